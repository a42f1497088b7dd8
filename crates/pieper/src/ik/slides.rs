//! Three joints of which some slide bring a point to a place: the position problem of Stanford arms and gantries.

use nalgebra::{Matrix3, Vector3};

use super::TOLERANCES;
use super::angle::{between, solve_linear};
use super::normal::Normal;
use super::polynomial::{Linear, Quadratic, Quartic, add_product, real_roots};
use super::position::{Reach, Reaches};
use super::reason::Part;
use crate::spatial::{Pose, shift};

/// `M_1 L_1 M_2 L_2 M_3 p = P`, each `M` a turn about z or a slide along it, at least one of them a slide.
///
/// As for three turns, what joint 1 cannot change gives two equations (height and distance if it turns, x and y if it
/// slides), and `Y = L_2 M_3 p` is linear in what joint 3 does:
///
/// - turn turn slide: a quartic in the slide, quadratic where axes 1 and 2 meet or are parallel;
/// - turn slide turn: a quartic in the half tangent of joint 3, quadratic where joint 2 slides at a right angle to axis 1;
/// - slide turn slide: a quadratic;
/// - slide slide turn: linear in cosine and sine of joint 3;
/// - slide slide slide: linear;
/// - the others are these from the other end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Three {
    turns: [bool; 3],
    first: Pose,
    second: Pose,
    reversed: bool,
}

impl Three {
    /// Prepares two links; `None` for three joints that turn, and for slides that do not span space.
    pub(super) fn new(turns: [bool; 3], first: &Pose, second: &Pose, size: f64) -> Option<Self> {
        let reversed = matches!(turns, [false, true, true] | [true, false, false]);
        let mut three = if reversed {
            Self {
                turns: [turns[2], turns[1], turns[0]],
                first: second.inverse(),
                second: first.inverse(),
                reversed,
            }
        } else {
            Self {
                turns,
                first: *first,
                second: *second,
                reversed,
            }
        };
        if three.turns[0] {
            // What the link shifts along axis 2 belongs behind joint 2: axes that meet then have no lever.
            let along = Normal::within(&three.first, size, TOLERANCES.merely).e;
            let z = Vector3::new(0.0, 0.0, along);
            three.first *= shift(-z);
            three.second = shift(z) * three.second;
        }
        let spans = match three.turns {
            [true, true, true] => false,
            [false, false, false] => three.directions().determinant().abs() > TOLERANCES.class,
            // Two slides along one line do the work of one.
            [false, false, true] => three.slope().norm() > TOLERANCES.class,
            [false, true, false] => {
                !(three.level(0).abs() < TOLERANCES.class
                    && three.level(1).abs() < TOLERANCES.class)
            }
            _ => size > 0.0,
        };
        spans.then_some(three)
    }

    /// The directions of three slides, as columns.
    fn directions(&self) -> Matrix3<f64> {
        let second = self.first.rotation * Vector3::z();
        let third = self.first.rotation * (self.second.rotation * Vector3::z());
        Matrix3::from_columns(&[Vector3::z(), second, third])
    }

    /// The part of slide 2 at a right angle to slide 1.
    fn slope(&self) -> nalgebra::Vector2<f64> {
        let m = self.first.rotation.matrix();
        nalgebra::Vector2::new(m[(0, 2)], m[(1, 2)])
    }

    /// The cosine of the angle between axis 2 and axis 1 (0) or axis 3 (1).
    fn level(&self, side: usize) -> f64 {
        let link = if side == 0 { &self.first } else { &self.second };
        link.rotation.matrix()[(2, 2)]
    }

    /// All joint values that bring `point` (seen behind joint 3) to `place` (seen before joint 1).
    pub(super) fn solve(&self, place: [f64; 3], point: [f64; 3], slack: f64, out: &mut Reaches) {
        let (place, point) = if self.reversed {
            (point, place)
        } else {
            (place, point)
        };
        let (place, point) = (Vector3::from(place), Vector3::from(point));
        let t = self.first.translation.vector;
        let r = self.first.rotation;
        let flat = Vector3::new(t.x, t.y, 0.0);
        let problem = Problem {
            three: self,
            place: place - Vector3::new(0.0, 0.0, t.z),
            lever: r.inverse_transform_vector(&flat),
            up: r.inverse_transform_vector(&Vector3::z()),
            flat,
            point,
            scale: place.norm() + point.norm() + t.norm() + self.second.translation.vector.norm(),
            slack,
        };
        let mut found = Reaches::new();
        match self.turns {
            [true, true, false] => problem.turn_turn_slide(&mut found),
            [true, false, true] => problem.turn_slide_turn(&mut found),
            [false, true, false] => problem.slide_turn_slide(&mut found),
            [false, false, true] => problem.slide_slide_turn(&mut found),
            _ => problem.slides(&mut found),
        }
        out.shortfall = found.shortfall;
        for reach in found.as_slice() {
            let [a, b, c] = reach.turns;
            let turns = if self.reversed {
                [c, b, a].map(|(sin, cos)| (-sin, cos))
            } else {
                [a, b, c]
            };
            out.push(Reach { turns, ..*reach });
        }
    }
}

/// A distance found from squares is lost in their rounding below the root of it, relative.
const NEAR_AXIS: f64 = 3e-8;

/// The problem with the origin of link 1 at the height of axis 1's.
struct Problem<'a> {
    three: &'a Three,
    place: Vector3<f64>,
    /// The shift of link 1 across axis 1, seen before and behind its rotation.
    flat: Vector3<f64>,
    lever: Vector3<f64>,
    /// Axis 1 seen from axis 2.
    up: Vector3<f64>,
    point: Vector3<f64>,
    scale: f64,
    slack: f64,
}

impl Problem<'_> {
    /// `Y` at joint 3 zero, and its change per metre of a slide.
    fn sliding(&self) -> (Vector3<f64>, Vector3<f64>) {
        let link = &self.three.second;
        let start = link * nalgebra::Point3::from(self.point);
        (start.coords, link.rotation * Vector3::z())
    }

    /// `Y` as functions of the angle of joint 3.
    fn turning(&self) -> [Linear; 3] {
        let link = &self.three.second;
        let (m, t, p) = (link.rotation.matrix(), link.translation.vector, self.point);
        std::array::from_fn(|i| Linear {
            k: t[i] + m[(i, 2)] * p.z,
            c: m[(i, 0)] * p.x + m[(i, 1)] * p.y,
            s: m[(i, 1)] * p.x - m[(i, 0)] * p.y,
        })
    }

    /// What `|X|^2 + 2 lever . X` must be.
    fn wanted(&self) -> f64 {
        self.place.norm_squared() - self.flat.norm_squared()
    }

    /// Joint values as an answer holds them.
    fn pairs(&self, values: [f64; 3]) -> [(f64, f64); 3] {
        let pair = |k: usize| match self.three.turns[k] {
            true => values[k].sin_cos(),
            false => (values[k], 0.0),
        };
        [pair(0), pair(1), pair(2)]
    }

    /// Joint 1 from `X`, both seen along its axis; then all three.
    fn finish(&self, x: &Vector3<f64>, second: f64, third: f64, count: u8, out: &mut Reaches) {
        let at = self.three.first.rotation * x + self.flat;
        let (from, to) = ([at.x, at.y], [self.place.x, self.place.y]);
        let short = |v: [f64; 2]| v[0].hypot(v[1]) < TOLERANCES.free * self.scale;
        let (first, free) = match (self.three.turns[0], short(from) || short(to)) {
            (false, _) => (self.place.z - at.z, false),
            (true, true) => (0.0, true),
            (true, false) => (between(from, to), false),
        };
        out.push(Reach {
            turns: self.pairs([first, second, third]),
            edge: true,
            free,
            ..Reach::simple([true; 2], count)
        });
    }

    /// Joint 2 turns `y` onto a point with the given component along a direction across its axis.
    fn turn_second(
        &self,
        y: &Vector3<f64>,
        along: &Vector3<f64>,
        wanted: f64,
        (third, count): (f64, u8),
        out: &mut Reaches,
    ) {
        let c = along.x * y.x + along.y * y.y;
        let s = along.y * y.x - along.x * y.y;
        let length = c.hypot(s);
        if length < NEAR_AXIS * self.scale && length + wanted.abs() < 4.0 * NEAR_AXIS * self.scale {
            // The point lies on axis 2, or so close to it that its direction is lost in the rounding of distances:
            // joint 2 may stand anywhere, or Newton's method finds out where.
            for k in 0..8 {
                let second = f64::from(k) * std::f64::consts::FRAC_PI_4;
                self.finish(y, second, third, count, out);
            }
            if let Some(last) = out.last_mut(8) {
                last.iter_mut().for_each(|reach| reach.free = true);
            }
            return;
        }
        let roots = solve_linear(c, s, wanted, self.slack);
        out.fail(Part::WristInside, roots.excess);
        for &(sin, cos) in &roots.turns[..roots.len] {
            let angle = sin.atan2(cos);
            let x = Vector3::new(cos * y.x - sin * y.y, sin * y.x + cos * y.y, y.z);
            let count = if roots.len == 1 { 2 * count } else { count };
            self.finish(&x, angle, third, count, out);
        }
    }

    fn turn_turn_slide(&self, out: &mut Reaches) {
        let (y, step) = self.sliding();
        let step = step * self.scale;
        let (lever, up) = (self.lever, self.up);
        let across = |v: &Vector3<f64>| v.x.hypot(v.y);
        // Polynomials in slide / scale: |Y|^2, and the two components of X that the equations give.
        let square = [y.norm_squared(), 2.0 * y.dot(&step), step.norm_squared()];
        let far = [
            0.5 * (self.wanted() - square[0]) - lever.z * y.z,
            -0.5 * square[1] - lever.z * step.z,
            -0.5 * square[2],
        ];
        let high = [self.place.z - up.z * y.z, -up.z * step.z, 0.0];
        let determinant = lever.x * up.y - lever.y * up.x;
        if across(&lever) < TOLERANCES.merely * self.scale {
            let mut distance = [0.0; 5];
            distance[0] = square[0] - self.wanted();
            distance[1..3].copy_from_slice(&square[1..]);
            for &(slide, count) in real_roots(&distance, self.slack).as_slice() {
                let y = y + step * slide;
                let wanted = high[0] + high[1] * slide;
                self.turn_second(&y, &up, wanted, (slide * self.scale, count), out);
            }
        } else if across(&up) < TOLERANCES.merely {
            let slide = -high[0] / high[1];
            let wanted = far[0] + slide * (far[1] + slide * far[2]);
            self.turn_second(
                &(y + step * slide),
                &lever,
                wanted,
                (slide * self.scale, 1),
                out,
            );
        } else {
            let mut x = [[0.0; 3]; 2];
            for k in 0..3 {
                x[0][k] = (up.y * far[k] - lever.y * high[k]) / determinant;
                x[1][k] = (lever.x * high[k] - up.x * far[k]) / determinant;
            }
            let mut equation: Quartic = [0.0; 5];
            for side in 0..2 {
                add_product(&mut equation, 1.0, &x[side], &x[side]);
                let linear = [y[side], step[side], 0.0];
                add_product(&mut equation, -1.0, &linear, &linear);
            }
            for &(slide, count) in real_roots(&equation, self.slack).as_slice() {
                let at = |p: &[f64; 3]| p[0] + slide * (p[1] + slide * p[2]);
                let y = y + step * slide;
                let x = Vector3::new(at(&x[0]), at(&x[1]), y.z);
                self.finish(
                    &x,
                    between([y.x, y.y], [x.x, x.y]),
                    slide * self.scale,
                    count,
                    out,
                );
            }
        }
        if out.as_slice().is_empty() {
            out.fail(Part::Slides, f64::MIN_POSITIVE);
        }
    }

    fn turn_slide_turn(&self, out: &mut Reaches) {
        let y = self.turning();
        let (lever, up) = (self.lever, self.up);
        let dot = |v: &Vector3<f64>| {
            let first = Linear::default().plus(v.x, &y[0]).plus(v.y, &y[1]);
            first.plus(v.z, &y[2])
        };
        let (along_lever, along_up) = (dot(&lever), dot(&up));
        let mut equation = Quadratic::default();
        let one = Linear {
            k: 1.0,
            ..Linear::default()
        };
        for side in &y {
            equation.add(1.0, side, side);
        }
        equation.add(2.0, &along_lever, &one);
        equation.add(-self.wanted(), &one, &one);
        if up.z.abs() > TOLERANCES.merely {
            let slide = Linear {
                k: self.place.z / up.z,
                ..Linear::default()
            }
            .plus(-1.0 / up.z, &along_up);
            equation.add(2.0, &slide, &y[2]);
            equation.add(1.0, &slide, &slide);
            equation.add(2.0 * lever.z, &slide, &one);
            for &(third, count) in equation.roots(self.slack).as_slice() {
                let at = third.sin_cos();
                let slide = slide.at(at);
                let x = Vector3::new(y[0].at(at), y[1].at(at), y[2].at(at) + slide);
                self.finish(&x, slide, third, count, out);
            }
            return;
        }
        let roots = solve_linear(
            along_up.c,
            along_up.s,
            self.place.z - along_up.k,
            self.slack,
        );
        out.fail(Part::Slides, roots.excess);
        for &at in &roots.turns[..roots.len] {
            let third = at.0.atan2(at.1);
            let y = Vector3::new(y[0].at(at), y[1].at(at), y[2].at(at));
            let rest = y.norm_squared() + 2.0 * lever.dot(&y) - self.wanted();
            let equation = [rest, 2.0 * (y.z + lever.z), 1.0];
            self.quadratic(&equation, out, |slide, count, out| {
                self.finish(
                    &(y + Vector3::new(0.0, 0.0, slide)),
                    slide,
                    third,
                    count,
                    out,
                );
            });
        }
    }

    fn slide_turn_slide(&self, out: &mut Reaches) {
        let (y, step) = self.sliding();
        // X lies on a line along axis 1, Y on one along axis 3; joint 2 keeps height and distance.
        let x = self
            .three
            .first
            .rotation
            .inverse_transform_vector(&(self.place - self.flat));
        let up = self.up;
        let by_height = up.z.abs() > step.z.abs();
        // Both as functions of one slide: (height offset, rate) so that the heights agree.
        let (x0, x1, y0, y1) = if by_height {
            let (offset, rate) = ((y.z - x.z) / up.z, step.z / up.z);
            (x + up * offset, up * rate, y, step)
        } else {
            let (offset, rate) = ((x.z - y.z) / step.z, up.z / step.z);
            (x, up, y + step * offset, step * rate)
        };
        let flat = |a: &Vector3<f64>, b: &Vector3<f64>| a.x * b.x + a.y * b.y;
        let equation = [
            flat(&x0, &x0) - flat(&y0, &y0),
            2.0 * (flat(&x0, &x1) - flat(&y0, &y1)),
            flat(&x1, &x1) - flat(&y1, &y1),
        ];
        self.quadratic(&equation, out, |slide, count, out| {
            let (x, at) = (x0 + x1 * slide, y0 + y1 * slide);
            let third = if by_height {
                slide
            } else {
                (at - y).dot(&step)
            };
            self.finish(&x, between([at.x, at.y], [x.x, x.y]), third, count, out);
        });
    }

    fn slide_slide_turn(&self, out: &mut Reaches) {
        let y = self.turning();
        let m = self.three.first.rotation.matrix();
        let row = |i: usize| {
            let offset = Linear {
                k: self.flat[i] - self.place[i],
                ..Linear::default()
            };
            let xy = offset.plus(m[(i, 0)], &y[0]).plus(m[(i, 1)], &y[1]);
            xy.plus(m[(i, 2)], &y[2])
        };
        let slope = self.three.slope();
        let (x, y_row) = (row(0), row(1));
        let across = Linear::default().plus(-slope.y, &x).plus(slope.x, &y_row);
        let along = Linear::default().plus(slope.x, &x).plus(slope.y, &y_row);
        let roots = solve_linear(across.c, across.s, -across.k, self.slack);
        out.fail(Part::Slides, roots.excess / slope.norm());
        for &at in &roots.turns[..roots.len] {
            let third = at.0.atan2(at.1);
            let slide = -along.at(at) / slope.norm_squared();
            let point = Vector3::new(y[0].at(at), y[1].at(at), y[2].at(at) + slide);
            let count = if roots.len == 1 { 2 } else { 1 };
            self.finish(&point, slide, third, count, out);
        }
    }

    fn slides(&self, out: &mut Reaches) {
        let start = self.three.second * nalgebra::Point3::from(self.point);
        let start = self.three.first.rotation * start.coords + self.flat;
        let inverse = self.three.directions().try_inverse();
        if let Some(steps) = inverse.map(|inverse| inverse * (self.place - start)) {
            out.push(Reach {
                turns: self.pairs(steps.into()),
                ..Reach::simple([true; 2], 1)
            });
        }
    }

    /// Calls `found` with every root of a quadratic.
    fn quadratic(&self, c: &[f64; 3], out: &mut Reaches, found: impl Fn(f64, u8, &mut Reaches)) {
        let s = self.scale;
        let scaled = [c[0], c[1] * s, c[2] * s * s, 0.0, 0.0];
        let roots = real_roots(&scaled, self.slack);
        if roots.as_slice().is_empty() {
            out.fail(Part::Slides, f64::MIN_POSITIVE);
        }
        for &(root, count) in roots.as_slice() {
            found(root * s, count, out);
        }
    }
}
