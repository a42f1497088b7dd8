//! A line with a point on it as a 15-vector on which rigid motions act linearly.
//!
//! For a point p and a direction l: `v = [p, l, p.p, p.l, m = p x l, r = (p.p) l - 2 (p.l) p, 1]`. Its first 14
//! entries, written for both halves of the closed loop, are the 14 equations of Raghavan and Roth (J. Mech. Design
//! 115, 1993, section 3), which hold no joint but those of the two halves.

use crate::ik::lanes::Rigid;

/// Entries of the vector.
pub(super) const SIZE: usize = 15;

/// A line as a vector.
pub(super) type Line = [f64; SIZE];

const P: usize = 0;
const L: usize = 3;
const PP: usize = 6;
const PL: usize = 7;
const M: usize = 8;
const R: usize = 11;
const W: usize = 14;

/// The z axis, the point at the origin.
pub(super) const Z_AXIS: Line = {
    let mut line = [0.0; SIZE];
    line[L + 2] = 1.0;
    line[W] = 1.0;
    line
};

/// Where the pairs (x, y) begin that a turn about z mixes.
const PAIRS: [usize; 4] = [P, L, M, R];

/// The parts of a line that go with 1, cos q and sin q in `D(Rz(q)) v`, or with 1, q and q^2 if the joint slides along z.
pub(super) fn harmonics(line: &Line, slides: bool) -> [Line; 3] {
    if slides {
        slide_powers(line)
    } else {
        turn_harmonics(line)
    }
}

/// The same for a row n: the parts of `n D`.
pub(super) fn row_harmonics(row: &Line, slides: bool) -> [Line; 3] {
    if slides {
        return slide_powers_of_row(row);
    }
    let [still, cos, sin] = turn_harmonics(row);
    [still, cos, sin.map(|entry| -entry)]
}

/// A shift by q along z: `p' = p + q z`, `p'.p' = pp + 2 q p_z + q^2`, `p'.l = pl + q l_z`, `m' = m + q z x l`,
/// `r' = r - 2 q (z x m + pl z) + q^2 (l - 2 l_z z)`.
fn slide_powers(v: &Line) -> [Line; 3] {
    let (mut first, mut second) = ([0.0; SIZE], [0.0; SIZE]);
    first[P + 2] = v[W];
    first[PP] = 2.0 * v[P + 2];
    first[PL] = v[L + 2];
    (first[M], first[M + 1]) = (-v[L + 1], v[L]);
    (first[R], first[R + 1], first[R + 2]) = (2.0 * v[M + 1], -2.0 * v[M], -2.0 * v[PL]);
    second[PP] = v[W];
    (second[R], second[R + 1], second[R + 2]) = (v[L], v[L + 1], -v[L + 2]);
    [*v, first, second]
}

fn slide_powers_of_row(n: &Line) -> [Line; 3] {
    let (mut first, mut second) = ([0.0; SIZE], [0.0; SIZE]);
    first[W] = n[P + 2];
    first[P + 2] = 2.0 * n[PP];
    (first[L], first[L + 1], first[L + 2]) = (n[M + 1], -n[M], n[PL]);
    (first[M], first[M + 1], first[PL]) = (-2.0 * n[R + 1], 2.0 * n[R], -2.0 * n[R + 2]);
    second[W] = n[PP];
    (second[L], second[L + 1], second[L + 2]) = (n[R], n[R + 1], -n[R + 2]);
    [*n, first, second]
}

fn turn_harmonics(line: &Line) -> [Line; 3] {
    let (mut still, mut cos, mut sin) = (*line, [0.0; SIZE], [0.0; SIZE]);
    for x in PAIRS {
        (still[x], still[x + 1]) = (0.0, 0.0);
        (cos[x], cos[x + 1]) = (line[x], line[x + 1]);
        (sin[x], sin[x + 1]) = (-line[x + 1], line[x]);
    }
    [still, cos, sin]
}

/// The matrix D of a rigid motion: `v(R p + t, R l) = D v(p, l)`, row by row.
///
/// With P = R p, q = R l, M = R m: `p' = P + t`, `l' = q`, `p'.p' = pp + 2 t.P + t.t`, `p'.l' = pl + t.q`,
/// `m' = M + t x q`, `r' = R r + (t.t) q - 2 t x M - 2 (pl + t.q) t`.
#[inline(always)]
pub(super) fn motion(rigid: &Rigid) -> [Line; SIZE] {
    let mut d = [[0.0; SIZE]; SIZE];
    let (rotation, t) = (&rigid.rotation, &rigid.shift);
    let square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    d[PP][PP] = 1.0;
    d[PP][W] = square;
    d[PL][PL] = 1.0;
    d[W][W] = 1.0;
    for j in 0..3 {
        let column = [rotation[0][j], rotation[1][j], rotation[2][j]];
        let along = t[0] * column[0] + t[1] * column[1] + t[2] * column[2];
        let moment = [
            t[1] * column[2] - t[2] * column[1],
            t[2] * column[0] - t[0] * column[2],
            t[0] * column[1] - t[1] * column[0],
        ];
        d[PP][P + j] = 2.0 * along;
        d[PL][L + j] = along;
        for i in 0..3 {
            d[P + i][P + j] = column[i];
            d[L + i][L + j] = column[i];
            d[M + i][M + j] = column[i];
            d[R + i][R + j] = column[i];
            d[M + i][L + j] = moment[i];
            d[R + i][L + j] = square * column[i] - 2.0 * along * t[i];
            d[R + i][M + j] = -2.0 * moment[i];
        }
    }
    for i in 0..3 {
        d[P + i][W] = t[i];
        d[R + i][PL] = -2.0 * t[i];
    }
    d
}

/// `D v`.
#[inline(always)]
pub(super) fn act(d: &[Line; SIZE], line: &Line) -> Line {
    let mut out = [0.0; SIZE];
    for (entry, row) in out.iter_mut().zip(d) {
        for (factor, part) in row.iter().zip(line) {
            *entry += factor * part;
        }
    }
    out
}

/// `n D`.
#[inline(always)]
pub(super) fn act_on_row(row: &Line, d: &[Line; SIZE]) -> Line {
    let mut out = [0.0; SIZE];
    for (factor, d_row) in row.iter().zip(d) {
        for (entry, d_entry) in out.iter_mut().zip(d_row) {
            *entry += factor * d_entry;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::from_xyz_rpy;
    use nalgebra::Vector3;

    fn of(p: Vector3<f64>, l: Vector3<f64>) -> Line {
        let (pp, pl, m) = (p.dot(&p), p.dot(&l), p.cross(&l));
        let r = pp * l - 2.0 * pl * p;
        let parts = [p.as_slice(), l.as_slice(), &[pp, pl], m.as_slice()];
        let list = [&parts.concat()[..], r.as_slice(), &[1.0]].concat();
        list.try_into().unwrap()
    }

    #[test]
    fn motions_act_linearly() {
        let pose = from_xyz_rpy([0.3, -0.7, 1.1], [0.4, -1.0, 2.0]);
        let (p, l) = (Vector3::new(0.2, 0.5, -0.4), Vector3::new(0.6, 0.0, 0.8));
        let moved = of(
            pose.rotation * p + pose.translation.vector,
            pose.rotation * l,
        );
        let acted = act(&motion(&Rigid::of(&pose)), &of(p, l));
        for (a, b) in moved.iter().zip(&acted) {
            assert!((a - b).abs() < 1e-14);
        }
    }

    #[test]
    fn turns_about_z_split_into_harmonics() {
        let turn = from_xyz_rpy([0.0; 3], [0.0, 0.0, 0.7]);
        let line = of(Vector3::new(0.2, 0.5, -0.4), Vector3::new(0.6, 0.0, 0.8));
        let d = motion(&Rigid::of(&turn));
        let sum = |parts: [Line; 3]| -> Line {
            std::array::from_fn(|i| {
                parts[0][i] + 0.7_f64.cos() * parts[1][i] + 0.7_f64.sin() * parts[2][i]
            })
        };
        let pairs = [
            (act(&d, &line), sum(harmonics(&line, false))),
            (act_on_row(&line, &d), sum(row_harmonics(&line, false))),
        ];
        for (acted, summed) in pairs {
            for (a, b) in acted.iter().zip(&summed) {
                assert!((a - b).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn slides_along_z_are_quadratic() {
        let shift = from_xyz_rpy([0.0, 0.0, 0.7], [0.0; 3]);
        let line = of(Vector3::new(0.2, 0.5, -0.4), Vector3::new(0.6, 0.48, 0.64));
        let d = motion(&Rigid::of(&shift));
        let sum = |parts: [Line; 3]| -> Line {
            std::array::from_fn(|i| parts[0][i] + 0.7 * parts[1][i] + 0.49 * parts[2][i])
        };
        let pairs = [
            (act(&d, &line), sum(harmonics(&line, true))),
            (act_on_row(&line, &d), sum(row_harmonics(&line, true))),
        ];
        for (acted, summed) in pairs {
            for (a, b) in acted.iter().zip(&summed) {
                assert!((a - b).abs() < 1e-14);
            }
        }
    }
}
