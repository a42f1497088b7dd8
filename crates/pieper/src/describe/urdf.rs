//! URDF, the robot description of ROS: [`read`] gives a [`Tree`](crate::model::Tree), [`write()`] and
//! [`write_chain`] give text.

mod chain;
mod joint;
mod mimic;
mod read;
mod shape;
mod value;
mod write;
pub(in crate::describe) mod xml;

pub use chain::write_chain;
pub use read::read;
pub(in crate::describe) use read::robot;
pub(in crate::describe) use write::escape;
pub use write::write;
