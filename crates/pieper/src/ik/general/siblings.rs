//! Near a singularity roots come in pairs, and the eliminations may see only one: its sibling is searched for along the
//! direction in which the arm moves without moving its end.

use pulp::{Simd, WithSimd};

use super::newton::{Goal, measure, newton};
use super::pool::{CAPACITY, Pool, gather};
use super::tolerances::TOLERANCES;
use crate::ik::lanes::Lane;

/// Measures the solutions from `first` on.
#[inline(always)]
pub(super) fn measure_new<S: Simd>(
    simd: S,
    goal: &Goal<'_>,
    pool: &Pool,
    first: usize,
    sigma: &mut [f64; CAPACITY],
) {
    let first = first - first % S::F64_LANES;
    for register in first / S::F64_LANES..pool.count.div_ceil(S::F64_LANES) {
        simd.vectorize(Measure {
            goal,
            pool,
            register,
            sigma,
        });
    }
}

struct Measure<'a, 'b> {
    goal: &'a Goal<'b>,
    pool: &'a Pool,
    register: usize,
    sigma: &'a mut [f64; CAPACITY],
}

impl WithSimd for Measure<'_, '_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let first = self.register * S::F64_LANES;
        let q = gather(simd, &self.pool.points[first..self.pool.count]);
        let measured = measure(simd, self.goal, &q);
        measured.sigma.store(self.sigma, self.register);
    }
}

/// Whether every nearly singular solution has a partner that is as singular: siblings are, on both sides of a double root
/// and at a wrist that flips. Families have more members than that.
pub(super) fn paired(pool: &Pool, sigma: &[f64; CAPACITY]) -> bool {
    let list = &sigma[..pool.count];
    list.iter().enumerate().all(|(index, &s)| {
        let alike = |(other, &t): (usize, &f64)| other != index && t < 2.0 * s && s < 2.0 * t;
        let close = (TOLERANCES.doubles..=TOLERANCES.singular).contains(&s);
        !close || list.iter().enumerate().any(alike)
    })
}

/// Searches siblings of nearly singular solutions.
#[inline(always)]
pub(super) fn search<S: Simd>(
    simd: S,
    goal: &Goal<'_>,
    pool: &mut Pool,
    sigma: &mut [f64; CAPACITY],
) {
    let (mut next, mut searched) = (0, 0);
    while next < pool.count && searched < SEARCHES {
        if sigma[next] < TOLERANCES.singular {
            searched += 1;
            let before = pool.count;
            for register in 0..STARTS / S::F64_LANES {
                simd.vectorize(Along {
                    goal,
                    pool,
                    index: next,
                    register,
                });
            }
            measure_new(simd, goal, pool, before, sigma);
        }
        next += 1;
    }
}

/// Searches at most: the members of a family would go on for ever.
const SEARCHES: usize = 6;

/// Starts along the null direction.
const STARTS: usize = 16;

/// Their distances in radians: far ones for flips of a wrist, near ones for the other half of a double root.
const DISTANCES: [f64; STARTS] = [
    2e-4, -2e-4, 2e-3, -2e-3, 1e-2, -1e-2, 5e-2, -5e-2, 0.3, -0.3, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0,
];

struct Along<'a, 'b> {
    goal: &'a Goal<'b>,
    pool: &'a mut Pool,
    index: usize,
    register: usize,
}

impl WithSimd for Along<'_, '_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let mut q = gather(simd, &[self.pool.points[self.index]]);
        let measured = measure(simd, self.goal, &q);
        let distance = Lane::load(simd, &DISTANCES, self.register);
        for (joint, turn) in q.iter_mut().enumerate() {
            let step = measured.free[joint] * distance;
            *turn = turn.moved(step, self.goal.slides[joint]);
        }
        let errors = newton(simd, self.goal, &mut q);
        self.pool.add(&q, errors, S::F64_LANES, TOLERANCES.closes);
    }
}
