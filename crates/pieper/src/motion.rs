//! Laws of motion: joint values over time, their rates and accelerations.
//!
//! A [`Law`] passes through rows of joint values at given times. Between two rows all joints move straight in joint
//! space, all with the same [`Profile`] of time; so a value between two rows lies between theirs, and whether limits
//! are kept can be told from the rows and the profile alone: see [`excesses`].

mod excess;
mod law;
mod profile;
mod sampling;

pub use excess::{Excess, Limited, excesses};
pub use law::{Law, State};
pub use profile::Profile;
pub use sampling::sample_times;
