//! A handful of poses at once, on the stack: what inverse kinematics verifies its solutions with.

use pulp::{Arch, Simd, WithSimd};

use super::batch::ENTRIES;
use super::kernel::{Frame, Turn};
use super::lanes::{self, LaneColumn, Lanes};
use super::ortho;
use super::single::{self, Moved};
use crate::model::{Canonical, PACK, Step};
use crate::scalar::Scalar;

/// Vectors in a group of [`poses`].
pub(crate) const GROUP: usize = 8;

/// The tool's poses for [`GROUP`] joint vectors on the stack, value `j` of vector `k` at `q[j][k]`; `false`, and nothing
/// of use written, if an angle is too large or not finite, or if this processor has no registers of several doubles.
///
/// For inverse kinematics, which verifies a handful of solutions at once.
#[inline]
pub(crate) fn poses(
    canonical: &Canonical,
    q: &[[f64; GROUP]],
    out: &mut [[f64; GROUP]; ENTRIES],
) -> bool {
    Arch::new().dispatch(Group { canonical, q, out })
}

struct Group<'a> {
    canonical: &'a Canonical,
    q: &'a [[f64; GROUP]],
    out: &'a mut [[f64; GROUP]; ENTRIES],
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
        let mut columns: [&mut [S::f64s]; ENTRIES] = Default::default();
        for (column, entries) in columns.iter_mut().zip(self.out.iter_mut()) {
            *column = S::as_mut_simd_f64s(entries).0;
        }
        for block in 0..GROUP / width {
            let joint = |variable: usize| S::as_simd_f64s(&self.q[variable]).0[block];
            if let Some(arm) = self.canonical.ortho() {
                let [a, b, c, d, e, f] = arm.variables;
                let joints = [joint(a), joint(b), joint(c), joint(d), joint(e), joint(f)];
                let (Frame { x, y, z, p }, sizes) = ortho::poses(simd, arm, joints);
                let entries = [x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, p.x, p.y, p.z];
                for (column, value) in columns.iter_mut().zip(entries) {
                    column[block] = value;
                }
                if !lanes::all_small(sizes) {
                    return false;
                }
                continue;
            }
            let store = |entry: usize, value: S::f64s| columns[entry][block] = value;
            if !several(simd, self.canonical, joint, &mut turns, store) {
                return false;
            }
        }
        true
    }
}

/// Sines and cosines of a pack of steps, where no register straddles two cache lines.
#[repr(align(64))]
struct Turns<S: Simd>([Turn<Lanes<S>>; PACK]);

/// One register's worth of poses, which stay in registers: for so few a tile does not pay. `joint` gives the values of a variable, `store` takes the entries; `false`, and
/// nothing of use stored, if an angle is too large or not finite.
#[inline(always)]
fn several<S: Simd>(
    simd: S,
    canonical: &Canonical,
    joint: impl Fn(usize) -> S::f64s,
    Turns(turns): &mut Turns<S>,
    mut store: impl FnMut(usize, S::f64s),
) -> bool {
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
    let Frame { x, y, z, p } = frame;
    store(0, x.x);
    store(1, x.y);
    store(2, x.z);
    store(3, y.x);
    store(4, y.y);
    store(5, y.z);
    store(6, z.x);
    store(7, z.y);
    store(8, z.z);
    store(9, p.x);
    store(10, p.y);
    store(11, p.z);
    lanes::all_small(sizes)
}
