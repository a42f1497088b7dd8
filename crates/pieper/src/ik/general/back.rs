//! Back substitution: from the angles c, d, e of a root to all six, by geometry on the true arm.

use pulp::Simd;

use super::lanes::{Lane, Rigid, Turn, Vector, constant, cross, dot};

/// The links of one elimination for one target: La to Le, and the inverse of Lf.
pub(super) type Links = [Rigid; 6];

/// All angles a to f.
///
/// With `X = Lb Rc Lc Rd Ld Re Le`, its point Xp and z axis Xl, and those of `Y = Lf^-1`, `La = (R, t)`, g the third row
/// of R, h = R^T t, four equations are linear in (cos b, sin b):
/// `g.Rb Xp = Yp_z - t_z`, `g.Rb Xl = Yl_z`, `h.Rb Xp = (Yp.Yp - Xp.Xp - t.t)/2`, `h.Rb Xl = Yp.Yl - Xp.Xl`;
/// they are solved by least squares. Then a turns `La Rb X` onto Y about z, and f is what is left about the axis.
#[inline(always)]
pub(super) fn complete<S: Simd>(simd: S, links: &Links, [c, d, e]: [Turn<S>; 3]) -> [Turn<S>; 6] {
    let last = &links[4];
    let mut point = constant(simd, last.shift);
    let mut axis = constant(simd, last.column(2));
    let mut side = constant(simd, last.column(0));
    for (turn, link) in [(e, &links[3]), (d, &links[2]), (c, &links[1])] {
        point = link.carry(&turn.about_z(point));
        axis = link.rotate(&turn.about_z(axis));
        side = link.rotate(&turn.about_z(side));
    }
    let (y_point, y_axis) = (
        constant(simd, links[5].shift),
        constant(simd, links[5].column(2)),
    );
    let b = second(simd, &links[0], (&point, &axis), (&y_point, &y_axis));
    let point = links[0].carry(&b.about_z(point));
    let axis = links[0].rotate(&b.about_z(axis));
    let side = links[0].rotate(&b.about_z(side));
    let (of_point, of_axis) = (planar(&point, &y_point), planar(&axis, &y_axis));
    let a = Turn::along(of_point.0 + of_axis.0, of_point.1 + of_axis.1);
    let (axis, side) = (a.about_z(axis), a.about_z(side));
    let y_side = constant(simd, links[5].column(0));
    let f = Turn::along(dot(&y_side, &side), dot(&y_side, &cross(&axis, &side)));
    [a, b, c, d, e, f]
}

/// Cosine and sine, times both lengths, of the turn about z from v to w.
#[inline(always)]
fn planar<S: Simd>(v: &Vector<S>, w: &Vector<S>) -> (Lane<S>, Lane<S>) {
    (
        v[1].mul_add(w[1], v[0] * w[0]),
        v[1].subtract_product(w[0], v[0] * w[1]),
    )
}

/// The angle b, by least squares.
#[inline(always)]
fn second<S: Simd>(
    simd: S,
    link: &Rigid,
    (point, axis): (&Vector<S>, &Vector<S>),
    (y_point, y_axis): (&Vector<S>, &Vector<S>),
) -> Turn<S> {
    let (rotation, t) = (&link.rotation, &link.shift);
    let g = constant(simd, rotation[2]);
    let mut h = [0.0; 3];
    for j in 0..3 {
        h[j] = rotation[0][j] * t[0] + rotation[1][j] * t[1] + rotation[2][j] * t[2];
    }
    let h = constant(simd, h);
    let half = g[0].constant(0.5);
    let square = g[0].constant(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    let right = [
        y_point[2] - g[0].constant(t[2]),
        y_axis[2],
        half * (dot(y_point, y_point) - dot(point, point) - square),
        dot(y_point, y_axis) - dot(point, axis),
    ];
    let zero = g[0].constant(0.0);
    let (mut cc, mut cs, mut ss, mut c_right, mut s_right) = (zero, zero, zero, zero, zero);
    let rows = [(&g, point), (&g, axis), (&h, point), (&h, axis)];
    for k in 0..4 {
        let ((row, v), right) = (rows[k], right[k]);
        let cos = row[1].mul_add(v[1], row[0] * v[0]);
        let sin = row[0].subtract_product(v[1], row[1] * v[0]);
        let right = row[2].subtract_product(v[2], right);
        cc = cos.mul_add(cos, cc);
        cs = cos.mul_add(sin, cs);
        ss = sin.mul_add(sin, ss);
        c_right = cos.mul_add(right, c_right);
        s_right = sin.mul_add(right, s_right);
    }
    // The determinant is not negative: the direction needs no division.
    let cos = cs.subtract_product(s_right, ss * c_right);
    let sin = cs.subtract_product(c_right, cc * s_right);
    Turn::along(cos, sin)
}
