//! Proposals on their way to verification, eight at a time: their angles and their poses fill the lanes of registers.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use pulp::{Arch, Simd, WithSimd};

use super::arm::{Arm, MAX_JOINTS};
use super::lanes::Lane;
use super::sink::Marks;
use super::solutions::{Branch, JointVector};
use super::wide::Turns;
use crate::kinematics::group::{self, GROUP};
use crate::spatial::Pose;

/// What a row knows about the proposals of all lanes.
pub(super) type Names = [(Branch, Marks); GROUP];

/// Up to [`GROUP`] proposals as sines and cosines.
#[derive(Debug)]
pub(super) struct Pending {
    turns: [Turns; MAX_JOINTS],
    names: Names,
    len: usize,
}

/// Up to four branches in two ways each, as sines and cosines of six joints in lanes.
pub(super) struct Halves<'a> {
    pub(super) turns: [&'a Turns; 6],
    /// Which there are: branch `k` by the first way at `k`, by the second at `FOUR + k`.
    pub(super) there: [bool; GROUP],
    pub(super) names: Names,
}

/// The same as joint values, with what they miss the pose by.
pub(super) struct Measured {
    q: [[f64; GROUP]; MAX_JOINTS],
    /// Whether all of them lie within the joints' limits.
    pub(super) within: [bool; GROUP],
    /// The largest entries of the difference: rotation, position. `None` if they have still to be measured.
    pub(super) misses: Option<[[f64; GROUP]; 2]>,
}

impl Pending {
    pub(super) fn new() -> Self {
        Self {
            turns: [[[0.0; GROUP], [1.0; GROUP]]; MAX_JOINTS],
            names: [(Branch::NONE, Marks::PLAIN); GROUP],
            len: 0,
        }
    }

    /// Whether there is no room for more.
    pub(super) fn is_full(&self) -> bool {
        self.len == GROUP
    }

    #[inline]
    pub(super) fn push(&mut self, turns: &[(f64, f64)], branch: Branch, marks: Marks) {
        let lane = self.len.min(GROUP - 1);
        for ([sines, cosines], &(sin, cos)) in self.turns.iter_mut().zip(turns) {
            (sines[lane], cosines[lane]) = (sin, cos);
        }
        self.names[lane] = (branch, marks);
        self.len = lane + 1;
    }

    /// How many there were: there are none any more, though what they were can still be measured.
    pub(super) fn take(&mut self) -> usize {
        std::mem::take(&mut self.len)
    }

    pub(super) fn names(&self) -> Names {
        self.names
    }

    /// Sines and cosines, or values, of each step.
    pub(super) fn turns(&self) -> [&Turns; MAX_JOINTS] {
        self.turns.each_ref()
    }
}

/// Most arms have no more joints.
const USUAL: usize = 6;

impl Measured {
    /// The joint values of proposals, given as sines and cosines or values of each step, and how far they miss `pose`.
    #[inline]
    pub(super) fn of(turns: &[&Turns], arm: &Arm, pose: &Pose) -> Self {
        let mut measured = Self {
            q: [[0.0; GROUP]; MAX_JOINTS],
            within: [true; GROUP],
            misses: None,
        };
        Arch::new().dispatch(Angles {
            turns,
            arm,
            q: &mut measured.q,
            within: &mut measured.within,
        });
        measured.misses = group::misses(arm.chain().canonical(), &measured.q, pose);
        measured
    }

    #[inline]
    pub(super) fn write(&self, lane: usize, dof: usize, q: &mut JointVector) {
        // Fixed numbers of them, zeros as well, are copied without a call.
        let (first, rest) = self.q.split_at(USUAL);
        for (value, values) in q.iter_mut().zip(first) {
            *value = values[lane];
        }
        q[USUAL..].fill(0.0);
        if dof > USUAL {
            for (value, values) in q[USUAL..].iter_mut().zip(rest) {
                *value = values[lane];
            }
        }
    }
}

/// Joint values, and which are within the limits, compiled for the registers that the processor has.
struct Angles<'a> {
    turns: &'a [&'a Turns],
    arm: &'a Arm,
    q: &'a mut [[f64; GROUP]; MAX_JOINTS],
    within: &'a mut [bool; GROUP],
}

impl WithSimd for Angles<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let splat = |value: f64| Lane::splat(simd, value);
        let [lower, upper] = self.arm.bounds();
        for block in 0..GROUP / S::F64_LANES {
            let steps = self.arm.drives().iter().zip(self.arm.turns());
            let mut inside = splat(0.0).equals(splat(0.0));
            for (&[sines, cosines], (drive, &turns)) in self.turns.iter().zip(steps) {
                let sine = Lane::load(simd, sines, block);
                let (offset, factor) = (splat(drive.offset), splat(drive.factor));
                let value = match turns {
                    // The factor is 1 or -1 here.
                    true => wrap((angle(sine, Lane::load(simd, cosines, block)) - offset) * factor),
                    false => (sine - offset) / factor,
                };
                let joint = drive.variable;
                value.store(&mut self.q[joint], block);
                let above = splat(lower[joint]).at_most(value);
                inside = inside.and(above).and(value.at_most(splat(upper[joint])));
            }
            let mut flags = [0.0; GROUP];
            inside.pick(splat(1.0), splat(0.0)).store(&mut flags, block);
            let lanes = S::F64_LANES * block..S::F64_LANES * (block + 1);
            for lane in lanes {
                self.within[lane] = flags[lane] != 0.0;
            }
        }
    }
}

/// Adding it rounds a double below 2^51 to an integer.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// As [`angle::wrap`](super::angle::wrap), without branches.
#[inline(always)]
fn wrap<S: Simd>(angle: Lane<S>) -> Lane<S> {
    let constant = |value: f64| angle.constant(value);
    let turns = angle.mul_add(constant(1.0 / TAU), constant(ROUNDING)) - constant(ROUNDING);
    let wrapped = turns.subtract_product(constant(TAU), angle);
    let is_least = wrapped.at_most(constant(-PI + 4.0 * f64::EPSILON));
    is_least.pick(constant(PI), wrapped)
}

/// Minimax coefficients of `(atan x - x) / x^3` in `x^2` for `x` up to `tan(pi / 8)`, lowest first; they leave a relative
/// error of the angle below 2^-54.
const ATAN: [f64; 10] = [
    -0.333_333_333_333_302_150_836_1,
    0.199_999_999_991_039_645_855_3,
    -0.142_857_141_964_658_766_564_2,
    0.111_111_067_009_577_287_367_7,
    -0.090_907_834_659_347_934_680_39,
    0.076_900_824_463_777_025_048_52,
    -0.066_412_381_795_059_029_610_22,
    0.056_931_218_201_756_405_524_89,
    -0.043_606_993_585_709_829_925_28,
    0.021_278_579_207_035_796_102_5,
];

/// `tan(pi / 8)`
const HALF_OF_45: f64 = 0.414_213_562_373_095_048_8;

/// The angles of plane vectors `(x, y)` by `y` and `x`, without branches; to about two units in the last place. 0 for the zero
/// vector.
#[inline(always)]
fn angle<S: Simd>(y: Lane<S>, x: Lane<S>) -> Lane<S> {
    let constant = |value: f64| x.constant(value);
    let (ax, ay, zero) = (x.abs(), y.abs(), constant(0.0));
    let steep = ax.less(ay);
    let (low, high) = (steep.pick(ax, ay), steep.pick(ay, ax));
    // Of the upper half it is counted from 45 degrees.
    let far = (high * constant(HALF_OF_45)).less(low);
    let above = far.pick(low - high, low);
    let below = far.pick(low + high, high);
    let ratio = above / below.equals(zero).pick(constant(1.0), below);
    let z = ratio * ratio;
    let mut sum = constant(ATAN[ATAN.len() - 1]);
    for &coefficient in ATAN.iter().rev().skip(1) {
        sum = sum.mul_add(z, constant(coefficient));
    }
    let small = (ratio * z).mul_add(sum, ratio);
    let angle = far.pick(constant(FRAC_PI_4) + small, small);
    let angle = steep.pick(constant(FRAC_PI_2) - angle, angle);
    let angle = x.less(zero).pick(constant(PI) - angle, angle);
    angle.with_sign(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Call<'a>([&'a [f64; GROUP]; 2], &'a mut [f64; GROUP]);

    impl WithSimd for Call<'_> {
        type Output = ();

        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) {
            let [y, x] = self.0;
            for block in 0..GROUP / S::F64_LANES {
                let out = angle(Lane::load(simd, y, block), Lane::load(simd, x, block));
                out.store(self.1, block);
            }
        }
    }

    fn angles(y: &[f64; GROUP], x: &[f64; GROUP]) -> [f64; GROUP] {
        let mut out = [0.0; GROUP];
        Arch::new().dispatch(Call([y, x], &mut out));
        out
    }

    #[test]
    fn angles_are_those_of_the_standard_library() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut worst = 0.0_f64;
        for _ in 0..20_000 {
            // Of any size, and as often near an axis or a diagonal as anywhere.
            let size = 10_f64.powf(16.0 * random.f64() - 8.0);
            let quarter = FRAC_PI_4 * f64::from(random.u8(0..8));
            let off = 10_f64.powf(-17.0 * random.f64());
            let mut directions = [[0.0; GROUP]; 2];
            for lane in 0..GROUP {
                let (sin, cos) = (quarter + off * (2.0 * random.f64() - 1.0)).sin_cos();
                (directions[0][lane], directions[1][lane]) = (size * sin, size * cos);
            }
            let [y, x] = &directions;
            for ((angle, y), x) in angles(y, x).iter().zip(y).zip(x) {
                let expected = y.atan2(*x);
                worst = worst.max(((angle - expected) / expected).abs());
            }
        }
        assert!(worst < 2.5 * f64::EPSILON, "{worst:e}");
    }

    #[test]
    fn angles_of_what_has_none() {
        let y = [0.0, -0.0, 0.0, f64::NAN, 1.0, f64::NAN, 1.0, -1.0];
        let x = [0.0, 1.0, -1.0, 1.0, f64::NAN, f64::NAN, 0.0, 0.0];
        let found = angles(&y, &x);
        assert_eq!(found[..3], [0.0, -0.0, PI]);
        assert!(found[3..6].iter().all(|angle| angle.is_nan()));
        assert_eq!(found[6..], [FRAC_PI_2, -FRAC_PI_2]);
    }
}
