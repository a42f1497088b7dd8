//! Newton's method on the true arm, one root in each lane, and the measures of a root: error, smallest singular value.

use pulp::Simd;

use super::lanes::{Lane, Rigid, Turn, Vector, along, constant, cross, dot, pick, square};
use super::tolerances::TOLERANCES;

/// The arm and a target: `Rz(q1) L1 ... Rz(q6) = target`, the last link being part of the target, lengths scaled.
#[derive(Clone, Copy, Debug)]
pub(super) struct Goal<'a> {
    pub(super) links: &'a [Rigid; 5],
    /// Which joints slide.
    pub(super) slides: &'a [bool; 6],
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
const STEPS: usize = 32;
/// Steps after which a root that is still `hopeless` is given up; that bound then falls by half with each step, where
/// even at a double root Newton's method divides the error by four.
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
        if goal.slides[i] {
            for k in 0..3 {
                origin[k] = s.mul_add(frame[2][k], origin[k]);
            }
        } else {
            for k in 0..3 {
                let (x, y) = (frame[0][k], frame[1][k]);
                frame[0][k] = s.mul_add(y, c * x);
                frame[1][k] = s.subtract_product(x, c * y);
            }
        }
        if i < 5 {
            let link = &goal.links[i];
            for k in 0..3 {
                let row = [frame[0][k], frame[1][k], frame[2][k]];
                origin[k] = origin[k] + along(&link.shift, &row);
                for j in 0..3 {
                    frame[j][k] = along(&link.column(j), &row);
                }
            }
        }
    }
    let position = constant(simd, goal.target.shift);
    let (mut turn, mut trace) = ([zero; 3], zero);
    for j in 0..3 {
        let wanted = constant(simd, goal.target.column(j));
        let part = cross(&frame[j], &wanted);
        turn = [turn[0] + part[0], turn[1] + part[1], turn[2] + part[2]];
        trace = trace + dot(&frame[j], &wanted);
    }
    let half = Lane::splat(simd, 0.5);
    let mut error = [zero; 6];
    for k in 0..3 {
        error[k] = position[k] - origin[k];
        error[3 + k] = half * turn[k];
    }
    let square = square(&error);
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
    fn jacobian(&self, slides: &[bool; 6]) -> Matrix<S> {
        let mut rows = [[self.error[0]; 6]; 6];
        for j in 0..6 {
            if slides[j] {
                for k in 0..3 {
                    rows[k][j] = self.axes[j][k];
                    rows[3 + k][j] = self.error[0].constant(0.0);
                }
                continue;
            }
            let (end, origin) = (&self.end, &self.origins[j]);
            let arm = [end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]];
            let velocity = cross(&self.axes[j], &arm);
            for k in 0..3 {
                rows[k][j] = velocity[k];
                rows[3 + k][j] = self.axes[j][k];
            }
        }
        rows
    }
}

/// The error of the pose.
#[inline(always)]
pub(super) fn error<S: Simd>(simd: S, goal: &Goal<'_>, q: &Angles<S>) -> Lane<S> {
    place(simd, goal, q).size
}

/// Runs Newton's method in every lane and keeps the best angles of each. Returns their errors.
#[inline(always)]
pub(super) fn newton<S: Simd>(simd: S, goal: &Goal<'_>, q: &mut Angles<S>) -> Lane<S> {
    let (zero, one) = (Lane::splat(simd, 0.0), Lane::splat(simd, 1.0));
    let half = Lane::splat(simd, 0.5);
    let most = Lane::splat(simd, TOLERANCES.newton_step);
    let (rounding, done) = (
        Lane::splat(simd, TOLERANCES.rounding),
        Lane::splat(simd, TOLERANCES.done),
    );
    let mut hopeless = Lane::splat(simd, TOLERANCES.hopeless);
    let infinite = Lane::splat(simd, f64::MAX);
    let mut at = *q;
    let mut best = infinite;
    for step in 0..STEPS {
        let placed = place(simd, goal, &at);
        let better = placed.size.less(best);
        for k in 0..6 {
            q[k].cos = better.pick(at[k].cos, q[k].cos);
            q[k].sin = better.pick(at[k].sin, q[k].sin);
        }
        // A root that no longer improves although it is small is done; so is one without hope.
        let improves = placed.size.less(half * best);
        let small = best.less(done);
        let mut active = small.pick(improves.pick(one, zero), one);
        best = better.pick(placed.size, best);
        active = best.less(rounding).pick(zero, active);
        if step >= PATIENCE {
            active = hopeless.less(best).pick(zero, active);
            hopeless = hopeless * half;
        }
        if active.largest() == 0.0 {
            break;
        }
        let delta = solve(placed.jacobian(goal.slides), placed.error);
        let length = square(&delta).sqrt();
        let scale = most.less(length).pick(most / length, one);
        let moving = zero.less(active).and(length.less(infinite));
        for k in 0..6 {
            at[k] = at[k].moved(moving.pick(delta[k] * scale, zero), goal.slides[k]);
        }
    }
    best
}

/// `A x = r` by Gaussian elimination with row pivoting in each lane.
#[inline(always)]
fn solve<S: Simd, const N: usize>(mut a: [[Lane<S>; N]; N], mut r: [Lane<S>; N]) -> [Lane<S>; N] {
    let one = r[0].constant(1.0);
    let tiny = one.constant(1e-300);
    for k in 0..N {
        for i in k + 1..N {
            let larger = a[k][k].abs().less(a[i][k].abs());
            for j in k..N {
                let (upper, lower) = (a[k][j], a[i][j]);
                a[k][j] = larger.pick(lower, upper);
                a[i][j] = larger.pick(upper, lower);
            }
            (r[k], r[i]) = (larger.pick(r[i], r[k]), larger.pick(r[k], r[i]));
        }
        let pivot = a[k][k].abs().less(tiny).pick(tiny, a[k][k]);
        a[k][k] = one / pivot;
        for i in k + 1..N {
            let factor = a[i][k] * a[k][k];
            for j in k + 1..N {
                a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
            }
            r[i] = factor.subtract_product(r[k], r[i]);
        }
    }
    for i in (0..N).rev() {
        for j in i + 1..N {
            r[i] = a[i][j].subtract_product(r[j], r[i]);
        }
        r[i] = r[i] * a[i][i];
    }
    r
}

/// The null directions near a fold.
pub(super) struct Frame {
    /// In the joints.
    pub(super) free: [f64; 6],
    /// At the end.
    pub(super) left: [f64; 6],
}

/// Moves every lane to where the error of the pose is along `frame.left` alone, at a distance `along` along `frame.free`.
/// Returns the error there and the longest of the last steps.
#[inline(always)]
pub(super) fn settle<S: Simd>(
    simd: S,
    goal: &Goal<'_>,
    frame: &Frame,
    q: &mut Angles<S>,
    along: Lane<S>,
    steps: usize,
    enough: f64,
) -> (Lane<S>, f64) {
    let zero = Lane::splat(simd, 0.0);
    let (mut rest, mut error, mut last) = (along, zero, f64::MAX);
    for _ in 0..steps {
        let placed = place(simd, goal, q);
        let jacobian = placed.jacobian(goal.slides);
        let mut a = [[zero; 7]; 7];
        let mut r = [rest; 7];
        for i in 0..6 {
            a[i][..6].copy_from_slice(&jacobian[i]);
            a[i][6] = Lane::splat(simd, frame.left[i]);
            a[6][i] = Lane::splat(simd, frame.free[i]);
            r[i] = placed.error[i];
        }
        let [step @ .., along_left] = solve(a, r);
        error = along_left;
        for k in 0..6 {
            q[k] = q[k].moved(step[k], goal.slides[k]);
            rest = rest - Lane::splat(simd, frame.free[k]) * step[k];
        }
        last = square(&step).sqrt().largest();
        if last < enough {
            break;
        }
    }
    (error, last)
}

/// What is measured at a root.
#[derive(Clone, Copy)]
pub(super) struct Measured<S: Simd> {
    /// Smallest singular value of the Jacobian.
    pub(super) sigma: Lane<S>,
    /// The joint motion that moves the end least, of unit length.
    pub(super) free: [Lane<S>; 6],
    /// The motion of the end that takes most of the joints, of unit length.
    pub(super) left: [Lane<S>; 6],
}

/// Steps of the power method; its start is the largest column already.
const POWERS: usize = 3;

/// Error and smallest singular value: the power method on the inverse of `J J^T`.
#[inline(always)]
pub(super) fn measure<S: Simd>(simd: S, goal: &Goal<'_>, q: &Angles<S>) -> Measured<S> {
    let placed = place(simd, goal, q);
    let inverse = invert(placed.jacobian(goal.slides));
    let zero = Lane::splat(simd, 0.0);
    // The column of the inverse that is longest has a large part of what is sought.
    let mut free = [zero; 6];
    let mut length = zero;
    for j in 0..6 {
        let mut column = [zero; 6];
        for i in 0..6 {
            column[i] = inverse[i][j];
        }
        let size = square(&column).sqrt();
        let longer = length.less(size);
        free = pick(longer, &column, &free);
        length = longer.pick(size, length);
    }
    let one = Lane::splat(simd, 1.0);
    divide(&mut free, length);
    let mut stretch = length;
    let mut left = [zero; 6];
    for _ in 0..POWERS {
        left = [zero; 6];
        for i in 0..6 {
            for j in 0..6 {
                left[j] = inverse[i][j].mul_add(free[i], left[j]);
            }
        }
        let length = square(&left).sqrt();
        divide(&mut left, length);
        free = [zero; 6];
        for i in 0..6 {
            for j in 0..6 {
                free[i] = inverse[i][j].mul_add(left[j], free[i]);
            }
        }
        stretch = square(&free).sqrt();
        divide(&mut free, stretch);
    }
    Measured {
        sigma: one / stretch,
        free,
        left,
    }
}

#[inline(always)]
fn divide<S: Simd>(v: &mut [Lane<S>; 6], by: Lane<S>) {
    let inverse = by.constant(1.0) / by;
    for k in 0..6 {
        v[k] = v[k] * inverse;
    }
}

/// The inverse, by Gauss and Jordan with row pivoting in each lane.
#[inline(always)]
fn invert<S: Simd>(mut a: Matrix<S>) -> Matrix<S> {
    let (zero, one) = (a[0][0].constant(0.0), a[0][0].constant(1.0));
    let tiny = one.constant(1e-30);
    let mut out = [[zero; 6]; 6];
    for i in 0..6 {
        out[i][i] = one;
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
        for j in 0..6 {
            a[k][j] = a[k][j] * inverse;
            out[k][j] = out[k][j] * inverse;
        }
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
