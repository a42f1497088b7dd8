//! Three neighbouring parallel axes of six, wherever they stand.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{Rotation3, Vector3};

use super::TOLERANCES;
use super::angle::{
    LinearRoots, MERGED, ONE, Roots, forth, length, solve_linear, turn_between, unit,
};
use super::arm::Arm;
use super::classify::{Class, Structure};
use super::normal::Normal;
use super::pending::Halves;
use super::planar::Triangle;
use super::polynomial::{Linear, Quadratic};
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, Elbow, Shoulder, Wrist};
use super::spherical::turn_z;
use super::wide::{self, Closed, Closing, FOUR, Sines, Turning};
use crate::spatial::Pose;

/// The loop opened behind the three parallel axes `a, b, c`, as for the spherical wrist:
///
/// `(Z_a L_a Z_b L_b Z_c)^-1 = W = K_0 Z_d K_1 Z_e K_2 Z_f K_3`
///
/// The left side keeps the direction z and the height along it, so `W z = +-z` and `W` rises by a known amount. With
/// `k0 = K_0^T z`, `k3 = K_3 z` (rotations) and the translations `t` of the links, that is
///
/// 1. `t1 . Rz(d)^-1 k0 +- (K_2^T t2) . Rz(f) k3 = const` (the rise),
/// 2. `K_1 z . Rz(d)^-1 k0 -+ K_2^T z . Rz(f) k3 = 0` (the angle that axis e cannot change),
///
/// two equations linear in cosine and sine of d and of f. Where axes d and e meet (UR: 5 and 6), a combination is
/// free of d and gives f at once; where e and f meet, one is free of f; otherwise a quartic. Then e from the direction,
/// and a triangle for a, b, c: up to eight solutions.
#[derive(Clone, Debug)]
struct ThreeParallel {
    first: usize,
    links: [Pose; 6],
    triangle: Triangle,
    size: f64,
}

/// Prepares an arm of the class.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    let Class::ThreeParallel { first } = class else {
        return None;
    };
    let links: [Pose; 6] = arm.links().try_into().ok()?;
    let normals = [0, 1].map(|ahead| Normal::of(&links[first + ahead], arm.size()));
    // A fourth axis parallel to the three would leave them without work of their own.
    let next = |index: usize| Normal::of(&links[index], arm.size()).is_parallel();
    if (first + 2 < 5 && next(first + 2)) || (first > 0 && next(first - 1)) {
        return None;
    }
    Some(Arc::new(ThreeParallel {
        first,
        triangle: Triangle::new(&normals[0], &normals[1])?,
        size: arm.size(),
        links,
    }))
}

impl Prepared for ThreeParallel {
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        // By reference, as for the spherical joint.
        let link = |index: usize| &self.links[(self.first + 2 + index) % 6];
        let closing = (9 - self.first) % 6;
        let closed = link(closing) * target.inverse();
        let at = |index: usize| {
            if index == closing {
                &closed
            } else {
                link(index)
            }
        };
        let links = [at(0), at(1), at(2), at(3)];
        let equations = Loop::new(links, &self.triangle, self.size, sink.slack());
        let mut outers = Outers::new();
        equations.solve(&mut outers, sink);
        let outers = &outers.list[..outers.len];
        let mut clear = [false; FOUR];
        if let Some(lanes) = equations.lanes(outers) {
            let closed = wide::run(&equations.closing(&lanes, self.triangle.turning()));
            // By reference: it would be copied out of the option.
            if let Some(closed) = &closed {
                clear = closed.clear;
                self.propose(outers, closed, sink);
            }
        }
        for (index, outer) in outers.iter().enumerate() {
            if !clear.get(index).is_some_and(|&clear| clear) {
                equations.close(self, outer, index, sink);
            }
        }
    }
}

/// `u . Rz(x) v` as a function of x.
pub(super) fn turned_dot(u: &Vector3<f64>, v: &Vector3<f64>) -> Linear {
    Linear {
        k: u.z * v.z,
        c: u.x * v.x + u.y * v.y,
        s: u.y * v.x - u.x * v.y,
    }
}

/// The equations of one pose.
struct Loop<'a> {
    links: [&'a Pose; 4],
    k0: Vector3<f64>,
    k3: Vector3<f64>,
    /// `K_1 z` and `K_2^T z`
    axis_e: [Vector3<f64>; 2],
    flip: f64,
    /// Equations 1 and 2 as (function of d) + (function of f) = 0.
    equations: [(Linear, Linear); 2],
    slack: f64,
    size: f64,
}

/// Values of d and f that satisfy both equations.
#[derive(Clone, Copy, Debug)]
struct Outer {
    d: (f64, f64),
    f: (f64, f64),
    signs: [bool; 2],
    multiplicity: u8,
    edge: bool,
    /// Close to another, but told from it, or one with it for certain: unless something else is singular as well.
    near: bool,
}

impl Outer {
    /// Whether it is told from others, and for how many it stands; unless something else is singular as well, if it is near.
    fn is_clear(&self) -> bool {
        self.near || self.multiplicity == 1 && !self.edge
    }
}

/// The same in lanes; those beyond the last hold copies of it.
struct Lanes {
    d: Sines,
    f: Sines,
    near: [bool; FOUR],
}

/// Two times two, or three times three starts where the arm misses its class.
const MAX_OUTERS: usize = 12;

/// All of them.
#[derive(Clone, Copy, Debug)]
struct Outers {
    list: [Outer; MAX_OUTERS],
    len: usize,
}

impl Outers {
    fn new() -> Self {
        let empty = Outer {
            d: (0.0, 1.0),
            f: (0.0, 1.0),
            signs: [true; 2],
            multiplicity: 1,
            edge: false,
            near: false,
        };
        Self {
            list: [empty; MAX_OUTERS],
            len: 0,
        }
    }

    fn push(&mut self, outer: Outer) {
        if self.len < self.list.len() {
            self.list[self.len] = outer;
            self.len += 1;
        }
    }
}

impl<'a> Loop<'a> {
    fn new(links: [&'a Pose; 4], triangle: &Triangle, size: f64, slack: f64) -> Self {
        let r = links.map(|link| link.rotation.matrix());
        let t = links.map(|link| &link.translation.vector);
        let z = Vector3::z();
        let flip = triangle.flip();
        let (k0, k3) = (r[0].transpose() * z, r[3] * z);
        let axis_e = [r[1] * z, r[2].transpose() * z];
        let rise = -flip * triangle.rise;
        // The rise counts in the arm's size: both equations are then of order one.
        let mut of_f = scaled(&turned_dot(&r[2].tr_mul(t[2]), &k3), flip / size);
        of_f.k += (t[0].z + flip * k3.dot(t[3]) - rise) / size;
        let of_d = scaled(&turned_dot(&k0, t[1]), 1.0 / size);
        let second = (
            turned_dot(&k0, &axis_e[0]),
            scaled(&turned_dot(&axis_e[1], &k3), -flip),
        );
        Self {
            links,
            k0,
            k3,
            axis_e,
            flip,
            equations: [(of_d, of_f), second],
            slack,
            size,
        }
    }

    /// Both equations solved for d and f.
    fn solve(&self, outers: &mut Outers, sink: &mut Sink<'_>) {
        let [one, two] = &self.equations;
        let (d_rows, f_rows) = ([&one.0, &two.0], [&one.1, &two.1]);
        if let Some(weights) = self.weights(d_rows) {
            let (roots, near) = self.combined(weights, f_rows, d_rows, sink);
            for (&f, first) in roots.turns[..roots.len].iter().zip([true, false, true]) {
                let (inner, middle, cosine) = self.inner_d(f, sink);
                for (root, second) in inner.iter().zip([true, false, true]) {
                    let d = forth(unit((root, cosine)), middle);
                    outers.push(Outer {
                        d,
                        f,
                        signs: [first, second],
                        ..marks((&roots, near), &inner)
                    });
                }
            }
        } else if let Some(weights) = self.weights(f_rows) {
            let (roots, near) = self.combined(weights, d_rows, f_rows, sink);
            for (&d, first) in roots.turns[..roots.len].iter().zip([true, false, true]) {
                let (inner, middle, cosine) = self.inner_f(d, sink);
                for (root, second) in inner.iter().zip([true, false, true]) {
                    let f = forth(unit((root, cosine)), middle);
                    outers.push(Outer {
                        d,
                        f,
                        signs: [first, second],
                        ..marks((&roots, near), &inner)
                    });
                }
            }
        } else {
            self.quartic(outers, sink);
        }
    }

    /// The combination of the two equations in which the angle of these rows does not occur, if there is one.
    fn weights(&self, rows: [&Linear; 2]) -> Option<[f64; 2]> {
        let [u, v] = rows.map(|row| [row.c, row.s]);
        let (lu, lv) = (length(u), length(v));
        let cross = u[0] * v[1] - u[1] * v[0];
        let tolerance = TOLERANCES.exact.max(16.0 * self.slack);
        if cross.abs() > tolerance * lu.max(lv) {
            return None;
        }
        let long = if lu > lv { u } else { v };
        let length = lu.max(lv);
        if length < TOLERANCES.free {
            return Some([1.0, 0.0]);
        }
        let along = |w: [f64; 2]| (w[0] * long[0] + w[1] * long[1]) / (length * length);
        Some([along(v), -along(u)])
    }

    /// Solves the combination for the angle of `rows`; of `others` only the constants are left. Also whether the roots are near
    /// one another, see [`Outer`].
    fn combined(
        &self,
        weights: [f64; 2],
        rows: [&Linear; 2],
        others: [&Linear; 2],
        sink: &mut Sink<'_>,
    ) -> (LinearRoots, bool) {
        let sum = |part: fn(&Linear) -> f64, rows: [&Linear; 2]| {
            weights[0] * part(rows[0]) + weights[1] * part(rows[1])
        };
        let constant = sum(|row| row.k, rows) + sum(|row| row.k, others);
        let (c, s) = (sum(|row| row.c, rows), sum(|row| row.s, rows));
        let mut roots = solve_linear(c, s, -constant, self.slack);
        sink.fail(Part::Inside, roots.excess * self.size);
        // The equations are of order one: what is as small as their rounding is none.
        let near = self.slack == 0.0 && roots.edge && roots.excess < MERGED;
        if near && roots.excess > -ONE {
            let toward = 1.0_f64.copysign(-constant);
            (roots.turns[0], roots.len) = (unit((toward * s, toward * c)), 1);
        }
        (roots, near)
    }

    /// The angle d for a given f: (roots of its sine, where it counts from, its cosine).
    fn inner_d(&self, f: (f64, f64), sink: &mut Sink<'_>) -> (Roots, (f64, f64), f64) {
        let m = self.direction_behind(f);
        let cone = Cone::new(&self.k0, &self.axis_e[0], &m, self.slack);
        if let Some(cone) = cone {
            return self.cone_roots(&cone, sink);
        }
        // Axes d and e are parallel: the rise decides.
        let (of_d, of_f) = &self.equations[0];
        self.rise_roots(of_d, of_f.at(f), sink)
    }

    /// The angle f for a given d.
    fn inner_f(&self, d: (f64, f64), sink: &mut Sink<'_>) -> (Roots, (f64, f64), f64) {
        let y = self.direction_before(d) * self.flip;
        let cone = Cone::new(&self.axis_e[1], &self.k3, &y, self.slack);
        if let Some(cone) = cone {
            return self.cone_roots(&cone, sink);
        }
        let (of_d, of_f) = &self.equations[0];
        self.rise_roots(of_f, of_d.at(d), sink)
    }

    fn cone_roots(&self, cone: &Cone, sink: &mut Sink<'_>) -> (Roots, (f64, f64), f64) {
        let sine = cone.square.sqrt();
        let roots = if self.slack == 0.0 && sine < TOLERANCES.free {
            Roots {
                values: [0.0; 3],
                len: 1,
                edge: true,
            }
        } else if self.slack == 0.0 && cone.right {
            // On both sides of an alignment joint e stands half a turn apart: they never merge.
            Roots {
                values: [sine, -sine, 0.0],
                len: 2,
                edge: false,
            }
        } else {
            Roots::of(cone.square, self.slack)
        };
        if roots.len == 0 {
            sink.fail(
                Part::Orientation,
                (2.0 * (cone.cosine.abs() - 1.0).max(0.0)).sqrt(),
            );
        }
        (roots, cone.middle, cone.cosine)
    }

    fn rise_roots(
        &self,
        row: &Linear,
        constant: f64,
        sink: &mut Sink<'_>,
    ) -> (Roots, (f64, f64), f64) {
        let length = length([row.c, row.s]);
        let cosine = -(row.k + constant) / length;
        sink.fail(Part::Inside, (cosine.abs() - 1.0) * length * self.size);
        (
            Roots::of(1.0 - cosine * cosine, self.slack),
            (row.s / length, row.c / length),
            cosine,
        )
    }

    /// `K_1^T Rz(d)^-1 K_0^T z`: the direction of the three axes, seen from axis e.
    fn direction_before(&self, (sin, cos): (f64, f64)) -> Vector3<f64> {
        let k = &self.k0;
        let back = Vector3::new(cos * k.x + sin * k.y, cos * k.y - sin * k.x, k.z);
        self.links[1].rotation.matrix().tr_mul(&back)
    }

    /// The same seen from behind axis e: `+-K_2 Rz(f) K_3 z`.
    fn direction_behind(&self, (sin, cos): (f64, f64)) -> Vector3<f64> {
        let k = &self.k3;
        let on = Vector3::new(cos * k.x - sin * k.y, sin * k.x + cos * k.y, k.z);
        self.links[2].rotation.matrix() * on * self.flip
    }

    /// No neighbouring axes meet: f from both equations, linear in its cosine and sine.
    fn quartic(&self, outers: &mut Outers, sink: &mut Sink<'_>) {
        let [one, two] = &self.equations;
        let right = |equation: &(Linear, Linear)| {
            let mut sum = scaled(&equation.0, -1.0);
            sum.k -= equation.1.k;
            sum
        };
        let (p, q) = (right(one), right(two));
        let determinant = one.1.c * two.1.s - one.1.s * two.1.c;
        let cosine = scaled(&p, two.1.s).plus(-one.1.s, &q);
        let sine = scaled(&q, one.1.c).plus(-two.1.c, &p);
        let whole = Linear {
            k: determinant,
            ..Linear::default()
        };
        let mut equation = Quadratic::default();
        equation.add(1.0, &cosine, &cosine);
        equation.add(1.0, &sine, &sine);
        equation.add(-1.0, &whole, &whole);
        let roots = equation.roots(self.slack);
        for (index, &(d, count)) in roots.as_slice().iter().enumerate() {
            let at = d.sin_cos();
            let sign = 1.0_f64.copysign(determinant);
            let f = unit((sign * sine.at(at), sign * cosine.at(at)));
            let d = at;
            let signs = [index & 2 == 0, index & 1 == 0];
            outers.push(Outer {
                d,
                f,
                signs,
                multiplicity: count,
                edge: true,
                near: false,
            });
        }
        if outers.len == 0 {
            sink.fail(Part::Inside, f64::MIN_POSITIVE);
        }
    }

    /// All d and f at once, if they are four at most and none is near another.
    fn lanes(&self, outers: &[Outer]) -> Option<Lanes> {
        let is_usual =
            self.slack == 0.0 && outers.len() <= FOUR && outers.iter().all(Outer::is_clear);
        let last = outers.last().filter(|_| is_usual)?;
        let mut lanes = Lanes {
            d: [[0.0; FOUR]; 2],
            f: [[0.0; FOUR]; 2],
            near: [false; FOUR],
        };
        for lane in 0..FOUR {
            let outer = outers.get(lane).unwrap_or(last);
            lanes.near[lane] = outer.near;
            (lanes.d[0][lane], lanes.d[1][lane]) = outer.d;
            (lanes.f[0][lane], lanes.f[1][lane]) = outer.f;
        }
        Some(lanes)
    }

    /// Joint e and the triangle for all of them.
    fn closing<'b>(&'b self, lanes: &'b Lanes, triangle: Turning<'b>) -> Closing<'b> {
        Closing {
            links: &self.links,
            axes: [self.k0, self.k3],
            flip: self.flip,
            d: &lanes.d,
            f: &lanes.f,
            near: &lanes.near,
            triangle,
        }
    }

    /// Joint e and the triangle for given d and f.
    fn close(&self, arm: &ThreeParallel, outer: &Outer, index: usize, sink: &mut Sink<'_>) {
        let (y, m) = (
            self.direction_before(outer.d),
            self.direction_behind(outer.f),
        );
        let (y, m) = ([y.x, y.y], [m.x, m.y]);
        let shortest = length(y).min(length(m));
        let free = shortest < TOLERANCES.free;
        if !free {
            // As far as rounding may have turned it, and with it moved the third corner.
            let slack = match shortest < UNSTEADY {
                true => self.slack.max(ROUNDING / shortest),
                false => self.slack,
            };
            let e = turn_between(m, y);
            self.triangle(arm, outer, index, (e, false, slack), sink);
        }
        if free {
            // Axis e is parallel to the three: it may stand anywhere within the triangle's reach.
            for e in self.within_reach(arm, outer) {
                self.triangle(arm, outer, index, (e.sin_cos(), free, self.slack), sink);
            }
        }
        // Or nearly parallel, and the arm misses its class: it may stand anywhere as a start.
        if shortest < 16.0 * self.slack {
            for k in 0..ANYWHERE {
                let e = k as f64 * TAU / ANYWHERE as f64;
                self.triangle(arm, outer, index, (e.sin_cos(), free, self.slack), sink);
            }
        }
    }

    /// Where joint e may stand, if it turns about an axis parallel to the three: the middles of both arcs in which the
    /// triangle closes, or where it comes closest to closing.
    fn within_reach(&self, arm: &ThreeParallel, outer: &Outer) -> [f64; 2] {
        // The third corner runs on a circle as e turns: the square of its distance is mean + swing cos(e - top).
        let square = |e: f64| {
            let ([x, y], _) = self.corner(outer, e.sin_cos());
            x * x + y * y
        };
        let third = TAU / 3.0;
        let [one, two, three] = [square(0.0), square(third), square(2.0 * third)];
        let mean = (one + two + three) / 3.0;
        let (cos, sin) = (one - mean, (two - three) / 3.0_f64.sqrt());
        let (swing, top) = (sin.hypot(cos), sin.atan2(cos));
        let angle = |square: f64| ((square - mean) / swing).clamp(-1.0, 1.0).acos();
        let [short, long] = arm.triangle.reach();
        let middle = match swing > 0.0 {
            true => 0.5 * (angle(short * short) + angle(long * long)),
            false => 0.0,
        };
        [top + middle, top - middle]
    }

    /// The third corner of the triangle as seen from the first axis, and the direction behind it.
    fn corner(&self, outer: &Outer, e: (f64, f64)) -> ([f64; 2], [f64; 2]) {
        let mut whole = *self.links[0];
        for (turn, link) in [outer.d, e, outer.f]
            .iter()
            .zip(self.links[1..].iter().copied())
        {
            let mut rotation = whole.rotation.into_inner();
            turn_z(&mut rotation, *turn);
            let shift = rotation * link.translation.vector;
            whole.translation.vector += shift;
            whole.rotation = Rotation3::from_matrix_unchecked(rotation * link.rotation.matrix());
        }
        let motion = whole.inverse();
        let at = [motion.translation.vector.x, motion.translation.vector.y];
        let m = motion.rotation.matrix();
        (at, [m[(0, 0)], m[(1, 0)]])
    }

    fn triangle(
        &self,
        arm: &ThreeParallel,
        outer: &Outer,
        index: usize,
        (e, free, slack): ((f64, f64), bool, f64),
        sink: &mut Sink<'_>,
    ) {
        let (at, toward) = self.corner(outer, e);
        let bends = arm.triangle.solve(at, toward, slack);
        if let Some(shortfall) = bends.shortfall.filter(|_| !free) {
            sink.fail(shortfall.part, shortfall.amount);
        }
        for bent in &bends.list[..bends.len] {
            let mut all = [(0.0, 1.0); 6];
            let [a, b, c] = bent.turns;
            let turns = [a, b, c, outer.d, e, outer.f];
            for (k, turn) in turns.iter().enumerate() {
                all[(arm.first + k) % 6] = *turn;
            }
            let marks = Marks {
                multiplicity: outer.multiplicity * bent.multiplicity,
                edge: outer.edge || bent.edge,
                free: free || bent.free,
            };
            sink.push_turns(&all, arm.branch(outer, index, bent.bend), marks);
        }
    }
}

/// A direction that is shorter is known so badly that a triangle may seem not to close which does.
const UNSTEADY: f64 = 1e-5;
/// Of such a direction.
const ROUNDING: f64 = 1e-15;

/// Starts for a joint that may stand nearly anywhere.
const ANYWHERE: usize = 16;

fn marks((outer, near): (&LinearRoots, bool), inner: &Roots) -> Outer {
    let merged = usize::from(outer.len == 1) + usize::from(inner.len == 1);
    Outer {
        d: (0.0, 1.0),
        f: (0.0, 1.0),
        signs: [true; 2],
        multiplicity: 1 << merged,
        edge: outer.edge || inner.edge,
        near: near && !inner.edge,
    }
}

/// The angles x with `u . Rz(x) v = w_z`, for unit vectors of which `w` is known whole: its plane part gives the
/// sine without cancellation where the cosine is close to one.
struct Cone {
    middle: (f64, f64),
    cosine: f64,
    square: f64,
    /// Both axes at right angles to the one between them: the roots are those of a sum of squares.
    right: bool,
}

impl Cone {
    /// None if there is no cone: an axis parallel to the next, as closely as the arm misses its class.
    fn new(u: &Vector3<f64>, v: &Vector3<f64>, w: &Vector3<f64>, slack: f64) -> Option<Self> {
        let row = turned_dot(u, v);
        let length = length([row.c, row.s]);
        let least = match slack > 0.0 {
            true => TOLERANCES.class,
            false => TOLERANCES.merely,
        };
        if length < least {
            return None;
        }
        let flat = w.x * w.x + w.y * w.y;
        let square = flat - u.z * u.z - v.z * v.z + 2.0 * u.z * v.z * w.z;
        Some(Self {
            middle: (row.s / length, row.c / length),
            cosine: (w.z - row.k) / length,
            square: square / (length * length),
            right: u.z == 0.0 && v.z == 0.0,
        })
    }
}

impl ThreeParallel {
    /// Both ways to close the triangle, of the branches that are there.
    #[inline]
    fn propose(&self, outers: &[Outer], closed: &Closed, sink: &mut Sink<'_>) {
        let mut names = [(Branch::NONE, Marks::PLAIN); 2 * FOUR];
        let mut there = [false; 2 * FOUR];
        for (index, outer) in outers.iter().enumerate() {
            let ways = u8::from(!closed.there[1][index]);
            for (half, bend) in [true, false].into_iter().enumerate() {
                let at = index + FOUR * half;
                there[at] = closed.clear[index] && closed.there[half][index];
                names[at].0 = self.branch(outer, index, bend);
                names[at].1.multiplicity = outer.multiplicity << ways;
            }
        }
        let turn = |joint: usize| &closed.turns[(joint + 6 - self.first) % 6];
        sink.push_halves(&Halves {
            turns: std::array::from_fn(turn),
            there,
            names,
        });
    }

    fn branch(&self, outer: &Outer, index: usize, bend: bool) -> Branch {
        let [first, second] = outer.signs;
        if self.first != 1 {
            return Branch {
                elbow: Some(if bend { Elbow::Down } else { Elbow::Up }),
                root: index as u8 + 1,
                ..Branch::default()
            };
        }
        Branch {
            shoulder: Some(if first {
                Shoulder::Left
            } else {
                Shoulder::Right
            }),
            elbow: Some(if bend == first {
                Elbow::Down
            } else {
                Elbow::Up
            }),
            wrist: Some(if second { Wrist::NoFlip } else { Wrist::Flip }),
            root: 0,
        }
    }
}

fn scaled(linear: &Linear, by: f64) -> Linear {
    Linear {
        k: linear.k * by,
        c: linear.c * by,
        s: linear.s * by,
    }
}
