//! Forward kinematics by rotation matrices.

use super::single::{self, Nothing};
use crate::error::Result;
use crate::model::Chain;
use crate::spatial::Pose;

/// The pose of the tool at the joint vector `q`: `base_from_tool`, metres and radians.
///
/// Direct kinematics, the product of the rows' matrices (for tables: Denavit and Hartenberg 1955,
/// `T = A_1 A_2 ... A_n`). Allocates nothing.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable.
///
/// ```
/// use pieper::{describe::Robot, kinematics};
/// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let chain = Robot::from_toml("r.toml", text)?.chain()?;
/// let pose = kinematics::tool_pose(&chain, &[std::f64::consts::FRAC_PI_2])?;
/// assert!((pose.translation.vector.y - 0.5).abs() < 1e-15);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn tool_pose(chain: &Chain, q: &[f64]) -> Result<Pose> {
    single::tool_pose(chain, q, &mut Nothing)
}

/// The pose of every link at the joint vector `q`, one for each of [`Chain::joints`], into `poses`.
///
/// The frames of the description: row frames of a table, link frames of a URDF. The tool transform is not in the
/// last one.
///
/// # Errors
/// As [`tool_pose`].
pub fn link_poses(chain: &Chain, q: &[f64], poses: &mut Vec<Pose>) -> Result<()> {
    chain.check_joint_values(q)?;
    poses.clear();
    let mut pose = *chain.base();
    for joint in chain.joints() {
        pose *= joint.pose(q);
        poses.push(pose);
    }
    Ok(())
}
