//! The library's integration tests, in one binary.

// Tests may unwrap, and so may their helper functions, which clippy.toml's exception does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod urdf;
mod urdf_errors;
mod urdf_xacro;
