//! Source code of an arm's kinematics, free of dependencies, in five languages.
//!
//! Forward kinematics are the rows' product from tool to base as a graph in which equal parts are one node; parallel
//! axes turn once, by the sum of their angles; one column of the rotation may be the cross product of the others. Of the
//! ways to do it the one with fewest operations is taken. The Jacobian is its formulas as such a graph, or axes and points carried from base
//! to tool where those are fewer operations: an arm whose formulas would fill pages has code all the same. The inverse
//! is the list of steps of [`inverse`](crate::inverse), a loop for each branch, with every solution put back into the
//! forward kinematics before it is returned.

mod emit;
mod forward;
mod graph;
mod helpers;
mod inverse;
mod language;
mod program;
mod self_test;
mod turns;
mod velocity;

use pieper::Result;

use crate::arm::Arm;

pub use forward::operations;
pub use graph::Operations;
pub use language::Language;

/// What to generate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// Forward kinematics.
    Forward,
    /// Forward kinematics and the Jacobian.
    Jacobian,
    /// Forward kinematics and the closed-form inverse.
    Inverse,
    /// All of it.
    All,
}

/// The numbers the code computes with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 32 bits.
    Float,
    /// 64 bits.
    Double,
}

/// Generates the source code. `id` prefixes names where the language has no modules.
///
/// # Errors
/// A model error where the arm has no closed form and one is asked for; an input error for single precision in a
/// language whose numbers are doubles.
///
/// ```
/// use pieper_symbolic::code::{self, Language, Precision, What};
/// use pieper_symbolic::{Arm, Lengths};
/// let robot = pieper_robots::find("ar3").unwrap().robot();
/// let arm = Arm::new(&robot, Lengths::Symbols)?;
/// let source = code::generate(&arm, "ar3", Language::C, What::Forward, Precision::Double)?;
/// assert!(source.contains("void ar3_fk(const double q[6], double T[3][4])"));
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn generate(
    arm: &Arm,
    id: &str,
    language: Language,
    what: What,
    precision: Precision,
) -> Result<String> {
    program::generate(arm, id, language, what, precision)
}
