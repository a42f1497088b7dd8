//! Kinematics of robot arms: from an arm's table (Denavit-Hartenberg, URDF or screws) to poses,
//! Jacobians and every inverse solution.
//!
//! The modules stand in reading order; each uses only those above it.
//!
//! The library does no input or output beyond text it is handed, starts no thread, reads no clock.
//! Lengths are metres, angles radians, time seconds, everywhere.

// Blank lines keep the order: it is that of reading, and of what may use what.
pub mod error;

pub mod scalar;

pub mod spatial;

pub mod model;

pub mod transmission;

pub mod describe;

pub mod kinematics;

pub mod ik;

pub mod motion;

pub mod calibration;

pub use error::{Error, Result};

/// The README's program is compiled with the documentation's examples.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
