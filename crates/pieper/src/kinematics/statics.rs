//! Velocities and forces: what the Jacobian is for.

use nalgebra::Vector6;

use super::jacobian::Jacobian;
use crate::error::{Error, Result};

/// The tool's twist `(v, omega) = J qdot`, m/s and rad/s, in the Jacobian's reference.
///
/// # Errors
/// An input error unless `rates` has one value for each column.
pub fn twist(jacobian: &Jacobian, rates: &[f64]) -> Result<Vector6<f64>> {
    if rates.len() != jacobian.ncols() {
        let text = format!(
            "{} were expected, {} were given",
            jacobian.ncols(),
            rates.len()
        );
        return Err(Error::input("joint rates", text));
    }
    let columns = jacobian.column_iter().zip(rates);
    Ok(columns.fold(Vector6::zeros(), |sum, (column, rate)| sum + column * *rate))
}

/// The joint torques (N m) and forces (N) `tau = J^T wrench` that balance a wrench `(force, moment)` at the tool point,
/// into `torques`.
///
/// The wrench is written in the Jacobian's reference: force in N, moment in N m about the tool point. What the arm
/// must exert on its joints to apply this wrench to its surroundings, friction and weight aside.
///
/// # Errors
/// An input error unless `torques` has one place for each column.
pub fn joint_torques(
    jacobian: &Jacobian,
    wrench: &Vector6<f64>,
    torques: &mut [f64],
) -> Result<()> {
    if torques.len() != jacobian.ncols() {
        let text = format!(
            "room for {} was expected, there is room for {}",
            jacobian.ncols(),
            torques.len()
        );
        return Err(Error::input("joint torques", text));
    }
    for (torque, column) in torques.iter_mut().zip(jacobian.column_iter()) {
        *torque = column.dot(wrench);
    }
    Ok(())
}
