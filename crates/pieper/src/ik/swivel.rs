//! Seven axes: a spherical shoulder, an elbow, a spherical wrist.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{Matrix3, Point3, Vector3};

use super::angle::solve_linear;
use super::arm::Arm;
use super::classify::{Class, Structure};
use super::normal::Normal;
use super::parallel::turned_dot;
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, Elbow, JointVector, Wrist};
use super::spherical::turn_z;
use super::wrist::Ball;
use crate::spatial::Pose;

/// The distance from shoulder to wrist gives the elbow (two ways); the arm may then swivel about the line between
/// them. For a swivel angle the shoulder has two ways to its orientation, the wrist two: eight families.
///
/// The member listed for each is the one whose elbow axis is at a right angle to axis 1 (or, if a shoulder or wrist
/// without right angles cannot do that, the first of some others that it can).
#[derive(Clone, Debug)]
struct Swivel {
    links: [Pose; 7],
    shoulder: Ball,
    wrist: Ball,
    /// The shoulder seen from axes 1 and 3, the wrist seen from axes 5 and 7.
    points: [Point3<f64>; 4],
}

/// The row's name.
pub(super) const NAME: &str = "swivel";

/// There is no swivel angle where axis 1 is closer than this to the line from shoulder to wrist, or that as short.
const FLAT: f64 = 1e-9;

/// Swivel angles tried, as parts of a turn.
const SWIVELS: usize = 8;

/// Prepares an arm of the class.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::SphericalRotationalSpherical {
        return None;
    }
    let links: [Pose; 7] = arm.links().try_into().ok()?;
    let [a, b, c, d] = [0, 1, 4, 5].map(|index: usize| Normal::of(&links[index], arm.size()));
    let on_axis = |z: f64| Point3::new(0.0, 0.0, z);
    Some(Arc::new(Swivel {
        shoulder: Ball::new(&a, &b),
        wrist: Ball::new(&c, &d),
        points: [on_axis(a.d), on_axis(-b.e), on_axis(c.d), on_axis(-d.e)],
        links,
    }))
}

/// An orthonormal frame whose x is `along` and whose y is as close to `side` as that allows.
fn frame(along: &Vector3<f64>, side: &Vector3<f64>) -> Matrix3<f64> {
    let x = along.normalize();
    let y = side - x * x.dot(side);
    let fallback = if x.x.abs() < 0.5 {
        Vector3::x()
    } else {
        Vector3::y()
    };
    let y = y
        .try_normalize(1e-9)
        .unwrap_or_else(|| (fallback - x * x.dot(&fallback)).normalize());
    Matrix3::from_columns(&[x, y, x.cross(&y)])
}

impl Prepared for Swivel {
    fn swivel(&self, arm: &Arm, q: &JointVector) -> Option<f64> {
        let mut elbow = Matrix3::identity();
        for (drive, link) in arm.drives().iter().zip(&self.links).take(3) {
            turn_z(&mut elbow, drive.displacement(q).sin_cos());
            elbow *= link.rotation.matrix();
        }
        let line = self.line(&arm.target(&arm.pose(q)));
        let side = Vector3::z().cross(&line);
        let plain = side.norm() > FLAT * line.norm() && line.norm() > FLAT * arm.size();
        let axis = frame(&line, &side).transpose() * elbow.column(2);
        plain.then(|| axis.z.atan2(axis.y))
    }

    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        let [_, shoulder_3, wrist_5, _] = self.points;
        let line = self.line(target);
        let forearm = (self.links[3] * wrist_5).coords;
        let upper = self.links[2].translation.vector - shoulder_3.coords;
        let turn_3 = self.links[2].rotation;
        let swing = turned_dot(&turn_3.inverse_transform_vector(&upper), &forearm);
        let constant = upper.norm_squared() + forearm.norm_squared() + 2.0 * swing.k;
        let elbow = solve_linear(
            2.0 * swing.c,
            2.0 * swing.s,
            line.norm_squared() - constant,
            sink.slack(),
        );
        let wanted = sink.swivel();
        let distance = line.norm();
        sink.fail(
            Part::WristBeyond,
            distance - (constant + elbow.length).max(0.0).sqrt(),
        );
        sink.fail(
            Part::WristTooNear,
            (constant - elbow.length).max(0.0).sqrt() - distance,
        );
        for (&fourth, up) in elbow.turns[..elbow.len].iter().zip([true, false, true]) {
            let mut at = turn_3.into_inner();
            let axis = at.column(2).into_owned();
            turn_z(&mut at, fourth);
            let reach = upper + at * forearm;
            let (from, to) = (
                frame(&reach, &axis),
                frame(&line, &Vector3::z().cross(&line)),
            );
            let mut propose = |angle: f64| {
                let spin = nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), angle);
                let whole = to * spin.matrix() * from.transpose();
                self.members(&whole, &(whole * at), target, (fourth, up), sink)
            };
            match wanted {
                Some(angle) => _ = propose(angle),
                None => {
                    _ = (0..SWIVELS)
                        .map(|swivel| swivel as f64 * TAU / SWIVELS as f64)
                        .any(propose);
                }
            }
        }
    }
}

impl Swivel {
    /// From the shoulder to the wrist's centre, seen from the first axis.
    fn line(&self, target: &Pose) -> Vector3<f64> {
        let [shoulder, .., wrist_7] = self.points;
        target * (self.links[6].inverse() * wrist_7) - shoulder
    }

    /// Proposes the members with this orientation of the shoulder and of the elbow; false if there are none.
    fn members(
        &self,
        shoulder: &Matrix3<f64>,
        elbow: &Matrix3<f64>,
        target: &Pose,
        (fourth, up): ((f64, f64), bool),
        sink: &mut Sink<'_>,
    ) -> bool {
        let last = target.rotation * self.links[6].rotation.inverse();
        let rest = (elbow * self.links[3].rotation.matrix()).transpose() * last.matrix();
        let (first, second) = (
            self.shoulder.solve(shoulder, sink.slack(), sink.method()),
            self.wrist.solve(&rest, sink.slack(), sink.method()),
        );
        for (turned, root) in first.list[..first.len].iter().zip([1, 2, 3]) {
            for bent in &second.list[..second.len] {
                let ([a, b, c], [d, e, f]) = (turned.turns, bent.turns);
                let branch = Branch {
                    shoulder: None,
                    elbow: Some(if up { Elbow::Up } else { Elbow::Down }),
                    wrist: Some(if bent.flip {
                        Wrist::Flip
                    } else {
                        Wrist::NoFlip
                    }),
                    root,
                };
                sink.push_turns(&[a, b, c, fourth, d, e, f], branch, Marks::PLAIN);
            }
        }
        first.len * second.len > 0
    }
}
