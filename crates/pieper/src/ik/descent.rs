//! Newton's method and its damped form (Levenberg 1944, Marquardt 1963) on the true model.

use super::arm::{Arm, Columns, MAX_JOINTS};
use super::dense::{LeastSquares, Six};
use super::solutions::JointVector;
use crate::spatial::Pose;

/// The most Newton steps: from a close start each doubles the number of digits, so four suffice; at a double root
/// each gains one binary digit, and nothing is to be gained after this many.
const NEWTON_STEPS: usize = 24;

/// The longest step of Newton's method, radians or extents: beyond, the linear model means nothing.
const LONGEST: f64 = 0.5;

/// Improves a joint vector that is nearly a solution, by Newton's method, until the error is below `enough` or rounding is
/// reached; the best vector met, and its error.
///
/// With a `border` (a direction), steps stay perpendicular to it: this keeps the method regular on a curve of
/// solutions whose tangent it is. Steps are least-squares ones by reflections, which keep all digits near singular
/// poses; the normal equations of [`damped`] would lose half of them.
pub(super) fn newton(
    arm: &Arm,
    start: &JointVector,
    target: &Pose,
    border: Option<&JointVector>,
    enough: f64,
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
        if error < enough || idle > 2 {
            break;
        }
        let mut problem = LeastSquares::new(arm.chain().dof());
        for (i, &right) in missing.iter().enumerate() {
            problem.add(|j| columns[j][i], right);
        }
        if let Some(border) = border {
            problem.add(|j| border[j], 0.0);
        }
        advance(arm, &mut q, &problem.solve(), LONGEST);
    }
    (best, least)
}

/// One Newton step, perpendicular to a direction of any length.
pub(super) fn step_beside(arm: &Arm, q: &mut JointVector, target: &Pose, border: &JointVector) {
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    let pose = arm.pose_and_columns(q, &mut columns);
    let by = 1.0 / largest(border);
    let mut problem = LeastSquares::new(arm.chain().dof());
    for (i, &right) in arm.missing(&pose, target).iter().enumerate() {
        problem.add(|j| columns[j][i], right);
    }
    problem.add(|j| by * border[j], 0.0);
    advance(arm, q, &problem.solve(), LONGEST);
}

/// Takes a step, shortened so that no variable moves by more than `most` of its units.
fn advance(arm: &Arm, q: &mut JointVector, step: &[f64; MAX_JOINTS], most: f64) {
    let longest = largest(step);
    let scale = if longest > most { most / longest } else { 1.0 };
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
    /// Steps tried.
    pub(super) steps: u32,
}

/// Where the values of a descent may lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Room {
    /// Anywhere.
    Free,
    /// Within the joints' limits.
    Limits,
}

/// An error (as [`Descent::error`] counts) below which nothing is to be gained: rounding.
pub(super) const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The most damped steps; a start that converges at all needs 10 to 30.
const STEPS: u32 = 80;

/// A descent gives up after this many steps in a row without [`PROGRESS`].
const PATIENCE: u32 = 6;

/// What counts as progress: the error shrinks by this part.
const PROGRESS: f64 = 0.05;

/// The longest damped step, radians or extents.
const STRIDE: f64 = 1.0;

/// The damping at the start, in units of the squared error, and how it changes after a step that helped or failed.
const DAMPING: f64 = 0.1;
const EASE: f64 = 0.5;
const TIGHTEN: f64 = 4.0;

/// Walks downhill from `start` to a solution or to a local minimum of the pose error, until the error is below
/// `enough`.
///
/// Levenberg and Marquardt's method with a damping proportional to the squared error (Sugihara 2011): steps become
/// Newton's as the pose is approached. The normal equations are always six: of the joints for up to six of them,
/// `(J^T J + d) x = J^T e`, of the pose for more, `x = J^T (J J^T + d)^-1 e`.
pub(super) fn damped(
    arm: &Arm,
    start: &JointVector,
    target: &Pose,
    room: Room,
    enough: f64,
) -> Descent {
    let mut here = Place::new(arm, start, target);
    let mut damping = DAMPING;
    let (mut slow, mut steps) = (0, 0);
    while here.error > enough && slow <= PATIENCE && steps < STEPS {
        steps += 1;
        let step = here.step(arm, damping * here.error * here.error, room);
        let mut q = here.q;
        advance(arm, &mut q, &step, STRIDE);
        if room == Room::Limits {
            clamp(arm, &mut q);
        }
        let next = Place::new(arm, &q, target);
        slow = if next.error < (1.0 - PROGRESS) * here.error {
            0
        } else {
            slow + 1
        };
        if next.error < here.error {
            damping *= EASE;
            here = next;
        } else {
            damping *= TIGHTEN;
        }
    }
    Descent {
        q: here.q,
        error: here.error,
        steps,
    }
}

/// A point of a descent.
struct Place {
    q: JointVector,
    columns: Columns,
    missing: [f64; 6],
    error: f64,
}

impl Place {
    #[inline]
    fn new(arm: &Arm, q: &JointVector, target: &Pose) -> Self {
        let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
        let pose = arm.pose_and_columns(q, &mut columns);
        let missing = arm.missing(&pose, target);
        let error = missing.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self {
            q: *q,
            columns,
            missing,
            error,
        }
    }

    /// The damped step; variables at a limit that would leave it stay.
    #[inline]
    fn step(&mut self, arm: &Arm, damping: f64, room: Room) -> [f64; MAX_JOINTS] {
        let dof = arm.chain().dof();
        if room == Room::Limits {
            self.hold(arm);
        }
        // Relative to what rounding does to the entries, so that the equations stay positive definite.
        let damping = damping.max(1e-14);
        let mut step = [0.0; MAX_JOINTS];
        if dof <= 6 {
            let gram: [[f64; 6]; 6] = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    if j <= i {
                        dot(&self.columns[i], &self.columns[j])
                    } else {
                        0.0
                    }
                })
            });
            let right = std::array::from_fn(|j| dot(&self.columns[j], &self.missing));
            step[..6].copy_from_slice(&Six(gram).solve(damping, right));
        } else {
            let mut gram = [[0.0; 6]; 6];
            for column in &self.columns[..dof] {
                for i in 0..6 {
                    for j in 0..=i {
                        gram[i][j] += column[i] * column[j];
                    }
                }
            }
            let along = Six(gram).solve(damping, self.missing);
            for (step, column) in step.iter_mut().zip(&self.columns[..dof]) {
                *step = dot(column, &along);
            }
        }
        step
    }

    /// Drops the columns of variables that stand at a limit and are pushed against it.
    fn hold(&mut self, arm: &Arm) {
        for (j, variable) in arm.chain().variables().iter().enumerate() {
            let Some(limits) = variable.limits else {
                continue;
            };
            let push = dot(&self.columns[j], &self.missing);
            let stuck = (self.q[j] <= limits.lower() && push < 0.0)
                || (self.q[j] >= limits.upper() && push > 0.0);
            if stuck {
                self.columns[j] = [0.0; 6];
            }
        }
    }
}

fn clamp(arm: &Arm, q: &mut JointVector) {
    for (value, variable) in q.iter_mut().zip(arm.chain().variables()) {
        if let Some(limits) = variable.limits {
            *value = value.clamp(limits.lower(), limits.upper());
        }
    }
}

#[inline(always)]
fn dot(a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let products: [f64; 6] = std::array::from_fn(|i| a[i] * b[i]);
    (products[0] + products[1]) + (products[2] + products[3]) + (products[4] + products[5])
}
