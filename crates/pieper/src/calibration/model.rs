//! An arm's table as elementary motions, each a turn or a shift about or along an axis of the frame it stands in.

use nalgebra::{Rotation3, Translation3, Unit, Vector3};

use crate::describe::dh::{Convention, DhTable, Moves};
use crate::describe::{Form, Robot};
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial::{Pose, shift, to_rpy};

/// Neighbouring axes nearer to parallel than this get Hayati's turn about y: the common perpendicular of nearly parallel
/// axes jumps, and with it d and theta.
const NEARLY_PARALLEL: f64 = 0.1;

/// What kind of number a parameter is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Joint offsets.
    Theta,
    /// Shifts along the joint axes.
    D,
    /// Lengths of links.
    A,
    /// Twists of links.
    Alpha,
    /// Hayati's turn about y, between nearly parallel axes.
    Beta,
    /// Turns of the joint for one of its value.
    Gear,
    /// The arm's place in the measuring device's frame.
    Base,
    /// The tool in the last frame.
    Tool,
    /// Of the measurement: the place of an anchor, a plane, a contact.
    Set,
}

/// Which groups are estimated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "as in Group")]
pub struct Groups {
    pub theta: bool,
    pub d: bool,
    pub a: bool,
    pub alpha: bool,
    pub beta: bool,
    pub gear: bool,
    pub base: bool,
    pub tool: bool,
}

impl Groups {
    /// None.
    pub const NONE: Self = Self {
        theta: false,
        d: false,
        a: false,
        alpha: false,
        beta: false,
        gear: false,
        base: false,
        tool: false,
    };

    /// The table, the base and the tool; not the gears.
    pub const USUAL: Self = Self {
        theta: true,
        d: true,
        a: true,
        alpha: true,
        beta: true,
        gear: false,
        base: true,
        tool: true,
    };

    /// By names separated by commas: theta, d, a, alpha, beta, gear, base, tool.
    ///
    /// # Errors
    /// An input error that names the word and the choices.
    pub fn parse(text: &str) -> Result<Self> {
        let mut groups = Self::NONE;
        for word in text
            .split(',')
            .map(str::trim)
            .filter(|word| !word.is_empty())
        {
            let flag = match word {
                "theta" => &mut groups.theta,
                "d" => &mut groups.d,
                "a" => &mut groups.a,
                "alpha" => &mut groups.alpha,
                "beta" => &mut groups.beta,
                "gear" => &mut groups.gear,
                "base" => &mut groups.base,
                "tool" => &mut groups.tool,
                _ => {
                    let text = "theta, d, a, alpha, beta, gear, base or tool was expected";
                    return Err(Error::input(format!("parameters: {word}"), text));
                }
            };
            *flag = true;
        }
        Ok(groups)
    }

    fn has(self, group: Group) -> bool {
        match group {
            Group::Theta => self.theta,
            Group::D => self.d,
            Group::A => self.a,
            Group::Alpha => self.alpha,
            Group::Beta => self.beta,
            Group::Gear => self.gear,
            Group::Base => self.base,
            Group::Tool => self.tool,
            Group::Set => true,
        }
    }
}

/// A number that may be wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// `theta1`, `d1`, `a1`, `alpha1`, `beta1`, `gear1`, `base.x`, `tool.roll`, ...
    pub name: String,
    /// Its kind.
    pub group: Group,
    /// Whether it is an angle (radians), rather than a length (metres) or a ratio.
    pub is_angle: bool,
    /// The description's value.
    pub nominal: f64,
    /// How far from it the true value may be: the scale in which parameters are compared.
    pub spread: f64,
}

/// A turn about, or a shift along, an axis of the frame that the motions before it lead to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elementary {
    pub(super) turns: bool,
    pub(super) axis: usize,
    pub(super) value: f64,
    /// The joint whose value is added, its sign, and its gear's parameter.
    pub(super) drive: Option<(usize, f64, Option<usize>)>,
    pub(super) parameter: Option<usize>,
}

/// An arm whose numbers may be wrong.
#[derive(Clone, Debug)]
pub struct Model {
    pub(super) robot: Robot,
    pub(super) chain: Chain,
    pub(super) elements: Vec<Elementary>,
    /// The first element of each row, base and tool between them: `elements[starts[k]..starts[k + 1]]`.
    pub(super) starts: Vec<usize>,
    pub(super) parameters: Vec<Parameter>,
}

/// Where the tool is, and how it moves with each parameter.
#[derive(Clone, Debug)]
pub(super) struct Sensed {
    pub(super) tool: Pose,
    /// For each parameter: the tool frame's angular and linear rate, base axes.
    pub(super) rates: Vec<[Vector3<f64>; 2]>,
}

/// Spreads: 10 mm and 3 degrees for what is in a table, 50 mm and 10 degrees for frames, 2 percent for gears.
const SPREADS: [f64; 2] = [0.01, 0.05];
const FRAMES: [f64; 2] = [0.05, 0.17];
const GEAR: f64 = 0.02;

impl Model {
    /// The model of a described arm, with these groups of parameters. An arm that is no table is taken by the table of its chain.
    ///
    /// # Errors
    /// As [`Robot::chain`].
    pub fn of(robot: &Robot, groups: Groups) -> Result<Self> {
        let chain = robot.chain()?;
        let (table, values) = match &robot.form {
            Form::Dh(table) => (table.clone(), robot.values()?),
            _ => (
                DhTable::of_chain(&chain, Convention::Standard)?,
                crate::describe::expr::Values::new(),
            ),
        };
        let mut model = Self {
            robot: robot.clone(),
            chain,
            elements: Vec::new(),
            starts: vec![0],
            parameters: Vec::new(),
        };
        model.frame("base", &table.base.pose(&values)?, Group::Base, groups);
        for (index, row) in table.rows.iter().enumerate() {
            let number = index + 1;
            let of = |expr: &crate::describe::Expr| expr.evaluate(&values);
            let (theta, d, a, alpha) = (of(&row.theta)?, of(&row.d)?, of(&row.a)?, of(&row.alpha)?);
            let gear = groups
                .gear
                .then(|| model.parameter(format!("gear{number}"), Group::Gear, false, 1.0, GEAR));
            let drive = Some((index, row.sign, gear));
            let (turned, slid) = match row.moves {
                Moves::Theta => (drive, None),
                Moves::D => (None, drive),
            };
            // Between the last axis and the tool, or the base and the first, there are no neighbouring axes.
            let is_between = match table.convention {
                Convention::Standard => number < table.rows.len(),
                Convention::Modified => index > 0,
            };
            let is_parallel = is_between && alpha.sin().abs() < NEARLY_PARALLEL;
            let z = |model: &mut Self| {
                model.element(
                    true,
                    2,
                    theta,
                    turned,
                    format!("theta{number}"),
                    Group::Theta,
                    groups,
                );
                model.element(false, 2, d, slid, format!("d{number}"), Group::D, groups);
            };
            let x = |model: &mut Self| {
                model.element(false, 0, a, None, format!("a{number}"), Group::A, groups);
                model.element(
                    true,
                    0,
                    alpha,
                    None,
                    format!("alpha{number}"),
                    Group::Alpha,
                    groups,
                );
            };
            let y = |model: &mut Self| {
                if is_parallel {
                    model.element(
                        true,
                        1,
                        0.0,
                        None,
                        format!("beta{number}"),
                        Group::Beta,
                        groups,
                    );
                }
            };
            match table.convention {
                Convention::Standard => {
                    z(&mut model);
                    x(&mut model);
                    y(&mut model);
                }
                Convention::Modified => {
                    y(&mut model);
                    x(&mut model);
                    z(&mut model);
                }
            }
            model.starts.push(model.elements.len());
        }
        model.frame("tool", &table.tool.pose(&values)?, Group::Tool, groups);
        Ok(model)
    }

    /// The arm as described.
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// Its chain as described.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The parameters.
    pub fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn parameter(
        &mut self,
        name: String,
        group: Group,
        is_angle: bool,
        nominal: f64,
        spread: f64,
    ) -> usize {
        self.parameters.push(Parameter {
            name,
            group,
            is_angle,
            nominal,
            spread,
        });
        self.parameters.len() - 1
    }

    #[allow(clippy::too_many_arguments, reason = "a row of a table has so many")]
    fn element(
        &mut self,
        turns: bool,
        axis: usize,
        value: f64,
        drive: Option<(usize, f64, Option<usize>)>,
        name: String,
        group: Group,
        groups: Groups,
    ) {
        let spreads = match group {
            Group::Base | Group::Tool => FRAMES,
            _ => SPREADS,
        };
        let parameter = groups
            .has(group)
            .then(|| self.parameter(name, group, turns, value, spreads[usize::from(turns)]));
        self.elements.push(Elementary {
            turns,
            axis,
            value,
            drive,
            parameter,
        });
    }

    fn frame(&mut self, name: &str, pose: &Pose, group: Group, groups: Groups) {
        let p = pose.translation.vector;
        let [roll, pitch, yaw] = to_rpy(&pose.rotation);
        let shifts = [("x", 0, p.x), ("y", 1, p.y), ("z", 2, p.z)];
        for (what, axis, value) in shifts {
            self.element(
                false,
                axis,
                value,
                None,
                format!("{name}.{what}"),
                group,
                groups,
            );
        }
        for (what, axis, value) in [("yaw", 2, yaw), ("pitch", 1, pitch), ("roll", 0, roll)] {
            self.element(
                true,
                axis,
                value,
                None,
                format!("{name}.{what}"),
                group,
                groups,
            );
        }
        self.starts.push(self.elements.len());
    }

    /// The pose of one element at joint values, with these values of the parameters.
    fn displacement(&self, element: &Elementary, values: &[f64], q: &[f64]) -> f64 {
        let own = element.parameter.map_or(element.value, |p| values[p]);
        let driven = element.drive.map_or(0.0, |(joint, sign, gear)| {
            sign * gear.map_or(1.0, |g| values[g]) * q[joint]
        });
        own + driven
    }

    /// Where the tool is with these values of the parameters, and how it moves with each.
    ///
    /// `q` and `values` must be long enough.
    pub(super) fn sense(&self, values: &[f64], q: &[f64]) -> Sensed {
        let mut frame = Pose::identity();
        // For each parameter: whether it turns, the axis times what a unit of it does, and a point on the axis.
        let still = (false, Vector3::zeros(), Vector3::zeros());
        let mut moves = vec![still; self.parameters.len()];
        for element in &self.elements {
            let axis = Vector3::ith(element.axis, 1.0);
            let along = frame.rotation * axis;
            let place = frame.translation.vector;
            if let Some(parameter) = element.parameter {
                moves[parameter] = (element.turns, along, place);
            }
            if let Some((joint, sign, Some(gear))) = element.drive {
                moves[gear] = (element.turns, along * (sign * q[joint]), place);
            }
            let by = self.displacement(element, values, q);
            frame *= match element.turns {
                true => Pose::from_parts(
                    Translation3::identity(),
                    Rotation3::from_axis_angle(&Unit::new_unchecked(axis), by),
                ),
                false => shift(axis * by),
            };
        }
        let tool = frame.translation.vector;
        let rate = |(turns, along, place): (bool, Vector3<f64>, Vector3<f64>)| match turns {
            true => [along, along.cross(&(tool - place))],
            false => [Vector3::zeros(), along],
        };
        let rates = moves.into_iter().map(rate).collect();
        Sensed { tool: frame, rates }
    }

    /// How the tool frame moves with each parameter: angular and linear rate in the base's axes, for a unit a second.
    ///
    /// As many values as parameters and as many joint values as joints are expected.
    pub fn rates(&self, values: &[f64], q: &[f64]) -> Vec<[Vector3<f64>; 2]> {
        self.sense(values, q).rates
    }

    /// The nominal values of the parameters.
    pub fn nominal(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.nominal).collect()
    }
}
