//! Newton's method on the true arm, one root in each lane, and the measures of a root: error, smallest singular value.

use pulp::Simd;

use super::lanes::{Lane, Rigid, Turn, Vector, constant, cross, dot};
use super::tolerances::TOLERANCES;

/// The arm and a target: `Rz(q1) L1 ... Rz(q6) = target`, the last link being part of the target, lengths scaled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal<'a> {
    pub(super) links: &'a [Rigid; 5],
    pub(super) target: Rigid,
}

/// Six angles in lanes.
pub(super) type Angles<S> = [Turn<S>; 6];

type Matrix<S> = [[Lane<S>; 6]; 6];

/// Where the arm is: axes, points on them, and the error of the pose.
struct Placed<S: Simd> {
    axes: [Vector<S>; 6],
    origins: [Vector<S>; 6],
    end: Vector<S>,
    /// Position error, then half the sum of the columns' cross products: the rotation vector to first order.
    error: [Lane<S>; 6],
    /// Its norm; large where the orientation is off by more than a right angle.
    size: Lane<S>,
}

/// Newton steps at most.
const STEPS: usize = 16;
/// Steps after which a root that is still `hopeless` is given up.
const PATIENCE: usize = 4;

#[inline(always)]
fn place<S: Simd>(simd: S, goal: &Goal<'_>, q: &Angles<S>) -> Placed<S> {
    let (zero, one) = (Lane::splat(simd, 0.0), Lane::splat(simd, 1.0));
    let mut frame = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let mut origin = [zero; 3];
    let mut axes = [frame[2]; 6];
    let mut origins = [origin; 6];
    for i in 0..6 {
        axes[i] = frame[2];
        origins[i] = origin;
        let (c, s) = (q[i].cos, q[i].sin);
        let x: Vector<S> = std::array::from_fn(|k| s.mul_add(frame[1][k], c * frame[0][k]));
        let y: Vector<S> = std::array::from_fn(|k| s.subtract_product(frame[0][k], c * frame[1][k]));
        frame = [x, y, frame[2]];
        if let Some(link) = goal.links.get(i) {
            let combine = |by: [f64; 3], k: usize| {
                let [a, b, d] = by.map(|entry| zero.constant(entry));
                d.mul_add(frame[2][k], b.mul_add(frame[1][k], a * frame[0][k]))
            };
            origin = std::array::from_fn(|k| origin[k] + combine(link.shift, k));
            frame = [0, 1, 2].map(|j| std::array::from_fn(|k| combine(link.column(j), k)));
        }
    }
    let position = constant(simd, goal.target.shift);
    let (mut turn, mut trace) = ([zero; 3], zero);
    for (j, column) in frame.iter().enumerate() {
        let wanted = constant(simd, goal.target.column(j));
        let part = cross(column, &wanted);
        turn = std::array::from_fn(|k| turn[k] + part[k]);
        trace = trace + dot(column, &wanted);
    }
    let half = Lane::splat(simd, 0.5);
    let error = std::array::from_fn(|k| {
        if k < 3 { position[k] - origin[k] } else { half * turn[k - 3] }
    });
    let square = error.iter().fold(zero, |sum, &x: &Lane<S>| x.mul_add(x, sum));
    let turned_away = trace.less(one);
    Placed {
        axes,
        origins,
        end: origin,
        error,
        size: turned_away.pick(one + square, square).sqrt(),
    }
}

impl<S: Simd> Placed<S> {
    /// The geometric Jacobian at the end point.
    #[inline(always)]
    fn jacobian(&self) -> Matrix<S> {
        let mut rows = [[self.error[0]; 6]; 6];
        for j in 0..6 {
            let arm = std::array::from_fn(|k| self.end[k] - self.origins[j][k]);
            let velocity = cross(&self.axes[j], &arm);
            for k in 0..3 {
                rows[k][j] = velocity[k];
                rows[3 + k][j] = self.axes[j][k];
            }
        }
        rows
    }
}

/// Runs Newton's method in every lane and keeps the best angles of each. Returns their errors.
#[inline(always)]
pub(super) fn newton<S: Simd>(simd: S, goal: &Goal<'_>, q: &mut Angles<S>) -> Lane<S> {
    let splat = |value| Lane::splat(simd, value);
    let mut at = *q;
    let mut best = splat(f64::MAX);
    for step in 0..STEPS {
        let placed = place(simd, goal, &at);
        let better = placed.size.less(best);
        for (kept, new) in q.iter_mut().zip(&at) {
            kept.cos = better.pick(new.cos, kept.cos);
            kept.sin = better.pick(new.sin, kept.sin);
        }
        // A root that no longer improves although it is small is done; so is one without hope.
        let stalls = placed.size.less(splat(0.5) * best);
        let small = best.less(splat(TOLERANCES.closes));
        let mut active = small.pick(stalls.pick(splat(1.0), splat(0.0)), splat(1.0));
        best = better.pick(placed.size, best);
        active = best.less(splat(TOLERANCES.rounding)).pick(splat(0.0), active);
        if step >= PATIENCE {
            active = splat(TOLERANCES.hopeless).less(best).pick(splat(0.0), active);
        }
        if active.largest() == 0.0 {
            break;
        }
        let delta = solve(placed.jacobian(), placed.error);
        let square = delta.iter().fold(splat(0.0), |sum, &x| x.mul_add(x, sum));
        let length = square.sqrt();
        let most = splat(TOLERANCES.newton_step);
        let scale = most.less(length).pick(most / length, splat(1.0));
        let moving = splat(0.0).less(active).and(length.less(splat(f64::MAX)));
        let scale = moving.pick(scale, splat(0.0));
        for (turn, &by) in at.iter_mut().zip(&delta) {
            *turn = turn.advanced(moving.pick(by * scale, splat(0.0)));
        }
    }
    best
}

/// `J x = r` by Gaussian elimination with row pivoting in each lane.
#[inline(always)]
fn solve<S: Simd>(mut a: Matrix<S>, mut r: [Lane<S>; 6]) -> [Lane<S>; 6] {
    let one = r[0].constant(1.0);
    let tiny = one.constant(1e-300);
    for k in 0..6 {
        for i in k + 1..6 {
            let larger = a[k][k].abs().less(a[i][k].abs());
            for j in k..6 {
                let (upper, lower) = (a[k][j], a[i][j]);
                a[k][j] = larger.pick(lower, upper);
                a[i][j] = larger.pick(upper, lower);
            }
            (r[k], r[i]) = (larger.pick(r[i], r[k]), larger.pick(r[k], r[i]));
        }
        let pivot = a[k][k].abs().less(tiny).pick(tiny, a[k][k]);
        a[k][k] = one / pivot;
        for i in k + 1..6 {
            let factor = a[i][k] * a[k][k];
            for j in k + 1..6 {
                a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
            }
            r[i] = factor.subtract_product(r[k], r[i]);
        }
    }
    for i in (0..6).rev() {
        for j in i + 1..6 {
            r[i] = a[i][j].subtract_product(r[j], r[i]);
        }
        r[i] = r[i] * a[i][i];
    }
    r
}

/// What is measured at a root.
#[derive(Clone, Copy)]
pub(super) struct Measured<S: Simd> {
    /// Norm of the pose's error.
    pub(super) error: Lane<S>,
    /// Smallest singular value of the Jacobian.
    pub(super) sigma: Lane<S>,
    /// The joint motion that moves the end least, of unit length.
    pub(super) free: [Lane<S>; 6],
}

/// Steps of the power method; its start is the largest column already.
const POWERS: usize = 3;

/// Error and smallest singular value: the power method on the inverse of `J J^T`.
#[inline(always)]
pub(super) fn measure<S: Simd>(simd: S, goal: &Goal<'_>, q: &Angles<S>) -> Measured<S> {
    let placed = place(simd, goal, q);
    let inverse = invert(placed.jacobian());
    let zero = Lane::splat(simd, 0.0);
    let norm = |v: &[Lane<S>; 6]| v.iter().fold(zero, |sum, &x| x.mul_add(x, sum)).sqrt();
    // The column of the inverse that is longest has a large part of what is sought.
    let mut free = [zero; 6];
    let mut length = zero;
    for j in 0..6 {
        let column: [Lane<S>; 6] = std::array::from_fn(|i| inverse[i][j]);
        let size = norm(&column);
        let longer = length.less(size);
        free = std::array::from_fn(|i| longer.pick(column[i], free[i]));
        length = longer.pick(size, length);
    }
    let one = Lane::splat(simd, 1.0);
    free = free.map(|x| x / length);
    let mut stretch = length;
    for _ in 0..POWERS {
        let mut left = [zero; 6];
        for j in 0..6 {
            left[j] = (0..6).fold(zero, |sum, i| inverse[i][j].mul_add(free[i], sum));
        }
        let size = norm(&left);
        left = left.map(|x| x / size);
        let next: [Lane<S>; 6] = std::array::from_fn(|i| {
            (0..6).fold(zero, |sum, j| inverse[i][j].mul_add(left[j], sum))
        });
        stretch = norm(&next);
        free = next.map(|x| x / stretch);
    }
    Measured {
        error: placed.size,
        sigma: one / stretch,
        free,
    }
}

/// The inverse, by Gauss and Jordan with row pivoting in each lane.
#[inline(always)]
fn invert<S: Simd>(mut a: Matrix<S>) -> Matrix<S> {
    let (zero, one) = (a[0][0].constant(0.0), a[0][0].constant(1.0));
    let tiny = one.constant(1e-30);
    let mut out = [[zero; 6]; 6];
    for (i, row) in out.iter_mut().enumerate() {
        row[i] = one;
    }
    for k in 0..6 {
        for i in k + 1..6 {
            let larger = a[k][k].abs().less(a[i][k].abs());
            for j in 0..6 {
                let (upper, lower) = (a[k][j], a[i][j]);
                a[k][j] = larger.pick(lower, upper);
                a[i][j] = larger.pick(upper, lower);
                let (upper, lower) = (out[k][j], out[i][j]);
                out[k][j] = larger.pick(lower, upper);
                out[i][j] = larger.pick(upper, lower);
            }
        }
        let pivot = a[k][k].abs().less(tiny).pick(tiny, a[k][k]);
        let inverse = one / pivot;
        a[k] = a[k].map(|x| x * inverse);
        out[k] = out[k].map(|x| x * inverse);
        for i in 0..6 {
            if i != k {
                let factor = a[i][k];
                for j in 0..6 {
                    a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
                    out[i][j] = factor.subtract_product(out[k][j], out[i][j]);
                }
            }
        }
    }
    out
}
