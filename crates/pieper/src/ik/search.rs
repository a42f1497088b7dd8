//! One numeric solution from one start: the fastest way to an answer for any chain.

use super::arm::{Arm, MAX_JOINTS};
use super::descent::{Room, damped, newton};
use super::numeric::start;
use super::solutions::{JointVector, Nearest};
use super::solver::check;
use crate::error::Result;
use crate::model::Chain;
use crate::spatial::Pose;

/// A numeric search on one chain, of any joints.
///
/// ```
/// use pieper::{describe::Robot, ik, kinematics};
/// let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
/// let chain = Robot::from_toml("elbow.toml", text)?.chain()?;
/// let pose = kinematics::tool_pose(&chain, &[0.3, 0.7])?;
/// let found = ik::Search::new(&chain)?.find(&pose, &[0.0, 0.1], &ik::Options::default())?;
/// assert!(found.reached && (found.q()[1] - 0.7).abs() < 1e-5);
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Search {
    arm: Arm,
}

/// How a search is done. Any values are valid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// What counts as reached: the distance of the tool points in metres, and the angle between the orientations in
    /// radians, are both at most this.
    pub tolerance: f64,
    /// Whether values stay within the joints' limits; a seed outside is moved to the nearest limit.
    pub limits: bool,
    /// How many starts are tried, the caller's seed first; the others are fixed points spread over the joints' ranges.
    pub starts: u32,
}

impl Default for Options {
    /// A micrometre and a microradian, without limits, up to 32 starts.
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            limits: false,
            starts: 32,
        }
    }
}

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// The joint values, and what they miss the pose by. Angles are not wrapped: within limits they stay as found,
    /// without limits they are close to the start.
    pub nearest: Nearest,
    /// Whether they meet the pose within the tolerance.
    pub reached: bool,
    /// Steps taken over all starts: evaluations of the pose and its Jacobian.
    pub steps: u32,
    /// Starts tried.
    pub starts: u32,
}

impl Found {
    /// The joint values.
    pub fn q(&self) -> &[f64] {
        self.nearest.q()
    }
}

impl Search {
    /// Prepares a chain.
    ///
    /// # Errors
    /// A model error for a chain of more than [`MAX_JOINTS`] joints.
    pub fn new(chain: &Chain) -> Result<Self> {
        Ok(Self {
            arm: Arm::new(chain)?,
        })
    }

    /// Walks from `seed` to joint values that meet the pose, or, if that ends in a local minimum, from other starts;
    /// if none of them reaches it, the closest met. Deterministic; allocates nothing.
    ///
    /// # Errors
    /// An input error if the pose is none (as [`Solver::solve`](super::Solver::solve)), or unless `seed` has one finite
    /// value for each variable.
    pub fn find(&self, pose: &Pose, seed: &[f64], options: &Options) -> Result<Found> {
        check(pose)?;
        self.arm.chain().check_joint_values(seed)?;
        let mut first = [0.0; MAX_JOINTS];
        first[..seed.len()].copy_from_slice(seed);
        Ok(find(&self.arm, pose, &first, options))
    }
}

fn find(arm: &Arm, pose: &Pose, seed: &JointVector, options: &Options) -> Found {
    let room = if options.limits {
        Room::Limits
    } else {
        Room::Free
    };
    // The error of a descent counts positions in extents and is the length of both parts together.
    let enough = options.tolerance * (1.0 / arm.extent()).min(1.0);
    let (mut best, mut least) = (*seed, f64::INFINITY);
    let (mut steps, mut starts) = (0, 0);
    while starts < options.starts.max(1) && (least > enough || least.is_nan()) {
        let from = match starts {
            0 => *seed,
            index => start(arm, index as usize, room),
        };
        let found = damped(arm, &from, pose, room, enough);
        starts += 1;
        steps += found.steps;
        if found.error < least {
            (best, least) = (found.q, found.error);
        }
    }
    if least > enough && !options.limits {
        // Near a singular pose damped steps are slow.
        (best, _) = newton(arm, &best, pose, None, f64::EPSILON);
    }
    let nearest = Nearest::of(arm, &best, pose);
    Found {
        reached: nearest.position_error <= options.tolerance
            && nearest.orientation_error <= options.tolerance,
        nearest,
        steps,
        starts,
    }
}
