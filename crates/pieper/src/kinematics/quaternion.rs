//! Forward kinematics by quaternions.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

use crate::error::Result;
use crate::model::{Chain, Motion};

/// The pose of the tool at the joint vector `q`, composed of unit quaternions and translations throughout.
///
/// Equal to [`tool_pose`](super::tool_pose) to rounding; a second, independent way through the same chain.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable.
pub fn tool_pose_by_quaternions(chain: &Chain, q: &[f64]) -> Result<Isometry3<f64>> {
    chain.check_joint_values(q)?;
    let mut pose = nalgebra::convert::<_, Isometry3<f64>>(*chain.base());
    for joint in chain.joints() {
        pose *= nalgebra::convert::<_, Isometry3<f64>>(joint.before);
        pose *= match &joint.motion {
            Motion::Fixed => Isometry3::identity(),
            Motion::Turn(axis, drive) => {
                let turn = UnitQuaternion::from_axis_angle(axis, drive.displacement(q));
                Isometry3::from_parts(Translation3::identity(), turn)
            }
            Motion::Slide(axis, drive) => {
                let by: Vector3<f64> = axis.into_inner() * drive.displacement(q);
                Isometry3::from_parts(by.into(), UnitQuaternion::identity())
            }
        };
        pose *= nalgebra::convert::<_, Isometry3<f64>>(joint.after);
    }
    Ok(pose * nalgebra::convert::<_, Isometry3<f64>>(*chain.tool()))
}
