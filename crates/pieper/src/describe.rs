//! The formats an arm is described in, and the way from each to the [model](crate::model) and back.
//!
//! Only this module knows file formats. It reads text it is handed; files come through the caller.

pub mod dh;
pub mod drives;
pub mod expr;
mod measurement_table;
mod motion_table;
pub mod robot;
mod robot_file;
pub mod screws;
pub mod urdf;
pub mod xacro;

pub use dh::{Convention, DhTable};
pub use expr::Expr;
pub use measurement_table::{Measurement, Readings, Seen, measurements_from_csv};
pub use motion_table::{MotionTable, MotionValues, ToolPoints};
pub use robot::{Form, Golden, Robot, Up};
pub use screws::ScrewTable;
