//! Whether a root of six joints stands alone, from the shape of the pose around it: without following anything.

use super::arm::{Arm, Columns, MAX_JOINTS};
use super::curve::tangent;
use super::solutions::JointVector;
use crate::spatial::Pose;

/// A matrix of six rows and its null directions, as far as it has any.
struct Kernel {
    /// The unit direction that the matrix shortens most, nearly, and that of its transpose.
    right: [f64; 6],
    left: [f64; 6],
    /// What is left of the first of them.
    least: f64,
    /// The last pivot but one, small where two directions are null.
    second: f64,
}

impl Kernel {
    /// By Gaussian elimination with complete pivoting, `P A Q = L U`.
    fn of(columns: &Columns) -> Self {
        let mut a: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
        let mut rows: [usize; 6] = std::array::from_fn(|i| i);
        let mut order = rows;
        for step in 0..5 {
            let (mut row, mut column, mut most) = (step, step, 0.0);
            for (i, entries) in a.iter().enumerate().skip(step) {
                for (j, entry) in entries.iter().enumerate().skip(step) {
                    if entry.abs() > most {
                        (row, column, most) = (i, j, entry.abs());
                    }
                }
            }
            a.swap(step, row);
            rows.swap(step, row);
            a.iter_mut().for_each(|entries| entries.swap(step, column));
            order.swap(step, column);
            let pivot = a[step];
            for entries in &mut a[step + 1..] {
                let factor = if most > 0.0 {
                    entries[step] / pivot[step]
                } else {
                    0.0
                };
                for j in step + 1..6 {
                    entries[j] -= factor * pivot[j];
                }
                entries[step] = factor;
            }
        }
        let (mut right, mut left) = ([0.0; 6], [0.0; 6]);
        let (mut x, mut w) = ([0.0; 6], [0.0; 6]);
        (x[5], w[5]) = (1.0, 1.0);
        for k in (0..5).rev() {
            let upper: f64 = (k + 1..6).map(|j| a[k][j] * x[j]).sum();
            x[k] = -upper / a[k][k];
            w[k] = -(k + 1..6).map(|i| a[i][k] * w[i]).sum::<f64>();
        }
        let length = |v: &[f64; 6]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (long, tall) = (length(&x), length(&w));
        for k in 0..6 {
            right[order[k]] = x[k] / long;
            left[rows[k]] = w[k] / tall;
        }
        Self {
            right,
            left,
            least: a[5][5].abs() / long,
            second: a[4][4].abs(),
        }
    }
}

/// Whether the root `q` certainly stands alone: no direction keeps the pose, or a single one, along which
/// the pose then bends away. False where that is not so, and where it is not clear: with
/// fewer than six variables the first is told, with more neither.
///
/// A curve of solutions `q + s v + s^2 a + ...` has `J v = 0` and `J a + H(v, v) / 2 = 0`, so that with `u J = 0` the pose does
/// not bend towards `u` along `v`: `u H(v, v) = 0`. It is measured by second differences.
pub(super) fn stands_alone(arm: &Arm, q: &JointVector, target: &Pose) -> bool {
    /// A rate of change of the pose that is none, from a root that is known to half of its digits.
    const NONE: f64 = 1e-5;
    /// The bend of the pose, per square of a step, that the length of the steps does not explain, nor an error of the root by
    /// half of its digits, which turns the null directions by its size over the second pivot.
    const BENDS: f64 = 1e-4;
    const HALF: f64 = 1e-5;
    const STEP: f64 = 1e-3;
    /// Where the root is known well, as it is if no second direction is nearly null, a much smaller rate leads off a curve: one that
    /// closes to what is promised along a twentieth of a radian needs 2e-11.
    const FIRST: f64 = 1e-10;
    const SECOND: f64 = 1e-2;
    match arm.chain().dof() {
        6 => {}
        fewer @ 0..6 => return fewer > 0 && tangent(arm, q).1 > NONE,
        _ => return false,
    }
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    let here = arm.pose_and_columns(q, &mut columns);
    let kernel = Kernel::of(&columns);
    if kernel.least > NONE || kernel.least > FIRST && kernel.second > SECOND {
        return true;
    }
    let misses = |pose: &Pose| -> f64 {
        let missing = arm.missing(pose, target);
        missing.iter().zip(&kernel.left).map(|(x, u)| x * u).sum()
    };
    let at = |step: f64| {
        let mut next = *q;
        for (j, (value, along)) in next.iter_mut().zip(&kernel.right).enumerate() {
            *value += step * along * arm.unit(j);
        }
        misses(&arm.pose(&next))
    };
    // Both ways: odd terms do not count.
    let bend = (at(STEP) + at(-STEP) - 2.0 * misses(&here)) / (STEP * STEP);
    bend.abs() > BENDS && bend.abs() * kernel.second > HALF
}
