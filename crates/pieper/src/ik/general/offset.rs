//! Offset wrists: axes 2 and 3 are parallel, axis 5 meets a neighbour. One equation in one angle, without elimination.
//!
//! Let W be the point where axis 5 meets axis 4 or axis 6. With that angle known which moves W past the meeting axes (joint 6
//! or joint 4), W is known as seen from the base and as seen from link 3, and so are axis 5 and its neighbour. What is
//! left is a position problem for the first three joints, with one condition more: the angle between the two meeting axes
//! (`equation`). The equation is a trigonometric polynomial of degree 8, exactly, and free of the degeneracies that the
//! elimination has for such arms; where joint 1 may turn by half a turn in every solution, as for arms without any offset of
//! the shoulder, degree 4 for pairs of solutions. The same arms with wrist and shoulder exchanged are solved backwards.
//!
//! Worked out and measured for this project; the degrees were found by sampling (harmonics above are rounding).

mod back;
mod equation;

use pulp::{Simd, WithSimd};

use super::isolate::{Candidates, Origin, isolate};
use super::lanes::{Lane, Mask, Rigid, Turn, square};
use super::newton::{Angles, Goal, newton};
use super::polynomial::{Sampled, transform};
use super::pool::Pool;
use super::random::Random;
use super::refine::polish;
use super::single::{Doubt, Target};
use super::tables::{SAMPLES, Tables};
use super::tolerances::TOLERANCES;
use crate::ik::normal::Normal;
use crate::spatial::{Pose, sin_cos_exact};
use equation::{Equation, Plane};

/// Which neighbour axis 5 meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Meets {
    /// Axis 4; joint 6 is the unknown.
    Fourth,
    /// Axis 6; joint 4 is the unknown.
    Sixth,
}

/// An arm with an offset wrist, prepared.
#[derive(Clone, Debug)]
pub(super) struct Offset {
    /// Whether the arm is seen from its tool: joints in reverse order, angles negated.
    reversed: bool,
    meets: Meets,
    /// The links behind joints 1 to 5, in the order in which they are seen.
    links: [Rigid; 5],
    plane: Plane,
    /// Where the first three angles are counted from.
    zeros: [(f64, f64); 3],
    /// W along the axis behind (or before) the link at which the two axes meet.
    along: [f64; 2],
    /// Whether a half turn of joint 1 leads from every solution to another.
    symmetric: bool,
}

/// Targets on which the symmetry is tested.
const TRIALS: usize = 8;
const SEED: u64 = 0x6f66_6673;

impl Offset {
    /// Prepares an arm if it has such a wrist, at its tool or at its base.
    pub(super) fn new(links: &[Pose; 5]) -> Option<Self> {
        let reversed = std::array::from_fn(|index| links[4 - index].inverse());
        Self::one_way(links, false).or_else(|| Self::one_way(&reversed, true))
    }

    fn one_way(links: &[Pose; 5], reversed: bool) -> Option<Self> {
        let normal =
            |index: usize| Normal::within(&links[index], super::TOTAL, crate::ik::TOLERANCES.exact);
        let [shoulder, upper, forearm, before, behind] = std::array::from_fn(normal);
        // A fourth axis parallel to the second and third makes every root of the equation a double one.
        let three = upper.is_parallel() && !upper.meets() && !forearm.is_parallel();
        if shoulder.is_parallel() || !three {
            return None;
        }
        let (meets, crossing) = match (before.crosses(), behind.crosses()) {
            (true, _) => (Meets::Fourth, before),
            (_, true) => (Meets::Sixth, behind),
            _ => return None,
        };
        let flip = upper.alpha.1;
        let mut offset = Self {
            reversed,
            meets,
            links: links.each_ref().map(Rigid::of),
            plane: Plane {
                rise: shoulder.d,
                a1: shoulder.a,
                alpha1: shoulder.alpha,
                side: shoulder.e + upper.d,
                a2: upper.a,
                flip,
                cosine: crossing.alpha.1,
            },
            zeros: [shoulder.phi, shoulder.psi + upper.phi, upper.psi].map(sin_cos_exact),
            along: [crossing.d, -crossing.e],
            symmetric: false,
        };
        offset.symmetric = offset.is_symmetric();
        Some(offset)
    }

    /// Whether turning joint 1 by half a turn leads from every solution to another: measured at a few random targets.
    fn is_symmetric(&self) -> bool {
        let mut random = Random::new(SEED);
        (0..TRIALS).all(|_| {
            let mut pose = Pose::identity();
            for _ in 0..2 {
                let axis = nalgebra::Vector3::from_fn(|_, _| random.signed());
                let shift = nalgebra::Vector3::from_fn(|_, _| random.signed());
                pose = pose
                    * crate::spatial::shift(shift)
                    * Pose::from_parts(
                        nalgebra::Translation3::identity(),
                        nalgebra::Rotation3::new(3.0 * axis),
                    );
            }
            let equation = self.equation(&Rigid::of(&pose));
            let angle = 3.0 * random.signed();
            let at = Turn {
                cos: Lane::splat(pulp::Scalar::new(), angle.cos()),
                sin: Lane::splat(pulp::Scalar::new(), angle.sin()),
            };
            equation.at(at).is_even()
        })
    }

    /// The target as this arm sees it.
    fn target(&self, target: &Target) -> Rigid {
        Rigid::of(if self.reversed {
            &target.inverse
        } else {
            &target.pose
        })
    }

    /// The equation of a target.
    #[inline(always)]
    fn equation(&self, target: &Rigid) -> Equation {
        Equation::new(self.meets, &self.links, &self.plane, self.along, target)
    }

    /// Finds roots and adds them to the pool.
    #[inline(always)]
    pub(super) fn run<S: Simd>(
        &self,
        simd: S,
        tables: &Tables,
        goal: &Goal<'_>,
        target: &Target,
        pool: &mut Pool,
    ) -> Doubt {
        let target = self.target(target);
        let equation = self.equation(&target);
        let mut candidates = Candidates::new();
        let sampled = simd.vectorize(Sample {
            offset: self,
            tables,
            equation: &equation,
            candidates: &mut candidates,
        });
        let mut doubt = Doubt {
            near_miss: candidates.unsure,
            drowned: candidates.drowned,
            noise: sampled.noise,
        };
        let before = pool.count;
        let finish = |thorough: bool, pool: &mut Pool| {
            let mut sum = Finished {
                doubtful: false,
                expected: 0,
            };
            for register in 0..candidates.count.div_ceil(S::F64_LANES) {
                let finished = simd.vectorize(Finish {
                    offset: self,
                    tables,
                    goal,
                    target: &target,
                    equation: &equation,
                    sampled: &sampled,
                    candidates: &candidates,
                    register,
                    thorough,
                    pool,
                });
                sum.doubtful |= finished.doubtful;
                sum.expected += finished.expected;
            }
            sum
        };
        let finished = finish(false, pool);
        doubt.drowned |= finished.doubtful;
        // Two roots that lead to the same solution are one root found twice, and another lost.
        doubt.drowned |= pool.count != before + finished.expected;
        if doubt.drowned || doubt.near_miss {
            finish(true, pool);
        }
        doubt
    }
}

struct Sample<'a> {
    offset: &'a Offset,
    tables: &'a Tables,
    equation: &'a Equation,
    candidates: &'a mut Candidates,
}

impl WithSimd for Sample<'_> {
    type Output = Sampled;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Sampled {
        let mut values = [0.0; SAMPLES];
        for register in 0..SAMPLES / S::F64_LANES {
            let angle = Turn {
                cos: Lane::load(simd, &self.tables.sample_cos, register),
                sin: Lane::load(simd, &self.tables.sample_sin, register),
            };
            let value = self.equation.at(angle).value(self.offset.symmetric);
            value.store(&mut values, register);
        }
        let sampled = transform(simd, self.tables, &values);
        let sampled = Sampled {
            noise: sampled.noise.max(NOISE),
            ..sampled
        };
        isolate(
            simd,
            self.tables,
            &sampled.polynomial,
            sampled.noise,
            Origin::Equation,
            self.candidates,
        );
        sampled
    }
}

/// From candidates to solutions, one register of them.
struct Finish<'a, 'b> {
    offset: &'a Offset,
    tables: &'a Tables,
    goal: &'a Goal<'b>,
    target: &'a Rigid,
    equation: &'a Equation,
    sampled: &'a Sampled,
    candidates: &'a Candidates,
    register: usize,
    /// Whether to look for roots beside the simple ones.
    thorough: bool,
    pool: &'a mut Pool,
}

/// The noise at least: rounding of the transform, which may by chance leave no trace in the harmonics above.
const NOISE: f64 = 2.0 * f64::EPSILON;

/// Radians; see [`polish`]: roots this close are still told apart.
const POLISHED: f64 = 1e-8;

/// Newton steps on the equation itself, with the polynomial's slope.
const DIRECT: usize = 1;

/// What became of the candidates of one register.
struct Finished {
    /// Whether solutions may have been missed.
    doubtful: bool,
    /// How many solutions there should be.
    expected: usize,
}

impl WithSimd for Finish<'_, '_> {
    type Output = Finished;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> Finished {
        let polished = polish(
            simd,
            self.tables,
            &self.sampled.polynomial,
            self.candidates,
            self.register,
            POLISHED,
        );
        let zero = Lane::splat(simd, 0.0);
        let simple = zero.less(polished.most);
        let shaky = Lane::splat(simd, self.sampled.noise / TOLERANCES.shaky);
        let mut doubt = simple.and(polished.slope.abs().less(shaky)).any();
        let symmetric = self.offset.symmetric;
        let mut angle = polished.turn;
        let scale = Lane::splat(simd, self.sampled.scale);
        for _ in 0..DIRECT {
            let value = self.equation.at(angle).value(symmetric);
            let step = -(value * scale / polished.slope);
            let usable = step.abs().less(polished.most);
            angle = angle.advanced(usable.pick(step, zero));
        }
        let at = self.equation.at(angle);
        // Where the point is closer to axis 1 than the arm's shoulder is, a root belongs to no real solution.
        let (real, unsure) = at.is_real();
        doubt |= simple.and(unsure).any();
        let x = at.first(symmetric);
        let mut good = self.finish(simd, angle, &at.branch(x, at.turn(x)));
        if symmetric {
            good = good.and(self.finish(simd, angle, &at.branch(-x, at.turn(-x))));
        }
        if self.thorough {
            self.search(simd, angle, &at);
        }
        let due = simple.and(real);
        let used = self.used::<S>();
        Finished {
            doubtful: doubt | due.and_not(good).any(),
            expected: due.count(used) << u32::from(symmetric),
        }
    }
}

impl Finish<'_, '_> {
    /// Around what is no simple root there may be several, of which the linear equations say nothing.
    #[inline(always)]
    fn search<S: Simd>(&mut self, simd: S, angle: Turn<S>, at: &equation::Values<S>) {
        let x = at.distance();
        for x in [x, -x] {
            for turn in at.turns(x) {
                self.finish(simd, angle, &at.branch(x, turn));
            }
        }
    }

    /// Lanes that hold a candidate of their own.
    fn used<S: Simd>(&self) -> usize {
        let left = self.candidates.count - self.register * S::F64_LANES;
        left.min(S::F64_LANES)
    }

    /// From the unknown to solutions; whether there is one close to it.
    #[inline(always)]
    fn finish<S: Simd>(
        &mut self,
        simd: S,
        angle: Turn<S>,
        branch: &equation::Branch<S>,
    ) -> Mask<S> {
        let seen = back::complete(simd, self.offset, self.target, self.equation, angle, branch);
        let mut q: Angles<S> = seen;
        if self.offset.reversed {
            for joint in 0..6 {
                q[5 - joint] = seen[joint].reversed();
            }
        }
        let errors = newton(simd, self.goal, &mut q);
        let used = self.used::<S>();
        self.pool.add(&q, errors, used, TOLERANCES.closes);
        let kept = q[self.offset.unknown()];
        let kept = if self.offset.reversed {
            kept.reversed()
        } else {
            kept
        };
        let moved = square(&[kept.cos - angle.cos, kept.sin - angle.sin]);
        let most = moved.constant(TOLERANCES.moved * TOLERANCES.moved);
        let closes = errors.less(moved.constant(TOLERANCES.closes));
        closes.and(moved.less(most))
    }
}

impl Offset {
    /// The joint whose angle is the unknown, from 0, as the caller counts.
    fn unknown(&self) -> usize {
        match (self.meets, self.reversed) {
            (Meets::Fourth, false) => 5,
            (Meets::Fourth, true) => 0,
            (Meets::Sixth, false) => 3,
            (Meets::Sixth, true) => 2,
        }
    }
}
