//! The two kinds of elimination: by the resultant, or by the orientation alone.

use pulp::Simd;

use super::newton::Goal;
use super::orientation::Orientation;
use super::pool::Pool;
use super::single::{Doubt, Elimination, Target};
use super::tables::Tables;

/// One way from a target to roots.
#[derive(Clone, Debug)]
pub(super) enum Way {
    /// At most one joint slides.
    Resultant(Box<Elimination>),
    /// Two joints slide.
    Orientation(Box<Orientation>),
}

impl Way {
    /// The joint whose angle is the unknown of the polynomial.
    pub(super) fn kept(&self) -> usize {
        match self {
            Self::Resultant(elimination) => elimination.case.kept,
            Self::Orientation(orientation) => orientation.kept(),
        }
    }

    /// Never takes it for evidence enough: for arms that are too special for its noise to tell.
    pub(super) fn disbelieve(&mut self) {
        if let Self::Resultant(elimination) = self {
            elimination.exact = false;
        }
    }

    /// Finds roots and adds them to the pool.
    #[inline(always)]
    pub(super) fn run<S: Simd>(
        &self,
        simd: S,
        tables: &Tables,
        goal: &Goal<'_>,
        target: &Target,
        pool: &mut Pool,
    ) -> Doubt {
        match self {
            Self::Resultant(elimination) => elimination.run(simd, tables, goal, target, pool),
            Self::Orientation(orientation) => orientation.run(simd, tables, goal, target, pool),
        }
    }
}
