//! Offset wrists: axes 2 and 3 are parallel, axis 5 meets a neighbour. One equation in one angle, without elimination.
//!
//! Let W be the point where axis 5 meets axis 4 or axis 6. With that angle known which moves W past the meeting axes (joint 6
//! or joint 4), W is known as seen from the base and as seen from link 3, and so are axis 5 and its neighbour. What is
//! left is a position problem for the first three joints, with one condition more: the angle between the two meeting axes
//! (`equation`). The equation is a trigonometric polynomial of degree 8, exactly, and free of the degeneracies that the
//! elimination has for such arms; where joint 1 may turn by half a turn in every solution, as for arms without any offset of
//! the shoulder, degree 4 for pairs of solutions. The same arms with wrist and shoulder exchanged are solved backwards.
//!
//! Near double roots the polynomial is a parabola; from its top the arm itself tells the two apart (`pair`). Where the
//! polynomial drowns in its rounding in other ways, as it does where several roots are near, the equation itself is looked at
//! on shorter and shorter intervals (`zoom`), on each of them as a polynomial again (`local`): near such places its own rounding
//! vanishes with it. Where that does not tell either, as near families, every place where it is as good as zero is tried
//! (`magnify`).
//!
//! Worked out and measured for this project; the degrees were found by sampling (harmonics above are rounding).

mod back;
mod equation;
mod finish;
mod hunt;
mod local;
mod magnify;
mod pair;
mod zoom;

use pulp::{Simd, WithSimd};

use super::isolate::{Candidates, Origin, isolate};
use super::newton::Goal;
use super::polynomial::{Sampled, transform};
use super::pool::Pool;
use super::random::Random;
use super::single::{Doubt, Target};
use super::tables::{SAMPLES, Tables};
use crate::ik::lanes::{Lane, Rigid, Turn};
use crate::ik::normal::Normal;
use crate::spatial::{Pose, sin_cos_exact};
use equation::{Equation, Plane};
use finish::Finish;
use hunt::Hunt;

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
    local: Box<local::Tables>,
}

/// What the equation says of one target.
pub(super) struct Found {
    pub(super) doubt: Doubt,
    /// How often two roots were nearly one.
    pub(super) pairs: usize,
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
            local: Box::new(local::Tables::new()),
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
    ) -> Found {
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
            drowned: false,
            noise: sampled.noise,
            alone: None,
        };
        let finish = Finish {
            offset: self,
            goal,
            target: &target,
            equation: &equation,
        };
        let mut hunt = Hunt::new(&finish, pool, &candidates);
        hunt.polish(simd, tables, &sampled, &candidates);
        hunt.tell_pairs(simd, &candidates);
        hunt.look_closely(simd);
        doubt.drowned = !hunt.is_whole();
        if doubt.drowned {
            hunt.search(simd, &candidates);
        }
        Found {
            doubt,
            pairs: candidates.pair_count,
        }
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

/// The noise at least: rounding of the transform, which may by chance leave no trace in the harmonics above.
const NOISE: f64 = 2.0 * f64::EPSILON;
