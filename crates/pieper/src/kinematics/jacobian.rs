//! The geometric Jacobian.

use nalgebra::{Matrix6xX, Vector3};

use super::single::{self, Record};
use crate::error::Result;
use crate::model::{Chain, Step};
use crate::spatial::Pose;

/// A Jacobian: six rows (linear velocity x, y, z of the tool point in m/s, then angular velocity x, y, z in rad/s),
/// one column for each variable.
pub type Jacobian = Matrix6xX<f64>;

/// The axes in which a velocity is written. The velocity itself is the tool point's, either way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// The base's axes.
    Base,
    /// The tool's axes.
    Tool,
}

/// The tool's pose at `q` and the geometric Jacobian there: `(v, omega) = J qdot`.
///
/// Column of a joint that turns about axis z through point o: `(z x (p - o), z)`; of one that slides: `(z, 0)`
/// (Whitney 1972); times the factor with which the variable enters, signs included. Joints that share a variable
/// (mimic) add up. `jacobian` is resized if it has another number of columns, and not allocated otherwise.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable.
///
/// ```
/// use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian};
/// use pieper::describe::Robot;
/// let text = "name = 'r'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5";
/// let chain = Robot::from_toml("r.toml", text)?.chain()?;
/// let mut jacobian = Jacobian::zeros(1);
/// pose_and_jacobian(&chain, &[0.0], Reference::Base, &mut jacobian)?;
/// assert_eq!(jacobian[(1, 0)], 0.5); // the tool moves along y
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn pose_and_jacobian(
    chain: &Chain,
    q: &[f64],
    reference: Reference,
    jacobian: &mut Jacobian,
) -> Result<Pose> {
    if jacobian.ncols() != chain.dof() {
        *jacobian = Jacobian::zeros(chain.dof());
    }
    jacobian.fill(0.0);
    let mut moments = Moments { jacobian };
    let pose = single::checked_tool_pose(chain, q, &mut moments)?;
    finish(&pose, reference, jacobian);
    Ok(pose)
}

/// Collects, for each variable, the sum of its axes (as angular velocity) and of what they do to the base's origin.
struct Moments<'a> {
    jacobian: &'a mut Jacobian,
}

impl Record for Moments<'_> {
    #[inline(always)]
    fn axis(&mut self, step: &Step, z: [f64; 3], o: [f64; 3]) {
        let factor = step.drive.factor;
        let (z, o) = (Vector3::from(z) * factor, Vector3::from(o));
        let mut column = self.jacobian.column_mut(step.drive.variable);
        let (v, w) = if step.turns {
            (o.cross(&z), z)
        } else {
            (z, Vector3::zeros())
        };
        for i in 0..3 {
            column[i] += v[i];
            column[i + 3] += w[i];
        }
    }
}

/// From the velocity of the point at the base's origin to that of the tool point, `v + omega x p`, and to the reference.
#[inline(always)]
fn finish(pose: &Pose, reference: Reference, jacobian: &mut Jacobian) {
    let p = pose.translation.vector;
    for mut column in jacobian.column_iter_mut() {
        let w = Vector3::new(column[3], column[4], column[5]);
        let mut v = Vector3::new(column[0], column[1], column[2]) + w.cross(&p);
        let mut w = w;
        if reference == Reference::Tool {
            v = pose.rotation.inverse_transform_vector(&v);
            w = pose.rotation.inverse_transform_vector(&w);
        }
        for i in 0..3 {
            column[i] = v[i];
            column[i + 3] = w[i];
        }
    }
}
