//! The AR4's firmware 4.x: one command per line, letter-tagged decimal numbers in a fixed order, no checksum.
//!
//! A move is answered when it has ended, so the arm is driven by whole moves from rest to rest.

mod command;
mod host;
mod reply;

pub use command::{Command, Move};
pub use host::Ar4Host;
pub use reply::{Position, Refusal, Reply};

/// Joints of the arm and external axes.
pub const AXES: usize = 9;

/// Joints of the arm.
pub const JOINTS: usize = 6;

/// The tags of J1 to J9 in commands.
const JOINT_TAGS: [&str; AXES] = ["A", "B", "C", "D", "E", "F", "J7", "J8", "J9"];
