//! The AR3's firmware: motor steps, relative, with the step count that is expected afterwards.
//!
//! A move is answered when it has ended. The firmware compares its encoders with the expected count and says which joint differs.

mod host;
mod message;

pub use host::Ar3Host;
pub(crate) use host::FULL;
pub use message::{Ask, JOINTS, Reply, STEPS, angle, steps};
