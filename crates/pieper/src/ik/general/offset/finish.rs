//! From roots of the equation to solutions.

use pulp::{Simd, WithSimd};

use super::equation::{Branch, Equation};
use super::zoom::{ROOTS, Sighting, Windows};
use super::{Meets, Offset, back};
use crate::ik::general::isolate::{CANDIDATES, Candidates};
use crate::ik::general::newton::{Angles, Goal, newton};
use crate::ik::general::polynomial::Sampled;
use crate::ik::general::pool::{Point, Pool};
use crate::ik::general::refine::polish;
use crate::ik::general::tables::Tables;
use crate::ik::general::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Mask, Rigid, Turn, square};

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

    /// From the unknown and a branch to solutions, of the first so many lanes; whether there is one close to it, to rounding, and the
    /// bits of all in the pool.
    #[inline(always)]
    pub(super) fn solve<S: Simd>(
        &self,
        simd: S,
        angle: Turn<S>,
        branch: &Branch<S>,
        used: usize,
        pool: &mut Pool,
    ) -> (Mask<S>, [u64; 8]) {
        let mut q = self.joints(simd, angle, branch);
        let errors = newton(simd, self.goal, &mut q);
        let bits = pool.add(&q, errors, used, TOLERANCES.closes);
        let kept = q[self.offset.unknown()];
        let kept = if self.offset.reversed {
            kept.reversed()
        } else {
            kept
        };
        let moved = square(&[kept.cos - angle.cos, kept.sin - angle.sin]);
        let most = moved.constant(TOLERANCES.moved * TOLERANCES.moved);
        let closes = errors.less(moved.constant(TOLERANCES.closes_well));
        (closes.and(moved.less(most)), bits)
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

    /// Its value, as the equation counts it.
    pub(super) fn kept(&self, point: &Point) -> f64 {
        let (sin, cos) = (point[6 + self.unknown()], point[self.unknown()]);
        let sign = if self.reversed { -1.0 } else { 1.0 };
        (sign * sin).atan2(cos)
    }
}

/// Roots of the equation that were followed to solutions.
pub(super) struct Followed {
    pub(super) count: usize,
    pub(super) angles: [f64; FOLLOWED],
    /// How many solutions each should lead to, and the bits of those to which it did.
    solutions: [u8; FOLLOWED],
    bits: [u64; FOLLOWED],
    /// The number of solutions of some could not be told.
    pub(super) unsure: bool,
}

/// Most roots: those of the polynomial, and those at close range.
const FOLLOWED: usize = CANDIDATES + ROOTS;

impl Followed {
    pub(super) fn new() -> Self {
        Self {
            count: 0,
            angles: [0.0; FOLLOWED],
            solutions: [0; FOLLOWED],
            bits: [0; FOLLOWED],
            unsure: false,
        }
    }

    /// The bits of all their solutions.
    pub(super) fn bits(&self) -> u64 {
        let bits = self.bits[..self.count].iter();
        bits.fold(0, |all, bits| all | bits)
    }

    /// The number of the roots that are to be counted, and the bits of their solutions; `None` for these if there should be more.
    pub(super) fn count(&self, is_counted: impl Fn(usize, f64) -> bool) -> (usize, Option<u64>) {
        let (mut roots, mut expected, mut bits) = (0, 0, 0_u64);
        for k in 0..self.count {
            if is_counted(k, self.angles[k]) {
                roots += 1;
                expected += u32::from(self.solutions[k]);
                bits |= self.bits[k];
            }
        }
        (roots, (bits.count_ones() == expected).then_some(bits))
    }
}

/// Roots in lanes.
pub(super) struct Simple<S: Simd> {
    /// Radians; as cosine and sine besides.
    pub(super) angle: Lane<S>,
    pub(super) turn: Turn<S>,
    /// Of the equation, per radian.
    pub(super) slope: Lane<S>,
    /// Radians: the longest step that the equation itself may add.
    pub(super) most: Lane<S>,
    /// How many lanes are in use.
    pub(super) used: usize,
}

impl Finish<'_> {
    /// Follows simple roots; those that lead to no solution although they should.
    #[inline(always)]
    pub(super) fn follow<S: Simd>(
        &self,
        simd: S,
        roots: &Simple<S>,
        pool: &mut Pool,
        followed: &mut Followed,
    ) -> Mask<S> {
        let zero = Lane::splat(simd, 0.0);
        let symmetric = self.offset.symmetric;
        // A step on the equation itself.
        let value = self.equation.at(roots.turn).value(symmetric);
        let step = -(value / roots.slope);
        let usable = step.abs().less(roots.most);
        let angle = roots.turn.advanced(usable.pick(step, zero));
        let at = self.equation.at(angle);
        // Where the point is closer to axis 1 than the arm's shoulder is, a root belongs to no real solution.
        let (real, unsure) = at.is_real();
        let x = at.first(symmetric);
        let branch = at.branch(x, at.turn(x));
        let (mut good, mut bits) = self.solve(simd, angle, &branch, roots.used, pool);
        if symmetric {
            let branch = at.branch(-x, at.turn(-x));
            let (other, mirrored) = self.solve(simd, angle, &branch, roots.used, pool);
            good = good.and(other);
            bits = std::array::from_fn(|lane| bits[lane] | mirrored[lane]);
        }
        let (mut angles, mut solutions) = ([0.0; 8], [0.0; 8]);
        // Where they were seen: a step from a flat root may lead anywhere.
        roots.angle.store(&mut angles, 0);
        let each = Lane::splat(simd, if symmetric { 2.0 } else { 1.0 });
        real.pick(each, zero).store(&mut solutions, 0);
        for lane in 0..roots.used.min(FOLLOWED - followed.count) {
            followed.angles[followed.count] = angles[lane];
            followed.solutions[followed.count] = solutions[lane] as u8;
            followed.bits[followed.count] = bits[lane];
            followed.count += 1;
        }
        followed.unsure |= unsure.any();
        real.and_not(good)
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
    pub(super) followed: &'a mut Followed,
    /// Gets what is around roots that may not be all there is.
    pub(super) windows: &'a mut Windows,
}

/// Radians to both sides of a root that was not cleared up: at least, and at most.
const AROUND: f64 = 1e-2;
const FARTHEST: f64 = 0.05;

impl WithSimd for Polish<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let (candidates, register) = (self.candidates, self.register);
        let polished = polish(
            simd,
            self.tables,
            &self.sampled.polynomial,
            candidates,
            register,
        );
        let shaky = Lane::splat(simd, self.sampled.noise / TOLERANCES.shaky_equation);
        let flat = polished.slope.abs().less(shaky);
        let roots = Simple {
            angle: polished.angle,
            turn: polished.turn,
            slope: polished.slope * Lane::splat(simd, 1.0 / self.sampled.scale),
            most: polished.most,
            used: (candidates.count - register * S::F64_LANES).min(S::F64_LANES),
        };
        let first = self.followed.count;
        let lost = self.finish.follow(simd, &roots, self.pool, self.followed);
        let doubtful = flat.or(lost);
        if doubtful.any() {
            // As far as noise may have moved it.
            let reach = (roots
                .slope
                .constant(TOLERANCES.drowned * self.sampled.noise)
                / polished.slope.abs())
            .max(roots.slope.constant(AROUND))
            .min(roots.slope.constant(FARTHEST));
            let mut reaches = [0.0; 8];
            let zero = Lane::splat(simd, 0.0);
            doubtful.pick(reach, zero).store(&mut reaches, 0);
            for k in first..self.followed.count {
                if reaches[k - first] > 0.0 {
                    let angle = self.followed.angles[k];
                    self.windows.add_around(angle, reaches[k - first]);
                }
            }
        }
    }
}

/// From roots at close range to solutions, one register of them.
pub(super) struct Close<'a> {
    pub(super) finish: &'a Finish<'a>,
    pub(super) roots: &'a [Sighting],
    pub(super) register: usize,
    pub(super) pool: &'a mut Pool,
    pub(super) followed: &'a mut Followed,
}

impl WithSimd for Close<'_> {
    /// Whether all of them led to solutions.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let (mut angle, mut cos, mut sin) = ([0.0; 8], [1.0; 8], [0.0; 8]);
        let (mut slope, mut room) = ([1.0; 8], [0.0; 8]);
        let first = self.register * S::F64_LANES;
        let used = (self.roots.len() - first).min(S::F64_LANES);
        for lane in 0..S::F64_LANES {
            // The last one in all lanes that are left.
            let root = &self.roots[first + lane.min(used - 1)];
            angle[lane] = root.angle;
            (sin[lane], cos[lane]) = root.angle.sin_cos();
            (slope[lane], room[lane]) = (root.slope, root.room);
        }
        let roots = Simple {
            angle: Lane::load(simd, &angle, 0),
            turn: Turn {
                cos: Lane::load(simd, &cos, 0),
                sin: Lane::load(simd, &sin, 0),
            },
            slope: Lane::load(simd, &slope, 0),
            most: Lane::load(simd, &room, 0),
            used,
        };
        let lost = self.finish.follow(simd, &roots, self.pool, self.followed);
        !lost.any()
    }
}
