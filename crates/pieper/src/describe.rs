//! The file formats that describe an arm, to the model and back.

pub mod urdf;
pub mod xacro;
