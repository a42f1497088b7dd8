//! Second derivatives of the tool's pose.

use nalgebra::Vector3;

use super::jacobian::Jacobian;
use super::kernel::Frame;
use super::single::{self, Record, SpaceColumn};
use crate::error::Result;
use crate::model::{Chain, Step};
use crate::spatial::Pose;

/// The tool's pose at `q` and the Hessian there: slice `i` is the derivative of the base-frame
/// [`Jacobian`] with respect to variable `i`.
///
/// Of two axes that turn, the one nearer the base carries the other: for `i` at or before `j`,
/// `dJ_j/dq_i = (w_i x v_j, w_i x w_j)`, and `(w_j x v_i, 0)` for `i` behind `j`; the linear rows are symmetric in i and j.
/// (Hourtash, The Kinematic Hessian and Higher Derivatives, 2005.) Buffers are resized if they do not fit.
///
/// # Errors
/// An input error unless `q` has one finite value for each variable.
pub fn hessian(chain: &Chain, q: &[f64], slices: &mut Vec<Jacobian>) -> Result<Pose> {
    let dof = chain.dof();
    slices.resize_with(dof, || Jacobian::zeros(dof));
    for slice in slices.iter_mut() {
        slice.resize_horizontally_mut(dof, 0.0);
        slice.fill(0.0);
    }
    let mut axes = Axes(Vec::with_capacity(chain.canonical().steps.len()));
    let pose = single::tool_pose(chain, q, &mut axes)?;
    for (i, inner) in axes.0.iter().enumerate() {
        for (j, outer) in axes.0.iter().enumerate() {
            let (v, w) = if i <= j {
                (inner.w.cross(&outer.v), inner.w.cross(&outer.w))
            } else {
                (outer.w.cross(&inner.v), Vector3::zeros())
            };
            let mut column = slices[inner.variable].column_mut(outer.variable);
            for row in 0..3 {
                column[row] += v[row];
                column[row + 3] += w[row];
            }
        }
    }
    Ok(pose)
}

/// The axes of a chain, each with the velocity its variable gives the base's origin; in the end, the tool point.
struct Axes(Vec<AxisVelocity>);

struct AxisVelocity {
    variable: usize,
    v: Vector3<f64>,
    w: Vector3<f64>,
}

impl Record for Axes {
    fn axis<C: SpaceColumn>(&mut self, step: &Step, frame: &Frame<C>) {
        let (v, w) = single::moment(step, frame);
        self.0.push(AxisVelocity {
            variable: step.drive.variable,
            v,
            w,
        });
    }

    fn tool<C: SpaceColumn>(&mut self, frame: &Frame<C>) {
        let p = Vector3::from(frame.p.store());
        for axis in &mut self.0 {
            axis.v += axis.w.cross(&p);
        }
    }
}
