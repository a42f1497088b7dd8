//! The arm itself: immutable, validated, free of any file format.
//!
//! A [`Chain`] is an open kinematic chain from a base to a tool,
//!
//! ```text
//! base_from_tool = base * (before_1 * motion_1(q) * after_1) * ... * (before_m * motion_m(q) * after_m) * tool
//! ```
//!
//! where `motion` turns about or slides along an axis, or stands still. A [`Tree`] is what a URDF describes;
//! chains are taken out of it.

mod canonical;
mod chain;
mod joint;
mod shape;
mod tree;

pub use canonical::{Canonical, LinkShape, Row, Rows, Step};
pub(crate) use canonical::{Names, Ortho, PACK, StepRow};
pub use chain::{Chain, ChainParts};
pub use joint::{Drive, Joint, JointKind, Limits, Motion, Variable};
pub use shape::{Geometry, Shape};
pub use tree::{Tree, TreeJoint, TreeLink};
