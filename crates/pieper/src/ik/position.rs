//! Three joints that turn bring a point to a place: Pieper's equations (Pieper 1968).

use super::angle::{
    MERGED, ONE, Roots, STEADY, back, length, solve_linear, turn_between, turned, unit,
};
use super::normal::Normal;
use super::polynomial::{Linear, Quadratic};
use super::reason::Part;
use super::wide::{self, FOUR, Folded, Folding, Sines};
use super::{Shortfall, TOLERANCES};
use crate::spatial::sin_cos_exact;

/// `Z_1 L_1 Z_2 L_2 Z_3 p = P` for given links, as `Tz(d1) Tx(a1) Rx(alpha1)` and `Tz(d2) Tx(a2) Rx(alpha2)` between
/// suitably counted angles.
///
/// Seen from joint 1, the height and the distance of `Z_2 L_2 Z_3 p` are given; both are linear in cosine and sine of
/// joint 3, and the plane of joint 2 closes the system. Up to four solutions:
///
/// - axes 2 and 3 parallel: front or back from the distance to axis 1, then the elbow's triangle;
/// - axes 1 and 2 parallel: the same, seen from the other end;
/// - axes 1 and 2 meet: joint 3 from the distance to the crossing, then front or back;
/// - axes 2 and 3 meet: the same, from the other end;
/// - otherwise a quartic in the half tangent of joint 3.
#[derive(Clone, Copy, Debug)]
pub(super) struct Three {
    kind: Kind,
    /// The links as used: those of the other end, reversed, if `reversed`.
    links: Links,
    reversed: bool,
    /// Counted from the given frames: angle shifts of the three joints, and the origins of `P` and `p` along axes 1, 3.
    shifts: [(f64, f64); 3],
    ends: [f64; 2],
    end_turn: (f64, f64),
    miss: f64,
    /// The first sign says back where the arm reaches forward: joint 2's axis is counted the other way round.
    backward: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Parallel,
    Meeting,
    Skew,
}

#[derive(Clone, Copy, Debug)]
struct Links {
    a1: f64,
    alpha1: (f64, f64),
    d2: f64,
    a2: f64,
    alpha2: (f64, f64),
}

impl Links {
    fn reversed(&self) -> Self {
        let negated = |(sin, cos): (f64, f64)| (-sin, cos);
        Self {
            a1: -self.a2,
            alpha1: negated(self.alpha2),
            d2: -self.d2,
            a2: -self.a1,
            alpha2: negated(self.alpha1),
        }
    }
}

/// One way to bring the point there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    /// Sine and cosine of a joint that turns; value and 0 of one that slides.
    pub(super) turns: [(f64, f64); 3],
    /// The sign of the first choice (front), and of the second (elbow).
    pub(super) signs: [bool; 2],
    /// How many roots it stands for.
    pub(super) multiplicity: u8,
    pub(super) edge: bool,
    /// An angle is undetermined.
    pub(super) free: bool,
}

impl Reach {
    /// Whether it stands for one root, away from others, and determines every angle.
    #[inline]
    pub(super) fn is_plain(&self) -> bool {
        self.multiplicity == 1 && !self.edge && !self.free
    }

    #[inline]
    pub(super) fn simple(signs: [bool; 2], multiplicity: u8) -> Self {
        Self {
            turns: [(0.0, 1.0); 3],
            signs,
            multiplicity,
            edge: false,
            free: false,
        }
    }
}

/// Ways in lanes: bent one way and the other reaching forward, then reaching back.
pub(super) struct Four {
    pub(super) turns: [Sines; 3],
    /// Which there are, and for how many roots they stand.
    pub(super) there: [bool; FOUR],
    pub(super) multiplicity: [u8; FOUR],
    /// Which are certain only if nothing else is singular.
    pub(super) near: [bool; FOUR],
    /// Of which of the two directions, forward and back, everything is known.
    pub(super) clear: [bool; 2],
    /// As of a [`Reach`].
    pub(super) signs: [[bool; 2]; FOUR],
}

impl Four {
    /// Of a list in which each stands for one root, away from others; the lanes beyond hold copies of the last.
    pub(super) fn gather(reaches: &[Reach]) -> Option<Self> {
        let last = reaches.last()?;
        if reaches.len() > FOUR || !reaches.iter().all(Reach::is_plain) {
            return None;
        }
        let mut four = Self {
            turns: [[[0.0; FOUR]; 2]; 3],
            there: [false; FOUR],
            multiplicity: [1; FOUR],
            near: [false; FOUR],
            clear: [true; 2],
            signs: [[true; 2]; FOUR],
        };
        for lane in 0..FOUR {
            let reach = reaches.get(lane).unwrap_or(last);
            four.there[lane] = lane < reaches.len();
            four.signs[lane] = reach.signs;
            for (turn, (sin, cos)) in four.turns.iter_mut().zip(reach.turns) {
                (turn[0][lane], turn[1][lane]) = (sin, cos);
            }
        }
        Some(four)
    }
}

/// At most four ways, or eight starts for each of two of them.
const MAX_REACHES: usize = 16;

/// All ways.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reaches {
    list: [Reach; MAX_REACHES],
    len: usize,
    /// The smallest failure met.
    pub(super) shortfall: Option<Shortfall>,
}

impl Reaches {
    #[inline]
    pub(super) fn new() -> Self {
        Self {
            list: [Reach::simple([true; 2], 1); MAX_REACHES],
            len: 0,
            shortfall: None,
        }
    }

    #[inline]
    pub(super) fn push(&mut self, reach: Reach) {
        if self.len < self.list.len() {
            self.list[self.len] = reach;
            self.len += 1;
        }
    }

    /// The last few.
    pub(super) fn last_mut(&mut self, count: usize) -> Option<&mut [Reach]> {
        let from = self.len.checked_sub(count)?;
        self.list.get_mut(from..self.len)
    }

    pub(super) fn fail(&mut self, part: Part, amount: f64) {
        if amount > 0.0 && self.shortfall.is_none_or(|least| amount < least.amount) {
            self.shortfall = Some(Shortfall { part, amount });
        }
    }

    #[inline]
    pub(super) fn as_slice(&self) -> &[Reach] {
        &self.list[..self.len]
    }
}

impl Three {
    /// Prepares two links; `None` if three joints about such axes cannot bring a point anywhere in space.
    pub(super) fn new(first: &Normal, second: &Normal) -> Option<Self> {
        let links = Links {
            a1: first.a,
            alpha1: first.alpha,
            d2: first.e + second.d,
            a2: second.a,
            alpha2: second.alpha,
        };
        let (kind, reversed) = match (first, second) {
            (first, second) if first.is_parallel() && second.is_parallel() => return None,
            // Three axes through one point.
            (first, second) if first.meets() && second.meets() && links.d2 == 0.0 => return None,
            (_, second) if second.is_parallel() && !second.meets() => (Kind::Parallel, false),
            (first, _) if first.is_parallel() && !first.meets() => (Kind::Parallel, true),
            // Two axes coincide: two joints do the work of one.
            (first, second) if first.is_parallel() || second.is_parallel() => return None,
            (first, _) if first.meets() => (Kind::Meeting, false),
            (_, second) if second.meets() => (Kind::Meeting, true),
            _ => (Kind::Skew, false),
        };
        Some(Self {
            kind,
            links: if reversed { links.reversed() } else { links },
            reversed,
            shifts: [first.phi, first.psi + second.phi, 0.0].map(sin_cos_exact),
            ends: [first.d, second.e],
            end_turn: sin_cos_exact(second.psi),
            miss: first.miss.max(second.miss),
            // Forward is where the shoulder is set off to; without an offset, the description's own x.
            backward: first.a < 0.0 || first.a == 0.0 && first.phi.cos() < 0.0,
        })
    }

    /// How far the links miss what they are taken for.
    pub(super) fn miss(&self) -> f64 {
        self.miss
    }

    /// Whether the signs of an answer mean front or back and elbow up or down.
    pub(super) fn has_names(&self) -> bool {
        self.kind == Kind::Parallel && !self.reversed
    }

    /// Whether an answer with the first sign `front` reaches forward.
    pub(super) fn reaches_forward(&self, front: bool) -> bool {
        front != self.backward
    }

    /// Which elbow sign is up when the arm reaches forward.
    pub(super) fn up_sign(&self) -> bool {
        // The forward arm turns joint 2 about x cross forward; sin alpha1 says which way that axis points.
        (self.links.alpha1.0 > 0.0) == (self.links.a2 * self.links.alpha2.1 < 0.0)
    }

    /// The problem as its kind is solved, and the turn by which joint 3 is counted off.
    #[inline]
    fn problem(&self, place: [f64; 3], point: [f64; 3], slack: f64) -> (Problem, (f64, f64)) {
        let place = [place[0], place[1], place[2] - self.ends[0]];
        let spun = turned([point[0], point[1]], self.end_turn);
        let point = [spun[0], spun[1], point[2] + self.ends[1]];
        let (place, point) = if self.reversed {
            (point, place)
        } else {
            (place, point)
        };
        let radius = length([point[0], point[1]]);
        let turn = if radius > 0.0 {
            (point[1] / radius, point[0] / radius)
        } else {
            (0.0, 1.0)
        };
        let problem = Problem {
            links: self.links,
            place,
            radius,
            height: point[2],
            slack,
        };
        (problem, turn)
    }

    /// The usual case in lanes, axes 2 and 3 parallel: the ways of those directions, forward and back, that are away from
    /// singularities.
    #[inline]
    pub(super) fn four(&self, place: [f64; 3], point: [f64; 3], slack: f64) -> Option<Four> {
        if self.kind != Kind::Parallel || self.reversed || slack > 0.0 {
            return None;
        }
        let (problem, turn) = self.problem(place, point, slack);
        problem.folded([self.shifts[0], self.shifts[1], turn])
    }

    /// All joint angles that bring `point` (seen behind joint 3) to `place` (seen before joint 1), but for the directions,
    /// forward and back, that are done.
    #[inline]
    pub(super) fn solve(
        &self,
        place: [f64; 3],
        point: [f64; 3],
        slack: f64,
        done: [bool; 2],
        out: &mut Reaches,
    ) {
        let (problem, turn) = self.problem(place, point, slack);
        let before = out.len;
        match self.kind {
            Kind::Parallel => problem.parallel(done, out),
            Kind::Meeting => problem.meeting(out),
            Kind::Skew => problem.skew(out),
        }
        for reach in &mut out.list[before..out.len] {
            reach.turns[2] = back(reach.turns[2], turn);
            if self.reversed {
                let [x, y, z] = reach.turns;
                reach.turns = [z, y, x].map(|(sin, cos)| (-sin, cos));
            }
            for (turn, shift) in reach.turns.iter_mut().zip(self.shifts) {
                *turn = back(*turn, shift);
            }
        }
    }
}

/// The problem with the point at `(radius, 0, height)` behind joint 3 and `d1 = 0`.
struct Problem {
    links: Links,
    place: [f64; 3],
    radius: f64,
    height: f64,
    slack: f64,
}

/// What is known of the point where axes 2 and 3 are parallel.
struct Upright {
    /// Along axis 2.
    height: f64,
    /// Up the plane of joint 2, as seen from it.
    v: f64,
    /// Across that plane, seen from axis 1.
    side: f64,
    /// From axis 1, and a length that stands for the problem's.
    distance: f64,
    scale: f64,
    /// Forward or back along the plane, in that length.
    forward: Roots,
}

/// A vector that should give an angle.
struct Bearing {
    turn: (f64, f64),
    free: bool,
}

impl Problem {
    /// A length that stands for the problem's.
    fn scale(&self) -> f64 {
        let l = &self.links;
        l.a1.abs() + l.d2.abs() + l.a2.abs() + self.radius + self.height.abs()
    }

    fn bearing(&self, from: [f64; 2], to: [f64; 2], scale: f64) -> Bearing {
        let short = |v: [f64; 2]| v[0].abs().max(v[1].abs()) < TOLERANCES.free * scale;
        if short(from) || short(to) {
            return Bearing {
                turn: (0.0, 1.0),
                free: true,
            };
        }
        Bearing {
            turn: turn_between(from, to),
            free: false,
        }
    }

    /// Joints 1 and 2 from `Y = L_2 Z_3 p` and `X = Z_2 Y`, its plane part given.
    fn finish(
        &self,
        y: [f64; 2],
        x: [f64; 2],
        height: f64,
        third: (f64, f64),
        mut reach: Reach,
        out: &mut Reaches,
    ) {
        let Links {
            a1,
            alpha1: (s1, c1),
            ..
        } = self.links;
        let scale = self.scale();
        let second = self.bearing(y, x, scale);
        let around = [a1 + x[0], c1 * x[1] - s1 * height];
        let first = self.bearing(around, [self.place[0], self.place[1]], scale);
        reach.turns = [first.turn, second.turn, third];
        reach.free |= first.free || second.free;
        out.push(reach);
    }

    /// Where axes 2 and 3 are parallel: the point before joint 2 but for its distance from axis 1.
    #[inline]
    fn upright(&self) -> Upright {
        let Links {
            alpha1: (s1, c1),
            d2,
            alpha2: (_, flip),
            ..
        } = self.links;
        let [px, py, pz] = self.place;
        let height = d2 + flip * self.height;
        let v = (pz - c1 * height) / s1;
        let side = c1 * v - s1 * height;
        let distance = length([px, py]);
        let scale = self.scale();
        let square = (distance - side.abs()) * (distance + side.abs()) / (scale * scale);
        Upright {
            height,
            v,
            side,
            distance,
            scale,
            forward: Roots::of(square, self.slack),
        }
    }

    /// All ways at once where axes 2 and 3 are parallel, unless reaching forward and back are nearly one; the angles less
    /// `zeros`.
    #[inline]
    fn folded(&self, zeros: [(f64, f64); 3]) -> Option<Four> {
        let Links {
            a1,
            a2,
            alpha2: (_, flip),
            ..
        } = self.links;
        let Upright {
            v,
            side,
            distance,
            scale,
            forward,
            ..
        } = self.upright();
        // Front and back are half a turn apart where axis 1 meets the plane of the elbow: they never merge.
        let apart = side.abs() <= TOLERANCES.free * scale;
        let near = forward.edge && !apart;
        let beside = (distance - side.abs()) / scale;
        if forward.edge && (beside.is_nan() || beside < -MERGED) {
            return None;
        }
        let merged = near && beside <= ONE;
        let forward = match merged {
            true => [0.0; 2],
            false => [forward.values[0] * scale, forward.values[1] * scale],
        };
        let steady = apart || forward[0] > STEADY * scale;
        let folded = wide::run(&Folding {
            near,
            steady,
            u: forward.map(|forward| forward - a1),
            v,
            a1,
            side,
            lengths: [a2, self.radius],
            flip,
            place: [self.place[0], self.place[1]],
            scale,
            zeros,
        })?;
        let Folded {
            turns,
            mut there,
            near,
            clear,
        } = folded;
        let mut multiplicity = [1; FOUR];
        if near.contains(&true) {
            for k in 0..FOUR {
                multiplicity[k] = if there[k ^ 1] { 1 } else { 2 } << u8::from(merged);
            }
        }
        for k in 0..FOUR {
            there[k] &= clear[k / 2] && !(merged && k >= 2);
        }
        Some(Four {
            turns,
            there,
            multiplicity,
            near,
            clear,
            signs: [[true, true], [true, false], [false, true], [false, false]],
        })
    }

    /// Axes 2 and 3 parallel.
    #[inline]
    fn parallel(&self, done: [bool; 2], out: &mut Reaches) {
        let Links {
            a1,
            a2,
            alpha2: (_, flip),
            ..
        } = self.links;
        let Upright {
            height,
            v,
            side,
            distance,
            scale,
            forward,
        } = self.upright();
        out.fail(Part::WristInside, side.abs() - distance);
        let (long, short) = (a2.abs() + self.radius, (a2.abs() - self.radius).abs());
        let product = 2.0 * a2 * self.radius;
        for ((root, front), index) in forward.iter().zip([true, false, true]).zip(0..) {
            if index < 2 && done[index] {
                continue;
            }
            let u = root * scale - a1;
            let reach = length([u, v]);
            out.fail(Part::WristBeyond, reach - long);
            out.fail(Part::WristTooNear, short - reach);
            if self.radius < TOLERANCES.free * scale {
                // The point lies on axis 3: joint 3 does not move it.
                if (reach - long).abs() < TOLERANCES.closes * scale {
                    let reach = Reach {
                        free: true,
                        ..Reach::simple([front, true], 1 << usize::from(forward.len == 1))
                    };
                    self.finish([a2, 0.0], [u, v], height, (0.0, 1.0), reach, out);
                }
                continue;
            }
            // Sine of the elbow without cancellation: Heron's formula.
            let square = (long - reach) * (long + reach) * (reach - short) * (reach + short)
                / (product * product);
            let cosine = (u * u + v * v - a2 * a2 - self.radius * self.radius) / product;
            let bends = Roots::of(square, self.slack);
            for (bend, sign) in bends.iter().zip([true, false, true]) {
                // At the boundary the cosine may exceed 1 by rounding; the angle does not mind.
                let (sin, cos) = unit((bend, cosine));
                let y = [a2 + self.radius * cos, flip * self.radius * sin];
                let merged = usize::from(forward.len == 1) + usize::from(bends.len == 1);
                let reach = Reach {
                    edge: forward.edge || bends.edge,
                    ..Reach::simple([front, sign], 1 << merged)
                };
                self.finish(y, [u, v], height, (sin, cos), reach, out);
            }
        }
    }

    /// `Y = L_2 Z_3 p` as functions of joint 3.
    fn forearm(&self) -> [Linear; 3] {
        let Links {
            d2,
            a2,
            alpha2: (s2, c2),
            ..
        } = self.links;
        let (r, h) = (self.radius, self.height);
        [
            Linear {
                k: a2,
                c: r,
                s: 0.0,
            },
            Linear {
                k: -s2 * h,
                c: 0.0,
                s: c2 * r,
            },
            Linear {
                k: d2 + c2 * h,
                c: 0.0,
                s: s2 * r,
            },
        ]
    }

    /// `|Y|^2` as a function of joint 3.
    fn squared_reach(&self) -> Linear {
        let Links {
            d2,
            a2,
            alpha2: (s2, c2),
            ..
        } = self.links;
        let (r, h) = (self.radius, self.height);
        Linear {
            k: a2 * a2 + r * r + h * h + d2 * d2 + 2.0 * d2 * c2 * h,
            c: 2.0 * a2 * r,
            s: 2.0 * d2 * s2 * r,
        }
    }

    /// Axes 1 and 2 meet.
    fn meeting(&self, out: &mut Reaches) {
        let (s1, c1) = self.links.alpha1;
        let [px, py, pz] = self.place;
        let square = self.squared_reach();
        let wanted = px * px + py * py + pz * pz;
        let mut third = solve_linear(square.c, square.s, wanted - square.k, self.slack);
        let area = self.scale() * self.scale();
        let idle = third.length < TOLERANCES.free * area;
        if idle && (wanted - square.k).abs() < TOLERANCES.closes * area {
            // Joint 3 does not change the distance: the point lies on its axis.
            (third.turns[0], third.len) = ((0.0, 1.0), 1);
        }
        let distance = wanted.sqrt();
        out.fail(
            Part::WristBeyond,
            distance - (square.k + third.length).max(0.0).sqrt(),
        );
        out.fail(
            Part::WristTooNear,
            (square.k - third.length).max(0.0).sqrt() - distance,
        );
        let y = self.forearm();
        for (&at, sign) in third.turns[..third.len].iter().zip([true, false, true]) {
            let y = [y[0].at(at), y[1].at(at), y[2].at(at)];
            let v = (pz - c1 * y[2]) / s1;
            let across = y[0].hypot(y[1]);
            let scale = self.scale();
            let roots = Roots::of(
                (across - v.abs()) * (across + v.abs()) / (scale * scale),
                self.slack,
            );
            out.fail(Part::WristInside, v.abs() - across);
            for (root, front) in roots.iter().zip([true, false, true]) {
                let merged = usize::from(roots.len == 1) + usize::from(third.len == 1);
                let reach = Reach {
                    edge: roots.edge || third.edge,
                    free: idle,
                    ..Reach::simple([front, sign], 1 << merged)
                };
                self.finish([y[0], y[1]], [root * scale, v], y[2], at, reach, out);
            }
        }
    }

    /// Axes 1, 2 and 3 skew: `U^2 + V^2 = Yx^2 + Yy^2`, a quartic.
    fn skew(&self, out: &mut Reaches) {
        let Links {
            a1,
            alpha1: (s1, c1),
            ..
        } = self.links;
        let [px, py, pz] = self.place;
        let y = self.forearm();
        let square = self.squared_reach();
        let far = Linear {
            k: px * px + py * py + pz * pz - a1 * a1,
            ..Linear::default()
        }
        .plus(-1.0, &square);
        let high = Linear {
            k: pz,
            ..Linear::default()
        }
        .plus(-c1, &y[2]);
        let scale = self.scale();
        let unit = 1.0 / (scale * scale);
        let mut equation = Quadratic::default();
        equation.add(s1 * s1 * unit * unit, &far, &far);
        equation.add(4.0 * a1 * a1 * unit * unit, &high, &high);
        for side in &y[..2] {
            equation.add(-4.0 * a1 * a1 * s1 * s1 * unit * unit, side, side);
        }
        let roots = equation.roots(self.slack);
        if roots.as_slice().is_empty() {
            out.fail(Part::WristBeyond, self.distance_outside(&square));
        }
        for (index, &(theta3, count)) in roots.as_slice().iter().enumerate() {
            let at = theta3.sin_cos();
            let x = [far.at(at) / (2.0 * a1), high.at(at) / s1];
            let reach = Reach {
                edge: true,
                ..Reach::simple([index & 2 == 0, index & 1 == 0], count)
            };
            self.finish([y[0].at(at), y[1].at(at)], x, y[2].at(at), at, reach, out);
        }
    }

    /// A lower bound of how far the place lies outside the reach of three skew joints; a tiny positive number where
    /// the bound says nothing.
    fn distance_outside(&self, square: &Linear) -> f64 {
        let [px, py, pz] = self.place;
        let distance = (px * px + py * py + pz * pz).sqrt();
        let swing = square.c.hypot(square.s);
        let far = (square.k + swing).max(0.0).sqrt() + self.links.a1.abs();
        let near = (square.k - swing).max(0.0).sqrt() - self.links.a1.abs();
        (distance - far).max(near - distance).max(f64::MIN_POSITIVE)
    }
}
