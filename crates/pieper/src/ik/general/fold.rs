//! A fold: two solutions that are nearly one. Newton's method finds one of them slowly, and often only one. Here both are told
//! apart by what separates them.
//!
//! Let n be the direction in which the joints move without moving the end, and u the motion of the end that they cannot make.
//! On the curve where the error of the pose is along u alone, parametrised by the distance t along n, that error is a
//! parabola; its roots are the two solutions (Liapunov and Schmidt's reduction). A point of the curve is found by Newton's
//! method on `[J u; n^T 0]`, which is regular at a fold.

use pulp::{Simd, WithSimd};

use super::lanes::Lane;
use super::newton::{Frame, Goal, error, measure, newton, settle};
use super::pool::{Point, Pool, gather, scatter};
use super::tolerances::TOLERANCES;

/// Tells apart the solutions beside a point that is close to a fold.
pub(super) struct Fold<'a, 'b> {
    pub(super) goal: &'a Goal<'b>,
    pub(super) start: &'a Point,
}

/// The solutions beside a fold: two, one that is double, or none.
pub(super) struct Told {
    /// The top of the parabola, where the arm is singular.
    pub(super) top: Point,
    pub(super) solutions: Pool,
}

/// Radians: how far the start may be from the top of the parabola.
const REACH: f64 = 0.01;
/// No fold is within reach of a point whose smallest singular value is larger.
const FAR: f64 = 0.05;
/// Radians between the samples: first to find the top, then to know it.
const SPACINGS: [f64; 2] = [1e-3, 3e-5];
/// The two looks must agree on the bend up to this part.
const ALIKE: f64 = 0.1;
/// Steps onto the curve end when they are this short, radians; what has not come there is on no curve.
const SETTLED: f64 = 1e-11;
const STEPS: usize = 6;
/// The error of the pose by which rounding of the target and of the arm's motion may move the parabola.
const NOISE: f64 = 1e-15;
/// What the parabola may be wrong by when it says that it has no root.
const BIAS: f64 = 1e-14;
/// Radians: a parabola that leaves its roots less certain is none.
const VAGUE: f64 = 1e-5;
/// Radians: solutions that are farther from the top must come out as two.
const DISTINCT: f64 = 1e-6;

/// Samples of the curve, enough for the widest register.
const SAMPLES: usize = 8;

/// The error along u around a point of the curve, by its derivatives.
struct Parabola {
    slope: f64,
    bend: f64,
}

impl WithSimd for Fold<'_, '_> {
    /// Nothing if there is no fold, or more than one.
    type Output = Option<Told>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<Told> {
        let frame = self.frame(simd)?;
        let far = self.look(simd, &frame, 0.0, SPACINGS[0])?;
        let top = -far.slope / far.bend;
        if top.is_nan() || top.abs() >= REACH {
            return None;
        }
        let near = self.look(simd, &frame, top, SPACINGS[1])?;
        let top = top - near.slope / near.bend;
        let vague = 2.0 * (NOISE / near.bend).abs();
        let is_parabola = (near.bend - far.bend).abs() < ALIKE * far.bend.abs();
        if !(is_parabola && vague < VAGUE * VAGUE) {
            return None;
        }
        // Measured there, since what is no parabola moves the smallest value of one that was fitted beside.
        let (point, lowest) = self.point(simd, &frame, top);
        let square = -2.0 * lowest / near.bend;
        if square.abs() > TOLERANCES.beside * TOLERANCES.beside {
            return None;
        }
        let mut told = Told {
            top: point,
            solutions: Pool::new(),
        };
        if square < -2.0 * (BIAS / near.bend).abs() {
            return Some(told);
        }
        // Closer than rounding tells apart they are one, at the top.
        if square < vague {
            let at = gather(simd, &[told.top]);
            let errors = error(simd, self.goal, &at);
            told.solutions.add(&at, errors, 1, TOLERANCES.closes_well);
            return (told.solutions.count == 1).then_some(told);
        }
        let half = square.sqrt();
        let mut places = [0.0; SAMPLES];
        for (lane, place) in places.iter_mut().enumerate() {
            *place = top + half * [-1.0, 1.0][lane % 2];
        }
        for register in 0..2_usize.div_ceil(S::F64_LANES) {
            let mut q = gather(simd, &[*self.start]);
            let at = Lane::load(simd, &places, register);
            settle(simd, self.goal, &frame, &mut q, at, STEPS, SETTLED);
            let errors = newton(simd, self.goal, &mut q);
            let used = (2 - register * S::F64_LANES).min(S::F64_LANES);
            told.solutions.add(&q, errors, used, TOLERANCES.closes_well);
        }
        let count = told.solutions.count;
        (count == 2 || (count == 1 && half < DISTINCT)).then_some(told)
    }
}

impl Fold<'_, '_> {
    #[inline(always)]
    fn frame<S: Simd>(&self, simd: S) -> Option<Frame> {
        let measured = measure(simd, self.goal, &gather(simd, &[*self.start]));
        let (mut free, mut left) = ([0.0; 6], [0.0; 6]);
        for k in 0..6 {
            free[k] = measured.free[k].largest();
            left[k] = measured.left[k].largest();
        }
        (measured.sigma.largest() < FAR).then_some(Frame { free, left })
    }

    /// The point of the curve at a distance, and the error there.
    #[inline(always)]
    fn point<S: Simd>(&self, simd: S, frame: &Frame, along: f64) -> (Point, f64) {
        let mut q = gather(simd, &[*self.start]);
        let at = Lane::splat(simd, along);
        let (error, _) = settle(simd, self.goal, frame, &mut q, at, STEPS, SETTLED);
        (scatter(&q)[0], error.largest())
    }

    /// Samples the curve at distances around `middle`; nothing if they are on no curve.
    #[inline(always)]
    fn look<S: Simd>(&self, simd: S, frame: &Frame, middle: f64, spacing: f64) -> Option<Parabola> {
        let mut places = [middle; SAMPLES];
        places[1] += spacing;
        places[2] -= spacing;
        let mut errors = [0.0; SAMPLES];
        for register in 0..3_usize.div_ceil(S::F64_LANES) {
            let mut q = gather(simd, &[*self.start]);
            let at = Lane::load(simd, &places, register);
            let (error, last) = settle(simd, self.goal, frame, &mut q, at, STEPS, SETTLED);
            if last.is_nan() || last >= SETTLED.sqrt() {
                return None;
            }
            error.store(&mut errors, register);
        }
        let [value, right, left, ..] = errors;
        Some(Parabola {
            slope: (right - left) / (2.0 * spacing),
            bend: (right + left - 2.0 * value) / (spacing * spacing),
        })
    }
}
