//! Newton's method and its damped form (Levenberg 1944, Marquardt 1963) on the true model.

use super::arm::{Arm, Columns, MAX_JOINTS};
use super::dense::LeastSquares;
use super::solutions::JointVector;
use crate::spatial::Pose;

/// The most Newton steps: from a close start each doubles the number of digits, so four suffice; at a double root
/// each gains one binary digit, and nothing is to be gained after this many.
const NEWTON_STEPS: usize = 24;

/// The longest step, radians or extents: beyond, the linear model means nothing.
const LONGEST: f64 = 0.5;

/// Improves a joint vector that is nearly a solution, by Newton's method; the best vector met, and its error.
///
/// With a `border` (a direction), steps stay perpendicular to it: this keeps the method regular on a curve of
/// solutions whose tangent it is.
pub(super) fn newton(
    arm: &Arm,
    start: &JointVector,
    target: &Pose,
    border: Option<&JointVector>,
) -> (JointVector, f64) {
    let mut q = *start;
    let (mut best, mut least) = (q, f64::INFINITY);
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    let mut idle = 0;
    for _ in 0..NEWTON_STEPS {
        let pose = arm.pose_and_columns(&q, &mut columns);
        let missing = arm.missing(&pose, target);
        let error = largest(&missing);
        if error.is_nan() {
            break;
        }
        idle = if error < 0.5 * least { 0 } else { idle + 1 };
        if error < least {
            (best, least) = (q, error);
        }
        // Two steps without real progress: rounding is reached, or there is nothing to reach.
        if error < f64::EPSILON || idle > 2 {
            break;
        }
        let mut problem = pose_equations(arm, &columns, &missing);
        if let Some(border) = border {
            problem.add(|j| border[j], 0.0);
        }
        advance(arm, &mut q, &problem.solve());
    }
    (best, least)
}

fn pose_equations(arm: &Arm, columns: &Columns, missing: &[f64; 6]) -> LeastSquares {
    let mut problem = LeastSquares::new(arm.chain().dof());
    for (i, &right) in missing.iter().enumerate() {
        problem.add(|j| columns[j][i], right);
    }
    problem
}

/// Takes a step, shortened to [`LONGEST`].
fn advance(arm: &Arm, q: &mut JointVector, step: &[f64; MAX_JOINTS]) {
    let longest = largest(step);
    let scale = if longest > LONGEST {
        LONGEST / longest
    } else {
        1.0
    };
    for (variable, value) in q.iter_mut().enumerate().take(arm.chain().dof()) {
        *value += scale * step[variable] * arm.unit(variable);
    }
}

pub(super) fn largest(v: &[f64]) -> f64 {
    v.iter()
        .fold(0.0, |most, x| if x.abs() <= most { most } else { x.abs() })
}

/// How a damped descent ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Descent {
    pub(super) q: JointVector,
    /// Root of the sum of squares: position in extents, rotation in radians.
    pub(super) error: f64,
}

/// A descent gives up after this many steps in a row without one percent of progress.
const SLOW: usize = 30;

/// The most damped steps; a start that converges at all needs 10 to 30.
const DAMPED_STEPS: usize = 80;

/// Walks downhill from `start` to a solution or to a local minimum of the pose error.
///
/// With `bounded`, values stay within the joints' limits (projected steps).
pub(super) fn damped(arm: &Arm, start: &JointVector, target: &Pose, bounded: bool) -> Descent {
    let dof = arm.chain().dof();
    let mut q = *start;
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    let mut pose = arm.pose_and_columns(&q, &mut columns);
    let mut missing = arm.missing(&pose, target);
    let mut error = length(&missing);
    let mut damping = 1e-2;
    let mut slow = 0;
    for _ in 0..DAMPED_STEPS {
        if error < 4.0 * f64::EPSILON || slow > SLOW {
            break;
        }
        let mut problem = pose_equations(arm, &columns, &missing);
        let weight = f64::sqrt(damping);
        for k in 0..dof {
            problem.add(|j| if j == k { weight } else { 0.0 }, 0.0);
        }
        let mut next = q;
        advance(arm, &mut next, &problem.solve());
        if bounded {
            clamp(arm, &mut next);
        }
        let mut next_columns: Columns = [[0.0; 6]; MAX_JOINTS];
        pose = arm.pose_and_columns(&next, &mut next_columns);
        let next_missing = arm.missing(&pose, target);
        let next_error = length(&next_missing);
        if next_error < error {
            slow = if next_error > 0.99 * error {
                slow + 1
            } else {
                0
            };
            // The damping follows the error: Newton's method near a solution, gradient steps far from one.
            damping = (damping * 0.1).min(next_error * next_error);
            (q, columns, missing, error) = (next, next_columns, next_missing, next_error);
        } else {
            damping = (damping * 8.0).max(1e-10);
            slow += 1;
            if damping > 1e6 {
                break;
            }
        }
    }
    Descent { q, error }
}

fn clamp(arm: &Arm, q: &mut JointVector) {
    for (value, variable) in q.iter_mut().zip(arm.chain().variables()) {
        if let Some(limits) = variable.limits {
            *value = value.clamp(limits.lower(), limits.upper());
        }
    }
}

fn length(v: &[f64; 6]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
