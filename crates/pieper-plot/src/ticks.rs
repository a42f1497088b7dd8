//! Round numbers along an axis.

use crate::axes::SMALL;
use crate::font;

/// Round values inside a range, and how they are written.
#[derive(Clone, Debug)]
pub(crate) struct Ticks {
    pub(crate) values: Vec<f64>,
    pub(crate) step: f64,
}

/// How a circle is divided: the steps people expect on an axis of degrees.
const DEGREES: [f64; 9] = [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0];

/// At most `count` round values from `low` to `high`.
pub(crate) fn ticks(low: f64, high: f64, count: usize, unit: &str) -> Ticks {
    let least = (high - low) / count.max(1) as f64;
    let degrees = matches!(unit, "°" | "deg");
    let step = DEGREES
        .into_iter()
        .find(|&step| degrees && step >= least && least > 0.5)
        .unwrap_or_else(|| round_up(least));
    let first = (low / step - 1e-9).ceil();
    let last = (high / step + 1e-9).floor();
    let number = (last - first).clamp(-1.0, 100.0) as i64;
    let values = (0..=number).map(|k| (first + k as f64) * step).collect();
    Ticks { values, step }
}

/// Like [`ticks`], but no more than have room for their labels side by side on a level axis `length`
/// long.
pub(crate) fn level_ticks([low, high]: [f64; 2], count: usize, unit: &str, length: f64) -> Ticks {
    let mut count = count;
    loop {
        let ticks = ticks(low, high, count, unit);
        let room = length * ticks.step / (high - low);
        if count <= 2 || ticks.widest_label() + 12.0 <= room {
            return ticks;
        }
        count -= 1;
    }
}

/// The next number of the form 1, 2 or 5 times a power of ten.
fn round_up(least: f64) -> f64 {
    if !(least > 0.0 && least.is_finite()) {
        return 1.0;
    }
    let power = 10f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|factor| factor * power >= least * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

impl Ticks {
    /// The values' texts: as many digits as the step needs, and a true minus sign.
    pub(crate) fn labels(&self) -> Vec<String> {
        let largest = self
            .values
            .iter()
            .fold(0.0, |size: f64, v| size.max(v.abs()));
        let place = self.step.log10().floor();
        let power = largest >= 1e6 || place < -4.0;
        let write = |value: &f64| {
            if power {
                with_power(*value, place)
            } else {
                let decimals = (-place).max(0.0) as usize;
                minus(&format!("{value:.decimals$}"))
            }
        };
        self.values.iter().map(write).collect()
    }

    /// The width of the widest label.
    pub(crate) fn widest_label(&self) -> f64 {
        let widths = self
            .labels()
            .into_iter()
            .map(|label| font::width(&label, SMALL));
        widths.fold(0.0, f64::max)
    }
}

/// A number as "1.5·10⁻⁶", exact to the decimal place `place` (a power of ten).
fn with_power(value: f64, place: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = (value.abs().log10().floor() - place).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let exponent = exponent.chars().map(|c| match c {
        '-' => '\u{207b}',
        '1' => '\u{b9}',
        '2' => '\u{b2}',
        '3' => '\u{b3}',
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or_default()).unwrap_or(digit),
    });
    format!(
        "{}\u{b7}10{}",
        minus(mantissa),
        exponent.collect::<String>()
    )
}

/// The text of a number with a true minus sign, and without one on zero.
pub(crate) fn minus(text: &str) -> String {
    let zero = !text.chars().any(|c| c.is_ascii_digit() && c != '0');
    match text.strip_prefix('-') {
        Some(digits) if zero => digits.to_owned(),
        _ => text.replace('-', "\u{2212}"),
    }
}

/// The smallest range that holds the values, widened where they are all (nearly) equal.
pub(crate) fn range(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for value in values {
        low = low.min(value);
        high = high.max(value);
    }
    if low > high {
        return [0.0, 1.0];
    }
    let size = low.abs().max(high.abs());
    if high - low > 1e-9 * size && high - low > 1e-300 {
        return [low, high];
    }
    let room = if size > 1e-300 { size * 0.1 } else { 1.0 };
    [low - room, high + room]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_have_the_digits_their_step_needs() {
        let cases: [(f64, f64, usize, &str, &[&str]); 6] = [
            (
                -95.0,
                95.0,
                8,
                "°",
                &["−90", "−60", "−30", "0", "30", "60", "90"],
            ),
            (-95.0, 95.0, 5, "mm", &["−50", "0", "50"]),
            (0.0, 0.5, 5, "", &["0.0", "0.1", "0.2", "0.3", "0.4", "0.5"]),
            (-1.5e-6, 1.5e-6, 3, "", &["−1·10⁻⁶", "0", "1·10⁻⁶"]),
            (0.0, 1.5e7, 3, "", &["0", "5·10⁶", "1.0·10⁷", "1.5·10⁷"]),
            (3.0, 3.0, 3, "", &["3"]),
        ];
        for (low, high, count, unit, expected) in cases {
            assert_eq!(ticks(low, high, count, unit).labels(), expected);
        }
    }
}
