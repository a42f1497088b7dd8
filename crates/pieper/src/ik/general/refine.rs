//! The roots of the polynomial in all lanes at once: safeguarded Newton steps between the ends of the intervals.

use pulp::Simd;

use super::isolate::{CANDIDATES, Candidates};
use super::lanes::{Lane, Turn};
use super::tables::{DEGREE, Tables, Trigonometric};
use super::tolerances::TOLERANCES;

/// Angles c and the polynomial's slope there.
#[derive(Clone, Copy)]
pub(super) struct Polished<S: Simd> {
    pub(super) turn: Turn<S>,
    pub(super) slope: Lane<S>,
    /// The longest step that the determinant itself may add: none for points that are no simple roots.
    pub(super) most: Lane<S>,
}

/// Newton steps at most; the last ones only for intervals that had to be halved.
const STEPS: usize = 12;

/// Radians: the last step is shorter. Roots this close are still told apart.
const POLISHED: f64 = 1e-8;

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
    for k in 0..candidates.count.next_multiple_of(8).min(CANDIDATES) {
        cos[k] = tables.arc_cos[0][usize::from(candidates.arc[k])];
        sin[k] = tables.arc_sin[0][usize::from(candidates.arc[k])];
    }
    let middle = Turn {
        cos: Lane::load(simd, &cos, register),
        sin: Lane::load(simd, &sin, register),
    };
    let mut low = Lane::load(simd, &candidates.low, register);
    let mut high = Lane::load(simd, &candidates.high, register);
    let sign = Lane::load(simd, &candidates.sign, register);
    let mut at = Lane::load(simd, &candidates.start, register);
    let most = low.less(high).pick(
        Lane::splat(simd, TOLERANCES.refine_step),
        Lane::splat(simd, 0.0),
    );
    let (zero, half) = (Lane::splat(simd, 0.0), Lane::splat(simd, 0.5));
    let mut turn = local(middle, at);
    let (mut value, mut slope) = evaluate(polynomial, turn);
    for _ in 0..STEPS {
        let before = (value * sign).less(zero);
        high = before.pick(at, high);
        low = before.pick(low, at);
        let newton = at - value / slope;
        let inside = low.less(newton).and(newton.less(high));
        let next = inside.pick(newton, half * (low + high));
        let moved = (next - at).abs();
        at = next;
        turn = local(middle, at);
        (value, slope) = evaluate(polynomial, turn);
        if moved.largest() < POLISHED {
            break;
        }
    }
    Polished { turn, slope, most }
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

/// The polynomial and its slope: Horner's rule for `sum (a_k - i b_k) z^k` and its derivative, `z = cos + i sin`.
#[inline(always)]
fn evaluate<S: Simd>(polynomial: &Trigonometric, z: Turn<S>) -> (Lane<S>, Lane<S>) {
    let zero = z.cos.constant(0.0);
    let (mut re, mut im, mut slope_re, mut slope_im) = (zero, zero, zero, zero);
    for k in (1..=DEGREE).rev() {
        let (a, b) = (polynomial[k], polynomial[DEGREE + k]);
        let rate = k as f64;
        let (x, y) = (re + zero.constant(a), im + zero.constant(-b));
        re = z.sin.subtract_product(y, z.cos * x);
        im = z.sin.mul_add(x, z.cos * y);
        let (a, b) = (zero.constant(rate * a), zero.constant(-rate * b));
        let (x, y) = (slope_re + a, slope_im + b);
        slope_re = z.sin.subtract_product(y, z.cos * x);
        slope_im = z.sin.mul_add(x, z.cos * y);
    }
    (re + zero.constant(polynomial[0]), -slope_im)
}
