//! Constant tables: sampling angles, the discrete Fourier transform, arcs of the circle in Bernstein form.

use std::f64::consts::TAU;

/// Harmonics of the resultant: det S is a trigonometric polynomial of degree 8, 17 coefficients. (The size is 12, less 4
/// because the coefficient of `e^{ic}` in M has rank 4: the factor `(1 + x3^2)^4` of Raghavan and Roth.)
pub(super) const DEGREE: usize = 8;
pub(super) const COEFFICIENTS: usize = 2 * DEGREE + 1;

/// Samples: at least 17; a multiple of every register's lanes.
pub(super) const SAMPLES: usize = 24;

/// Coefficients of the harmonics above the degree that the samples determine; the last one, half the samples, is left out.
pub(super) const BEYOND: usize = 2 * (SAMPLES / 2 - 1 - DEGREE);

/// Arcs into which the circle is cut. On an arc of 1/32 turn the Taylor series of degree 15 of cos 8t is exact to 1e-15.
pub(super) const ARCS: usize = 32;
/// Half an arc.
pub(super) const HALF: f64 = TAU / (2 * ARCS) as f64;
/// Bernstein coefficients on an arc.
pub(super) const BERNSTEIN: usize = 16;

/// The coefficients `[a0, a1, ..., a8, b1, ..., b8]` of `a0 + sum a_k cos k t + b_k sin k t`.
pub(super) type Trigonometric = [f64; COEFFICIENTS];

/// All tables.
#[derive(Clone, Debug)]
pub(super) struct Tables {
    pub(super) sample_cos: [f64; SAMPLES],
    pub(super) sample_sin: [f64; SAMPLES],
    /// The coefficients from the samples.
    pub(super) transform: [[f64; SAMPLES]; COEFFICIENTS],
    /// The same for harmonics that the resultant does not have: what they come to is noise.
    pub(super) beyond: [[f64; SAMPLES]; BEYOND],
    /// Cosine and sine of k times the middle of each arc, k from 1.
    pub(super) arc_cos: [[f64; ARCS]; DEGREE],
    pub(super) arc_sin: [[f64; ARCS]; DEGREE],
    /// The first half of the Bernstein coefficients of cos(k w t), k from 1, and of sin(k w t); the second half is the
    /// mirror image, with the sign changed for the sines.
    pub(super) even: [[f64; DEGREE]; BERNSTEIN / 2],
    pub(super) odd: [[f64; DEGREE]; BERNSTEIN / 2],
}

impl Tables {
    pub(super) fn new() -> Self {
        let angle = |k: usize| TAU * (k as f64 + 0.25) / SAMPLES as f64;
        let middle = |arc: usize| TAU * (arc as f64 + 0.5) / ARCS as f64;
        let transform = std::array::from_fn(|row| {
            std::array::from_fn(|k| {
                let size = SAMPLES as f64;
                match row {
                    0 => 1.0 / size,
                    1..=DEGREE => 2.0 * (row as f64 * angle(k)).cos() / size,
                    _ => 2.0 * ((row - DEGREE) as f64 * angle(k)).sin() / size,
                }
            })
        });
        let beyond = std::array::from_fn(|row| {
            let rate = (DEGREE + 1 + row / 2) as f64;
            std::array::from_fn(|k| {
                let (sin, cos) = (rate * angle(k)).sin_cos();
                2.0 * if row % 2 == 0 { cos } else { sin } / SAMPLES as f64
            })
        });
        let arcs = |function: fn(f64) -> f64| {
            std::array::from_fn(|k| {
                std::array::from_fn(|arc| function((k + 1) as f64 * middle(arc)))
            })
        };
        let powers: Vec<[f64; BERNSTEIN]> = (0..BERNSTEIN).map(bernstein_of_power).collect();
        let series = |parity: usize| {
            std::array::from_fn(|i| {
                std::array::from_fn(|k| {
                    let rate = (k + 1) as f64 * HALF;
                    let mut term = if parity == 0 { 1.0 } else { rate };
                    let mut sum = 0.0;
                    for n in (parity..BERNSTEIN).step_by(2) {
                        sum += term * powers[n][i];
                        term *= -rate * rate / ((n + 1) * (n + 2)) as f64;
                    }
                    sum
                })
            })
        };
        Self {
            sample_cos: std::array::from_fn(|k| angle(k).cos()),
            sample_sin: std::array::from_fn(|k| angle(k).sin()),
            transform,
            beyond,
            arc_cos: arcs(f64::cos),
            arc_sin: arcs(f64::sin),
            even: series(0),
            odd: series(1),
        }
    }
}

/// The Bernstein coefficients of t^n on [-1, 1], degree 15: by its polar form, coefficient i is the coefficient of z^n
/// in `(1 + z)^i (1 - z)^(15 - i)`, over the binomial of 15 and n.
fn bernstein_of_power(n: usize) -> [f64; BERNSTEIN] {
    let degree = BERNSTEIN - 1;
    let binomial = (0..n).fold(1.0, |b, k| b * (degree - k) as f64 / (k + 1) as f64);
    std::array::from_fn(|i| {
        let mut product = [0.0; BERNSTEIN];
        product[0] = 1.0;
        for factor in 0..degree {
            let sign = if factor < i { 1.0 } else { -1.0 };
            for k in (1..BERNSTEIN).rev() {
                product[k] += sign * product[k - 1];
            }
        }
        product[n] / binomial
    })
}
