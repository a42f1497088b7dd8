//! Formula to number.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::{Expr, Function, Operator, Unit};
use crate::error::{Error, Result};
use crate::spatial;

/// Symbols with their values, metres and radians.
pub type Values = BTreeMap<String, f64>;

impl Unit {
    /// `value` of this unit in metres, radians or as it is.
    fn in_si(self, value: f64) -> f64 {
        match self {
            Self::None | Self::Metre | Self::Radian => value,
            // Division by a power of ten rounds once; multiplication by its inexact reciprocal would round twice.
            Self::Centimetre => value / 100.0,
            Self::Millimetre => value / 1000.0,
            Self::Degree => spatial::snap(value.to_radians()),
        }
    }
}

impl Expr {
    /// The number the formula stands for.
    ///
    /// # Errors
    /// A missing-value error that names every symbol without a value; an input error if the result is not finite.
    pub fn evaluate(&self, values: &Values) -> Result<f64> {
        let missing: Vec<_> = self
            .symbols()
            .into_iter()
            .filter(|name| !values.contains_key(*name))
            .collect();
        if !missing.is_empty() {
            let text = format!("{} has no value", missing.join(", "));
            return Err(Error::missing_value(format!("\"{self}\""), text));
        }
        let value = self.value(values);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Error::input(
                format!("\"{self}\""),
                format!("its value is {value}"),
            ))
        }
    }

    fn value(&self, values: &Values) -> f64 {
        match self {
            Self::Number(value, unit) => unit.in_si(*value),
            Self::Pi => PI,
            Self::Symbol(name) => values.get(name).copied().unwrap_or(f64::NAN),
            Self::Neg(inner) => -inner.value(values),
            Self::Binary(operator, left, right) => {
                operator.apply(left.value(values), right.value(values))
            }
            Self::Call(function, arguments) => {
                let mut numbers = arguments.iter().map(|argument| argument.value(values));
                let x = numbers.next().unwrap_or(f64::NAN);
                function.apply(x, numbers.next().unwrap_or(f64::NAN))
            }
        }
    }
}

impl Operator {
    fn apply(self, left: f64, right: f64) -> f64 {
        match self {
            Self::Add => left + right,
            Self::Sub => left - right,
            Self::Mul => left * right,
            Self::Div => left / right,
            Self::Pow => left.powf(right),
        }
    }
}

impl Function {
    fn apply(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Sqrt => x.sqrt(),
            Self::Sin => spatial::sin_cos_exact(x).0,
            Self::Cos => spatial::sin_cos_exact(x).1,
            Self::Tan => x.tan(),
            Self::Asin => x.asin(),
            Self::Acos => x.acos(),
            Self::Atan => x.atan(),
            Self::Atan2 => x.atan2(y),
            Self::Abs => x.abs(),
            Self::Hypot => x.hypot(y),
        }
    }
}
