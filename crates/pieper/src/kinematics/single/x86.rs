//! One pose on AVX2 or AVX-512: sines and cosines in the widest lanes, a column of the frame in four.

use pulp::x86::V3;
use pulp::{NullaryFnOnce, Simd, f64x4};

use super::{Moved, Record, SpaceColumn, append_tail, base_frame, pose_of, run};
use crate::error::Result;
use crate::kinematics::kernel::{Column, Frame, Turn};
use crate::kinematics::lanes::{self, Lanes};
use crate::model::{Canonical, Chain, PACK, Step};
use crate::scalar::Scalar;
use crate::spatial::Pose;

/// A column in one register; the fourth lane is idle.
#[derive(Clone, Copy)]
struct Quad {
    simd: V3,
    value: f64x4,
}

impl Quad {
    #[inline(always)]
    fn new(simd: V3, [x, y, z]: [f64; 3]) -> Self {
        Self {
            simd,
            value: f64x4(x, y, z, 0.0),
        }
    }
}

impl Column for Quad {
    type Scalar = f64;

    #[inline(always)]
    fn scaled(&self, by: &f64) -> Self {
        let by = self.simd.splat_f64s(*by);
        Self {
            value: self.simd.mul_f64s(self.value, by),
            ..*self
        }
    }

    #[inline(always)]
    fn scaled_plus(&self, by: &f64, other: &Self) -> Self {
        let by = self.simd.splat_f64s(*by);
        Self {
            value: self.simd.mul_add_f64s(self.value, by, other.value),
            ..*self
        }
    }

    #[inline(always)]
    fn negated(&self) -> Self {
        Self {
            value: lanes::negative(self.simd, self.value),
            ..*self
        }
    }
}

impl SpaceColumn for Quad {
    #[inline(always)]
    fn cross(&self, other: &Self) -> Self {
        // Lanes y z x: of a x b = (a * b.yzx - a.yzx * b).yzx
        let yzx = |value: f64x4| {
            let lanes = self
                .simd
                .avx2
                ._mm256_permute4x64_pd::<0b11_00_10_01>(pulp::cast(value));
            pulp::cast::<_, f64x4>(lanes)
        };
        let product = self.simd.mul_f64s(yzx(self.value), other.value);
        let turned = self.simd.mul_add_f64s(
            self.value,
            yzx(other.value),
            lanes::negative(self.simd, product),
        );
        Self {
            value: yzx(turned),
            ..*self
        }
    }

    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        Self {
            value: self.simd.sub_f64s(self.value, other.value),
            ..*self
        }
    }

    #[inline(always)]
    fn padded(&self) -> [f64; 4] {
        pulp::cast(self.value)
    }

    #[inline(always)]
    fn load(&self, from: &[f64; 3]) -> Self {
        Self::new(self.simd, *from)
    }

    #[inline(always)]
    fn store(&self) -> [f64; 3] {
        let f64x4(x, y, z, _) = self.value;
        [x, y, z]
    }
}

/// The call, as what runs with the processor's features switched on.
struct Call<'a, S, R> {
    wide: S,
    narrow: V3,
    chain: &'a Chain,
    q: &'a [f64],
    record: &'a mut R,
}

#[inline(always)]
pub(super) fn tool_pose<S: Simd>(
    wide: S,
    narrow: V3,
    chain: &Chain,
    q: &[f64],
    record: &mut impl Record,
) -> Result<Pose> {
    wide.vectorize(Call {
        wide,
        narrow,
        chain,
        q,
        record,
    })
}

impl<S: Simd, R: Record> NullaryFnOnce for Call<'_, S, R> {
    type Output = Result<Pose>;

    #[inline(always)]
    fn call(self) -> Result<Pose> {
        let Self {
            wide,
            narrow,
            chain,
            q,
            record,
        } = self;
        let canonical = chain.canonical();
        let base = base_frame(&canonical.base);
        let column = |column| Quad::new(narrow, column);
        let mut frame = Frame {
            x: column(base.x),
            y: column(base.y),
            z: column(base.z),
            p: column(base.p),
        };
        let mut moved = Displacements {
            values: [0.0; PACK],
            sin: [0.0; PACK],
            cos: [0.0; PACK],
        };
        for (pack, steps) in canonical.steps.chunks(PACK).enumerate() {
            if !moved.set(wide, canonical, pack, steps, q) {
                return Err(chain.not_finite_error(q));
            }
            let motion = |index: usize, step: &Step| {
                if step.turns {
                    Moved::Turned(Turn {
                        sin: moved.sin[index],
                        cos: moved.cos[index],
                    })
                } else {
                    Moved::Slid(moved.values[index])
                }
            };
            let visit = |step: &Step, frame: &Frame<Quad>| record.axis(step, frame);
            frame = run(steps, frame, |x| x, motion, visit);
        }
        append_tail(&mut frame, canonical, |x| x);
        record.tool(&frame);
        let [x, y, z, p] = [frame.x, frame.y, frame.z, frame.p].map(|column| column.store());
        Ok(pose_of(&Frame { x, y, z, p }))
    }
}

/// Displacements of a pack of steps, with their sines and cosines.
// Aligned so that no register straddles two cache lines.
#[repr(align(64))]
struct Displacements {
    values: [f64; PACK],
    sin: [f64; PACK],
    cos: [f64; PACK],
}

impl Displacements {
    /// Those of pack `pack`, whose steps are `steps`; `false` if one is not finite.
    #[inline(always)]
    fn set<S: Simd>(
        &mut self,
        simd: S,
        canonical: &Canonical,
        pack: usize,
        steps: &[Step],
        q: &[f64],
    ) -> bool {
        let drives = canonical.packed();
        let (factors, offsets) = (&drives.factors[pack], &drives.offsets[pack]);
        let mut gathered = [0.0; PACK];
        let q = if drives.in_order {
            &q[pack * PACK..]
        } else {
            for (value, step) in gathered.iter_mut().zip(steps) {
                *value = q[step.drive.variable];
            }
            &gathered[..]
        };
        let (factors, offsets) = (S::as_simd_f64s(factors).0, S::as_simd_f64s(offsets).0);
        let (values, sin, cos) = (
            S::as_mut_simd_f64s(&mut self.values).0,
            S::as_mut_simd_f64s(&mut self.sin).0,
            S::as_mut_simd_f64s(&mut self.cos).0,
        );
        let limit = simd.splat_f64s(lanes::MAX_REDUCED);
        let mut small = true;
        for register in 0..PACK / S::F64_LANES {
            let at = register * S::F64_LANES;
            let q = q
                .get(at..q.len().min(at + S::F64_LANES))
                .unwrap_or_default();
            let full = |value| Lanes { simd, value };
            let value = full(simd.partial_load_f64s(q))
                .mul_add(full(factors[register]), full(offsets[register]));
            let in_range = simd.less_than_f64s(lanes::magnitude(simd, value.value), limit);
            small &= lanes::all_true(simd, in_range);
            let turn = lanes::sin_cos(value);
            values[register] = value.value;
            sin[register] = turn.sin.value;
            cos[register] = turn.cos.value;
        }
        small || self.by_the_standard_library()
    }

    #[cold]
    #[inline(never)]
    fn by_the_standard_library(&mut self) -> bool {
        for lane in 0..PACK {
            (self.sin[lane], self.cos[lane]) = self.values[lane].sin_cos();
        }
        self.values.iter().all(|value| value.is_finite())
    }
}
