//! How close the arm comes to a pose that it cannot reach.

use super::arm::{Arm, rotation_between};
use super::descent::{ROUNDING, Room, damped};
use super::numeric::start;
use super::solutions::{JointVector, Nearest};
use crate::error::{Error, Result};
use crate::kinematics;
use crate::model::Chain;
use crate::spatial::Pose;

/// Starts of the search; the minimum over the arm's few branches is found from a handful.
const STARTS: usize = 24;

/// The best of many damped descents: position errors count in the arm's extent, orientation errors in radians.
pub(super) fn find(arm: &Arm, pose: &Pose) -> Nearest {
    let descents = (0..STARTS).map(|index| {
        damped(
            arm,
            &start(arm, index, Room::Free),
            pose,
            Room::Free,
            ROUNDING,
        )
    });
    let best = descents.min_by(|a, b| a.error.total_cmp(&b.error));
    let mut q = best.map_or([0.0; super::MAX_JOINTS], |best| best.q);
    arm.wrap(&mut q);
    Nearest::of(arm, &q, pose)
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
            return Err(Error::input(
                "q",
                "more joints than inverse kinematics takes",
            ));
        }
        values[..q.len()].copy_from_slice(q);
        Ok(Self::measured(
            &kinematics::tool_pose(chain, q)?,
            values,
            q.len(),
            pose,
        ))
    }

    /// Joint values and what they miss a pose by.
    pub(super) fn of(arm: &Arm, q: &JointVector, pose: &Pose) -> Self {
        Self::measured(&arm.pose(q), *q, arm.chain().dof(), pose)
    }

    fn measured(reached: &Pose, q: JointVector, dof: usize, pose: &Pose) -> Self {
        let turn = rotation_between(reached.rotation.matrix(), pose.rotation.matrix());
        Self {
            q,
            dof: dof as u8,
            position_error: (reached.translation.vector - pose.translation.vector).norm(),
            orientation_error: turn.norm(),
        }
    }
}
