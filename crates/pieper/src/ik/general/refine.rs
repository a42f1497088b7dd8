//! The roots of the polynomial in all lanes at once: safeguarded Newton steps between the ends of the intervals.

use pulp::Simd;

use super::isolate::{CANDIDATES, Candidates};
use super::tables::{DEGREE, HALF, Tables, Trigonometric};
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Turn};

/// Angles c and the polynomial's slope there.
#[derive(Clone, Copy)]
pub(super) struct Polished<S: Simd> {
    pub(super) angle: Lane<S>,
    pub(super) turn: Turn<S>,
    pub(super) slope: Lane<S>,
    /// The longest step that the determinant itself may add: none for points that are no simple roots.
    pub(super) most: Lane<S>,
}

/// Newton steps at most; the last ones only for intervals that had to be halved.
const STEPS: usize = 12;

/// Radians: what is closer to a root is left to the step on what the polynomial stands for, if it is as small a part of the distance
/// from the ends of the interval, where there may be an extremum.
const POLISHED: f64 = 1e-6;
const OF_THE_WAY: f64 = 0.01;

/// The roots of the candidates in register `register`.
#[inline(always)]
pub(super) fn polish<S: Simd>(
    simd: S,
    tables: &Tables,
    polynomial: &Trigonometric,
    candidates: &Candidates,
    register: usize,
) -> Polished<S> {
    let (mut cos, mut sin) = ([1.0; CANDIDATES], [0.0; CANDIDATES]);
    let mut middles = [0.0; CANDIDATES];
    for k in 0..candidates.count.next_multiple_of(8).min(CANDIDATES) {
        cos[k] = tables.arc_cos[0][usize::from(candidates.arc[k])];
        sin[k] = tables.arc_sin[0][usize::from(candidates.arc[k])];
        middles[k] = HALF * f64::from(2 * u16::from(candidates.arc[k]) + 1);
    }
    let middle = Turn {
        cos: Lane::load(simd, &cos, register),
        sin: Lane::load(simd, &sin, register),
    };
    let mut low = Lane::load(simd, &candidates.low, register);
    let mut high = Lane::load(simd, &candidates.high, register);
    let (first, last) = (low, high);
    let sign = Lane::load(simd, &candidates.sign, register);
    let mut at = Lane::load(simd, &candidates.start, register);
    let (zero, half) = (Lane::splat(simd, 0.0), Lane::splat(simd, 0.5));
    let is_root = low.less(high);
    let most = is_root.pick(Lane::splat(simd, TOLERANCES.refine_step), zero);
    let (polished, of_the_way) = (Lane::splat(simd, POLISHED), Lane::splat(simd, OF_THE_WAY));
    let mut turn = local(middle, at);
    let (mut value, mut slope) = evaluate(polynomial, turn);
    for _ in 0..STEPS {
        let before = (value * sign).less(zero);
        high = before.pick(at, high);
        low = before.pick(low, at);
        let step = value / slope;
        let enough = polished.min(of_the_way * (at - first).min(last - at));
        if is_root.pick(step.abs() - enough, zero).largest() <= 0.0 {
            break;
        }
        let newton = at - step;
        let inside = low.less(newton).and(newton.less(high));
        at = inside.pick(newton, half * (low + high));
        turn = local(middle, at);
        (value, slope) = evaluate(polynomial, turn);
    }
    Polished {
        angle: at + Lane::load(simd, &middles, register),
        turn,
        slope,
        most,
    }
}

/// `middle` turned on by an offset of at most half an arc: sine and cosine by their series.
#[inline(always)]
pub(super) fn local<S: Simd>(middle: Turn<S>, offset: Lane<S>) -> Turn<S> {
    let square = offset * offset;
    let mut sin = square.mul_add(offset.constant(-1.0 / 5040.0), offset.constant(1.0 / 120.0));
    sin = square.mul_add(sin, offset.constant(-1.0 / 6.0));
    sin = (square * offset).mul_add(sin, offset);
    let mut cos = square.mul_add(
        offset.constant(1.0 / 40320.0),
        offset.constant(-1.0 / 720.0),
    );
    cos = square.mul_add(cos, offset.constant(1.0 / 24.0));
    cos = square.mul_add(cos, offset.constant(-0.5));
    cos = square.mul_add(cos, offset.constant(1.0));
    Turn {
        cos: middle.sin.subtract_product(sin, middle.cos * cos),
        sin: middle.sin.mul_add(cos, middle.cos * sin),
    }
}

/// The polynomial and its slope: `sum c_k z^k` with `c_k = a_k - i b_k`, `z = cos + i sin`, and `sum i k c_k z^k`. By Horner's rule
/// in `z^2`, even and odd powers side by side: a single chain would have to wait for each of its steps.
#[inline(always)]
fn evaluate<S: Simd>(polynomial: &Trigonometric, z: Turn<S>) -> (Lane<S>, Lane<S>) {
    let zero = z.cos.constant(0.0);
    let square = Turn {
        cos: z.sin.subtract_product(z.sin, z.cos * z.cos),
        sin: (z.sin + z.sin) * z.cos,
    };
    let (mut sums, mut rates) = ([[zero; 2]; 2], [[zero; 2]; 2]);
    for k in (0..=DEGREE).rev() {
        let (a, b) = match k {
            0 => (polynomial[0], 0.0),
            _ => (polynomial[k], -polynomial[DEGREE + k]),
        };
        let rate = k as f64;
        sums[k % 2] = times_plus(square, sums[k % 2], (a, b));
        rates[k % 2] = times_plus(square, rates[k % 2], (rate * a, rate * b));
    }
    let value = z
        .sin
        .subtract_product(sums[1][1], z.cos.mul_add(sums[1][0], sums[0][0]));
    let slope = z
        .sin
        .mul_add(rates[1][0], z.cos.mul_add(rates[1][1], rates[0][1]));
    (value, -slope)
}

/// A complex number times another one, and a constant.
#[inline(always)]
fn times_plus<S: Simd>(z: Turn<S>, [x, y]: [Lane<S>; 2], (re, im): (f64, f64)) -> [Lane<S>; 2] {
    [
        z.cos.mul_add(x, z.sin.subtract_product(y, x.constant(re))),
        z.cos.mul_add(y, z.sin.mul_add(x, x.constant(im))),
    ]
}
