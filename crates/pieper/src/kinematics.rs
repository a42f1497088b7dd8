//! From joint values to poses, velocities and measures.
//!
//! Free functions on a [`Chain`](crate::model::Chain) and a joint vector. The frame a velocity is seen from is an
//! explicit [`Reference`]. Hot calls allocate nothing: results larger than a pose go into buffers of the caller.

pub mod batch;
mod directions;
mod forward;
pub(crate) mod group;
mod hessian;
mod jacobian;
pub mod kernel;
pub(crate) mod lanes;
mod measures;
mod orientation;
mod ortho;
mod quaternion;
mod reach;
mod single;
mod statics;
mod tile;

pub use directions::{AxisDirections, Directions};
pub use forward::{link_poses, tool_pose};
pub use hessian::hessian;
pub(crate) use jacobian::pose_and_columns;
pub use jacobian::{Jacobian, Reference, pose_and_jacobian};
pub use measures::{Measures, Singularity, measures};
pub use orientation::{Orientation, analytic_jacobian};
pub use quaternion::tool_pose_by_quaternions;
pub use reach::{Reach, reach};
pub use statics::{joint_torques, twist};
