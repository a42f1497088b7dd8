//! All solutions at one moment: points that stand alone, and sets in which the arm can turn without moving its tool.

use std::f64::consts::TAU;

use super::space::{Space, add, dot, minus};
use crate::error::Result;
use crate::ik::{Branch, Family, JointVector, MAX_JOINTS, Shortfall, Solutions, Solver, Status};
use crate::motion::PoseLaw;
use crate::spatial::Pose;

/// Below this smallest singular value a solution's values are not told apart from its neighbours' along the idle
/// direction: rounding of 1e-16 in the pose moves them by 1e-8.
const SINGULAR: f64 = 1e-8;

/// Two descriptions of a set are of the same one if a member of one is a member of the other within this.
const SAME: f64 = 1e-6;

/// A straight line of members is one if the tool stays within this (m and rad) of its pose.
const STRAIGHT: f64 = 1e-11;

/// A solution at a moment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) q: JointVector,
    pub(super) branch: Branch,
    /// For a set: what it is.
    pub(super) set: Option<Set>,
}

/// Solutions that hang together: a family, roots that merge, or a solution so near a singularity that one joint motion
/// hardly moves the tool.
#[derive(Clone, Copy, Debug)]
pub(super) struct Set {
    /// The unit direction in which it goes on; zero for a single point.
    pub(super) free: JointVector,
    pub(super) family: Option<Family>,
}

/// All that is known about a moment.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) time: f64,
    pub(super) pose: Pose,
    pub(super) nodes: Vec<Node>,
    pub(super) shortfall: Option<Shortfall>,
}

impl Sample {
    pub(super) fn has_sets(&self) -> bool {
        self.nodes.iter().any(|node| node.set.is_some())
    }
}

/// Finds samples of one path.
pub(super) struct Sampler<'a> {
    pub(super) space: &'a Space<'a>,
    pub(super) law: &'a PoseLaw,
    pub(super) solver: &'a Solver,
    found: Solutions,
    /// How many poses were solved.
    pub(super) solves: usize,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(space: &'a Space<'a>, law: &'a PoseLaw, solver: &'a Solver) -> Self {
        Self {
            space,
            law,
            solver,
            found: Solutions::default(),
            solves: 0,
        }
    }

    /// All solutions at a time.
    pub(super) fn at(&mut self, time: f64) -> Result<Sample> {
        let pose = self.law.at(time);
        self.solves += 1;
        self.solver.solve_into(&pose, &mut self.found)?;
        let mut sample = Sample {
            time,
            pose,
            nodes: Vec::with_capacity(self.found.len()),
            shortfall: None,
        };
        if self.found.status() == Status::Unreachable {
            sample.shortfall = self.found.reason();
            return Ok(sample);
        }
        for family in self.found.families() {
            let q = self.space.vector(family.q());
            let free = match self.space.twins(&q)? {
                Some(free) => free,
                None => self.space.vector(family.free()),
            };
            let set = Set {
                free,
                family: Some(*family),
            };
            self.list(&mut sample, q, family.branch, Some(set))?;
        }
        for solution in &self.found {
            let q = self.space.vector(solution.q());
            let set = self.set(&q, solution.multiplicity)?;
            self.list(&mut sample, q, solution.branch, set)?;
        }
        Ok(sample)
    }

    /// The set that an isolated solution stands for, if it is singular or several roots merge in it.
    fn set(&self, q: &JointVector, multiplicity: u8) -> Result<Option<Set>> {
        let idle = self.space.idle(q)?;
        let idle = idle.filter(|(least, _)| *least < SINGULAR);
        if multiplicity < 2 && idle.is_none() {
            return Ok(None);
        }
        // Where the arm is singular in two ways at once, the idle direction is a mixture; axes in one line are not.
        let free = match (self.space.twins(q)?, idle) {
            (Some(free), _) => free,
            (None, Some((_, free))) if multiplicity < 2 => free,
            _ => [0.0; MAX_JOINTS],
        };
        Ok(Some(Set { free, family: None }))
    }

    /// Lists a solution, unless it is a set that is listed already.
    fn list(
        &self,
        sample: &mut Sample,
        q: JointVector,
        branch: Branch,
        set: Option<Set>,
    ) -> Result<()> {
        let node = Node { q, branch, set };
        if set.is_none() || !self.is_listed(sample, &node)? {
            sample.nodes.push(node);
        }
        Ok(())
    }

    /// Whether the node's set is one that the sample lists already.
    fn is_listed(&self, sample: &Sample, node: &Node) -> Result<bool> {
        for listed in &sample.nodes {
            if let Some(member) = self.member(sample, listed, &node.q)?
                && self.space.size(&self.space.way(&member, &node.q)) < SAME
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The member of a set that is nearest to `seed`, its angles beside the seed's; `None` if the node is no set.
    pub(super) fn member(
        &self,
        sample: &Sample,
        node: &Node,
        seed: &JointVector,
    ) -> Result<Option<JointVector>> {
        let Some(set) = &node.set else {
            return Ok(None);
        };
        let near = self.space.beside(seed, &node.q);
        let line = self.nearest_on_line(&near, &set.free, seed);
        let miss = self.space.miss(&line, &sample.pose)?;
        if miss.within(STRAIGHT) {
            return Ok(Some(line));
        }
        let Some(family) = &set.family else {
            return Ok(Some(near));
        };
        let wrapped = self.space.beside(&node.q, seed);
        let member = self
            .solver
            .nearest_member(family, &wrapped[..self.space.dof()])?;
        Ok(Some(self.space.beside(seed, &self.space.vector(&member))))
    }

    /// The point nearest to `seed` on the line through `point` along `free`, and on the lines a whole turn of one
    /// joint away.
    fn nearest_on_line(
        &self,
        point: &JointVector,
        free: &JointVector,
        seed: &JointVector,
    ) -> JointVector {
        let project = |from: &JointVector| add(from, free, dot(free, &minus(seed, from)));
        let mut best = project(point);
        let mut least = dot(&minus(seed, &best), &minus(seed, &best));
        for (j, &angular) in self.space.angular.iter().enumerate() {
            for turn in [-TAU, TAU] {
                if !angular || free[j].abs() < SAME {
                    continue;
                }
                let mut shifted = *point;
                shifted[j] += turn;
                let found = project(&shifted);
                let distance = dot(&minus(seed, &found), &minus(seed, &found));
                // Clearly nearer: of equals, the one without a turn.
                if distance < 0.99 * least {
                    (best, least) = (found, distance);
                }
            }
        }
        best
    }
}
