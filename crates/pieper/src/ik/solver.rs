//! The solver of one arm.

use super::arm::{Arm, MAX_JOINTS};
use super::classify::{self, Structure};
use super::curve;
use super::nearest;
use super::reason::{Part, Shortfall};
use super::registry::{self, Choice};
use super::sink::{Marks, Sink};
use super::solutions::{Branch, Family, JointVector, Nearest, Solutions, Status};
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial::Pose;

/// Inverse kinematics of one chain, prepared once: a few microseconds to classify it.
#[derive(Clone, Debug)]
pub struct Solver {
    arm: Arm,
    structure: Structure,
    choice: Choice,
}

impl Solver {
    /// Prepares a chain.
    ///
    /// # Errors
    /// A model error for a chain of more than [`MAX_JOINTS`] joints.
    pub fn new(chain: &Chain) -> Result<Self> {
        let arm = Arm::new(chain)?;
        let structure = classify::of(&arm);
        let choice = registry::choose(&arm, &structure)
            .ok_or_else(|| Error::model("chain", "no solver takes it"))?;
        Ok(Self {
            arm,
            structure,
            choice,
        })
    }

    /// The chain.
    pub fn chain(&self) -> &Chain {
        self.arm.chain()
    }

    /// How the axes lie.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// The solver at work.
    pub fn choice(&self) -> &Choice {
        &self.choice
    }

    /// Every solution for a pose of the tool, `base_from_tool` as [`tool_pose`](crate::kinematics::tool_pose) gives
    /// it.
    ///
    /// # Errors
    /// An input error if the pose has an entry that is not finite or if its rotation part is none.
    pub fn solve(&self, pose: &Pose) -> Result<Solutions> {
        let mut out = Solutions::default();
        self.solve_into(pose, &mut out)?;
        Ok(out)
    }

    /// [`Solver::solve`] into an answer used again: nothing is allocated.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn solve_into(&self, pose: &Pose, out: &mut Solutions) -> Result<()> {
        check(pose)?;
        let target = self.arm.target(pose);
        let mut sink = Sink::new(&self.arm, pose, self.choice.slack, out);
        self.choice.solver.solve(&target, &mut sink);
        sink.finish();
        if out.status == Status::Unreachable
            && out.reason.is_none_or(|reason| reason.is_unmeasured())
        {
            self.measure(pose, out);
        }
        Ok(())
    }

    /// Measures a failure for which the row had no number, by search. Should the search reach the pose after all, it
    /// is a solution.
    #[cold]
    fn measure(&self, pose: &Pose, out: &mut Solutions) {
        let part = out.reason.map_or(Part::NoneCloses, |reason| reason.part);
        let nearest = nearest::find(&self.arm, pose);
        let mut sink = Sink::new(&self.arm, pose, self.choice.slack, out);
        sink.push_joints(nearest.q, Branch::default(), Marks::PLAIN);
        sink.finish();
        if out.status == Status::Unreachable {
            let amount = match part.is_angular() {
                true => nearest.orientation_error,
                false => nearest.position_error,
            };
            out.reason = Some(Shortfall { part, amount });
            out.nearest = Some(nearest);
        }
    }

    /// The closest the arm comes to a pose that it cannot reach: a local search from many starts.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn nearest(&self, pose: &Pose) -> Result<Nearest> {
        check(pose)?;
        Ok(nearest::find(&self.arm, pose))
    }

    /// `count` members of a family, spread evenly along it, the listed member first.
    pub fn samples(&self, family: &Family, count: usize) -> Vec<Vec<f64>> {
        let pose = self.arm.pose(&family.member);
        let mut points: Vec<JointVector> = Vec::new();
        curve::follow(&self.arm, &family.member, &family.heading, &pose, |q, _| {
            points.push(*q);
            true
        });
        let (dof, last) = (self.arm.chain().dof(), points.len().saturating_sub(1));
        let pick = |k: usize| {
            let mut q = points[k * last / count.max(2).saturating_sub(1)];
            self.arm.wrap(&mut q);
            q[..dof].to_vec()
        };
        (0..count).map(pick).collect()
    }

    /// The member of a family that is closest to the joint values `seed`.
    ///
    /// # Errors
    /// An input error unless `seed` has one finite value for each variable.
    pub fn nearest_member(&self, family: &Family, seed: &[f64]) -> Result<Vec<f64>> {
        let chain = self.arm.chain();
        chain.check_joint_values(seed)?;
        let mut wanted = [0.0; MAX_JOINTS];
        wanted[..seed.len()].copy_from_slice(seed);
        let pose = self.arm.pose(&family.member);
        let distance = |q: &JointVector| -> f64 {
            curve::difference(&self.arm, q, &wanted)
                .iter()
                .map(|x| x * x)
                .sum()
        };
        let (mut best, mut least) = (family.member, f64::INFINITY);
        curve::follow(&self.arm, &family.member, &family.heading, &pose, |q, _| {
            if distance(q) < least {
                (best, least) = (*q, distance(q));
            }
            true
        });
        let mut q = curve::closest(&self.arm, &best, &pose, &wanted);
        self.arm.wrap(&mut q);
        Ok(q[..chain.dof()].to_vec())
    }
}

/// How far from orthonormal a pose may be: what callers pass was projected or computed.
const ORTHONORMAL: f64 = 1e-6;

pub(super) fn check(pose: &Pose) -> Result<()> {
    let (m, t) = (pose.rotation.matrix(), &pose.translation.vector);
    // A NaN makes the sum a NaN, and every comparison with it false.
    let sum: f64 = m.iter().chain(t.iter()).map(|x| x.abs()).sum();
    if !sum.is_finite() {
        return Err(Error::input(
            "pose",
            "it has an entry that is not a finite number",
        ));
    }
    let column = |j: usize| m.column(j);
    let off = [
        column(0).norm_squared() - 1.0,
        column(1).norm_squared() - 1.0,
        column(0).dot(&column(1)),
        (column(0).cross(&column(1)) - column(2)).amax(),
    ];
    let off = off.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if off > ORTHONORMAL {
        let text = format!("it is no rotation: off by {off:.3e}, at most 1e-6 was expected");
        return Err(Error::input("rotation part of the pose", text));
    }
    Ok(())
}
