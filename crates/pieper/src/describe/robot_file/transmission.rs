//! `[[transmission]]`

use super::fields::{Field, Table};
use crate::describe::drives::{AngleExpr, CouplingExpr, GearExpr, MotorExpr};
use crate::describe::expr::{Expr, Linear};
use crate::error::Result;
use crate::transmission::{Assembly, MotorKind};

/// The motors, of an arm with `dof` joints.
pub(super) fn motors(root: &Table<'_>, dof: usize, known: &[&str]) -> Result<Vec<MotorExpr>> {
    let mut motors: Vec<MotorExpr> = Vec::new();
    for table in root.tables("transmission")? {
        let motor = motor(&Context { dof, known }, &table)?;
        if motors.iter().any(|other| other.place == motor.place) {
            let text = format!(
                "one [[transmission]] for each motor was expected, m{} has two",
                motor.place + 1
            );
            return Err(table.error(&text));
        }
        motors.push(motor);
    }
    Ok(motors)
}

/// What a section may refer to.
struct Context<'a> {
    dof: usize,
    known: &'a [&'a str],
}

const COMMON: [&str; 3] = ["kind", "motor", "name"];
const GEAR: [&str; 3] = ["ratio", "offset", "limits"];

fn motor(context: &Context<'_>, table: &Table<'_>) -> Result<MotorExpr> {
    let field = table.require("kind", "\"linear\", \"four-bar\" or \"servo\"")?;
    let named = |kind: &MotorKind| field.string().is_ok_and(|name| name == kind.name());
    let kinds = [MotorKind::Linear, MotorKind::FourBar, MotorKind::Servo];
    let Some(kind) = kinds.into_iter().find(named) else {
        return Err(field.error("\"linear\", \"four-bar\" or \"servo\" was expected"));
    };
    let keys: &[&[&str]] = match kind {
        MotorKind::FourBar => &[
            &COMMON,
            &["crank", "coupler", "rocker", "frame", "assembly"],
            &["rocker_angle", "frame_angle"],
            &GEAR,
        ],
        MotorKind::Servo => &[&COMMON, &["joint", "centre", "sign", "ratio", "window"]],
        _ => &[&COMMON, &["joints"], &GEAR],
    };
    table.allow_only(&keys.concat())?;
    let field = table.require("motor", "the motor's place, as in motor = \"m3\"")?;
    let place = context.number(&field, field.string()?, 'm')?;
    let name = match table.get("name") {
        Some(field) => field.string()?.to_owned(),
        None => format!("m{}", place + 1),
    };
    let coupling = match kind {
        MotorKind::FourBar => context.four_bar(table)?,
        MotorKind::Servo => context.servo(table)?,
        _ => context.linear(table)?,
    };
    Ok(MotorExpr {
        place,
        name,
        coupling,
    })
}

impl Context<'_> {
    fn linear(&self, table: &Table<'_>) -> Result<CouplingExpr> {
        let expected = "the joints with their factors, as in joints = { q2 = 1, q3 = 1 }";
        table.require("joints", expected)?;
        let mut joints = Vec::new();
        for field in table.table("joints")?.iter().flat_map(Table::fields) {
            let joint = self.number(&field, field.name(), 'q')?;
            joints.push((joint, field.expr(Some(self.known))?));
        }
        let gear = self.gear(table)?;
        Ok(CouplingExpr::Linear { joints, gear })
    }

    fn four_bar(&self, table: &Table<'_>) -> Result<CouplingExpr> {
        let length = |name: &str| {
            let field = table.require(name, "the length of that bar")?;
            field.expr(Some(self.known))
        };
        let lengths = Box::new([
            length("crank")?,
            length("coupler")?,
            length("rocker")?,
            length("frame")?,
        ]);
        let assembly = match table.get("assembly") {
            None => Assembly::Open,
            Some(field) => match field.string()? {
                "open" => Assembly::Open,
                "crossed" => Assembly::Crossed,
                _ => return Err(field.error("\"open\" or \"crossed\" was expected")),
            },
        };
        let expected = "the rocker's angle, 0 where it is perpendicular to the frame, as in rocker_angle = \"q3\"";
        let rocker_angle = self.angle(&table.require("rocker_angle", expected)?)?;
        let frame_angle = table.get("frame_angle");
        Ok(CouplingExpr::FourBar {
            lengths,
            assembly,
            rocker_angle,
            frame_angle: frame_angle.map(|field| self.angle(&field)).transpose()?,
            gear: self.gear(table)?,
        })
    }

    fn servo(&self, table: &Table<'_>) -> Result<CouplingExpr> {
        let field = table.require("joint", "the joint it turns, as in joint = \"q1\"")?;
        let joint = self.number(&field, field.string()?, 'q')?;
        let sign = match table.get("sign") {
            None => 1.0,
            Some(field) => match field.number()? {
                sign if sign.abs() == 1.0 => sign,
                _ => return Err(field.error("1 or -1 was expected")),
            },
        };
        let centre = table
            .get("centre")
            .map(|field| field.expr(Some(self.known)));
        let window = match table.get("window") {
            Some(field) => field.exprs(self.known)?,
            None => half_turn(),
        };
        Ok(CouplingExpr::Servo {
            joint,
            centre: centre.transpose()?,
            sign,
            ratio: self.optional(table, "ratio", 1.0)?,
            window,
        })
    }

    fn gear(&self, table: &Table<'_>) -> Result<GearExpr> {
        let limits = table.get("limits").map(|field| field.exprs(self.known));
        Ok(GearExpr {
            ratio: self.optional(table, "ratio", 1.0)?,
            offset: self.optional(table, "offset", 0.0)?,
            limits: limits.transpose()?,
        })
    }

    fn optional(&self, table: &Table<'_>, name: &str, default: f64) -> Result<Expr> {
        match table.get(name) {
            Some(field) => field.expr(Some(self.known)),
            None => Ok(Expr::number(default)),
        }
    }

    /// `offset + q3` or `offset - q3`
    fn angle(&self, field: &Field<'_>) -> Result<AngleExpr> {
        let any = field.expr(None)?;
        let joint_names: Vec<String> = (1..=self.dof).map(|joint| format!("q{joint}")).collect();
        let symbols = any.symbols();
        let position = joint_names
            .iter()
            .position(|name| symbols.contains(&name.as_str()));
        let expected = || match self.dof {
            1 => "\"offset + q1\" or \"offset - q1\" was expected".to_owned(),
            dof => format!(
                "\"offset + q\" or \"offset - q\" was expected, q being one of the joints q1 to q{dof}"
            ),
        };
        let joint = position.ok_or_else(|| field.error(&expected()))?;
        let name = &joint_names[joint];
        let Some(Linear { sign, offset }) = any.split_at(name) else {
            return Err(field.error(&expected()));
        };
        let mut allowed = self.known.to_vec();
        allowed.push(name);
        field.expr(Some(&allowed))?;
        Ok(AngleExpr {
            joint,
            sign,
            offset,
        })
    }

    /// The index that a name such as `q3` or `m3` stands for.
    fn number(&self, field: &Field<'_>, name: &str, letter: char) -> Result<usize> {
        let digits = name
            .strip_prefix(letter)
            .filter(|digits| !digits.starts_with('+'));
        let number = digits.and_then(|digits| digits.parse::<usize>().ok());
        match number {
            Some(number) if (1..=self.dof).contains(&number) => Ok(number - 1),
            _ => {
                let what = if letter == 'q' { "joints" } else { "motors" };
                let text = match self.dof {
                    1 => format!("{letter}1 was expected: the arm has one joint"),
                    dof => format!("one of the {what} {letter}1 to {letter}{dof} was expected"),
                };
                Err(field.error(&text))
            }
        }
    }
}

/// What hobby servos turn: 0 to 180 degrees.
pub(super) fn half_turn() -> [Expr; 2] {
    use crate::describe::expr::Unit;
    [Expr::number(0.0), Expr::Number(180.0, Unit::Degree)]
}
