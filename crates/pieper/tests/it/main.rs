//! The library's integration tests, in one binary.

mod urdf;
mod urdf_errors;
mod urdf_xacro;
