//! The closed loop, and the eight ways to eliminate all of its joints but one.
//!
//! `R1 L1 ... R5 L5 R6 L6 = 1` with `L6` the inverse of the target may be started at any joint and may be inverted.
//! Its joints are called a to f in order, the link behind each `La ... Lf`. Joint f, opposite of the kept joint c,
//! drops out because only the line of its axis is used; a and b are eliminated linearly, d and e by the resultant.

use crate::spatial::Pose;

/// Which link of the loop holds the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    /// Behind joint b.
    B,
    /// Behind joint c.
    C,
    /// Behind joint d.
    D,
    /// Behind joint e.
    E,
}

/// One of the eight eliminations whose linear part depends on the arm alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Case {
    /// The joint that remains, from 0.
    pub(super) kept: usize,
    /// Whether the loop is inverted.
    pub(super) inverted: bool,
    /// Where the target is.
    pub(super) slot: Slot,
}

/// All of them; those that lose fewest roots of general arms first.
pub(super) const CASES: [Case; 8] = {
    const fn case(kept: usize, inverted: bool, slot: Slot) -> Case {
        Case {
            kept,
            inverted,
            slot,
        }
    }
    [
        case(3, false, Slot::E),
        case(2, true, Slot::E),
        case(1, true, Slot::D),
        case(4, false, Slot::D),
        case(0, true, Slot::C),
        case(5, false, Slot::C),
        case(0, false, Slot::B),
        case(5, true, Slot::B),
    ]
};

impl Case {
    /// The joints a to f, from 0.
    pub(super) fn joints(&self) -> [usize; 6] {
        std::array::from_fn(|place| {
            if self.inverted {
                (self.kept + 8 - place) % 6
            } else {
                (self.kept + 4 + place) % 6
            }
        })
    }

    /// The links behind the joints a to f; `links` are those behind joints 1 to 6 of the loop.
    pub(super) fn links(&self, links: &[Pose; 6]) -> [Pose; 6] {
        self.joints().map(|joint| {
            if self.inverted {
                links[(joint + 5) % 6].inverse()
            } else {
                links[joint]
            }
        })
    }

    /// Whether it eliminates an arm of which these joints slide: the kept joint and the one opposite must turn.
    pub(super) fn takes(&self, slides: &[bool; 6]) -> bool {
        !slides[self.kept] && !slides[(self.kept + 3) % 6]
    }

    /// The index of the link that holds the target.
    pub(super) fn place(&self) -> usize {
        match self.slot {
            Slot::B => 1,
            Slot::C => 2,
            Slot::D => 3,
            Slot::E => 4,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_target_is_where_the_case_says() {
        for case in CASES {
            let before = if case.inverted { 0 } else { 5 };
            assert_eq!(case.joints()[case.place()], before);
            assert_eq!(case.joints()[2], case.kept);
        }
    }
}
