//! Dragging: a link turned by its joint, or the whole arm pulled by a point.

use nalgebra::{DMatrix, DVector, Isometry3, Point3, Unit, Vector3};

use crate::arm::Arm;

/// A drag that is going on.
#[derive(Clone, Debug)]
pub(crate) struct Drag {
    /// The link that was touched, and the variable that moves it.
    pub(crate) link: usize,
    pub(crate) joint: usize,
    /// Where it was touched, in the link's frame.
    local: Point3<f64>,
    /// Whether the whole arm follows.
    whole: bool,
    /// Where the ray met the link.
    plane: Point3<f64>,
    /// Joint values before.
    pub(crate) before: Vec<f64>,
}

/// A step of the angle below this part of the plane's tilt is looked at edge-on.
const EDGE_ON: f64 = 0.15;

/// Steps of the pull, and its damping relative to the arm's reach.
const PULLS: usize = 14;
const DAMPING: f64 = 0.02;

/// How much keeping the tool's direction counts against following the pointer.
const STIFFNESS: f64 = 0.5;

impl Drag {
    pub(crate) fn new(
        arm: &Arm,
        q: &[f64],
        (link, joint): (usize, usize),
        point: Point3<f64>,
        whole: bool,
    ) -> Self {
        let local = arm.poses(q)[link].inverse_transform_point(&point);
        Self {
            link,
            joint,
            local,
            whole,
            plane: point,
            before: q.to_vec(),
        }
    }

    /// Where the touched point is now.
    pub(crate) fn point(&self, arm: &Arm, q: &[f64]) -> Point3<f64> {
        arm.poses(q)[self.link] * self.local
    }

    /// Joint values that bring the touched point under the ray, as far as they can.
    pub(crate) fn follow(
        &self,
        arm: &Arm,
        q: &[f64],
        origin: &Point3<f64>,
        direction: &Unit<Vector3<f64>>,
        free: bool,
    ) -> Vec<f64> {
        let mut next = q.to_vec();
        if self.whole {
            // The point stays in the plane that faces the viewer.
            let depth = (self.plane - origin).dot(direction);
            let target = origin + direction.into_inner() * depth;
            self.pull(arm, &mut next, &target, free);
        } else {
            let at = self.point(arm, q);
            let change = self.change(arm, q, &at, origin, direction);
            let value = next[self.joint] + change;
            next[self.joint] = if free {
                value
            } else {
                arm.clamp(self.joint, value)
            };
        }
        next
    }

    /// By how much the one joint has to change.
    fn change(
        &self,
        arm: &Arm,
        q: &[f64],
        at: &Point3<f64>,
        origin: &Point3<f64>,
        direction: &Unit<Vector3<f64>>,
    ) -> f64 {
        let Some((axis, turns, factor)) = axes(arm, q)
            .into_iter()
            .find(|axis| axis.2 == self.joint)
            .map(|a| (a.0, a.1, a.3))
        else {
            return 0.0;
        };
        let (centre, along) = (Point3::from(axis.translation.vector), axis * Vector3::z());
        if !turns {
            return nearest_on_line(at, &along, origin, direction) / factor;
        }
        let foot = centre + along * (at - centre).dot(&along);
        let arm_of = at - foot;
        let radius = arm_of.norm();
        if radius < 1e-9 {
            return 0.0;
        }
        let slope = direction.dot(&along);
        if slope.abs() > EDGE_ON {
            // Where the ray meets the plane of the circle on which the point runs.
            let hit = origin + direction.into_inner() * ((foot - origin).dot(&along) / slope);
            let wanted = hit - foot;
            return along.dot(&arm_of.cross(&wanted)).atan2(arm_of.dot(&wanted)) / factor;
        }
        let tangent = along.cross(&arm_of) / radius;
        (nearest_on_line(at, &tangent, origin, direction) / radius).clamp(-0.5, 0.5) / factor
    }

    /// Damped least squares: the point to the target, the tool's direction kept where the tool itself is pulled.
    fn pull(&self, arm: &Arm, q: &mut [f64], target: &Point3<f64>, free: bool) {
        let last = self.link + 1 == arm.links();
        let start = arm.poses(q)[self.link].rotation;
        let stiff = STIFFNESS * arm.reach;
        for _ in 0..PULLS {
            let pose = arm.poses(q)[self.link];
            let at = pose * self.local;
            let mut error = DVector::zeros(6);
            error.fixed_rows_mut::<3>(0).copy_from(&(target - at));
            if last {
                let turn = (start * pose.rotation.inverse()).scaled_axis() * stiff;
                error.fixed_rows_mut::<3>(3).copy_from(&turn);
            }
            let mut jacobian = DMatrix::zeros(6, q.len());
            for (axis, turns, variable, factor) in axes(arm, q) {
                let z = axis * Vector3::z() * factor;
                let (moved, turned) = match turns {
                    true => (
                        z.cross(&(at - Point3::from(axis.translation.vector))),
                        z * stiff,
                    ),
                    false => (z, Vector3::zeros()),
                };
                // Joints behind the touched link do not move it.
                if variable > self.joint {
                    continue;
                }
                let mut column = jacobian.column_mut(variable);
                let mut top = column.fixed_rows_mut::<3>(0);
                top += moved;
                if last {
                    let mut bottom = column.fixed_rows_mut::<3>(3);
                    bottom += turned;
                }
            }
            let damping = (DAMPING * arm.reach).powi(2) * 0.05;
            let mut normal = &jacobian * jacobian.transpose();
            for k in 0..6 {
                normal[(k, k)] += damping;
            }
            let Some(solved) = normal.cholesky().map(|c| c.solve(&error)) else {
                return;
            };
            let step = jacobian.transpose() * solved;
            let longest = step.amax().max(0.2) / 0.2;
            for (j, value) in q.iter_mut().enumerate() {
                let moved = *value + step[j] / longest;
                *value = if free { moved } else { arm.clamp(j, moved) };
            }
        }
    }
}

/// The axes of all joints in the world: frame (z along the axis), whether it turns, its variable, and the variable's factor.
fn axes(arm: &Arm, q: &[f64]) -> Vec<(Isometry3<f64>, bool, usize, f64)> {
    let mut poses = Vec::new();
    pieper_scene::Frames::Axes.at(&arm.chain, q, &mut poses);
    let steps = arm.chain.canonical().steps.iter();
    steps
        .zip(poses.into_iter().skip(1))
        .map(|(step, pose)| (pose, step.turns, step.drive.variable, step.drive.factor))
        .collect()
}

/// How far along a line through `at` the place is that is nearest to a ray.
fn nearest_on_line(
    at: &Point3<f64>,
    along: &Vector3<f64>,
    origin: &Point3<f64>,
    direction: &Unit<Vector3<f64>>,
) -> f64 {
    let across = along - direction.into_inner() * along.dot(direction);
    let square = across.norm_squared();
    if square < 1e-6 {
        return 0.0;
    }
    (origin - at).dot(&across) / square
}
