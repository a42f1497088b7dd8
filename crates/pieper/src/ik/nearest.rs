//! How close the arm comes to a pose that it cannot reach.

use super::arm::Arm;
use super::descent::damped;
use super::numeric::start;
use super::solutions::Nearest;
use crate::spatial::Pose;

/// Starts of the search; the minimum over the arm's few branches is found from a handful.
const STARTS: usize = 24;

/// The best of many damped descents: position errors count in the arm's extent, orientation errors in radians.
pub(super) fn find(arm: &Arm, pose: &Pose) -> Nearest {
    let descents = (0..STARTS).map(|index| damped(arm, &start(arm, index), pose, false));
    let best = descents.min_by(|a, b| a.error.total_cmp(&b.error));
    let mut q = best.map_or([0.0; super::MAX_JOINTS], |best| best.q);
    arm.wrap(&mut q);
    let reached = arm.pose(&q);
    let turn = super::arm::rotation_between(reached.rotation.matrix(), pose.rotation.matrix());
    Nearest {
        q,
        dof: arm.chain().dof() as u8,
        position_error: (reached.translation.vector - pose.translation.vector).norm(),
        orientation_error: turn.norm(),
    }
}
