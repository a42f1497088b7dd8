//! Two roots of the equation that are nearly one: near double roots the polynomial is a parabola, and how far its two roots are
//! apart follows from the value of the equation itself at its top, which is known better than the polynomial.

use pulp::{Simd, WithSimd};

use super::finish::Finish;
use crate::ik::general::isolate::Candidates;
use crate::ik::general::lanes::{Lane, Turn};
use crate::ik::general::polynomial::Sampled;
use crate::ik::general::pool::{CAPACITY, Pool};
use crate::ik::general::siblings::measure_new;

/// From pairs of roots to solutions, one register of them: both roots of a pair in neighbouring lanes.
pub(super) struct Pairs<'a> {
    pub(super) finish: &'a Finish<'a>,
    pub(super) sampled: &'a Sampled,
    pub(super) candidates: &'a Candidates,
    pub(super) register: usize,
    pub(super) pool: &'a mut Pool,
}

/// Samples of the equation around a top, and their distance in radians: too short for the parabola to be seen, so that they
/// tell the equation's rounding. The last two are farther away, to see it: whether it is the polynomial's, up to this part.
const SAMPLES: usize = 8;
const SPACING: f64 = 1e-10;
const ASIDE: f64 = 3e-5;
const ALIKE: f64 = 0.25;

/// Times the samples' spread: what their mean may be wrong by.
const NOISE: f64 = 4.0;

/// Times the noise of a coefficient over the bend: how far the top may be from where the polynomial has it. Never less far than
/// angles tell apart at a double root.
const OFF: f64 = 16.0;
const DIM: f64 = 2e-8;

/// Times the noise of a coefficient: what the equation may be wrong by all around a top, from rounding of the target, when it
/// says that it has no root there.
const BIAS: f64 = 100.0;

/// Where two roots led to one solution that is less singular than this, another one is missing.
const DOUBLE: f64 = 1e-5;

impl WithSimd for Pairs<'_> {
    /// Whether solutions may have been missed.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let (finish, candidates, register) = (self.finish, self.candidates, self.register);
        let sampled = self.sampled;
        let symmetric = finish.offset.symmetric;
        let (mut cos, mut sin, mut distance) = ([1.0; 8], [0.0; 8], [0.0; 8]);
        // Whether there may be two roots.
        let mut exists = [0.0; 8];
        let mut is_parabola = true;
        for lane in 0..S::F64_LANES {
            let root = register * S::F64_LANES + lane;
            let Some(pair) = candidates.pairs[..candidates.pair_count].get(root / 2) else {
                break;
            };
            (sin[lane], cos[lane]) = pair.angle.sin_cos();
            let top = Turn {
                cos: Lane::splat(simd, cos[lane]),
                sin: Lane::splat(simd, sin[lane]),
            };
            let [value, spread, bend] = self.top(simd, top);
            // What is no number fails.
            is_parabola &= (bend - pair.bend).abs() < ALIKE * pair.bend.abs();
            let square = -2.0 * value / pair.bend;
            let off = OFF * sampled.noise / pair.bend;
            let vague = (NOISE * (spread / pair.bend).abs())
                .max(off * off)
                .max(DIM * DIM);
            let most = (BIAS * sampled.noise / pair.bend).abs();
            exists[lane] = f64::from(square > -most.max(vague));
            // Where it is not known on which side of zero the square is: from outside, so that Newton's method stays on its side.
            distance[lane] = square.max(vague).sqrt() * [1.0, -1.0][root % 2];
        }
        let lanes = |list: &[f64; 8]| Lane::load(simd, list, 0);
        let exists = Lane::splat(simd, 0.5).less(lanes(&exists));
        let top = Turn {
            cos: lanes(&cos),
            sin: lanes(&sin),
        };
        let angle = top.advanced(lanes(&distance));
        let at = finish.equation.at(angle);
        let (real, unsure) = at.is_real();
        let real = real.and(exists);
        let used = (2 * candidates.pair_count - register * S::F64_LANES).min(S::F64_LANES);
        let before = self.pool.count;
        let pool = self.pool;
        let x = at.first(symmetric);
        let mut good = finish.solve(simd, angle, &at.branch(x, at.turn(x)), used, pool);
        if symmetric {
            let branch = at.branch(-x, at.turn(-x));
            good = good.and(finish.solve(simd, angle, &branch, used, pool));
        }
        if !is_parabola || unsure.any() || real.and_not(good).any() {
            return true;
        }
        if pool.count == before + (real.count(used) << u32::from(symmetric)) {
            return false;
        }
        let mut sigma = [0.0; CAPACITY];
        measure_new(simd, finish.goal, pool, before, &mut sigma);
        sigma[before..pool.count].iter().any(|&s| s > DOUBLE)
    }
}

impl Pairs<'_> {
    /// The equation at a top, in the polynomial's units, how far samples of it lie apart, and the second derivative.
    #[inline(always)]
    fn top<S: Simd>(&self, simd: S, top: Turn<S>) -> [f64; 3] {
        let symmetric = self.finish.offset.symmetric;
        let mut values = [0.0; SAMPLES];
        let mut offsets: [f64; SAMPLES] = std::array::from_fn(|k| SPACING * k as f64);
        offsets[SAMPLES - 2..].copy_from_slice(&[ASIDE, -ASIDE]);
        for register in 0..SAMPLES / S::F64_LANES {
            let angle = top.advanced(Lane::load(simd, &offsets, register));
            let value = self.finish.equation.at(angle).value(symmetric);
            value.store(&mut values, register);
        }
        let [near @ .., left, right] = values;
        let (mut least, mut most, mut sum) = (f64::MAX, f64::MIN, 0.0);
        for value in near {
            least = if value < least { value } else { least };
            most = if value > most { value } else { most };
            sum += value;
        }
        let mean = sum / near.len() as f64;
        let bend = (left + right - 2.0 * mean) / (ASIDE * ASIDE);
        [mean, most - least, bend].map(|x| x * self.sampled.scale)
    }
}
