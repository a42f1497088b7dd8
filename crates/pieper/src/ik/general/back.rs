//! Back substitution: from the angles c, d, e of a root to all six, by geometry on the true arm.

use pulp::Simd;

use crate::ik::lanes::{Lane, Rigid, Turn, Vector, constant, cross, dot};

/// The links of one elimination for one target: La to Le, and the inverse of Lf.
pub(super) type Links = [Rigid; 6];

/// All angles a to f.
///
/// With `X = Lb Rc Lc Rd Ld Re Le`, its point Xp and z axis Xl, and those of `Y = Lf^-1`, `La = (R, t)`, g the third row
/// of R, h = R^T t, four equations are linear in (cos b, sin b):
/// `g.Rb Xp = Yp_z - t_z`, `g.Rb Xl = Yl_z`, `h.Rb Xp = (Yp.Yp - Xp.Xp - t.t)/2`, `h.Rb Xl = Yp.Yl - Xp.Xl`;
/// they are solved by least squares. Then a turns `La Rb X` onto Y about z, and f is what is left about the axis.
#[inline(always)]
pub(super) fn complete<S: Simd>(
    simd: S,
    links: &Links,
    slides: &[bool; 6],
    [c, d, e]: [Turn<S>; 3],
) -> [Turn<S>; 6] {
    let last = &links[4];
    let mut point = constant(simd, last.shift);
    let mut axis = constant(simd, last.column(2));
    let mut side = constant(simd, last.column(0));
    for (turn, place) in [(e, 4), (d, 3), (c, 2)] {
        let link = &links[place - 1];
        point = link.carry(&turn.carry(point, slides[place]));
        axis = link.rotate(&turn.rotate(axis, slides[place]));
        side = link.rotate(&turn.rotate(side, slides[place]));
    }
    let (y_point, y_axis) = (
        constant(simd, links[5].shift),
        constant(simd, links[5].column(2)),
    );
    let (x, y) = ((&point, &axis), (&y_point, &y_axis));
    let b = match (slides[0], slides[1]) {
        (false, false) => second(simd, &links[0], x, y),
        (false, true) => slide_behind_turn(simd, &links[0], x, y),
        (true, false) => turn_behind_slide(simd, &links[0], x, y),
        (true, true) => slide_behind_slide(simd, &links[0], &point, &y_point),
    };
    let point = links[0].carry(&b.carry(point, slides[1]));
    let axis = links[0].rotate(&b.rotate(axis, slides[1]));
    let side = links[0].rotate(&b.rotate(side, slides[1]));
    let (of_point, of_axis) = (planar(&point, &y_point), planar(&axis, &y_axis));
    let a = if slides[0] {
        Turn::slid(y_point[2] - point[2])
    } else {
        Turn::along(of_point.0 + of_axis.0, of_point.1 + of_axis.1)
    };
    let (axis, side) = (a.rotate(axis, slides[0]), a.rotate(side, slides[0]));
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
    let t = &link.shift;
    let g = constant(simd, link.rotation[2]);
    let h = constant(simd, link.unrotated_shift());
    let half = g[0].constant(0.5);
    let square = g[0].constant(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    let right = [
        y_point[2] - g[0].constant(t[2]),
        y_axis[2],
        half * (dot(y_point, y_point) - dot(point, point) - square),
        dot(y_point, y_axis) - dot(point, axis),
    ];
    let rows = [(&g, point), (&g, axis), (&h, point), (&h, axis)];
    least_squares(&rows, &right)
}

/// The turn about z for which each row times the turned vector is as near as possible to its right side.
#[inline(always)]
fn least_squares<S: Simd, const N: usize>(
    rows: &[(&Vector<S>, &Vector<S>); N],
    right: &[Lane<S>; N],
) -> Turn<S> {
    let zero = right[0].constant(0.0);
    let (mut cc, mut cs, mut ss, mut c_right, mut s_right) = (zero, zero, zero, zero, zero);
    for k in 0..N {
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

/// Joint a turns, b slides by x: `g.(Xp + x z) = Yp_z - t_z` and `(Xp + x z + h).Xl = Yp.Yl`, by least squares; where
/// neither depends on x, the distance `|Xp + x z + h|` is at its least.
#[inline(always)]
fn slide_behind_turn<S: Simd>(
    simd: S,
    link: &Rigid,
    (point, axis): (&Vector<S>, &Vector<S>),
    (y_point, y_axis): (&Vector<S>, &Vector<S>),
) -> Turn<S> {
    let g = constant(simd, link.rotation[2]);
    let h = constant(simd, link.unrotated_shift());
    let shifted = [point[0] + h[0], point[1] + h[1], point[2] + h[2]];
    let height = y_point[2] - g[0].constant(link.shift[2]) - dot(&g, point);
    let along = dot(y_point, y_axis) - dot(&shifted, axis);
    let square = g[2].mul_add(g[2], axis[2] * axis[2]);
    let right = g[2].mul_add(height, axis[2] * along);
    let determined = square.constant(1e-12).less(square);
    Turn::slid(determined.pick(right / square.max(square.constant(1e-12)), -shifted[2]))
}

/// Joint a slides, b turns: the axis is `R Rb Xl = Yl`, and the point's first two coordinates are Y's.
#[inline(always)]
fn turn_behind_slide<S: Simd>(
    simd: S,
    link: &Rigid,
    (point, axis): (&Vector<S>, &Vector<S>),
    (y_point, y_axis): (&Vector<S>, &Vector<S>),
) -> Turn<S> {
    let [x, y, z] = link.rotation.map(|row| constant(simd, row));
    let shift = constant(simd, link.shift);
    let rows = [(&x, axis), (&y, axis), (&z, axis), (&x, point), (&y, point)];
    let right = [
        y_axis[0],
        y_axis[1],
        y_axis[2],
        y_point[0] - shift[0],
        y_point[1] - shift[1],
    ];
    least_squares(&rows, &right)
}

/// Both slide: the first two coordinates of `R (Xp + x z) + t` are those of Yp.
#[inline(always)]
fn slide_behind_slide<S: Simd>(
    simd: S,
    link: &Rigid,
    point: &Vector<S>,
    y_point: &Vector<S>,
) -> Turn<S> {
    let carried = link.carry(point);
    let column = constant(simd, link.column(2));
    let square = column[0].mul_add(column[0], column[1] * column[1]);
    let first = y_point[0] - carried[0];
    let second = y_point[1] - carried[1];
    let right = column[0].mul_add(first, column[1] * second);
    Turn::slid(right / square.max(square.constant(f64::MIN_POSITIVE)))
}
