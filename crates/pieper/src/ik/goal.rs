//! What is asked for: all of a pose or a part of it, with joints held, by matrices or by quaternions.

use nalgebra::Vector3;

use super::arm::angle_between;
use super::wrist::Method;
use crate::spatial::Pose;

/// The part of a pose that is to be met.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Goal {
    /// All of it: six conditions.
    #[default]
    Pose,
    /// The tool's point, with any orientation: three conditions.
    Position,
    /// The direction of the tool's z axis, anywhere: two conditions. Joints that slide do not matter to it and are
    /// answered at zero, or at the limit closest to it.
    Axis,
    /// The tool's point and the direction of its z axis, turned about that in any way: five conditions.
    PositionAxis,
}

impl Goal {
    /// Every goal.
    pub const ALL: [Self; 4] = [Self::Pose, Self::Position, Self::Axis, Self::PositionAxis];

    /// The word people and programs use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pose => "pose",
            Self::Position => "position",
            Self::Axis => "axis",
            Self::PositionAxis => "position+axis",
        }
    }

    /// By how much `reached` misses the asked part of `wanted`: metres, and radians; 0 for what is not asked for.
    pub fn miss(self, reached: &Pose, wanted: &Pose) -> (f64, f64) {
        let shift = (reached.translation.vector - wanted.translation.vector).norm();
        let (a, b) = (axis(reached), axis(wanted));
        let tilt = a.cross(&b).norm().atan2(a.dot(&b));
        match self {
            Self::Position => (shift, 0.0),
            Self::Axis => (0.0, tilt),
            Self::PositionAxis => (shift, tilt),
            Self::Pose => {
                let (from, to) = (reached.rotation.matrix(), wanted.rotation.matrix());
                (shift, angle_between(from, to))
            }
        }
    }

    /// The largest absolute entry of `reached - wanted` among those that are asked for.
    pub(super) fn residual(self, reached: &Pose, wanted: &Pose) -> f64 {
        let most = |entries: &[f64]| entries.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let shift = reached.translation.vector - wanted.translation.vector;
        let turn = reached.rotation.matrix() - wanted.rotation.matrix();
        let position = most(shift.as_slice());
        let tilt = most(turn.column(2).as_slice());
        match self {
            Self::Pose => position.max(most(turn.as_slice())),
            Self::Position => position,
            Self::Axis => tilt,
            Self::PositionAxis => position.max(tilt),
        }
    }
}

fn axis(pose: &Pose) -> Vector3<f64> {
    pose.rotation.matrix().column(2).into_owned()
}

/// What a [`Solver`](super::Solver) is prepared for. The default is the whole pose, no joint held, by matrices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Question {
    /// The part of the pose.
    pub goal: Goal,
    /// Joints that are held, by their place in the joint vector, and where: radians or metres.
    pub held: Vec<(usize, f64)>,
    /// How the orientation of a spherical wrist is solved.
    pub method: Method,
    /// Of an arm of seven joints with a spherical shoulder and wrist: the angle by which its elbow is turned about the line
    /// from shoulder to wrist, radians; up to eight isolated solutions are left. See [`Solver::swivel`](super::Solver::swivel).
    pub swivel: Option<f64>,
}
