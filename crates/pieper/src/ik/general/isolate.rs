//! Every real root of the trigonometric polynomial: Descartes' rule of signs in Bernstein form on 32 arcs.
//!
//! On an arc the number of sign changes of the Bernstein coefficients is the number of roots, or larger by an even
//! number (Lane and Riesenfeld, BIT 21, 1981). None: no root. One: exactly one, between the ends. Two, and the coefficients
//! are convex or concave: two on both sides of the extremum, or none. Otherwise the arc is halved by de Casteljau's rule.

use pulp::{Scalar, Simd};

use super::refine::local;
use super::tables::{ARCS, BERNSTEIN, DEGREE, HALF, Tables, Trigonometric};
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Turn};

/// Most candidates: 16 roots, or fewer with near-misses, two extra each.
pub(super) const CANDIDATES: usize = 32;

/// Radians between the ends of pieces that are neighbours.
const ADJACENT: f64 = 1e-6;

/// What a polynomial is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// Of a perturbed elimination: it moves roots, so that a close complex pair may be two real roots.
    Perturbed,
    /// Of an elimination of the arm as it is: right wherever it is above its noise.
    Exact,
    /// Of the true equation: it says the truth wherever it is above its noise, and where it is not, it is drowned.
    Equation,
}

impl Origin {
    /// Radians. Where the noise may move a root by more, it may hide others.
    fn shaky(self) -> f64 {
        match self {
            Self::Equation => TOLERANCES.shaky_equation,
            _ => TOLERANCES.shaky,
        }
    }

    /// Times the noise: where the top of two roots is closer to zero, the arm is asked.
    fn doubt(self) -> f64 {
        match self {
            Self::Equation => TOLERANCES.drowned,
            _ => DOUBTED,
        }
    }
}

/// Intervals that hold one root each, and points that may be one: angle = middle of the arc + offset.
#[derive(Clone, Debug)]
pub(super) struct Candidates {
    pub(super) count: usize,
    /// Some of them are near-misses: points beside which there may be two roots or none.
    pub(super) unsure: bool,
    /// Noise may hide roots, or make some up.
    pub(super) drowned: bool,
    /// Of an exact elimination: some signs are no larger than noise, so that more roots may be where one was seen, or none.
    pub(super) vague: bool,
    /// The smallest number that a sign was taken from.
    pub(super) least: f64,
    pub(super) arc: [u8; CANDIDATES],
    /// Offsets from the arc's middle, radians; equal for a point.
    pub(super) low: [f64; CANDIDATES],
    pub(super) high: [f64; CANDIDATES],
    /// Sign of the polynomial at `low`.
    pub(super) sign: [f64; CANDIDATES],
    /// Where to start.
    pub(super) start: [f64; CANDIDATES],
    /// Of the true equation: where it drowns, first and last angle.
    pub(super) windows: [(f64, f64); WINDOWS],
    pub(super) window_count: usize,
    /// Not of a perturbed elimination: where two roots are nearly one, or nearly real, the angle at the top of their parabola.
    pub(super) pairs: [f64; PAIRS],
    pub(super) pair_count: usize,
}

/// Most pairs: there are 16 roots.
pub(super) const PAIRS: usize = 8;

/// Most windows; more of them are no longer told apart.
pub(super) const WINDOWS: usize = 8;

impl Candidates {
    pub(super) fn new() -> Self {
        Self {
            count: 0,
            unsure: false,
            drowned: false,
            vague: false,
            least: f64::INFINITY,
            arc: [0; CANDIDATES],
            low: [0.0; CANDIDATES],
            high: [0.0; CANDIDATES],
            sign: [1.0; CANDIDATES],
            start: [0.0; CANDIDATES],
            windows: [(0.0, 0.0); WINDOWS],
            window_count: 0,
            pairs: [0.0; PAIRS],
            pair_count: 0,
        }
    }

    fn push_pair(&mut self, top: f64) {
        if self.pair_count < PAIRS {
            self.pairs[self.pair_count] = top;
            self.pair_count += 1;
        } else {
            self.unsure = true;
        }
    }

    /// Adds a piece in which the equation drowns to the window that ends where it begins, or as a new one.
    fn push_window(&mut self, (low, high): (f64, f64)) {
        self.drowned = true;
        match self.windows[..self.window_count].last_mut() {
            Some(last) if low - last.1 < ADJACENT => last.1 = high,
            _ if self.window_count < WINDOWS => {
                self.windows[self.window_count] = (low, high);
                self.window_count += 1;
            }
            _ => self.unsure = true,
        }
    }

    #[inline(always)]
    fn push(&mut self, arc: usize, (low, high): (f64, f64), at_low: f64, start: f64) {
        if self.count == CANDIDATES {
            return;
        }
        let k = self.count;
        self.count += 1;
        self.arc[k] = arc as u8;
        (self.low[k], self.high[k]) = (low, high);
        (self.sign[k], self.start[k]) = (at_low.signum(), start);
    }

    /// Fills the last register with copies of a candidate: what else is there would be worked on until it is given up.
    fn pad(&mut self) {
        let last = self.count.next_multiple_of(8).min(CANDIDATES);
        for k in self.count..last {
            self.arc[k] = self.arc[0];
            self.low[k] = self.low[0];
            self.high[k] = self.high[0];
            self.sign[k] = self.sign[0];
            self.start[k] = self.start[0];
        }
    }

    /// How many of them are intervals.
    pub(super) fn intervals(&self) -> usize {
        (0..self.count)
            .filter(|&k| self.low[k] < self.high[k])
            .count()
    }

    fn push_point(&mut self, arc: usize, at: f64) {
        self.push(arc, (at, at), 1.0, at);
    }
}

/// Where the chord is zero, but not close to the ends.
#[inline(always)]
fn chord((low, high): (f64, f64), (at_low, at_high): (f64, f64)) -> f64 {
    let share = at_low / (at_low - at_high);
    let share = if share.is_finite() {
        share.clamp(0.05, 0.95)
    } else {
        0.5
    };
    share.mul_add(high - low, low)
}

/// About where the only zero is: that of the control polygon.
#[inline(always)]
fn crossing((low, high): (f64, f64), list: impl Fn(usize) -> f64) -> f64 {
    let last = BERNSTEIN - 1;
    let k = (0..last).find(|&k| list(k) * list(k + 1) < 0.0);
    let k = k.unwrap_or(last / 2);
    let share = (k as f64 + list(k) / (list(k) - list(k + 1))) / last as f64;
    share.mul_add(high - low, low)
}

/// Of every arc, how often the sign of the Bernstein coefficients changes, and how many of them noise may have changed.
struct Signs {
    changes: [f64; ARCS],
    vague: [f64; ARCS],
    /// The smallest of the coefficients.
    least: [f64; ARCS],
}

/// The Bernstein coefficients of all arcs and their signs.
#[inline(always)]
fn bernstein<S: Simd>(
    simd: S,
    tables: &Tables,
    polynomial: &Trigonometric,
    out: &mut [[f64; ARCS]; BERNSTEIN],
    noise: f64,
    signs: &mut Signs,
) {
    let zero = Lane::splat(simd, 0.0);
    let one = Lane::splat(simd, 1.0);
    let constant = Lane::splat(simd, polynomial[0]);
    for register in 0..ARCS / S::F64_LANES {
        let (mut even, mut odd) = ([zero; DEGREE], [zero; DEGREE]);
        for k in 0..DEGREE {
            let a = Lane::splat(simd, polynomial[1 + k]);
            let b = Lane::splat(simd, polynomial[1 + DEGREE + k]);
            let cos = Lane::load(simd, &tables.arc_cos[k], register);
            let sin = Lane::load(simd, &tables.arc_sin[k], register);
            even[k] = a.mul_add(cos, b * sin);
            odd[k] = a.subtract_product(sin, b * cos);
        }
        let mut list = [zero; BERNSTEIN];
        for i in 0..BERNSTEIN / 2 {
            let (mut symmetric, mut opposite) = (constant, zero);
            for k in 0..DEGREE {
                symmetric = even[k].mul_add(Lane::splat(simd, tables.even[i][k]), symmetric);
                opposite = odd[k].mul_add(Lane::splat(simd, tables.odd[i][k]), opposite);
            }
            list[i] = symmetric + opposite;
            list[BERNSTEIN - 1 - i] = symmetric - opposite;
        }
        let drowned = Lane::splat(simd, TOLERANCES.drowned * noise);
        let (mut count, mut vague) = (zero, zero);
        let mut least = list[0].abs();
        for i in 0..BERNSTEIN {
            list[i].store(&mut out[i], register);
            least = least.min(list[i].abs());
            vague = vague + list[i].abs().less(drowned).pick(one, zero);
            if i > 0 {
                let change = (list[i - 1] * list[i]).less(zero);
                count = count + change.pick(one, zero);
            }
        }
        count.store(&mut signs.changes, register);
        vague.store(&mut signs.vague, register);
        least.store(&mut signs.least, register);
    }
}

/// Isolates the real roots.
#[inline(always)]
pub(super) fn isolate<S: Simd>(
    simd: S,
    tables: &Tables,
    polynomial: &Trigonometric,
    noise: f64,
    origin: Origin,
    out: &mut Candidates,
) {
    let mut coefficients = [[0.0; ARCS]; BERNSTEIN];
    let mut signs = Signs {
        changes: [0.0; ARCS],
        vague: [0.0; ARCS],
        least: [0.0; ARCS],
    };
    bernstein(
        simd,
        tables,
        polynomial,
        &mut coefficients,
        noise,
        &mut signs,
    );
    for (arc, (&changes, &vague)) in signs.changes.iter().zip(&signs.vague).enumerate() {
        // One vague sign between two others may be noise; two may be two changes more.
        let doubtful = vague > changes.min(1.0);
        let settled = origin != Origin::Equation || !doubtful;
        out.vague |= doubtful && changes < 2.0;
        if changes < 2.0 {
            out.least = out.least.min(signs.least[arc]);
        }
        if changes == 0.0 && settled {
            out.drowned |= vague > 0.0;
        } else if changes == 1.0 && settled {
            let start = crossing((-HALF, HALF), |i| coefficients[i][arc]);
            out.push(arc, (-HALF, HALF), coefficients[0][arc], start);
        } else {
            let list = std::array::from_fn(|i| coefficients[i][arc]);
            Arc {
                tables,
                polynomial,
                noise,
                origin,
                index: arc,
            }
            .subdivide(list, out);
        }
    }
    out.pad();
}

/// One arc and the polynomial on it.
struct Arc<'a> {
    tables: &'a Tables,
    polynomial: &'a Trigonometric,
    noise: f64,
    origin: Origin,
    index: usize,
}

/// A part of an arc: its ends and its Bernstein coefficients.
#[derive(Clone, Copy)]
struct Piece {
    low: f64,
    high: f64,
    list: [f64; BERNSTEIN],
}

/// Radians: pieces that are vague are halved to this, so that little of the circle is looked at again.
const WINDOW: f64 = 0.01;

/// Of an elimination: its noise is measured, and now and then there is ten times more of it.
const DOUBTED: f64 = 100.0;

/// Radians: the last step towards an extremum is shorter. What is left of it is the square of that, and changes the value there
/// by less than rounding does.
const FOUND: f64 = 1e-5;

/// Halvings of an arc at most: down to the least width.
const DEPTH: usize = 12;

impl Arc<'_> {
    /// Halves until every part has at most one sign change, or is decided otherwise.
    #[inline(always)]
    fn subdivide(&self, list: [f64; BERNSTEIN], out: &mut Candidates) {
        let whole = Piece {
            low: -HALF,
            high: HALF,
            list,
        };
        let mut stack = [whole; DEPTH + 1];
        let (mut depth, mut proposed) = (1, false);
        let is_equation = self.origin == Origin::Equation;
        while depth > 0 {
            depth -= 1;
            let piece = stack[depth];
            let width = piece.high - piece.low;
            let changes = sign_changes(&piece.list);
            let vague = self.is_vague(&piece, changes);
            out.vague |= vague && changes < 2;
            if changes < 2 {
                out.least = piece
                    .list
                    .iter()
                    .fold(out.least, |least, x| least.min(x.abs()));
            }
            let last = width < TOLERANCES.least_width || depth + 2 > DEPTH;
            match changes {
                _ if vague && is_equation && (width < WINDOW || last) => self.window(&piece, out),
                _ if vague && is_equation => piece.split(&mut stack, &mut depth),
                0 => self.touch(&piece, &mut proposed, out),
                1 => {
                    let ends = (piece.low, piece.high);
                    let start = crossing(ends, |i| piece.list[i]);
                    out.push(self.index, ends, piece.list[0], start);
                }
                2 if self.two(&piece, &mut proposed, out) => {}
                _ if last && is_equation => self.window(&piece, out),
                _ if last => {
                    out.unsure = true;
                    out.push_point(self.index, 0.5 * (piece.low + piece.high));
                }
                _ => piece.split(&mut stack, &mut depth),
            }
        }
    }

    /// The equation itself has to be looked at.
    #[inline(always)]
    fn window(&self, piece: &Piece, out: &mut Candidates) {
        let middle = HALF * (2 * self.index + 1) as f64;
        out.push_window((middle + piece.low, middle + piece.high));
    }

    /// Whether noise may have hidden some of the sign changes of a piece.
    #[inline(always)]
    fn is_vague(&self, piece: &Piece, changes: usize) -> bool {
        let least = TOLERANCES.drowned * self.noise;
        let vague = || piece.list.iter().filter(|x| x.abs() < least).count();
        self.origin != Origin::Perturbed && vague() > changes.min(1)
    }

    /// No root, unless the polynomial is so small there that noise may hide some: then the point where it is smallest is
    /// proposed, once in an arc.
    #[inline(always)]
    fn touch(&self, piece: &Piece, proposed: &mut bool, out: &mut Candidates) {
        let (mut place, mut least) = (0, f64::INFINITY);
        for (index, value) in piece.list.iter().enumerate() {
            if value.abs() < least {
                (place, least) = (index, value.abs());
            }
        }
        if least >= TOLERANCES.drowned * self.noise {
            return;
        }
        out.drowned = true;
        if !*proposed {
            *proposed = true;
            out.unsure = true;
            let share = place as f64 / (BERNSTEIN - 1) as f64;
            out.push_point(self.index, share.mul_add(piece.high - piece.low, piece.low));
        }
    }

    /// Two sign changes: true if it is known what they mean.
    #[inline(always)]
    fn two(&self, piece: &Piece, proposed: &mut bool, out: &mut Candidates) -> bool {
        let is_bent = piece.is_bent(TOLERANCES.drowned * self.noise);
        if !is_bent && piece.high - piece.low > TOLERANCES.pair_width {
            return false;
        }
        match piece.extremum() {
            Some(start) => self.pair(piece, (start, is_bent), proposed, out),
            // The same sign at both ends, and nothing but up or down between them.
            None => is_bent,
        }
    }

    /// Two roots or none, with an extremum between: finds it by Newton's method. Either it is across zero from the ends
    /// and parts two roots; or the roots are a complex pair, and if that is as close to real as noise can make it,
    /// points around are proposed, once in an arc. True if the piece is decided: not if there is no extremum inside, or
    /// if there may be another.
    #[inline(always)]
    fn pair(
        &self,
        piece: &Piece,
        (start, is_bent): (f64, bool),
        proposed: &mut bool,
        out: &mut Candidates,
    ) -> bool {
        let mut at = start;
        let margin = piece.high - piece.low;
        let mut values = self.values(at);
        for _ in 0..8 {
            let step = values[1] / values[2];
            if step.is_nan() || step.abs() > margin {
                return false;
            }
            at -= step;
            values = self.values(at);
            if step.abs() < FOUND {
                break;
            }
        }
        if at <= piece.low || at >= piece.high {
            return false;
        }
        let (top, bend) = (values[0].abs(), values[2].abs());
        let drowned = top < TOLERANCES.drowned * self.noise;
        let flat = (2.0 * top * bend).sqrt() < self.noise / self.origin.shaky();
        let doubt = self.origin.doubt() * self.noise;
        if self.origin != Origin::Perturbed && (top < doubt || flat) {
            let most = top + doubt;
            if 2.0 * most < TOLERANCES.beside * TOLERANCES.beside * bend {
                out.push_pair(HALF * (2 * self.index + 1) as f64 + at);
                return true;
            }
            out.drowned |= self.origin == Origin::Exact && (drowned || flat);
        }
        out.least = out.least.min(top);
        let (at_low, at_high) = piece.ends();
        if (values[0] < 0.0) != (at_low < 0.0) {
            // As far from the top as those of a parabola.
            let beside = (2.0 * top / bend).sqrt();
            for (ends, signs, start) in [
                ((piece.low, at), (at_low, values[0]), at - beside),
                ((at, piece.high), (values[0], at_high), at + beside),
            ] {
                let is_inside = ends.0 < start && start < ends.1;
                let start = if is_inside { start } else { chord(ends, signs) };
                out.push(self.index, ends, signs.0, start);
            }
            return true;
        }
        if self.origin != Origin::Perturbed {
            // Halved until the pair leaves no more sign changes, where there may be other extrema beside, or the noise be more than
            // is known of it.
            return is_bent && top > TOLERANCES.clear * self.noise;
        }
        out.drowned |= drowned;
        let imaginary = (2.0 * top / bend).sqrt();
        if imaginary < TOLERANCES.near_miss && !*proposed {
            *proposed = true;
            out.unsure = true;
            for offset in [0.0, imaginary, -imaginary] {
                out.push_point(self.index, at + offset);
            }
        }
        margin < TOLERANCES.short
    }

    /// The polynomial and its first two derivatives at an offset from the middle.
    #[inline(always)]
    fn values(&self, offset: f64) -> [f64; 3] {
        let scalar = |x: f64| Lane::splat(Scalar::new(), x);
        let middle = Turn {
            cos: scalar(self.tables.arc_cos[0][self.index]),
            sin: scalar(self.tables.arc_sin[0][self.index]),
        };
        let turn = local(middle, scalar(offset));
        let (c, s) = (turn.cos.largest(), turn.sin.largest());
        let (mut ck, mut sk) = (1.0, 0.0);
        let mut out = [self.polynomial[0], 0.0, 0.0];
        for k in 1..=DEGREE {
            (ck, sk) = (ck * c - sk * s, sk * c + ck * s);
            let (a, b, rate) = (self.polynomial[k], self.polynomial[DEGREE + k], k as f64);
            let (value, slope) = (a * ck + b * sk, b * ck - a * sk);
            out[0] += value;
            out[1] += rate * slope;
            out[2] -= rate * rate * value;
        }
        out
    }
}

impl Piece {
    #[inline(always)]
    fn ends(&self) -> (f64, f64) {
        (self.list[0], self.list[BERNSTEIN - 1])
    }

    /// Whether it is convex or concave, whatever an error of this size does to the coefficients.
    #[inline(always)]
    fn is_bent(&self, error: f64) -> bool {
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 1..BERNSTEIN - 1 {
            let bend = (self.list[k + 1] - self.list[k]) - (self.list[k] - self.list[k - 1]);
            (least, most) = (least.min(bend), most.max(bend));
        }
        least > 4.0 * error || most < -4.0 * error
    }

    /// About where it turns: the zero of the slope's control polygon, if it has one.
    #[inline(always)]
    fn extremum(&self) -> Option<f64> {
        let slope = |k: usize| self.list[k + 1] - self.list[k];
        let last = BERNSTEIN - 2;
        let k = (0..last).find(|&k| slope(k) * slope(k + 1) < 0.0)?;
        let share = (k as f64 + slope(k) / (slope(k) - slope(k + 1))) / last as f64;
        Some(share.mul_add(self.high - self.low, self.low))
    }

    /// Puts both halves on the stack.
    #[inline(always)]
    fn split(&self, stack: &mut [Self; DEPTH + 1], depth: &mut usize) {
        let (left, right) = self.halves();
        (stack[*depth], stack[*depth + 1]) = (right, left);
        *depth += 2;
    }

    /// De Casteljau's rule at the middle.
    #[inline(always)]
    fn halves(&self) -> (Self, Self) {
        let middle = 0.5 * (self.low + self.high);
        let mut right = self.list;
        let mut left = [0.0; BERNSTEIN];
        left[0] = right[0];
        for step in 1..BERNSTEIN {
            for i in 0..BERNSTEIN - step {
                right[i] = 0.5 * (right[i] + right[i + 1]);
            }
            left[step] = right[0];
        }
        let part = |low, high, list| Self { low, high, list };
        (part(self.low, middle, left), part(middle, self.high, right))
    }
}

#[inline(always)]
fn sign_changes(list: &[f64; BERNSTEIN]) -> usize {
    list.windows(2)
        .filter(|pair| pair[0] * pair[1] < 0.0)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::general::random::Random;

    struct Isolate<'a>(&'a Tables, &'a Trigonometric, &'a mut Candidates);

    impl pulp::WithSimd for Isolate<'_> {
        type Output = ();
        fn with_simd<S: Simd>(self, simd: S) {
            isolate(simd, self.0, self.1, 0.0, Origin::Perturbed, self.2);
        }
    }

    /// As many candidates as sign changes on a fine grid, for random polynomials.
    #[test]
    fn finds_every_root_of_random_polynomials() {
        let tables = Tables::new();
        let mut random = Random::new(1);
        for _ in 0..300 {
            let polynomial: Trigonometric = std::array::from_fn(|_| random.signed());
            let mut found = Candidates::new();
            pulp::Arch::new().dispatch(Isolate(&tables, &polynomial, &mut found));
            let value = |k: usize| {
                let arc = Arc {
                    tables: &tables,
                    polynomial: &polynomial,
                    noise: 0.0,
                    origin: Origin::Perturbed,
                    index: k / 256,
                };
                arc.values(((k % 256) as f64 / 128.0 - 1.0) * HALF)[0]
            };
            let total = ARCS * 256;
            let changes = (0..total)
                .filter(|&k| value(k) * value((k + 1) % total) < 0.0)
                .count();
            let brackets = (0..found.count)
                .filter(|&k| found.low[k] < found.high[k])
                .count();
            assert_eq!(brackets, changes);
        }
    }
}
