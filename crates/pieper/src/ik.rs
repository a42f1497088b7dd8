//! From poses back to joint values: every solution, or the reason why there is none.
//!
//! A [`Solver`] is prepared once for a chain: [`classify`] finds out which axes meet and which are parallel, and the
//! first row of the [`registry`] that takes such an arm solves it from then on. Whatever a row proposes is verified
//! on the true model, refined there by Newton's method where the arm misses its class by a hair, merged where roots
//! coincide and, where roots form a curve, followed along it; a row itself only proposes.
//!
//! A [`Question`] asks for a part of a pose ([`Goal`]) or holds joints; the answer to both is another chain, solved by the same
//! rows. [`Search`] is the numeric way: one solution from one start, for any chain.
//!
//! ```
//! use pieper::describe::Robot;
//! use pieper::{ik, kinematics};
//! let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
//! let chain = Robot::from_toml("elbow.toml", text)?.chain()?;
//! let solver = ik::Solver::new(&chain)?;
//! let pose = kinematics::tool_pose(&chain, &[0.3, 0.7])?;
//! let solutions = solver.solve(&pose)?;
//! assert_eq!(solutions.status(), ik::Status::Solved);
//! assert!(solutions.iter().any(|s| (s.q()[1] - 0.7).abs() < 1e-9));
//! # Ok::<(), pieper::Error>(())
//! ```

mod angle;
mod arm;
pub mod classify;
mod curve;
mod dense;
mod descent;
mod elimination;
mod extend;
mod family;
mod fewer;
pub mod general;
mod goal;
mod kernel;
mod lanes;
mod limits;
mod locked;
mod nearest;
mod normal;
mod numeric;
mod parallel;
mod pending;
mod planar;
mod polynomial;
mod position;
mod reason;
pub mod registry;
mod search;
mod sink;
mod slides;
mod solutions;
mod solver;
mod spherical;
mod swivel;
mod three_slides;
mod tolerances;
mod view;
#[cfg_attr(
    not(all(target_arch = "x86_64", feature = "avx2")),
    expect(dead_code, reason = "only registers of four doubles make it pay")
)]
mod wide;
mod wrist;

pub use arm::{Arm, MAX_JOINTS};
pub use family::Range;
pub use goal::{Goal, Question};
pub use limits::{Ranking, rank, windings};
pub use reason::{Part, Shortfall};
pub use search::{Found, Options, Search};
pub use sink::{Marks, Sink};
pub use solutions::{
    Branch, Elbow, Family, JointVector, MAX_FAMILIES, MAX_SOLUTIONS, Nearest, Shoulder, Solution,
    Solutions, Status, Wrist,
};
pub use solver::Solver;
pub use tolerances::{TOLERANCES, Tolerances};
pub use wrist::{Method, orientation};
