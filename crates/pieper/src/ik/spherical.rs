//! Three neighbouring axes through one point, at either end of the arm or in its middle.

use std::sync::Arc;

use nalgebra::{Matrix3, Point3, Vector3};

use super::TOLERANCES;
use super::arm::Arm;
use super::classify::{Class, Structure};
use super::normal::Normal;
use super::pending::Halves;
use super::position::{Four, Reach, Reaches, Three};
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::slides;
use super::solutions::{Branch, Elbow, Shoulder, Wrist};
use super::wide::{self, FOUR, Oriented, Wrist as WideWrist};
use super::wrist::{Ball, Method};
use crate::spatial::Pose;

/// The loop `Z_1 L_1 ... Z_6 L_6 target^-1 = 1`, opened behind the three axes `a, b, c` that pass through a point:
///
/// `(Z_a L_a Z_b L_b Z_c)^-1 = K_0 Z_d K_1 Z_e K_2 Z_f K_3`
///
/// The point stays where it is on the left: `Z_d K_1 Z_e K_2 Z_f (K_3 point_a) = K_0^-1 point_c` is a position
/// problem in three joints (up to four solutions), the rest an orientation problem in the other three (two each).
#[derive(Clone, Debug)]
struct Spherical {
    first: usize,
    links: [Pose; 6],
    /// The point on axis a, seen from a; on axis c, seen from c.
    point_a: Point3<f64>,
    point_c: Point3<f64>,
    ball: Ball,
    size: f64,
    turns: [bool; 3],
    /// Prepared where the links between d, e, f do not depend on the pose.
    place: Option<Place>,
}

/// A position problem in three joints.
#[derive(Clone, Copy, Debug)]
enum Place {
    Turns(Three),
    Slides(slides::Three),
}

impl Place {
    fn new(
        turns: [bool; 3],
        first: &Pose,
        second: &Pose,
        (size, class): (f64, f64),
    ) -> Option<Self> {
        if turns == [true; 3] {
            let normals = (
                Normal::within(first, size, class),
                Normal::within(second, size, class),
            );
            return Three::new(&normals.0, &normals.1).map(Self::Turns);
        }
        slides::Three::new(turns, first, second, size).map(Self::Slides)
    }

    /// In lanes, where that can be done.
    #[inline]
    fn four(&self, place: [f64; 3], point: [f64; 3], slack: f64) -> Option<Four> {
        match self {
            Self::Turns(three) => three.four(place, point, slack),
            Self::Slides(_) => None,
        }
    }

    /// But for the directions, forward and back, that are done.
    #[inline]
    fn solve(
        &self,
        place: [f64; 3],
        point: [f64; 3],
        slack: f64,
        done: [bool; 2],
        out: &mut Reaches,
    ) {
        match self {
            Self::Turns(three) => three.solve(place, point, slack, done, out),
            Self::Slides(three) => three.solve(place, point, slack, out),
        }
    }
}

/// Prepares an arm of the class.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    let Class::Spherical { first } = class else {
        return None;
    };
    let links: [Pose; 6] = arm.links().try_into().ok()?;
    let (one, two) = (
        Normal::of(&links[first], arm.size()),
        Normal::of(&links[first + 1], arm.size()),
    );
    let turns = [3, 4, 5].map(|ahead| arm.turns()[(first + ahead) % 6]);
    let link = |ahead: usize| &links[(first + ahead) % 6];
    let fixed = matches!(first, 0 | 3);
    let place = Place::new(turns, link(3), link(4), (arm.size(), TOLERANCES.class));
    if fixed && place.is_none() {
        return None;
    }
    Some(Arc::new(Spherical {
        first,
        point_a: Point3::new(0.0, 0.0, one.d),
        point_c: Point3::new(0.0, 0.0, -two.e),
        ball: Ball::new(&one, &two),
        size: arm.size(),
        turns,
        place: place.filter(|_| fixed),
        links,
    }))
}

impl Prepared for Spherical {
    fn slack(&self) -> f64 {
        match &self.place {
            Some(Place::Turns(three)) => three.miss(),
            _ => 0.0,
        }
    }

    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        // Links K_0 .. K_3 follow joints c, d, e, f; the pose closes the loop behind joint 6. By reference: copies of poses
        // take longer than what is done with them.
        let link = |index: usize| &self.links[(self.first + index + 8) % 6];
        let closing = (9 - self.first) % 6;
        let closed = link(closing) * target.inverse();
        let at = |index: usize| {
            if index == closing {
                &closed
            } else {
                link(index)
            }
        };
        let links = [at(0), at(1), at(2), at(3)];
        let made;
        let place = match &self.place {
            Some(place) => place,
            None => {
                let sizes = (self.size, TOLERANCES.merely);
                made = match Place::new(self.turns, links[1], links[2], sizes) {
                    Some(place) => place,
                    None => return,
                };
                &made
            }
        };
        let goal = links[0].inverse_transform_point(&self.point_c);
        let point = links[3].transform_point(&self.point_a);
        let rotations = links.map(|link| link.rotation.matrix());
        let (goal, point, slack) = (goal.coords.into(), point.coords.into(), sink.slack());
        let mut done = [false; 2];
        if let Some(four) = place.four(goal, point, slack)
            && self.orient_all(place, &rotations, &four, 0, sink)
        {
            done = four.clear;
            if done == [true; 2] {
                return;
            }
        }
        // Places are numbered where they have no names.
        let before = 2 * done.into_iter().filter(|&done| done).count();
        let mut reaches = Reaches::new();
        place.solve(goal, point, slack, done, &mut reaches);
        if let Some(shortfall) = reaches.shortfall {
            sink.fail(self.part(shortfall.part), shortfall.amount);
        }
        if let Some(four) = Four::gather(reaches.as_slice())
            && self.orient_all(place, &rotations, &four, before, sink)
        {
            return;
        }
        for (index, reach) in reaches.as_slice().iter().enumerate() {
            self.orient(place, &rotations, reach, before + index, sink);
        }
    }
}

impl Spherical {
    /// The words fit an arm with its wrist at the tool; elsewhere they are less specific.
    fn part(&self, part: Part) -> Part {
        match part {
            Part::WristInside if self.first != 3 => Part::Inside,
            Part::WristBeyond if self.first != 3 => Part::ElbowBeyond,
            Part::WristTooNear if self.first != 3 => Part::ElbowTooNear,
            part => part,
        }
    }

    /// The usual case, all of it at once: right angles in the wrist, no singularity near. False if it is another.
    #[inline]
    fn orient_all(
        &self,
        place: &Place,
        links: &[&Matrix3<f64>; 4],
        four: &Four,
        before: usize,
        sink: &mut Sink<'_>,
    ) -> bool {
        let is_usual = sink.slack() == 0.0
            && sink.method() == Method::Matrix
            && self.turns == [true; 3]
            && four.there.contains(&true);
        let (Some(signs), true) = (self.ball.right_signs(), is_usual) else {
            return false;
        };
        let task = WideWrist {
            links,
            turns: &four.turns,
            near: &four.near,
            signs,
            shifts: self.ball.shifts(),
        };
        let Some(Oriented { ball, others }) = wide::run(&task) else {
            return false;
        };
        let mut names = [(Branch::NONE, Marks::PLAIN); 2 * FOUR];
        let mut there = [false; 2 * FOUR];
        for (lane, &signs) in four.signs.iter().enumerate() {
            for flip in [false, true] {
                let at = lane + FOUR * usize::from(flip);
                there[at] = four.there[lane];
                names[at].0 = self.branch(place, signs, before + lane, flip);
                names[at].1.multiplicity = four.multiplicity[lane];
            }
        }
        sink.push_halves(&Halves {
            turns: self.in_order(ball.each_ref(), others.each_ref()),
            there,
            names,
        });
        true
    }

    #[inline]
    fn orient(
        &self,
        place: &Place,
        links: &[&Matrix3<f64>; 4],
        reach: &Reach,
        index: usize,
        sink: &mut Sink<'_>,
    ) {
        let mut whole = *links[0];
        for ((&turn, &turns), link) in reach
            .turns
            .iter()
            .zip(&self.turns)
            .zip(links[1..].iter().copied())
        {
            if turns {
                turn_z(&mut whole, turn);
            }
            whole *= link;
        }
        let rotation = whole.transpose();
        let turns = self.ball.solve(&rotation, sink.slack(), sink.method());
        if let Some(shortfall) = turns.shortfall {
            sink.fail(shortfall.part, shortfall.amount);
        }
        for turned in &turns.list[..turns.len] {
            let branch = self.branch(place, reach.signs, index, turned.flip);
            let marks = Marks {
                multiplicity: reach.multiplicity * turned.multiplicity,
                edge: reach.edge || turned.edge,
                free: reach.free || turned.free,
            };
            sink.push_turns(&self.displacements(reach, &turned.turns), branch, marks);
            if sink.slack() > 0.0 && turned.edge {
                for turns in self.ball.starts(&rotation, turned) {
                    sink.push_turns(&self.displacements(reach, &turns), branch, marks);
                }
            }
        }
    }

    #[inline]
    fn displacements(&self, reach: &Reach, ball: &[(f64, f64); 3]) -> [(f64, f64); 6] {
        self.in_order(*ball, reach.turns)
    }

    /// Something of the three joints that meet and of the other three, in the order of the arm.
    #[inline(always)]
    fn in_order<T: Copy>(&self, ball: [T; 3], others: [T; 3]) -> [T; 6] {
        let mut all = [ball[0]; 6];
        for k in 0..3 {
            all[(self.first + k) % 6] = ball[k];
            all[(self.first + 3 + k) % 6] = others[k];
        }
        all
    }

    #[inline]
    fn branch(&self, place: &Place, [front, bend]: [bool; 2], index: usize, flip: bool) -> Branch {
        let wrist = Some(if flip { Wrist::Flip } else { Wrist::NoFlip });
        match place {
            Place::Turns(three) if self.first == 3 && three.has_names() => {
                let up = (bend == three.up_sign()) == front;
                Branch {
                    shoulder: Some(if three.reaches_forward(front) {
                        Shoulder::Front
                    } else {
                        Shoulder::Back
                    }),
                    elbow: Some(if up { Elbow::Up } else { Elbow::Down }),
                    wrist,
                    root: 0,
                }
            }
            _ => Branch {
                wrist,
                root: index as u8 + 1,
                ..Branch::default()
            },
        }
    }
}

/// `m Rz`
#[inline]
pub(super) fn turn_z(m: &mut Matrix3<f64>, (sin, cos): (f64, f64)) {
    let (x, y): (Vector3<f64>, Vector3<f64>) = (m.column(0).into_owned(), m.column(1).into_owned());
    m.set_column(0, &(x * cos + y * sin));
    m.set_column(1, &(y * cos - x * sin));
}
