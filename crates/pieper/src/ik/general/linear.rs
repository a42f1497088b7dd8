//! Systems of linear equations, one in each lane.

use pulp::Simd;

use crate::ik::lanes::{Lane, Mask, unrolled};

pub(super) type Matrix<S, const N: usize> = [[Lane<S>; N]; N];

/// A matrix after Gaussian elimination with row pivoting in each lane.
pub(super) struct Factors<S: Simd, const N: usize> {
    /// Multipliers below the diagonal, inverse pivots on it.
    a: Matrix<S, N>,
    /// Where row k was exchanged with row i below it.
    exchanged: [[Mask<S>; N]; N],
}

impl<S: Simd, const N: usize> Factors<S, N> {
    #[inline(always)]
    pub(super) fn of(mut a: Matrix<S, N>) -> Self {
        let one = a[0][0].constant(1.0);
        let tiny = one.constant(1e-300);
        let mut exchanged = [[one.less(one); N]; N];
        unrolled!(k of N, {
            for i in k + 1..N {
                let larger = a[k][k].abs().less(a[i][k].abs());
                for j in k..N {
                    let (upper, lower) = (a[k][j], a[i][j]);
                    a[k][j] = larger.pick(lower, upper);
                    a[i][j] = larger.pick(upper, lower);
                }
                exchanged[k][i] = larger;
            }
            let pivot = a[k][k].abs().less(tiny).pick(tiny, a[k][k]);
            a[k][k] = one / pivot;
            for i in k + 1..N {
                let factor = a[i][k] * a[k][k];
                for j in k + 1..N {
                    a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
                }
                a[i][k] = factor;
            }
        });
        Self { a, exchanged }
    }

    /// The x of `A x = r`.
    #[inline(always)]
    pub(super) fn solve(&self, mut r: [Lane<S>; N]) -> [Lane<S>; N] {
        unrolled!(k of N, {
            for i in k + 1..N {
                let exchanged = self.exchanged[k][i];
                (r[k], r[i]) = (exchanged.pick(r[i], r[k]), exchanged.pick(r[k], r[i]));
            }
            for i in k + 1..N {
                r[i] = self.a[i][k].subtract_product(r[k], r[i]);
            }
        });
        unrolled!(k of N, {
            let i = N - 1 - k;
            for j in i + 1..N {
                r[i] = self.a[i][j].subtract_product(r[j], r[i]);
            }
            r[i] = r[i] * self.a[i][i];
        });
        r
    }
}

/// The inverse, by Gauss and Jordan in place with row pivoting in each lane.
#[inline(always)]
pub(super) fn invert<S: Simd, const N: usize>(mut a: Matrix<S, N>) -> Matrix<S, N> {
    let (zero, one) = (a[0][0].constant(0.0), a[0][0].constant(1.0));
    let tiny = one.constant(1e-30);
    let mut exchanged = [[one.less(one); N]; N];
    unrolled!(k of N, {
        for i in k + 1..N {
            let larger = a[k][k].abs().less(a[i][k].abs());
            exchanged[k][i] = larger;
            for j in 0..N {
                let (upper, lower) = (a[k][j], a[i][j]);
                a[k][j] = larger.pick(lower, upper);
                a[i][j] = larger.pick(upper, lower);
            }
        }
        let pivot = a[k][k].abs().less(tiny).pick(tiny, a[k][k]);
        let inverse = one / pivot;
        a[k][k] = one;
        for j in 0..N {
            a[k][j] = a[k][j] * inverse;
        }
        for i in 0..N {
            if i != k {
                let factor = a[i][k];
                a[i][k] = zero;
                for j in 0..N {
                    a[i][j] = factor.subtract_product(a[k][j], a[i][j]);
                }
            }
        }
    });
    // What was done to the rows of the matrix is undone in the columns of its inverse.
    unrolled!(step of N, {
        let k = N - 1 - step;
        for i in (k + 1..N).rev() {
            for row in &mut a {
                let (here, there) = (row[k], row[i]);
                row[k] = exchanged[k][i].pick(there, here);
                row[i] = exchanged[k][i].pick(here, there);
            }
        }
    });
    a
}
