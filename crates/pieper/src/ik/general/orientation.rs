//! Four joints that turn and two that slide: the orientation alone ties the four angles together.
//!
//! With one angle c given, the other three follow from the closed loop's rotations in two ways: for
//! `Rz(x1) A1 Rz(x2) A2 Rz(x3) = K(c)` the third column's height gives `cos(x2 - phi)`, linear in K, the sine is a root
//! of either sign, and x1 and x3 follow with the denominator `D = 1 - K33^2`. The slides drop out of the positions'
//! component along both of their directions' cross product, `E = (s1 x s2) . sum of the links' shifts`. It is linear in
//! (cos, sin) of the two outer angles, so `F(c) = D E+ E-`, the product over both ways, complex ones included, is a
//! trigonometric polynomial; its roots are the solutions, at most 8 as is known for such chains.

use nalgebra::{Complex, Matrix3, Vector3};
use pulp::{Simd, WithSimd};

use super::isolate::{CANDIDATES, Candidates, Origin, isolate};
use super::newton::{Goal, newton};
use super::polynomial::{Sampled, transform};
use super::pool::{Point, Pool, gather};
use super::random::Random;
use super::refine::polish;
use super::single::{Doubt, Target};
use super::tables::{SAMPLES, Tables};
use super::tolerances::TOLERANCES;
use crate::spatial::Pose;

type C = Complex<f64>;

/// One of the four ways, by the angle that is kept.
#[derive(Clone, Debug)]
pub(super) struct Orientation {
    /// The joints that turn, in the order of the loop, the kept one first.
    turns: [usize; 4],
    slides: [usize; 2],
    /// The links, perturbed; the last is what comes before the target's inverse.
    links: [Pose; 6],
}

/// The loop for one target.
struct Closed<'a> {
    way: &'a Orientation,
    links: [Pose; 6],
    /// From the kept joint to the next, and so on.
    between: [Matrix3<f64>; 4],
}

/// Cosine and sine of each joint, complex off the real branches; unused for slides.
type Angles = [(C, C); 6];

impl Orientation {
    /// The way that keeps joint `kept`; `None` if that one slides, or unless two do.
    pub(super) fn new(
        kept: usize,
        slides: &[bool; 6],
        links: &[Pose; 6],
        delta: f64,
        random: &mut Random,
    ) -> Option<Self> {
        let mut turning = (0..6).map(|step| (kept + step) % 6).filter(|&j| !slides[j]);
        let turns = [
            turning.next()?,
            turning.next()?,
            turning.next()?,
            turning.next()?,
        ];
        let mut sliding = (0..6).filter(|&j| slides[j]);
        let pair = [sliding.next()?, sliding.next()?];
        (turns[0] == kept).then(|| Self {
            turns,
            slides: pair,
            links: links.map(|link| link * random.motion(delta)),
        })
    }

    pub(super) fn kept(&self) -> usize {
        self.turns[0]
    }

    /// Finds roots and adds them to the pool.
    #[inline(always)]
    pub(super) fn run<S: Simd>(
        &self,
        simd: S,
        tables: &Tables,
        goal: &Goal<'_>,
        target: &Target,
        pool: &mut Pool,
    ) -> Doubt {
        let closed = self.close(target);
        let mut values = [0.0; SAMPLES];
        for (k, value) in values.iter_mut().enumerate() {
            *value = closed.value((tables.sample_cos[k], tables.sample_sin[k]));
        }
        let sampled = simd.vectorize(Transform {
            tables,
            values: &values,
        });
        let mut found = Found {
            candidates: Candidates::new(),
            cos: [0.0; CANDIDATES],
            sin: [0.0; CANDIDATES],
        };
        simd.vectorize(Isolate {
            tables,
            sampled: &sampled,
            out: &mut found,
        });
        let Found {
            candidates,
            cos,
            sin,
        } = found;
        let mut doubt = Doubt {
            near_miss: candidates.unsure,
            drowned: candidates.drowned,
            noise: sampled.noise,
            alone: None,
        };
        for k in 0..candidates.count {
            let simple = candidates.low[k] < candidates.high[k];
            let starts = closed.starts((cos[k], sin[k]));
            let good = simd.vectorize(Improve {
                goal,
                starts: &starts,
                kept: self.kept(),
                pool,
            });
            doubt.drowned |= simple && !good;
        }
        doubt
    }

    fn close(&self, target: &Target) -> Closed<'_> {
        let mut links = self.links;
        links[5] *= target.inverse;
        let between = std::array::from_fn(|k| {
            let (from, to) = (self.turns[k], self.turns[(k + 1) % 4]);
            let mut product = *links[from].rotation.matrix();
            let mut joint = (from + 1) % 6;
            while joint != to {
                product *= links[joint].rotation.matrix();
                joint = (joint + 1) % 6;
            }
            product
        });
        Closed {
            way: self,
            links,
            between,
        }
    }
}

impl Closed<'_> {
    /// All angles for the kept one, in both ways, and D.
    fn angles(&self, (cos, sin): (f64, f64)) -> ([Angles; 2], f64) {
        let [a0, a1, a2, a3] = &self.between;
        let turned = Matrix3::new(cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0);
        let k = a0.transpose() * turned * a3.transpose();
        let (g, a) = (a1.row(2).transpose(), a2.column(2).into_owned());
        let (c, s) = (g.x * a.x + g.y * a.y, g.y * a.x - g.x * a.y);
        let square = (c * c + s * s).max(f64::MIN_POSITIVE);
        let level = (k[(2, 2)] - g.z * a.z) / square;
        // cos x2 = level c - root s, sin x2 = level s + root c
        let root = C::from(1.0 / square - level * level).sqrt();
        let d = (k[(0, 2)] * k[(0, 2)] + k[(1, 2)] * k[(1, 2)]).max(f64::MIN_POSITIVE);
        let way = |root: C| {
            let second = (root * -s + level * c, root * c + level * s);
            let b = turn_z(second, &a);
            let b = [0, 1].map(|i| b[0] * a1[(i, 0)] + b[1] * a1[(i, 1)] + b[2] * a1[(i, 2)]);
            let (kx, ky) = (k[(0, 2)], k[(1, 2)]);
            let first = ((b[0] * kx + b[1] * ky) / d, (b[0] * ky - b[1] * kx) / d);
            // The row g turned back by x2, times A2.
            let m = [
                second.0 * g.x + second.1 * g.y,
                second.0 * g.y - second.1 * g.x,
                C::from(g.z),
            ];
            let m = [0, 1].map(|j| m[0] * a2[(0, j)] + m[1] * a2[(1, j)] + m[2] * a2[(2, j)]);
            let (kx, ky) = (k[(2, 0)], k[(2, 1)]);
            let third = ((m[0] * kx + m[1] * ky) / d, (m[1] * kx - m[0] * ky) / d);
            let mut all = [(C::from(1.0), C::from(0.0)); 6];
            all[self.way.turns[0]] = (C::from(cos), C::from(sin));
            all[self.way.turns[1]] = first;
            all[self.way.turns[2]] = second;
            all[self.way.turns[3]] = third;
            all
        };
        ([way(root), way(-root)], d)
    }

    /// The directions of the slides and the sum of the links' shifts, seen from the first joint.
    fn walk(&self, angles: &Angles) -> ([[C; 3]; 2], [C; 3]) {
        let (one, zero) = (C::from(1.0), C::from(0.0));
        let mut frame = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        let mut directions = [[zero; 3]; 2];
        let mut sum = [zero; 3];
        for (joint, link) in self.links.iter().enumerate() {
            let (cos, sin) = angles[joint];
            if let Some(which) = self.way.slides.iter().position(|&slide| slide == joint) {
                directions[which] = frame.map(|row| row[2]);
            } else {
                for row in &mut frame {
                    (row[0], row[1]) = (row[0] * cos + row[1] * sin, row[1] * cos - row[0] * sin);
                }
            }
            let (m, t) = (link.rotation.matrix(), &link.translation.vector);
            for (row, sum) in frame.iter_mut().zip(&mut sum) {
                *sum += row[0] * t.x + row[1] * t.y + row[2] * t.z;
                *row =
                    [0, 1, 2].map(|j| row[0] * m[(0, j)] + row[1] * m[(1, j)] + row[2] * m[(2, j)]);
            }
        }
        (directions, sum)
    }

    /// F at an angle of the kept joint.
    fn value(&self, kept: (f64, f64)) -> f64 {
        let (ways, d) = self.angles(kept);
        let [e, f] = ways.map(|angles| {
            let ([s, t], sum) = self.walk(&angles);
            sum[0] * (s[1] * t[2] - s[2] * t[1])
                + sum[1] * (s[2] * t[0] - s[0] * t[2])
                + sum[2] * (s[0] * t[1] - s[1] * t[0])
        });
        d * (e * f).re
    }

    /// Where Newton's method starts: both ways at a root, the slides by least squares.
    fn starts(&self, kept: (f64, f64)) -> [Point; 2] {
        let (ways, _) = self.angles(kept);
        ways.map(|angles| {
            let real = angles.map(|(cos, sin)| {
                let length = cos.re.hypot(sin.re).max(f64::MIN_POSITIVE);
                (C::from(cos.re / length), C::from(sin.re / length))
            });
            let (directions, sum) = self.walk(&real);
            let [s, t] = directions.map(|v| Vector3::from(v.map(|x| x.re)));
            let sum = Vector3::from(sum.map(|x| x.re));
            let (ss, st, tt) = (s.dot(&s), s.dot(&t), t.dot(&t));
            let (s_sum, t_sum) = (-s.dot(&sum), -t.dot(&sum));
            let determinant = (ss * tt - st * st).max(f64::EPSILON);
            let moved = [
                (tt * s_sum - st * t_sum) / determinant,
                (ss * t_sum - st * s_sum) / determinant,
            ];
            let mut point = [0.0; 12];
            for joint in 0..6 {
                (point[joint], point[6 + joint]) = (real[joint].0.re, real[joint].1.re);
            }
            for (slide, by) in self.way.slides.into_iter().zip(moved) {
                (point[slide], point[6 + slide]) = (1.0, by);
            }
            point
        })
    }
}

fn turn_z((cos, sin): (C, C), v: &Vector3<f64>) -> [C; 3] {
    [cos * v.x - sin * v.y, sin * v.x + cos * v.y, C::from(v.z)]
}

struct Transform<'a> {
    tables: &'a Tables,
    values: &'a [f64; SAMPLES],
}

impl WithSimd for Transform<'_> {
    type Output = Sampled;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Sampled {
        transform(simd, self.tables, self.values)
    }
}

/// Roots of F: intervals, and cosines and sines in them.
struct Found {
    candidates: Candidates,
    cos: [f64; CANDIDATES],
    sin: [f64; CANDIDATES],
}

struct Isolate<'a> {
    tables: &'a Tables,
    sampled: &'a Sampled,
    out: &'a mut Found,
}

impl WithSimd for Isolate<'_> {
    type Output = ();
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let polynomial = &self.sampled.polynomial;
        let Found {
            candidates,
            cos,
            sin,
        } = self.out;
        isolate(
            simd,
            self.tables,
            polynomial,
            self.sampled.noise,
            Origin::Perturbed,
            candidates,
        );
        for register in 0..candidates.count.div_ceil(S::F64_LANES) {
            let polished = polish(simd, self.tables, polynomial, candidates, register);
            polished.turn.cos.store(cos, register);
            polished.turn.sin.store(sin, register);
        }
    }
}

/// Newton's method from both ways at a root; whether one of them ends close by.
struct Improve<'a, 'b> {
    goal: &'a Goal<'b>,
    starts: &'a [Point; 2],
    kept: usize,
    pool: &'a mut Pool,
}

impl WithSimd for Improve<'_, '_> {
    type Output = bool;
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let mut good = false;
        // Two lanes hold both ways; a processor without any takes one after the other.
        for first in (0..2).step_by(S::F64_LANES.min(2)) {
            let mut q = gather(simd, &self.starts[first..]);
            let start = q[self.kept];
            let errors = newton(simd, self.goal, &mut q);
            let (x, y) = (q[self.kept].cos - start.cos, q[self.kept].sin - start.sin);
            let close = x
                .mul_add(x, y * y)
                .less(x.constant(TOLERANCES.moved * TOLERANCES.moved));
            let closes = errors.less(x.constant(TOLERANCES.closes));
            good |= close.and(closes).any();
            self.pool
                .add(&q, errors, S::F64_LANES.min(2), TOLERANCES.closes);
        }
        good
    }
}
