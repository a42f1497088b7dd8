//! A function on a short interval as a polynomial: of degree 8, from 16 samples, in Bernstein form on the eighths of the interval.
//!
//! The samples are at the zeros of the Chebyshev polynomial T16; of the series up to T15 that passes through them, the part up to T8
//! is the polynomial. The rest of a smooth function is next to nothing there: what is found in it is noise.

use pulp::Simd;

use crate::ik::lanes::Lane;

const DEGREE: usize = 8;
pub(super) const SAMPLES: usize = 16;
/// Coefficients of the polynomial.
const COUNT: usize = DEGREE + 1;
/// Parts of the interval.
pub(super) const PARTS: usize = 8;

/// Constant tables.
#[derive(Clone, Debug)]
pub(super) struct Tables {
    /// Where the samples are, from -1 to 1.
    pub(super) nodes: [f64; SAMPLES],
    /// Chebyshev coefficients from samples.
    series: [[f64; SAMPLES]; SAMPLES],
    /// The Bernstein coefficients of Chebyshev polynomials on each part.
    parts: [[[f64; PARTS]; COUNT]; COUNT],
}

impl Tables {
    pub(super) fn new() -> Self {
        // Every other one first, so that half of them are spread like all.
        let place = |k: usize| 2 * (k % (SAMPLES / 2)) + k / (SAMPLES / 2);
        let angle = |k: usize| std::f64::consts::PI * (place(k) as f64 + 0.5) / SAMPLES as f64;
        Self {
            nodes: std::array::from_fn(|k| angle(k).cos()),
            series: std::array::from_fn(|j| {
                let size = if j == 0 { SAMPLES } else { SAMPLES / 2 } as f64;
                std::array::from_fn(|k| (j as f64 * angle(k)).cos() / size)
            }),
            parts: std::array::from_fn(|j| {
                let parts: [_; PARTS] = std::array::from_fn(|part| bernstein(j, part));
                std::array::from_fn(|i| std::array::from_fn(|part| parts[part][i]))
            }),
        }
    }
}

/// The Bernstein coefficients of a Chebyshev polynomial on a part of the interval. All numbers but the last quotient are exact.
fn bernstein(j: usize, part: usize) -> [f64; COUNT] {
    let (mut before, mut powers) = ([0.0; COUNT], [0.0; COUNT]);
    powers[0] = 1.0;
    for step in 0..j {
        let mut next = [0.0; COUNT];
        let factor = if step == 0 { 1.0 } else { 2.0 };
        for k in 0..COUNT {
            next[k] = factor * if k > 0 { powers[k - 1] } else { 0.0 } - before[k];
        }
        (before, powers) = (powers, next);
    }
    // In powers of the distance from the part's beginning, as a share of the part: Horner's rule.
    let (low, width) = (edge(part), edge(part + 1) - edge(part));
    let mut shifted = [0.0; COUNT];
    for power in powers.iter().rev() {
        for k in (0..COUNT).rev() {
            shifted[k] = low * shifted[k] + if k > 0 { width * shifted[k - 1] } else { 0.0 };
        }
        shifted[0] += power;
    }
    let binomial =
        |n: usize, k: usize| (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
    // A common multiple of the binomials of 8.
    let multiple = 280.0;
    std::array::from_fn(|i| {
        let terms = (0..=i).map(|k| binomial(i, k) * (multiple / binomial(DEGREE, k)) * shifted[k]);
        terms.sum::<f64>() / multiple
    })
}

/// Where a part begins, from -1 to 1.
pub(super) fn edge(part: usize) -> f64 {
    (2 * part) as f64 / PARTS as f64 - 1.0
}

/// A polynomial on [-1, 1].
#[derive(Clone, Debug)]
pub(super) struct Local {
    parts: [[f64; PARTS]; COUNT],
    /// Below this a Bernstein coefficient may be noise.
    pub(super) least: f64,
    /// The same for the second derivative.
    flat: f64,
}

/// The value and its first two derivatives.
pub(super) struct Jet {
    pub(super) value: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
}

/// How many roots a part has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Roots {
    None,
    One,
    /// Not known, but the function is convex or concave there: its sign.
    Bent(bool),
    Unknown,
}

/// The part of the coefficients that may be noise where something is still to be seen.
const DARK: f64 = 0.6;
/// Times the noise of the series: with fewer, chance would soon reach it.
const DROWNED: f64 = 30.0;
/// The same for the second derivative, which the noise of the highest terms of the series enters some hundred times; and times an
/// error that does not show in the samples: it is as smooth as the function.
const ROUGH: f64 = 1000.0;
const SMOOTH: f64 = 30.0;

impl Local {
    /// The polynomial that has these values at the nodes, each of them wrong by an error that does not show at most.
    #[inline(always)]
    pub(super) fn new<S: Simd>(
        simd: S,
        tables: &Tables,
        values: &[f64; SAMPLES],
        error: f64,
    ) -> Self {
        let mut series = [0.0; SAMPLES];
        for (coefficient, weights) in series.iter_mut().zip(&tables.series) {
            let mut sum = Lane::splat(simd, 0.0);
            for register in 0..SAMPLES / S::F64_LANES {
                let weight = Lane::load(simd, weights, register);
                sum = weight.mul_add(Lane::load(simd, values, register), sum);
            }
            *coefficient = sum.sum();
        }
        let (kept, beyond) = series.split_at(COUNT);
        let square = beyond.iter().map(|c| c * c).sum::<f64>() / beyond.len() as f64;
        let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let noise = square.sqrt().max(f64::EPSILON * largest);
        let mut parts = [[0.0; PARTS]; COUNT];
        for register in 0..PARTS / S::F64_LANES {
            for i in 0..COUNT {
                let mut sum = Lane::splat(simd, 0.0);
                for (j, &coefficient) in kept.iter().enumerate() {
                    let weight = Lane::load(simd, &tables.parts[j][i], register);
                    sum = weight.mul_add(Lane::splat(simd, coefficient), sum);
                }
                sum.store(&mut parts[i], register);
            }
        }
        // What is no number is noise.
        let least = if (noise + error).is_finite() {
            (DROWNED * noise).max(error)
        } else {
            f64::MAX
        };
        let flat = if least < f64::MAX {
            ROUGH * noise + SMOOTH * error
        } else {
            f64::MAX
        };
        Self { parts, least, flat }
    }

    #[inline(always)]
    fn list(&self, part: usize) -> [f64; COUNT] {
        std::array::from_fn(|i| self.parts[i][part])
    }

    /// The roots of a part, by Descartes' rule of signs.
    #[inline(always)]
    pub(super) fn roots(&self, part: usize) -> Roots {
        let list = self.list(part);
        let changes = list.windows(2).filter(|w| w[0] * w[1] < 0.0).count();
        let is_vague = |x: f64| x.is_nan() || x.abs() < self.least;
        let vague = list.iter().filter(|x| is_vague(**x)).count();
        let ends = is_vague(list[0]) || is_vague(list[DEGREE]);
        match (changes, vague) {
            (0, 0) => return Roots::None,
            (1, 0 | 1) if !ends => return Roots::One,
            _ => {}
        }
        let bends = list.windows(3).map(|w| BEND * (w[2] - 2.0 * w[1] + w[0]));
        let (up, down) = bends.fold((true, true), |(up, down), bend| {
            (up && bend > self.flat, down && bend < -self.flat)
        });
        if up || down {
            Roots::Bent(up)
        } else {
            Roots::Unknown
        }
    }

    /// Whether noise has the upper hand.
    #[inline(always)]
    pub(super) fn is_dark(&self) -> bool {
        let all = self.parts.iter().flatten();
        let vague = all.filter(|x| x.is_nan() || x.abs() < self.least).count();
        vague as f64 > DARK * (PARTS * COUNT) as f64
    }

    /// De Casteljau's rule.
    #[inline(always)]
    pub(super) fn at(&self, x: f64) -> Jet {
        let part = ((x + 1.0) * (0.5 * PARTS as f64)).clamp(0.0, PARTS as f64 - 1.0) as usize;
        let share = (x - edge(part)) * (0.5 * PARTS as f64);
        let mut list = self.list(part);
        let mut jet = Jet {
            value: 0.0,
            slope: 0.0,
            bend: 0.0,
        };
        let (n, rate) = (DEGREE as f64, 0.5 * PARTS as f64);
        for left in (1..COUNT).rev() {
            if left == 2 {
                jet.bend = BEND * (list[2] - 2.0 * list[1] + list[0]);
            } else if left == 1 {
                jet.slope = n * rate * (list[1] - list[0]);
            }
            for i in 0..left {
                list[i] = share.mul_add(list[i + 1] - list[i], list[i]);
            }
        }
        jet.value = list[0];
        jet
    }

    /// The root between two places with different signs.
    #[inline(always)]
    pub(super) fn root(&self, low: f64, high: f64) -> f64 {
        self.zero(low, high, |jet| (jet.value, jet.slope))
    }

    /// Where the slope is zero between two places, if its sign differs there.
    #[inline(always)]
    pub(super) fn top(&self, low: f64, high: f64) -> Option<f64> {
        let crosses = self.at(low).slope * self.at(high).slope < 0.0;
        crosses.then(|| self.zero(low, high, |jet| (jet.slope, jet.bend)))
    }

    /// Newton's method between bounds, for a number and its derivative.
    #[inline(always)]
    fn zero(&self, mut low: f64, mut high: f64, of: impl Fn(&Jet) -> (f64, f64)) -> f64 {
        let sign = of(&self.at(low)).0;
        let mut at = 0.5 * (low + high);
        for _ in 0..STEPS {
            let (value, slope) = of(&self.at(at));
            if value * sign < 0.0 {
                high = at;
            } else {
                low = at;
            }
            let newton = at - value / slope;
            let inside = low <= newton && newton <= high;
            let next = if inside { newton } else { 0.5 * (low + high) };
            let moved = (next - at).abs();
            at = next;
            if moved < SHORT {
                break;
            }
        }
        at
    }
}

/// The second derivative from second differences of Bernstein coefficients of a part.
const BEND: f64 = 0.25 * (DEGREE * (DEGREE - 1) * PARTS * PARTS) as f64;
/// Newton steps at most.
const STEPS: usize = 40;
/// The last step, as a share of half the interval.
const SHORT: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;

    /// On a random polynomial of degree 8 the local one is that polynomial, its noise is rounding, and its roots are roots.
    #[test]
    fn polynomials_are_reproduced() {
        let tables = Tables::new();
        let mut random = crate::ik::general::random::Random::new(1);
        for _ in 0..200 {
            let coefficients: [f64; COUNT] = std::array::from_fn(|_| random.signed());
            let value = |x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
            let local = Local::new(pulp::Scalar::new(), &tables, &tables.nodes.map(value), 0.0);
            assert!(local.least < 1e-12);
            for k in 0..=100 {
                let x = f64::from(k) / 50.0 - 1.0;
                assert!((local.at(x).value - value(x)).abs() < 1e-14);
            }
            for part in 0..PARTS {
                let (low, high) = (edge(part), edge(part + 1));
                let crosses = value(low) * value(high) < 0.0;
                match local.roots(part) {
                    Roots::None => assert!(!crosses),
                    Roots::One => {
                        assert!(crosses);
                        let root = local.root(low, high);
                        assert!(value(root).abs() < 1e-13 && low < root && root < high);
                    }
                    Roots::Bent(up) => {
                        let bend = value(low) + value(high) - 2.0 * value(0.5 * (low + high));
                        assert_eq!(bend > 0.0, up);
                    }
                    Roots::Unknown => {}
                }
            }
        }
    }
}
