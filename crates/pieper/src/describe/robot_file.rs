//! Robot files: TOML to [`Robot`] and back.

mod fields;
mod joints;
mod transmission;
mod tree;
mod write;

use toml::de::{DeTable, DeValue};

use super::dh::{Convention, DhTable};
use super::expr::Expr;
use super::robot::{Form, Golden, Parameter, Robot, Up};
use super::screws::ScrewTable;
use super::xacro::{NoResources, Resources};
use crate::error::{Error, Place, Result};
use crate::spatial;
use fields::{Field, Table};

impl Robot {
    /// Reads a robot file: a Denavit-Hartenberg table or screws in TOML.
    ///
    /// `file` is the name used in error messages.
    ///
    /// # Errors
    /// A parse error with file, line and column, the offending text and what was expected.
    pub fn from_toml(file: &str, text: &str) -> Result<Self> {
        Self::from_toml_with(file, text, &NoResources)
    }

    /// As [`Robot::from_toml`], for files that may name a URDF or xacro (`urdf = "arm.urdf"`, with `base` and `tip`
    /// links if the whole is not meant), which `resources` reads. Its path is relative to the robot file.
    ///
    /// # Errors
    /// As [`Robot::from_toml`]; the errors of the URDF; a resource error if it cannot be read.
    pub fn from_toml_with(file: &str, text: &str, resources: &dyn Resources) -> Result<Self> {
        let document = DeTable::parse(text).map_err(|error| toml_error(file, text, &error))?;
        let root = Table::root(file, text, document.get_ref());
        root.allow_only(&[
            "name",
            "summary",
            "source",
            "up",
            "convention",
            "datasheet",
            "parameters",
            "joint",
            "screws",
            "base",
            "tool",
            "transmission",
            "golden",
            "urdf",
            "tip",
        ])?;
        let parameters = parameters(&root)?;
        let known: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
        let form = match root.get("urdf") {
            Some(field) => tree::form(&root, &field, resources)?,
            None => form(&root, &known)?,
        };
        let motors = transmission::motors(&root, form.dof(), &known)?;
        let robot = Self {
            name: root.require("name", "the arm's name")?.string()?.to_owned(),
            summary: root.optional_string("summary")?,
            source: root.optional_string("source")?,
            up: up(&root)?,
            datasheet: datasheet(&root)?,
            golden: golden(&root)?,
            parameters,
            form,
            motors,
        };
        robot.check_numbers(file)?;
        Ok(robot)
    }

    /// Mistakes that only show in numbers: found when the file is read, if it has all its numbers.
    fn check_numbers(&self, file: &str) -> Result<()> {
        let at_file = |error: Error| {
            error.at(Place {
                file: file.to_owned(),
                line: 0,
                column: 0,
            })
        };
        self.values().map_err(at_file)?;
        let is_wrong = |error: &Error| !error.is_missing_value();
        let wrong = self.chain().err().filter(is_wrong);
        match wrong.or_else(|| self.transmission().err().filter(is_wrong)) {
            Some(error) => Err(at_file(error)),
            None => Ok(()),
        }
    }
}

fn up(root: &Table<'_>) -> Result<Up> {
    let Some(field) = root.get("up") else {
        return Ok(Up::default());
    };
    let text = field.string()?;
    let found = Up::ALL.into_iter().find(|up| up.name() == text);
    found.ok_or_else(|| {
        field.error("\"x\", \"y\" or \"z\": the axis of the base frame that points up")
    })
}

fn toml_error(file: &str, text: &str, error: &toml::de::Error) -> Error {
    let span = error.span().unwrap_or(0..0);
    let place = Place::of_offset(file, text, span.start);
    let subject = text
        .get(span)
        .unwrap_or_default()
        .lines()
        .next()
        .unwrap_or_default()
        .trim();
    let subject = if subject.is_empty() {
        String::new()
    } else {
        format!("{subject:?}")
    };
    Error::parse(place, subject, error.message().to_owned())
}

fn parameters(root: &Table<'_>) -> Result<Vec<Parameter>> {
    let Some(table) = root.table("parameters")? else {
        return Ok(Vec::new());
    };
    let mut parameters = Vec::new();
    for field in table.fields() {
        let name = field.name();
        if !is_symbol(name) {
            let expected = "a name of letters, digits and '_' was expected that is neither pi, a unit, a function \
                            nor a joint variable q1, q2, ...";
            return Err(field.name_error(expected));
        }
        let value = match field.value() {
            DeValue::String(text) if text.trim() == "?" => None,
            _ => Some(field.expr(None)?),
        };
        parameters.push(Parameter {
            name: name.to_owned(),
            value,
        });
    }
    // Only now are all names known that a parameter may refer to.
    for field in table.fields() {
        if parameters
            .iter()
            .any(|p| p.name == field.name() && p.value.is_some())
        {
            let known: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
            field.expr(Some(&known))?;
        }
    }
    Ok(parameters)
}

/// Whether a name can stand for a parameter in a formula.
fn is_symbol(name: &str) -> bool {
    let reads_as_itself = matches!(Expr::parse(name), Ok(Expr::Symbol(symbol)) if symbol == name);
    let is_joint = name
        .strip_prefix('q')
        .is_some_and(|n| n.parse::<usize>().is_ok());
    let is_unit = super::expr::Unit::NAMED
        .iter()
        .any(|(unit, _)| *unit == name);
    reads_as_itself && !is_joint && !is_unit
}

fn form(root: &Table<'_>, known: &[&str]) -> Result<Form> {
    let base = joints::frame(root, "base", known)?;
    let tool = joints::frame(root, "tool", known)?;
    let (joint, screws) = (root.tables("joint")?, root.tables("screws")?);
    match (joint.is_empty(), screws.is_empty()) {
        (false, true) => {
            let convention = convention(root)?;
            let rows = joint.iter().enumerate();
            let rows = rows
                .map(|(i, row)| joints::dh_row(row, i, known))
                .collect::<Result<_>>()?;
            Ok(Form::Dh(DhTable {
                convention,
                rows,
                base,
                tool,
            }))
        }
        (true, false) => {
            let screws = screws.iter().enumerate();
            let screws = screws
                .map(|(i, row)| joints::screw(row, i, known))
                .collect::<Result<_>>()?;
            Ok(Form::Screws(ScrewTable { screws, base, tool }))
        }
        (true, true) => Err(root
            .error("a [[joint]] for each row of the table, [[screws]], or `urdf = ` was expected")),
        (false, false) => Err(root.error("either [[joint]] or [[screws]] was expected, not both")),
    }
}

fn convention(root: &Table<'_>) -> Result<Convention> {
    let field = root.require("convention", "\"standard\" or \"modified\"")?;
    match field.string()? {
        "standard" => Ok(Convention::Standard),
        "modified" => Ok(Convention::Modified),
        _ => Err(field.error("\"standard\" or \"modified\" was expected")),
    }
}

fn datasheet(root: &Table<'_>) -> Result<Vec<(String, String)>> {
    let Some(table) = root.table("datasheet")? else {
        return Ok(Vec::new());
    };
    table
        .fields()
        .map(|field| Ok((field.name().to_owned(), field.string()?.to_owned())))
        .collect()
}

fn golden(root: &Table<'_>) -> Result<Vec<Golden>> {
    root.tables("golden")?.iter().map(golden_pose).collect()
}

fn golden_pose(table: &Table<'_>) -> Result<Golden> {
    table.allow_only(&["q", "pose", "parameters", "source"])?;
    let q = table.require("q", "a list of joint values")?.numbers()?;
    let field = table.require("pose", "a 4x4 matrix, row by row")?;
    let rows: Vec<Vec<f64>> = field
        .items()?
        .iter()
        .map(Field::numbers)
        .collect::<Result<_>>()?;
    let pose = spatial::pose_from_rows(&rows).map_err(|error| field.error(&error.to_string()))?;
    let parameters = match table.table("parameters")? {
        None => Vec::new(),
        Some(table) => table
            .fields()
            .map(|field| Ok((field.name().to_owned(), field.number()?)))
            .collect::<Result<_>>()?,
    };
    Ok(Golden {
        q,
        pose,
        parameters,
    })
}
