//! How a joint gets from one row to the next.

/// The course of a move in time, from one row of a motion to the next.
///
/// With `u` from 0 to 1 the share of the time, a profile gives the share `s(u)` of the way, with `s(0) = 0` and
/// `s(1) = 1`, never falling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// `s = u`: constant rates, which jump at the rows.
    #[default]
    Linear,
    /// `s = 3u^2 - 2u^3`: starts and stops smoothly at every row.
    Cubic,
    /// `s = 10u^3 - 15u^4 + 6u^5`: accelerations start and stop smoothly too.
    Quintic,
    /// A third of the time speeding up, a third at constant rate, a third slowing down.
    Trapezoid,
}

impl Profile {
    /// Every profile, in the order of a listing.
    pub const ALL: [Self; 4] = [Self::Linear, Self::Cubic, Self::Quintic, Self::Trapezoid];

    /// The profile's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Cubic => "cubic",
            Self::Quintic => "quintic",
            Self::Trapezoid => "trapezoid",
        }
    }

    /// The share of the way at the share `u` of the time, and its first and second derivative by `u`.
    ///
    /// ```
    /// use pieper::motion::Profile;
    /// assert_eq!(Profile::Cubic.at(0.5), [0.5, 1.5, 0.0]);
    /// ```
    pub fn at(self, u: f64) -> [f64; 3] {
        let u = u.clamp(0.0, 1.0);
        match self {
            Self::Linear => [u, 1.0, 0.0],
            Self::Cubic => [u * u * (3.0 - 2.0 * u), 6.0 * u * (1.0 - u), 6.0 - 12.0 * u],
            Self::Quintic => {
                let v = u * (1.0 - u);
                [
                    u * u * u * (10.0 + u * (6.0 * u - 15.0)),
                    30.0 * v * v,
                    60.0 * v * (1.0 - 2.0 * u),
                ]
            }
            Self::Trapezoid if u < 1.0 / 3.0 => [2.25 * u * u, 4.5 * u, 4.5],
            Self::Trapezoid if u <= 2.0 / 3.0 => [1.5 * u - 0.25, 1.5, 0.0],
            Self::Trapezoid => {
                let v = 1.0 - u;
                [1.0 - 2.25 * v * v, 4.5 * v, -4.5]
            }
        }
    }

    /// The largest first derivative: how much faster than on average a move gets.
    pub fn peak_rate(self) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Cubic | Self::Trapezoid => 1.5,
            Self::Quintic => 1.875,
        }
    }

    /// The largest second derivative; `None` where rates jump.
    pub fn peak_acceleration(self) -> Option<f64> {
        match self {
            Self::Linear => None,
            Self::Cubic => Some(6.0),
            Self::Quintic => Some(10.0 / 3.0_f64.sqrt()),
            Self::Trapezoid => Some(4.5),
        }
    }
}
