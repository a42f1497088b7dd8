//! The resultant as a trigonometric polynomial in the angle c, from its values at 24 angles.

use pulp::Simd;

use super::elimination::Harmonics;
use super::number::Number;
use super::resultant::{self, Form};
use super::tables::{BEYOND, COEFFICIENTS, SAMPLES, Tables, Trigonometric};
use crate::ik::lanes::{Lane, Turn};

/// The polynomial, scaled to a largest coefficient of 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sampled {
    pub(super) polynomial: Trigonometric,
    /// The factor between det S and the polynomial.
    pub(super) scale: f64,
    /// The size of what the harmonics above the degree come to: rounding and perturbation make every coefficient as uncertain.
    pub(super) noise: f64,
}

/// Samples det S around the circle. Where the chosen shift is bad, the others are tried and the best one is taken for
/// each sample: bad samples would pollute all coefficients.
#[inline(always)]
pub(super) fn sample<S: Simd, N: Number<S>>(
    simd: S,
    tables: &Tables,
    matrix: &Harmonics,
    form: Form,
) -> Sampled {
    let (mut values, mut ratios) = ([0.0; SAMPLES], [0.0; SAMPLES]);
    let (mut worst, mut best) =
        sample_shift::<S, N>(simd, tables, matrix, form, &mut values, &mut ratios);
    for more in 1..resultant::SHIFTS.len() {
        if worst >= N::PIVOT_RATIO * best {
            break;
        }
        let shift = (form.shift + more) % resultant::SHIFTS.len();
        (worst, best) = sample_shift::<S, N>(
            simd,
            tables,
            matrix,
            Form { shift, ..form },
            &mut values,
            &mut ratios,
        );
    }
    transform(simd, tables, &values)
}

/// The polynomial that has these values at the sampling angles, and what it is not.
#[inline(always)]
pub(super) fn transform<S: Simd>(simd: S, tables: &Tables, values: &[f64; SAMPLES]) -> Sampled {
    let mut polynomial: Trigonometric = [0.0; COEFFICIENTS];
    for (coefficient, weights) in polynomial.iter_mut().zip(&tables.transform) {
        *coefficient = weighted(simd, weights, values);
    }
    let mut noise = 0.0;
    for weights in &tables.beyond {
        let coefficient = weighted(simd, weights, values);
        noise += coefficient * coefficient;
    }
    let largest = polynomial.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let scale = if largest > 0.0 { 1.0 / largest } else { 0.0 };
    Sampled {
        polynomial: polynomial.map(|x| x * scale),
        scale,
        // What is no number is noise.
        noise: if values.iter().sum::<f64>().is_finite() {
            (noise / BEYOND as f64).sqrt() * scale
        } else {
            f64::MAX
        },
    }
}

#[inline(always)]
fn weighted<S: Simd>(simd: S, weights: &[f64; SAMPLES], values: &[f64; SAMPLES]) -> f64 {
    let mut sum = Lane::splat(simd, 0.0);
    for register in 0..SAMPLES / S::F64_LANES {
        let weight = Lane::load(simd, weights, register);
        sum = weight.mul_add(Lane::load(simd, values, register), sum);
    }
    sum.sum()
}

/// One shift at all samples: takes over what is better than before. Returns the smallest and the largest ratio.
#[inline(always)]
fn sample_shift<S: Simd, N: Number<S>>(
    simd: S,
    tables: &Tables,
    matrix: &Harmonics,
    form: Form,
    values: &mut [f64; SAMPLES],
    ratios: &mut [f64; SAMPLES],
) -> (f64, f64) {
    let blocks = resultant::blocks(simd, matrix, form);
    let (mut worst, mut best) = (Lane::splat(simd, f64::MAX), Lane::splat(simd, 0.0));
    for register in 0..SAMPLES / S::F64_LANES {
        let c = Turn {
            cos: Lane::load(simd, &tables.sample_cos, register),
            sin: Lane::load(simd, &tables.sample_sin, register),
        };
        let reduced = resultant::reduce::<S, N>(&blocks, c);
        let before = Lane::load(simd, ratios, register);
        let better = before.less(reduced.ratio);
        let value = better.pick(reduced.value, Lane::load(simd, values, register));
        let ratio = better.pick(reduced.ratio, before);
        value.store(values, register);
        ratio.store(ratios, register);
        (worst, best) = (worst.min(ratio), best.max(ratio));
    }
    (worst.smallest(), best.largest())
}

/// The smallest pivot ratio of one form alone.
#[inline(always)]
pub(super) fn worst_ratio<S: Simd>(
    simd: S,
    tables: &Tables,
    matrix: &Harmonics,
    form: Form,
) -> f64 {
    let (mut values, mut ratios) = ([0.0; SAMPLES], [0.0; SAMPLES]);
    sample_shift::<S, Lane<S>>(simd, tables, matrix, form, &mut values, &mut ratios).0
}
