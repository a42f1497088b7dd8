//! The last resort: where looks at the equation did not tell how many roots there are, it is sampled closer and closer around sign changes
//! and around the smallest values, to the last digit; and everything that it allows there is tried.

use pulp::{Simd, WithSimd};

use super::equation::Equation;
use super::finish::Finish;
use crate::ik::general::pool::Pool;
use crate::ik::general::refine::local;
use crate::ik::lanes::{Lane, Turn};

/// Most places to look at.
const SPOTS: usize = 64;

/// Places where the equation is zero or as good as zero.
pub(super) struct Spots {
    pub(super) count: usize,
    cos: [f64; SPOTS],
    sin: [f64; SPOTS],
}

impl Spots {
    pub(super) fn new(angles: impl Iterator<Item = f64>) -> Self {
        let mut spots = Self {
            count: 0,
            cos: [1.0; SPOTS],
            sin: [0.0; SPOTS],
        };
        for angle in angles {
            spots.push(angle);
        }
        spots
    }

    fn push(&mut self, angle: f64) {
        if self.count < SPOTS {
            (self.sin[self.count], self.cos[self.count]) = angle.sin_cos();
            self.count += 1;
        }
    }

    /// Fills the last register with copies.
    fn pad(&mut self) {
        let last = self.count.next_multiple_of(8).min(SPOTS);
        let first = (self.cos[0], self.sin[0]);
        self.cos[self.count..last].fill(first.0);
        self.sin[self.count..last].fill(first.1);
    }
}

/// Looks into all windows.
pub(super) struct Magnify<'a> {
    pub(super) equation: &'a Equation,
    pub(super) symmetric: bool,
    pub(super) windows: &'a [(f64, f64)],
    pub(super) spots: &'a mut Spots,
}

/// Samples of one look.
const SAMPLES: usize = 32;
/// Looks at one window, at most.
const LOOKS: usize = 128;
/// More pieces than this are noise, on intervals shorter than `DIM`.
const CLEAR: usize = 5;
/// Radians.
const DIM: f64 = 1e-5;
/// Spots in a window as short as that, whatever is seen in it: where four roots are nearly one, as the directions from there are, no
/// value is smaller than the others for certain.
const EVENLY: usize = 8;
/// Radians: no closer, angles have no more digits.
const CLOSEST: f64 = 1e-15;

impl WithSimd for Magnify<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for &(low, high) in self.windows {
            let middle = 0.5 * (low + high);
            if high - low < DIM {
                for k in 0..EVENLY {
                    self.spots
                        .push(low + (high - low) * (k as f64 + 0.5) / EVENLY as f64);
                }
            }
            // Some more than the window: a smallest value at its end would not be seen.
            let half = 0.55 * (high - low);
            let mut queue = [(0.0, 0.0); LOOKS];
            queue[0] = (-half, half);
            let (mut next, mut end) = (0, 1);
            while next < end {
                let (low, high) = queue[next];
                next += 1;
                if high - low < CLOSEST {
                    self.spots.push(middle + 0.5 * (low + high));
                    continue;
                }
                let values = self.sample(simd, middle, (low, high));
                let mut pieces = [(0, 0); SAMPLES];
                let count = pieces_of(&values, &mut pieces);
                if count > CLEAR {
                    // Rounding has the upper hand, if this is not the first look at two roots and more beside each other.
                    self.spots.push(middle + 0.5 * (low + high));
                    if high - low < DIM {
                        continue;
                    }
                }
                let step = (high - low) / (SAMPLES - 1) as f64;
                let at = |index: usize| step.mul_add(index as f64, low);
                for &(first, last) in &pieces[..count] {
                    if end < LOOKS {
                        queue[end] = (at(first), at(last));
                        end += 1;
                    }
                }
            }
        }
        self.spots.pad();
    }
}

/// Where to look closer: between which samples the sign changes, or the value is smallest.
fn pieces_of(values: &[f64; SAMPLES], out: &mut [(usize, usize); SAMPLES]) -> usize {
    let mut count = 0;
    for k in 1..SAMPLES {
        let (left, here) = (values[k - 1], values[k]);
        let crosses = |other: f64| (other < 0.0) != (here < 0.0);
        let least = values.get(k + 1).is_some_and(|&right| {
            !crosses(left)
                && !crosses(right)
                && here.abs() <= left.abs()
                && here.abs() < right.abs()
        });
        let piece = match (crosses(left), least) {
            (true, _) => (k - 1, k),
            // Some more than the neighbours: two smallest values side by side look like one.
            (_, true) => (k.saturating_sub(2), (k + 2).min(SAMPLES - 1)),
            _ => continue,
        };
        out[count] = piece;
        count += 1;
    }
    count
}

impl Magnify<'_> {
    #[inline(always)]
    fn sample<S: Simd>(&self, simd: S, middle: f64, (low, high): (f64, f64)) -> [f64; SAMPLES] {
        let mut offsets = [0.0; SAMPLES];
        let step = (high - low) / (SAMPLES - 1) as f64;
        for (index, offset) in offsets.iter_mut().enumerate() {
            *offset = step.mul_add(index as f64, low);
        }
        let (sin, cos) = middle.sin_cos();
        let middle = Turn {
            cos: Lane::splat(simd, cos),
            sin: Lane::splat(simd, sin),
        };
        let mut values = [0.0; SAMPLES];
        for register in 0..SAMPLES / S::F64_LANES {
            let angle = local(middle, Lane::load(simd, &offsets, register));
            let value = self.equation.at(angle).value(self.symmetric);
            value.store(&mut values, register);
        }
        values
    }
}

/// Everything that the equations allow at one register of spots.
pub(super) struct Search<'a> {
    pub(super) finish: &'a Finish<'a>,
    pub(super) spots: &'a Spots,
    pub(super) register: usize,
    pub(super) pool: &'a mut Pool,
}

impl WithSimd for Search<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let angle = Turn {
            cos: Lane::load(simd, &self.spots.cos, self.register),
            sin: Lane::load(simd, &self.spots.sin, self.register),
        };
        let used = (self.spots.count - self.register * S::F64_LANES).min(S::F64_LANES);
        let at = self.finish.equation.at(angle);
        let x = at.distance();
        for x in [x, -x] {
            let [a, b, c, d] = at.turns(x);
            for turn in [at.turn(x), a, b, c, d] {
                let branch = at.branch(x, turn);
                self.finish.solve(simd, angle, &branch, used, self.pool);
            }
        }
    }
}
