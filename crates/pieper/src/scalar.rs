//! The number types a kinematic kernel accepts.
//!
//! A closed list: `f64`, `f32`, the SIMD lanes of the batches, dual numbers for exact derivatives, and the
//! expressions of `pieper-symbolic`. A kernel written once against [`Scalar`] gives numbers, derivatives and formulas.

mod dual;

use std::ops::{Add, Mul, Neg, Sub};

pub use dual::Dual;

/// A number a kinematic kernel can compute with: a commutative ring.
///
/// ```
/// use pieper::scalar::Scalar;
/// fn square_plus_one<S: Scalar>(x: S) -> S {
///     let one = x.constant(1.0);
///     x.clone().mul_add(x, one)
/// }
/// assert_eq!(square_plus_one(3.0), 10.0);
/// ```
pub trait Scalar:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The constant `value`, of the same kind as `self` (lanes know their width, expressions their table).
    fn constant(&self, value: f64) -> Self;

    /// `self * factor + addend`, in one rounding where that is cheap.
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
}

/// A scalar that has a sine and a cosine.
pub trait Trigonometric: Scalar {
    /// Sine and cosine.
    fn sin_cos(&self) -> (Self, Self);
}

macro_rules! float {
    ($($float:ident),*) => { $(
        impl Scalar for $float {
            #[inline(always)]
            fn constant(&self, value: f64) -> Self {
                value as $float
            }
        }

        impl Trigonometric for $float {
            fn sin_cos(&self) -> (Self, Self) {
                $float::sin_cos(*self)
            }
        }
    )* };
}

float!(f64, f32);
