//! Arms without a closed form: one joint taken as known, and the equation for it.

use pieper::{Error, Result};

use super::{Inverse, Source, Step, search};
use crate::arm::Arm;
use crate::poly::Poly;

/// The inverse of an arm whose joints do not follow one by one: with one of them taken as known the others do, and one equation is left
/// that only its right values satisfy. For a wrist whose axis 4 misses the crossing of axes 5 and 6 that is the paper's `phi4 = f(phi4)`.
#[derive(Clone, Debug)]
pub struct OneUnknown {
    /// The joint taken as known, from 0.
    pub joint: usize,
    /// The others.
    pub inverse: Inverse,
    /// After how many of the steps everything in the equation is known.
    pub at: usize,
    /// What is zero where the joint has a right value.
    pub equation: Poly,
    /// Where it comes from.
    pub source: Source,
}

impl OneUnknown {
    /// Finds a joint of which the others follow; the one with the shortest formulas.
    ///
    /// # Errors
    /// A model error where no joint is such a one, or lengths have no values, by which the equation is chosen.
    ///
    /// ```
    /// use pieper_symbolic::{Arm, Lengths, inverse::OneUnknown};
    /// let robot = pieper_robots::find("jaco2").unwrap().robot();
    /// let found = OneUnknown::derive(&Arm::new(&robot, Lengths::Symbols)?)?;
    /// let q = [0.3, -0.7, 1.1, 0.4, -0.9, 0.2];
    /// let pose = pieper::kinematics::tool_pose(&robot.chain()?, &q)?;
    /// // With the right value of the unknown joint the formulas give the others, and the equation leaves nothing.
    /// let (_, left) = found.at(&pose, q[found.joint], 0.0).into_iter()
    ///     .find(|(other, _)| other.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-9)).unwrap();
    /// assert!(left.abs() < 1e-9);
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn derive(arm: &Arm) -> Result<Self> {
        let joints = (0..arm.dof()).filter(|&joint| arm.rows[joint].turns);
        let mut stuck = None;
        let mut best: Option<(usize, Self)> = None;
        for joint in joints {
            match Self::of(arm, joint) {
                Err(error) => stuck = Some(error),
                Ok(found) => {
                    let size = found.size();
                    if best.as_ref().is_none_or(|(least, _)| size < *least) {
                        best = Some((size, found));
                    }
                }
            }
        }
        match (best, stuck) {
            (Some((_, best)), _) => Ok(best),
            (None, Some(error)) => Err(error),
            (None, None) => Err(Error::model(
                arm.title.clone(),
                "it has no joint that turns",
            )),
        }
    }

    /// With this joint as the unknown, and of the equations that are left the one that makes the shortest formulas.
    fn of(arm: &Arm, joint: usize) -> Result<Self> {
        let assumed = search::run_assuming(arm, joint)?;
        let conditions = assumed.conditions.into_iter();
        let found = conditions.filter_map(|(at, source, equation)| {
            let mut found = Self {
                joint,
                inverse: assumed.inverse.clone(),
                at,
                equation,
                source,
            };
            found.decides(&assumed.q).then(|| {
                let used = found.equation.vars();
                found.at = search::drop_unused(&mut found.inverse.steps, used, found.at);
                found
            })
        });
        found.min_by_key(Self::size).ok_or(assumed.stuck)
    }

    /// The number of terms in its formulas.
    fn size(&self) -> usize {
        let terms = |poly: &Poly| poly.terms().len();
        let steps = self.inverse.steps.iter().map(|step| match step {
            Step::Define { quantities, .. } => quantities.iter().map(|(_, poly)| terms(poly)).sum(),
            Step::Joint { rule, .. } => rule.polys().into_iter().map(terms).sum::<usize>(),
        });
        terms(&self.equation) + steps.sum::<usize>()
    }
}
