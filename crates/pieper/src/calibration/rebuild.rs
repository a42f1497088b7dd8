//! The arm with other numbers: as a chain, and as a description.

use nalgebra::Vector3;

use super::model::{Elementary, Model};
use super::parameter::Group;
use crate::describe::dh::{DhTable, FrameExpr};
use crate::describe::expr::Expr;
use crate::describe::screws::ScrewTable;
use crate::describe::{Form, Robot};
use crate::error::{Error, Result};
use crate::model::{Chain, ChainParts, Drive, Joint, Motion};
use crate::spatial::{Pose, shift, turn};

impl Model {
    /// The arm as a chain with these values of the parameters.
    ///
    /// # Errors
    /// A model error for values that are not finite.
    pub fn chain_with(&self, values: &[f64]) -> Result<Chain> {
        let pose_of = |elements: &[Elementary]| {
            let mut pose = Pose::identity();
            for element in elements {
                let axis = Vector3::ith_axis(element.axis);
                let by = element.parameter.map_or(element.value, |p| values[p]);
                pose *= match element.turns {
                    true => turn(
                        &axis,
                        crate::spatial::sin_cos_exact(crate::spatial::snap(by)),
                    ),
                    false => shift(axis.into_inner() * by),
                };
            }
            pose
        };
        let part = |k: usize| &self.elements[self.starts[k]..self.starts[k + 1]];
        let dof = self.chain.dof();
        let mut joints = Vec::with_capacity(dof);
        for (index, variable) in self.chain.variables().iter().enumerate() {
            let row = part(index + 1);
            let at = row.iter().position(|element| element.drive.is_some());
            let at = at.ok_or_else(|| Error::model("calibration", "a row that moves nothing"))?;
            let element = &row[at];
            let (variable_index, sign, gear) = element.drive.unwrap_or((index, 1.0, None));
            let drive = Drive {
                variable: variable_index,
                factor: sign * gear.map_or(1.0, |g| values[g]),
                offset: element.parameter.map_or(element.value, |p| values[p]),
            };
            joints.push(Joint {
                name: variable.name.clone(),
                link: (index + 1).to_string(),
                before: pose_of(&row[..at]),
                motion: match element.turns {
                    true => Motion::turn_z(drive),
                    false => Motion::slide_z(drive),
                },
                after: pose_of(&row[at + 1..]),
            });
        }
        Chain::new(ChainParts {
            variables: self.chain.variables().to_vec(),
            joints,
            base: pose_of(part(0)),
            tool: pose_of(part(dof + 1)),
        })
    }

    /// The arm as a description with these values of the parameters: a table of the same convention, or screws where Hayati's turns
    /// or gears are no part of a table.
    ///
    /// # Errors
    /// As [`Model::chain_with`].
    pub fn robot_with(&self, values: &[f64], source: String) -> Result<Robot> {
        let chain = self.chain_with(values)?;
        let is_table = self
            .parameters
            .iter()
            .zip(values)
            .all(|(parameter, value)| match parameter.group {
                Group::Beta => *value == 0.0,
                Group::Gear => *value == 1.0,
                _ => true,
            });
        let form = match (&self.robot.form, is_table) {
            (Form::Dh(table), true) => Form::Dh(self.table_with(table, values)?),
            _ => Form::Screws(ScrewTable::of_chain(&chain)?),
        };
        Ok(Robot {
            name: format!("{}, calibrated", self.robot.name),
            summary: self.robot.summary.clone(),
            source,
            up: self.robot.up,
            datasheet: self.robot.datasheet.clone(),
            // Every formula has become a number: what the nominal lengths were called would say something that is no longer so.
            parameters: Vec::new(),
            form,
            motors: self.drives.motors_with(values),
            golden: Vec::new(),
        })
    }

    /// The table with numbers in the places of its formulas.
    fn table_with(&self, table: &DhTable, values: &[f64]) -> Result<DhTable> {
        let mut table = table.clone();
        let numbers = self.robot.values()?;
        let named = |name: &str| {
            let index = self.parameters.iter().position(|p| p.name == name);
            index.map(|index| values[index])
        };
        for (index, row) in table.rows.iter_mut().enumerate() {
            let number = index + 1;
            for (what, place) in [
                ("theta", &mut row.theta),
                ("d", &mut row.d),
                ("a", &mut row.a),
                ("alpha", &mut row.alpha),
            ] {
                let value = match named(&format!("{what}{number}")) {
                    Some(value) => value,
                    None => place.evaluate(&numbers)?,
                };
                *place = Expr::number(value);
            }
            // Limits and rates keep their numbers, whose symbols are gone.
            let joint = &mut row.joint;
            let fixed = |expr: &mut Expr| -> Result<()> {
                *expr = Expr::number(expr.evaluate(&numbers)?);
                Ok(())
            };
            for expr in joint.limits.iter_mut().flatten() {
                fixed(expr)?;
            }
            for expr in [&mut joint.velocity, &mut joint.acceleration]
                .into_iter()
                .flatten()
            {
                fixed(expr)?;
            }
        }
        let chain = self.chain_with(values)?;
        table.base = FrameExpr::of_pose(chain.base());
        table.tool = FrameExpr::of_pose(chain.tool());
        Ok(table)
    }
}
