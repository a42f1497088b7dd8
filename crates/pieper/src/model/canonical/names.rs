//! Twists by right angles as exchanged names of axes.

use super::{LinkShape, Step};
use crate::spatial::Quarters;

/// Which of two stored columns are a frame's axes y and z.
///
/// A twist about x by right angles moves neither: it changes what the columns are called, and their signs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Names {
    /// The stored columns are exchanged.
    pub(crate) swapped: bool,
    /// The signs of y and of z.
    pub(crate) signs: [f64; 2],
}

impl Names {
    const PLAIN: Self = Self {
        swapped: false,
        signs: [1.0; 2],
    };

    /// The names behind a twist about x.
    #[inline(always)]
    pub(crate) fn twisted(self, quarters: Quarters) -> Self {
        let [y, z] = self.signs;
        let (swap, signs) = match quarters {
            Quarters::None => (false, [y, z]),
            Quarters::Plus => (true, [z, -y]),
            Quarters::Minus => (true, [-z, y]),
            Quarters::Half => (false, [-y, -z]),
        };
        Self {
            swapped: self.swapped != swap,
            signs,
        }
    }

    /// The names in front of steps, such that they are plain behind them or in front of the first that is no row.
    pub(crate) fn before(steps: &[Step]) -> Self {
        let rows = steps.iter().map_while(StepRow::of).count();
        let twists = steps[..rows].iter().rev().filter_map(StepRow::of);
        twists.fold(Self::PLAIN, |names, row| {
            names.twisted(match row.quarters {
                Quarters::Plus => Quarters::Minus,
                Quarters::Minus => Quarters::Plus,
                same => same,
            })
        })
    }
}

/// A link that is `Tz(d) Tx(a) Rx(quarters)` behind a joint that turns: most links of most arms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepRow {
    pub(crate) d: f64,
    pub(crate) a: f64,
    pub(crate) quarters: Quarters,
}

impl StepRow {
    #[inline(always)]
    pub(crate) fn of(step: &Step) -> Option<Self> {
        match step.link {
            LinkShape::Dh {
                theta: None,
                d,
                a,
                quarters: Some(quarters),
                ..
            } if step.turns => Some(Self { d, a, quarters }),
            _ => None,
        }
    }
}
