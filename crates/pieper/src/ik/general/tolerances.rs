//! Every threshold of the general solver, and its reason.
//!
//! Lengths are scaled: the distances between the arm's axes add up to 3.

/// See the fields.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerances {
    /// A sample whose pivots differ by more than this loses so many digits that other shifts are tried.
    pub(super) pivot_ratio: f64,
    /// The same for twice the digits.
    pub(super) precise_pivot_ratio: f64,
    /// Radians. On an interval this short, an extremum is sought where there are two sign changes. Not shorter: a complex
    /// pair leaves no sign changes on intervals of the size of its imaginary part.
    pub(super) pair_width: f64,
    /// Radians. On an interval this short there is one extremum only.
    pub(super) short: f64,
    /// Radians. No interval is cut further: the noise of the coefficients moves close roots by as much.
    pub(super) least_width: f64,
    /// Radians. How far the roots of a pair may be from the top of their parabola, by all that noise allows: farther apart, they are
    /// no two that something takes for one.
    pub(super) beside: f64,
    /// Radians. A complex pair with a smaller imaginary part may be two real roots in truth.
    pub(super) near_miss: f64,
    /// Times the noise of a coefficient: where the polynomial is smaller, its sign means nothing.
    pub(super) drowned: f64,
    /// The same for what is above the noise without any doubt: the noise is measured, and now and then it is more than what shows.
    pub(super) clear: f64,
    /// Relative to the largest coefficient: an elimination with more noise is not believed alone.
    pub(super) believed: f64,
    /// The same for one of which nothing is close to its noise.
    pub(super) believed_clear: f64,
    /// Radians. Where the noise may move a root by more, it may hide others.
    pub(super) shaky: f64,
    /// The same for an equation without elimination, whose noise is small.
    pub(super) shaky_equation: f64,
    /// Radians. A larger step towards the root of det S is noise.
    pub(super) refine_step: f64,
    /// The second singular value of P over the first, below which two roots are so close that their null vectors mix.
    pub(super) twins: f64,
    /// Radians. Where a solution's angle is farther from the root of the polynomial that led to it, perturbation or noise
    /// has moved roots by more than the distance of close ones.
    pub(super) moved: f64,
    /// A larger error after the first Newton steps is no root.
    pub(super) hopeless: f64,
    /// Radians, all joints together: the longest Newton step.
    pub(super) newton_step: f64,
    /// The error of a pose below which rounding rules.
    pub(super) rounding: f64,
    /// An error below which a step that does not halve it is the last one. More, and beside a fold a root would stop short.
    pub(super) done: f64,
    /// The largest error of an accepted root: quadratic convergence leaves nothing between this and rounding, but
    /// at singularities it stalls.
    pub(super) closes: f64,
    /// An error that any copy of a root should have.
    pub(super) closes_well: f64,
    /// Two roots whose joints differ by less, in sines and cosines, are one.
    pub(super) same: f64,
    /// Solutions, or tops of folds, whose joints differ by less, in sines and cosines, are of the same fold.
    pub(super) same_fold: f64,
    /// Smallest singular value below which roots may be double: their number then says nothing.
    pub(super) doubles: f64,
    /// What rounding does to a pose: over sigma, it is how far copies of a singular root lie apart.
    pub(super) scatter: f64,
    /// Copies are never farther apart than this, in sines and cosines.
    pub(super) most_scatter: f64,
    /// Smallest singular value below which the joints of two copies differ by more than `same`, and siblings are sought.
    pub(super) singular: f64,
}

/// The one set in use.
pub(super) const TOLERANCES: Tolerances = Tolerances {
    pivot_ratio: 1e-3,
    precise_pivot_ratio: 1e-12,
    pair_width: 0.1,
    short: 0.025,
    least_width: 2e-4,
    beside: 3e-3,
    near_miss: 0.03,
    drowned: 10.0,
    clear: 1e4,
    believed: 1e-13,
    believed_clear: 1e-10,
    shaky: 0.01,
    shaky_equation: 1e-6,
    refine_step: 0.02,
    twins: 1e-3,
    moved: 1e-3,
    hopeless: 0.3,
    newton_step: 0.5,
    rounding: 2e-15,
    done: 1e-14,
    closes: 1e-10,
    closes_well: 1e-12,
    same: 1e-7,
    same_fold: 1e-4,
    scatter: 1e-14,
    most_scatter: 1e-6,
    doubles: 1e-7,
    singular: 2e-3,
};
