//! Where rows put their proposals: everything is verified here, on the true model.

use super::arm::{Arm, residuals};
use super::curve;
use super::descent::{self, ROUNDING, Room, newton};
use super::pending::{Halves, Measured, Names, Pending};
use super::reason::{Part, Shortfall};
use super::solutions::{
    Branch, Family, JointVector, MAX_FAMILIES, MAX_SOLUTIONS, Solution, Solutions, Status,
};
use super::wide::FOUR;
use super::wrist::Method;
use super::{MAX_JOINTS, TOLERANCES};
use crate::kinematics::group::GROUP;
use crate::spatial::Pose;

/// What a row knows about a proposal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marks {
    /// How many roots the proposal stands for.
    pub multiplicity: u8,
    /// Other proposals may be the same root, split by rounding.
    pub edge: bool,
    /// Some displacement is undetermined: there may be a family through it.
    pub free: bool,
}

impl Marks {
    /// One root, away from others.
    pub const PLAIN: Self = Self {
        multiplicity: 1,
        edge: false,
        free: false,
    };
}

/// How a pose is to be solved.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Terms {
    /// See [`Sink::slack`].
    pub(super) slack: f64,
    /// See [`Sink::method`].
    pub(super) method: Method,
    /// See [`Question::swivel`](super::Question::swivel).
    pub(super) swivel: Option<f64>,
}

/// Starts of the search of last resort.
const RESCUE_STARTS: usize = 40;

/// Collects a row's proposals: verifies them on the true model, refines what misses by a hair, merges roots that
/// coincide and recognises families.
#[derive(Debug)]
pub struct Sink<'a> {
    arm: &'a Arm,
    pose: &'a Pose,
    terms: Terms,
    out: &'a mut Solutions,
    shortfall: Option<Shortfall>,
    rejected: bool,
    /// Some root was found to be several.
    merged: bool,
    /// Made with the first proposal that has to wait for others.
    pending: Option<Pending>,
}

impl<'a> Sink<'a> {
    pub(super) fn new(arm: &'a Arm, pose: &'a Pose, terms: Terms, out: &'a mut Solutions) -> Self {
        out.clear();
        Self {
            arm,
            pose,
            terms,
            out,
            shortfall: None,
            rejected: false,
            merged: false,
            pending: None,
        }
    }

    /// How rotations are to be represented where a row knows more than one way.
    pub fn method(&self) -> Method {
        self.terms.method
    }

    /// The arm.
    pub fn arm(&self) -> &'a Arm {
        self.arm
    }

    /// The wanted pose of the tool, in the world.
    pub fn pose(&self) -> &'a Pose {
        self.pose
    }

    /// How far the arm misses the class that its row solves, relative: 0 for none. Where a row must decide whether a
    /// root exists, it gives this much the benefit of the doubt.
    pub fn slack(&self) -> f64 {
        self.terms.slack
    }

    /// Where the elbow of a redundant arm is wanted.
    pub(super) fn swivel(&self) -> Option<f64> {
        self.terms.swivel
    }

    /// The number of isolated solutions and families so far.
    pub fn found(&self) -> usize {
        self.out.len + self.out.family_count
    }

    /// Whether there is no room for more families or no room for more isolated solutions.
    pub(super) fn is_full(&self) -> bool {
        self.out.len == MAX_SOLUTIONS || self.out.family_count == MAX_FAMILIES
    }

    /// Says that a branch does not exist, and how far it is from existing.
    pub fn fail(&mut self, part: Part, amount: f64) {
        if amount > 0.0 && self.shortfall.is_none_or(|least| amount < least.amount) {
            self.shortfall = Some(Shortfall { part, amount });
        }
    }

    /// Proposes displacements, one for each step of an arm whose joints have variables of their own.
    #[inline]
    pub fn push(&mut self, displacements: &[f64], branch: Branch, marks: Marks) {
        let q = self.arm.joint_vector(displacements);
        self.push_joints(q, branch, marks);
    }

    /// Proposes displacements by sine and cosine (up to a common positive factor) of each step that turns, value and
    /// 0 of each that slides. The fast way: eight proposals are turned into angles and verified at once.
    #[inline]
    pub fn push_turns(&mut self, turns: &[(f64, f64)], branch: Branch, marks: Marks) {
        if !self.arm.is_plain() {
            let mut all = [0.0; MAX_JOINTS];
            for ((value, &(sin, cos)), &turns) in all.iter_mut().zip(turns).zip(self.arm.turns()) {
                *value = if turns { sin.atan2(cos) } else { sin };
            }
            return self.push(&all[..turns.len()], branch, marks);
        }
        let pending = self.pending.get_or_insert_with(Pending::new);
        pending.push(turns, branch, marks);
        if pending.is_full() {
            self.flush();
        }
    }

    /// Proposes both ways of up to four branches, of an arm of six joints: the fastest way, from lanes to lanes. In the
    /// order of the branches, the first way first.
    #[inline]
    pub(super) fn push_halves(&mut self, halves: &Halves<'_>) {
        let there = halves.there;
        let order = (0..GROUP)
            .map(|index| index / 2 + FOUR * (index % 2))
            .filter(|&lane| there[lane]);
        if there == [false; GROUP] {
            return;
        }
        if self.arm.is_plain() {
            self.flush();
            let measured = Measured::of(&halves.turns, self.arm, self.pose);
            return self.verify(&measured, &halves.names, order);
        }
        for lane in order {
            let turns = halves
                .turns
                .map(|[sines, cosines]| (sines[lane], cosines[lane]));
            let (branch, marks) = halves.names[lane];
            self.push_turns(&turns, branch, marks);
        }
    }

    /// Verifies what is pending.
    fn flush(&mut self) {
        let Some(pending) = &mut self.pending else {
            return;
        };
        let count = pending.take();
        if count > 0 {
            let names = pending.names();
            let measured = Measured::of(&pending.turns(), self.arm, self.pose);
            self.verify(&measured, &names, 0..count);
        }
    }

    /// Lists those of these lanes that make the pose, and looks closer at those that do not, or not for certain.
    #[inline]
    fn verify(&mut self, measured: &Measured, names: &Names, lanes: impl Iterator<Item = usize>) {
        let dof = self.arm.chain().dof();
        let limit = TOLERANCES.rounding;
        for lane in lanes {
            let (branch, marks) = names[lane];
            let plain = !marks.free && !marks.edge && self.terms.slack == 0.0 && dof <= 6;
            match &measured.misses {
                Some([turn, shift])
                    if plain && turn[lane] <= limit && shift[lane] <= limit * self.arm.extent() =>
                {
                    let Some(slot) = self.out.list.get_mut(self.out.len) else {
                        continue;
                    };
                    // Where it belongs at once: a copy of each would take a tenth of the time.
                    measured.write(lane, dof, &mut slot.q);
                    slot.dof = dof as u8;
                    slot.residual = turn[lane].max(shift[lane]);
                    slot.branch = branch;
                    slot.multiplicity = marks.multiplicity;
                    slot.within_limits = measured.within[lane];
                    self.out.len += 1;
                }
                _ => {
                    let mut q = [0.0; MAX_JOINTS];
                    measured.write(lane, dof, &mut q);
                    self.push_verified(q, branch, marks);
                }
            }
        }
    }

    #[inline]
    fn solution(
        &self,
        q: JointVector,
        within_limits: bool,
        residual: f64,
        (branch, marks): (Branch, Marks),
    ) -> Solution {
        Solution {
            q,
            dof: self.arm.chain().dof() as u8,
            residual,
            branch,
            multiplicity: marks.multiplicity,
            within_limits,
        }
    }

    /// Proposes a joint vector. True if it was a new isolated solution.
    #[inline]
    pub fn push_joints(&mut self, q: JointVector, branch: Branch, marks: Marks) -> bool {
        // In the order of the proposals.
        self.flush();
        self.push_verified(q, branch, marks)
    }

    fn push_verified(&mut self, mut q: JointVector, branch: Branch, marks: Marks) -> bool {
        let extent = self.arm.extent();
        let (mut turn, mut shift) = residuals(&self.arm.pose(&q), self.pose);
        let mut refined = false;
        let rough = |turn: f64, shift: f64, limit: f64| !(turn <= limit && shift <= limit * extent);
        if rough(turn, shift, TOLERANCES.rounding) {
            let start = q;
            (q, _) = newton(self.arm, &start, self.pose, None, f64::EPSILON);
            (turn, shift) = residuals(&self.arm.pose(&q), self.pose);
            if self.terms.slack > 0.0 && rough(turn, shift, TOLERANCES.closes) {
                // Near a singularity Newton's steps overshoot; damped ones do not.
                let near = descent::damped(self.arm, &start, self.pose, Room::Free, ROUNDING);
                (q, _) = newton(self.arm, &near.q, self.pose, None, f64::EPSILON);
            }
            self.arm.wrap(&mut q);
            (turn, shift) = residuals(&self.arm.pose(&q), self.pose);
            refined = true;
        }
        if rough(turn, shift, TOLERANCES.closes) {
            self.rejected = true;
            return false;
        }
        let within = super::limits::within(self.arm.bounds(), &q);
        let solution = self.solution(q, within, turn.max(shift), (branch, marks));
        if self.terms.swivel.is_some() {
            return !self.merge(&solution, true) && self.insert(&solution);
        }
        if self.arm.chain().dof() > 6 {
            return self.add_redundant(&solution, marks);
        }
        if marks.free && self.add_family(&solution) {
            return false;
        }
        if (marks.edge || refined || self.terms.slack > 0.0) && self.merge(&solution, refined) {
            return false;
        }
        self.insert(&solution)
    }

    #[inline]
    fn insert(&mut self, solution: &Solution) -> bool {
        if self.out.len == MAX_SOLUTIONS {
            return false;
        }
        self.out.list[self.out.len] = *solution;
        self.out.len += 1;
        true
    }

    /// The largest difference of two joint vectors, angles modulo whole turns.
    fn distance(&self, a: &JointVector, b: &JointVector) -> f64 {
        descent::largest(&curve::difference(self.arm, a, b))
    }

    /// Whether the solution is one that is listed already; if so, that one takes it in.
    fn merge(&mut self, solution: &Solution, refined: bool) -> bool {
        for index in 0..self.out.len {
            let listed = self.out.list[index];
            let distance = self.distance(&listed.q, &solution.q);
            if distance > TOLERANCES.near {
                continue;
            }
            if refined && distance < TOLERANCES.same {
                return true;
            }
            if let Some((middle, residual)) = self.common(&listed.q, &solution.q, distance) {
                let kept = &mut self.out.list[index];
                kept.q = middle;
                kept.residual = residual;
                kept.multiplicity = kept.multiplicity.saturating_add(solution.multiplicity);
                kept.within_limits = super::limits::within(self.arm.bounds(), &middle);
                self.merged = true;
                return true;
            }
        }
        false
    }

    /// A root between two roots that are so close that rounding cannot tell them apart, and its residual.
    #[cold]
    fn common(
        &self,
        a: &JointVector,
        b: &JointVector,
        distance: f64,
    ) -> Option<(JointVector, f64)> {
        /// A step that leaves more than this part of the error has nothing to do with a curved valley.
        const LEFT: f64 = 0.1;
        /// Steps from the line between two points of a valley to its floor: the error is squared with each.
        const STEPS: usize = 2;
        let mut middle = *a;
        let line = curve::difference(self.arm, a, b);
        for (j, value) in middle.iter_mut().enumerate().take(self.arm.chain().dof()) {
            *value += 0.5 * line[j] * self.arm.unit(j);
        }
        let limit = match distance < TOLERANCES.same {
            true => TOLERANCES.rounding,
            false => TOLERANCES.one,
        };
        let mut least = f64::INFINITY;
        for _ in 0..=STEPS {
            let mut root = middle;
            self.arm.wrap(&mut root);
            let (turn, shift) = residuals(&self.arm.pose(&root), self.pose);
            if turn <= limit && shift <= limit * self.arm.extent() {
                let between = [a, b]
                    .iter()
                    .all(|end| self.distance(end, &root) < 0.9 * distance);
                return (between || distance < TOLERANCES.same).then_some((root, turn.max(shift)));
            }
            let error = turn.max(shift / self.arm.extent());
            if error.is_nan() || error > LEFT * least {
                return None;
            }
            least = error;
            descent::step_beside(self.arm, &mut middle, self.pose, &line);
        }
        None
    }

    /// Adds the family through a solution, if there is one; true also if it is listed already.
    #[cold]
    fn add_family(&mut self, solution: &Solution) -> bool {
        let Some(free) = curve::grows(self.arm, &solution.q, self.pose) else {
            return false;
        };
        for family in &self.out.families[..self.out.family_count] {
            let line = (&family.at, &family.heading);
            if curve::passes(self.arm, line, self.pose, &solution.q, MAX_JOINTS) {
                return true;
            }
        }
        self.push_family(solution, free);
        true
    }

    fn add_redundant(&mut self, solution: &Solution, marks: Marks) -> bool {
        for family in &self.out.families[..self.out.family_count] {
            let line = (&family.at, &family.heading);
            if self.distance(&family.at, &solution.q) < TOLERANCES.near
                || marks.edge && curve::passes(self.arm, line, self.pose, &solution.q, MAX_JOINTS)
            {
                return false;
            }
        }
        let (free, _) = curve::tangent(self.arm, &solution.q);
        self.push_family(solution, free);
        true
    }

    fn push_family(&mut self, solution: &Solution, heading: JointVector) {
        let mut free = heading;
        for (j, value) in free.iter_mut().enumerate().take(self.arm.chain().dof()) {
            *value *= self.arm.unit(j);
        }
        let length = free.iter().map(|x| x * x).sum::<f64>().sqrt();
        free.iter_mut().for_each(|x| *x /= length);
        if self.out.family_count < MAX_FAMILIES {
            self.out.families[self.out.family_count] = Family {
                member: solution.q,
                at: solution.q,
                heading,
                free,
                dof: solution.dof,
                residual: solution.residual,
                branch: solution.branch,
            };
            self.out.family_count += 1;
        }
    }

    /// Roots by search, where the arm misses its class and none of the class's roots led to one: near several
    /// singularities at once a hair of a miss moves roots far.
    #[cold]
    fn rescue(&mut self) {
        for index in 0..RESCUE_STARTS {
            let start = super::numeric::start(self.arm, index, Room::Free);
            let mut found = descent::damped(self.arm, &start, self.pose, Room::Free, ROUNDING);
            self.arm.wrap(&mut found.q);
            if found.error < TOLERANCES.class {
                let marks = Marks {
                    edge: true,
                    ..Marks::PLAIN
                };
                let branch = Branch {
                    root: self.out.len as u8 + 1,
                    ..Branch::default()
                };
                self.push_joints(found.q, branch, marks);
            }
        }
    }

    /// Makes families of merged roots that lie on one: on a stretched elbow the wrist is straight only to half of the
    /// digits until the roots have merged, and no row sees that it is.
    #[cold]
    fn spread_merged(&mut self) {
        let mut index = 0;
        while index < self.out.len {
            let solution = self.out.list[index];
            if solution.multiplicity > 1 && self.add_family(&solution) {
                self.out.list.copy_within(index + 1..self.out.len, index);
                self.out.len -= 1;
            } else {
                index += 1;
            }
        }
    }

    /// Draws the conclusion.
    // Into the caller: the whole would be copied for the call.
    #[inline(always)]
    pub(super) fn finish(mut self) {
        self.conclude();
    }

    fn conclude(&mut self) {
        self.flush();
        if self.merged && self.arm.chain().dof() <= 6 {
            self.spread_merged();
        }
        if self.terms.slack > 0.0 && self.rejected && self.out.len + self.out.family_count == 0 {
            self.rescue();
        }
        let out = &mut *self.out;
        out.status = match (out.family_count, out.len) {
            (0, 0) => Status::Unreachable,
            (0, _) => Status::Solved,
            _ if self.arm.chain().dof() > 6 => Status::Redundant,
            _ => Status::Singular,
        };
        if out.status == Status::Unreachable {
            out.reason = self.shortfall;
            if self.rejected && out.reason.is_none() {
                out.reason = Some(Shortfall {
                    part: Part::NoneCloses,
                    amount: f64::NAN,
                });
            }
        }
    }
}
