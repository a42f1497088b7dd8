//! Angles as solvers need them.

use std::f64::consts::{PI, TAU};

use crate::model::Chain;

/// An angle in (-pi, pi]; what differs from -pi by rounding alone is pi.
#[inline]
pub(super) fn wrap(angle: f64) -> f64 {
    let wrapped = if angle.abs() <= PI {
        angle
    } else {
        angle - TAU * (angle / TAU).round()
    };
    if wrapped <= -PI + 4.0 * f64::EPSILON {
        PI
    } else {
        wrapped
    }
}

/// The angle that turns the plane vector `from` onto the direction of `to`.
#[inline]
pub(super) fn between(from: [f64; 2], to: [f64; 2]) -> f64 {
    let cross = from[0] * to[1] - from[1] * to[0];
    let dot = from[0] * to[0] + from[1] * to[1];
    cross.atan2(dot)
}

/// Sine and cosine of [`between`], without computing the angle.
#[inline]
pub(super) fn turn_between(from: [f64; 2], to: [f64; 2]) -> (f64, f64) {
    let cross = from[0] * to[1] - from[1] * to[0];
    let dot = from[0] * to[0] + from[1] * to[1];
    unit((cross, dot))
}

/// The length of a plane vector. Those of arms are far from where squares overflow.
#[inline]
pub(super) fn length(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// The pair divided by its length.
#[inline]
pub(super) fn unit((sin, cos): (f64, f64)) -> (f64, f64) {
    let by = 1.0 / (sin * sin + cos * cos).sqrt();
    (sin * by, cos * by)
}

/// Sine and cosine of the difference of two angles.
#[inline]
pub(super) fn back((sin, cos): (f64, f64), (s, c): (f64, f64)) -> (f64, f64) {
    (sin * c - cos * s, cos * c + sin * s)
}

/// Sine and cosine of the sum of two angles.
#[inline]
pub(super) fn forth((sin, cos): (f64, f64), (s, c): (f64, f64)) -> (f64, f64) {
    (sin * c + cos * s, cos * c - sin * s)
}

/// `v` turned by the angle with this sine and cosine.
#[inline]
pub(super) fn turned(v: [f64; 2], (sin, cos): (f64, f64)) -> [f64; 2] {
    [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1]]
}

/// Roots of `square = x^2` around zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Roots {
    /// `+x` and `-x`; one of them where both are zero; 0 between them where they are only starts.
    pub(super) values: [f64; 3],
    pub(super) len: usize,
    /// The two are so close that rounding may have split or merged them.
    pub(super) edge: bool,
}

impl Roots {
    /// Both roots of a dimensionless square; none if it is clearly negative.
    ///
    /// `slack` is how far the arm misses its class: a square that is negative by less may be positive on the true
    /// model, so two starts are given for Newton's method to separate.
    #[inline]
    pub(super) fn of(square: f64, slack: f64) -> Self {
        let none = Self {
            values: [0.0; 3],
            len: 0,
            edge: true,
        };
        let allowed = super::TOLERANCES.boundary.max(SLACK_REACH * slack);
        if square > allowed {
            let root = square.sqrt();
            return Self {
                values: [root, -root, 0.0],
                len: 2,
                edge: square < EDGE,
            };
        }
        if square.is_nan() || square < -allowed {
            return none;
        }
        if slack > 0.0 {
            let root = square.max(SLACK_REACH * slack).sqrt();
            return Self {
                values: [root, -root, 0.0],
                len: 3,
                edge: true,
            };
        }
        if square <= 0.0 {
            return Self { len: 1, ..none };
        }
        let root = square.sqrt();
        Self {
            values: [root, -root, 0.0],
            len: 2,
            edge: true,
        }
    }

    #[inline]
    pub(super) fn iter(&self) -> impl Iterator<Item = f64> {
        self.values.into_iter().take(self.len)
    }
}

/// Relative squares below this come from root pairs closer than 3e-4 rad: worth a look whether they are one.
pub(super) const EDGE: f64 = 1e-8;

/// Where a root pair is closer than [`EDGE`], a closed form tells whether it is one root, as long as nothing else is as close
/// to a singularity as this: in radians, or relative to the lengths at hand.
pub(super) const AWAY: f64 = 1e-4;

/// What the distance that decides is computed from must be determined this well, or its rounding exceeds [`MERGED`].
pub(super) const STEADY: f64 = 0.1;

/// By how much less than a reach, relative, a distance may fall short of it (or exceed it) and both ways to bend be one: half
/// of what counts as rounding.
pub(super) const MERGED: f64 = 0.5 * super::TOLERANCES.rounding;

/// The same where the distance is known better, and both ways to bend are told apart as soon as they can be: a wrist that is nearly
/// straight makes much of a small turn of the elbow.
pub(super) const ONE: f64 = super::TOLERANCES.one;

/// A miss of the class by `s` moves a dimensionless square by a few `s`.
const SLACK_REACH: f64 = 16.0;

/// All `x` with `a cos x + b sin x = c`: two, or one where they merge, and by how much `c` is too large if none.
#[inline]
pub(super) fn solve_linear(a: f64, b: f64, c: f64, slack: f64) -> LinearRoots {
    let length = length([a, b]);
    let middle = (b / length, a / length);
    let (excess, ratio) = (c.abs() - length, c / length);
    let square = (length - c) * (length + c) / (length * length);
    let roots = Roots::of(square, slack);
    LinearRoots {
        turns: roots.values.map(|root| forth(unit((root, ratio)), middle)),
        len: roots.len,
        edge: roots.edge,
        excess,
        length,
    }
}

/// What [`solve_linear`] finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LinearRoots {
    /// Sines and cosines.
    pub(super) turns: [(f64, f64); 3],
    pub(super) len: usize,
    pub(super) edge: bool,
    /// By how much the right-hand side exceeds what the left can be.
    pub(super) excess: f64,
    /// The amplitude of the left-hand side.
    pub(super) length: f64,
}

/// Whether a whole turn of a variable changes nothing: all that it drives turns, by whole multiples of it.
pub(super) fn is_periodic(chain: &Chain, variable: usize) -> bool {
    let steps = &chain.canonical().steps;
    let mut driven = steps.iter().filter(|step| step.drive.variable == variable);
    chain.variables()[variable].kind.is_angular()
        && driven.all(|step| step.turns && step.drive.factor.fract() == 0.0)
}
