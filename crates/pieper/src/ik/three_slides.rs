//! Three joints that slide and three that turn, in any order: the angles from the orientation, the slides from the place.
//!
//! Slides do not turn the tool: `P0 Rz(x1) A1 Rz(x2) A2 Rz(x3) P3 = R` holds the three angles alone, two ways at most. With
//! the angles given the tool's point is linear in the slides.

use std::sync::Arc;

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::TOLERANCES;
use super::arm::Arm;
use super::classify::{Class, Structure};
use super::normal::Normal;
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, Wrist};
use super::wrist::{Ball, Turned};
use crate::spatial::Pose;

#[derive(Debug)]
struct ThreeSlides {
    turns: [bool; 6],
    links: [Pose; 6],
    ball: Ball,
    /// The rotations before the first turn and behind the last.
    before: Matrix3<f64>,
    behind: Matrix3<f64>,
}

/// Prepares an arm of six joints of which three slide.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    let turns: [bool; 6] = arm.turns().try_into().ok()?;
    let three = turns.iter().filter(|&&turns| turns).count() == 3;
    if class != Class::General || !arm.is_independent() || !three {
        return None;
    }
    let links: [Pose; 6] = arm.links().try_into().ok()?;
    // The rotations between turns.
    let mut between = [Matrix3::identity(); 4];
    let mut turn = 0;
    for (link, &turns) in links.iter().zip(&turns) {
        turn += usize::from(turns);
        between[turn] *= link.rotation.matrix();
    }
    let normal = |m: Matrix3<f64>| {
        let rotation = Rotation3::from_matrix_unchecked(m);
        // Only the angles matter, and only parallel axes are no ball.
        let link = Pose::from_parts(Vector3::zeros().into(), rotation);
        Normal::within(&link, 1.0, TOLERANCES.merely)
    };
    let (one, two) = (normal(between[1]), normal(between[2]));
    if one.is_parallel() || two.is_parallel() {
        return None;
    }
    Some(Arc::new(ThreeSlides {
        turns,
        links,
        ball: Ball::new(&one, &two),
        before: between[0],
        behind: between[3],
    }))
}

impl Prepared for ThreeSlides {
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        let rotation = self.before.transpose() * target.rotation.matrix() * self.behind.transpose();
        let turns = self.ball.solve(&rotation, 0.0, sink.method());
        if let Some(shortfall) = turns.shortfall {
            sink.fail(shortfall.part, shortfall.amount);
        }
        for turned in &turns.list[..turns.len] {
            self.place(target, turned, sink);
        }
    }
}

/// Slides whose directions span less than this, as a determinant of unit vectors, leave a direction out.
const SPAN: f64 = 1e-12;

impl ThreeSlides {
    /// The slides for given angles.
    fn place(&self, target: &Pose, turned: &Turned, sink: &mut Sink<'_>) {
        let mut all = [(0.0, 1.0); 6];
        let mut frame = Matrix3::identity();
        let (mut point, mut directions) = (Vector3::zeros(), Matrix3::zeros());
        let (mut turn, mut slide) = (0, 0);
        for (joint, link) in self.links.iter().enumerate() {
            if self.turns[joint] {
                let (sin, cos) = turned.turns[turn];
                let length = sin.hypot(cos);
                all[joint] = (sin / length, cos / length);
                super::spherical::turn_z(&mut frame, all[joint]);
                turn += 1;
            } else {
                directions.set_column(slide, &frame.column(2));
                slide += 1;
            }
            point += frame * link.translation.vector;
            frame *= link.rotation.matrix();
        }
        let missing = target.translation.vector - point;
        let Some(inverse) = directions
            .try_inverse()
            .filter(|_| directions.determinant().abs() > SPAN)
        else {
            // A family, or nothing: a search will tell.
            sink.fail(Part::Slides, f64::NAN);
            return;
        };
        let moved = inverse * missing;
        let slides = all
            .iter_mut()
            .zip(&self.turns)
            .filter(|(_, turns)| !**turns);
        for ((value, _), by) in slides.zip(moved.iter()) {
            *value = (*by, 0.0);
        }
        let branch = Branch {
            wrist: Some(if turned.flip {
                Wrist::Flip
            } else {
                Wrist::NoFlip
            }),
            ..Branch::default()
        };
        let marks = Marks {
            multiplicity: turned.multiplicity,
            edge: turned.edge,
            free: turned.free,
        };
        sink.push_turns(&all, branch, marks);
    }
}
