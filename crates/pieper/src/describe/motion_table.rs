//! Motion tables: CSV text to rows of joint values, tool poses or tool points over time.

pub(super) mod cells;
mod columns;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::error::{Error, Place, Result};
use crate::model::Chain;
use crate::spatial::{self, Pose};
use cells::{Cell, Records};
use columns::{Column, Header, Layout};

/// Beyond this a value is a mistake: no joint travels a million kilometres, and sums stay finite.
const LARGEST: f64 = 1e9;

/// Rows above this count are refused: a day of motion at ten rows a second fits.
const MOST_ROWS: usize = 1_000_000;

/// How far the length of a quaternion may be from 1: as for the rotation part of a pose.
const UNIT_TOLERANCE: f64 = 1e-6;

/// A motion as a table gives it: one state at each of several times.
///
/// ```
/// use pieper::describe::{MotionTable, MotionValues, Robot};
/// let arm = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let chain = Robot::from_toml("r.toml", arm)?.chain()?;
/// let table = MotionTable::from_csv("m.csv", "t,q1_deg,mark\n0,0,home\n1,180,\n", &chain)?;
/// assert_eq!(table.times, [0.0, 1.0]);
/// assert_eq!(table.values, MotionValues::Joints(vec![vec![0.0], vec![std::f64::consts::PI]]));
/// assert_eq!(table.reference_positions(), [(0, "home".to_owned())]);
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MotionTable {
    /// The rows' times in seconds, each later than the one before.
    pub times: Vec<f64>,
    /// The rows' names as reference positions, empty where a row is none; `None` for a table without that column.
    pub marks: Option<Vec<String>>,
    /// What the rows say, one for each time.
    pub values: MotionValues,
}

/// What the rows of a motion table say.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionValues {
    /// Joint vectors, radians and metres, in the order of the chain's variables.
    Joints(Vec<Vec<f64>>),
    /// Poses of the tool.
    Poses(Vec<Pose>),
    /// Three points of the tool.
    Points(Vec<ToolPoints>),
}

/// Three points of the tool, in metres, and the pose they give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolPoints {
    /// D: the tool's point.
    pub tip: Vector3<f64>,
    /// K: a point on the tool's z axis.
    pub on_z: Vector3<f64>,
    /// E: a point on the side of the tool's y axis.
    pub beside: Vector3<f64>,
    /// The tool's pose: see [`orientation_from_points`](spatial::orientation_from_points).
    pub pose: Pose,
}

impl MotionTable {
    /// Reads a table of comma-separated values for `chain`; `file` is the name used in error messages.
    ///
    /// The header names the columns: `t` (seconds), then either the joints as `q1`..`qn` or by their own names
    /// (radians and metres; with `_deg` degrees, with `_mm` millimetres), or a tool pose `x,y,z,qw,qx,qy,qz` or
    /// `x,y,z,roll,pitch,yaw`, or three tool points `Dx`..`Dz`, `Kx`..`Kz`, `Ex`..`Ez`. A column `mark` names
    /// reference positions. Empty lines and lines that start with `#` are skipped.
    ///
    /// # Errors
    /// A parse error with file, line and column, the offending text and what was expected.
    pub fn from_csv(file: &str, text: &str, chain: &Chain) -> Result<Self> {
        let mut reader = Reader::new(file, text, chain)?;
        let mut table = Self {
            times: Vec::new(),
            marks: reader.header.has_mark().then(Vec::new),
            values: reader.header.layout.no_values(),
        };
        while let Some(row) = reader.row(table.times.last().copied())? {
            let at_line = |error: Error| error.at(reader.line());
            if table.times.len() == MOST_ROWS {
                let text = format!("at most {MOST_ROWS} rows were expected");
                return Err(Error::parse(reader.line(), "", text));
            }
            table.times.push(row.time);
            if let Some(marks) = &mut table.marks {
                marks.push(row.mark);
            }
            let layout = reader.header.layout;
            table.values.push(layout, row.values).map_err(at_line)?;
        }
        if table.times.is_empty() {
            let place = whole(file);
            return Err(Error::parse(
                place,
                "",
                "a row of values was expected below the header",
            ));
        }
        Ok(table)
    }

    /// The rows that are reference positions, with their names: the marked ones, or every row, numbered from 0, if
    /// the table has no column `mark`.
    pub fn reference_positions(&self) -> Vec<(usize, String)> {
        match &self.marks {
            None => (0..self.times.len())
                .map(|row| (row, row.to_string()))
                .collect(),
            Some(marks) => {
                let named = marks
                    .iter()
                    .enumerate()
                    .filter(|(_, name)| !name.is_empty());
                named.map(|(row, name)| (row, name.clone())).collect()
            }
        }
    }
}

impl MotionValues {
    fn push(&mut self, layout: Layout, values: Vec<f64>) -> Result<()> {
        match self {
            Self::Joints(rows) => rows.push(values),
            Self::Poses(poses) => poses.push(pose(layout, &values)?),
            Self::Points(points) => points.push(tool_points(&values)?),
        }
        Ok(())
    }
}

fn pose(layout: Layout, values: &[f64]) -> Result<Pose> {
    let xyz = [values[0], values[1], values[2]];
    if layout == Layout::PoseAngles {
        return Ok(spatial::from_xyz_rpy(
            xyz,
            [values[3], values[4], values[5]],
        ));
    }
    let q = Quaternion::new(values[3], values[4], values[5], values[6]);
    let length = q.norm();
    if (length - 1.0).abs() > UNIT_TOLERANCE {
        let text = format!("a quaternion of length 1 was expected, its length is {length}");
        return Err(Error::parse(Place::default(), "qw, qx, qy, qz", text));
    }
    let rotation = UnitQuaternion::new_normalize(q).to_rotation_matrix();
    Ok(Pose::from_parts(Vector3::from(xyz).into(), rotation))
}

fn tool_points(values: &[f64]) -> Result<ToolPoints> {
    let point = |k: usize| Vector3::new(values[k], values[k + 1], values[k + 2]);
    let (tip, on_z, beside) = (point(0), point(3), point(6));
    let rotation = spatial::orientation_from_points(&tip, &on_z, &beside)
        .map_err(|error| Error::parse(Place::default(), "", error.to_string()))?;
    Ok(ToolPoints {
        tip,
        on_z,
        beside,
        pose: Pose::from_parts(tip.into(), rotation),
    })
}

/// The place of something about the file as a whole.
fn whole(file: &str) -> Place {
    Place {
        file: file.to_owned(),
        line: 0,
        column: 0,
    }
}

/// One row, its numbers in the units of the library and in the order of the layout.
struct Row {
    time: f64,
    mark: String,
    values: Vec<f64>,
}

struct Reader<'a> {
    file: &'a str,
    text: &'a str,
    records: Records<'a>,
    header: Header,
    cells: Vec<Cell<'a>>,
}

impl<'a> Reader<'a> {
    fn new(file: &'a str, text: &'a str, chain: &Chain) -> Result<Self> {
        // Spreadsheets put a byte order mark in front; it is no part of the first column's name.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut records = Records::new(file, text);
        let mut cells = Vec::new();
        if !records.read(&mut cells)? {
            let text = "a header was expected, such as t,q1,q2,q3,mark";
            return Err(Error::parse(whole(file), "", text));
        }
        let header = Header::read(file, text, &cells, chain)?;
        Ok(Self {
            file,
            text,
            records,
            header,
            cells,
        })
    }

    fn place(&self, offset: usize) -> Place {
        Place::of_offset(self.file, self.text, offset)
    }

    /// The line last read.
    fn line(&self) -> Place {
        let start = self.cells.first().map_or(0, |cell| cell.start);
        Place {
            column: 0,
            ..self.place(start)
        }
    }

    fn row(&mut self, before: Option<f64>) -> Result<Option<Row>> {
        if !self.records.read(&mut self.cells)? {
            return Ok(None);
        }
        self.check_count()?;
        let mut row = Row {
            time: 0.0,
            mark: String::new(),
            values: vec![0.0; self.header.count],
        };
        for (column, cell) in self.header.columns.iter().zip(&self.cells) {
            match column.kind {
                columns::Kind::Mark => row.mark = cell.text.clone().into_owned(),
                columns::Kind::Time => row.time = self.time(column, cell, before)?,
                columns::Kind::Value { slot, unit } => {
                    row.values[slot] = unit.to_si(self.number(column, cell)?);
                }
            }
        }
        Ok(Some(row))
    }

    fn check_count(&self) -> Result<()> {
        let (given, columns) = (self.cells.len(), &self.header.columns);
        if let Some(missing) = columns.get(given) {
            let place = self.place(self.records.line_end());
            let text = format!(
                "a value was expected, the line ends after {given} of {} cells",
                columns.len()
            );
            return Err(Error::parse(place, missing.name.clone(), text));
        }
        if let Some(extra) = self.cells.get(columns.len()) {
            let text = format!(
                "an extra cell: {} were expected, as in the header",
                columns.len()
            );
            return Err(Error::parse(self.place(extra.start), extra.shown(), text));
        }
        Ok(())
    }

    fn time(&self, column: &Column, cell: &Cell<'_>, before: Option<f64>) -> Result<f64> {
        let time = self.number(column, cell)?;
        match before {
            Some(before) if time <= before => {
                let text = format!("a time after {before} s, that of the row before, was expected");
                Err(self.error(column, cell, &text))
            }
            _ => Ok(time),
        }
    }

    fn number(&self, column: &Column, cell: &Cell<'_>) -> Result<f64> {
        if cell.text.is_empty() {
            let text = "a number was expected, the cell is empty";
            return Err(Error::parse(
                self.place(cell.start),
                column.name.clone(),
                text,
            ));
        }
        match cell.text.parse::<f64>() {
            Err(_) => Err(self.error(column, cell, "a number was expected")),
            Ok(value) if !value.is_finite() => {
                Err(self.error(column, cell, "a finite number was expected"))
            }
            Ok(value) if value.abs() > LARGEST => {
                let text = format!("a number between -{LARGEST:e} and {LARGEST:e} was expected");
                Err(self.error(column, cell, &text))
            }
            Ok(value) => Ok(value),
        }
    }

    #[cold]
    fn error(&self, column: &Column, cell: &Cell<'_>, text: &str) -> Error {
        let subject = format!("{} = {}", column.name, cell.shown());
        Error::parse(self.place(cell.start), subject, text)
    }
}
