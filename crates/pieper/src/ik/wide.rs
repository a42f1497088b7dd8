//! Four branches of a solution at once, in registers of four doubles.

mod position;
mod triangle;
mod wrist;

pub(super) use position::{Folded, Folding};
pub(super) use triangle::{Closed, Closing, Turning};
pub(super) use wrist::{Oriented, Wrist};

use super::angle::EDGE;
use crate::kinematics::group::GROUP;

/// Branches at once: what is left of a closed form behind its first choices has four at most, away from singularities.
pub(super) const FOUR: usize = 4;

/// Sines and cosines of one joint in [`FOUR`] branches.
pub(super) type Sines = [[f64; FOUR]; 2];

/// The same in two ways, one after the other.
pub(super) type Turns = [[f64; GROUP]; 2];

/// Sines and cosines by the first way and by the second.
#[inline(always)]
fn both(first: Sines, second: Sines) -> Turns {
    let mut out = [[0.0; GROUP]; 2];
    for (out, (first, second)) in out.iter_mut().zip(first.iter().zip(&second)) {
        out[..FOUR].copy_from_slice(first);
        out[FOUR..].copy_from_slice(second);
    }
    out
}

/// Sines and cosines of the angles half a turn away.
#[inline(always)]
fn opposite([sines, cosines]: Sines) -> Sines {
    [Wide(sines).negative().0, Wide(cosines).negative().0]
}

/// Something to be computed for all branches.
pub(super) trait Task {
    /// The answer.
    type Output;

    /// `None` where the branches have to be looked at one by one.
    fn solve(&self) -> Option<Self::Output>;
}

/// The answer to a task; `None` also if this processor has no registers of four doubles.
#[inline]
pub(super) fn run<T: Task>(task: &T) -> Option<T::Output> {
    #[cfg(all(target_arch = "x86_64", feature = "avx2"))]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return pulp::Simd::vectorize(simd, Call(task));
    }
    let _ = task;
    None
}

/// The call, as what runs with the processor's features switched on.
#[cfg(all(target_arch = "x86_64", feature = "avx2"))]
struct Call<'a, T>(&'a T);

#[cfg(all(target_arch = "x86_64", feature = "avx2"))]
impl<T: Task> pulp::NullaryFnOnce for Call<'_, T> {
    type Output = Option<T::Output>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        self.0.solve()
    }
}

/// One number for each branch.
#[derive(Clone, Copy)]
struct Wide([f64; FOUR]);

impl Wide {
    #[inline(always)]
    fn all(value: f64) -> Self {
        Self([value; FOUR])
    }

    /// `self by + plus`, fused: only within [`run`], where it is one instruction.
    #[inline(always)]
    fn mul_add(self, by: Self, plus: Self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k].mul_add(by.0[k], plus.0[k]);
        }
        Self(out)
    }

    #[inline(always)]
    fn times(self, by: Self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k] * by.0[k];
        }
        Self(out)
    }

    #[inline(always)]
    fn negative(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = -self.0[k];
        }
        Self(out)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = self.0[k].sqrt();
        }
        Self(out)
    }

    /// The root; 0 of what is negative.
    #[inline(always)]
    fn real_sqrt(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = if self.0[k] > 0.0 { self.0[k] } else { 0.0 };
        }
        Self(out).sqrt()
    }

    #[inline(always)]
    fn inverse(self) -> Self {
        let mut out = [0.0; FOUR];
        for k in 0..FOUR {
            out[k] = 1.0 / self.0[k];
        }
        Self(out)
    }
}

/// Whether there are two ways to bend a triangle of which the square of the bend's sine and the distances from being
/// stretched and folded are given, one by one for each branch.
struct Bends {
    /// The square, 0 where both ways are one.
    square: Wide,
    /// Whether there is a way, and another one.
    there: [[bool; FOUR]; 2],
    /// Whether they are so close that this is certain only if nothing else is singular.
    near: [bool; FOUR],
}

impl Bends {
    /// A distance of up to `merged` the other way is none, and one of up to `one` makes both ways the same.
    #[inline(always)]
    fn new(square: Wide, beyond: Wide, within: Wide, merged: f64, one: f64) -> Self {
        let mut out = Self {
            square,
            there: [[true; FOUR]; 2],
            near: [false; FOUR],
        };
        let mut is_apart = true;
        for k in 0..FOUR {
            is_apart &= square.0[k] > EDGE;
        }
        if is_apart {
            return out;
        }
        for k in 0..FOUR {
            // What is not a number fails every comparison.
            let [beyond, within] = [beyond.0[k], within.0[k]];
            let gap = if beyond < within { beyond } else { within };
            out.near[k] = square.0[k] <= EDGE;
            out.there[0][k] = square.0[k] > EDGE || gap >= -merged;
            out.there[1][k] = square.0[k] > EDGE || gap > one;
            out.square.0[k] = if out.there[1][k] { square.0[k] } else { 0.0 };
        }
        out
    }
}

/// `a b + c d`
#[inline(always)]
fn product(a: Wide, b: Wide, c: Wide, d: Wide) -> Wide {
    a.mul_add(b, c.times(d))
}

/// Sine and cosine of an angle less a constant one.
#[inline(always)]
fn back(sin: Wide, cos: Wide, (s, c): (f64, f64)) -> Sines {
    let (s, c) = (Wide::all(s), Wide::all(c));
    [
        product(sin, c, cos.negative(), s).0,
        product(cos, c, sin, s).0,
    ]
}

/// Sine and cosine, up to a common factor, of the angle that turns `from` onto the direction of `to`.
#[inline(always)]
fn turning(from: [Wide; 2], to: [Wide; 2]) -> [Wide; 2] {
    [
        product(from[0], to[1], from[1].negative(), to[0]),
        product(from[0], to[0], from[1], to[1]),
    ]
}

/// Divided by their length.
#[inline(always)]
fn unit([sin, cos]: [Wide; 2]) -> [Wide; 2] {
    let by = product(sin, sin, cos, cos).sqrt().inverse();
    [sin.times(by), cos.times(by)]
}
