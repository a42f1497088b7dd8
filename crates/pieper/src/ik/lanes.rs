//! Numbers in the lanes of a vector register: several samples, arcs or roots at once.
//!
//! Code on lanes is written with loops and functions that are always inlined, without closures: a closure handed to the
//! standard library is compiled without the vector unit's instructions, which then become calls.

use std::ops::{Add, Div, Mul, Neg, Sub};

use pulp::Simd;

use crate::kinematics::lanes::{magnitude, negative};

/// Runs the body for each index, of up to seven, written out: only where every index is known do the entries of arrays stay in
/// registers, and the compiler does not unroll loops as long as these by itself.
macro_rules! unrolled {
    ($index:ident of $count:expr, $body:block) => {
        unrolled!($index of $count, $body, 0 1 2 3 4 5 6)
    };
    ($index:ident of $count:expr, $body:block, $($value:literal)*) => {
        $({
            let $index = $value;
            if $index < $count $body
        })*
    };
}
pub(in crate::ik) use unrolled;

/// One register of doubles. In memory it lies in one line of the cache: whether it crossed two was up to where the stack happened to
/// begin, and cost a tenth of the time.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(in crate::ik) struct Lane<S: Simd> {
    simd: S,
    value: S::f64s,
}

/// One truth value for each lane.
#[derive(Clone, Copy)]
pub(in crate::ik) struct Mask<S: Simd> {
    simd: S,
    value: S::m64s,
}

/// A vector in space, in lanes.
pub(in crate::ik) type Vector<S> = [Lane<S>; 3];

/// Cosine and sine of an angle, in lanes.
#[derive(Clone, Copy)]
pub(in crate::ik) struct Turn<S: Simd> {
    pub(in crate::ik) cos: Lane<S>,
    pub(in crate::ik) sin: Lane<S>,
}

impl<S: Simd> Lane<S> {
    #[inline(always)]
    pub(in crate::ik) fn splat(simd: S, value: f64) -> Self {
        let value = simd.splat_f64s(value);
        Self { simd, value }
    }

    /// The same number in every lane, of the same kind as `self`.
    #[inline(always)]
    pub(in crate::ik) fn constant(self, value: f64) -> Self {
        Self::splat(self.simd, value)
    }

    /// Register `index` of a slice whose length is a multiple of the lanes.
    #[inline(always)]
    pub(in crate::ik) fn load(simd: S, slice: &[f64], index: usize) -> Self {
        let value = S::as_simd_f64s(slice).0[index];
        Self { simd, value }
    }

    #[inline(always)]
    pub(in crate::ik) fn store(self, slice: &mut [f64], index: usize) {
        S::as_mut_simd_f64s(slice).0[index] = self.value;
    }

    /// `self * factor + addend`.
    #[inline(always)]
    pub(in crate::ik) fn mul_add(self, factor: Self, addend: Self) -> Self {
        let value = self
            .simd
            .mul_add_e_f64s(self.value, factor.value, addend.value);
        Self { value, ..self }
    }

    /// `self * factor + addend`, rounded once whatever the processor.
    #[inline(always)]
    pub(in crate::ik) fn fused(self, factor: Self, addend: Self) -> Self {
        let value = self
            .simd
            .mul_add_f64s(self.value, factor.value, addend.value);
        Self { value, ..self }
    }

    /// `addend - self * factor`.
    #[inline(always)]
    pub(in crate::ik) fn subtract_product(self, factor: Self, from: Self) -> Self {
        let value = self
            .simd
            .negate_mul_add_e_f64s(self.value, factor.value, from.value);
        Self { value, ..self }
    }

    #[inline(always)]
    pub(in crate::ik) fn abs(self) -> Self {
        let value = magnitude(self.simd, self.value);
        Self { value, ..self }
    }

    #[inline(always)]
    pub(in crate::ik) fn sqrt(self) -> Self {
        let value = self.simd.sqrt_f64s(self.value);
        Self { value, ..self }
    }

    #[inline(always)]
    pub(in crate::ik) fn min(self, other: Self) -> Self {
        let value = self.simd.min_f64s(self.value, other.value);
        Self { value, ..self }
    }

    #[inline(always)]
    pub(in crate::ik) fn max(self, other: Self) -> Self {
        let value = self.simd.max_f64s(self.value, other.value);
        Self { value, ..self }
    }

    #[inline(always)]
    fn mask(self, value: S::m64s) -> Mask<S> {
        let simd = self.simd;
        Mask { simd, value }
    }

    #[inline(always)]
    pub(in crate::ik) fn less(self, other: Self) -> Mask<S> {
        self.mask(self.simd.less_than_f64s(self.value, other.value))
    }

    #[inline(always)]
    pub(in crate::ik) fn at_most(self, other: Self) -> Mask<S> {
        self.mask(self.simd.less_than_or_equal_f64s(self.value, other.value))
    }

    #[inline(always)]
    pub(in crate::ik) fn equals(self, other: Self) -> Mask<S> {
        self.mask(self.simd.equal_f64s(self.value, other.value))
    }

    /// With the sign of another in place of its own, which is not negative.
    #[inline(always)]
    pub(in crate::ik) fn with_sign(self, of: Self) -> Self {
        let sign = self.simd.and_f64s(of.value, self.simd.splat_f64s(-0.0));
        let value = self.simd.or_f64s(self.value, sign);
        Self { value, ..self }
    }

    /// The smallest lane.
    #[inline(always)]
    pub(in crate::ik) fn smallest(self) -> f64 {
        self.simd.reduce_min_f64s(self.value)
    }

    /// The sum of the lanes.
    #[inline(always)]
    pub(in crate::ik) fn sum(self) -> f64 {
        self.simd.reduce_sum_f64s(self.value)
    }

    /// The largest lane.
    #[inline(always)]
    pub(in crate::ik) fn largest(self) -> f64 {
        self.simd.reduce_max_f64s(self.value)
    }
}

impl<S: Simd> Mask<S> {
    /// `yes` where the mask holds, `no` elsewhere.
    #[inline(always)]
    pub(in crate::ik) fn pick(self, yes: Lane<S>, no: Lane<S>) -> Lane<S> {
        let value = self.simd.select_f64s(self.value, yes.value, no.value);
        Lane { value, ..yes }
    }

    #[inline(always)]
    pub(in crate::ik) fn pick_turn(self, yes: Turn<S>, no: Turn<S>) -> Turn<S> {
        Turn {
            cos: self.pick(yes.cos, no.cos),
            sin: self.pick(yes.sin, no.sin),
        }
    }

    #[inline(always)]
    pub(in crate::ik) fn or(self, other: Self) -> Self {
        let value = self.simd.or_m64s(self.value, other.value);
        Self { value, ..self }
    }

    /// Where it holds and the other does not.
    #[inline(always)]
    pub(in crate::ik) fn and_not(self, other: Self) -> Self {
        let value = self
            .simd
            .and_m64s(self.value, self.simd.not_m64s(other.value));
        Self { value, ..self }
    }

    /// Whether it holds in some lane.
    #[inline(always)]
    pub(in crate::ik) fn any(self) -> bool {
        let (one, zero) = (Lane::splat(self.simd, 1.0), Lane::splat(self.simd, 0.0));
        self.pick(one, zero).largest() > 0.0
    }

    #[inline(always)]
    pub(in crate::ik) fn and(self, other: Self) -> Self {
        let value = self.simd.and_m64s(self.value, other.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Add for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let value = self.simd.add_f64s(self.value, other.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Sub for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let value = self.simd.sub_f64s(self.value, other.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Mul for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let value = self.simd.mul_f64s(self.value, other.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Div for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.simd.div_f64s(self.value, other.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Neg for Lane<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let value = negative(self.simd, self.value);
        Self { value, ..self }
    }
}

impl<S: Simd> Turn<S> {
    /// The turn with this direction of (cosine, sine); any length above rounding, otherwise none.
    #[inline(always)]
    pub(in crate::ik) fn along(cos: Lane<S>, sin: Lane<S>) -> Self {
        let square = cos.mul_add(cos, sin * sin);
        let usable = cos.constant(f64::MIN_POSITIVE).less(square);
        let (one, zero) = (cos.constant(1.0), cos.constant(0.0));
        let inverse = one / usable.pick(square, one).sqrt();
        Self {
            cos: usable.pick(cos * inverse, one),
            sin: usable.pick(sin * inverse, zero),
        }
    }

    #[inline(always)]
    pub(in crate::ik) fn reversed(self) -> Self {
        Self {
            sin: -self.sin,
            ..self
        }
    }

    /// A sliding joint is at the value that is kept in place of the sine.
    #[inline(always)]
    pub(in crate::ik) fn slid(at: Lane<S>) -> Self {
        Self {
            cos: at.constant(1.0),
            sin: at,
        }
    }

    /// Moved on by `by`, whatever kind of joint it is.
    #[inline(always)]
    pub(in crate::ik) fn moved(self, by: Lane<S>, slides: bool) -> Self {
        if slides {
            Self::slid(self.sin + by)
        } else {
            self.advanced(by)
        }
    }

    /// A point moved about z, or along it.
    #[inline(always)]
    pub(in crate::ik) fn carry(self, p: Vector<S>, slides: bool) -> Vector<S> {
        if slides {
            [p[0], p[1], p[2] + self.sin]
        } else {
            self.about_z(p)
        }
    }

    /// A direction turned about z, if the joint turns.
    #[inline(always)]
    pub(in crate::ik) fn rotate(self, v: Vector<S>, slides: bool) -> Vector<S> {
        if slides { v } else { self.about_z(v) }
    }

    /// Turned on by `by` radians, to fifth order in it: Newton's steps need no more, and no division.
    #[inline(always)]
    pub(in crate::ik) fn advanced(self, by: Lane<S>) -> Self {
        let square = by * by;
        let cos = square.mul_add(by.constant(1.0 / 24.0), by.constant(-0.5));
        let cos = square.mul_add(cos, by.constant(1.0));
        let sin = square.mul_add(by.constant(1.0 / 120.0), by.constant(-1.0 / 6.0));
        let sin = (square * by).mul_add(sin, by);
        Self {
            cos: self.sin.subtract_product(sin, self.cos * cos),
            sin: self.sin.mul_add(cos, self.cos * sin),
        }
        .tightened()
    }

    /// One Newton step towards unit length.
    #[inline(always)]
    pub(in crate::ik) fn tightened(self) -> Self {
        let square = self.cos.mul_add(self.cos, self.sin * self.sin);
        let half = square.constant(0.5);
        let scale = half.subtract_product(square, square.constant(1.5));
        Self {
            cos: self.cos * scale,
            sin: self.sin * scale,
        }
    }

    /// `v` turned about z.
    #[inline(always)]
    pub(in crate::ik) fn about_z(self, v: Vector<S>) -> Vector<S> {
        [
            self.sin.subtract_product(v[1], self.cos * v[0]),
            self.sin.mul_add(v[0], self.cos * v[1]),
            v[2],
        ]
    }
}

#[inline(always)]
pub(in crate::ik) fn dot<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> Lane<S> {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

#[inline(always)]
pub(in crate::ik) fn cross<S: Simd>(a: &Vector<S>, b: &Vector<S>) -> Vector<S> {
    [
        a[2].subtract_product(b[1], a[1] * b[2]),
        a[0].subtract_product(b[2], a[2] * b[0]),
        a[1].subtract_product(b[0], a[0] * b[1]),
    ]
}

/// A constant rigid motion as plain numbers, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::ik) struct Rigid {
    pub(in crate::ik) rotation: [[f64; 3]; 3],
    pub(in crate::ik) shift: [f64; 3],
}

impl Rigid {
    pub(in crate::ik) fn of(pose: &crate::spatial::Pose) -> Self {
        let (m, t) = (pose.rotation.matrix(), &pose.translation.vector);
        let row = |i: usize| [m[(i, 0)], m[(i, 1)], m[(i, 2)]];
        Self {
            rotation: [row(0), row(1), row(2)],
            shift: [t.x, t.y, t.z],
        }
    }

    #[inline(always)]
    pub(in crate::ik) fn column(&self, j: usize) -> [f64; 3] {
        let [x, y, z] = &self.rotation;
        [x[j], y[j], z[j]]
    }

    /// The shift, seen from behind the rotation.
    #[inline(always)]
    pub(in crate::ik) fn unrotated_shift(&self) -> [f64; 3] {
        let (rotation, t) = (&self.rotation, &self.shift);
        let mut out = [0.0; 3];
        for j in 0..3 {
            out[j] = rotation[0][j] * t[0] + rotation[1][j] * t[1] + rotation[2][j] * t[2];
        }
        out
    }

    /// The rotation of a direction in lanes.
    #[inline(always)]
    pub(in crate::ik) fn rotate<S: Simd>(&self, v: &Vector<S>) -> Vector<S> {
        let [x, y, z] = &self.rotation;
        [along(x, v), along(y, v), along(z, v)]
    }

    /// A point in lanes, moved.
    #[inline(always)]
    pub(in crate::ik) fn carry<S: Simd>(&self, p: &Vector<S>) -> Vector<S> {
        let turned = self.rotate(p);
        [
            turned[0] + p[0].constant(self.shift[0]),
            turned[1] + p[0].constant(self.shift[1]),
            turned[2] + p[0].constant(self.shift[2]),
        ]
    }
}

/// A constant vector in lanes.
#[inline(always)]
pub(in crate::ik) fn constant<S: Simd>(simd: S, v: [f64; 3]) -> Vector<S> {
    [
        Lane::splat(simd, v[0]),
        Lane::splat(simd, v[1]),
        Lane::splat(simd, v[2]),
    ]
}

/// The component of a vector along a constant one.
#[inline(always)]
pub(in crate::ik) fn along<S: Simd>(by: &[f64; 3], v: &Vector<S>) -> Lane<S> {
    let [x, y, z] = constant(v[0].simd, *by);
    z.mul_add(v[2], y.mul_add(v[1], x * v[0]))
}

/// A vector times a number.
#[inline(always)]
pub(in crate::ik) fn scaled<S: Simd>(v: &Vector<S>, by: Lane<S>) -> Vector<S> {
    [v[0] * by, v[1] * by, v[2] * by]
}

/// `yes` where the mask holds, `no` elsewhere.
#[inline(always)]
pub(in crate::ik) fn pick<S: Simd, const N: usize>(
    mask: Mask<S>,
    yes: &[Lane<S>; N],
    no: &[Lane<S>; N],
) -> [Lane<S>; N] {
    let mut out = *no;
    for k in 0..N {
        out[k] = mask.pick(yes[k], no[k]);
    }
    out
}

/// The sum of squares.
#[inline(always)]
pub(in crate::ik) fn square<S: Simd, const N: usize>(v: &[Lane<S>; N]) -> Lane<S> {
    let mut sum = v[0] * v[0];
    for k in 1..N {
        sum = v[k].mul_add(v[k], sum);
    }
    sum
}
