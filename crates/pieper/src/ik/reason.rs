//! Why a pose cannot be reached, in words and numbers.

use std::fmt;

/// The part of a pose that fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The wrist centre lies farther out than the arm reaches.
    WristBeyond,
    /// The wrist centre lies closer to the shoulder than the arm folds.
    WristTooNear,
    /// The wrist centre lies inside the cylinder around axis 1 that the arm's offsets leave out.
    WristInside,
    /// The wrist cannot turn to the tool's direction.
    Orientation,
    /// The tool's offset leaves out a cylinder around an axis.
    Inside,
    /// The elbow is overstretched.
    ElbowBeyond,
    /// The elbow cannot fold so far.
    ElbowTooNear,
    /// The tool's axis must stay parallel to the arm's.
    ToolAxis,
    /// The directions of joints that slide do not reach the point.
    Slides,
    /// The tool's point comes no closer.
    Point,
    /// With the tool's point in place, its axis cannot be turned to the direction.
    Axis,
    /// The tool's axis cannot be turned to the direction.
    Direction,
    /// With the tool's point and axis in place, the turn about the axis is another.
    Spin,
    /// A search found nothing; this is no proof.
    NothingFound,
    /// Roots were proposed, but none of them closes.
    NoneCloses,
}

/// Which part of a pose fails, and by how much: the smallest failure over all branches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortfall {
    /// What fails.
    pub part: Part,
    /// By how much, metres or radians.
    pub amount: f64,
}

impl Part {
    /// Whether the amount is an angle.
    pub fn is_angular(self) -> bool {
        matches!(
            self,
            Self::Orientation | Self::ToolAxis | Self::Axis | Self::Direction | Self::Spin
        )
    }
}

impl Shortfall {
    pub(super) fn new(part: Part, amount: f64) -> Self {
        Self { part, amount }
    }

    /// Whether a row knew that a part fails, but not by how much.
    pub(super) fn is_unmeasured(&self) -> bool {
        self.amount.is_nan() || self.amount <= f64::MIN_POSITIVE
    }
}

impl fmt::Display for Shortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let amount = Amount(self.amount, self.part.is_angular());
        match self.part {
            Part::WristBeyond => write!(f, "wrist centre {amount} beyond the arm's reach"),
            Part::WristTooNear => write!(
                f,
                "wrist centre {amount} nearer to the shoulder than the arm folds"
            ),
            Part::WristInside => write!(
                f,
                "wrist centre {amount} inside the cylinder around axis 1 that the arm cannot enter"
            ),
            Part::Orientation => {
                write!(f, "orientation {amount} beyond what the wrist can turn to")
            }
            Part::Inside => write!(
                f,
                "the pose lies {amount} inside the region around the first axis that the arm's offsets leave out"
            ),
            Part::ElbowBeyond => write!(
                f,
                "the elbow would have to stretch {amount} beyond the arm's reach"
            ),
            Part::ElbowTooNear => write!(
                f,
                "the elbow would have to fold {amount} further than it does"
            ),
            Part::ToolAxis => write!(
                f,
                "the tool's axis is {amount} off the direction that this arm keeps"
            ),
            Part::Slides => write!(
                f,
                "the point lies {amount} off what the sliding joints reach"
            ),
            Part::Point => write!(f, "the tool's point comes no closer than {amount}"),
            Part::Axis => write!(
                f,
                "the tool's axis: {amount} off at best, with the tool's point in place"
            ),
            Part::Direction => write!(f, "the tool's axis: {amount} off at best"),
            Part::Spin => write!(
                f,
                "the turn about the tool's axis: {amount} off at best, with the tool's point and axis in place"
            ),
            Part::NothingFound => write!(
                f,
                "a numeric search found no joint values (no proof that there are none); the nearest pose found is {amount} off"
            ),
            Part::NoneCloses => write!(
                f,
                "no joint values reach the pose; the nearest misses it by {amount}"
            ),
        }
    }
}

/// A length or an angle with its unit.
struct Amount(f64, bool);

impl fmt::Display for Amount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = if self.1 { "rad" } else { "m" };
        if (1e-4..1e6).contains(&self.0.abs()) {
            write!(f, "{:.4} {unit}", self.0)
        } else {
            write!(f, "{:.3e} {unit}", self.0)
        }
    }
}
