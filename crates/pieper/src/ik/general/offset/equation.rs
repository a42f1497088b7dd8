//! The equation of an offset wrist for one target.
//!
//! Joint 1 turned back, W lies at `(x', y', z)`, at a known height over the plane in which joints 2 and 3 turn: `y'` follows,
//! and `x'^2 = D = x^2 + y^2 - y'^2`. In that plane let w be W seen from joint 2, p the same point seen from joint 3, n
//! and m the axis that passes through it seen from the base and the one seen from link 3, all as complex numbers, and E the
//! turn of link 3. Then `|w - E p| = a2` and the angle between the axes give two equations that are linear in E,
//!
//! `Re(w* p E) = M,  Re(n* m E) = K,  M = (|w|^2 + |p|^2 - a2^2) / 2`,
//!
//! and `|E| = 1` is the equation: `|M b - K a|^2 = Im(a* b)^2` with `a = w* p`, `b = n* m`. It is a number `g0 + g1 x'`; the
//! norm `g0^2 - D g1^2` is free of the root.

use pulp::Simd;

use super::Meets;
use crate::ik::general::random::Random;
use crate::ik::lanes::{Lane, Mask, Rigid, Turn};

/// The first three joints: common normals of axes 1 and 2, 2 and 3, and the angle at which the two axes meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// Along axis 1.
    pub(super) rise: f64,
    pub(super) a1: f64,
    /// Sine and cosine.
    pub(super) alpha1: (f64, f64),
    /// Along axes 2 and 3.
    pub(super) side: f64,
    pub(super) a2: f64,
    /// -1 if axis 3 points against axis 2.
    pub(super) flip: f64,
    /// Of the angle between the meeting axes.
    pub(super) cosine: f64,
}

/// A vector that turns with the unknown: `constant + cos c + sin s`.
type Turning = [[f64; 3]; 3];

/// The equation of one target.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    plane: Plane,
    /// W and the axis through it as seen from the base, then as seen from link 3.
    place: Turning,
    pub(super) axis: Turning,
    inner_place: Turning,
    inner_axis: Turning,
}

/// `frame Rz(sign t) vector`, for the sign of the turn.
fn turning(frame: &Rigid, vector: [f64; 3], sign: f64, is_point: bool) -> Turning {
    let mut out = [[0.0; 3]; 3];
    let [x, y, z] = vector;
    for (k, row) in frame.rotation.iter().enumerate() {
        let shift = if is_point { frame.shift[k] } else { 0.0 };
        out[0][k] = row[2].mul_add(z, shift);
        out[1][k] = row[0] * x + row[1] * y;
        out[2][k] = sign * (row[1] * x - row[0] * y);
    }
    out
}

/// What does not turn.
fn constant(vector: [f64; 3]) -> Turning {
    [vector, [0.0; 3], [0.0; 3]]
}

/// The frame's inverse applied to a point on z, and to z itself.
fn behind(frame: &Rigid, along: f64) -> ([f64; 3], [f64; 3]) {
    let back = frame.unrotated_shift();
    let z = frame.rotation[2];
    (std::array::from_fn(|k| z[k] * along - back[k]), z)
}

/// A point on z of a frame, and z itself.
fn before(frame: &Rigid, along: f64) -> ([f64; 3], [f64; 3]) {
    let z = frame.column(2);
    (std::array::from_fn(|k| z[k] * along + frame.shift[k]), z)
}

impl Equation {
    pub(super) fn new(
        meets: Meets,
        links: &[Rigid; 5],
        plane: &Plane,
        [before_it, behind_it]: [f64; 2],
        target: &Rigid,
    ) -> Self {
        let (mut place, axis, mut inner_place, mut inner_axis) = match meets {
            Meets::Fourth => {
                // Behind joint 5, W lies on axis 5; joint 6 carries both around.
                let (point, z) = behind(&links[4], behind_it);
                let (inner, inner_z) = before(&links[2], before_it);
                (
                    turning(target, point, -1.0, true),
                    turning(target, z, -1.0, false),
                    constant(inner),
                    constant(inner_z),
                )
            }
            Meets::Sixth => {
                let (point, z) = before(target, behind_it);
                let (inner, inner_z) = before(&links[3], before_it);
                (
                    constant(point),
                    constant(z),
                    turning(&links[2], inner, 1.0, true),
                    turning(&links[2], inner_z, 1.0, false),
                )
            }
        };
        place[0][2] -= plane.rise;
        for part in inner_place.iter_mut().chain(&mut inner_axis) {
            part[1] *= plane.flip;
            part[2] *= plane.flip;
        }
        Self {
            plane: *plane,
            place,
            axis,
            inner_place,
            inner_axis,
        }
    }

    /// The same with all numbers changed a little, some up and some down.
    pub(super) fn moved(&self, by: f64, random: &mut Random) -> Self {
        let mut moved = self.clone();
        let parts = [
            &mut moved.place,
            &mut moved.axis,
            &mut moved.inner_place,
            &mut moved.inner_axis,
        ];
        for number in parts.into_iter().flatten().flatten() {
            *number += by * random.signed();
        }
        moved
    }

    /// The equation at an angle.
    #[inline(always)]
    pub(super) fn at<S: Simd>(&self, angle: Turn<S>) -> Values<S> {
        let [x, y, z] = vector(&self.place, angle);
        let [nx, ny, nz] = vector(&self.axis, angle);
        let [px, py, ph] = vector(&self.inner_place, angle);
        let [mx, my, mh] = vector(&self.inner_axis, angle);
        let plane = &self.plane;
        let (sin, cos) = plane.alpha1;
        let (s, c) = (x.constant(sin), x.constant(cos));
        let height = ph + x.constant(plane.side);
        let side = c.mul_add(z, -height) * x.constant(1.0 / sin);
        let v = c.mul_add(side, s * z);
        let square = x.mul_add(x, y * y);
        let root = side.subtract_product(side, square);
        // The axis seen from behind joint 1, times x^2 + y^2.
        let (dot, cross) = (x.mul_add(nx, y * ny), y.subtract_product(nx, x * ny));
        let along = Both {
            even: -(cross * side),
            odd: dot,
        };
        let lift = square * nz;
        let up = Both {
            even: (dot * side).mul_add(c, s * lift),
            odd: c * cross,
        };
        let off = Both {
            even: (c * lift) - s * (dot * side),
            odd: -(s * cross),
        };
        let k = Both {
            even: mh.subtract_product(off.even, square * x.constant(plane.cosine)),
            odd: -(mh * off.odd),
        };
        let minus_a1 = x.constant(-plane.a1);
        let a = [
            Both {
                even: minus_a1.mul_add(px, v * py),
                odd: px,
            },
            Both {
                even: minus_a1.mul_add(py, -(v * px)),
                odd: py,
            },
        ];
        let b = [along.combined(mx, up, my), along.combined(my, up, -mx)];
        let lengths = x.constant(plane.a1 * plane.a1 - plane.a2 * plane.a2);
        let squares = px.mul_add(px, py.mul_add(py, v.mul_add(v, root + lengths)));
        let m = Both {
            even: squares * x.constant(0.5),
            odd: minus_a1,
        };
        let real = m.times(b[0], root).minus(k.times(a[0], root));
        let imaginary = m.times(b[1], root).minus(k.times(a[1], root));
        let turned = a[0].times(b[1], root).minus(a[1].times(b[0], root));
        let squares = real
            .times(real, root)
            .plus(imaginary.times(imaginary, root));
        Values {
            equation: squares.minus(turned.times(turned, root)),
            real,
            imaginary,
            turned,
            lines: [
                Line {
                    normal: a,
                    right: m,
                },
                Line {
                    normal: b,
                    right: k,
                },
            ],
            root,
            square,
            side,
            v,
            place: [x, y],
            inner: [px, py],
            a1: plane.a1,
        }
    }
}

/// A turning vector at an angle.
#[inline(always)]
pub(super) fn vector<S: Simd>(turning: &Turning, angle: Turn<S>) -> [Lane<S>; 3] {
    let mut out = [angle.cos; 3];
    for k in 0..3 {
        let [constant, cos, sin] = [turning[0][k], turning[1][k], turning[2][k]];
        let sum = angle
            .cos
            .mul_add(out[0].constant(cos), out[0].constant(constant));
        out[k] = angle.sin.mul_add(angle.sin.constant(sin), sum);
    }
    out
}

/// A number `even + odd x'`, where the square of x' is known.
#[derive(Clone, Copy)]
struct Both<S: Simd> {
    even: Lane<S>,
    odd: Lane<S>,
}

impl<S: Simd> Both<S> {
    #[inline(always)]
    fn times(self, by: Self, root: Lane<S>) -> Self {
        Self {
            even: self.even.mul_add(by.even, root * (self.odd * by.odd)),
            odd: self.even.mul_add(by.odd, self.odd * by.even),
        }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self {
            even: self.even + other.even,
            odd: self.odd + other.odd,
        }
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self {
            even: self.even - other.even,
            odd: self.odd - other.odd,
        }
    }

    /// `self x + other y`
    #[inline(always)]
    fn combined(self, x: Lane<S>, other: Self, y: Lane<S>) -> Self {
        Self {
            even: self.even.mul_add(x, other.even * y),
            odd: self.odd.mul_add(x, other.odd * y),
        }
    }

    #[inline(always)]
    fn at(self, x: Lane<S>) -> Lane<S> {
        self.odd.mul_add(x, self.even)
    }
}

/// `Re(normal E) = right`
#[derive(Clone, Copy)]
struct Line<S: Simd> {
    normal: [Both<S>; 2],
    right: Both<S>,
}

impl<S: Simd> Line<S> {
    /// Both E of length 1 on it; the nearest one if it passes by.
    #[inline(always)]
    fn turns(&self, x: Lane<S>) -> [Turn<S>; 2] {
        let (a, b, m) = (self.normal[0].at(x), self.normal[1].at(x), self.right.at(x));
        let zero = x.constant(0.0);
        let square = m.subtract_product(m, a.mul_add(a, b * b));
        let half = square.max(zero).sqrt();
        // E = (a - i b) (m +- i half), up to its length.
        [
            Turn::along(a.mul_add(m, b * half), a.mul_add(half, -(b * m))),
            Turn::along(a.mul_add(m, -(b * half)), -a.mul_add(half, b * m)),
        ]
    }
}

/// The equation and what leads on from it.
#[derive(Clone, Copy)]
pub(super) struct Values<S: Simd> {
    equation: Both<S>,
    real: Both<S>,
    imaginary: Both<S>,
    turned: Both<S>,
    lines: [Line<S>; 2],
    /// The square of x'.
    root: Lane<S>,
    square: Lane<S>,
    side: Lane<S>,
    v: Lane<S>,
    place: [Lane<S>; 2],
    inner: [Lane<S>; 2],
    a1: f64,
}

/// One of the two x', and what follows.
pub(super) struct Branch<S: Simd> {
    /// From W behind joint 1 to W before it: joint 1, counted from the common normal.
    pub(super) first: Turn<S>,
    /// Joint 2, counted from the common normals.
    pub(super) second: Turn<S>,
    /// Joints 2 and 3 together.
    pub(super) both: Turn<S>,
}

/// Odd parts below this, relative to even ones, are rounding.
const EVEN: f64 = 1e-12;
/// Squares of x' below this, relative to the distance from axis 1, may be of either sign.
const MERGED: f64 = 1e-9;
/// The same for a pair of roots, which may be some way to the sides of their top.
const BESIDE: f64 = 0.3;

impl<S: Simd> Values<S> {
    /// The polynomial: the norm over `(x^2 + y^2)^2`, or half of it where x' does not occur.
    #[inline(always)]
    pub(super) fn value(&self, symmetric: bool) -> Lane<S> {
        let Both { even, odd } = self.equation;
        if symmetric {
            return even / self.square;
        }
        let norm = (odd * odd).subtract_product(self.root, even * even);
        norm / (self.square * self.square)
    }

    /// Whether x' does not occur, in any lane.
    pub(super) fn is_even(&self) -> bool {
        let Both { even, odd } = self.equation;
        let odd = odd * self.root.abs().sqrt();
        !(even.abs() * even.constant(EVEN)).less(odd.abs()).any()
    }

    /// Where x' is a real number, and where it may be or not.
    #[inline(always)]
    pub(super) fn is_real(&self) -> (Mask<S>, Mask<S>) {
        let zero = self.root.constant(0.0);
        let least = self.square * self.square.constant(MERGED);
        (zero.less(self.root), self.root.abs().less(least))
    }

    /// Where x' is no real number, nor anywhere near.
    #[inline(always)]
    pub(super) fn is_far_from_real(&self) -> Mask<S> {
        self.root.less(self.square * self.square.constant(-BESIDE))
    }

    /// The x' that the equation asks for; where it does not occur, the positive one.
    #[inline(always)]
    pub(super) fn first(&self, symmetric: bool) -> Lane<S> {
        let x = self.distance();
        if symmetric {
            return x;
        }
        let Both { even, odd } = self.equation;
        x.constant(0.0).less(even * odd).pick(-x, x)
    }

    /// The positive x'.
    #[inline(always)]
    pub(super) fn distance(&self) -> Lane<S> {
        self.root.max(self.root.constant(0.0)).sqrt()
    }

    /// The turn of link 3 at a simple root: where both lines meet.
    #[inline(always)]
    pub(super) fn turn(&self, x: Lane<S>) -> Turn<S> {
        let turned = self.turned.at(x);
        Turn::along(self.imaginary.at(x) * turned, self.real.at(x) * turned)
    }

    /// The turns of link 3 on either line alone: at a double root the other one may say nothing.
    #[inline(always)]
    pub(super) fn turns(&self, x: Lane<S>) -> [Turn<S>; 4] {
        let [position, direction] = &self.lines;
        let ([a, b], [c, d]) = (position.turns(x), direction.turns(x));
        [a, b, c, d]
    }

    /// What follows from x' and the turn of link 3.
    #[inline(always)]
    pub(super) fn branch(&self, x: Lane<S>, both: Turn<S>) -> Branch<S> {
        let [px, py] = self.inner;
        let spun = [
            both.sin.subtract_product(py, both.cos * px),
            both.sin.mul_add(px, both.cos * py),
        ];
        let u = x - x.constant(self.a1);
        let [wx, wy] = self.place;
        Branch {
            first: Turn::along(
                x.mul_add(wx, self.side * wy),
                self.side.subtract_product(wx, x * wy),
            ),
            second: Turn::along(u - spun[0], self.v - spun[1]),
            both,
        }
    }
}
