//! The forward-kinematic kernel: one product of elementary motions, for every scalar.
//!
//! A frame is four columns: the directions x, y, z of its axes and its origin p. Multiplying a frame from the right
//! by an elementary motion combines columns; how a column is stored (three scalars, one SIMD register) is its own
//! affair. Numbers, batches, derivatives and formulas all come from these few functions.

use crate::scalar::Scalar;
use crate::spatial::Quarters;

/// A column of a frame: a vector over a scalar.
pub trait Column: Clone {
    /// What scales it.
    type Scalar: Scalar;

    /// `self * by`
    #[must_use]
    fn scaled(&self, by: &Self::Scalar) -> Self;

    /// `self * by + other`
    #[must_use]
    fn scaled_plus(&self, by: &Self::Scalar, other: &Self) -> Self;

    /// `-self`
    #[must_use]
    fn negated(&self) -> Self;
}

impl<S: Scalar> Column for [S; 3] {
    type Scalar = S;

    #[inline(always)]
    fn scaled(&self, by: &S) -> Self {
        let [x, y, z] = self.clone();
        [x * by.clone(), y * by.clone(), z * by.clone()]
    }

    #[inline(always)]
    fn scaled_plus(&self, by: &S, other: &Self) -> Self {
        let ([x, y, z], [u, v, w]) = (self.clone(), other.clone());
        [
            x.mul_add(by.clone(), u),
            y.mul_add(by.clone(), v),
            z.mul_add(by.clone(), w),
        ]
    }

    #[inline(always)]
    fn negated(&self) -> Self {
        let [x, y, z] = self.clone();
        [-x, -y, -z]
    }
}

/// A frame: the columns n, s, a, p of its pose.
#[derive(Clone, Copy, Debug)]
pub struct Frame<C> {
    /// Direction of the x axis (n).
    pub x: C,
    /// Direction of the y axis (s).
    pub y: C,
    /// Direction of the z axis (a).
    pub z: C,
    /// Origin (p).
    pub p: C,
}

/// A sine and a cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<S> {
    /// Sine.
    pub sin: S,
    /// Cosine.
    pub cos: S,
}

impl<C: Column> Frame<C> {
    /// Turns about the frame's own z.
    #[inline(always)]
    pub fn turn_z(&mut self, turn: &Turn<C::Scalar>) {
        (self.x, self.y) = combine(&self.x, &self.y, turn);
    }

    /// Turns about the frame's own x.
    #[inline(always)]
    pub fn turn_x(&mut self, turn: &Turn<C::Scalar>) {
        (self.y, self.z) = combine(&self.y, &self.z, turn);
    }

    /// Turns about the frame's own x by a multiple of a right angle, exactly.
    #[inline(always)]
    pub fn turn_x_quarters(&mut self, quarters: Quarters) {
        let (y, z) = (self.y.clone(), self.z.clone());
        (self.y, self.z) = match quarters {
            Quarters::None => (y, z),
            Quarters::Plus => (z, y.negated()),
            Quarters::Minus => (z.negated(), y),
            Quarters::Half => (y.negated(), z.negated()),
        };
    }

    /// Shifts along the frame's own x.
    #[inline(always)]
    pub fn shift_x(&mut self, by: &C::Scalar) {
        self.p = self.x.scaled_plus(by, &self.p);
    }

    /// Shifts along the frame's own z.
    #[inline(always)]
    pub fn shift_z(&mut self, by: &C::Scalar) {
        self.p = self.z.scaled_plus(by, &self.p);
    }

    /// Multiplies by any rigid motion, given as the rows of its 3x4 matrix.
    #[inline(always)]
    pub fn append(&mut self, rows: &[[C::Scalar; 4]; 3]) {
        let column = |j: usize| {
            let xy = self.y.scaled_plus(&rows[1][j], &self.x.scaled(&rows[0][j]));
            self.z.scaled_plus(&rows[2][j], &xy)
        };
        let (x, y, z, p) = (column(0), column(1), column(2), column(3));
        let one = rows[0][3].constant(1.0);
        let p = self.p.scaled_plus(&one, &p);
        *self = Self { x, y, z, p };
    }
}

/// Columns `u cos + v sin` and `v cos - u sin`.
#[inline(always)]
pub(super) fn combine<C: Column>(u: &C, v: &C, turn: &Turn<C::Scalar>) -> (C, C) {
    let u_turned = v.scaled_plus(&turn.sin, &u.scaled(&turn.cos));
    let v_turned = u.scaled_plus(&-turn.sin.clone(), &v.scaled(&turn.cos));
    (u_turned, v_turned)
}
