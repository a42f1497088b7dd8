//! What may be sent to an arm: the one place that decides it.
//!
//! A connection only shows. Arming is explicit, and the first set-point after it is the position just measured. From then
//! on every set-point passes [`Envelope`]: joint and motor limits, rates and accelerations. The [`Guard`] stops when the
//! one who drives it is silent for [`HEARTBEAT`], when the controller is, when a motor does not follow, and when it is told to.
//! What it refuses, it refuses in words.

mod envelope;
mod follower;
mod guard;

pub use envelope::{Envelope, Refusal};
pub use guard::{Guard, HEARTBEAT, Phase, SetPoint};
