//! The closed-form inverse, found by Paul's method: in every product `A_i ... A_j` of rows that are not solved yet, and in
//! the same with a row brought over to the known side, look for an equation with one unknown; solve it; go on.
//!
//! Source: R. P. Paul, *Robot Manipulators* (1981), chapter 3; the squares of a position that take out one of two
//! angles are Pieper's (1968). What comes out is a list of [`Step`]s in the order of computing; a sheet, numbers and code
//! are all made of it.

mod candidates;
mod one_unknown;
mod probe;
mod search;
mod sheet;
mod solve;

use pieper::{Error, Result};

use crate::arm::Arm;
use crate::names::{Names, Var};
use crate::poly::Poly;
use crate::transform::Transform;

pub use one_unknown::OneUnknown;
pub(crate) use sheet::{write, write_one_unknown};
pub use solve::solve;

/// The closed-form inverse of one arm.
#[derive(Clone, Debug)]
pub struct Inverse {
    /// The arm.
    pub arm: Arm,
    /// Names of the arm's quantities, of the target's entries, and of what the steps define.
    pub names: Names,
    /// The symbols of the target's entries: rows of `[n s a p]`.
    pub target: [[Var; 4]; 3],
    /// The steps, in the order of computing.
    pub steps: Vec<Step>,
}

impl Inverse {
    /// The most solutions there can be: two for each branch.
    pub fn most(&self) -> usize {
        let branches = self.steps.iter().filter(|step| {
            matches!(
                step,
                Step::Joint {
                    rule: Rule::Two { .. } | Rule::Square { .. },
                    ..
                }
            )
        });
        1 << branches.count()
    }
}

/// One step of computing.
#[derive(Clone, Debug)]
pub enum Step {
    /// Quantities made of known ones.
    Define {
        /// What they are.
        what: Defined,
        /// The quantities and their formulas.
        quantities: Vec<(Var, Poly)>,
    },
    /// A joint variable.
    Joint {
        /// The joint, from 0.
        joint: usize,
        /// How it is found.
        rule: Rule,
        /// Where its equation comes from.
        source: Source,
    },
}

/// What a step defines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defined {
    /// Entries of the known matrix that equals the product of the rows `first..end`, counted from 0.
    Known {
        /// The first row left.
        first: usize,
        /// The row behind the last one left.
        end: usize,
    },
    /// The origin of the frame before the last row left, seen from the frame before the first: the wrist centre.
    Point {
        /// The first row left.
        first: usize,
        /// The row behind the last one left.
        end: usize,
    },
}

/// How a joint variable is found.
#[derive(Clone, Debug)]
pub enum Rule {
    /// `a cos q + b sin q = k`: two values, `atan2(b, a) +- atan2(sqrt(a^2 + b^2 - k^2), k)`; none if the root is not
    /// real; any if all three vanish.
    Two {
        /// Factor of the cosine.
        a: Poly,
        /// Factor of the sine.
        b: Poly,
        /// Right side.
        k: Poly,
        /// For `cos q = k`: the sine's square from other entries, which keeps its digits where the cosine loses them.
        sine_square: Option<Poly>,
    },
    /// `q = atan2(sin, cos)`, both up to one positive factor; any value if both vanish.
    One {
        /// What the sine is proportional to.
        sin: Poly,
        /// What the cosine is proportional to.
        cos: Poly,
    },
    /// A joint that slides: `q = above / below`.
    Slide {
        /// Numerator.
        above: Poly,
        /// Denominator.
        below: Poly,
    },
    /// A joint that slides: `a q^2 + b q + c = 0`, two values.
    Square {
        /// The coefficients c, b, a.
        coefficients: [Poly; 3],
    },
}

/// Where an equation comes from.
#[derive(Clone, Debug)]
pub struct Source {
    /// Rows whose inverses stand on the left of the known matrix, and on the right of it.
    pub moved: (bool, bool),
    /// The rows that are unknown there, from 0, end excluded.
    pub rows: (usize, usize),
    /// The entries used, row and column from 0.
    pub entries: Vec<(usize, usize)>,
    /// Whether the squares of the entries were added up.
    pub squares: bool,
}

/// Finds the closed-form inverse.
///
/// # Errors
/// A model error that says why there is none, and what exists instead.
///
/// ```
/// use pieper_symbolic::{Arm, Lengths, inverse};
/// let robot = pieper_robots::find("ar3").unwrap().robot();
/// let inverse = inverse::derive(&Arm::new(&robot, Lengths::Symbols)?)?;
/// let pose = pieper::kinematics::tool_pose(&robot.chain()?, &[0.1, 0.9, 0.4, -0.3, 0.8, 0.2])?;
/// // Elbow up or down, wrist flipped or not; over its shoulder the arm does not reach so far.
/// assert_eq!(inverse::solve(&inverse, &pose, 0.0).len(), 4);
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn derive(arm: &Arm) -> Result<Inverse> {
    if arm.dof() > 6 {
        let text = format!(
            "it has {} joints, more than a pose needs: its solutions are families, without one closed form; `pieper ik` \
             finds members of them",
            arm.dof()
        );
        return Err(Error::model(arm.title.clone(), text));
    }
    search::run(arm)
}

/// The known matrix once base and tool are taken off: `B^-1 T E^-1`.
fn without_base_and_tool(arm: &Arm, target: &Transform) -> Transform {
    let left = arm
        .base
        .as_ref()
        .map_or_else(|| target.clone(), |base| base.inverse().times(target));
    arm.tool
        .as_ref()
        .map_or_else(|| left.clone(), |tool| left.times(&tool.inverse()))
}
