//! Every threshold of the inverse kinematics, by its reason.

/// Thresholds. Lengths are relative to the arm's size (the sum of the distances between its axes), angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// How far neighbouring axes may miss parallel or meeting and still be solved as such, with every root refined
    /// on the true model. Calibrated arms miss by some 1e-4; Newton's method repairs that in two or three steps.
    pub class: f64,
    /// Misses below this are rounding of the description: a dozen operations on doubles.
    pub exact: f64,
    /// Axes whose relation depends on the pose are taken for meeting or parallel within this, with Newton's
    /// method to make up for it: closer, the general formulas lose as many digits as the special ones.
    pub merely: f64,
    /// An angle is undetermined if a vector that should give it is shorter than this. The vector carries the
    /// rounding of the pose and of up to three matrix products, some 1e-15; roots at 1e-12 must still be told apart.
    pub free: f64,
    /// A residual below this needs no Newton step: the rounding of a pose and of forward kinematics.
    pub rounding: f64,
    /// A residual above this is no solution: the accuracy promised for every regular one.
    pub closes: f64,
    /// A square that should not be negative may be by this much and count as zero: the boundary of the reach, where
    /// rounding of the pose decides between two roots and none. Verification has the last word.
    pub boundary: f64,
    /// Roots closer than this (rad) are looked at: they are one if the point between them is a root as good as `one`.
    pub near: f64,
    /// The residual of a point between two roots below which they are one: what the rounding of a target moves a pose by. Less
    /// than `rounding`: with that, roots a few 1e-6 apart were taken for one.
    pub one: f64,
    /// A value counts as within its limits if it is outside by less (rad or m): rounding of a value at its limit.
    pub limit: f64,
    /// Two roots closer than this (rad or relative length) are the same one, found twice.
    pub same: f64,
}

/// The one policy.
pub const TOLERANCES: Tolerances = Tolerances {
    class: 1e-4,
    exact: 1e-12,
    merely: 1e-9,
    free: 1e-13,
    rounding: 1e-14,
    closes: 1e-12,
    boundary: 1e-11,
    near: 1e-4,
    one: 1e-15,
    limit: 1e-9,
    same: 1e-9,
};
