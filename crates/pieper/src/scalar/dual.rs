//! Dual numbers: a value and its derivative with respect to one variable.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Scalar, Trigonometric};

/// `value + derivative * epsilon` with `epsilon^2 = 0`: computes a derivative along with the value, exactly.
///
/// ```
/// use pieper::scalar::{Dual, Trigonometric};
/// let x = Dual::variable(0.5);
/// let (sin, _) = (x * x).sin_cos();
/// assert_eq!(sin.derivative, 0.25_f64.cos());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative.
    pub derivative: f64,
}

impl Dual {
    /// A constant: derivative 0.
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            derivative: 0.0,
        }
    }

    /// The variable itself: derivative 1.
    pub fn variable(value: f64) -> Self {
        Self {
            value,
            derivative: 1.0,
        }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            derivative: self.derivative + other.derivative,
        }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            derivative: self.derivative - other.derivative,
        }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            derivative: self.value * other.derivative + self.derivative * other.value,
        }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            derivative: -self.derivative,
        }
    }
}

impl Scalar for Dual {
    fn constant(&self, value: f64) -> Self {
        Self::constant(value)
    }
}

impl Trigonometric for Dual {
    fn sin_cos(&self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (
            Self {
                value: sin,
                derivative: self.derivative * cos,
            },
            Self {
                value: cos,
                derivative: -self.derivative * sin,
            },
        )
    }
}
