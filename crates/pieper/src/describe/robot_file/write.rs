//! A robot as a robot file.

use std::fmt::Write as _;

use super::transmission::half_turn;
use crate::describe::dh::{DhRow, FrameExpr, JointExpr, Moves};
use crate::describe::drives::{AngleExpr, CouplingExpr, GearExpr, MotorExpr};
use crate::describe::expr::{Expr, Unit, with_variable};
use crate::describe::robot::{Form, Robot, Up};
use crate::describe::screws::Screw;
use crate::error::{Error, Result};
use crate::model::JointKind;
use crate::transmission::MotorKind;

impl Robot {
    /// The robot as a robot file, readable by [`Robot::from_toml`] with the same numbers.
    ///
    /// # Errors
    /// A model error for a tree: make a table or screws of its chain first.
    pub fn to_toml(&self) -> Result<String> {
        let mut out = String::new();
        self.write(&mut out)?
            .map_err(|_| Error::model("robot", "out of memory"))?;
        Ok(out)
    }

    fn write(&self, out: &mut String) -> Result<std::fmt::Result> {
        let (base, tool) = match &self.form {
            Form::Dh(table) => (&table.base, &table.tool),
            Form::Screws(table) => (&table.base, &table.tool),
            Form::Tree { .. } => {
                let text = "a tree has no robot file: make a table or screws of its chain, or write a URDF";
                return Err(Error::model(self.name.clone(), text));
            }
        };
        Ok(self.write_head(out).and_then(|()| {
            match &self.form {
                Form::Dh(table) => table
                    .rows
                    .iter()
                    .enumerate()
                    .try_for_each(|(i, row)| write_row(out, i, row)),
                Form::Screws(table) => table
                    .screws
                    .iter()
                    .enumerate()
                    .try_for_each(|(i, screw)| write_screw(out, i, screw)),
                Form::Tree { .. } => Ok(()),
            }?;
            write_frame(out, "base", base)?;
            write_frame(out, "tool", tool)?;
            self.motors
                .iter()
                .try_for_each(|motor| write_motor(out, motor))
        }))
    }

    fn write_head(&self, out: &mut String) -> std::fmt::Result {
        writeln!(out, "name = {}", quoted(&self.name))?;
        for (key, text) in [("summary", &self.summary), ("source", &self.source)] {
            if !text.is_empty() {
                writeln!(out, "{key} = {}", quoted(text))?;
            }
        }
        if self.up != Up::default() {
            writeln!(out, "up = {}", quoted(self.up.name()))?;
        }
        if let Form::Dh(table) = &self.form {
            writeln!(out, "convention = {}", quoted(table.convention.name()))?;
        }
        if !self.datasheet.is_empty() {
            writeln!(out, "\n[datasheet]")?;
            self.datasheet
                .iter()
                .try_for_each(|(k, v)| writeln!(out, "{} = {}", key(k), quoted(v)))?;
        }
        if !self.parameters.is_empty() {
            writeln!(out, "\n[parameters]")?;
        }
        for parameter in &self.parameters {
            let value = parameter.value.as_ref().map_or("\"?\"".to_owned(), value);
            writeln!(out, "{} = {value}", parameter.name)?;
        }
        Ok(())
    }
}

fn write_row(out: &mut String, index: usize, row: &DhRow) -> std::fmt::Result {
    let moving = quoted(&row.moving_entry(index).to_string());
    let (theta, d) = match row.moves {
        Moves::Theta => (moving, value(&row.d)),
        Moves::D => (value(&row.theta), moving),
    };
    writeln!(
        out,
        "\n[[joint]]\ntheta = {theta}\nalpha = {}",
        value(&row.alpha)
    )?;
    writeln!(out, "d = {d}\na = {}", value(&row.a))?;
    write_joint(out, index, &row.joint)
}

fn write_screw(out: &mut String, index: usize, screw: &Screw) -> std::fmt::Result {
    let key = if screw.kind == JointKind::Prismatic {
        "d"
    } else {
        "theta"
    };
    let variable = format!("q{}", index + 1);
    let text = quoted(&with_variable(&screw.offset, &variable, screw.sign).to_string());
    writeln!(
        out,
        "\n[[screws]]\nh = {}\np = {}\n{key} = {text}",
        list(&screw.h),
        list(&screw.p)
    )?;
    write_joint(out, index, &screw.joint)
}

fn write_joint(out: &mut String, index: usize, joint: &JointExpr) -> std::fmt::Result {
    if joint.name != format!("q{}", index + 1) {
        writeln!(out, "name = {}", quoted(&joint.name))?;
    }
    if let Some(limits) = &joint.limits {
        writeln!(out, "limits = {}", list(limits))?;
    }
    for (key, expr) in [
        ("velocity", &joint.velocity),
        ("acceleration", &joint.acceleration),
    ] {
        if let Some(expr) = expr {
            writeln!(out, "{key} = {}", value(expr))?;
        }
    }
    Ok(())
}

fn write_frame(out: &mut String, name: &str, frame: &FrameExpr) -> std::fmt::Result {
    if frame.is_identity() {
        return Ok(());
    }
    writeln!(
        out,
        "\n[{name}]\nxyz = {}\nrpy = {}",
        list(&frame.xyz),
        list(&frame.rpy)
    )
}

fn write_motor(out: &mut String, motor: &MotorExpr) -> std::fmt::Result {
    let number = motor.place + 1;
    let kind = match &motor.coupling {
        CouplingExpr::Linear { .. } => MotorKind::Linear,
        CouplingExpr::FourBar { .. } => MotorKind::FourBar,
        CouplingExpr::Servo { .. } => MotorKind::Servo,
    };
    writeln!(out, "\n[[transmission]]\nkind = {}", quoted(kind.name()))?;
    writeln!(out, "motor = \"m{number}\"")?;
    if motor.name != format!("m{number}") {
        writeln!(out, "name = {}", quoted(&motor.name))?;
    }
    match &motor.coupling {
        CouplingExpr::Linear { joints, gear } => {
            let joint =
                |(joint, factor): &(usize, Expr)| format!("q{} = {}", joint + 1, value(factor));
            let joints: Vec<String> = joints.iter().map(joint).collect();
            writeln!(out, "joints = {{ {} }}", joints.join(", "))?;
            write_gear(out, gear)
        }
        CouplingExpr::FourBar {
            lengths,
            assembly,
            rocker_angle,
            frame_angle,
            gear,
        } => {
            for (key, length) in ["crank", "coupler", "rocker", "frame"]
                .iter()
                .zip(lengths.iter())
            {
                writeln!(out, "{key} = {}", value(length))?;
            }
            writeln!(out, "assembly = {}", quoted(assembly.name()))?;
            writeln!(out, "rocker_angle = {}", angle(rocker_angle))?;
            if let Some(frame) = frame_angle {
                writeln!(out, "frame_angle = {}", angle(frame))?;
            }
            write_gear(out, gear)
        }
        CouplingExpr::Servo {
            joint,
            centre,
            sign,
            ratio,
            window,
        } => {
            writeln!(out, "joint = \"q{}\"", joint + 1)?;
            if let Some(centre) = centre {
                writeln!(out, "centre = {}", value(centre))?;
            }
            if *sign < 0.0 {
                writeln!(out, "sign = -1")?;
            }
            write_unless(out, "ratio", ratio, 1.0)?;
            match *window == half_turn() {
                true => Ok(()),
                false => writeln!(out, "window = {}", list(window)),
            }
        }
    }
}

fn write_gear(out: &mut String, gear: &GearExpr) -> std::fmt::Result {
    write_unless(out, "ratio", &gear.ratio, 1.0)?;
    write_unless(out, "offset", &gear.offset, 0.0)?;
    match &gear.limits {
        None => Ok(()),
        Some(limits) => writeln!(out, "limits = {}", list(limits)),
    }
}

fn write_unless(out: &mut String, key: &str, expr: &Expr, default: f64) -> std::fmt::Result {
    match *expr == Expr::number(default) {
        true => Ok(()),
        false => writeln!(out, "{key} = {}", value(expr)),
    }
}

fn angle(angle: &AngleExpr) -> String {
    let variable = format!("q{}", angle.joint + 1);
    quoted(&with_variable(&angle.offset, &variable, angle.sign).to_string())
}

/// A plain number as a TOML number, anything else as a string.
fn value(expr: &Expr) -> String {
    let is_plain = match expr {
        Expr::Number(_, unit) => *unit == Unit::None,
        Expr::Neg(inner) => matches!(**inner, Expr::Number(_, Unit::None)),
        _ => false,
    };
    if is_plain {
        expr.to_string()
    } else {
        quoted(&expr.to_string())
    }
}

fn list(exprs: &[Expr]) -> String {
    format!(
        "[{}]",
        exprs.iter().map(value).collect::<Vec<_>>().join(", ")
    )
}

/// A key: bare where TOML allows that.
fn key(text: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !text.is_empty() && text.chars().all(is_bare) {
        text.to_owned()
    } else {
        quoted(text)
    }
}

/// A TOML string, over several lines if the text has them.
fn quoted(text: &str) -> String {
    // A line break between triple quotes stands for itself.
    match text.contains('\n') {
        true => format!("\"\"\"\n{}\"\"\"", escaped(text)),
        false => format!("\"{}\"", escaped(text)),
    }
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for character in text.chars() {
        match character {
            '"' | '\\' => out.extend(['\\', character]),
            '\n' => out.push('\n'),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => out.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out
}
