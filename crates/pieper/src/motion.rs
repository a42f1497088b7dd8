//! Laws of motion: joint values over time, their rates and accelerations, and the way from a path of the tool to them.
//!
//! A [`Law`] passes through rows of joint values at given times. Between two rows all joints move straight in joint
//! space, all with the same [`Profile`] of time; so a value between two rows lies between theirs, and whether limits
//! are kept can be told from the rows and the profile alone: see [`excesses`].
//!
//! A [`PoseLaw`] passes through poses of the tool, straight in space; [`track`](track()) finds all continuous motions
//! of the joints that follow it. [`stations`] finds joint values for poses between which the joints go straight.

mod excess;
mod law;
mod pose_law;
mod profile;
mod sampling;
mod track;

pub use excess::{Excess, Limited, excesses};
pub use law::{Law, State};
pub use pose_law::PoseLaw;
pub use profile::Profile;
pub use sampling::sample_times;
pub use track::{
    Deviation, End, Event, Gap, Leg, Stations, Switch, Track, TrackOptions, Tracks, stations, track,
};
