//! Analytic Jacobians: rates of orientation parameters instead of angular velocity.

use nalgebra::{DMatrix, Matrix3, MatrixXx3, Rotation3, UnitQuaternion, Vector3};

use super::jacobian::{Jacobian, Reference, pose_and_jacobian};
use crate::error::{Error, Result};
use crate::model::Chain;
use crate::spatial;

/// A way to write an orientation as numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Fixed-axis roll, pitch, yaw: `R = Rz(yaw) Ry(pitch) Rx(roll)`. Singular at pitch = +-pi/2.
    RollPitchYaw,
    /// Euler angles of moving axes: `R = Rz(phi) Ry(theta) Rz(psi)`. Singular at theta = 0 and pi.
    EulerZyz,
    /// The rotation vector: unit axis times angle, angle in [0, pi]. Singular nowhere short of a full turn.
    RotationVector,
    /// The unit quaternion w, x, y, z with w >= 0 at the pose: four numbers, singular nowhere.
    Quaternion,
}

/// Below this sine the parameters' rates exceed a thousand million times the angular velocity.
const MIN_SINE: f64 = 1e-9;

impl Orientation {
    /// The parameters of a rotation.
    pub fn parameters(self, rotation: &Rotation3<f64>) -> Vec<f64> {
        match self {
            Self::RollPitchYaw => spatial::to_rpy(rotation).to_vec(),
            Self::EulerZyz => {
                let m = rotation.matrix();
                let sine = m[(0, 2)].hypot(m[(1, 2)]);
                let theta = sine.atan2(m[(2, 2)]);
                if sine < MIN_SINE {
                    return vec![m[(1, 0)].atan2(m[(0, 0)]), theta, 0.0];
                }
                vec![
                    m[(1, 2)].atan2(m[(0, 2)]),
                    theta,
                    m[(2, 1)].atan2(-m[(2, 0)]),
                ]
            }
            Self::RotationVector => UnitQuaternion::from_rotation_matrix(rotation)
                .scaled_axis()
                .as_slice()
                .to_vec(),
            Self::Quaternion => {
                let q = positive(rotation);
                vec![q.w, q.i, q.j, q.k]
            }
        }
    }

    /// The matrix that takes the base-frame angular velocity to the parameters' rates.
    ///
    /// # Errors
    /// An input error at a singularity of the parameters, where some angular velocity has no rates.
    fn rates(self, rotation: &Rotation3<f64>) -> Result<MatrixXx3<f64>> {
        let dynamic = |m: Matrix3<f64>| m.resize_vertically(3, 0.0);
        match self {
            Self::RollPitchYaw => {
                let [_, pitch, yaw] = spatial::to_rpy(rotation);
                let ((sp, cp), (sy, cy)) = (pitch.sin_cos(), yaw.sin_cos());
                let axes = Matrix3::new(cy * cp, -sy, 0.0, sy * cp, cy, 0.0, -sp, 0.0, 1.0);
                Ok(dynamic(invert(
                    axes,
                    cp,
                    "roll, pitch, yaw at pitch = +-90 degrees",
                )?))
            }
            Self::EulerZyz => {
                let parameters = self.parameters(rotation);
                let ((sf, cf), (st, ct)) = (parameters[0].sin_cos(), parameters[1].sin_cos());
                let axes = Matrix3::new(0.0, -sf, cf * st, 0.0, cf, sf * st, 1.0, 0.0, ct);
                Ok(dynamic(invert(
                    axes,
                    st,
                    "Euler angles z-y-z at theta = 0 or 180 degrees",
                )?))
            }
            Self::RotationVector => {
                let vector = UnitQuaternion::from_rotation_matrix(rotation).scaled_axis();
                Ok(dynamic(rotation_vector_rates(&vector)))
            }
            Self::Quaternion => {
                let q = positive(rotation);
                let v = q.imag();
                let upper = -0.5 * v.transpose();
                let lower = 0.5 * (Matrix3::identity() * q.w - v.cross_matrix());
                Ok(MatrixXx3::from_fn(4, |i, j| {
                    if i == 0 { upper[j] } else { lower[(i - 1, j)] }
                }))
            }
        }
    }
}

fn positive(rotation: &Rotation3<f64>) -> UnitQuaternion<f64> {
    let q = UnitQuaternion::from_rotation_matrix(rotation);
    if q.w < 0.0 {
        UnitQuaternion::new_unchecked(-q.into_inner())
    } else {
        q
    }
}

fn invert(axes: Matrix3<f64>, sine: f64, what: &str) -> Result<Matrix3<f64>> {
    let inverse = axes.try_inverse().filter(|_| sine.abs() > MIN_SINE);
    inverse
        .ok_or_else(|| Error::input("analytic Jacobian", format!("it does not exist for {what}")))
}

/// Inverse of the left Jacobian of SO(3): `1 - [r]/2 + (1/t^2 - (1 + cos t)/(2 t sin t)) [r]^2`, `t = |r|`.
fn rotation_vector_rates(r: &Vector3<f64>) -> Matrix3<f64> {
    let angle = r.norm();
    let cross = r.cross_matrix();
    let factor = if angle < 1e-2 {
        // Series: the closed form cancels.
        let square = angle * angle;
        1.0 / 12.0 + square * (1.0 / 720.0 + square / 30240.0)
    } else {
        (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle)
    };
    Matrix3::identity() - 0.5 * cross + factor * cross * cross
}

/// The analytic Jacobian at `q`: rows are the rates of x, y, z and of the orientation's parameters (three, or four for
/// the quaternion), base frame.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable, or at a singularity of the parameters.
pub fn analytic_jacobian(
    chain: &Chain,
    q: &[f64],
    orientation: Orientation,
) -> Result<DMatrix<f64>> {
    let mut geometric = Jacobian::zeros(chain.dof());
    let pose = pose_and_jacobian(chain, q, Reference::Base, &mut geometric)?;
    let angular = orientation.rates(&pose.rotation)? * geometric.fixed_rows::<3>(3);
    let mut analytic = DMatrix::zeros(3 + angular.nrows(), chain.dof());
    analytic
        .rows_mut(0, 3)
        .copy_from(&geometric.fixed_rows::<3>(0));
    analytic.rows_mut(3, angular.nrows()).copy_from(&angular);
    Ok(analytic)
}
