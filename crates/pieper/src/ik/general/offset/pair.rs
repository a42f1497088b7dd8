//! Two roots of the equation that are nearly one: from the top of their parabola to all joint angles that may be solutions there,
//! around which the arm itself tells them apart (`fold`).

use pulp::{Simd, WithSimd};

use super::equation::Values;
use super::finish::Finish;
use crate::ik::angle::wrap;
use crate::ik::general::fold::Folds;
use crate::ik::general::list::List;
use crate::ik::general::newton::{error, newton};
use crate::ik::general::pool::{Point, Pool, distance, gather, scatter};
use crate::ik::general::tolerances::TOLERANCES;
use crate::ik::lanes::{Lane, Turn};

/// All solutions that a pair of roots leads to.
pub(super) struct Pair<'a> {
    pub(super) finish: &'a Finish<'a>,
    /// The unknown at the top.
    pub(super) top: f64,
    /// Solutions whose unknown is farther away belong to others.
    pub(super) within: f64,
    pub(super) pool: &'a mut Pool,
}

/// Ways from an angle to joint angles: two x', for each two turns of link 3 by either line. Where both lines meet is among them,
/// and at a double root one of the two may say nothing.
const WAYS: usize = 8;

/// A start whose error is larger is none.
const START: f64 = 0.1;
/// Of a start that is as good as a solution.
const CLOSE: f64 = 1e-4;

impl WithSimd for Pair<'_> {
    /// Whether that is all: a fold, or two solutions that share the angle; for an arm with solutions on both sides of axis 1
    /// twice as many; or that there are none.
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) -> bool {
        let finish = self.finish;
        let angle = self.angle(simd);
        let at = finish.equation.at(angle);
        if at.is_far_from_real().any() {
            // Where the point is closer to axis 1 than the arm's shoulder is, a root belongs to no real solution.
            return true;
        }
        let wanted = 1 << u32::from(finish.offset.symmetric);
        let starts = self.starts(simd, angle, &at);
        let mut tried: List<Point, WAYS> = List::new();
        let mut close = 0;
        for start in &starts {
            if start.error < START {
                push_new(&mut tried, &start.point);
            }
            if start.error < CLOSE {
                close = tried.len();
            }
        }
        let mut tops = List::new();
        for starts in tried[..close].chunks(S::F64_LANES) {
            self.tell(simd, starts, &mut tops);
        }
        if tops.len() == wanted {
            return true;
        }
        let found = self.follow(simd, &tried);
        found.add_to(self.pool);
        self.sharing(&found) == 2 * wanted
    }
}

/// Joint angles, and the error of their pose.
#[derive(Clone, Copy)]
struct Start {
    point: Point,
    error: f64,
}

impl Pair<'_> {
    /// Adds what the folds beside the starts tell, if they are the pair's and new.
    #[inline(always)]
    fn tell<S: Simd>(&mut self, simd: S, starts: &[Point], tops: &mut List<Point, WAYS>) {
        let goal = self.finish.goal;
        for fold in simd.vectorize(Folds { goal, starts }).iter().flatten() {
            if self.is_at(&fold.top) && push_new(tops, &fold.top) {
                fold.add_to(self.pool);
            }
        }
    }

    /// Whether the unknown is that of the pair.
    fn is_at(&self, point: &Point) -> bool {
        wrap(self.finish.offset.kept(point) - self.top).abs() < self.within
    }

    /// How many of the solutions have the unknown of the pair.
    fn sharing(&self, found: &Pool) -> usize {
        let points = &found.points[..found.count];
        points.iter().filter(|point| self.is_at(point)).count()
    }

    /// Solutions from all starts, each by itself.
    #[inline(always)]
    fn follow<S: Simd>(&self, simd: S, starts: &[Point]) -> Pool {
        let mut found = Pool::new();
        for points in starts.chunks(S::F64_LANES) {
            let mut q = gather(simd, points);
            let errors = newton(simd, self.finish.goal, &mut q);
            found.add(&q, errors, points.len(), TOLERANCES.closes_well);
        }
        found
    }

    #[inline(always)]
    fn angle<S: Simd>(&self, simd: S) -> Turn<S> {
        let (sin, cos) = self.top.sin_cos();
        Turn {
            cos: Lane::splat(simd, cos),
            sin: Lane::splat(simd, sin),
        }
    }

    /// Where solutions may be, the closest first.
    #[inline(always)]
    fn starts<S: Simd>(&self, simd: S, angle: Turn<S>, at: &Values<S>) -> [Start; WAYS] {
        let positive = at.distance();
        let (mut xs, mut turn_cos, mut turn_sin) = ([0.0; WAYS], [0.0; WAYS], [0.0; WAYS]);
        for (side, x) in [positive, -positive].into_iter().enumerate() {
            for (k, turn) in at.turns(x).into_iter().enumerate() {
                let way = 4 * side + k;
                xs[way] = x.largest();
                (turn_cos[way], turn_sin[way]) = (turn.cos.largest(), turn.sin.largest());
            }
        }
        let mut out = [Start {
            point: [0.0; 12],
            error: f64::INFINITY,
        }; WAYS];
        for register in 0..WAYS / S::F64_LANES {
            let both = Turn {
                cos: Lane::load(simd, &turn_cos, register),
                sin: Lane::load(simd, &turn_sin, register),
            };
            let branch = at.branch(Lane::load(simd, &xs, register), both);
            let q = self.finish.joints(simd, angle, &branch);
            let mut sizes = [0.0; 8];
            error(simd, self.finish.goal, &q).store(&mut sizes, 0);
            let points = scatter(&q);
            for lane in 0..S::F64_LANES {
                out[register * S::F64_LANES + lane] = Start {
                    point: points[lane],
                    error: sizes[lane],
                };
            }
        }
        out.sort_unstable_by(|a, b| a.error.total_cmp(&b.error));
        out
    }
}

/// Adds a point; false if it is there.
fn push_new(points: &mut List<Point, WAYS>, point: &Point) -> bool {
    let is_new = points
        .iter()
        .all(|other| distance(other, point) >= TOLERANCES.same_fold);
    if is_new {
        points.push(*point);
    }
    is_new
}
