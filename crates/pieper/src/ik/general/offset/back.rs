//! From the unknown of an offset wrist and its branch to all six angles.

use pulp::Simd;

use super::equation::{Branch, Equation, vector};
use super::{Meets, Offset};
use crate::ik::lanes::{Lane, Rigid, Turn, constant, dot};

/// The angle less a constant one.
#[inline(always)]
fn less<S: Simd>(turn: Turn<S>, (sin, cos): (f64, f64)) -> Turn<S> {
    let (s, c) = (turn.cos.constant(sin), turn.cos.constant(cos));
    Turn {
        cos: turn.cos.mul_add(c, turn.sin * s),
        sin: turn.sin.mul_add(c, -(turn.cos * s)),
    }
}

/// The turn about z from one plane vector to the direction of another.
#[inline(always)]
fn between<S: Simd>(from: [Lane<S>; 2], to: [Lane<S>; 2]) -> Turn<S> {
    Turn::along(
        from[0].mul_add(to[0], from[1] * to[1]),
        from[1].subtract_product(to[0], from[0] * to[1]),
    )
}

/// All angles, in the order in which the arm is seen.
///
/// The first three follow from the branch. With X the orientation before the last but one of the other joints and Y the
/// wanted one behind the last of them, `X^T Y = Z_x L Z_y`: its third column gives x, its third row y.
#[inline(always)]
pub(super) fn complete<S: Simd>(
    simd: S,
    offset: &Offset,
    target: &Rigid,
    equation: &Equation,
    angle: Turn<S>,
    branch: &Branch<S>,
) -> [Turn<S>; 6] {
    let [first, second, third] = offset.zeros;
    let elbow = {
        let (turn, both) = (branch.second, branch.both);
        let flip = Lane::splat(simd, offset.plane.flip);
        Turn {
            cos: both.cos.mul_add(turn.cos, both.sin * turn.sin),
            sin: flip * both.sin.mul_add(turn.cos, -(both.cos * turn.sin)),
        }
    };
    let q1 = less(branch.first, first);
    let q2 = less(branch.second, second);
    let q3 = less(elbow, third);
    let [shoulder, upper, forearm, before, behind] = &offset.links;
    let mut frame = match offset.meets {
        Meets::Fourth => columns(simd, forearm),
        Meets::Sixth => {
            let mut frame = columns(simd, before);
            for column in &mut frame {
                *column = forearm.rotate(&angle.about_z(*column));
            }
            frame
        }
    };
    for column in &mut frame {
        let turned = upper.rotate(&q3.about_z(*column));
        let turned = shoulder.rotate(&q2.about_z(turned));
        *column = q1.about_z(turned);
    }
    let axis = vector(&equation.axis, angle);
    let mut row = [axis[0]; 3];
    for k in 0..3 {
        row[k] = dot(&constant(simd, target.column(k)), &frame[2]);
    }
    let link = match offset.meets {
        Meets::Fourth => {
            row = behind.rotate(&angle.about_z(row));
            before
        }
        Meets::Sixth => behind,
    };
    let z = constant(simd, link.column(2));
    let x = between([z[0], z[1]], [dot(&frame[0], &axis), dot(&frame[1], &axis)]);
    let last = constant(simd, link.rotation[2]);
    let y = between([row[0], row[1]], [last[0], last[1]]);
    match offset.meets {
        Meets::Fourth => [q1, q2, q3, x, y, angle],
        Meets::Sixth => [q1, q2, q3, angle, x, y],
    }
}

#[inline(always)]
fn columns<S: Simd>(simd: S, link: &Rigid) -> [[Lane<S>; 3]; 3] {
    [
        constant(simd, link.column(0)),
        constant(simd, link.column(1)),
        constant(simd, link.column(2)),
    ]
}
