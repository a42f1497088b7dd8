//! The solutions found so far, as sines and cosines.

use pulp::Simd;

use super::newton::Angles;
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Turn};

/// Real roots that a pose can have at most (Primrose 1986); members of families may fill the rest.
pub const MAX_ROOTS: usize = 16;
/// Copies near double roots and points of families need some room more.
pub(super) const CAPACITY: usize = 32;

/// Cosine and sine of the six joints, cosines first.
pub(super) type Point = [f64; 12];

/// Distinct solutions, and which of them the current elimination has found.
#[derive(Clone, Debug)]
pub(super) struct Pool {
    pub(super) count: usize,
    pub(super) points: [Point; CAPACITY],
    pub(super) errors: [f64; CAPACITY],
    /// For how many roots each stands, where a fold told: 2 for a double one; 0 where none did.
    pub(super) told: [u8; CAPACITY],
    /// One bit for each solution that the current elimination found.
    pub(super) hit: u64,
}

impl Pool {
    pub(super) fn new() -> Self {
        Self {
            count: 0,
            points: [[0.0; 12]; CAPACITY],
            errors: [0.0; CAPACITY],
            told: [0; CAPACITY],
            hit: 0,
        }
    }

    /// Starts a new elimination.
    pub(super) fn start(&mut self) {
        self.hit = 0;
    }

    /// Whether a solution is singular, and no fold told for how many roots it stands.
    pub(super) fn is_open(&self, sigma: &[f64; CAPACITY], index: usize) -> bool {
        self.told[index] == 0 && sigma[index] < TOLERANCES.doubles
    }

    /// Those that are, one bit each: copies of a double root, members of a family.
    pub(super) fn open(&self, sigma: &[f64; CAPACITY]) -> u64 {
        (0..self.count).fold(0, |mask, index| {
            mask | (u64::from(self.is_open(sigma, index)) << index)
        })
    }

    /// One bit for each solution.
    pub(super) fn listed(&self) -> u64 {
        (1 << self.count) - 1
    }

    /// For how many roots the solutions stand, as far as it is known.
    pub(super) fn roots(&self) -> usize {
        let told = self.told[..self.count].iter();
        told.map(|&roots| usize::from(roots.max(1))).sum()
    }

    /// Merges copies of singular solutions: rounding of the pose moves their joints by its size over sigma. True if there
    /// were any.
    pub(super) fn merge(&mut self, sigma: &mut [f64; CAPACITY]) -> bool {
        let before = self.count;
        let mut index = 1;
        while index < self.count {
            let copy = (0..index).find(|&kept| {
                let s = sigma[kept].max(sigma[index]);
                let allowed = match (self.told[kept], self.told[index]) {
                    (0, 0) => {
                        (TOLERANCES.scatter / s).clamp(TOLERANCES.same, TOLERANCES.most_scatter)
                    }
                    (1, 1) => TOLERANCES.same,
                    // Beside a fold there is nothing but what it told.
                    _ => TOLERANCES.same_fold,
                };
                s < TOLERANCES.singular
                    && distance(&self.points[kept], &self.points[index]) < allowed
            });
            let Some(kept) = copy else {
                index += 1;
                continue;
            };
            let last = self.count - 1;
            // The joints' error at a double root grows with sigma: the smaller one is the better copy.
            let better = sigma[index] < sigma[kept] && self.errors[index] < TOLERANCES.closes_well;
            if (self.told[kept], better) < (self.told[index], true) {
                self.points[kept] = self.points[index];
                self.errors[kept] = self.errors[index];
                self.told[kept] = self.told[index];
                sigma[kept] = sigma[index];
            }
            if (self.hit >> index) & 1 == 1 {
                self.hit |= 1 << kept;
            }
            self.points.copy_within(index + 1..=last, index);
            self.errors.copy_within(index + 1..=last, index);
            self.told.copy_within(index + 1..=last, index);
            sigma.copy_within(index + 1..=last, index);
            let below = (1_u64 << index) - 1;
            self.hit = (self.hit & below) | ((self.hit >> 1) & !below);
            self.count = last;
        }
        self.count < before
    }

    /// Adds the first `used` lanes whose error is at most `most`; for each lane the bit of its solution.
    #[inline(always)]
    pub(super) fn add<S: Simd>(
        &mut self,
        q: &Angles<S>,
        errors: Lane<S>,
        used: usize,
        most: f64,
    ) -> [u64; 8] {
        let mut error = [0.0; 8];
        errors.store(&mut error, 0);
        let points = scatter(q);
        let mut bits = [0; 8];
        for lane in 0..used.min(8) {
            if error[lane] <= most {
                bits[lane] = self.insert(&points[lane], error[lane], 0);
            }
        }
        bits
    }

    /// Adds all of them to others.
    pub(super) fn add_to(&self, pool: &mut Self) {
        for index in 0..self.count {
            pool.insert(&self.points[index], self.errors[index], self.told[index]);
        }
    }

    /// Adds a solution unless it is there; either way it counts as hit, and its bit is returned. What a fold told (see [`Pool::told`]) is
    /// better than what none did, and the smaller error otherwise.
    pub(super) fn insert(&mut self, point: &Point, error: f64, told: u8) -> u64 {
        let (mut nearest, mut least) = (0, f64::INFINITY);
        for index in 0..self.count {
            let other = &self.points[index];
            // Nearly all of them are excluded by the first joint alone.
            if (point[0] - other[0]).abs() >= TOLERANCES.same_fold {
                continue;
            }
            let away = distance(point, other);
            if away < least {
                (nearest, least) = (index, away);
            }
        }
        // Beside a fold there is nothing but what it told.
        let is_copy = told == 0 && least < TOLERANCES.same_fold && self.told[nearest] > 0;
        if is_copy || least < TOLERANCES.same {
            if (told, -error) > (self.told[nearest], -self.errors[nearest]) {
                self.points[nearest] = *point;
                self.errors[nearest] = error;
                self.told[nearest] = told;
            }
        } else if self.count < CAPACITY {
            nearest = self.count;
            self.points[nearest] = *point;
            self.errors[nearest] = error;
            self.told[nearest] = told;
            self.count += 1;
        } else {
            return 0;
        }
        self.hit |= 1 << nearest;
        1 << nearest
    }
}

/// Every lane as a point of its own.
#[inline(always)]
pub(super) fn scatter<S: Simd>(q: &Angles<S>) -> [Point; 8] {
    let mut points = [[0.0; 12]; 8];
    for (joint, Turn { cos, sin }) in q.iter().enumerate() {
        let mut numbers = [[0.0; 8]; 2];
        cos.store(&mut numbers[0], 0);
        sin.store(&mut numbers[1], 0);
        for (lane, point) in points.iter_mut().enumerate() {
            (point[joint], point[6 + joint]) = (numbers[0][lane], numbers[1][lane]);
        }
    }
    points
}

/// Points as lanes, the last one in all that are left.
#[inline(always)]
pub(super) fn gather<S: Simd>(simd: S, points: &[Point]) -> Angles<S> {
    let mut numbers = [[0.0; 8]; 12];
    let last = points.len().saturating_sub(1);
    for lane in 0..S::F64_LANES {
        let Some(point) = points.get(lane.min(last)) else {
            break;
        };
        for (list, x) in numbers.iter_mut().zip(point) {
            list[lane] = *x;
        }
    }
    let zero = Lane::splat(simd, 0.0);
    let mut q = [Turn {
        cos: zero,
        sin: zero,
    }; 6];
    for (joint, turn) in q.iter_mut().enumerate() {
        turn.cos = Lane::load(simd, &numbers[joint], 0);
        turn.sin = Lane::load(simd, &numbers[6 + joint], 0);
    }
    q
}

/// The largest difference of two solutions' sines and cosines.
pub(super) fn distance(a: &Point, b: &Point) -> f64 {
    let mut most = 0.0_f64;
    for (x, y) in a.iter().zip(b) {
        most = most.max((x - y).abs());
    }
    most
}
