//! Angles of an arm's description: multiples of a right angle are meant exactly.

use std::f64::consts::{FRAC_PI_2, PI};

/// How far a described angle may be from a multiple of a right angle and still mean it: a few roundings of
/// values up to 2 pi; a calibrated angle is never this close by chance.
const SNAP: f64 = 2e-15;

/// `angle`, or the multiple of pi/2 that it stands for.
///
/// ```
/// assert_eq!(pieper::spatial::snap(1.5707963267948970), std::f64::consts::FRAC_PI_2);
/// assert_eq!(pieper::spatial::snap(0.3), 0.3);
/// ```
pub fn snap(angle: f64) -> f64 {
    let turns = (angle / FRAC_PI_2).round();
    let exact = turns * FRAC_PI_2;
    if (angle - exact).abs() <= SNAP * exact.abs().max(1.0) && turns.abs() <= 8.0 {
        exact
    } else {
        angle
    }
}

/// Sine and cosine, exact at multiples of a right angle.
///
/// The nearest double to pi/2 is not pi/2, so `cos` of it is 6e-17 rather than 0. In a model the zero is meant:
/// it keeps tables, formulas and the classification of an arm free of dust.
///
/// ```
/// assert_eq!(pieper::spatial::sin_cos_exact(std::f64::consts::PI), (0.0, -1.0));
/// ```
pub fn sin_cos_exact(angle: f64) -> (f64, f64) {
    if angle.abs() > 9.0 * PI {
        return angle.sin_cos();
    }
    let quarters = (angle / FRAC_PI_2).round();
    if (angle - quarters * FRAC_PI_2).abs() > SNAP * (quarters * FRAC_PI_2).abs().max(1.0) {
        return angle.sin_cos();
    }
    match (quarters as i64).rem_euclid(4) {
        0 => (0.0, 1.0),
        1 => (1.0, 0.0),
        2 => (0.0, -1.0),
        _ => (-1.0, 0.0),
    }
}

/// A turn by a multiple of a right angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quarters {
    /// 0
    None,
    /// +90 degrees
    Plus,
    /// -90 degrees
    Minus,
    /// 180 degrees
    Half,
}

impl Quarters {
    /// The turn with this sine and cosine, if it is a multiple of a right angle to the last bit.
    pub fn of(sin: f64, cos: f64) -> Option<Self> {
        match (sin, cos) {
            (0.0, 1.0) => Some(Self::None),
            (1.0, 0.0) => Some(Self::Plus),
            (-1.0, 0.0) => Some(Self::Minus),
            (0.0, -1.0) => Some(Self::Half),
            _ => None,
        }
    }
}
