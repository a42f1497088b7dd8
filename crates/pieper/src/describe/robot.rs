//! A described arm: its form as written, its parameters, where its numbers come from.

use nalgebra::{Unit, Vector3};

use super::dh::DhTable;
use super::drives::MotorExpr;
use super::expr::{Expr, Values};
use super::screws::ScrewTable;
use crate::error::{Error, Result};
use crate::model::{Chain, Tree};
use crate::spatial::Pose;
use crate::transmission::Transmission;

/// An arm as a robot file or a URDF describes it. Symbols stay symbols until [`Robot::chain`] asks for numbers.
///
/// ```
/// use pieper::describe::Robot;
/// let text = r#"
/// name = "two links"
/// convention = "standard"
/// [parameters]
/// l1 = "300 mm"
/// [[joint]]
/// theta = "q1"
/// a = "l1"
/// [[joint]]
/// theta = "q2 - pi/2"
/// a = 0.2
/// "#;
/// let robot = Robot::from_toml("two.toml", text)?;
/// assert_eq!(robot.chain()?.dof(), 2);
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// The arm's name.
    pub name: String,
    /// One line for a listing.
    pub summary: String,
    /// Where the numbers come from.
    pub source: String,
    /// Which axis of the base frame points up in pictures.
    pub up: Up,
    /// What the maker says of it: payload, reach, mass; free text by key.
    pub datasheet: Vec<(String, String)>,
    /// The named lengths and angles, in order.
    pub parameters: Vec<Parameter>,
    /// The geometry.
    pub form: Form,
    /// The motors that do not drive the joint in their place directly.
    pub motors: Vec<MotorExpr>,
    /// Poses computed elsewhere, to check against.
    pub golden: Vec<Golden>,
}

/// The axis of a frame that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third, as nearly everywhere.
    #[default]
    Z,
}

impl Up {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Its letter.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    /// It as a vector.
    pub fn axis(self) -> Unit<Vector3<f64>> {
        match self {
            Self::X => Vector3::x_axis(),
            Self::Y => Vector3::y_axis(),
            Self::Z => Vector3::z_axis(),
        }
    }
}

/// A named length or angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name in formulas.
    pub name: String,
    /// Its value; `None` for a symbol whose value the user has to give.
    pub value: Option<Expr>,
}

/// The geometry in the form it was described in.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A Denavit-Hartenberg table.
    Dh(DhTable),
    /// Screw axes.
    Screws(ScrewTable),
    /// A chain taken out of a tree of links: a URDF.
    Tree {
        /// The tree.
        tree: Tree,
        /// Index of the chain's base link.
        base: usize,
        /// Index of the chain's tip link.
        tip: usize,
    },
}

/// A pose computed elsewhere, to check against.
#[derive(Clone, Debug, PartialEq)]
pub struct Golden {
    /// Joint values.
    pub q: Vec<f64>,
    /// The tool's pose there.
    pub pose: Pose,
    /// Values of the parameters that have none of their own.
    pub parameters: Vec<(String, f64)>,
}

impl Robot {
    /// The parameters that have no value yet and that the geometry needs, directly or through others.
    pub fn missing_parameters(&self) -> Vec<&str> {
        let symbols = match &self.form {
            Form::Dh(table) => table.symbols(),
            Form::Screws(table) => table.symbols(),
            Form::Tree { .. } => Vec::new(),
        };
        let mut needed = symbols;
        let mut next = 0;
        let mut missing = Vec::new();
        while next < needed.len() {
            let name = needed[next];
            next += 1;
            match self
                .parameters
                .iter()
                .find(|parameter| parameter.name == name)
            {
                Some(Parameter {
                    value: Some(value), ..
                }) => {
                    for symbol in value.symbols() {
                        if !needed.contains(&symbol) {
                            needed.push(symbol);
                        }
                    }
                }
                _ => missing.push(name),
            }
        }
        missing
    }

    /// The same arm with these parameters set.
    ///
    /// # Errors
    /// An input error for a name that is no parameter of the arm, with the names there are.
    pub fn with_parameters<'a>(
        &self,
        values: impl IntoIterator<Item = (&'a str, Expr)>,
    ) -> Result<Self> {
        let mut robot = self.clone();
        for (name, value) in values {
            let Some(parameter) = robot.parameters.iter_mut().find(|p| p.name == name) else {
                let names: Vec<_> = self.parameters.iter().map(|p| p.name.as_str()).collect();
                let text = match &names[..] {
                    [] => format!("{} has no parameters", self.name),
                    names => format!("the parameters of {} are {}", self.name, names.join(", ")),
                };
                return Err(Error::input(format!("parameter {name}"), text));
            };
            parameter.value = Some(value);
        }
        Ok(robot)
    }

    /// The values of the parameters that have one.
    ///
    /// # Errors
    /// A model error for parameters defined by one another in a circle; an input error for a value that is not finite.
    pub fn values(&self) -> Result<Values> {
        let mut values = Values::new();
        let mut open: Vec<&Parameter> = self
            .parameters
            .iter()
            .filter(|p| p.value.is_some())
            .collect();
        loop {
            let before = open.len();
            let mut rest = Vec::new();
            for parameter in open {
                let Some(expr) = &parameter.value else {
                    continue;
                };
                if expr
                    .symbols()
                    .iter()
                    .all(|symbol| values.contains_key(*symbol))
                {
                    values.insert(parameter.name.clone(), expr.evaluate(&values)?);
                } else {
                    rest.push(parameter);
                }
            }
            if rest.is_empty() {
                return Ok(values);
            }
            if rest.len() == before {
                return self.unresolved(&rest).map(|()| values);
            }
            open = rest;
        }
    }

    /// An error if the parameters left over form a circle; those that wait for a missing value are no error yet.
    fn unresolved(&self, rest: &[&Parameter]) -> Result<()> {
        let waits_for_missing = |parameter: &Parameter| {
            let mut seen = vec![parameter.name.as_str()];
            let mut next = 0;
            while next < seen.len() {
                let found = self.parameters.iter().find(|p| p.name == seen[next]);
                let Some(value) = found.and_then(|p| p.value.as_ref()) else {
                    return true;
                };
                for symbol in value.symbols() {
                    if !seen.contains(&symbol) {
                        seen.push(symbol);
                    }
                }
                next += 1;
            }
            false
        };
        match rest.iter().find(|parameter| !waits_for_missing(parameter)) {
            None => Ok(()),
            Some(parameter) => {
                let subject = format!("parameter {}", parameter.name);
                Err(Error::model(
                    subject,
                    "it is defined by itself, in a circle",
                ))
            }
        }
    }

    /// A robot out of a tree of links: the chain from `base` to `tip`, by default from the root to the likeliest tip.
    ///
    /// # Errors
    /// An input error if there is no such link, with the names there are, or if `base` does not carry `tip`; a model
    /// error if nothing moves between them.
    pub fn of_tree(tree: Tree, base: Option<&str>, tip: Option<&str>) -> Result<Self> {
        let base = base.map_or(Ok(tree.root()), |name| tree.link_index(name))?;
        let tip = tip.map_or(Ok(tree.default_tip()), |name| tree.link_index(name))?;
        tree.chain(base, tip)?;
        Ok(Self {
            name: tree.name().to_owned(),
            summary: String::new(),
            source: String::new(),
            up: Up::default(),
            datasheet: Vec::new(),
            parameters: Vec::new(),
            form: Form::Tree { tree, base, tip },
            motors: Vec::new(),
            golden: Vec::new(),
        })
    }

    /// The arm as a chain of numbers.
    ///
    /// # Errors
    /// A missing-value error that names every parameter without a value, and how to give one; model errors.
    pub fn chain(&self) -> Result<Chain> {
        let missing = self.missing_parameters();
        if !missing.is_empty() {
            let plural = if missing.len() == 1 {
                "parameter"
            } else {
                "parameters"
            };
            let text = format!("numbers are needed for the {plural} {}", missing.join(", "));
            return Err(Error::missing_value(self.name.clone(), text));
        }
        match &self.form {
            Form::Dh(table) => table.chain(&self.values()?),
            Form::Screws(table) => table.chain(&self.values()?),
            Form::Tree { tree, base, tip } => tree.chain(*base, *tip),
        }
    }

    /// The arm's transmission in numbers: from joints to motors and back. Direct where the file has none.
    ///
    /// # Errors
    /// As [`Robot::chain`]; a missing-value error for a symbol of the transmission without a value; a model error for
    /// numbers that make no motor, or motors that do not determine the joints.
    pub fn transmission(&self) -> Result<Transmission> {
        let chain = self.chain()?;
        let values = self.values()?;
        let motors = self
            .motors
            .iter()
            .map(|motor| Ok((motor.place, motor.motor(&chain, &values)?)));
        Transmission::new(&chain, motors.collect::<Result<Vec<_>>>()?)
    }
}

impl Form {
    /// The number of joint variables.
    pub fn dof(&self) -> usize {
        match self {
            Self::Dh(table) => table.rows.len(),
            Self::Screws(table) => table.screws.len(),
            Self::Tree { tree, base, tip } => {
                tree.chain(*base, *tip).map_or(0, |chain| chain.dof())
            }
        }
    }
}
