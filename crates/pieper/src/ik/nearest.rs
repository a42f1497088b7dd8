//! How close the arm comes to a pose that it cannot reach.

use super::arm::{Arm, angle_between};
use super::descent::{ROUNDING, Room, damped};
use super::extend::open_to;
use super::goal::Goal;
use super::numeric::start;
use super::reason::{Part, Shortfall};
use super::solutions::{JointVector, Nearest};
use crate::error::{Error, Result};
use crate::kinematics;
use crate::model::Chain;
use crate::spatial::Pose;

/// Starts of the search; the minimum over the arm's few branches is found from a handful.
const STARTS: usize = 24;

/// The best of many damped descents: position errors count in the arm's extent, orientation errors in radians.
pub(super) fn find(arm: &Arm, pose: &Pose) -> JointVector {
    let from = |index| start(arm, index, Room::Free);
    let descents = (0..STARTS).map(|index| damped(arm, &from(index), pose, Room::Free, ROUNDING));
    let best = descents.min_by(|a, b| a.error.total_cmp(&b.error));
    let mut q = best.map_or([0.0; super::MAX_JOINTS], |best| best.q);
    arm.wrap(&mut q);
    q
}

/// For arms that lack joints for a whole pose: the parts of a pose in the order in which they are given up, last first.
///
/// First the tool's point comes as close as it can; among the ways to put it there, the tool's axis; among those that
/// also do that, the turn about the axis. What cannot be met of the first of them that fails is the reason. The closest
/// pose has the point in place, and the least turn from the wanted orientation.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    /// With an orientation that does not matter.
    point: Arm,
    /// With a turn about the tool's axis that does not matter; a miss of the position weighs heavily.
    axis: Arm,
    /// Where the turn matters: the arm itself, a miss of the position weighing heavily.
    whole: Option<Arm>,
}

/// How much more a miss of the position weighs where the axis is to be turned with the point in place: the point then
/// gives way by this part, squared, of a radian in the arm's extent.
const WEIGHT: f64 = 1e4;

/// A miss below this (rad, or extents) is none.
const MET: f64 = 1e-7;

impl Ladder {
    pub(super) fn new(chain: &Chain, goal: Goal) -> Result<Self> {
        let axis = Arm::new(&open_to(chain, Goal::PositionAxis)?)?;
        Ok(Self {
            point: Arm::new(&open_to(chain, Goal::Position)?)?,
            axis: axis.weighing_position(WEIGHT),
            whole: match goal {
                Goal::Pose => Some(Arm::new(chain)?.weighing_position(WEIGHT)),
                _ => None,
            },
        })
    }

    /// The reason, and joint values (of the chain) of the closest pose by it.
    pub(super) fn find(&self, pose: &Pose) -> (Shortfall, JointVector) {
        let mut points = [([0.0; super::MAX_JOINTS], f64::INFINITY); STARTS];
        for (index, (q, miss)) in points.iter_mut().enumerate() {
            let from = start(&self.point, index, Room::Free);
            let found = damped(&self.point, &from, pose, Room::Free, ROUNDING);
            (*q, *miss) = (found.q, found.error);
        }
        let least = |list: &[(JointVector, f64)]| -> (JointVector, f64) {
            let best = list.iter().min_by(|a, b| a.1.total_cmp(&b.1));
            best.copied().unwrap_or(list[0])
        };
        let (q, miss) = least(&points);
        let shift = miss * self.point.extent();
        if miss > MET {
            return (Shortfall::new(Part::Point, shift), q);
        }
        let dof = self.axis.chain().dof();
        let mut axes = points;
        for (q, miss) in &mut axes {
            // The turn about the axis starts at zero.
            q[dof - 1..].fill(0.0);
            let found = damped(&self.axis, q, pose, Room::Free, ROUNDING);
            let reached = self.axis.pose(&found.q);
            let (shift, tilt) = Goal::PositionAxis.miss(&reached, pose);
            let in_place = shift < MET * self.point.extent();
            (*q, *miss) = (found.q, if in_place { tilt } else { f64::INFINITY });
        }
        let (q, miss) = least(&axes);
        let axis = Shortfall::new(Part::Axis, miss);
        let Some(whole) = &self.whole else {
            return (axis, q);
        };
        let mut spin = f64::INFINITY;
        let mut best = (q, f64::INFINITY);
        for (q, tilt) in axes.iter().filter(|(_, tilt)| tilt.is_finite()) {
            if *tilt <= MET {
                // What the turn about the axis makes up for is what the arm misses.
                spin = spin.min(super::angle::wrap(q[dof - 1]).abs());
            }
            let mut own = *q;
            own[dof - 1] = 0.0;
            let found = damped(whole, &own, pose, Room::Free, ROUNDING);
            if found.error < best.1 {
                best = (found.q, found.error);
            }
        }
        match miss > MET {
            true => (axis, best.0),
            false => (Shortfall::new(Part::Spin, spin), best.0),
        }
    }
}

impl Nearest {
    /// Joint values and what they miss a pose by.
    ///
    /// # Errors
    /// An input error unless `q` has one finite value for each variable, or for a chain of more than
    /// [`MAX_JOINTS`](super::MAX_JOINTS) joints.
    pub fn at(chain: &Chain, q: &[f64], pose: &Pose) -> Result<Self> {
        chain.check_joint_values(q)?;
        let mut values = [0.0; super::MAX_JOINTS];
        if q.len() > values.len() {
            let text = "more joints than inverse kinematics takes";
            return Err(Error::input("joint values", text));
        }
        values[..q.len()].copy_from_slice(q);
        let reached = kinematics::tool_pose(chain, q)?;
        Ok(Self::measured(&reached, values, q.len(), pose))
    }

    pub(super) fn of(arm: &Arm, q: &JointVector, pose: &Pose) -> Self {
        Self::measured(&arm.pose(q), *q, arm.chain().dof(), pose)
    }

    fn measured(reached: &Pose, q: JointVector, dof: usize, pose: &Pose) -> Self {
        Self {
            q,
            dof: dof as u8,
            position_error: (reached.translation.vector - pose.translation.vector).norm(),
            orientation_error: angle_between(reached.rotation.matrix(), pose.rotation.matrix()),
        }
    }
}
