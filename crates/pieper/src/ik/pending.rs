//! Proposals on their way to verification, eight at a time: their angles and their poses fill the lanes of registers.

use pulp::{Arch, Simd, WithSimd};

use super::arm::{Arm, MAX_JOINTS};
use super::sink::Marks;
use super::solutions::{Branch, JointVector};
use super::wide::{FOUR, Sines};
use crate::kinematics::{
    batch::ENTRIES,
    group::{self, GROUP},
};
use crate::spatial::Pose;

/// Up to [`GROUP`] proposals as sines and cosines.
#[derive(Debug)]
pub(super) struct Pending {
    sines: [[f64; GROUP]; MAX_JOINTS],
    cosines: [[f64; GROUP]; MAX_JOINTS],
    pub(super) names: [(Branch, Marks); GROUP],
    pub(super) len: usize,
}

/// Up to four branches in two ways each, as sines and cosines of six joints in lanes.
pub(super) struct Halves<'a> {
    pub(super) turns: [[&'a Sines; 6]; 2],
    /// Which there are: branch `k` by the first way at `k`, by the second at `FOUR + k`.
    pub(super) there: [bool; GROUP],
    pub(super) names: [(Branch, Marks); GROUP],
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
            sines: [[0.0; GROUP]; MAX_JOINTS],
            cosines: [[1.0; GROUP]; MAX_JOINTS],
            names: [(Branch::NONE, Marks::PLAIN); GROUP],
            len: 0,
        }
    }

    #[inline]
    pub(super) fn push(&mut self, turns: &[(f64, f64)], branch: Branch, marks: Marks) {
        let lane = self.len.min(GROUP - 1);
        for (step, &(sin, cos)) in turns.iter().enumerate() {
            self.sines[step][lane] = sin;
            self.cosines[step][lane] = cos;
        }
        self.names[lane] = (branch, marks);
        self.len = lane + 1;
    }

    /// Puts four proposals into each half of the lanes, in place of what was there.
    #[inline]
    pub(super) fn fill(&mut self, halves: &Halves<'_>) {
        for (half, turns) in halves.turns.iter().enumerate() {
            let lanes = FOUR * half..FOUR * (half + 1);
            for (step, [sines, cosines]) in turns.iter().enumerate() {
                self.sines[step][lanes.clone()].copy_from_slice(sines);
                self.cosines[step][lanes.clone()].copy_from_slice(cosines);
            }
        }
        self.names = halves.names;
    }

    /// Joint values, and how far they miss `pose`.
    #[inline]
    pub(super) fn measure(&self, arm: &Arm, pose: &Pose, measured: &mut Measured) {
        Arch::new().dispatch(Angles {
            pending: self,
            arm,
            q: &mut measured.q,
            within: &mut measured.within,
        });
        let mut entries = [[0.0; GROUP]; ENTRIES];
        let canonical = arm.chain().canonical();
        if group::poses(canonical, &measured.q, &mut entries) {
            let mut most = [[0.0; GROUP]; 2];
            Arch::new().dispatch(Misses {
                entries: &entries,
                pose,
                most: &mut most,
            });
            measured.misses = Some(most);
        }
    }

    #[inline(always)]
    fn joint_values(&self, arm: &Arm, q: &mut [[f64; GROUP]; MAX_JOINTS]) {
        for (step, (drive, &turns)) in arm.drives().iter().zip(arm.turns()).enumerate() {
            let (sines, cosines) = (&self.sines[step], &self.cosines[step]);
            let values = &mut q[drive.variable];
            if turns {
                for lane in 0..GROUP {
                    let angle = atan2(sines[lane], cosines[lane]);
                    // The factor is 1 or -1 here.
                    values[lane] = wrap((angle - drive.offset) * drive.factor);
                }
            } else {
                for lane in 0..GROUP {
                    values[lane] = (sines[lane] - drive.offset) / drive.factor;
                }
            }
        }
    }
}

/// [`Pending::joint_values`], and which are within the limits, compiled for the registers that the processor has.
struct Angles<'a> {
    pending: &'a Pending,
    arm: &'a Arm,
    q: &'a mut [[f64; GROUP]; MAX_JOINTS],
    within: &'a mut [bool; GROUP],
}

impl WithSimd for Angles<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.pending.joint_values(self.arm, self.q);
        let [lower, upper] = self.arm.bounds();
        let bounds = lower.iter().zip(upper).take(self.arm.chain().dof());
        // Numbers in a local array stay in a register; flags in memory would be waited for, joint after joint.
        let mut outside = [0.0; GROUP];
        for (values, (&lower, &upper)) in self.q.iter().zip(bounds) {
            for lane in 0..GROUP {
                let inside = (lower <= values[lane]) & (values[lane] <= upper);
                outside[lane] += if inside { 0.0 } else { 1.0 };
            }
        }
        for lane in 0..GROUP {
            self.within[lane] = outside[lane] == 0.0;
        }
    }
}

impl Measured {
    #[inline]
    pub(super) fn empty() -> Self {
        Self {
            q: [[0.0; GROUP]; MAX_JOINTS],
            within: [true; GROUP],
            misses: None,
        }
    }

    #[inline]
    pub(super) fn write(&self, lane: usize, q: &mut JointVector) {
        // All of them, zeros as well: a fixed number is copied without a call.
        for (value, values) in q.iter_mut().zip(&self.q) {
            *value = values[lane];
        }
    }
}

/// The largest differences from a pose, compiled for the registers that the processor has.
struct Misses<'a> {
    entries: &'a [[f64; GROUP]; ENTRIES],
    pose: &'a Pose,
    most: &'a mut [[f64; GROUP]; 2],
}

impl WithSimd for Misses<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let wanted = [
            self.pose.rotation.matrix().as_slice(),
            self.pose.translation.vector.as_slice(),
        ];
        let (rotations, positions) = self.entries.split_at(9);
        for ((wanted, values), out) in wanted
            .iter()
            .zip([rotations, positions])
            .zip(self.most.iter_mut())
        {
            // In registers until the end: what is stored and loaded again waits.
            let mut most = [0.0_f64; GROUP];
            for (values, &wanted) in values.iter().zip(wanted.iter()) {
                for lane in 0..GROUP {
                    let miss = (values[lane] - wanted).abs();
                    most[lane] = if miss <= most[lane] { most[lane] } else { miss };
                }
            }
            *out = most;
        }
    }
}

/// Adding it rounds a double below 2^51 to an integer.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// As [`angle::wrap`](super::angle::wrap), without branches.
#[inline(always)]
fn wrap(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let turns = (angle * (1.0 / TAU) + ROUNDING) - ROUNDING;
    let wrapped = angle - TAU * turns;
    if wrapped <= -PI + 4.0 * f64::EPSILON {
        PI
    } else {
        wrapped
    }
}

/// Coefficients of the rational approximation of `(atan x - x) / x^3` in `x^2` on [0, 0.66], highest first, after
/// Moshier's Cephes; error below 2e-16.
const ATAN_ABOVE: [f64; 5] = [
    -8.750_608_600_031_904_122_785e-1,
    -1.615_753_718_733_365_076_637e1,
    -7.500_855_792_314_704_667_340e1,
    -1.228_866_684_490_136_173_410e2,
    -6.485_021_904_942_025_371_773e1,
];
const ATAN_BELOW: [f64; 5] = [
    2.485_846_490_142_306_297_962e1,
    1.650_270_098_316_988_542_046e2,
    4.328_810_604_912_902_668_951e2,
    4.853_903_996_359_136_964_868e2,
    1.945_506_571_482_613_964_425e2,
];

/// The angle of the plane vector `(x, y)`, without branches, so that eight are computed at once; to about two units
/// in the last place. 0 for the zero vector.
#[inline(always)]
fn atan2(y: f64, x: f64) -> f64 {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let (ax, ay) = (x.abs(), y.abs());
    let steep = ay > ax;
    let (low, high) = if steep { (ax, ay) } else { (ay, ax) };
    // Beyond 0.66 the angle is counted from 45 degrees.
    let far = low > 0.66 * high;
    let above = if far { low - high } else { low };
    let below = if far { low + high } else { high };
    let ratio = above / if below > 0.0 { below } else { 1.0 };
    let z = ratio * ratio;
    let p = ATAN_ABOVE[1..]
        .iter()
        .fold(ATAN_ABOVE[0], |sum, c| sum * z + c);
    let q = ATAN_BELOW.iter().fold(1.0, |sum, c| sum * z + c);
    let small = ratio * (z * p / q) + ratio;
    let angle = if far { FRAC_PI_4 + small } else { small };
    let angle = if steep { FRAC_PI_2 - angle } else { angle };
    let angle = if x < 0.0 { PI - angle } else { angle };
    angle.copysign(y)
}
