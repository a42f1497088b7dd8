//! Curves of solutions: recognised, followed, sampled.
//!
//! Where the Jacobian has a null direction, solutions either touch (a double root) or go on along a curve. A step
//! along the direction, corrected by Newton's method perpendicular to it, tells the two apart, whatever kind of arm
//! it is.

use super::TOLERANCES;
use super::angle::wrap;
use super::arm::{Arm, Columns, MAX_JOINTS};
use super::dense::{LeastSquares, symmetric_eigen};
use super::descent::newton;
use super::solutions::JointVector;
use crate::spatial::Pose;

/// Length of a trial step (radians or extents): far beyond the reach of Newton's method from a double root, where
/// the error grows with the square of the step.
const TRIAL: f64 = 0.05;

/// Length of the steps that follow a curve, and the most of them: some six turns in joint space.
const STRIDE: f64 = 0.2;
const MOST_STRIDES: usize = 200;

/// The difference `b - a`, angles modulo whole turns, lengths in extents.
pub(super) fn difference(arm: &Arm, a: &JointVector, b: &JointVector) -> JointVector {
    let mut out = [0.0; MAX_JOINTS];
    for j in 0..arm.chain().dof() {
        let step = b[j] - a[j];
        out[j] = if arm.is_periodic(j) {
            wrap(step)
        } else {
            step / arm.unit(j)
        };
    }
    out
}

fn dot(a: &JointVector, b: &JointVector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &JointVector) -> f64 {
    dot(a, a).sqrt()
}

/// The unit direction in which the pose changes least, in the units of the variables' columns, and that least change.
pub(super) fn tangent(arm: &Arm, q: &JointVector) -> (JointVector, f64) {
    let (values, vectors) = gram(arm, q);
    let mut direction = vectors[0];
    // The sign: the largest entry is positive.
    let largest = direction.iter().fold(
        0.0_f64,
        |most, x| if x.abs() > most.abs() { *x } else { most },
    );
    if largest < 0.0 {
        direction.iter_mut().for_each(|x| *x = -*x);
    }
    (direction, values[0].max(0.0).sqrt())
}

/// Whether solutions around `q` fill a surface rather than a curve: more than seven joints, or seven of which two
/// directions keep the pose.
pub(super) fn is_surface(arm: &Arm, q: &JointVector) -> bool {
    /// A rate of change of the pose that is none.
    const NONE: f64 = 1e-7;
    let dof = arm.chain().dof();
    dof > 7 || dof == 7 && gram(arm, q).0[1] < NONE * NONE
}

/// Eigenvalues, smallest first, and eigenvectors of `J^T J`.
fn gram(arm: &Arm, q: &JointVector) -> ([f64; MAX_JOINTS], [[f64; MAX_JOINTS]; MAX_JOINTS]) {
    let n = arm.chain().dof();
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    arm.pose_and_columns(q, &mut columns);
    let mut gram = [[0.0; MAX_JOINTS]; MAX_JOINTS];
    for i in 0..n {
        for j in 0..n {
            gram[i][j] = (0..6).map(|k| columns[i][k] * columns[j][k]).sum();
        }
    }
    symmetric_eigen(gram, n)
}

/// A step of length `h` from `q` along `direction`, back on the curve.
pub(super) fn advance(
    arm: &Arm,
    q: &JointVector,
    direction: &JointVector,
    h: f64,
    target: &Pose,
) -> Option<JointVector> {
    let mut start = *q;
    for (j, value) in start.iter_mut().enumerate().take(arm.chain().dof()) {
        *value += h * direction[j] * arm.unit(j);
    }
    let (next, error) = newton(arm, &start, target, Some(direction), ON_CURVE);
    let moved = norm(&difference(arm, q, &next));
    (error < TOLERANCES.closes && moved < 3.0 * h.abs()).then_some(next)
}

/// The direction of the curve of solutions through `q`, if there is one.
pub(super) fn grows(arm: &Arm, q: &JointVector, target: &Pose) -> Option<JointVector> {
    let (direction, _) = tangent(arm, q);
    [TRIAL, -TRIAL]
        .iter()
        .any(|&h| advance(arm, q, &direction, h, target).is_some())
        .then_some(direction)
}

/// Newton's method on a curve ends at this error.
const ON_CURVE: f64 = 1e-14;

/// The direction in which a curve goes on at `q`, given one that is roughly it: the null direction of the Jacobian with
/// a given part along that.
fn continued(arm: &Arm, q: &JointVector, heading: &JointVector) -> JointVector {
    let dof = arm.chain().dof();
    if dof > 7 {
        // The null directions are many: the given one is kept.
        return *heading;
    }
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    arm.pose_and_columns(q, &mut columns);
    let mut problem = LeastSquares::new(dof);
    for i in 0..6 {
        problem.add(|j| columns[j][i], 0.0);
    }
    problem.add(|j| heading[j], 1.0);
    let next = problem.solve();
    let length = norm(&next);
    if length.is_finite() && length > 0.5 {
        return next.map(|x| x / length);
    }
    let (tangent, _) = tangent(arm, q);
    let sign = 1.0_f64.copysign(dot(&tangent, heading));
    tangent.map(|x| sign * x)
}

/// The part of a step that keeps the pose: null directions of the Jacobian as close to it as they come in the first
/// `count` variables.
pub(super) fn along(arm: &Arm, q: &JointVector, step: &JointVector, count: usize) -> JointVector {
    /// How much more the pose counts, and how much less the variables that do not matter.
    const KEEP: f64 = 1e6;
    const IDLE: f64 = 1e-3;
    let dof = arm.chain().dof();
    let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
    arm.pose_and_columns(q, &mut columns);
    let mut problem = LeastSquares::new(dof);
    for i in 0..6 {
        problem.add(|j| KEEP * columns[j][i], 0.0);
    }
    for (k, &wanted) in step.iter().enumerate().take(dof) {
        let weight = if k < count { 1.0 } else { IDLE };
        let entry = |j: usize| if j == k { weight } else { 0.0 };
        problem.add(entry, if k < count { wanted } else { 0.0 });
    }
    problem.solve()
}

/// How following a curve ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Followed {
    /// It came back to where it began.
    Closed,
    /// It has ends, or goes on too far.
    Open,
    /// The visitor had enough.
    Left,
}

/// Follows the curve from `member` until it closes, ends, or `visit` returns false; both ways if it ends. The visitor is
/// told whether a point is the first of its way; `member` itself is visited first.
pub(super) fn follow(
    arm: &Arm,
    member: &JointVector,
    direction: &JointVector,
    target: &Pose,
    mut visit: impl FnMut(&JointVector, bool) -> bool,
) -> Followed {
    if !visit(member, false) {
        return Followed::Left;
    }
    for sign in [1.0, -1.0] {
        let mut heading = direction.map(|x| sign * x);
        let mut q = *member;
        for step in 0..MOST_STRIDES {
            let next = [1.0, 0.25, 0.05]
                .iter()
                .find_map(|part| advance(arm, &q, &heading, part * STRIDE, target));
            let Some(next) = next else { break };
            let home = norm(&difference(arm, &next, member));
            if step > 2 && home < 0.8 * STRIDE {
                return Followed::Closed;
            }
            if !visit(&next, step == 0) {
                return Followed::Left;
            }
            heading = continued(arm, &next, &heading);
            q = next;
        }
    }
    Followed::Open
}

/// Whether the curve through `member` passes through `q`, as far as the first `count` variables tell.
pub(super) fn passes(
    arm: &Arm,
    (member, heading): (&JointVector, &JointVector),
    target: &Pose,
    q: &JointVector,
    count: usize,
) -> bool {
    let gap = |at: &JointVector| {
        let mut gap = difference(arm, at, q);
        gap[count..].fill(0.0);
        norm(&gap)
    };
    let mut met = false;
    follow(arm, member, heading, target, |at, _| {
        if gap(at) < STRIDE {
            met = gap(&closest(arm, at, target, q, count)) < SAME_POINT;
        }
        !met
    });
    met
}

/// A point on a curve and a solution are the same if closer than this: where Newton's method stops at a singular
/// point only half of the digits are determined.
const SAME_POINT: f64 = 1e-6;

/// Walks along the curve from `at` to where it is perpendicular to the direction of `q`, of which the first `count`
/// variables matter.
pub(super) fn closest(
    arm: &Arm,
    at: &JointVector,
    target: &Pose,
    q: &JointVector,
    count: usize,
) -> JointVector {
    let mut at = *at;
    for _ in 0..30 {
        let (tangent, _) = tangent(arm, &at);
        let mut step = difference(arm, &at, q);
        step[count..].fill(0.0);
        let seen: f64 = tangent[..count].iter().map(|x| x * x).sum();
        if seen < TOLERANCES.exact {
            break;
        }
        let along = (dot(&tangent, &step) / seen).clamp(-STRIDE, STRIDE);
        if along.abs() < TOLERANCES.exact {
            break;
        }
        match advance(arm, &at, &tangent, along, target) {
            Some(next) => at = next,
            None => break,
        }
    }
    at
}
