//! How well the tool can move: manipulability, condition, distance to singularity.

use nalgebra::{DVector, Matrix3xX, Matrix6xX, Vector6};

use super::jacobian::Jacobian;

/// Measures of a Jacobian. Metres and radians are mixed as they come: compare values of one arm only.
#[derive(Clone, Debug, PartialEq)]
pub struct Measures {
    /// Yoshikawa's manipulability: the product of the singular values, `sqrt(det(J J^T))` for six joints or more.
    /// With fewer than six joints it is `sqrt(det(J^T J))`: the volume within what the arm can do at all.
    pub manipulability: f64,
    /// The same of the linear rows alone.
    pub translational: f64,
    /// The same of the angular rows alone.
    pub rotational: f64,
    /// Largest over smallest singular value; infinite where the smallest is zero.
    pub condition: f64,
    /// The singular values, falling.
    pub singular_values: Vec<f64>,
    /// Distance to singularity and what is lost there.
    pub singularity: Singularity,
}

/// The smallest singular value with its directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Singularity {
    /// The smallest singular value: zero where the arm is singular.
    pub distance: f64,
    /// The unit twist (v, omega) that costs most joint motion; the one that is lost at a singularity.
    pub lost_twist: Vector6<f64>,
    /// The unit joint motion that moves the tool least; at a singularity, not at all.
    pub idle_joints: DVector<f64>,
}

/// The measures of a Jacobian.
///
/// `None` if its singular values cannot be found (entries that are not finite).
pub fn measures(jacobian: &Jacobian) -> Option<Measures> {
    let svd = jacobian
        .clone()
        .try_svd(true, true, f64::EPSILON, MAX_ITERATIONS)?;
    let (u, v_t) = (svd.u.as_ref()?, svd.v_t.as_ref()?);
    let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
    order.sort_by(|&a, &b| svd.singular_values[b].total_cmp(&svd.singular_values[a]));
    let singular_values: Vec<f64> = order
        .iter()
        .map(|&index| svd.singular_values[index])
        .collect();
    let (&last, largest) = (order.last()?, singular_values[0]);
    let smallest = svd.singular_values[last];
    Some(Measures {
        manipulability: singular_values.iter().product(),
        translational: volume(jacobian, 0)?,
        rotational: volume(jacobian, 3)?,
        condition: if smallest > 0.0 {
            largest / smallest
        } else {
            f64::INFINITY
        },
        singularity: Singularity {
            distance: smallest,
            lost_twist: u.column(last).into_owned(),
            idle_joints: v_t.row(last).transpose(),
        },
        singular_values,
    })
}

/// The sweeps a 6xn matrix needs are a dozen; this many only where something is not a number.
const MAX_ITERATIONS: usize = 1000;

/// The product of the singular values of three rows.
fn volume(jacobian: &Matrix6xX<f64>, first_row: usize) -> Option<f64> {
    let rows: Matrix3xX<f64> = jacobian.fixed_rows::<3>(first_row).into_owned();
    let svd = rows.try_svd(false, false, f64::EPSILON, MAX_ITERATIONS)?;
    Some(svd.singular_values.product())
}
