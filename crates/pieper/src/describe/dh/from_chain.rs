//! Any chain as a Denavit-Hartenberg table.

use std::f64::consts::PI;

use super::{Convention, DhRow, DhTable, FrameExpr, JointExpr, Moves};
use crate::describe::expr::{Expr, Unit};
use crate::error::{Error, Result};
use crate::model::{Chain, JointKind, Variable};
use crate::spatial::{self, Pose};

impl DhTable {
    /// A table with the same tool pose as the chain at every joint vector.
    ///
    /// Base and tool transforms take up what a table cannot say. The frames between are the table's own: a chain
    /// read from a URDF keeps its tool pose, not its link frames. Where neighbouring axes are nearly parallel (angle
    /// below 6 degrees) the common normal is ill-conditioned, and rounding grows by the reciprocal of that angle.
    ///
    /// # Errors
    /// A model error for what a table cannot express: a variable that drives several joints (mimic) or enters with
    /// a factor other than +1 or -1, or neighbouring axes that are parallel only almost (angle below 1e-7 rad).
    pub fn of_chain(chain: &Chain, convention: Convention) -> Result<Self> {
        let steps = chain.canonical().to_rows()?;
        let mut rows: Vec<DhRow> = Vec::with_capacity(chain.dof());
        for (index, step) in steps.rows.iter().enumerate() {
            if step.drive.variable != index || step.drive.factor.abs() != 1.0 {
                let name = &chain.variables()[step.drive.variable].name;
                let text =
                    "a table needs one row for each variable, in order, with factor +1 or -1";
                return Err(Error::model(format!("joint {name}"), text));
            }
            let (theta, d) = if step.turns {
                (step.drive.offset, step.d)
            } else {
                (step.theta, step.d + step.drive.offset)
            };
            rows.push(DhRow {
                theta: angle(theta),
                d: Expr::number(d),
                a: Expr::number(step.a),
                alpha: angle(step.alpha),
                moves: if step.turns { Moves::Theta } else { Moves::D },
                sign: step.drive.factor,
                joint: JointExpr::of_variable(&chain.variables()[index]),
            });
        }
        let (base, mut tool) = (steps.base, steps.tail);
        if convention == Convention::Modified {
            tool = shift_links(&mut rows, &steps.rows) * tool;
        }
        Ok(Self {
            convention,
            rows,
            base: FrameExpr::of_pose(&base),
            tool: FrameExpr::of_pose(&tool),
        })
    }
}

/// Standard rows to modified ones: each takes a and alpha of the row before it. What the last row had is returned.
fn shift_links(rows: &mut [DhRow], steps: &[crate::model::Row]) -> Pose {
    for index in (0..rows.len()).rev() {
        let (a, alpha) = match index.checked_sub(1) {
            Some(before) => (rows[before].a.clone(), rows[before].alpha.clone()),
            None => (Expr::number(0.0), Expr::number(0.0)),
        };
        (rows[index].a, rows[index].alpha) = (a, alpha);
    }
    let last = steps.last().map_or((0.0, 0.0), |step| (step.a, step.alpha));
    spatial::from_xyz_rpy([last.0, 0.0, 0.0], [last.1, 0.0, 0.0])
}

/// An angle as a person writes it: multiples of pi/12 by name, others in radians.
fn angle(value: f64) -> Expr {
    let twelfths = (value * 12.0 / PI).round();
    if twelfths == 0.0 || twelfths.abs() > 24.0 || twelfths * PI / 12.0 != value {
        return Expr::number(value);
    }
    Expr::parse(&fraction_of_pi(twelfths as i64)).unwrap_or_else(|_| Expr::number(value))
}

fn fraction_of_pi(twelfths: i64) -> String {
    let divisor = [12, 6, 4, 3, 2]
        .into_iter()
        .find(|d| twelfths % d == 0)
        .unwrap_or(1);
    let (numerator, denominator) = (twelfths / divisor, 12 / divisor);
    let sign = if numerator < 0 { "-" } else { "" };
    let times = if numerator.abs() == 1 {
        String::new()
    } else {
        format!("{}*", numerator.abs())
    };
    let over = if denominator == 1 {
        String::new()
    } else {
        format!("/{denominator}")
    };
    format!("{sign}{times}pi{over}")
}

impl JointExpr {
    /// A joint of the model, its numbers as a person writes them.
    pub(in crate::describe) fn of_variable(variable: &Variable) -> Self {
        let number = |value: f64| match variable.kind {
            JointKind::Prismatic => Expr::number(value),
            _ => degrees(value),
        };
        Self {
            name: variable.name.clone(),
            limits: variable
                .limits
                .map(|limits| [number(limits.lower()), number(limits.upper())]),
            velocity: variable.velocity.map(number),
            acceleration: variable.acceleration.map(number),
        }
    }
}

/// An angle in degrees where that is a whole number, else in radians.
fn degrees(value: f64) -> Expr {
    let whole = value.to_degrees().round();
    if spatial::snap(whole.to_radians()) != value {
        return Expr::number(value);
    }
    let number = Expr::Number(whole.abs(), Unit::Degree);
    if whole < 0.0 {
        Expr::Neg(Box::new(number))
    } else {
        number
    }
}
