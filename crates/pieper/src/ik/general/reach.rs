//! A cheap bound: how far the last axis can be from the first.

use crate::spatial::Pose;

/// The longest distance between the fixed point on axis 1 and the one on axis 6, scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reach {
    farthest: f64,
}

/// What rounding may add, relative: a stretched arm stays within.
const MARGIN: f64 = 1e-9;

impl Reach {
    /// By the triangle inequality over the links between axis 1 and axis 6; slides reach anywhere.
    pub(super) fn new(links: &[Pose; 5], slides: &[bool; 6]) -> Self {
        if slides.contains(&true) {
            return Self { farthest: f64::MAX };
        }
        let total: f64 = links
            .iter()
            .map(|link| link.translation.vector.norm())
            .sum();
        Self {
            farthest: total * (1.0 + MARGIN),
        }
    }

    /// Whether a target of the last axis is out of reach.
    pub(super) fn excludes(&self, target: &Pose) -> bool {
        // A target that is not finite is out of reach, too.
        let distance = target.translation.vector.norm();
        distance.is_nan() || distance > self.farthest
    }
}
