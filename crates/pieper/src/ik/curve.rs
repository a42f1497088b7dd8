//! Curves of solutions: recognised, followed, sampled.
//!
//! Where the Jacobian has a null direction, solutions either touch (a double root) or go on along a curve. A step
//! along the direction, corrected by Newton's method perpendicular to it, tells the two apart, whatever kind of arm
//! it is.

use std::f64::consts::PI;

use super::TOLERANCES;
use super::angle::wrap;
use super::arm::{Arm, Columns, MAX_JOINTS, residuals};
use super::dense::{LeastSquares, symmetric_eigen};
use super::descent::newton;
use super::kernel::stands_alone;
use super::solutions::JointVector;
use crate::spatial::Pose;

/// Lengths of trial steps (radians or extents): far beyond the reach of Newton's method from a double root, where
/// the error grows with the square of the step. Where a stretched arm leaves a family little room, only the short ones
/// stay within it.
const TRIALS: [f64; 3] = [0.05, 0.005, 0.0005];

/// Length of the steps that follow a curve, the parts of it that are tried in narrow bends, and the most of them: some six
/// turns in joint space.
const STRIDE: f64 = 0.2;
const PARTS: [f64; 5] = [1.0, 0.25, 0.05, 0.01, 0.0025];
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
    (upright(vectors[0]), values[0].max(0.0).sqrt())
}

/// The direction or its opposite: the largest entry is positive.
fn upright(direction: JointVector) -> JointVector {
    let largest = direction.iter().fold(
        0.0_f64,
        |most, x| if x.abs() > most.abs() { *x } else { most },
    );
    direction.map(|x| if largest < 0.0 { -x } else { x })
}

/// `q` after a step of length `h` along a direction in the units of the variables' columns.
fn stepped(arm: &Arm, q: &JointVector, direction: &JointVector, h: f64) -> JointVector {
    let mut next = *q;
    for (j, value) in next.iter_mut().enumerate().take(arm.chain().dof()) {
        *value += h * direction[j] * arm.unit(j);
    }
    next
}

/// The unit direction in which solutions of `target` go on at `q`, if they do: [`tangent`], unless two directions change
/// nothing to first order, as with a straight wrist on a stretched elbow. Of those the one that keeps the pose best to
/// second order.
pub(super) fn heading(arm: &Arm, q: &JointVector, target: &Pose) -> JointVector {
    /// A rate of change of the pose that is none, from a root that is known to half of its digits.
    const NONE: f64 = 1e-6;
    let (values, vectors) = gram(arm, q);
    if !(2..=6).contains(&arm.chain().dof()) || values[1] > NONE * NONE {
        return upright(vectors[0]);
    }
    /// Length of the steps that are compared, both ways so that odd terms do not count.
    const STEP: f64 = 0.01;
    let along = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        std::array::from_fn(|j| cos * vectors[0][j] + sin * vectors[1][j])
    };
    let change = |angle: f64| -> f64 {
        let direction: JointVector = along(angle);
        let at = |h: f64| {
            let next = stepped(arm, q, &direction, h);
            let (turn, shift) = residuals(&arm.pose(&next), target);
            turn.max(shift / arm.extent())
        };
        at(STEP) + at(-STEP)
    };
    /// Directions compared first; around each that is better than its neighbours lies one valley.
    const COARSE: usize = 24;
    const THIRDS: usize = 60;
    let spacing = PI / COARSE as f64;
    let coarse: [f64; COARSE] = std::array::from_fn(|k| change(k as f64 * spacing));
    let (mut best, mut least) = (0.0, f64::INFINITY);
    for k in 0..COARSE {
        if coarse[k] > coarse[(k + COARSE - 1) % COARSE] || coarse[k] > coarse[(k + 1) % COARSE] {
            continue;
        }
        let (mut low, mut high) = ((k as f64 - 1.0) * spacing, (k as f64 + 1.0) * spacing);
        for _ in 0..THIRDS {
            let third = (high - low) / 3.0;
            match change(low + third) < change(high - third) {
                true => high -= third,
                false => low += third,
            }
        }
        let middle = 0.5 * (low + high);
        if change(middle) < least {
            (best, least) = (middle, change(middle));
        }
    }
    upright(along(best))
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
    let start = stepped(arm, q, direction, h);
    let (next, error) = newton(arm, &start, target, Some(direction), ON_CURVE);
    let moved = norm(&difference(arm, q, &next));
    // A short step misses a double root by less: it has to close the better.
    let closes = TOLERANCES.closes * (h.abs() / TRIALS[0]).min(1.0);
    (error < closes && moved < 3.0 * h.abs()).then_some(next)
}

/// The direction of the curve of solutions through `q`, if there is one.
pub(super) fn grows(arm: &Arm, q: &JointVector, target: &Pose) -> Option<JointVector> {
    if stands_alone(arm, q, target) {
        return None;
    }
    let direction = heading(arm, q, target);
    TRIALS
        .iter()
        .flat_map(|&h| [h, -h])
        .any(|h| advance(arm, q, &direction, h, target).is_some())
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
            let next = PARTS.iter().map(|part| part * STRIDE).find_map(|length| {
                advance(arm, &q, &heading, length, target).map(|next| (next, length))
            });
            let Some((next, length)) = next else { break };
            let home = norm(&difference(arm, &next, member));
            if step > 2 && home < 0.8 * length {
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

/// How far two points are from one another in the first `count` variables.
fn gap(arm: &Arm, a: &JointVector, b: &JointVector, count: usize) -> f64 {
    let mut gap = difference(arm, a, b);
    gap[count..].fill(0.0);
    norm(&gap)
}

/// Whether the curve through `member` passes through `q`, as far as the first `count` variables tell.
pub(super) fn passes(
    arm: &Arm,
    (member, heading): (&JointVector, &JointVector),
    target: &Pose,
    q: &JointVector,
    count: usize,
) -> bool {
    let mut met = false;
    follow(arm, member, heading, target, |at, _| {
        if gap(arm, at, q, count) < STRIDE {
            met = gap(arm, &closest(arm, at, target, q, count), q, count) < SAME_POINT;
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
    // A last step is no longer than what Newton's method still moves a point of the curve by: it only has to come closer.
    let settle = |from: &JointVector, tangent: &JointVector, along: f64| {
        let start = stepped(arm, from, tangent, along);
        let (next, error) = newton(arm, &start, target, Some(tangent), ON_CURVE);
        let is_last = along.abs() < TRIALS[0] && error < TOLERANCES.closes;
        (is_last && gap(arm, &next, q, count) < gap(arm, from, q, count)).then_some(next)
    };
    let mut at = *at;
    for _ in 0..30 {
        let tangent = heading(arm, &at, target);
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
        match advance(arm, &at, &tangent, along, target).or_else(|| settle(&at, &tangent, along)) {
            Some(next) => at = next,
            None => break,
        }
    }
    at
}
