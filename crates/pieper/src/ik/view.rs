//! Between the caller's joint vector and that of the arm at work, which lacks joints that are held and has others that make
//! up for what a goal leaves open.

use super::arm::{Arm, MAX_JOINTS};
use super::curve;
use super::descent::largest;
use super::extend::{held, open_to};
use super::goal::{Goal, Question};
use super::limits;
use super::solutions::{Family, JointVector, Nearest, Solution, Solutions, Status};
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial::Pose;

/// What the caller sees.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub(super) chain: Chain,
    bounds: [JointVector; 2],
    pub(super) goal: Goal,
    /// Of each of the caller's joints: where it is held.
    held: Vec<Option<f64>>,
}

/// Two solutions that differ only in joints which the caller does not have are one if closer than this.
const SAME: f64 = 1e-7;

/// A family moves the caller's joints if its direction has at least this part in them.
const MOVES: f64 = 1e-7;

impl View {
    /// The view, the chain without held joints, and the chain to work on.
    pub(super) fn new(chain: &Chain, question: &Question) -> Result<(Self, Chain, Chain)> {
        let mut held_at = vec![None; chain.dof()];
        for &(joint, value) in &question.held {
            let subject = || format!("held joint {}", joint + 1);
            let Some(place) = held_at.get_mut(joint) else {
                let text = format!("the chain has {} joints", chain.dof());
                return Err(Error::input(subject(), text));
            };
            if !value.is_finite() {
                let text = format!("{value}: a finite number was expected");
                return Err(Error::input(subject(), text));
            }
            if place.replace(value).is_some() {
                return Err(Error::input(subject(), "it is held twice"));
            }
        }
        if question.goal == Goal::Axis {
            // What slides does not turn the axis: it stands as close to zero as it may.
            for (place, variable) in held_at.iter_mut().zip(chain.variables()) {
                let rest = variable
                    .limits
                    .map_or(0.0, |limits| 0.0_f64.clamp(limits.lower(), limits.upper()));
                if !variable.kind.is_angular() {
                    place.get_or_insert(rest);
                }
            }
        }
        if held_at.iter().all(Option::is_some) {
            let text = match question.goal {
                Goal::Axis => "no joint is left that turns: its axis keeps its direction",
                _ => "every joint is held: none is left to move",
            };
            return Err(Error::model("chain", text));
        }
        let mut free = chain.clone();
        for (joint, value) in held_at.iter().enumerate().rev() {
            if let Some(value) = value {
                free = held(&free, joint, *value)?;
            }
        }
        let work = open_to(&free, question.goal)?;
        let view = Self {
            bounds: limits::bounds(chain),
            chain: chain.clone(),
            goal: question.goal,
            held: held_at,
        };
        Ok((view, free, work))
    }

    /// The joints of the caller that are free; they come first in the vector of the arm at work.
    pub(super) fn free_joints(&self) -> usize {
        self.held.iter().filter(|held| held.is_none()).count()
    }

    fn is_plain(&self) -> bool {
        self.goal == Goal::Pose && self.held.iter().all(Option::is_none)
    }

    /// The caller's joint vector.
    pub(super) fn outward(&self, q: &JointVector) -> JointVector {
        let (mut out, mut next) = ([0.0; MAX_JOINTS], 0);
        for (value, held) in out.iter_mut().zip(&self.held) {
            *value = held.unwrap_or_else(|| {
                next += 1;
                q[next - 1]
            });
        }
        out
    }

    /// The vector of the arm at work, joints that the caller does not have at zero.
    pub(super) fn inward(&self, q: &[f64]) -> JointVector {
        let mut out = [0.0; MAX_JOINTS];
        let free = q.iter().zip(&self.held).filter(|(_, held)| held.is_none());
        for (value, (given, _)) in out.iter_mut().zip(free) {
            *value = *given;
        }
        out
    }

    /// Joint values of the arm at work as the caller sees them, with what they miss of the goal.
    pub(super) fn nearest(&self, q: &JointVector, pose: &Pose) -> Nearest {
        let q = self.outward(q);
        let reached = self.pose(&q);
        let (position_error, orientation_error) = self.goal.miss(&reached, pose);
        Nearest {
            q,
            dof: self.chain.dof() as u8,
            position_error,
            orientation_error,
        }
    }

    fn pose(&self, q: &JointVector) -> Pose {
        crate::kinematics::tool_pose(&self.chain, &q[..self.chain.dof()])
            .unwrap_or_else(|_| crate::spatial::shift(nalgebra::Vector3::repeat(f64::NAN)))
    }

    /// Turns an answer of the arm at work into the caller's.
    pub(super) fn present(&self, arm: &Arm, pose: &Pose, out: &mut Solutions) {
        if self.is_plain() {
            return;
        }
        let (list, len) = (out.list, std::mem::take(&mut out.len));
        let (families, count) = (out.families, std::mem::take(&mut out.family_count));
        for solution in &list[..len] {
            self.add(solution, pose, out);
        }
        for family in &families[..count] {
            let free = self.direction(arm, &family.heading);
            if largest(&free) < MOVES {
                // Only joints that the caller does not have move along it.
                let solution = Solution {
                    q: family.at,
                    branch: family.branch,
                    multiplicity: 1,
                    ..Solution::EMPTY
                };
                self.add(&solution, pose, out);
                continue;
            }
            // What differs only in joints which the caller does not have is one.
            let known = out.families[..out.family_count].iter().any(|known| {
                let line = (&known.at, &known.heading);
                !curve::is_surface(arm, &known.at)
                    && curve::passes(
                        arm,
                        line,
                        &arm.pose(&known.at),
                        &family.at,
                        self.free_joints(),
                    )
            });
            if known {
                continue;
            }
            out.families[out.family_count] = self.family(arm, family, pose);
            out.family_count += 1;
        }
        out.status = match (out.family_count, out.len) {
            (0, 0) => Status::Unreachable,
            (0, _) => Status::Solved,
            _ if self.goal != Goal::Pose => Status::Redundant,
            _ => out.status,
        };
    }

    /// A family of the arm at work, as the caller sees it.
    pub(super) fn family(&self, arm: &Arm, family: &Family, pose: &Pose) -> Family {
        let free = self.direction(arm, &family.heading);
        let length = free.iter().map(|x| x * x).sum::<f64>().sqrt();
        let member = self.outward(&family.at);
        Family {
            member,
            free: free.map(|x| x / length),
            dof: self.chain.dof() as u8,
            residual: self.goal.residual(&self.pose(&member), pose),
            ..*family
        }
    }

    fn add(&self, solution: &Solution, pose: &Pose, out: &mut Solutions) {
        let q = self.outward(&solution.q);
        let known = out.list[..out.len].iter().any(|known| {
            let gap = |(j, (a, b)): (usize, (&f64, &f64))| {
                let step = a - b;
                match super::angle::is_periodic(&self.chain, j) {
                    true => super::angle::wrap(step).abs(),
                    false => step.abs(),
                }
            };
            let pairs = known.q[..self.chain.dof()].iter().zip(&q).enumerate();
            pairs.map(gap).fold(0.0, f64::max) < SAME
        });
        if known || out.len == out.list.len() {
            return;
        }
        out.list[out.len] = Solution {
            q,
            dof: self.chain.dof() as u8,
            residual: self.goal.residual(&self.pose(&q), pose),
            within_limits: limits::within(&self.bounds, &q),
            ..*solution
        };
        out.len += 1;
    }

    /// A direction of the arm at work in the caller's joints, radians and metres.
    fn direction(&self, arm: &Arm, heading: &JointVector) -> JointVector {
        let mut inner = [0.0; MAX_JOINTS];
        for (j, value) in inner.iter_mut().enumerate().take(self.free_joints()) {
            *value = heading[j] * arm.unit(j);
        }
        let mut out = self.outward(&inner);
        for (value, held) in out.iter_mut().zip(&self.held) {
            if held.is_some() {
                *value = 0.0;
            }
        }
        out
    }

    /// The difference of two vectors of the arm at work, joints that the caller does not have left out.
    pub(super) fn difference(&self, arm: &Arm, a: &JointVector, b: &JointVector) -> JointVector {
        let mut step = curve::difference(arm, a, b);
        step[self.free_joints()..].fill(0.0);
        step
    }
}
