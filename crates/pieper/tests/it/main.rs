//! The library's tests: identities, and independent ways to the same numbers.

// Tests may unwrap, and so may their helper functions, which clippy.toml's exception does not reach.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod ar3;
mod bad_robot_files;
mod batches;
mod calibration;
mod derivatives;
mod descriptions;
mod general6r;
mod golden;
mod hot_calls;
mod ik;
mod measures;
mod motion;
mod motion_tables;
mod orientation;
mod stations;
mod support;
mod tracks;
mod transmission;
mod urdf;
mod urdf_errors;
mod urdf_xacro;
mod vectors;
