//! What a drive cannot do: an answer, not an error.

use std::fmt;

use super::motor::{Motor, MotorKind};
use super::sections::Rest;

/// A drive that cannot reach a joint vector, or a motor value that no joint vector belongs to: which drive, and by how
/// much. An answer to a well-put question; bad input is an [`Error`](crate::Error).
///
/// Prints as a sentence, angles in degrees, with `q1`, `q2`, ... for the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfReach<'a> {
    pub(super) motor: &'a Motor,
    pub(super) quantity: Quantity,
    pub(super) value: f64,
    pub(super) past: f64,
    pub(super) bound: Past,
}

/// Whose value lies too far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The value of the joint with this index.
    Joint(usize),
    /// The motor's own value.
    Motor,
}

/// What the value lies past.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Past {
    /// A dead point of a four-bar linkage.
    DeadPoint(Rest),
    /// A limit of the motor: the end of a servo's window.
    Limit,
}

impl<'a> OutOfReach<'a> {
    /// The drive.
    pub fn motor(&self) -> &'a Motor {
        self.motor
    }

    /// Whose value lies too far: the joint's, or the motor's.
    pub fn quantity(&self) -> Quantity {
        self.quantity
    }

    /// That value.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// By how much it lies past the end, in its own unit; 0 exactly at a dead point, where speeds have no ratio.
    pub fn by(&self) -> f64 {
        self.past.abs()
    }

    /// The end it lies past: of a joint, the copy by whole turns next to its value.
    pub fn end(&self) -> f64 {
        self.value - self.past
    }

    /// What it lies past.
    pub fn bound(&self) -> Past {
        self.bound
    }
}

impl fmt::Display for OutOfReach<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A motor that is driven directly has no limits of its own, so every value here is an angle.
        let deg = |angle: f64| Degrees(angle.to_degrees());
        write!(
            f,
            "motor {} ({}): ",
            self.motor.name(),
            self.motor.kind().name()
        )?;
        match self.quantity {
            Quantity::Joint(index) => write!(f, "q{} = ", index + 1)?,
            Quantity::Motor => write!(f, "its value ")?,
        }
        write!(f, "{} deg ", deg(self.value))?;
        let end = deg(self.end());
        match self.bound {
            Past::Limit => {
                let what = match self.motor.kind() {
                    MotorKind::Servo => "the end of its window",
                    _ => "its limit",
                };
                write!(f, "lies {} deg past {what} at {end} deg", deg(self.by()))
            }
            Past::DeadPoint(rest) if self.past == 0.0 => {
                write!(f, "is a dead point, where {}", rest.in_line())
            }
            Past::DeadPoint(rest) => {
                let by = deg(self.by());
                write!(
                    f,
                    "lies {by} deg past the dead point at {end} deg, where {}",
                    rest.in_line()
                )
            }
        }
    }
}

/// An angle to a hundredth of a degree; less than that, to three digits.
struct Degrees(f64);

impl fmt::Display for Degrees {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.abs() {
            size if size >= 0.01 => write!(f, "{:.2}", self.0),
            0.0 => f.write_str("0"),
            _ => write!(f, "{:.1e}", self.0),
        }
    }
}
