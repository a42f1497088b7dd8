//! A handful of poses at once, on the stack: what inverse kinematics verifies its solutions with.

use pulp::{Arch, Simd, WithSimd};

use super::kernel::{Frame, Turn};
use super::lanes::{self, LaneColumn, Lanes};
use super::ortho;
use super::single::{self, Moved};
use crate::model::{Canonical, PACK, Step};
use crate::scalar::Scalar;
use crate::spatial::Pose;

/// Vectors in a group of [`poses`].
pub(crate) const GROUP: usize = 8;

/// By how much the tool's poses for [`GROUP`] joint vectors on the stack, value `j` of vector `k` at `q[j][k]`, differ from a
/// wanted one: the largest difference of an entry of the rotation, and of the position. `None` if an angle is too large or not
/// finite, or if this processor has no registers of several doubles.
///
/// For inverse kinematics, which verifies a handful of solutions at once.
#[inline]
pub(crate) fn misses(
    canonical: &Canonical,
    q: &[[f64; GROUP]],
    pose: &Pose,
) -> Option<[[f64; GROUP]; 2]> {
    let mut out = [[0.0; GROUP]; 2];
    let task = Group {
        canonical,
        q,
        wanted: [
            pose.rotation.matrix().as_slice(),
            pose.translation.vector.as_slice(),
        ],
        out: &mut out,
    };
    Arch::new().dispatch(task).then_some(out)
}

struct Group<'a> {
    canonical: &'a Canonical,
    q: &'a [[f64; GROUP]],
    /// Rotation by columns, and position.
    wanted: [&'a [f64]; 2],
    out: &'a mut [[f64; GROUP]; 2],
}

impl WithSimd for Group<'_> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        let width = S::F64_LANES;
        if width == 1 || !GROUP.is_multiple_of(width) {
            return false;
        }
        let zero = Lanes::splat(simd, 0.0);
        let mut turns = Turns(
            [Turn {
                sin: zero,
                cos: zero,
            }; PACK],
        );
        for block in 0..GROUP / width {
            let joint = |variable: usize| S::as_simd_f64s(&self.q[variable]).0[block];
            let (Frame { x, y, z, p }, sizes) = match self.canonical.ortho() {
                Some(arm) => {
                    let [a, b, c, d, e, f] = arm.variables;
                    let joints = [joint(a), joint(b), joint(c), joint(d), joint(e), joint(f)];
                    ortho::poses(simd, arm, joints)
                }
                None => several(simd, self.canonical, joint, &mut turns),
            };
            let rotation = [x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z];
            for ((entries, wanted), out) in [&rotation[..], &[p.x, p.y, p.z]]
                .iter()
                .zip(self.wanted)
                .zip(self.out.iter_mut())
            {
                let most = largest_miss(simd, entries, wanted);
                S::as_mut_simd_f64s(out).0[block] = most;
            }
            if !lanes::all_small(sizes) {
                return false;
            }
        }
        true
    }
}

/// The largest difference of entries from those that are wanted.
#[inline(always)]
fn largest_miss<S: Simd>(simd: S, entries: &[S::f64s], wanted: &[f64]) -> S::f64s {
    let mut most = simd.splat_f64s(0.0);
    for (&entry, &wanted) in entries.iter().zip(wanted) {
        let miss = lanes::magnitude(simd, simd.sub_f64s(entry, simd.splat_f64s(wanted)));
        let is_less = simd.less_than_or_equal_f64s(miss, most);
        most = simd.select_f64s(is_less, most, miss);
    }
    most
}

/// Sines and cosines of a pack of steps, where no register straddles two cache lines.
#[repr(align(64))]
struct Turns<S: Simd>([Turn<Lanes<S>>; PACK]);

/// One register's worth of poses, which stay in registers: for so few a tile does not pay. `joint` gives the values of a variable.
/// With the sum of the angles' sizes, which is not a number where one of them is none.
#[inline(always)]
fn several<S: Simd>(
    simd: S,
    canonical: &Canonical,
    joint: impl Fn(usize) -> S::f64s,
    Turns(turns): &mut Turns<S>,
) -> (Frame<LaneColumn<S>>, Lanes<S>) {
    let splat = |value: f64| Lanes::splat(simd, value);
    let base = single::base_frame(&canonical.base);
    let column = |[x, y, z]: [f64; 3]| LaneColumn {
        simd,
        x: simd.splat_f64s(x),
        y: simd.splat_f64s(y),
        z: simd.splat_f64s(z),
    };
    let mut frame = Frame {
        x: column(base.x),
        y: column(base.y),
        z: column(base.z),
        p: column(base.p),
    };
    let mut sizes = splat(0.0);
    for steps in canonical.steps.chunks(PACK) {
        // All sines and cosines first: they are independent of one another, the product is one long chain.
        for (turn, step) in turns.iter_mut().zip(steps) {
            let value = Lanes {
                simd,
                value: joint(step.drive.variable),
            };
            let displacement = value.mul_add(splat(step.drive.factor), splat(step.drive.offset));
            // Adding sizes, unlike comparing them, keeps what is not a number.
            sizes = sizes
                + Lanes {
                    simd,
                    value: lanes::magnitude(simd, displacement.value),
                };
            *turn = if step.turns {
                lanes::sin_cos(displacement)
            } else {
                Turn {
                    sin: displacement,
                    cos: displacement,
                }
            };
        }
        let motion = |index: usize, step: &Step| {
            if step.turns {
                Moved::Turned(turns[index])
            } else {
                Moved::Slid(turns[index].sin)
            }
        };
        frame = single::run(steps, frame, splat, motion, |_, _| {});
    }
    single::append_tail(&mut frame, canonical, splat);
    (frame, sizes)
}
