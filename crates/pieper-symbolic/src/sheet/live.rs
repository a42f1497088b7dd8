//! A sheet inside another page: its parts alone, with places for the values of its equations.

use super::{Block, Sheet, html};
use crate::arm::Arm;
use crate::form::Form;
use crate::number;

impl Sheet {
    /// The sheet's parts as HTML, without a page around them, styles or scripts: classes alone (`formula`, `wide`, `dh`, `m`).
    ///
    /// Behind each equation stands an empty `<output class="value">`, in the order of [`Sheet::values`].
    pub fn fragment(&self) -> String {
        html::blocks(self, r#" <output class="value"></output>"#)
    }

    /// The values of the right-hand sides of all equations at a joint vector, in order; `None` where one is no number, as a
    /// step of an inverse way.
    ///
    /// `arm` is the one that the sheet was made from. A table's symbols without a value give NaN.
    ///
    /// ```
    /// use pieper_symbolic::{Arm, Lengths, derive};
    /// let robot = pieper_robots::find("cobra600").unwrap().robot();
    /// let arm = Arm::new(&robot, Lengths::Symbols)?;
    /// let sheet = derive::sheet(&arm, derive::Scope::Forward)?;
    /// let values = sheet.values(&arm, &[0.3, -0.4, 0.1, 0.2]);
    /// assert_eq!(values.len(), sheet.fragment().matches("<output").count());
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn values(&self, arm: &Arm, q: &[f64]) -> Vec<Option<f64>> {
        let equations = self.blocks.iter().filter_map(|block| match block {
            Block::Equation(_, right) => Some(right),
            _ => None,
        });
        equations.map(|right| value(right, arm, q)).collect()
    }
}

/// The number that a formula stands for.
fn value(form: &Form, arm: &Arm, q: &[f64]) -> Option<f64> {
    let of = |form: &Form| value(form, arm, q);
    Some(match form {
        Form::Number(number) => number::to_f64(number),
        Form::Var(var) => arm.value_at(*var, q, &|name| arm.parameter(name)),
        Form::Joint(joint) => *q.get(*joint)?,
        Form::Neg(inner) => -of(inner)?,
        Form::Sum(terms) => terms.iter().map(of).sum::<Option<f64>>()?,
        Form::Product(factors) => factors.iter().map(of).product::<Option<f64>>()?,
        Form::Power(base, exponent) => of(base)?.powi(i32::try_from(*exponent).ok()?),
        Form::Quotient(above, below) => of(above)? / of(below)?,
        Form::Root(inner) => of(inner)?.sqrt(),
        Form::Name(_)
        | Form::Entry(..)
        | Form::Inverse(_)
        | Form::Call(..)
        | Form::PlusMinus(..) => return None,
    })
}
