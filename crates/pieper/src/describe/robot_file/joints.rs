//! The rows of a table, screws, and the frames around them.

use super::fields::{Field, Table};
use crate::describe::dh::{DhRow, FrameExpr, JointExpr, Moves};
use crate::describe::expr::{Expr, Linear};
use crate::describe::screws::Screw;
use crate::error::Result;
use crate::model::JointKind;

/// `[base]` or `[tool]`.
pub(super) fn frame(root: &Table<'_>, name: &str, known: &[&str]) -> Result<FrameExpr> {
    let mut frame = FrameExpr::default();
    let Some(table) = root.table(name)? else {
        return Ok(frame);
    };
    table.allow_only(&["xyz", "rpy"])?;
    if let Some(field) = table.get("xyz") {
        frame.xyz = field.exprs(known)?;
    }
    if let Some(field) = table.get("rpy") {
        frame.rpy = field.exprs(known)?;
    }
    Ok(frame)
}

/// `[[joint]]`
pub(super) fn dh_row(table: &Table<'_>, index: usize, known: &[&str]) -> Result<DhRow> {
    table.allow_only(&[
        "theta",
        "d",
        "a",
        "alpha",
        "name",
        "limits",
        "velocity",
        "acceleration",
    ])?;
    let variable = format!("q{}", index + 1);
    let entry = |name: &str| match table.get(name) {
        None => Ok((Expr::number(0.0), None)),
        Some(field) => variable_entry(&field, &variable, known),
    };
    let fixed = |name: &str| match table.get(name) {
        None => Ok(Expr::number(0.0)),
        Some(field) => field.expr(Some(known)),
    };
    let ((theta, theta_sign), (d, d_sign)) = (entry("theta")?, entry("d")?);
    let (moves, sign) = match (theta_sign, d_sign) {
        (Some(sign), None) => (Moves::Theta, sign),
        (None, Some(sign)) => (Moves::D, sign),
        (None, None) => {
            let text = format!(
                "theta or d was expected to hold the joint variable, as in theta = \"pi/2 + {variable}\""
            );
            return Err(table.error(&text));
        }
        (Some(_), Some(_)) => {
            return Err(table.error(&format!(
                "only one of theta and d can hold {variable}, both do"
            )));
        }
    };
    let joint = joint(table, &variable, known)?;
    Ok(DhRow {
        theta,
        d,
        a: fixed("a")?,
        alpha: fixed("alpha")?,
        moves,
        sign,
        joint,
    })
}

/// An entry that may hold the joint variable: its offset, and the variable's sign if it does.
fn variable_entry(
    field: &Field<'_>,
    variable: &str,
    known: &[&str],
) -> Result<(Expr, Option<f64>)> {
    let mut allowed = known.to_vec();
    let any = field.expr(None)?;
    if !any.symbols().contains(&variable) {
        return Ok((
            field
                .expr(Some(known))
                .map_err(|error| hint_order(error, field, &any, variable))?,
            None,
        ));
    }
    allowed.push(variable);
    let expr = field.expr(Some(&allowed))?;
    let Some(Linear { sign, offset }) = expr.split_at(variable) else {
        return Err(field.error(&format!(
            "\"offset + {variable}\" or \"offset - {variable}\" was expected"
        )));
    };
    Ok((offset, Some(sign)))
}

/// A joint variable of another row gets a message of its own.
fn hint_order(error: crate::Error, field: &Field<'_>, expr: &Expr, variable: &str) -> crate::Error {
    let is_joint = |name: &&str| {
        name.strip_prefix('q')
            .is_some_and(|n| n.parse::<usize>().is_ok())
    };
    match expr.symbols().into_iter().find(|name| is_joint(name)) {
        Some(other) => field.error(&format!(
            "this row's joint variable is {variable}, not {other}"
        )),
        None => error,
    }
}

fn joint(table: &Table<'_>, variable: &str, known: &[&str]) -> Result<JointExpr> {
    let optional = |name: &str| {
        table
            .get(name)
            .map(|field| field.expr(Some(known)))
            .transpose()
    };
    let name = match table.get("name") {
        Some(field) => field.string()?.to_owned(),
        None => variable.to_owned(),
    };
    Ok(JointExpr {
        name,
        limits: table
            .get("limits")
            .map(|field| field.exprs(known))
            .transpose()?,
        velocity: optional("velocity")?,
        acceleration: optional("acceleration")?,
    })
}

/// `[[screws]]`
pub(super) fn screw(table: &Table<'_>, index: usize, known: &[&str]) -> Result<Screw> {
    table.allow_only(&[
        "h",
        "p",
        "theta",
        "d",
        "name",
        "limits",
        "velocity",
        "acceleration",
    ])?;
    let variable = format!("q{}", index + 1);
    let (kind, displacement) = match (table.get("theta"), table.get("d")) {
        (None, None) => (JointKind::Revolute, None),
        (Some(field), None) => (JointKind::Revolute, Some(field)),
        (None, Some(field)) => (JointKind::Prismatic, Some(field)),
        (Some(_), Some(field)) => return Err(field.error("only one of theta and d was expected")),
    };
    let (offset, sign) = match displacement {
        None => (Expr::number(0.0), 1.0),
        Some(field) => match variable_entry(&field, &variable, known)? {
            (offset, Some(sign)) => (offset, sign),
            (_, None) => {
                return Err(field.error(&format!(
                    "the joint variable was expected, as in \"pi/2 + {variable}\""
                )));
            }
        },
    };
    let p = match table.get("p") {
        Some(field) => field.exprs(known)?,
        None => [Expr::number(0.0), Expr::number(0.0), Expr::number(0.0)],
    };
    let h = table
        .require("h", "the axis, as in h = [0, 0, 1]")?
        .exprs(known)?;
    Ok(Screw {
        h,
        p,
        kind,
        sign,
        offset,
        joint: joint(table, &variable, known)?,
    })
}
