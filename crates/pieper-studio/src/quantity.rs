//! Values as people type them: `0.5`, `"90deg"`, `"pi/2"`, `"250mm"`.

use pieper::describe::expr;
use serde::{Deserialize, Deserializer, de};
use serde_json::Value;

/// A finite number in radians or metres, from a number or a text with units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity(pub f64);

impl Quantity {
    /// Reads what a person types.
    ///
    /// # Errors
    /// A sentence that quotes the text and says what was expected.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        expr::typed(text)
            .map(Self)
            .map_err(|error| error.to_string())
    }
}

impl<'de> Deserialize<'de> for Quantity {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        match Value::deserialize(from)? {
            Value::Number(number) => match number.as_f64() {
                Some(value) if value.is_finite() => Ok(Self(value)),
                _ => Err(de::Error::custom("a finite number was expected")),
            },
            Value::String(text) => Self::parse(&text).map_err(de::Error::custom),
            other => Err(de::Error::custom(format!(
                "{other}: a number or a text like \"90deg\" was expected"
            ))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Quantity;
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn what_people_type_is_understood() {
        for (text, value) in [
            ("90deg", FRAC_PI_2),
            ("pi/2", FRAC_PI_2),
            (" 250mm ", 0.25),
            ("-1.5", -1.5),
            ("1e-3", 1e-3),
            ("90°", FRAC_PI_2),
            ("0,5", 0.5),
            ("2*45 deg", FRAC_PI_2),
        ] {
            let read = Quantity::parse(text).unwrap().0;
            assert!((read - value).abs() < 1e-15, "{text}: {read}");
        }
        for text in ["", "nan", "1/0", "q1", "12 parsec", "1 2"] {
            assert!(
                Quantity::parse(text).unwrap_err().contains("was expected"),
                "{text}"
            );
        }
    }
}
