//! One elimination from end to end: from a target to the roots that it finds.

use pulp::{Simd, WithSimd};

use super::back::{self, Links};
use super::cycle::Case;
use super::elimination::{Harmonics, Linear};
use super::fold::Folds;
use super::isolate::{Candidates, Origin, PAIRS, isolate};
use super::newton::{Angles, Goal, newton};
use super::number::Double;
use super::polynomial::{Sampled, sample};
use super::pool::{Point, Pool, scatter};
use super::refine::polish;
use super::resultant::{self, Form, Reduced};
use super::tables::Tables;
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Mask, Rigid, Turn, square};
use crate::spatial::Pose;

/// One elimination, prepared.
#[derive(Clone, Debug)]
pub(super) struct Elimination {
    pub(super) case: Case,
    /// Whether the resultant is computed with twice the digits.
    pub(super) precise: bool,
    /// Whether its linear part is that of the arm as it is.
    pub(super) exact: bool,
    pub(super) form: Form,
    pub(super) linear: Linear,
    /// The true links behind a to e and the inverse of the one behind f; the target's is filled in per target.
    pub(super) links: Links,
    /// Which of the joints a to f slide.
    pub(super) slides: [bool; 6],
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

/// Why an elimination may have missed roots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doubt {
    /// Two roots, or none, where the polynomial nearly touches zero.
    pub(super) near_miss: bool,
    /// The polynomial is smaller than its noise somewhere, or so flat at a root that noise moves it far.
    pub(super) drowned: bool,
    /// The noise, relative to the largest coefficient.
    pub(super) noise: f64,
    /// That it is evidence enough, unless one of these solutions is singular: those that lone roots led to, one bit each. For that
    /// the elimination is exact, it rose above its noise everywhere but at pairs of roots that were told apart, and every
    /// lone root led to a solution of its own.
    pub(super) alone: Option<u64>,
}

impl Elimination {
    /// Takes the resultant in another form.
    pub(super) fn set_form(&mut self, form: Form) {
        self.form = form;
        self.linear.swap(form.swapped);
    }

    /// What stands for a slide in the resultant is twice its arc tangent.
    #[inline(always)]
    fn value<S: Simd>(&self, place: usize, turn: Turn<S>) -> Turn<S> {
        if !self.slides[place] {
            return turn;
        }
        let one = turn.cos.constant(1.0);
        let tiny = turn.cos.constant(f64::EPSILON);
        Turn::slid(turn.sin / (one + turn.cos).max(tiny))
    }

    #[inline(always)]
    fn reduce<S: Simd>(&self, blocks: &Harmonics, c: Turn<S>) -> Reduced<S> {
        if self.precise {
            resultant::reduce::<S, Double<S>>(blocks, c)
        } else {
            resultant::reduce::<S, Lane<S>>(blocks, c)
        }
    }

    /// The arm's joints from the angles c, d and e.
    #[inline(always)]
    fn joints<S: Simd>(
        &self,
        simd: S,
        links: &Links,
        c: Turn<S>,
        (d, e): (Turn<S>, Turn<S>),
    ) -> Angles<S> {
        let (d, e) = (self.value(3, d), self.value(4, e));
        let loop_angles = back::complete(simd, links, &self.slides, [c, d, e]);
        let mut q = loop_angles;
        for (angle, joint) in loop_angles.into_iter().zip(self.case.joints()) {
            q[joint] = match self.case.inverted {
                true => angle.reversed(),
                false => angle,
            };
        }
        q
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
    ) -> Doubt {
        let matrix = simd.vectorize(Build {
            elimination: self,
            target,
        });
        let sampled = simd.vectorize(Sample {
            tables,
            matrix: &matrix,
            form: self.form,
            precise: self.precise,
        });
        let mut candidates = Candidates::new();
        simd.vectorize(Isolate {
            tables,
            sampled: &sampled,
            origin: if self.exact {
                Origin::Exact
            } else {
                Origin::Perturbed
            },
            out: &mut candidates,
        });
        let mut doubt = Doubt {
            near_miss: candidates.unsure,
            drowned: candidates.drowned,
            noise: sampled.noise,
            alone: None,
        };
        let mut links = self.links;
        links[self.case.place()] = Rigid::of(self.link(target));
        let blocks = simd.vectorize(Blocks {
            matrix: &matrix,
            form: self.form,
        });
        for register in 0..candidates.count.div_ceil(S::F64_LANES) {
            doubt.drowned |= simd.vectorize(Finish {
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
        let lone = std::mem::take(&mut pool.hit);
        let mut told = true;
        for register in 0..candidates.pair_count.div_ceil(S::F64_LANES) {
            let starts = simd.vectorize(Tops {
                elimination: self,
                links: &links,
                blocks: &blocks,
                candidates: &candidates,
                register,
            });
            let used = candidates.pair_count - register * S::F64_LANES;
            let starts = &starts[..used.min(S::F64_LANES)];
            let folds = simd.vectorize(Folds { goal, starts });
            for fold in &folds[..starts.len()] {
                match fold {
                    Some(fold) => fold.add_to(pool),
                    None => told = false,
                }
            }
        }
        // Those that only lone roots led to.
        let lone = lone & !pool.hit;
        pool.hit |= lone;
        doubt.drowned |= !told;
        let is_clear = !(doubt.near_miss || doubt.drowned || candidates.vague);
        // Fewer, and a root led nowhere or to another one's solution; more, and some solution has no root.
        let is_whole = lone.count_ones() as usize == candidates.intervals();
        let believed = if candidates.least > TOLERANCES.clear * sampled.noise {
            TOLERANCES.believed_clear
        } else {
            TOLERANCES.believed
        };
        doubt.alone =
            (self.exact && is_clear && is_whole && sampled.noise < believed).then_some(lone);
        doubt
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
    precise: bool,
}

impl WithSimd for Sample<'_> {
    type Output = Sampled;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Sampled {
        if self.precise {
            sample::<S, Double<S>>(simd, self.tables, self.matrix, self.form)
        } else {
            sample::<S, Lane<S>>(simd, self.tables, self.matrix, self.form)
        }
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
    sampled: &'a Sampled,
    origin: Origin,
    out: &'a mut Candidates,
}

impl WithSimd for Isolate<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        isolate(
            simd,
            self.tables,
            &self.sampled.polynomial,
            self.sampled.noise,
            self.origin,
            self.out,
        );
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
    /// Whether noise moves some of the roots far.
    type Output = bool;
    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> bool {
        let (elimination, polynomial) = (self.elimination, &self.sampled.polynomial);
        let polished = polish(
            simd,
            self.tables,
            polynomial,
            self.candidates,
            self.register,
        );
        let zero = Lane::splat(simd, 0.0);
        let shaky = Lane::splat(simd, self.sampled.noise / TOLERANCES.shaky);
        let flat = zero
            .less(polished.most)
            .and(polished.slope.abs().less(shaky));
        let drowned = flat.any();
        let mut c = polished.turn;
        let scale = Lane::splat(simd, self.sampled.scale);
        for _ in 0..DIRECT {
            let reduced = elimination.reduce(self.blocks, c);
            let step = -(reduced.value * scale / polished.slope);
            let usable = step.abs().less(polished.most);
            c = c.advanced(usable.pick(step, zero));
        }
        let reduced = elimination.reduce(self.blocks, c);
        let form = elimination.form;
        let plain = reduced.angles(form);
        let mut good = self.finish(simd, c, plain);
        let (twins, both) = reduced.twins(form);
        if twins.any() {
            for (d, e) in both {
                // The others once more, which costs nothing: from elsewhere Newton's method would take long.
                let angles = (twins.pick_turn(d, plain.0), twins.pick_turn(e, plain.1));
                good = good.or(self.finish(simd, c, angles));
            }
        }
        // A simple root of the polynomial that leads to no solution, or far away, was a mixture of several.
        let simple = zero.less(polished.most);
        drowned || simple.and_not(good).any()
    }
}

/// From the tops of pairs to joint angles nearby, one register of them.
struct Tops<'a> {
    elimination: &'a Elimination,
    links: &'a Links,
    blocks: &'a Harmonics,
    candidates: &'a Candidates,
    register: usize,
}

impl WithSimd for Tops<'_> {
    type Output = [Point; 8];
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [Point; 8] {
        let elimination = self.elimination;
        let (mut cos, mut sin) = ([1.0; PAIRS], [0.0; PAIRS]);
        for k in 0..self.candidates.pair_count {
            (sin[k], cos[k]) = self.candidates.pairs[k].sin_cos();
        }
        let c = Turn {
            cos: Lane::load(simd, &cos, self.register),
            sin: Lane::load(simd, &sin, self.register),
        };
        let angles = elimination.reduce(self.blocks, c).angles(elimination.form);
        let q = elimination.joints(simd, self.links, c, angles);
        scatter(&q)
    }
}

impl Finish<'_, '_> {
    /// From the angles c, d and e to solutions; whether there is one close to the angle c.
    #[inline(always)]
    fn finish<S: Simd>(&mut self, simd: S, c: Turn<S>, angles: (Turn<S>, Turn<S>)) -> Mask<S> {
        let mut q = self.elimination.joints(simd, self.links, c, angles);
        let errors = newton(simd, self.goal, &mut q);
        let used = self.candidates.count - self.register * S::F64_LANES;
        self.pool
            .add(&q, errors, used.min(S::F64_LANES), TOLERANCES.closes);
        let kept = q[self.elimination.case.kept];
        let kept = if self.elimination.case.inverted {
            kept.reversed()
        } else {
            kept
        };
        let moved = square(&[kept.cos - c.cos, kept.sin - c.sin]);
        let most = c.cos.constant(TOLERANCES.moved * TOLERANCES.moved);
        let closes = errors.less(c.cos.constant(TOLERANCES.closes));
        closes.and(moved.less(most))
    }
}
