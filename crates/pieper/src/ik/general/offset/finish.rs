//! From roots of the equation to solutions.

use pulp::{Simd, WithSimd};

use super::equation::{Branch, Equation};
use super::magnify::Spots;
use super::{Meets, Offset, back};
use crate::ik::general::isolate::Candidates;
use crate::ik::general::lanes::{Lane, Mask, Rigid, Turn, square};
use crate::ik::general::newton::{Angles, Goal, newton};
use crate::ik::general::polynomial::Sampled;
use crate::ik::general::pool::Pool;
use crate::ik::general::refine::polish;
use crate::ik::general::tables::Tables;
use crate::ik::general::tolerances::TOLERANCES;

/// What leads from the unknown to solutions of one target.
pub(super) struct Finish<'a> {
    pub(super) offset: &'a Offset,
    pub(super) goal: &'a Goal<'a>,
    pub(super) target: &'a Rigid,
    pub(super) equation: &'a Equation,
}

impl Finish<'_> {
    /// From the unknown and a branch to the arm's joints.
    #[inline(always)]
    pub(super) fn joints<S: Simd>(&self, simd: S, angle: Turn<S>, branch: &Branch<S>) -> Angles<S> {
        let seen = back::complete(simd, self.offset, self.target, self.equation, angle, branch);
        let mut q = seen;
        if self.offset.reversed {
            for joint in 0..6 {
                q[5 - joint] = seen[joint].reversed();
            }
        }
        q
    }

    /// From the unknown and a branch to solutions, of the first so many lanes; whether there is one close to it, to rounding.
    #[inline(always)]
    pub(super) fn solve<S: Simd>(
        &self,
        simd: S,
        angle: Turn<S>,
        branch: &Branch<S>,
        used: usize,
        pool: &mut Pool,
    ) -> Mask<S> {
        let mut q = self.joints(simd, angle, branch);
        let errors = newton(simd, self.goal, &mut q);
        pool.add(&q, errors, used, TOLERANCES.closes);
        let kept = q[self.offset.unknown()];
        let kept = if self.offset.reversed {
            kept.reversed()
        } else {
            kept
        };
        let moved = square(&[kept.cos - angle.cos, kept.sin - angle.sin]);
        let most = moved.constant(TOLERANCES.moved * TOLERANCES.moved);
        let closes = errors.less(moved.constant(TOLERANCES.closes_well));
        closes.and(moved.less(most))
    }
}

impl Offset {
    /// The joint whose angle is the unknown, from 0, as the caller counts.
    pub(super) fn unknown(&self) -> usize {
        match (self.meets, self.reversed) {
            (Meets::Fourth, false) => 5,
            (Meets::Fourth, true) => 0,
            (Meets::Sixth, false) => 3,
            (Meets::Sixth, true) => 2,
        }
    }
}

/// From the polynomial's candidates to solutions, one register of them.
pub(super) struct Polish<'a> {
    pub(super) finish: &'a Finish<'a>,
    pub(super) tables: &'a Tables,
    pub(super) sampled: &'a Sampled,
    pub(super) candidates: &'a Candidates,
    pub(super) register: usize,
    pub(super) pool: &'a mut Pool,
    /// Where the roots are, should a closer look be needed.
    pub(super) spots: &'a mut Spots,
}

/// What became of the candidates of one register.
pub(super) struct Finished {
    /// Whether solutions may have been missed.
    pub(super) doubtful: bool,
    /// How many solutions there should be.
    pub(super) expected: usize,
}

impl WithSimd for Polish<'_> {
    type Output = Finished;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Finished {
        let Self {
            finish,
            candidates,
            register,
            pool,
            spots,
            ..
        } = self;
        let polished = polish(
            simd,
            self.tables,
            &self.sampled.polynomial,
            candidates,
            register,
        );
        let zero = Lane::splat(simd, 0.0);
        let symmetric = finish.offset.symmetric;
        let shaky = Lane::splat(simd, self.sampled.noise / TOLERANCES.shaky_equation);
        let flat = polished.slope.abs().less(shaky);
        // A step on the equation itself, with the polynomial's slope.
        let value = finish.equation.at(polished.turn).value(symmetric);
        let step = -(value * Lane::splat(simd, self.sampled.scale) / polished.slope);
        let usable = step.abs().less(polished.most);
        let angle = polished.turn.advanced(usable.pick(step, zero));
        let at = finish.equation.at(angle);
        // Where the point is closer to axis 1 than the arm's shoulder is, a root belongs to no real solution.
        let (real, unsure) = at.is_real();
        let used = (candidates.count - register * S::F64_LANES).min(S::F64_LANES);
        let x = at.first(symmetric);
        let mut good = finish.solve(simd, angle, &at.branch(x, at.turn(x)), used, pool);
        if symmetric {
            let branch = at.branch(-x, at.turn(-x));
            good = good.and(finish.solve(simd, angle, &branch, used, pool));
        }
        spots.add(angle, flat.or(real.and_not(good)), used);
        Finished {
            doubtful: flat.or(unsure).any() | real.and_not(good).any(),
            expected: real.count(used) << u32::from(symmetric),
        }
    }
}
