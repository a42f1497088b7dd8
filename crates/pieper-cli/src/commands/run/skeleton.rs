//! The arm's skeleton: the corners of its links in one position.

use nalgebra::{Unit, Vector3};
use pieper::model::{Chain, Motion};
use pieper_plot::{Arm, ArmJoint, JointKind, ToolFrame};

/// Corners nearer than this are one.
const NEAR: f64 = 1e-9;

/// The arm at the joint values `q`, its tool at `tool`.
pub(super) fn arm(
    chain: &Chain,
    q: &[f64],
    tool: &pieper::spatial::Pose,
    label: String,
    note: String,
) -> Arm {
    let mut frame = *chain.base();
    let mut points: Vec<[f64; 3]> = vec![frame.translation.vector.into()];
    let mut joints = Vec::new();
    for joint in chain.joints() {
        frame *= joint.before;
        points.push(frame.translation.vector.into());
        if let Some(axis) = joint.motion.axis() {
            joints.push(ArmJoint {
                at: frame.translation.vector.into(),
                axis: (frame.rotation * axis.into_inner()).into(),
                kind: match joint.motion {
                    Motion::Slide(..) => JointKind::Prismatic,
                    _ => JointKind::Revolute,
                },
            });
        }
        frame *= joint.motion.pose(q);
        points.push(frame.translation.vector.into());
        if let Some(axis) = joint.motion.axis() {
            // A link's offset: first along the joint's axis (d), then across it (a).
            let corner = frame * along(axis, joint.after.translation.vector);
            points.push(corner.into());
        }
        frame *= joint.after;
        points.push(frame.translation.vector.into());
    }
    points.push(tool.translation.vector.into());
    points.dedup_by(|a, b| (0..3).all(|k| (a[k] - b[k]).abs() < NEAR));
    let column = |k: usize| tool.rotation.matrix().column(k).into_owned().into();
    Arm {
        label,
        note,
        points,
        joints,
        tool: ToolFrame {
            at: tool.translation.vector.into(),
            axes: [column(0), column(1), column(2)],
        },
    }
}

/// The part of an offset along an axis, as a point.
fn along(axis: &Unit<Vector3<f64>>, offset: Vector3<f64>) -> nalgebra::Point3<f64> {
    (axis.into_inner() * axis.dot(&offset)).into()
}
