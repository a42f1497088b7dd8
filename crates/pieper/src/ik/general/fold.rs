//! A fold: two solutions that are nearly one. Newton's method finds one of them slowly, and often only one. Here both are told
//! apart by what separates them.
//!
//! Let n be the direction in which the joints move without moving the end, and u the motion of the end that they cannot make.
//! On the curve where the error of the pose is along u alone, parametrised by the distance t along n, that error is a
//! parabola; its roots are the two solutions (Liapunov and Schmidt's reduction). The curve, the slope and the bend of the error
//! follow from `[J u; n^T 0]`, which is regular at a fold, and from the acceleration of the end.

use pulp::{Simd, WithSimd};

use super::list::List;
use super::newton::{Angles, Curve, Goal, curve, measure, newton};
use super::pool::{CAPACITY, Point, Pool, distance, gather, scatter};
use super::siblings;
use super::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Mask, square};

/// Tells apart the solutions beside points that are close to folds, as many as a register takes.
pub(super) struct Folds<'a, 'b> {
    pub(super) goal: &'a Goal<'b>,
    pub(super) starts: &'a [Point],
}

/// The solutions beside a fold: two, one that is double, or none.
#[derive(Clone)]
pub(super) struct Told {
    /// The top of the parabola, where the arm is singular.
    pub(super) top: Point,
    /// And the errors of their poses.
    solutions: List<(Point, f64), 2>,
    /// The joints have no second direction that nearly keeps the pose: there is nothing else close to the fold.
    is_simple: bool,
}

/// Where the curve is bent more, per radian, a second direction nearly keeps the pose.
const CURVED: f64 = 1e3;
/// Lanes of the widest register.
const LANES: usize = 8;

/// Radians: how far the start may be from the top of the parabola.
const REACH: f64 = 0.01;
/// Radians: where a start is farther from the curve, the parabola there says nothing about its top yet.
const OFF: f64 = 0.01;
/// No fold is within reach of a point whose smallest singular value is larger.
const FAR: f64 = 0.05;
/// The bend must be the same at the start and at the top up to this part.
const ALIKE: f64 = 0.1;
/// Radians: what is as close to the curve, and to the top, is seen exactly: the error is wrong by the square of the one and
/// the third power of the other.
const ON_CURVE: f64 = 1e-9;
const AT_TOP: f64 = 3e-6;
const STEPS: usize = 8;
/// The error of the pose by which rounding of the target and of the arm's motion may move the parabola.
const NOISE: f64 = 1e-15;
/// What the parabola may be wrong by when it says that it has no root.
const BIAS: f64 = 1e-14;
/// Radians: a parabola that leaves its roots less certain is none.
const VAGUE: f64 = 1e-5;
/// Radians: solutions that are farther from the top must come out as two.
const DISTINCT: f64 = 1e-6;

impl WithSimd for Folds<'_, '_> {
    /// For each start nothing if there is no fold, or more than one.
    type Output = [Option<Told>; LANES];

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> [Option<Told>; LANES] {
        let tops = self.tops(simd);
        let roots = tops.roots();
        let points = scatter(&tops.point(Lane::splat(simd, 0.0), self.goal.slides));
        let mut curvatures = [0.0; LANES];
        square(&tops.curve.curvature).store(&mut curvatures, 0);
        let mut told = [const { None }; LANES];
        let mut halves = [0.0; LANES];
        for lane in 0..self.starts.len().min(S::F64_LANES) {
            let top = points[lane];
            let mut solutions = List::new();
            match roots[lane] {
                Roots::Unclear => continue,
                Roots::None => {}
                Roots::One(error) => solutions.push((top, error)),
                Roots::Two(half) => halves[lane] = half,
            }
            told[lane] = Some(Told {
                top,
                solutions,
                is_simple: curvatures[lane] < CURVED * CURVED,
            });
        }
        // Starts beside the same fold: the first of them solves it.
        let twins = twins(&told);
        for lane in 0..LANES {
            if twins[lane] != lane {
                halves[lane] = 0.0;
            }
        }
        if halves != [0.0; LANES] {
            self.solve(simd, &tops, &halves, &mut told);
        }
        for lane in 0..LANES {
            if twins[lane] != lane {
                told[lane] = told[twins[lane]].clone();
            }
        }
        told
    }
}

impl Folds<'_, '_> {
    /// Climbs along the curves to the tops.
    #[inline(always)]
    fn tops<S: Simd>(&self, simd: S) -> Tops<S> {
        let mut at = gather(simd, self.starts);
        let measured = measure(simd, self.goal, &at);
        let zero = Lane::splat(simd, 0.0);
        let (reach, off) = (Lane::splat(simd, REACH), Lane::splat(simd, OFF));
        let (on_curve, at_top) = (Lane::splat(simd, ON_CURVE), Lane::splat(simd, AT_TOP));
        let mut is_near = measured.sigma.less(Lane::splat(simd, FAR));
        let mut is_seen = zero.less(zero);
        let (mut first, mut travelled) = (zero, zero);
        let mut steps = STEPS;
        loop {
            let curve = curve(simd, self.goal, &measured, &at);
            let distance = square(&curve.step).sqrt();
            let is_close = distance.less(off);
            first = is_seen.pick(first, curve.bend);
            is_seen = is_seen.or(is_close);
            let along = is_close.pick(-(curve.slope / curve.bend), zero);
            travelled = travelled + along;
            is_near = is_near.and(travelled.abs().less(reach));
            let is_exact = distance.less(on_curve).and(along.abs().less(at_top));
            steps -= 1;
            if steps == 0 || !is_near.and_not(is_exact).any() {
                let is_there = is_near.and(is_exact);
                return Tops {
                    at,
                    curve,
                    first,
                    is_there,
                };
            }
            at = curve.point(&at, along, self.goal.slides);
        }
    }

    /// Solutions at these distances to both sides of the tops.
    #[inline(always)]
    fn solve<S: Simd>(
        &self,
        simd: S,
        tops: &Tops<S>,
        halves: &[f64; LANES],
        told: &mut [Option<Told>; LANES],
    ) {
        let half = Lane::load(simd, halves, 0);
        let mut beside = [[0.0; 12]; 2 * LANES];
        let mut owners: List<usize, { 2 * LANES }> = List::new();
        for side in [-half, half] {
            let points = scatter(&tops.point(side, self.goal.slides));
            for lane in 0..S::F64_LANES {
                if halves[lane] > 0.0 {
                    beside[owners.len()] = points[lane];
                    owners.push(lane);
                }
            }
        }
        // Only these: a lane that is nowhere near a solution would keep all of them waiting.
        for (points, owners) in beside.chunks(S::F64_LANES).zip(owners.chunks(S::F64_LANES)) {
            let mut q = gather(simd, &points[..owners.len()]);
            let mut errors = [0.0; LANES];
            newton(simd, self.goal, &mut q).store(&mut errors, 0);
            let found = scatter(&q);
            for (lane, &owner) in owners.iter().enumerate() {
                if let Some(told) = &mut told[owner] {
                    told.add(&found[lane], errors[lane]);
                }
            }
        }
        for (told, &half) in told.iter_mut().zip(halves) {
            let least = if half > DISTINCT { 2 } else { 1 };
            told.take_if(|told| half > 0.0 && told.solutions.len() < least);
        }
    }
}

/// Asks the folds beside solutions that are open for how many roots they stand. The copies are left to [`Pool::merge`].
#[inline(always)]
pub(super) fn ask<S: Simd>(simd: S, goal: &Goal<'_>, pool: &mut Pool, sigma: &mut [f64; CAPACITY]) {
    let mut open: List<Point, CAPACITY> = List::new();
    for index in 0..pool.count {
        let point = &pool.points[index];
        let is_new = |other: &Point| distance(other, point) >= TOLERANCES.same_fold;
        if pool.is_open(sigma, index) && open.iter().all(is_new) {
            open.push(*point);
        }
    }
    if open.is_empty() {
        return;
    }
    let (hit, count) = (pool.hit, pool.count);
    for starts in open.chunks(S::F64_LANES) {
        for fold in simd.vectorize(Folds { goal, starts }).iter().flatten() {
            fold.add_to(pool);
        }
    }
    // Found are only those of which a copy was found.
    pool.hit = hit;
    siblings::measure_new(simd, goal, pool, count, sigma);
}

impl Told {
    fn add(&mut self, point: &Point, error: f64) {
        let mut others = self.solutions.iter();
        let is_new = others.all(|(other, _)| distance(other, point) >= TOLERANCES.same);
        if is_new && error <= TOLERANCES.closes_well {
            self.solutions.push((*point, error));
        }
    }

    pub(super) fn add_to(&self, pool: &mut Pool) {
        let roots = match (self.is_simple, self.solutions.len()) {
            (false, _) => 0,
            (true, 1) => 2,
            (true, _) => 1,
        };
        for (point, error) in self.solutions.iter() {
            pool.insert(point, *error, roots);
        }
    }
}

/// For each start the first one with the same top.
fn twins(told: &[Option<Told>; LANES]) -> [usize; LANES] {
    let mut twins = std::array::from_fn(|start| start);
    for (start, twin) in twins.iter_mut().enumerate() {
        let Some(own) = &told[start] else { continue };
        let is_same = |other: &Option<Told>| {
            let other = other.as_ref();
            other.is_some_and(|other| distance(&other.top, &own.top) < TOLERANCES.same_fold)
        };
        *twin = told.iter().position(is_same).unwrap_or(start);
    }
    twins
}

/// The curve close to the top of each lane's parabola.
struct Tops<S: Simd> {
    at: Angles<S>,
    curve: Curve<S>,
    /// The bend where it was seen first.
    first: Lane<S>,
    is_there: Mask<S>,
}

/// What a parabola says of its roots.
#[derive(Clone, Copy)]
enum Roots {
    /// It is none, or they are too far apart.
    Unclear,
    None,
    /// Closer than rounding tells apart they are one, at the top, where the error is this.
    One(f64),
    /// So far from the top.
    Two(f64),
}

impl<S: Simd> Tops<S> {
    /// The point of the curve at a distance from the top.
    #[inline(always)]
    fn point(&self, from_top: Lane<S>, slides: &[bool; 6]) -> Angles<S> {
        let top = -(self.curve.slope / self.curve.bend);
        self.curve.point(&self.at, top + from_top, slides)
    }

    /// What each lane's parabola says.
    #[inline(always)]
    fn roots(&self) -> [Roots; LANES] {
        let (mut value, mut slope, mut bend, mut first) =
            ([0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let nothing = self.first.constant(f64::NAN);
        self.curve.error.store(&mut value, 0);
        self.curve.slope.store(&mut slope, 0);
        self.curve.bend.store(&mut bend, 0);
        self.is_there.pick(self.first, nothing).store(&mut first, 0);
        let mut roots = [Roots::Unclear; LANES];
        for (lane, roots) in roots.iter_mut().enumerate() {
            if (bend[lane] - first[lane]).abs() < ALIKE * first[lane].abs() {
                *roots = parabola(value[lane], slope[lane], bend[lane]);
            }
        }
        roots
    }
}

/// The roots of a parabola, by its value and derivatives.
fn parabola(value: f64, slope: f64, bend: f64) -> Roots {
    let top = slope / bend;
    let square = top * top - 2.0 * value / bend;
    let vague = 2.0 * (NOISE / bend).abs();
    let is_clear = vague < VAGUE * VAGUE && square.abs() < TOLERANCES.beside * TOLERANCES.beside;
    if !is_clear {
        Roots::Unclear
    } else if square < -2.0 * (BIAS / bend).abs() {
        Roots::None
    } else if square < vague {
        Roots::One((value - 0.5 * slope * top).abs())
    } else {
        Roots::Two(square.sqrt())
    }
}
