//! The resultant of the six equations in d and e: a 12 x 12 determinant from a 6 x 9 elimination and a 3 x 3 one.
//!
//! With blocks E1, Ec, Es of M for 1, cos d, sin d, a shift phi and `x = tan((d + phi)/2)`,
//! `Ec' = cos phi Ec - sin phi Es`, `Es' = sin phi Ec + cos phi Es`, the equations read
//! `(A + B x + C x^2) y = 0`, `A = E1 + Ec'`, `B = 2 Es'`, `C = E1 - Ec'`, `y = (1, cos e, sin e)`. Multiplied by x as
//! well they are `S (y, x y, x^2 y, x^3 y) = 0` with `S = [[A B C 0], [0 A B C]]` (Raghavan and Roth 1993). Solving
//! `[X1; X2] = [B C]^-1 A` instead:
//!
//! * `det S = -det([B C])^2 det P`, `P = X1 X1 + X2`;
//! * at a root `P y = 0` and `x = -(y . X1 y) / (y . y)`.
//!
//! A turn of phi is a Moebius map of x with determinant 1, so det S does not depend on phi: where `[B C]` is nearly
//! singular for one phi, another gives the same number without the cancellation.

use pulp::Simd;

use super::elimination::{BLOCK, COLUMNS, Harmonics, ROWS};
use super::number::Number;
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Mask, Turn, Vector, cross, dot, pick, scaled, unrolled};

/// How the resultant is taken: which of d and e is the unknown x, and the shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Form {
    /// Whether d and e have exchanged their roles.
    pub(super) swapped: bool,
    /// Index into [`SHIFTS`].
    pub(super) shift: usize,
}

/// Cosine and sine of the shifts phi: 0.3 rad and three right angles more; no joint's own right angles are met.
pub(super) const SHIFTS: [(f64, f64); 4] = [
    (0.955_336_489_125_606, 0.295_520_206_661_339_6),
    (-0.295_520_206_661_339_6, 0.955_336_489_125_606),
    (-0.955_336_489_125_606, -0.295_520_206_661_339_6),
    (0.295_520_206_661_339_6, -0.955_336_489_125_606),
];

/// The harmonics in c of `[B C A]`.
#[inline(always)]
pub(super) fn blocks<S: Simd>(simd: S, matrix: &Harmonics, form: Form) -> Harmonics {
    let (cos, sin) = SHIFTS[form.shift & 3];
    let (cos, sin) = (Lane::splat(simd, cos), Lane::splat(simd, sin));
    let mut out = [[[0.0; BLOCK]; 3]; 3];
    for h in 0..3 {
        for register in 0..BLOCK / S::F64_LANES {
            let one = Lane::load(simd, &matrix[h][0], register);
            let of_cos = Lane::load(simd, &matrix[h][1], register);
            let of_sin = Lane::load(simd, &matrix[h][2], register);
            let turned_cos = sin.subtract_product(of_sin, cos * of_cos);
            let turned_sin = sin.mul_add(of_cos, cos * of_sin);
            (turned_sin + turned_sin).store(&mut out[h][0], register);
            (one - turned_cos).store(&mut out[h][1], register);
            (one + turned_cos).store(&mut out[h][2], register);
        }
    }
    out
}

/// The elimination at given angles c.
#[derive(Clone, Copy)]
pub(super) struct Reduced<S: Simd> {
    /// det S.
    pub(super) value: Lane<S>,
    /// The smallest pivot over the largest.
    pub(super) ratio: Lane<S>,
    x1: [Vector<S>; 3],
    p: [Vector<S>; 3],
}

/// Eliminates at the angles c of the lanes, in numbers N.
#[inline(always)]
pub(super) fn reduce<S: Simd, N: Number<S>>(blocks: &Harmonics, c: Turn<S>) -> Reduced<S> {
    let (cos, sin) = N::circle(c);
    let mut a = [[cos; COLUMNS]; ROWS];
    for i in 0..ROWS {
        for j in 0..COLUMNS {
            let (block, k) = (j / 3, ROWS * (j % 3) + i);
            let still = N::of(c.cos.constant(blocks[0][block][k]));
            let of_cos = N::of(c.cos.constant(blocks[1][block][k]));
            let of_sin = N::of(c.cos.constant(blocks[2][block][k]));
            a[i][j] = of_sin.mul_add(sin, of_cos.mul_add(cos, still));
        }
    }
    let (least, most, product) = triangular(&mut a, c.cos.constant(1.0));
    // Back substitution: the last three columns become [X1; X2].
    for y in 6..COLUMNS {
        for i in (0..ROWS).rev() {
            let mut sum = a[i][y];
            for j in i + 1..ROWS {
                sum = a[i][j].subtract_product(a[j][y], sum);
            }
            a[i][y] = sum.times(a[i][i]);
        }
    }
    let mut p = [[cos; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            p[i][j] = a[i + 3][6 + j];
            for k in 0..3 {
                p[i][j] = a[i][6 + k].mul_add(a[k][6 + j], p[i][j]);
            }
        }
    }
    let minor = |j: usize, k: usize| p[2][j].subtract_product(p[1][k], p[1][j].times(p[2][k]));
    let determinant = p[0][0].mul_add(
        minor(1, 2),
        p[0][1].mul_add(minor(2, 0), p[0][2].times(minor(0, 1))),
    );
    let (mut x1, mut rounded) = ([[c.cos; 3]; 3], [[c.cos; 3]; 3]);
    for i in 0..3 {
        for j in 0..3 {
            x1[i][j] = a[i][6 + j].rounded();
            rounded[i][j] = p[i][j].rounded();
        }
    }
    Reduced {
        value: -(product.times(product).times(determinant).rounded()),
        ratio: least / most,
        x1,
        p: rounded,
    }
}

/// Gaussian elimination of the first six columns with row pivoting in each lane; the diagonal is left inverted.
/// Returns the smallest and largest pivot by magnitude and the product of all (its sign is not needed).
#[inline(always)]
fn triangular<S: Simd, N: Number<S>>(
    a: &mut [[N; COLUMNS]; ROWS],
    one: Lane<S>,
) -> (Lane<S>, Lane<S>, N) {
    let tiny = one.constant(f64::MIN_POSITIVE);
    let (mut least, mut most, mut product) =
        (one.constant(f64::MAX), one.constant(0.0), N::of(one));
    unrolled!(k of ROWS, {
        for i in k + 1..ROWS {
            let larger = a[k][k].rounded().abs().less(a[i][k].rounded().abs());
            for j in k..COLUMNS {
                let (upper, lower) = (a[k][j], a[i][j]);
                a[k][j] = N::pick(larger, lower, upper);
                a[i][j] = N::pick(larger, upper, lower);
            }
        }
        let size = a[k][k].rounded().abs();
        let pivot = N::pick(size.less(tiny), N::of(tiny), a[k][k]);
        (least, most) = (least.min(size), most.max(size));
        product = product.times(pivot);
        let inverse = pivot.inverse();
        a[k][k] = inverse;
        for i in k + 1..ROWS {
            let factor = a[i][k].times(inverse);
            for j in k + 1..COLUMNS {
                a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
            }
        }
    });
    (least, most, product)
}

/// The angles d and e.
type Pair<S> = (Turn<S>, Turn<S>);

impl<S: Simd> Reduced<S> {
    /// The angles d and e at a root.
    #[inline(always)]
    pub(super) fn angles(&self, form: Form) -> Pair<S> {
        self.angles_of(null_vector(&self.p), form)
    }

    /// Where two roots share the angle c, or nearly, P has rank 1 but for the perturbation, and its null vector is a mixture
    /// of both roots'. Each of them is perpendicular to the largest row and of the form (1, cos e, sin e): whether that is
    /// so, and both pairs of angles.
    #[inline(always)]
    pub(super) fn twins(&self, form: Form) -> (Mask<S>, [Pair<S>; 2]) {
        let mut row = self.p[0];
        let mut size = dot(&row, &row);
        for other in [self.p[1], self.p[2]] {
            let square = dot(&other, &other);
            let larger = size.less(square);
            row = pick(larger, &other, &row);
            size = larger.pick(square, size);
        }
        let mut rest = size.constant(0.0);
        for other in &self.p {
            let part = cross(other, &row);
            rest = rest.max(dot(&part, &part));
        }
        let most = size.constant(TOLERANCES.twins * TOLERANCES.twins);
        let twins = rest.less(most * size * size);
        // row . (1, cos e, sin e) = 0
        let [k, c, s] = row;
        let square = c.mul_add(c, s * s);
        let root = k.subtract_product(k, square).max(size.constant(0.0)).sqrt();
        let mut both = [self.angles_of(row, form); 2];
        for (angles, root) in both.iter_mut().zip([root, -root]) {
            let cos = k.subtract_product(c, -(s * root));
            let sin = k.subtract_product(s, c * root);
            *angles = self.angles_of([square, cos, sin], form);
        }
        (twins, both)
    }

    /// The angles d and e that go with a null vector.
    #[inline(always)]
    fn angles_of(&self, y: Vector<S>, form: Form) -> Pair<S> {
        let e = Turn::along(y[1], y[2]);
        let x1y = [
            dot(&self.x1[0], &y),
            dot(&self.x1[1], &y),
            dot(&self.x1[2], &y),
        ];
        // tan((d + phi)/2) = -n/m; twice the angle of (m, -n).
        let (m, n) = (dot(&y, &y), dot(&y, &x1y));
        let half = Turn::along(m, -n);
        let cos = half.sin.subtract_product(half.sin, half.cos * half.cos);
        let sin = (half.sin + half.sin) * half.cos;
        let (shift_cos, shift_sin) = SHIFTS[form.shift];
        let (shift_cos, shift_sin) = (m.constant(shift_cos), m.constant(shift_sin));
        let d = Turn {
            cos: sin.mul_add(shift_sin, cos * shift_cos),
            sin: cos.subtract_product(shift_sin, sin * shift_cos),
        };
        if form.swapped { (e, d) } else { (d, e) }
    }
}

/// The largest cross product of two rows, first component not negative, at unit length.
#[inline(always)]
fn null_vector<S: Simd>(p: &[Vector<S>; 3]) -> Vector<S> {
    let (one, tiny) = (p[0][0].constant(1.0), p[0][0].constant(f64::MIN_POSITIVE));
    let mut unit = *p;
    for row in &mut unit {
        *row = scaled(row, one / dot(row, row).max(tiny).sqrt());
    }
    let mut best = cross(&unit[0], &unit[1]);
    let mut square = dot(&best, &best);
    for (a, b) in [(1, 2), (2, 0)] {
        let candidate = cross(&unit[a], &unit[b]);
        let size = dot(&candidate, &candidate);
        let larger = square.less(size);
        best = pick(larger, &candidate, &best);
        square = square.max(size);
    }
    let inverse = one / square.max(tiny).sqrt();
    let negative = best[0].less(best[0].constant(0.0));
    scaled(&best, negative.pick(-inverse, inverse))
}
