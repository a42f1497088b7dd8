//! Small dense algebra on the stack, for matrices whose size is known only when the program runs.

use super::arm::MAX_JOINTS;

/// The most equations: six for a pose, one for each joint's damping, one for a border.
const MAX_ROWS: usize = 6 + MAX_JOINTS + 1;

/// A least-squares problem `min |A x - b|`, by Householder's reflections.
pub(super) struct LeastSquares {
    columns: [[f64; MAX_ROWS]; MAX_JOINTS],
    right: [f64; MAX_ROWS],
    rows: usize,
    unknowns: usize,
}

/// A pivot below this part of its column's length: the column depends on those before it.
const DEPENDENT: f64 = 1e-14;

impl LeastSquares {
    pub(super) fn new(unknowns: usize) -> Self {
        Self {
            columns: [[0.0; MAX_ROWS]; MAX_JOINTS],
            right: [0.0; MAX_ROWS],
            rows: 0,
            unknowns,
        }
    }

    /// Adds the equation `sum of entry(j) x_j = right`.
    pub(super) fn add(&mut self, entry: impl Fn(usize) -> f64, right: f64) {
        for (j, column) in self.columns.iter_mut().enumerate().take(self.unknowns) {
            column[self.rows] = entry(j);
        }
        self.right[self.rows] = right;
        self.rows += 1;
    }

    /// The solution; unknowns that the equations leave open are zero.
    pub(super) fn solve(mut self) -> [f64; MAX_JOINTS] {
        let (rows, unknowns) = (self.rows, self.unknowns);
        let mut diagonal = [0.0; MAX_JOINTS];
        for j in 0..unknowns.min(rows) {
            let whole = norm(&self.columns[j][..rows]);
            let length = norm(&self.columns[j][j..rows]);
            if length <= DEPENDENT * whole || length == 0.0 {
                continue;
            }
            let pivot = -length.copysign(self.columns[j][j]);
            diagonal[j] = pivot;
            self.columns[j][j] -= pivot;
            let reflector = self.columns[j];
            let scale = -1.0 / (pivot * reflector[j]);
            let reflect = |v: &mut [f64; MAX_ROWS]| {
                let dot: f64 = (j..rows).map(|i| reflector[i] * v[i]).sum();
                for i in j..rows {
                    v[i] -= dot * scale * reflector[i];
                }
            };
            self.columns[j + 1..unknowns].iter_mut().for_each(reflect);
            reflect(&mut self.right);
        }
        let mut x = [0.0; MAX_JOINTS];
        for j in (0..unknowns.min(rows)).rev() {
            if diagonal[j] != 0.0 {
                let known: f64 = (j + 1..unknowns).map(|k| self.columns[k][j] * x[k]).sum();
                x[j] = (self.right[j] - known) / diagonal[j];
            }
        }
        x
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Eigenvalues and eigenvectors of a symmetric matrix of size `n`, smallest first, by Jacobi's rotations.
pub(super) fn symmetric_eigen(
    mut a: [[f64; MAX_JOINTS]; MAX_JOINTS],
    n: usize,
) -> ([f64; MAX_JOINTS], [[f64; MAX_JOINTS]; MAX_JOINTS]) {
    let mut vectors = [[0.0; MAX_JOINTS]; MAX_JOINTS];
    (0..n).for_each(|i| vectors[i][i] = 1.0);
    // Convergence is quadratic; six to eight sweeps reach rounding for n up to 12.
    for _ in 0..12 {
        let mut off = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                off += a[p][q] * a[p][q];
                rotate(&mut a, &mut vectors, n, p, q);
            }
        }
        if off == 0.0 {
            break;
        }
    }
    let mut order: [usize; MAX_JOINTS] = std::array::from_fn(|i| i);
    order[..n].sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    let mut values = [0.0; MAX_JOINTS];
    let mut sorted = [[0.0; MAX_JOINTS]; MAX_JOINTS];
    for (place, &index) in order[..n].iter().enumerate() {
        values[place] = a[index][index];
        (0..n).for_each(|i| sorted[place][i] = vectors[i][index]);
    }
    (values, sorted)
}

fn rotate(
    a: &mut [[f64; MAX_JOINTS]; MAX_JOINTS],
    vectors: &mut [[f64; MAX_JOINTS]; MAX_JOINTS],
    n: usize,
    p: usize,
    q: usize,
) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    for k in 0..n {
        let (x, y) = (a[k][p], a[k][q]);
        (a[k][p], a[k][q]) = (c * x - s * y, s * x + c * y);
    }
    for k in 0..n {
        let (x, y) = (a[p][k], a[q][k]);
        (a[p][k], a[q][k]) = (c * x - s * y, s * x + c * y);
    }
    for row in vectors.iter_mut().take(n) {
        let (x, y) = (row[p], row[q]);
        (row[p], row[q]) = (c * x - s * y, s * x + c * y);
    }
    (a[p][q], a[q][p]) = (0.0, 0.0);
}

/// A symmetric positive semidefinite matrix of six rows; the lower triangle counts.
pub(super) struct Six(pub(super) [[f64; 6]; 6]);

impl Six {
    /// `x` with `(A + damping) x = right`, by Cholesky's decomposition without roots. Pivots that rounding made
    /// smaller than the damping count as that.
    #[inline]
    pub(super) fn solve(mut self, damping: f64, right: [f64; 6]) -> [f64; 6] {
        let a = &mut self.0;
        let mut inverse = [0.0; 6];
        let mut x = right;
        for k in 0..6 {
            let pivot = a[k][k] + damping;
            inverse[k] = 1.0 / if pivot > damping { pivot } else { damping };
            for i in k + 1..6 {
                let factor = a[i][k] * inverse[k];
                for j in k + 1..=i {
                    a[i][j] -= factor * a[j][k];
                }
                x[i] -= factor * x[k];
            }
        }
        for k in (0..6).rev() {
            let known: f64 = (k + 1..6).map(|i| a[i][k] * x[i]).sum();
            x[k] = (x[k] - known) * inverse[k];
        }
        x
    }
}
