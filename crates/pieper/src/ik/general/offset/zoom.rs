//! The equation at close range: where its polynomial drowns in rounding, it is sampled itself on shorter and shorter intervals. Its own
//! rounding vanishes with it near such places, and so a few looks tell the roots apart.

use std::f64::consts::TAU;

use pulp::{Simd, WithSimd};

use super::equation::Equation;
use super::local::{Local, PARTS, Roots, SAMPLES, Tables, edge};
use crate::ik::general::isolate::Candidates;
use crate::ik::general::list::List;
use crate::ik::general::random::Random;
use crate::ik::general::refine::local;
use crate::ik::general::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Turn};

/// Intervals of the unknown, radians: first and last angle.
pub(super) type Windows = List<(f64, f64), WINDOWS>;

/// Most windows.
const WINDOWS: usize = 64;
/// Radians: wider ones are cut.
const WIDEST: f64 = 0.1;

/// Those in which the polynomial drowns.
pub(super) fn drowned(candidates: &Candidates) -> Windows {
    let mut windows = Windows::new();
    for &(low, high) in &candidates.windows[..candidates.window_count] {
        let pieces = ((high - low) / WIDEST).ceil().max(1.0);
        let step = (high - low) / pieces;
        for k in 0..pieces as usize {
            let begin = step.mul_add(k as f64, low);
            windows.push((begin, begin + step));
        }
    }
    windows
}

impl Windows {
    /// Adds what is around an angle, up to where there are windows already.
    pub(super) fn add_around(&mut self, angle: f64, reach: f64) {
        if self.hold(angle) {
            return;
        }
        let (mut before, mut behind) = (reach, reach);
        for &(low, high) in self.iter() {
            behind = behind.min((low - angle).rem_euclid(TAU));
            before = before.min((angle - high).rem_euclid(TAU));
        }
        self.push((angle - before, angle + behind));
    }

    /// Whether an angle is in one of them.
    pub(super) fn hold(&self, angle: f64) -> bool {
        self.iter()
            .any(|&(low, high)| (angle - low).rem_euclid(TAU) < high - low)
    }
}

/// A simple root of the equation.
#[derive(Clone, Copy, Default)]
pub(super) struct Sighting {
    pub(super) angle: f64,
    /// Of the equation, per radian.
    pub(super) slope: f64,
    /// Radians: it is no farther away than this.
    pub(super) room: f64,
    /// Whether it is in the window itself, not beside it.
    pub(super) inside: bool,
}

/// What is to be seen in windows.
pub(super) struct Sight {
    pub(super) roots: List<Sighting, ROOTS>,
    /// Where two roots are nearly one.
    pub(super) tops: List<f64, ROOTS>,
    /// Where it is not known what there is.
    pub(super) dark: Windows,
}

/// Most of each.
pub(super) const ROOTS: usize = 32;

impl Sight {
    pub(super) fn new() -> Self {
        Self {
            roots: List::new(),
            tops: List::new(),
            dark: Windows::new(),
        }
    }

    /// Whether it is all.
    pub(super) fn is_clear(&self) -> bool {
        self.dark.is_empty() && !self.roots.overflowed && !self.tops.overflowed
    }

    /// The distance of a top from the nearest of the others and of the simple roots.
    pub(super) fn nearest(&self, index: usize) -> f64 {
        let roots = self.roots.iter().map(|root| root.angle);
        let tops = self.tops.iter().enumerate();
        let others = tops.filter(|(k, _)| *k != index).map(|(_, top)| *top);
        let distance = |angle: f64| (angle - self.tops[index]).abs();
        roots
            .chain(others)
            .fold(f64::INFINITY, |least, angle| least.min(distance(angle)))
    }
}

/// Looks into windows.
pub(super) struct Zoom<'a> {
    pub(super) equation: &'a Equation,
    pub(super) symmetric: bool,
    pub(super) tables: &'a Tables,
    pub(super) windows: &'a Windows,
    pub(super) sight: &'a mut Sight,
}

/// By how much the numbers of the equation are changed to see what their rounding does to it: it is the same for all samples, so that
/// they do not show it. On short intervals by less, or it would no longer be a small change: as a part of half the interval at most,
/// and what it then is, so that it is not chosen anew each time.
const SHIFT: f64 = 1e-10;
const MOST_SHIFT: f64 = 0.02;
const NEXT_SHIFT: f64 = 0.002;
/// In how many ways they are changed: one may by chance do little.
const MOVED: usize = 3;
/// Of the changes.
const SEED: u64 = 0x6571_7561;
/// By how much rounding may have changed them.
const ERROR: f64 = 4e-15;
/// Looks at most.
const LOOKS: usize = 128;
/// Radians: half an interval, no closer.
const CLOSEST: f64 = 1e-14;
/// Of a window's width: as much is looked at beyond its ends, so that a root at an end is not at the end of what is seen. Unequal, so
/// that what is in a window's middle is not at the end of a part.
const MARGINS: (f64, f64) = (0.13, 0.22);
/// A vague place is looked at closer if it is a smaller part of the interval than this, on either side.
const SMALL: f64 = 0.08;
/// Times as far as it is vague: so much of it is looked at.
const BEYOND: f64 = 4.0;
/// A group of parts that is longer, of 2, is halved: looking at it again would show no more.
const LONG: f64 = 1.1;

impl WithSimd for Zoom<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self {
            equation,
            symmetric,
            tables,
            windows,
            sight,
        } = self;
        let mut random = Random::new(SEED);
        let mut shift = SHIFT;
        let mut moved: [_; MOVED] = std::array::from_fn(|_| equation.moved(shift, &mut random));
        let mut queue = Queue::new();
        for &window in windows.iter() {
            queue.push(window);
        }
        let mut next = 0;
        while next < queue.len() {
            let (low, high) = queue[next];
            next += 1;
            let (before, behind) = (MARGINS.0 * (high - low), MARGINS.1 * (high - low));
            let middle = 0.5 * (low - before + high + behind);
            let half = 0.5 * (high - low + before + behind);
            if half < CLOSEST {
                sight.dark.push((low, high));
                continue;
            }
            if shift > MOST_SHIFT * half {
                shift = NEXT_SHIFT * half;
                moved = std::array::from_fn(|_| equation.moved(shift, &mut random));
            }
            let (sin, cos) = middle.sin_cos();
            let turn = Turn {
                cos: Lane::splat(simd, cos),
                sin: Lane::splat(simd, sin),
            };
            let mut values = [0.0; SAMPLES];
            let mut change = Lane::splat(simd, 0.0);
            for register in 0..SAMPLES / S::F64_LANES {
                let offset = Lane::load(simd, &tables.nodes, register) * Lane::splat(simd, half);
                let angle = local(turn, offset);
                let value = equation.at(angle).value(symmetric);
                value.store(&mut values, register);
                // Some of the samples are enough.
                if register < SAMPLES / S::F64_LANES / 2 {
                    for other in &moved {
                        let other = other.at(angle).value(symmetric);
                        change = change.max((other - value).abs());
                    }
                }
            }
            let error = change.largest() * (ERROR / shift);
            Look {
                local: &Local::new(simd, tables, &values, error),
                window: (low, high),
                middle,
                half,
            }
            .sort(&mut queue, sight);
        }
    }
}

/// Windows that wait.
type Queue = List<(f64, f64), LOOKS>;

/// What is seen of one window.
struct Look<'a> {
    local: &'a Local,
    /// The window itself.
    window: (f64, f64),
    /// The middle of the interval that is looked at, with its margins, and half its length.
    middle: f64,
    half: f64,
}

impl Look<'_> {
    /// Sorts what is there: roots, tops of pairs, and places that have to be looked at closer.
    #[inline(always)]
    fn sort(&self, queue: &mut Queue, sight: &mut Sight) {
        if self.local.is_dark() {
            sight.dark.push(self.window);
            return;
        }
        let kinds: [Roots; PARTS] = std::array::from_fn(|part| self.local.roots(part));
        let mut part = 0;
        while part < PARTS {
            let first = part;
            part += 1;
            match kinds[first] {
                Roots::None => {}
                Roots::One => self.push_root(edge(first), edge(part), sight),
                kind => {
                    let mut alike = kind != Roots::Unknown;
                    while part < PARTS && !matches!(kinds[part], Roots::None | Roots::One) {
                        alike &= kinds[part] == kind;
                        part += 1;
                    }
                    let (low, high) = (edge(first), edge(part));
                    if !(alike && self.bent(low, high, queue, sight)) {
                        self.closer(low, high, queue, sight);
                    }
                }
            }
        }
    }

    /// Where the function is convex or concave there are two roots at most. False if they have to be looked at closer.
    #[inline(always)]
    fn bent(&self, low: f64, high: f64, queue: &mut Queue, sight: &mut Sight) -> bool {
        let least = self.local.least;
        let (at_low, at_high) = (self.local.at(low).value, self.local.at(high).value);
        let Some(top) = self.local.top(low, high) else {
            if at_low * at_high < 0.0 {
                self.push_root(low, high, sight);
            }
            return true;
        };
        let jet = self.local.at(top);
        if jet.value.abs() >= least {
            if at_low * jet.value < 0.0 {
                self.push_root(low, top, sight);
            }
            if at_high * jet.value < 0.0 {
                self.push_root(top, high, sight);
            }
            return true;
        }
        let vague = (2.0 * least / jet.bend.abs()).sqrt();
        if vague < SMALL {
            let reach = BEYOND * vague;
            self.closer(top - reach, top + reach, queue, sight);
            return true;
        }
        // As if a root were as far from the top as noise allows.
        let farthest = 2.0 * vague * self.half;
        let is_pair = farthest < TOLERANCES.beside;
        if is_pair {
            sight.tops.push(self.angle(top));
        }
        is_pair
    }

    /// Whether an angle is in the window itself.
    #[inline(always)]
    fn holds(&self, angle: f64) -> bool {
        self.window.0 <= angle && angle < self.window.1
    }

    #[inline(always)]
    fn angle(&self, at: f64) -> f64 {
        self.half.mul_add(at, self.middle)
    }

    #[inline(always)]
    fn push_root(&self, low: f64, high: f64, sight: &mut Sight) {
        let at = self.local.root(low, high);
        let angle = self.angle(at);
        sight.roots.push(Sighting {
            angle,
            slope: self.local.at(at).slope / self.half,
            room: self.half * (high - low),
            inside: self.holds(angle),
        });
    }

    /// What is seen is not known well enough: a window of its own, or two where it is most of this one.
    #[inline(always)]
    fn closer(&self, low: f64, high: f64, queue: &mut Queue, sight: &mut Sight) {
        // Beside the window others look.
        let low = self.angle(low).max(self.window.0);
        let high = self.angle(high).min(self.window.1);
        if low >= high {
            return;
        }
        let middle = 0.5 * (low + high);
        let parts = if high - low > LONG * self.half {
            [Some((low, middle)), Some((middle, high))]
        } else {
            [Some((low, high)), None]
        };
        for part in parts.into_iter().flatten() {
            queue.push(part);
            if queue.overflowed {
                sight.dark.push(part);
            }
        }
    }
}
