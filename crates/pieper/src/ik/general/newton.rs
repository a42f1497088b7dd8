//! Newton's method on the true arm, one root in each lane, and what is measured there: the error, the smallest singular value, and
//! the curve along which a fold's error is a parabola.

use pulp::Simd;

use super::linear::{Factors, Matrix, invert};
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{
    Lane, Rigid, Turn, Vector, along, constant, cross, dot, pick, scaled, square, unrolled,
};

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
    unrolled!(i of 6, {
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
    });
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
    fn jacobian(&self, slides: &[bool; 6]) -> Matrix<S, 6> {
        let mut rows = [[self.error[0]; 6]; 6];
        unrolled!(j of 6, {
            if slides[j] {
                for k in 0..3 {
                    rows[k][j] = self.axes[j][k];
                    rows[3 + k][j] = self.error[0].constant(0.0);
                }
            } else {
                let (end, origin) = (&self.end, &self.origins[j]);
                let arm = [end[0] - origin[0], end[1] - origin[1], end[2] - origin[2]];
                let velocity = cross(&self.axes[j], &arm);
                for k in 0..3 {
                    rows[k][j] = velocity[k];
                    rows[3 + k][j] = self.axes[j][k];
                }
            }
        });
        rows
    }

    /// The acceleration of the end, its shift and then its turn, at constant joint velocities.
    #[inline(always)]
    fn acceleration(&self, slides: &[bool; 6], velocities: &[Lane<S>; 6]) -> [Lane<S>; 6] {
        let zero = self.size.constant(0.0);
        let two = zero.constant(2.0);
        let (mut turning, mut turn, mut shift) = ([zero; 3], [zero; 3], [zero; 3]);
        for j in 0..6 {
            let along = scaled(&self.axes[j], velocities[j]);
            let across = cross(&turning, &along);
            for k in 0..3 {
                if slides[j] {
                    shift[k] = two.mul_add(across[k], shift[k]);
                } else {
                    turn[k] = turn[k] + across[k];
                    turning[k] = turning[k] + along[k];
                }
            }
            let next = if j < 5 {
                &self.origins[j + 1]
            } else {
                &self.end
            };
            let origin = &self.origins[j];
            let arm = [
                next[0] - origin[0],
                next[1] - origin[1],
                next[2] - origin[2],
            ];
            let (swing, pull) = (cross(&turn, &arm), cross(&turning, &cross(&turning, &arm)));
            for k in 0..3 {
                shift[k] = shift[k] + swing[k] + pull[k];
            }
        }
        let ([x, y, z], [a, b, c]) = (shift, turn);
        [x, y, z, a, b, c]
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
        let delta = Factors::of(placed.jacobian(goal.slides)).solve(placed.error);
        let length = square(&delta).sqrt();
        let scale = most.less(length).pick(most / length, one);
        let moving = zero.less(active).and(length.less(infinite));
        for k in 0..6 {
            at[k] = at[k].moved(moving.pick(delta[k] * scale, zero), goal.slides[k]);
        }
    }
    best
}

/// The curve on which the error of the pose is along `Measured::left` alone, close to some joint values, parametrised by the
/// distance along `Measured::free`.
pub(super) struct Curve<S: Simd> {
    /// From the joint values onto the curve.
    pub(super) step: [Lane<S>; 6],
    /// The joints' derivatives along the curve.
    pub(super) tangent: [Lane<S>; 6],
    pub(super) curvature: [Lane<S>; 6],
    /// The error along `Measured::left`, and its derivatives.
    pub(super) error: Lane<S>,
    pub(super) slope: Lane<S>,
    pub(super) bend: Lane<S>,
}

impl<S: Simd> Curve<S> {
    /// The point of the curve at a distance from the joint values.
    #[inline(always)]
    pub(super) fn point(&self, at: &Angles<S>, along: Lane<S>, slides: &[bool; 6]) -> Angles<S> {
        let half = along * along.constant(0.5);
        let mut q = *at;
        for k in 0..6 {
            let bent = self.curvature[k].mul_add(half, self.tangent[k]);
            q[k] = at[k].moved(bent.mul_add(along, self.step[k]), slides[k]);
        }
        q
    }
}

/// The curve through the neighbourhood of every lane, by `[J u; n^T 0]`, which is regular at a fold.
#[inline(always)]
pub(super) fn curve<S: Simd>(
    simd: S,
    goal: &Goal<'_>,
    measured: &Measured<S>,
    q: &Angles<S>,
) -> Curve<S> {
    let (zero, one) = (Lane::splat(simd, 0.0), Lane::splat(simd, 1.0));
    let placed = place(simd, goal, q);
    let jacobian = placed.jacobian(goal.slides);
    let mut a = [[zero; 7]; 7];
    let mut r = [zero; 7];
    for i in 0..6 {
        a[i][..6].copy_from_slice(&jacobian[i]);
        a[i][6] = measured.left[i];
        a[6][i] = measured.free[i];
        r[i] = placed.error[i];
    }
    let factors = Factors::of(a);
    let [step @ .., error] = factors.solve(r);
    let [tangent @ .., slope] = factors.solve([zero, zero, zero, zero, zero, zero, one]);
    let acceleration = placed.acceleration(goal.slides, &tangent);
    for i in 0..6 {
        r[i] = -acceleration[i];
    }
    let [curvature @ .., bend] = factors.solve(r);
    Curve {
        step,
        tangent,
        curvature,
        error,
        slope,
        bend,
    }
}

/// What is measured at a root.
#[derive(Clone, Copy)]
pub(super) struct Measured<S: Simd> {
    /// Smallest singular value of the Jacobian.
    pub(super) sigma: Lane<S>,
    /// The joint motion that moves the end least, of unit length.
    pub(super) free: [Lane<S>; 6],
    /// The motion of the end that takes most of the joints, of unit length.
    left: [Lane<S>; 6],
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
    let mut longest = zero;
    for j in 0..6 {
        let mut column = [zero; 6];
        for i in 0..6 {
            column[i] = inverse[i][j];
        }
        let size = square(&column);
        let longer = longest.less(size);
        free = pick(longer, &column, &free);
        longest = longer.pick(size, longest);
    }
    // The largest singular value of the inverse is at most 6^(1/2) times as long: with this factor nothing grows by more than 6.
    let shrunk = Lane::splat(simd, 1.0) / longest;
    let mut left = [zero; 6];
    for _ in 0..POWERS {
        left = [zero; 6];
        for i in 0..6 {
            let along = free[i] * shrunk;
            for j in 0..6 {
                left[j] = inverse[i][j].mul_add(along, left[j]);
            }
        }
        free = [zero; 6];
        for i in 0..6 {
            for j in 0..6 {
                free[i] = inverse[i][j].mul_add(left[j], free[i]);
            }
        }
    }
    let (short, long) = (square(&left).sqrt(), square(&free).sqrt());
    divide(&mut left, short);
    divide(&mut free, long);
    Measured {
        sigma: short / long,
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
