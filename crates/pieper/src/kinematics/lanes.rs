//! SIMD lanes as a scalar: several poses at once, and their sines and cosines.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use std::ops::{Add, Mul, Neg, Sub};

use pulp::Simd;

use super::kernel::{Column, Turn};
use crate::scalar::Scalar;

/// One register of doubles, in one line of the cache.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Lanes<S: Simd> {
    pub(super) simd: S,
    pub(super) value: S::f64s,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    pub(super) fn splat(simd: S, value: f64) -> Self {
        Self {
            simd,
            value: simd.splat_f64s(value),
        }
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.simd.add_f64s(self.value, other.value),
            ..self
        }
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.simd.sub_f64s(self.value, other.value),
            ..self
        }
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.simd.mul_f64s(self.value, other.value),
            ..self
        }
    }
}

/// `-v`. Not `neg_f64s`, nor `abs_f64s` below: those are not always inlined, and without link-time optimisation become calls.
#[inline(always)]
pub(crate) fn negative<S: Simd>(simd: S, v: S::f64s) -> S::f64s {
    simd.xor_f64s(v, simd.splat_f64s(-0.0))
}

/// `|v|`.
#[inline(always)]
pub(crate) fn magnitude<S: Simd>(simd: S, v: S::f64s) -> S::f64s {
    simd.and_f64s(v, simd.splat_f64s(f64::from_bits(!(1 << 63))))
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            value: negative(self.simd, self.value),
            ..self
        }
    }
}

impl<S: Simd> Scalar for Lanes<S> {
    #[inline(always)]
    fn constant(&self, value: f64) -> Self {
        Self::splat(self.simd, value)
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self {
            value: self
                .simd
                .mul_add_e_f64s(self.value, factor.value, addend.value),
            ..self
        }
    }
}

/// A column of several poses at once.
#[derive(Clone, Copy)]
pub(super) struct LaneColumn<S: Simd> {
    pub(super) simd: S,
    pub(super) x: S::f64s,
    pub(super) y: S::f64s,
    pub(super) z: S::f64s,
}

impl<S: Simd> LaneColumn<S> {
    /// The column, or its opposite if `sign` is below zero.
    #[inline(always)]
    pub(super) fn signed(self, sign: f64) -> Self {
        if sign < 0.0 { self.negated() } else { self }
    }
}

impl<S: Simd> Column for LaneColumn<S> {
    type Scalar = Lanes<S>;

    #[inline(always)]
    fn scaled(&self, by: &Lanes<S>) -> Self {
        let simd = self.simd;
        let scale = |value| simd.mul_f64s(value, by.value);
        Self {
            simd,
            x: scale(self.x),
            y: scale(self.y),
            z: scale(self.z),
        }
    }

    #[inline(always)]
    fn scaled_plus(&self, by: &Lanes<S>, other: &Self) -> Self {
        let simd = self.simd;
        let scale = |value, plus| simd.mul_add_e_f64s(value, by.value, plus);
        Self {
            simd,
            x: scale(self.x, other.x),
            y: scale(self.y, other.y),
            z: scale(self.z, other.z),
        }
    }

    #[inline(always)]
    fn negated(&self) -> Self {
        let simd = self.simd;
        Self {
            simd,
            x: negative(simd, self.x),
            y: negative(simd, self.y),
            z: negative(simd, self.z),
        }
    }
}

/// Angles up to this size are reduced by two products with pi/2; larger ones go to the standard library.
/// Up to here the number of quarter turns, below 2^17, times pi/2's leading 53 bits cancels exactly.
pub(super) const MAX_REDUCED: f64 = 1e5;

/// pi/2 less its nearest double.
const FRAC_PI_2_TAIL: f64 = 6.123_233_995_736_766e-17;

/// Adding it rounds a double below 2^51 to an integer, left in the low bits.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Minimax coefficients of (sin r - r) / r^3 in r^2 on [-pi/4, pi/4], after Sun's fdlibm; error below 2^-58.
const SIN: [f64; 6] = [
    -1.666_666_666_666_663_243_48e-1,
    8.333_333_333_322_489_461_24e-3,
    -1.984_126_982_985_794_931_34e-4,
    2.755_731_370_707_006_767_89e-6,
    -2.505_076_025_340_686_341_95e-8,
    1.589_690_995_211_550_102_21e-10,
];

/// Minimax coefficients of (cos r - 1 + r^2/2) / r^4 in r^2, same source.
const COS: [f64; 6] = [
    4.166_666_666_666_660_190_37e-2,
    -1.388_888_888_887_410_957_49e-3,
    2.480_158_728_947_672_941_78e-5,
    -2.755_731_435_139_066_330_35e-7,
    2.087_572_321_298_174_827_90e-9,
    -1.135_964_755_778_819_482_65e-11,
];

/// Sine and cosine of every lane, to about one unit in the last place; every lane at most [`MAX_REDUCED`] in size.
///
/// For units with a fused multiply-add: the reduction's first product has to be exact.
#[inline(always)]
pub(super) fn sin_cos<S: Simd>(x: Lanes<S>) -> Turn<Lanes<S>> {
    reduced(x).sin_cos()
}

/// Angles less a number of quarter turns.
#[derive(Clone, Copy)]
pub(super) struct Reduced<S: Simd> {
    /// The number, in the low bits.
    shifted: Lanes<S>,
    /// What is left, in [-pi/4, pi/4].
    rest: Lanes<S>,
}

/// The first half of [`sin_cos`].
#[inline(always)]
pub(super) fn reduced<S: Simd>(x: Lanes<S>) -> Reduced<S> {
    let splat = |value| Lanes::splat(x.simd, value);
    let shifted = x.mul_add(splat(FRAC_2_PI), splat(ROUNDING));
    let quarters = shifted - splat(ROUNDING);
    let rest = quarters.mul_add(splat(-FRAC_PI_2), x);
    let rest = quarters.mul_add(splat(-FRAC_PI_2_TAIL), rest);
    Reduced { shifted, rest }
}

impl<S: Simd> Reduced<S> {
    /// The second half of [`sin_cos`].
    #[inline(always)]
    pub(super) fn sin_cos(&self) -> Turn<Lanes<S>> {
        let simd = self.shifted.simd;
        let (sin, cos) = polynomials(self.rest);
        in_quarter(simd, self.shifted, sin, cos)
    }
}

/// Sine and cosine of an angle from those of what is left of it beyond a number of quarter turns, in the low bits
/// of `shifted`.
#[inline(always)]
fn in_quarter<S: Simd>(simd: S, shifted: Lanes<S>, sin: Lanes<S>, cos: Lanes<S>) -> Turn<Lanes<S>> {
    let bits = simd.transmute_u64s_f64s(shifted.value);
    let splat_bits = |value| simd.splat_u64s(value);
    let mask = |bits: S::u64s, bit: u64, ones: u64| {
        let is_set = simd.equal_u64s(simd.and_u64s(bits, splat_bits(bit)), splat_bits(bit));
        simd.select_u64s(is_set, splat_bits(ones), splat_bits(0))
    };
    // Odd quarters exchange sine and cosine: by the bits in which they differ, cheaper than two selections.
    let (sin, cos) = (
        simd.transmute_u64s_f64s(sin.value),
        simd.transmute_u64s_f64s(cos.value),
    );
    let differ = simd.and_u64s(simd.xor_u64s(sin, cos), mask(bits, 1, u64::MAX));
    let finish = |value: S::u64s, quarters: S::u64s| {
        let turned = simd.xor_u64s(simd.xor_u64s(value, differ), mask(quarters, 2, 1 << 63));
        Lanes {
            simd,
            value: simd.transmute_f64s_u64s(turned),
        }
    };
    Turn {
        sin: finish(sin, bits),
        cos: finish(cos, simd.add_u64s(bits, splat_bits(1))),
    }
}

/// Sine and cosine on [-pi/4, pi/4].
#[inline(always)]
fn polynomials<S: Simd>(r: Lanes<S>) -> (Lanes<S>, Lanes<S>) {
    let splat = |value| Lanes::splat(r.simd, value);
    let z = r * r;
    // Fused, the last steps round once each: the result is within one unit in the last place.
    let sin = (z * r).mul_add(polynomial(z, SIN), r);
    let cos = polynomial(z, COS).mul_add(z, splat(-0.5));
    (sin, cos.mul_add(z, splat(1.0)))
}

/// A polynomial in x, lowest coefficient first (Horner).
#[inline(always)]
fn polynomial<S: Simd>(x: Lanes<S>, [a, b, c, d, e, f]: [f64; 6]) -> Lanes<S> {
    let plus = |sum: Lanes<S>, coefficient: f64| sum.mul_add(x, Lanes::splat(x.simd, coefficient));
    plus(
        plus(plus(plus(plus(Lanes::splat(x.simd, f), e), d), c), b),
        a,
    )
}

/// Whether every lane is at most [`MAX_REDUCED`], and a number.
#[inline(always)]
pub(super) fn all_small<S: Simd>(Lanes { simd, value }: Lanes<S>) -> bool {
    all_true(
        simd,
        simd.less_than_f64s(value, simd.splat_f64s(MAX_REDUCED)),
    )
}

/// Whether a mask holds for every lane.
#[inline(always)]
pub(super) fn all_true<S: Simd>(simd: S, mask: S::m64s) -> bool {
    let zero = simd.splat_u64s(0);
    let every = simd.equal_u64s(zero, zero);
    simd.first_true_m64s(simd.xor_m64s(mask, every)) >= S::F64_LANES
}
