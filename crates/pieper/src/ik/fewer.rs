//! Fewer than six joints: joints that the arm does not have make up six, and must come out at zero.

use std::sync::Arc;

use super::arm::{Arm, MAX_JOINTS};
use super::classify::{self, Class, Structure};
use super::curve;
use super::descent::{Room, largest};
use super::extend::{Place, Stand, extended, turns_at};
use super::numeric::start;
use super::registry::{self, Choice, Prepared};
use super::sink::{Marks, Sink, Terms};
use super::solutions::{Branch, JointVector, MAX_SOLUTIONS, Solutions};
use crate::spatial::Pose;

/// An arm of up to five joints inside one of six.
///
/// Whatever reaches the pose with the extra joints at zero is a solution of the arm, and every solution of the arm is
/// among them: where the six-joint solver is complete, so is this. Extra axes stand where they make a spherical joint
/// with the arm's own, or askew, so that roots are isolated although the extra joints stand still.
#[derive(Debug)]
struct Fewer {
    six: Arm,
    choice: Choice,
    dof: usize,
}

/// An extra joint may be off zero by this much (rad) in a proposal; Newton's method on the arm itself decides.
const OFF: f64 = 1e-3;

/// Along a family of the six joints, where the extra ones come closest to zero, they may be off by this much: half a
/// stride along it.
const OFF_ON_CURVE: f64 = 0.3;

/// Prepares an arm of up to five independent joints.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::General || !arm.is_independent() || arm.steps() >= 6 {
        return None;
    }
    // Closed forms first; the elimination takes a millisecond to prepare. Extra axes whose six-joint arm is singular
    // at ordinary poses only if there are no others: families cost time.
    let mut singular = None;
    for special in [true, false] {
        for ends in splits(6 - arm.steps()) {
            match prepare_with(arm, ends, special) {
                Some((fewer, Trial::Regular)) => return Some(Arc::new(fewer)),
                Some((fewer, Trial::Singular)) => singular = singular.or(Some(fewer)),
                _ => {}
            }
        }
    }
    singular.map(|fewer| Arc::new(fewer) as Arc<dyn Prepared>)
}

/// The ends of the arm, with how many extra joints each gets and how they stand.
type Ends = [(Place, usize, Stand); 2];

/// All ways to share out the extra joints, those with a spherical joint at the tool first.
fn splits(missing: usize) -> Vec<Ends> {
    let shared = |at_tool: usize| {
        let at_base = missing - at_tool;
        [(Stand::Askew, Stand::Ball), (Stand::Ball, Stand::Askew)]
            .map(|(base, tool)| [(Place::Base, at_base, base), (Place::Tool, at_tool, tool)])
    };
    let most = missing.min(3);
    (missing - most..=most).rev().flat_map(shared).collect()
}

fn prepare_with(arm: &Arm, ends: Ends, special: bool) -> Option<(Fewer, Trial)> {
    let extras = ends.map(|(place, count, stand)| turns_at(place, count, stand, arm));
    let six = Arm::new(&extended(arm.chain(), &extras.concat()).ok()?).ok()?;
    let mut structure = classify::of_axes(&six);
    structure
        .classes
        .retain(|&(class, _)| (class != Class::General) == special);
    let fewer = Fewer {
        choice: registry::choose(&six, &structure)?,
        six,
        dof: arm.chain().dof(),
    };
    if fewer.choice.name == super::numeric::NAME {
        return None;
    }
    let trial = fewer.trial(arm);
    Some((fewer, trial))
}

/// Test poses, and how many of them must be regular.
const TRIALS: usize = 8;
const REGULAR: usize = 4;

/// A root closer than this to the joint values that made a test pose is theirs.
const FOUND: f64 = 1e-6;

/// What test poses say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Trial {
    /// The six-joint arm is regular at all of them.
    Regular,
    /// All joint values were found, but the six-joint arm has families.
    Singular,
    /// Joint values were lost, or too few poses were regular to tell.
    Lossy,
}

impl Fewer {
    /// Whether the joint values that made some test poses are found again.
    fn trial(&self, arm: &Arm) -> Trial {
        let (mut regular, mut singular) = (0, 0);
        let mut out = Solutions::default();
        for index in 1..=TRIALS {
            let q = start(arm, index, Room::Free);
            if curve::tangent(arm, &q).1 < FOUND {
                continue;
            }
            regular += 1;
            let pose = arm.pose(&q);
            let mut sink = Sink::new(arm, &pose, Terms::default(), &mut out);
            self.solve(&arm.target(&pose), &mut sink);
            sink.finish();
            let near = |found: &JointVector| largest(&curve::difference(arm, found, &q)) < FOUND;
            if !out.iter().any(|solution| near(&solution.q)) {
                return Trial::Lossy;
            }
            self.solve_six(&pose, &mut out);
            singular += usize::from(!out.families().is_empty());
        }
        match (regular, singular) {
            (..REGULAR, _) => Trial::Lossy,
            (_, 0) => Trial::Regular,
            _ => Trial::Singular,
        }
    }

    /// Everything that reaches the pose, wherever the extra joints stand.
    fn solve_six(&self, pose: &Pose, out: &mut Solutions) {
        let terms = Terms {
            slack: self.choice.slack,
            ..Terms::default()
        };
        let mut sink = Sink::new(&self.six, pose, terms, out);
        self.choice.solver.solve(&self.six.target(pose), &mut sink);
        sink.finish();
    }

    /// How far the extra joints are from zero.
    fn off(&self, q: &JointVector) -> f64 {
        let turned = curve::difference(&self.six, &[0.0; MAX_JOINTS], q);
        largest(&turned[self.dof..])
    }

    /// Where a family of the six-joint arm comes closest to having its extra joints at zero.
    #[cold]
    fn visit(
        &self,
        pose: &Pose,
        member: &JointVector,
        heading: &JointVector,
        found: &mut Proposals,
    ) {
        let mut last: [Option<(JointVector, f64)>; 2] = [None; 2];
        curve::follow(&self.six, member, heading, pose, |q, _| {
            let here = (*q, self.off(q));
            if let [before, Some(middle)] = last
                && middle.1 < OFF_ON_CURVE
                && middle.1 <= here.1
                && before.is_none_or(|before| middle.1 <= before.1)
            {
                found.add(&self.six, &middle.0, 1);
            }
            last = [last[1], Some(here)];
            true
        });
        if let Some((q, off)) = last[1]
            && off < OFF_ON_CURVE
        {
            found.add(&self.six, &q, 1);
        }
    }
}

/// Proposals without repetition.
struct Proposals {
    list: [(JointVector, u8); 2 * MAX_SOLUTIONS],
    len: usize,
}

impl Proposals {
    fn add(&mut self, arm: &Arm, q: &JointVector, multiplicity: u8) {
        let known = self.list[..self.len]
            .iter()
            .any(|(known, _)| largest(&curve::difference(arm, known, q)) < FOUND);
        if !known && self.len < self.list.len() {
            self.list[self.len] = (*q, multiplicity);
            self.len += 1;
        }
    }
}

impl Prepared for Fewer {
    fn solve(&self, _: &Pose, sink: &mut Sink<'_>) {
        let (arm, pose) = (sink.arm(), sink.pose());
        let mut all = Solutions::default();
        self.solve_six(pose, &mut all);
        let mut found = Proposals {
            list: [([0.0; MAX_JOINTS], 1); 2 * MAX_SOLUTIONS],
            len: 0,
        };
        for solution in all.iter().filter(|solution| self.off(&solution.q) < OFF) {
            found.add(&self.six, &solution.q, solution.multiplicity);
        }
        for family in all.families() {
            self.visit(pose, &family.member, &family.heading, &mut found);
        }
        for (q, multiplicity) in &found.list[..found.len] {
            let mut own = [0.0; MAX_JOINTS];
            own[..self.dof].copy_from_slice(&q[..self.dof]);
            let singular = curve::tangent(arm, &own).1 < SINGULAR;
            let marks = Marks {
                multiplicity: if singular { *multiplicity } else { 1 },
                edge: true,
                free: singular,
            };
            let branch = Branch {
                root: sink.found() as u8 + 1,
                ..Branch::default()
            };
            sink.push_joints(own, branch, marks);
        }
    }
}

/// Below this smallest rate of change of the pose roots may merge or lie on a family.
const SINGULAR: f64 = 1e-6;
