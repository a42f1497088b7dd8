//! One elimination from end to end: from a target to the roots that it finds.

use pulp::{Simd, WithSimd};

use super::back::{self, Links};
use super::cycle::Case;
use super::elimination::{Harmonics, Linear};
use super::isolate::{Candidates, isolate};
use super::lanes::{Lane, Rigid};
use super::newton::{Angles, Goal, newton};
use super::polynomial::{Sampled, sample};
use super::pool::Pool;
use super::refine::polish;
use super::resultant::{self, Form};
use super::tables::{Tables, Trigonometric};
use super::tolerances::TOLERANCES;
use crate::spatial::Pose;

/// One elimination, prepared.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    pub(super) case: Case,
    /// The perturbation of its linear part.
    pub(super) delta: f64,
    pub(super) form: Form,
    pub(super) linear: Linear,
    /// The true links behind a to e and the inverse of the one behind f; the target's is filled in per target.
    pub(super) links: Links,
}

/// The scaled target and its inverse, as links of the loop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    pub(super) pose: Pose,
    pub(super) inverse: Pose,
}

impl Target {
    pub(super) fn new(pose: Pose) -> Self {
        let inverse = pose.inverse();
        Self { pose, inverse }
    }
}

impl Elimination {
    /// Takes the resultant in another form.
    pub(super) fn set_form(&mut self, form: Form) {
        self.form = form;
        self.linear.swap(form.swapped);
    }

    #[inline(always)]
    fn link<'a>(&self, target: &'a Target) -> &'a Pose {
        if self.case.inverted {
            &target.pose
        } else {
            &target.inverse
        }
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
    ) {
        let matrix = simd.vectorize(Build {
            elimination: self,
            target,
        });
        let sampled = simd.vectorize(Sample {
            tables,
            matrix: &matrix,
            form: self.form,
        });
        let mut candidates = Candidates::new();
        simd.vectorize(Isolate {
            tables,
            polynomial: &sampled.polynomial,
            out: &mut candidates,
        });
        pool.unsure |= candidates.unsure;
        let mut links = self.links;
        links[self.case.place()] = Rigid::of(self.link(target));
        let blocks = simd.vectorize(Blocks {
            matrix: &matrix,
            form: self.form,
        });
        for register in 0..candidates.count.div_ceil(S::F64_LANES) {
            simd.vectorize(Finish {
                elimination: self,
                tables,
                goal,
                links: &links,
                sampled: &sampled,
                blocks: &blocks,
                candidates: &candidates,
                register,
                pool,
            });
        }
    }

    /// Samples one target: the pivot ratio with this form alone.
    pub(super) fn conditioning<S: Simd>(&self, simd: S, tables: &Tables, target: &Target) -> f64 {
        let matrix = simd.vectorize(Build {
            elimination: self,
            target,
        });
        simd.vectorize(Condition {
            tables,
            matrix: &matrix,
            form: self.form,
        })
    }
}

struct Build<'a> {
    elimination: &'a Elimination,
    target: &'a Target,
}

impl WithSimd for Build<'_> {
    type Output = Harmonics;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Harmonics {
        let link = self.elimination.link(self.target);
        self.elimination.linear.matrix(simd, link)
    }
}

struct Sample<'a> {
    tables: &'a Tables,
    matrix: &'a Harmonics,
    form: Form,
}

impl WithSimd for Sample<'_> {
    type Output = Sampled;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Sampled {
        sample(simd, self.tables, self.matrix, self.form)
    }
}

struct Blocks<'a> {
    matrix: &'a Harmonics,
    form: Form,
}

impl WithSimd for Blocks<'_> {
    type Output = Harmonics;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Harmonics {
        resultant::blocks(simd, self.matrix, self.form)
    }
}

struct Condition<'a> {
    tables: &'a Tables,
    matrix: &'a Harmonics,
    form: Form,
}

impl WithSimd for Condition<'_> {
    type Output = f64;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> f64 {
        super::polynomial::worst_ratio(simd, self.tables, self.matrix, self.form)
    }
}

struct Isolate<'a> {
    tables: &'a Tables,
    polynomial: &'a Trigonometric,
    out: &'a mut Candidates,
}

impl WithSimd for Isolate<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        isolate(simd, self.tables, self.polynomial, self.out);
    }
}

/// From candidates to solutions, one register of them.
struct Finish<'a, 'b> {
    elimination: &'a Elimination,
    tables: &'a Tables,
    goal: &'a Goal<'b>,
    links: &'a Links,
    sampled: &'a Sampled,
    blocks: &'a Harmonics,
    candidates: &'a Candidates,
    register: usize,
    pool: &'a mut Pool,
}

/// Newton steps on the determinant itself, with the polynomial's slope.
const DIRECT: usize = 1;

impl WithSimd for Finish<'_, '_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let polynomial = &self.sampled.polynomial;
        let polished = polish(
            simd,
            self.tables,
            polynomial,
            self.candidates,
            self.register,
        );
        let mut c = polished.turn;
        let zero = Lane::splat(simd, 0.0);
        let scale = Lane::splat(simd, self.sampled.scale);
        for _ in 0..DIRECT {
            let reduced = resultant::reduce(self.blocks, c);
            let step = -(reduced.value * scale / polished.slope);
            let usable = step.abs().less(polished.most);
            c = c.advanced(usable.pick(step, zero));
        }
        let reduced = resultant::reduce(self.blocks, c);
        let (d, e) = reduced.angles(self.elimination.form);
        let loop_angles = back::complete(simd, self.links, [c, d, e]);
        let mut q: Angles<S> = loop_angles;
        let joints = self.elimination.case.joints();
        for (angle, joint) in loop_angles.into_iter().zip(joints) {
            q[joint] = if self.elimination.case.inverted {
                angle.reversed()
            } else {
                angle
            };
        }
        let errors = newton(simd, self.goal, &mut q);
        let used = self.candidates.count - self.register * S::F64_LANES;
        self.pool
            .add(&q, errors, used.min(S::F64_LANES), TOLERANCES.closes);
    }
}
