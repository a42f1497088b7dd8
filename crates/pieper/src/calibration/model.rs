//! An arm's table as elementary motions, each a turn or a shift about or along an axis of the frame it stands in.

use super::drives::Drives;
use super::parameter::{Group, Groups, Parameter, Unit};
use crate::describe::dh::{Convention, DhTable, Moves};
use crate::describe::{Form, Readings, Robot};
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial::{Pose, to_rpy};

/// Neighbouring axes nearer to parallel than this get Hayati's turn about y: the common perpendicular of nearly parallel
/// axes jumps, and with it d and theta.
const NEARLY_PARALLEL: f64 = 0.1;

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
    pub(super) drives: Drives,
}

/// Spreads: 10 mm and 3 degrees for what is in a table, 50 mm and 10 degrees for frames, 2 percent for gears.
const SPREADS: [f64; 2] = [0.01, 0.05];
const FRAMES: [f64; 2] = [0.05, 0.17];
const GEAR: f64 = 0.02;

impl Model {
    /// The model of a described arm, with these groups of parameters. An arm that is no table is taken by the table of its chain.
    ///
    /// # Errors
    /// As [`Robot::chain`] and [`Robot::transmission`].
    pub fn of(robot: &Robot, groups: Groups) -> Result<Self> {
        let chain = robot.chain()?;
        let (table, values) = match &robot.form {
            Form::Dh(table) => (table.clone(), robot.values()?),
            _ => (
                DhTable::of_chain(&chain, Convention::Standard)?,
                crate::describe::expr::Values::new(),
            ),
        };
        let mut parameters = Vec::new();
        let drives = Drives::of(robot, &chain, groups.drive, &mut parameters)?;
        drives.with(
            &chain,
            &parameters.iter().map(|p| p.nominal).collect::<Vec<_>>(),
        )?;
        let mut model = Self {
            robot: robot.clone(),
            chain,
            elements: Vec::new(),
            starts: vec![0],
            parameters,
            drives,
        };
        model.frame("base", &table.base.pose(&values)?, Group::Base, groups);
        for (index, row) in table.rows.iter().enumerate() {
            let number = index + 1;
            let of = |expr: &crate::describe::Expr| expr.evaluate(&values);
            let (theta, d, a, alpha) = (of(&row.theta)?, of(&row.d)?, of(&row.a)?, of(&row.alpha)?);
            let gear = groups.gear.then(|| {
                model.parameter(format!("gear{number}"), Group::Gear, Unit::Ratio, 1.0, GEAR)
            });
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
        unit: Unit,
        nominal: f64,
        spread: f64,
    ) -> usize {
        self.parameters.push(Parameter {
            name,
            group,
            unit,
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
        let unit = match turns {
            true => Unit::Angle,
            false => Unit::Length,
        };
        let parameter = groups
            .has(group)
            .then(|| self.parameter(name, group, unit, value, spreads[usize::from(turns)]));
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

    /// The joint values that belong to what the arm's sensors told, with the description's own numbers.
    ///
    /// # Errors
    /// An input error for as many values as there are not, for values that are not finite; for motor values that no joint values belong to.
    pub fn joints(&self, readings: &Readings) -> Result<Vec<f64>> {
        match readings {
            Readings::Joints(q) => {
                self.chain.check_joint_values(q)?;
                Ok(q.clone())
            }
            Readings::Motors(motors) => {
                let mut q = vec![0.0; self.chain.dof()];
                let transmission = self.drives.with(&self.chain, &self.nominal())?;
                match transmission.joints(motors, &mut q)? {
                    Ok(()) => Ok(q),
                    Err(answer) => Err(Error::input("motor values", answer.to_string())),
                }
            }
        }
    }

    /// The motor values at joint values, with these values of the parameters. `None` where the drives cannot reach them.
    ///
    /// # Errors
    /// An input error unless there is one finite value for each joint; a model error for values that make no drives.
    pub fn motors(&self, values: &[f64], q: &[f64]) -> Result<Option<Vec<f64>>> {
        let transmission = self.drives.with(&self.chain, values)?;
        let mut motors = vec![0.0; q.len()];
        let reached = transmission.motors(q, &mut motors)?.is_ok();
        Ok(reached.then_some(motors))
    }

    /// The nominal values of the parameters.
    pub fn nominal(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.nominal).collect()
    }
}
