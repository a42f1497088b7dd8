//! Measurement tables: CSV text to what was seen of an arm's tool, for calibration.

use nalgebra::{Quaternion, UnitQuaternion};

use super::motion_table::cells::{Cell, Records};
use crate::error::{Error, Place, Result};
use crate::model::Chain;
use crate::spatial::{self, Pose};
use crate::transmission::Transmission;

/// One measurement: where the arm stood by its own account, and what was seen there.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What the arm's own sensors told.
    pub readings: Readings,
    /// What was seen.
    pub seen: Seen,
    /// The standard deviation of a length, metres.
    pub sigma: f64,
    /// The standard deviation of an angle, radians.
    pub sigma_angle: f64,
}

/// The values of an arm's sensors, radians and metres, in the order of its joints.
#[derive(Clone, Debug, PartialEq)]
pub enum Readings {
    /// Of the joints.
    Joints(Vec<f64>),
    /// Of the motors, before gears, couplings, linkages and servo windows.
    Motors(Vec<f64>),
}

impl Readings {
    /// The values.
    pub fn values(&self) -> &[f64] {
        let (Self::Joints(values) | Self::Motors(values)) = self;
        values
    }

    /// The values, to change them.
    pub fn values_mut(&mut self) -> &mut Vec<f64> {
        let (Self::Joints(values) | Self::Motors(values)) = self;
        values
    }
}

impl Measurement {
    /// The measurement of a camera on the tool that looks at a target which stands still: where the table tells the target in the
    /// camera's frame, this tells the camera in the target's. The base is then the target's frame, and the tool the camera: `A X = X B`.
    /// What is no whole pose stays as it is.
    #[must_use]
    pub fn of_eye_in_hand(mut self) -> Self {
        if let Seen::Pose(pose) = &mut self.seen {
            *pose = pose.inverse();
        }
        self
    }
}

/// What was seen. Points of the tool are given in the tool's frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// The tool's whole pose.
    Pose(Pose),
    /// Where a point of the tool is.
    Position {
        /// There.
        point: [f64; 3],
        /// Of the tool.
        at: [f64; 3],
    },
    /// How far a point of the tool is from an anchor (a ball bar, a wire), whose place is estimated too.
    Distance {
        /// The anchor's name.
        anchor: String,
        /// So far, metres.
        distance: f64,
        /// Of the tool.
        at: [f64; 3],
    },
    /// A point of the tool touches a plane, which is estimated too.
    Plane {
        /// The plane's name.
        plane: String,
        /// Of the tool.
        at: [f64; 3],
    },
    /// A point of the tool is at a fixed point, which is estimated too: a cone, the tip of a pin.
    Contact {
        /// The point's name.
        contact: String,
        /// Of the tool.
        at: [f64; 3],
    },
}

/// Standard deviations where a table tells none: 0.1 mm and 0.01 degrees.
const SIGMA: f64 = 1e-4;
const SIGMA_ANGLE: f64 = 1.745e-4;

/// Rows above this count are refused.
const MOST_ROWS: usize = 100_000;

/// How far the length of a quaternion may be from 1.
const UNIT_TOLERANCE: f64 = 1e-6;

/// The columns beside the joints, with the kind of their numbers; names of anchors, planes and contacts are words.
const COLUMNS: [(&str, Quantity); 18] = [
    ("x", Quantity::Length),
    ("y", Quantity::Length),
    ("z", Quantity::Length),
    ("qw", Quantity::Number),
    ("qx", Quantity::Number),
    ("qy", Quantity::Number),
    ("qz", Quantity::Number),
    ("roll", Quantity::Angle),
    ("pitch", Quantity::Angle),
    ("yaw", Quantity::Angle),
    ("distance", Quantity::Length),
    ("px", Quantity::Length),
    ("py", Quantity::Length),
    ("pz", Quantity::Length),
    ("sigma", Quantity::Length),
    ("sigma_angle", Quantity::Angle),
    ("t", Quantity::Number),
    ("mark", Quantity::Word),
];
const WORDS: [&str; 3] = ["anchor", "plane", "contact"];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Angle,
    Length,
    Number,
    Word,
}

/// What a column holds.
#[derive(Clone, Debug)]
struct Column {
    name: String,
    place: Slot,
    factor: f64,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Slot {
    Joint(usize),
    Motor(usize),
    Named(&'static str),
    Ignored,
}

/// Reads a table of comma-separated values for `chain` and its motors; `file` is the name used in error messages.
///
/// The header names the columns: the joints as `q1`..`qn` or by their own names (radians and metres; with `_deg` degrees, with `_mm`
/// millimetres), or else the motors by theirs (`m1`..`mn` where a description gives none), and what was seen: `x,y,z` with `qw,qx,qy,qz` or `roll,pitch,yaw` for whole poses, `x,y,z` alone for positions,
/// `distance` and `anchor` (its name), `plane` or `contact` (a name). `px,py,pz` is the point of the tool that was looked at, in the
/// tool's frame, and its origin where it is left out. `sigma` and `sigma_angle` are standard deviations. Cells that do not belong to a
/// row's kind are left empty, so that kinds may be mixed. Lines that start with `#` are skipped.
///
/// ```
/// use pieper::describe::{Robot, measurements_from_csv};
/// let arm = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let robot = Robot::from_toml("r.toml", arm)?;
/// let table = "q1_deg,x_mm,y_mm,z_mm,sigma_mm\n90,0,501,0,0.05\n";
/// let measurements = measurements_from_csv("m.csv", table, &robot.chain()?, &robot.transmission()?)?;
/// assert_eq!(measurements[0].sigma, 5e-5);
/// # Ok::<(), pieper::Error>(())
/// ```
///
/// # Errors
/// A parse error with file, line and column, the offending text and what was expected.
pub fn measurements_from_csv(
    file: &str,
    text: &str,
    chain: &Chain,
    transmission: &Transmission,
) -> Result<Vec<Measurement>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut records = Records::new(file, text);
    let mut cells = Vec::new();
    let place = |offset: usize| Place::of_offset(file, text, offset);
    if !records.read(&mut cells)? {
        let words = "a header was expected, such as q1_deg,q2_deg,x_mm,y_mm,z_mm,sigma_mm";
        return Err(Error::parse(place(0), "", words));
    }
    let (columns, of_motors) = header(&cells, chain, transmission, &place)?;
    let mut measurements = Vec::new();
    while records.read(&mut cells)? {
        let line = place(cells.first().map_or(0, |cell| cell.start));
        if cells.len() != columns.len() {
            let words = format!(
                "{} cells were expected, as in the header; {} are there",
                columns.len(),
                cells.len()
            );
            return Err(Error::parse(line, "", words));
        }
        if measurements.len() == MOST_ROWS {
            return Err(Error::parse(
                line,
                "",
                format!("at most {MOST_ROWS} rows were expected"),
            ));
        }
        let row = Row {
            columns: &columns,
            cells: &cells,
            place: &place,
            line,
        };
        measurements.push(row.measurement(chain.dof(), of_motors)?);
    }
    if measurements.is_empty() {
        let words = "a row of values was expected below the header";
        return Err(Error::parse(place(text.len()), "", words));
    }
    Ok(measurements)
}

fn header(
    cells: &[Cell<'_>],
    chain: &Chain,
    transmission: &Transmission,
    place: &dyn Fn(usize) -> Place,
) -> Result<(Vec<Column>, bool)> {
    let mut columns: Vec<Column> = Vec::with_capacity(cells.len());
    for cell in cells {
        let column = column(&cell.text, chain, transmission)
            .map_err(|words| Error::parse(place(cell.start), cell.shown(), words))?;
        let is_double = column.place != Slot::Ignored
            && columns.iter().any(|other| other.place == column.place);
        if is_double {
            let words = "a second column for the same";
            return Err(Error::parse(place(cell.start), cell.shown(), words));
        }
        columns.push(column);
    }
    let has = |slot: &Slot| columns.iter().any(|column| column.place == *slot);
    let of_motors = columns
        .iter()
        .any(|column| matches!(column.place, Slot::Motor(_)));
    for index in 0..chain.dof() {
        let (name, motor) = (
            &chain.variables()[index].name,
            transmission.all()[index].name(),
        );
        let words = match of_motors {
            true if has(&Slot::Joint(index)) => {
                format!("joint {name}: a table of motor values was expected, without joints")
            }
            true if !has(&Slot::Motor(index)) => format!("a column {motor} was expected"),
            false if !has(&Slot::Joint(index)) => {
                format!("a column q{} or {name} was expected", index + 1)
            }
            _ => continue,
        };
        return Err(Error::parse(place(0), "", words));
    }
    Ok((columns, of_motors))
}

fn column(
    name: &str,
    chain: &Chain,
    transmission: &Transmission,
) -> std::result::Result<Column, String> {
    let of = |place: Slot, factor: f64| {
        Ok(Column {
            name: name.to_owned(),
            place,
            factor,
        })
    };
    if let Some(word) = WORDS.iter().find(|word| **word == name) {
        return of(Slot::Named(word), 1.0);
    }
    let (stem, unit) = [("_deg", Quantity::Angle), ("_mm", Quantity::Length)]
        .into_iter()
        .find_map(|(ending, quantity)| Some((name.strip_suffix(ending)?, Some(quantity))))
        .unwrap_or((name, None));
    let factor = |own: Quantity| match unit {
        None => Ok(1.0),
        Some(unit) if unit == own => Ok(match unit {
            Quantity::Angle => 1_f64.to_radians(),
            _ => 1e-3,
        }),
        Some(_) => Err(match own {
            Quantity::Angle => "this is an angle: radians, or degrees with _deg, were expected",
            Quantity::Length => "this is a length: metres, or millimetres with _mm, were expected",
            _ => "this has no unit",
        }
        .to_owned()),
    };
    let joints = chain.variables().iter().enumerate();
    let joint = joints
        .clone()
        .find(|(_, variable)| variable.name == stem)
        .or_else(|| {
            let number: usize = stem.strip_prefix('q')?.parse().ok()?;
            joints.clone().find(|(index, _)| index + 1 == number)
        });
    if let Some((index, variable)) = joint {
        let own = match variable.kind.is_angular() {
            true => Quantity::Angle,
            false => Quantity::Length,
        };
        return of(Slot::Joint(index), factor(own)?);
    }
    let motor = transmission
        .all()
        .iter()
        .position(|motor| motor.name() == stem);
    if let Some(index) = motor {
        let own = match transmission.motor_kind(index).is_angular() {
            true => Quantity::Angle,
            false => Quantity::Length,
        };
        return of(Slot::Motor(index), factor(own)?);
    }
    match COLUMNS.iter().find(|(known, _)| *known == stem) {
        Some(("t" | "mark", _)) => of(Slot::Ignored, 1.0),
        Some((known, own)) => of(Slot::Named(known), factor(*own)?),
        None => Err(
            "a joint (q1, q2, ... or its name), a motor (m1, m2, ... or its name), x, y, z, qw..qz, roll, pitch, yaw, distance, anchor, plane, contact, \
             px, py, pz, sigma or sigma_angle was expected"
                .to_owned(),
        ),
    }
}

struct Row<'a> {
    columns: &'a [Column],
    cells: &'a [Cell<'a>],
    place: &'a dyn Fn(usize) -> Place,
    line: Place,
}

impl Row<'_> {
    fn cell(&self, slot: &Slot) -> Option<(&Column, &Cell<'_>)> {
        let at = self
            .columns
            .iter()
            .position(|column| column.place == *slot)?;
        let cell = self.cells.get(at)?;
        (!cell.text.is_empty()).then_some((&self.columns[at], cell))
    }

    fn number(&self, slot: &Slot) -> Result<Option<f64>> {
        let Some((column, cell)) = self.cell(slot) else {
            return Ok(None);
        };
        match cell.text.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(Some(value * column.factor)),
            _ => {
                let subject = format!("{} = {}", column.name, cell.shown());
                let words = "a finite number was expected";
                Err(Error::parse((self.place)(cell.start), subject, words))
            }
        }
    }

    /// Several numbers: all, or none.
    fn numbers<const N: usize>(&self, names: [&'static str; N]) -> Result<Option<[f64; N]>> {
        let mut values = [0.0; N];
        let mut found = 0;
        for (value, name) in values.iter_mut().zip(names) {
            if let Some(number) = self.number(&Slot::Named(name))? {
                *value = number;
                found += 1;
            }
        }
        match found {
            0 => Ok(None),
            found if found == N => Ok(Some(values)),
            _ => {
                let words = format!("{} were expected together", names.join(", "));
                Err(Error::parse(self.line.clone(), "", words))
            }
        }
    }

    fn word(&self, name: &'static str) -> Option<String> {
        let (_, cell) = self.cell(&Slot::Named(name))?;
        Some(cell.text.clone().into_owned())
    }

    fn measurement(&self, dof: usize, of_motors: bool) -> Result<Measurement> {
        let fail = |words: &str| Err(Error::parse(self.line.clone(), "", words));
        let (what, slot): (_, fn(usize) -> Slot) = match of_motors {
            true => ("motor", Slot::Motor),
            false => ("joint", Slot::Joint),
        };
        let mut values = Vec::with_capacity(dof);
        for index in 0..dof {
            match self.number(&slot(index))? {
                Some(value) => values.push(value),
                None => return fail(&format!("a value of {what} {} was expected", index + 1)),
            }
        }
        let readings = match of_motors {
            true => Readings::Motors(values),
            false => Readings::Joints(values),
        };
        let at = self.numbers(["px", "py", "pz"])?.unwrap_or([0.0; 3]);
        let position = self.numbers(["x", "y", "z"])?;
        let turn = self.turn()?;
        let distance = self.number(&Slot::Named("distance"))?;
        let seen = match (
            self.word("anchor"),
            self.word("plane"),
            self.word("contact"),
        ) {
            (Some(anchor), None, None) => match distance {
                Some(distance) if distance >= 0.0 => Seen::Distance {
                    anchor,
                    distance,
                    at,
                },
                _ => return fail("a distance of 0 or more was expected for the anchor"),
            },
            (None, Some(plane), None) => Seen::Plane { plane, at },
            (None, None, Some(contact)) => Seen::Contact { contact, at },
            (None, None, None) => match (position, turn) {
                (Some(point), Some(turn)) if at == [0.0; 3] => {
                    Seen::Pose(Pose::from_parts(point.into(), turn))
                }
                (Some(_), Some(_)) => {
                    return fail(
                        "px, py, pz are for positions: a whole pose is that of the tool's frame",
                    );
                }
                (Some(point), None) => Seen::Position { point, at },
                (None, Some(_)) => return fail("x, y, z were expected with the orientation"),
                (None, None) => {
                    return fail(
                        "something seen was expected: x, y, z, a distance, a plane or a contact",
                    );
                }
            },
            _ => return fail("one of anchor, plane and contact was expected, not several"),
        };
        let sigma = |name: &'static str, usual: f64| match self.number(&Slot::Named(name))? {
            Some(sigma) if sigma > 0.0 => Ok(sigma),
            Some(_) => {
                let words = format!("{name}: a standard deviation above 0 was expected");
                Err(Error::parse(self.line.clone(), "", words))
            }
            None => Ok(usual),
        };
        Ok(Measurement {
            readings,
            seen,
            sigma: sigma("sigma", SIGMA)?,
            sigma_angle: sigma("sigma_angle", SIGMA_ANGLE)?,
        })
    }

    fn turn(&self) -> Result<Option<nalgebra::Rotation3<f64>>> {
        if let Some([roll, pitch, yaw]) = self.numbers(["roll", "pitch", "yaw"])? {
            return Ok(Some(
                spatial::from_xyz_rpy([0.0; 3], [roll, pitch, yaw]).rotation,
            ));
        }
        let Some([w, x, y, z]) = self.numbers(["qw", "qx", "qy", "qz"])? else {
            return Ok(None);
        };
        let quaternion = Quaternion::new(w, x, y, z);
        let off = (quaternion.norm() - 1.0).abs();
        if off > UNIT_TOLERANCE {
            let words = format!(
                "a quaternion of length 1 was expected, this one's is {}",
                quaternion.norm()
            );
            return Err(Error::parse(self.line.clone(), "", words));
        }
        Ok(Some(
            UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix(),
        ))
    }
}
