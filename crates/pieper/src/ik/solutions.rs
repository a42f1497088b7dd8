//! What a solver answers.

use std::fmt;

use super::arm::MAX_JOINTS;
use super::reason::Shortfall;

/// A joint vector without a heap, padded with zeros.
pub type JointVector = [f64; MAX_JOINTS];

/// The most isolated solutions of a pose: a chain of six joints that turn has at most 16.
pub const MAX_SOLUTIONS: usize = 16;

/// The most families listed: one for each branch of a closed form.
pub const MAX_FAMILIES: usize = 16;

/// What is known about a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Status {
    /// Finitely many solutions, all listed.
    Solved,
    /// At least one family of infinitely many; isolated solutions are listed too.
    Singular,
    /// More joints than the pose needs: families over the free parameter.
    Redundant,
    /// None; the reason says why, the nearest pose is given.
    Unreachable,
}

impl Status {
    /// The word programs read.
    pub fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Singular => "singular",
            Self::Redundant => "redundant",
            Self::Unreachable => "unreachable",
        }
    }
}

/// On which side of axis 1 the arm works.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the words say it")]
pub enum Shoulder {
    Front,
    Back,
    Left,
    Right,
}

/// How the elbow bends, seen with the arm reaching forward.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the words say it")]
pub enum Elbow {
    Up,
    Down,
}

/// Which way the wrist bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the words say it")]
pub enum Wrist {
    NoFlip,
    Flip,
}

/// The name of a branch: the same words wherever the pose is, as far as the branch exists there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Branch {
    /// Side of axis 1, where the arm has one.
    pub shoulder: Option<Shoulder>,
    /// Bend of the elbow, where the arm has one.
    pub elbow: Option<Elbow>,
    /// Bend of the wrist, where the arm has one.
    pub wrist: Option<Wrist>,
    /// A number where words do not tell branches apart: 1 for the first; 0 for none.
    pub root: u8,
}

impl Branch {
    pub(super) const NONE: Self = Self {
        shoulder: None,
        elbow: None,
        wrist: None,
        root: 0,
    };
}

impl fmt::Display for Branch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shoulder = self.shoulder.map(|shoulder| match shoulder {
            Shoulder::Front => "shoulder-front",
            Shoulder::Back => "shoulder-back",
            Shoulder::Left => "shoulder-left",
            Shoulder::Right => "shoulder-right",
        });
        let elbow = self.elbow.map(|elbow| match elbow {
            Elbow::Up => "elbow-up",
            Elbow::Down => "elbow-down",
        });
        let wrist = self.wrist.map(|wrist| match wrist {
            Wrist::NoFlip => "wrist-noflip",
            Wrist::Flip => "wrist-flip",
        });
        let mut gap = "";
        for word in [shoulder, elbow, wrist].into_iter().flatten() {
            write!(f, "{gap}{word}")?;
            gap = " ";
        }
        match (self.root, gap) {
            (0, "") => f.write_str("only"),
            (0, _) => Ok(()),
            (root, _) => write!(f, "{gap}root-{root}"),
        }
    }
}

/// One isolated solution, verified on the true model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    pub(super) q: JointVector,
    pub(super) dof: u8,
    /// The largest absolute entry of FK(q) - pose, measured.
    pub residual: f64,
    /// Its name.
    pub branch: Branch,
    /// How many roots merge here.
    pub multiplicity: u8,
    /// Whether every value, as listed, lies within its joint's limits.
    pub within_limits: bool,
}

impl Solution {
    /// The joint values; angles in (-pi, pi].
    pub fn q(&self) -> &[f64] {
        &self.q[..usize::from(self.dof)]
    }

    pub(super) const EMPTY: Self = Self {
        q: [0.0; MAX_JOINTS],
        dof: 0,
        residual: 0.0,
        branch: Branch::NONE,
        multiplicity: 0,
        within_limits: false,
    };
}

/// A curve of solutions: one member and the direction in which it goes on there.
///
/// Where more than one joint is free beyond what the pose needs, solutions fill surfaces: then one family is listed, with
/// one of its directions, for all of them.
///
/// [`Solver::samples`](super::Solver::samples) follows the curve; [`Solver::nearest_member`](super::Solver::nearest_member)
/// finds its point closest to given joint values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Family {
    pub(super) member: JointVector,
    /// The member as the joint vector of the arm at work.
    pub(super) at: JointVector,
    /// Of the arm at work, in the units of the columns, to follow the curve by.
    pub(super) heading: JointVector,
    /// In radians and metres.
    pub(super) free: JointVector,
    pub(super) dof: u8,
    /// The member's residual, measured.
    pub residual: f64,
    /// The member's branch.
    pub branch: Branch,
}

impl Family {
    /// A member.
    pub fn q(&self) -> &[f64] {
        &self.member[..usize::from(self.dof)]
    }

    /// The unit direction in joint space in which the family goes on at the member.
    pub fn free(&self) -> &[f64] {
        &self.free[..usize::from(self.dof)]
    }

    pub(super) const EMPTY: Self = Self {
        member: [0.0; MAX_JOINTS],
        at: [0.0; MAX_JOINTS],
        heading: [0.0; MAX_JOINTS],
        free: [0.0; MAX_JOINTS],
        dof: 0,
        residual: 0.0,
        branch: Solution::EMPTY.branch,
    };
}

/// The joint values that come closest to a pose which cannot be reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    pub(super) q: JointVector,
    pub(super) dof: u8,
    /// Distance of the tool point from the pose's, metres.
    pub position_error: f64,
    /// Angle between the orientations, radians.
    pub orientation_error: f64,
}

impl Nearest {
    /// The joint values.
    pub fn q(&self) -> &[f64] {
        &self.q[..usize::from(self.dof)]
    }
}

/// Everything a solver found for one pose. Fixed capacity, no heap; reusable.
#[derive(Clone, Debug)]
pub struct Solutions {
    pub(super) status: Status,
    pub(super) list: [Solution; MAX_SOLUTIONS],
    pub(super) len: usize,
    pub(super) families: [Family; MAX_FAMILIES],
    pub(super) family_count: usize,
    pub(super) reason: Option<Shortfall>,
    pub(super) nearest: Option<Nearest>,
}

impl Default for Solutions {
    fn default() -> Self {
        Self {
            status: Status::Unreachable,
            list: [Solution::EMPTY; MAX_SOLUTIONS],
            len: 0,
            families: [Family::EMPTY; MAX_FAMILIES],
            family_count: 0,
            reason: None,
            nearest: None,
        }
    }
}

impl Solutions {
    /// What is known.
    pub fn status(&self) -> Status {
        self.status
    }

    /// The isolated solutions, in the solver's fixed order of branches.
    pub fn iter(&self) -> std::slice::Iter<'_, Solution> {
        self.as_slice().iter()
    }

    /// The isolated solutions.
    pub fn as_slice(&self) -> &[Solution] {
        &self.list[..self.len]
    }

    /// The number of isolated solutions.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is no isolated solution.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The families of infinitely many solutions.
    pub fn families(&self) -> &[Family] {
        &self.families[..self.family_count]
    }

    /// Why the pose is unreachable.
    pub fn reason(&self) -> Option<Shortfall> {
        self.reason
    }

    /// The closest the arm comes to an unreachable pose.
    pub fn nearest(&self) -> Option<&Nearest> {
        self.nearest.as_ref()
    }

    pub(super) fn clear(&mut self) {
        self.status = Status::Unreachable;
        self.len = 0;
        self.family_count = 0;
        self.reason = None;
        self.nearest = None;
    }
}

impl<'a> IntoIterator for &'a Solutions {
    type Item = &'a Solution;
    type IntoIter = std::slice::Iter<'a, Solution>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
