//! Values as people type them.

use super::{Expr, Values};
use crate::error::{Error, Result};

/// A number as people type it, in radians or metres: `0.5`, `90deg`, `90°`, `pi/2`, `250mm`, `0,5`.
///
/// ```
/// use pieper::describe::expr::typed;
/// assert_eq!(typed("250mm")?, 0.25);
/// assert_eq!(typed("-90deg")?, -std::f64::consts::FRAC_PI_2);
/// assert!(typed("12 parsec").is_err());
/// # Ok::<(), pieper::Error>(())
/// ```
///
/// # Errors
/// An input error that quotes the text and says what was expected.
pub fn typed(text: &str) -> Result<f64> {
    let plain = text.trim().replace('°', " deg").replace(',', ".");
    let read = Expr::parse(&spaced(&plain)).and_then(|expr| expr.evaluate(&Values::new()));
    read.map_err(|_| {
        let words = "a number was expected, as 0.5, 90deg, pi/2 or 250mm";
        Error::input(format!("\"{}\"", text.trim()), words)
    })
}

/// `90deg` as `90 deg`.
fn spaced(text: &str) -> String {
    let mut out = String::new();
    let mut digit = false;
    for c in text.chars() {
        if digit && c.is_ascii_alphabetic() && !matches!(c, 'e' | 'E') {
            out.push(' ');
        }
        digit = c.is_ascii_digit() || c == '.';
        out.push(c);
    }
    out
}
