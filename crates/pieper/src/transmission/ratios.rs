//! Speeds, torques and Jacobians over a transmission.

use nalgebra::{DMatrix, Matrix6xX};

use super::answer::OutOfReach;
use super::{Block, Transmission};
use crate::error::{Error, Result};

/// How fast motors turn for joints and joints for motors, at one joint vector.
///
/// ```
/// use pieper::describe::Robot;
/// use pieper::transmission::Ratios;
/// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n
///     [[transmission]]\nkind = 'linear'\nmotor = 'm1'\njoints = { q1 = 1 }\nratio = 50";
/// let transmission = Robot::from_toml("r.toml", text)?.transmission()?;
/// let mut ratios = Ratios::zeros(1);
/// transmission.ratios(&[0.3], &mut ratios)?.expect("no dead point");
/// let mut torque = [0.0];
/// ratios.motor_torques(&[100.0], &mut torque)?;
/// assert_eq!(torque, [2.0]); // the gear makes a small torque a large one
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ratios {
    motors_by_joints: DMatrix<f64>,
    joints_by_motors: DMatrix<f64>,
}

impl Ratios {
    /// Room for `dof` motors.
    pub fn zeros(dof: usize) -> Self {
        Self {
            motors_by_joints: DMatrix::zeros(dof, dof),
            joints_by_motors: DMatrix::zeros(dof, dof),
        }
    }

    /// d motor / d joint: a row for each motor, a column for each joint.
    pub fn motors_by_joints(&self) -> &DMatrix<f64> {
        &self.motors_by_joints
    }

    /// d joint / d motor: a row for each joint, a column for each motor. The inverse of the other.
    pub fn joints_by_motors(&self) -> &DMatrix<f64> {
        &self.joints_by_motors
    }

    /// The motors' speeds for the joints': `D qdot`.
    ///
    /// # Errors
    /// An input error unless both have one value for each motor.
    pub fn motor_rates(&self, joint_rates: &[f64], motor_rates: &mut [f64]) -> Result<()> {
        product(&self.motors_by_joints, joint_rates, motor_rates)
    }

    /// The joints' speeds for the motors': `D^-1 mdot`.
    ///
    /// # Errors
    /// As [`Ratios::motor_rates`].
    pub fn joint_rates(&self, motor_rates: &[f64], joint_rates: &mut [f64]) -> Result<()> {
        product(&self.joints_by_motors, motor_rates, joint_rates)
    }

    /// The motors' torques for the joints': `D^-T tau`. Power is the same on either side: the drive is without friction.
    ///
    /// # Errors
    /// As [`Ratios::motor_rates`].
    pub fn motor_torques(&self, joint_torques: &[f64], motor_torques: &mut [f64]) -> Result<()> {
        product_of_columns(&self.joints_by_motors, joint_torques, motor_torques)
    }

    /// The joints' torques for the motors': `D^T tau_m`.
    ///
    /// # Errors
    /// As [`Ratios::motor_rates`].
    pub fn joint_torques(&self, motor_torques: &[f64], joint_torques: &mut [f64]) -> Result<()> {
        product_of_columns(&self.motors_by_joints, motor_torques, joint_torques)
    }

    /// The geometric Jacobian by motors, from the one by joints at the same joint vector: `J D^-1`. Its columns are the
    /// tool's twist for a unit speed of each motor.
    ///
    /// # Errors
    /// An input error unless the Jacobian has a column for each motor.
    pub fn motor_jacobian(&self, jacobian: &Matrix6xX<f64>) -> Result<Matrix6xX<f64>> {
        check(&self.joints_by_motors, jacobian.ncols(), "Jacobian columns")?;
        Ok(jacobian * &self.joints_by_motors)
    }
}

impl Transmission {
    /// The ratios at the joint vector `q`, into `ratios`, which is resized if it has another size and not allocated
    /// otherwise.
    ///
    /// # Errors
    /// An input error unless `q` has one finite value for each joint. Within: the first linkage that cannot reach `q`, or
    /// that stands at a dead point there (nearer than 1e-8 rad), where one ratio is infinite. Limits are no matter.
    pub fn ratios(&self, q: &[f64], ratios: &mut Ratios) -> Result<Result<(), OutOfReach<'_>>> {
        self.check(q, "joint")?;
        if ratios.motors_by_joints.nrows() != self.dof() {
            *ratios = Ratios::zeros(self.dof());
        }
        ratios.motors_by_joints.fill(0.0);
        for (row, motor) in self.all().iter().enumerate() {
            if let Some(answer) = motor.at_dead_point(q) {
                return Ok(Err(answer));
            }
            for variable in motor.variables() {
                match motor.derivative(variable, q) {
                    Ok(slope) => ratios.motors_by_joints[(row, variable)] = slope,
                    Err(answer) => return Ok(Err(answer)),
                }
            }
        }
        ratios.joints_by_motors.fill(0.0);
        for block in &self.blocks {
            invert(
                block,
                &ratios.motors_by_joints,
                &mut ratios.joints_by_motors,
            );
        }
        Ok(Ok(()))
    }
}

/// The rows of the block's joints: what its motors do, less what the joints before it do to them.
fn invert(block: &Block, forward: &DMatrix<f64>, inverse: &mut DMatrix<f64>) {
    for column in 0..forward.ncols() {
        for (row, &joint) in block.joints.iter().enumerate() {
            let sum = block.motors.iter().enumerate().map(|(k, &motor)| {
                let own = if motor == column { 1.0 } else { 0.0 };
                let others = (0..forward.ncols()).filter(|other| !block.joints.contains(other));
                let before: f64 = others
                    .map(|other| forward[(motor, other)] * inverse[(other, column)])
                    .sum();
                let factor = match block.joints.len() {
                    1 => 1.0 / forward[(motor, joint)],
                    _ => block.inverse[(row, k)],
                };
                factor * (own - before)
            });
            let value = sum.sum();
            inverse[(joint, column)] = value;
        }
    }
}

fn check(matrix: &DMatrix<f64>, count: usize, of: &str) -> Result<()> {
    if count == matrix.nrows() {
        return Ok(());
    }
    let text = format!("{} were expected, {count} were given", matrix.nrows());
    Err(Error::input(of, text))
}

fn product(matrix: &DMatrix<f64>, values: &[f64], out: &mut [f64]) -> Result<()> {
    check(matrix, values.len(), "values")?;
    check(matrix, out.len(), "places for values")?;
    for (out, row) in out.iter_mut().zip(matrix.row_iter()) {
        *out = row.iter().zip(values).map(|(a, b)| a * b).sum();
    }
    Ok(())
}

fn product_of_columns(matrix: &DMatrix<f64>, values: &[f64], out: &mut [f64]) -> Result<()> {
    check(matrix, values.len(), "values")?;
    check(matrix, out.len(), "places for values")?;
    for (out, column) in out.iter_mut().zip(matrix.column_iter()) {
        *out = column.iter().zip(values).map(|(a, b)| a * b).sum();
    }
    Ok(())
}
