//! Seven joints: one at an end is held at many values, the other six are solved; what is found lies on families.

use std::f64::consts::PI;
use std::sync::Arc;

use super::arm::{Arm, MAX_JOINTS};
use super::classify::{self, Class, Structure};
use super::curve;
use super::descent::{Room, largest};
use super::extend::{Place, without_end};
use super::numeric::start;
use super::registry::{self, Choice, Prepared};
use super::sink::{Marks, Sink, Terms};
use super::solutions::{Branch, JointVector, MAX_SOLUTIONS, Solutions};
use crate::model::Drive;
use crate::spatial::{Pose, shift, turn};
use nalgebra::Vector3;

/// An arm of seven joints as one of six and a joint at an end.
///
/// Held at a value, the first or the last joint only moves the pose that the other six have to reach: their solver is
/// prepared once. At [`SLICES`] values over its range all solutions are found; each lies on a curve of solutions, which
/// is followed and takes in the others that it passes. A family that lives on less of the joint's range than the
/// distance of two values can be missed.
#[derive(Debug)]
struct Locked {
    six: Arm,
    choice: Choice,
    end: Place,
    /// The locked joint.
    variable: usize,
    drive: Drive,
    turns: bool,
    /// What stands between the world and the locked joint's motion, and behind it up to the six: base and link, or link.
    around: [Pose; 2],
    range: [f64; 2],
}

/// Values of the locked joint.
const SLICES: usize = 96;

/// Test joint vectors for the choice of the locked joint.
const TRIALS: usize = 16;

/// A joint that moves less than this part of a unit step along the families, on average, does not tell them apart.
const IDLE: f64 = 0.05;

/// Prepares an arm of seven independent joints. Of the two end joints the one is locked that leaves the more special
/// arm; of equals, the one that moves more along the families, averaged over some fixed joint vectors.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::General || !arm.is_independent() || arm.steps() != 7 {
        return None;
    }
    let candidates = [Place::Tool, Place::Base].into_iter();
    let candidates = candidates.filter_map(|end| Locked::new(arm, end));
    let best = candidates.min_by(|(a, moves_a), (b, moves_b)| {
        let rank = |locked: &Locked| {
            registry::ROWS
                .iter()
                .position(|row| row.name == locked.choice.name)
        };
        rank(a).cmp(&rank(b)).then(moves_b.total_cmp(moves_a))
    });
    best.map(|(locked, _)| Arc::new(locked) as Arc<dyn Prepared>)
}

impl Locked {
    /// With how much the joint moves along the families.
    fn new(arm: &Arm, end: Place) -> Option<(Self, f64)> {
        let chain = arm.chain();
        let canonical = chain.canonical();
        let step = match end {
            Place::Base => 0,
            Place::Tool => arm.steps() - 1,
        };
        let drive = arm.drives()[step];
        let variable = drive.variable;
        let movement = |index: usize| {
            let q = start(arm, index + 1, Room::Free);
            curve::tangent(arm, &q).0[variable].abs() / TRIALS as f64
        };
        let movement: f64 = (0..TRIALS).map(movement).sum();
        if movement < IDLE {
            return None;
        }
        let six = Arm::new(&without_end(chain, end).ok()?).ok()?;
        let choice = registry::choose(&six, &classify::of(&six))?;
        if choice.name == super::numeric::NAME {
            return None;
        }
        let turns = arm.turns()[step];
        let range = match chain.variables()[variable].limits {
            _ if turns => [-PI / drive.factor.abs(), PI / drive.factor.abs()],
            Some(limits) => [limits.lower(), limits.upper()],
            None => [-arm.extent(), arm.extent()],
        };
        let around = match end {
            Place::Base => [canonical.base, arm.links()[0]],
            Place::Tool => [Pose::identity(), arm.links()[step]],
        };
        let locked = Self {
            six,
            choice,
            end,
            variable,
            drive,
            turns,
            around,
            range,
        };
        Some((locked, movement))
    }

    fn value(&self, slice: usize) -> f64 {
        let [lower, upper] = self.range;
        lower + (slice as f64 + 0.5) / SLICES as f64 * (upper - lower)
    }

    /// All joint vectors with the locked joint at a value.
    fn at(&self, value: f64, pose: &Pose, out: &mut Solutions) {
        let moved = self.drive.factor.mul_add(value, self.drive.offset);
        let motion = if self.turns {
            turn(&Vector3::z_axis(), moved.sin_cos())
        } else {
            shift(Vector3::new(0.0, 0.0, moved))
        };
        let held = (self.around[0] * motion * self.around[1]).inverse();
        let pose = match self.end {
            Place::Base => held * pose,
            Place::Tool => pose * held,
        };
        let terms = Terms {
            slack: self.choice.slack,
            ..Terms::default()
        };
        let mut sink = Sink::new(&self.six, &pose, terms, out);
        self.choice.solver.solve(&self.six.target(&pose), &mut sink);
        sink.finish();
        for solution in &mut out.list[..out.len] {
            solution
                .q
                .copy_within(self.variable..MAX_JOINTS - 1, self.variable + 1);
            solution.q[self.variable] = value;
        }
    }
}

/// What was found at one value, and whether a family passes it. Small: there are many.
#[derive(Clone, Copy)]
struct Slice {
    list: [([f64; 7], Branch); MAX_SOLUTIONS],
    passed: [bool; MAX_SOLUTIONS],
    len: usize,
}

impl Slice {
    fn q(&self, place: usize) -> JointVector {
        let mut q = [0.0; MAX_JOINTS];
        q[..7].copy_from_slice(&self.list[place].0);
        q
    }
}

/// A family passes a solution if it is closer than this to the line between two of its points, or to that line
/// prolonged by this part at both ends: near a fold, points may lie on one side of a value that the family touches.
const PASSES: f64 = 0.06;
const BEYOND: f64 = 0.3;

impl Prepared for Locked {
    fn solve(&self, _: &Pose, sink: &mut Sink<'_>) {
        let (arm, pose) = (sink.arm(), sink.pose());
        let mut out = Solutions::default();
        let mut slices = [Slice {
            list: [([0.0; 7], Branch::NONE); MAX_SOLUTIONS],
            passed: [false; MAX_SOLUTIONS],
            len: 0,
        }; SLICES];
        for (index, slice) in slices.iter_mut().enumerate() {
            self.at(self.value(index), pose, &mut out);
            slice.len = out.len;
            for (kept, solution) in slice.list.iter_mut().zip(&out) {
                kept.0.copy_from_slice(&solution.q[..7]);
                kept.1 = solution.branch;
            }
        }
        // From the middle of the joint's range outwards.
        for step in 0..SLICES {
            let half = step.div_ceil(2);
            let index = if step % 2 == 0 {
                SLICES / 2 + half
            } else {
                SLICES / 2 - half
            };
            for place in 0..slices[index].len {
                if slices[index].passed[place] {
                    continue;
                }
                let (q, branch) = (slices[index].q(place), slices[index].list[place].1);
                sink.push_joints(q, branch, Marks::PLAIN);
                let (heading, _) = curve::tangent(arm, &q);
                let mut last = q;
                slices[index].passed[place] = true;
                let followed = curve::follow(arm, &q, &heading, pose, |at, begins| {
                    if begins {
                        last = q;
                    }
                    self.pass(arm, &last, at, &mut slices);
                    last = *at;
                    true
                });
                if followed == curve::Followed::Closed {
                    self.pass(arm, &last, &q, &mut slices);
                }
            }
        }
    }
}

impl Locked {
    /// Marks what a family passes between two of its points.
    fn pass(&self, arm: &Arm, from: &JointVector, to: &JointVector, slices: &mut [Slice]) {
        let step = curve::difference(arm, from, to);
        let unit = arm.unit(self.variable);
        let (begin, width) = (from[self.variable], step[self.variable] * unit);
        if width == 0.0 {
            return;
        }
        let [lower, upper] = self.range;
        let place = |value: f64| (value - lower) / (upper - lower) * SLICES as f64 - 0.5;
        let ends = [begin - BEYOND * width, begin + (1.0 + BEYOND) * width].map(place);
        let most = (2 * SLICES) as f64;
        if !(ends[0].abs() < most && ends[1].abs() < most) {
            // A range of no length, or a joint far outside it.
            return;
        }
        let first = ends[0].min(ends[1]).ceil() as i64;
        let last = ends[0].max(ends[1]).floor() as i64;
        for index in first..=last {
            let turns = index.div_euclid(SLICES as i64);
            if turns != 0 && !self.turns {
                continue;
            }
            let slice = index.rem_euclid(SLICES as i64) as usize;
            let value = self.value(slice) + turns as f64 * (upper - lower);
            let part = (value - begin) / width;
            let mut at = *from;
            for (j, value) in at.iter_mut().enumerate().take(arm.chain().dof()) {
                *value += part * step[j] * arm.unit(j);
            }
            let slice = &mut slices[slice];
            for place in 0..slice.len {
                let gap = largest(&curve::difference(arm, &at, &slice.q(place)));
                slice.passed[place] |= gap < PASSES;
            }
        }
    }
}
