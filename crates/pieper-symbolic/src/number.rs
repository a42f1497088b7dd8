//! Exact rational numbers: decimals as a table prints them.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// An exact rational number.
pub type Rational = RBig;

/// Digits a decimal may have: no table prints more, and an exponent of a million would fill the memory.
const MAX_DIGITS: usize = 400;

/// The number a decimal stands for, exactly: `0.0777` is 777/10000.
///
/// `None` for what is no decimal, or has more than 400 digits.
///
/// ```
/// use pieper_symbolic::number;
/// assert_eq!(number::parse("0.25").unwrap(), number::ratio(1, 4));
/// assert_eq!(number::parse("2e-3").unwrap(), number::ratio(1, 500));
/// ```
pub fn parse(text: &str) -> Option<Rational> {
    let (negative, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let shift = i64::from(exponent) - fraction.len() as i64;
    let is_decimal = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if !is_decimal || digits.len() + shift.unsigned_abs() as usize > MAX_DIGITS {
        return None;
    }
    let digits = digits
        .bytes()
        .fold(UBig::ZERO, |sum, byte| sum * 10u8 + UBig::from(byte - b'0'));
    let power = UBig::from(10u8).pow(shift.unsigned_abs() as usize);
    let value = if shift < 0 {
        RBig::from_parts(digits.into(), power)
    } else {
        RBig::from(IBig::from(digits * power))
    };
    Some(if negative { -value } else { value })
}

/// The decimal a float prints as: what a person wrote, not the nearest sum of powers of two.
///
/// `None` for NaN and infinities.
pub fn of_f64(value: f64) -> Option<Rational> {
    value
        .is_finite()
        .then(|| parse(&format!("{value:e}")))
        .flatten()
}

/// A small fraction.
pub fn ratio(numerator: i64, denominator: u64) -> Rational {
    RBig::from_parts(IBig::from(numerator), UBig::from(denominator.max(1)))
}

/// A whole number.
pub fn whole(value: i64) -> Rational {
    RBig::from(IBig::from(value))
}

/// The nearest double.
pub fn to_f64(value: &Rational) -> f64 {
    value.to_f64().value()
}

/// Whether the number is negative.
pub fn is_negative(value: &Rational) -> bool {
    *value < RBig::ZERO
}

/// The absolute value.
pub fn magnitude(value: &Rational) -> Rational {
    if is_negative(value) {
        -value.clone()
    } else {
        value.clone()
    }
}

/// The number as text: a decimal where one is exact and short, a fraction otherwise.
///
/// ```
/// use pieper_symbolic::number;
/// assert_eq!(number::text(&number::ratio(777, 10000)), "0.0777");
/// assert_eq!(number::text(&number::ratio(-1, 3)), "-1/3");
/// assert_eq!(number::text(&number::ratio(1, 2)), "1/2");
/// ```
pub fn text(value: &Rational) -> String {
    match decimal(value) {
        Some(decimal) => decimal,
        None => value.to_string(),
    }
}

/// Small fractions read better as such than as decimals.
const SMALL: u8 = 8;

/// The number as a finite decimal, if it is one and not a small fraction.
fn decimal(value: &Rational) -> Option<String> {
    let denominator = value.denominator();
    if *denominator <= UBig::from(SMALL) {
        return None;
    }
    let (mut rest, mut twos, mut fives) = (denominator.clone(), 0_usize, 0_usize);
    while (&rest % 2u8) == 0 {
        rest /= 2u8;
        twos += 1;
    }
    while (&rest % 5u8) == 0 {
        rest /= 5u8;
        fives += 1;
    }
    let places = twos.max(fives);
    if rest != UBig::ONE || places > 24 {
        return None;
    }
    let scaled = value.clone() * RBig::from(IBig::from(UBig::from(10u8).pow(places)));
    let digits = magnitude(&scaled).numerator().to_string();
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let sign = if is_negative(value) { "-" } else { "" };
    Some(format!("{sign}{whole}.{fraction}"))
}
