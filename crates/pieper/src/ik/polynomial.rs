//! Real roots of the polynomials that three joints lead to.

use super::TOLERANCES;

/// Real roots of a polynomial of degree at most four.
#[derive(Clone, Copy, Debug)]
pub(super) struct RealRoots {
    /// Each with the number of roots it stands for: 2 where the function touches zero, or comes so close to it
    /// without crossing that rounding decides.
    values: [(f64, u8); 16],
    len: usize,
}

impl RealRoots {
    fn new() -> Self {
        Self {
            values: [(0.0, 1); 16],
            len: 0,
        }
    }

    fn push(&mut self, x: f64, count: u8) {
        if self.len < self.values.len() {
            self.values[self.len] = (x, count);
            self.len += 1;
        }
    }

    /// Adds a root unless it is there already, modulo `period`: found from both sides of a border.
    fn push_once(&mut self, x: f64, count: u8, period: f64) {
        let same = |&(y, _): &(f64, u8)| {
            let gap = x - y;
            let gap = gap - period * (gap / period).round();
            gap.abs() <= TOLERANCES.exact * x.abs().max(1.0)
        };
        if !self.as_slice().iter().any(same) {
            self.push(x, count);
        }
    }

    pub(super) fn as_slice(&self) -> &[(f64, u8)] {
        &self.values[..self.len]
    }
}

/// Coefficients in rising order.
pub(super) type Quartic = [f64; 5];

/// Adds `factor * a * b` to a quartic, for `a` and `b` of degree at most two.
pub(super) fn add_product(sum: &mut Quartic, factor: f64, a: &[f64; 3], b: &[f64; 3]) {
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            sum[i + j] += factor * x * y;
        }
    }
}

fn value(c: &Quartic, x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, a| sum * x + a)
}

fn derivative(c: &Quartic) -> Quartic {
    [c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4], 0.0]
}

/// The ends of the interval that [`roots_in_unit`] looks at: a little beyond 1, so that a root on the border of two
/// intervals is found at least once.
const BORDER: f64 = 1.0 + 1e-6;

/// Roots in [-1, 1]: between neighbouring extrema, themselves found so, a polynomial is monotone.
///
/// An extremum closer to zero than `touch` (relative to the coefficients) counts as a root.
fn roots_in_unit(c: &Quartic, degree: usize, touch: f64) -> RealRoots {
    let mut found = RealRoots::new();
    let scale: f64 = c.iter().map(|a| a.abs()).sum();
    if degree == 0 || scale == 0.0 {
        return found;
    }
    let inner = roots_in_unit(&derivative(c), degree - 1, 0.0);
    let mut from = -BORDER;
    for (index, &(to, _)) in inner.as_slice().iter().chain(&[(BORDER, 1)]).enumerate() {
        let (f, g) = (value(c, from), value(c, to));
        if f == 0.0 && index == 0 {
            found.push(from, 1);
        }
        let extremum = index < inner.len;
        if g == 0.0 {
            found.push(to, if extremum { 2 } else { 1 });
        } else if f != 0.0 && (f < 0.0) != (g < 0.0) {
            found.push(bisect(c, from, to, f), 1);
        } else if extremum && g.abs() < touch * scale {
            found.push(to, 2);
        }
        from = to;
    }
    found
}

/// The root between two points of opposite sign: Newton's method, kept inside by bisection.
fn bisect(c: &Quartic, mut low: f64, mut high: f64, at_low: f64) -> f64 {
    let slope = derivative(c);
    let mut x = 0.5 * (low + high);
    for _ in 0..80 {
        let f = value(c, x);
        if f == 0.0 {
            return x;
        }
        if (f < 0.0) == (at_low < 0.0) {
            low = x;
        } else {
            high = x;
        }
        let newton = x - f / value(&slope, x);
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if (next - x).abs() <= f64::EPSILON * x.abs() || high - low <= f64::EPSILON {
            return next;
        }
        x = next;
    }
    x
}

/// All real roots of a quartic on the whole line, infinity apart.
pub(super) fn real_roots(c: &Quartic, slack: f64) -> RealRoots {
    let touch = touch(slack);
    let mut all = roots_in_unit(c, 4, touch);
    let reversed = [c[4], c[3], c[2], c[1], c[0]];
    let outer = roots_in_unit(&reversed, 4, touch);
    for &(x, count) in outer.as_slice() {
        // 0 is infinity.
        if x != 0.0 {
            all.push_once(1.0 / x, count, f64::MAX);
        }
    }
    all
}

/// How close to zero an extremum counts as a root: the noise of coefficients that are themselves products of
/// rounded numbers, or the miss of the class.
fn touch(slack: f64) -> f64 {
    TOLERANCES.boundary.max(64.0 * slack)
}

/// A trigonometric polynomial `k + c cos x + s sin x + d cos 2x + t sin 2x`, as a quadratic in cosine and sine.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Quadratic {
    /// 1, c, s, c^2, c s, s^2
    terms: [f64; 6],
}

/// `k + c cos x + s sin x`
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Linear {
    pub(super) k: f64,
    pub(super) c: f64,
    pub(super) s: f64,
}

impl Linear {
    // Plain products: without a fused unit at compile time `mul_add` is a library call.
    #[inline]
    pub(super) fn at(&self, (sin, cos): (f64, f64)) -> f64 {
        self.c * cos + self.s * sin + self.k
    }

    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            k: self.k + factor * other.k,
            c: self.c + factor * other.c,
            s: self.s + factor * other.s,
        }
    }
}

impl Quadratic {
    /// Adds `factor * a * b`.
    pub(super) fn add(&mut self, factor: f64, a: &Linear, b: &Linear) {
        let products = [
            a.k * b.k,
            a.k * b.c + a.c * b.k,
            a.k * b.s + a.s * b.k,
            a.c * b.c,
            a.c * b.s + a.s * b.c,
            a.s * b.s,
        ];
        for (term, product) in self.terms.iter_mut().zip(products) {
            *term += factor * product;
        }
    }

    /// All angles at which it vanishes.
    ///
    /// With `t = tan(x/2)` it is a quartic; the two half circles around 0 and around pi are two quartics on
    /// [-1, 1], so that no root lies at infinity.
    pub(super) fn roots(&self, slack: f64) -> RealRoots {
        let mut all = RealRoots::new();
        for (middle, sign) in [(0.0, 1.0), (std::f64::consts::PI, -1.0)] {
            let [k, c, s, cc, cs, ss] = self.terms;
            let (c, s) = (sign * c, sign * s);
            // cos = (1 - t^2)/(1 + t^2), sin = 2t/(1 + t^2)
            let quartic = [
                k + c + cc,
                2.0 * (s + cs),
                2.0 * k - 2.0 * cc + 4.0 * ss,
                2.0 * (s - cs),
                k - c + cc,
            ];
            let half = roots_in_unit(&quartic, 4, touch(slack));
            for &(t, count) in half.as_slice() {
                all.push_once(middle + 2.0 * t.atan(), count, std::f64::consts::TAU);
            }
        }
        all
    }
}
