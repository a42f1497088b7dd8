//! Joints that turn about parallel axes: a triangle in the plane, and arms of nothing else (SCARA).

use std::sync::Arc;

use nalgebra::Matrix3;

use super::TOLERANCES;
use super::angle::{Roots, back, turn_between, unit};
use super::arm::{Arm, MAX_JOINTS};
use super::classify::{Class, Structure};
use super::normal::Normal;
use super::reason::{Part, Shortfall};
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, Elbow};
use super::wide::Turning;
use crate::spatial::Pose;
use crate::spatial::sin_cos_exact;

/// `Z_a L_a Z_b L_b Z_c = S` with both links between parallel axes: the motion `S` keeps the plane.
///
/// The distance of the third axis from the first gives the middle angle (two ways), its direction the first, the
/// turn of `S` the last.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    lengths: [f64; 2],
    /// Whether each link turns the plane over: -1 if so.
    flips: [f64; 2],
    shifts: [(f64, f64); 3],
    /// The shift of `S` along z, which no joint changes.
    pub(super) rise: f64,
}

/// One way to close the triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bent {
    /// Sines and cosines, up to a common factor of the last.
    pub(super) turns: [(f64, f64); 3],
    /// The sign of the bend.
    pub(super) bend: bool,
    pub(super) multiplicity: u8,
    pub(super) edge: bool,
    pub(super) free: bool,
}

/// Both ways.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bends {
    pub(super) list: [Bent; 3],
    pub(super) len: usize,
    pub(super) shortfall: Option<Shortfall>,
}

impl Triangle {
    /// `None` unless both links join parallel axes at a distance.
    pub(super) fn new(first: &Normal, second: &Normal) -> Option<Self> {
        let parallel = |link: &Normal| link.is_parallel() && !link.meets();
        (parallel(first) && parallel(second)).then_some(Self {
            lengths: [first.a, second.a],
            flips: [first.alpha.1, second.alpha.1],
            shifts: [first.phi, first.psi + second.phi, second.psi].map(sin_cos_exact),
            rise: first.d + first.alpha.1 * second.d,
        })
    }

    /// What is needed to close it in several branches at once.
    pub(super) fn turning(&self) -> Turning<'_> {
        Turning {
            lengths: self.lengths,
            flips: self.flips,
            zeros: &self.shifts,
        }
    }

    /// Whether z keeps its direction through `S`: -1 if it is turned over.
    pub(super) fn flip(&self) -> f64 {
        self.flips[0] * self.flips[1]
    }

    /// The least and the greatest distance of the third axis from the first.
    pub(super) fn reach(&self) -> [f64; 2] {
        let [a, b] = self.lengths;
        [(a - b).abs(), a + b]
    }

    /// The ways to bring the third axis to `at`, and the x axis behind it to the direction `toward`.
    #[inline]
    pub(super) fn solve(&self, at: [f64; 2], toward: [f64; 2], slack: f64) -> Bends {
        let [a, b] = self.lengths;
        let reach = (at[0] * at[0] + at[1] * at[1]).sqrt();
        let [short, long] = self.reach();
        let square = (long - reach) * (long + reach) * (reach - short) * (reach + short)
            / (4.0 * a * a * b * b);
        let cosine = (reach * reach - a * a - b * b) / (2.0 * a * b);
        let roots = Roots::of(square, slack);
        let empty = Bent {
            turns: [(0.0, 1.0); 3],
            bend: true,
            multiplicity: if roots.len == 1 { 2 } else { 1 },
            edge: roots.edge,
            free: reach < TOLERANCES.free * long,
        };
        let mut bends = Bends {
            list: [empty; 3],
            len: roots.len,
            shortfall: None,
        };
        if reach > long {
            bends.fail(Part::ElbowBeyond, reach - long);
        } else if reach < short {
            bends.fail(Part::ElbowTooNear, short - reach);
        }
        for ((bent, root), sign) in bends
            .list
            .iter_mut()
            .zip(roots.iter())
            .zip([true, false, true])
        {
            let middle = unit((root, cosine));
            let (sin, cos) = middle;
            let elbow = [a + b * cos, self.flips[0] * b * sin];
            let first = if bent.free {
                (0.0, 1.0)
            } else {
                turn_between(elbow, at)
            };
            // The x axis behind the third joint points to first + flip_1 (middle + flip_2 last).
            let rest = back((toward[1], toward[0]), first);
            let rest = back(rest, (self.flips[0] * sin, cos));
            let last = (self.flip() * rest.0, rest.1);
            let all = [first, middle, last];
            bent.turns = std::array::from_fn(|i| back(all[i], self.shifts[i]));
            bent.bend = sign;
        }
        bends
    }
}

impl Bends {
    fn fail(&mut self, part: Part, amount: f64) {
        self.shortfall = Some(Shortfall { part, amount });
    }
}

/// An arm of three joints that turn about parallel axes and at most one that slides along them.
#[derive(Clone, Debug)]
struct Planar {
    triangle: Triangle,
    /// The steps that turn.
    turning: [usize; 3],
    /// The step that slides, and the direction of its axis: -1 if it points against the first.
    sliding: Option<(usize, f64)>,
    /// From the third turning axis, all joints at zero, to the tool.
    last: Pose,
    /// From the first axis to the first that turns.
    lead: Pose,
}

/// Prepares an arm of the class.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::AllParallel {
        return None;
    }
    let mut turning = Vec::new();
    let mut sliding = None;
    // Links between the joints that turn: a slide along the common direction can as well be the last joint.
    let mut spans = vec![Pose::identity()];
    let mut heading = 1.0;
    for (index, (&turns, link)) in arm.turns().iter().zip(arm.links()).enumerate() {
        if turns {
            turning.push(index);
            spans.push(Pose::identity());
        } else if sliding.replace((index, heading)).is_some() {
            return None;
        }
        if let Some(span) = spans.last_mut() {
            *span *= link;
        }
        heading *= link.rotation.matrix()[(2, 2)].signum();
    }
    let turning: [usize; 3] = turning.try_into().ok()?;
    let [lead, first, second, last] = spans.try_into().ok()?;
    let normals = [first, second].map(|link| Normal::of(&link, arm.size()));
    Some(Arc::new(Planar {
        triangle: Triangle::new(&normals[0], &normals[1])?,
        turning,
        sliding,
        last,
        lead,
    }))
}

impl Prepared for Planar {
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        let mut motion = self.lead.inverse() * target * self.last.inverse();
        let m: Matrix3<f64> = *motion.rotation.matrix();
        let flip = self.triangle.flip();
        let tilt = m[(0, 2)].hypot(m[(1, 2)]).atan2(flip * m[(2, 2)]);
        if tilt > TOLERANCES.class {
            sink.fail(Part::ToolAxis, tilt);
            return;
        }
        let gap = motion.translation.vector.z - self.triangle.rise;
        let mut all = [(0.0, 0.0); MAX_JOINTS];
        let upright = self.lead.rotation.matrix()[(2, 2)].signum();
        match self.sliding {
            Some((step, heading)) => all[step].0 = gap * heading * upright,
            None if gap.abs() > TOLERANCES.class * sink.arm().size() => {
                sink.fail(Part::Slides, gap.abs());
                return;
            }
            None => {}
        }
        motion.translation.vector.z = 0.0;
        let at = [motion.translation.vector.x, motion.translation.vector.y];
        let bends = self
            .triangle
            .solve(at, [m[(0, 0)], m[(1, 0)]], sink.slack());
        if let Some(shortfall) = bends.shortfall {
            sink.fail(shortfall.part, shortfall.amount);
        }
        for bent in &bends.list[..bends.len] {
            for (&step, &turn) in self.turning.iter().zip(&bent.turns) {
                all[step] = turn;
            }
            let branch = Branch {
                elbow: Some(if bent.bend { Elbow::Down } else { Elbow::Up }),
                ..Branch::default()
            };
            let marks = Marks {
                multiplicity: bent.multiplicity,
                edge: bent.edge,
                free: bent.free,
            };
            sink.push_turns(&all[..sink.arm().steps()], branch, marks);
        }
    }
}
