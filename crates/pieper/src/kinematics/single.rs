//! One pose as fast as it goes: all sines and cosines in one vector call, a column of the frame in one register.

use super::kernel::{Column, Frame, Turn};
use crate::model::{Canonical, LinkShape, Step};
use crate::spatial::Pose;

/// Runs the chain's product from its base; `visit` sees each step with the frame whose z is the step's axis.
#[inline(always)]
pub(super) fn run<C: Column>(
    canonical: &Canonical,
    mut frame: Frame<C>,
    lift: impl Fn(f64) -> C::Scalar + Copy,
    mut motion: impl FnMut(usize, &Step) -> Moved<C::Scalar>,
    mut visit: impl FnMut(&Step, &Frame<C>),
) -> Frame<C> {
    for (index, step) in canonical.steps.iter().enumerate() {
        visit(step, &frame);
        match motion(index, step) {
            Moved::Turned(turn) => frame.turn_z(&turn),
            Moved::Slid(by) => frame.shift_z(&by),
        }
        append_link(&mut frame, &step.link, lift);
    }
    if let Some(tail) = &canonical.tail {
        frame.append(&rows_of(tail, lift));
    }
    frame
}

/// What a joint did.
pub(super) enum Moved<S> {
    /// Turned by the angle with this sine and cosine.
    Turned(Turn<S>),
    /// Slid by this length.
    Slid(S),
}

#[inline(always)]
fn append_link<C: Column>(
    frame: &mut Frame<C>,
    link: &LinkShape,
    lift: impl Fn(f64) -> C::Scalar + Copy,
) {
    match link {
        LinkShape::General(pose) => frame.append(&rows_of(pose, lift)),
        LinkShape::Dh {
            theta,
            d,
            a,
            alpha,
            quarters,
        } => {
            if theta.0 != 0.0 || theta.1 != 1.0 {
                frame.turn_z(&Turn {
                    sin: lift(theta.0),
                    cos: lift(theta.1),
                });
            }
            if *d != 0.0 {
                frame.shift_z(&lift(*d));
            }
            if *a != 0.0 {
                frame.shift_x(&lift(*a));
            }
            match quarters {
                Some(quarters) => frame.turn_x_quarters(*quarters),
                None => frame.turn_x(&Turn {
                    sin: lift(alpha.0),
                    cos: lift(alpha.1),
                }),
            }
        }
    }
}

#[inline(always)]
fn rows_of<S>(pose: &Pose, lift: impl Fn(f64) -> S) -> [[S; 4]; 3] {
    let (m, t) = (pose.rotation.matrix(), &pose.translation.vector);
    let row = |i: usize| {
        [
            lift(m[(i, 0)]),
            lift(m[(i, 1)]),
            lift(m[(i, 2)]),
            lift(t[i]),
        ]
    };
    [row(0), row(1), row(2)]
}

/// Where the product starts, in plain numbers.
pub(super) fn base_frame(pose: &Pose) -> Frame<[f64; 3]> {
    let m = pose.rotation.matrix();
    let column = |j: usize| [m[(0, j)], m[(1, j)], m[(2, j)]];
    Frame {
        x: column(0),
        y: column(1),
        z: column(2),
        p: pose.translation.vector.into(),
    }
}

/// A frame in plain numbers as a pose.
#[inline(always)]
pub(super) fn pose_of(frame: &Frame<[f64; 3]>) -> Pose {
    let columns = [frame.x, frame.y, frame.z].map(nalgebra::Vector3::from);
    let matrix = nalgebra::Matrix3::from_columns(&columns);
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(matrix);
    Pose::from_parts(frame.p.into(), rotation)
}

/// The product in plain numbers, with the standard library's sine and cosine: works everywhere.
pub(super) fn tool_frame_plain(
    canonical: &Canonical,
    displacement: impl Fn(&Step) -> f64,
    visit: impl FnMut(&Step, &Frame<[f64; 3]>),
) -> Frame<[f64; 3]> {
    let motion = |_: usize, step: &Step| {
        let displacement = displacement(step);
        if step.turns {
            let (sin, cos) = displacement.sin_cos();
            Moved::Turned(Turn { sin, cos })
        } else {
            Moved::Slid(displacement)
        }
    };
    run(canonical, base_frame(&canonical.base), |x| x, motion, visit)
}

/// What a caller wants of the frames before each joint: the axis and a point on it.
pub(super) trait Record {
    /// Called for each step, base to tool.
    fn axis(&mut self, step: &Step, direction: [f64; 3], point: [f64; 3]);
}

/// Wants nothing.
pub(super) struct Nothing;

impl Record for Nothing {
    #[inline(always)]
    fn axis(&mut self, _: &Step, _: [f64; 3], _: [f64; 3]) {}
}

/// The tool's pose by the fastest way this processor has; `record` sees the axes.
#[inline(always)]
pub(super) fn tool_pose(canonical: &Canonical, q: &[f64], record: &mut impl Record) -> Pose {
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return avx2::tool_pose(simd, canonical, q, record);
    }
    let visit = |step: &Step, frame: &Frame<[f64; 3]>| record.axis(step, frame.z, frame.p);
    pose_of(&tool_frame_plain(
        canonical,
        |step| step.drive.displacement(q),
        visit,
    ))
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use pulp::x86::V3;
    use pulp::{Simd, f64x4};

    use super::super::lanes::{self, Lanes};
    use super::{Moved, Record, run};
    use crate::kinematics::kernel::{Column, Frame, Turn};
    use crate::model::{Canonical, Step};
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

        #[inline(always)]
        fn array(self) -> [f64; 3] {
            let f64x4(x, y, z, _) = self.value;
            [x, y, z]
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
                value: self.simd.neg_f64s(self.value),
                ..*self
            }
        }
    }

    /// Steps whose sines and cosines are computed in one go.
    const CHUNK: usize = 8;

    struct Call<'a, R> {
        simd: V3,
        canonical: &'a Canonical,
        q: &'a [f64],
        record: &'a mut R,
    }

    pub(super) fn tool_pose(
        simd: V3,
        canonical: &Canonical,
        q: &[f64],
        record: &mut impl Record,
    ) -> Pose {
        simd.vectorize(Call {
            simd,
            canonical,
            q,
            record,
        })
    }

    impl<R: Record> pulp::NullaryFnOnce for Call<'_, R> {
        type Output = Pose;

        #[inline(always)]
        fn call(self) -> Pose {
            let Self {
                simd,
                canonical,
                q,
                record,
            } = self;
            let mut turns = Turns {
                angles: [0.0; CHUNK],
                sin: [0.0; CHUNK],
                cos: [0.0; CHUNK],
            };
            let base = super::base_frame(&canonical.base);
            let frame = Frame {
                x: Quad::new(simd, base.x),
                y: Quad::new(simd, base.y),
                z: Quad::new(simd, base.z),
                p: Quad::new(simd, base.p),
            };
            let motion = |index: usize, step: &Step| {
                if index.is_multiple_of(CHUNK) {
                    turns.fill(simd, &canonical.steps[index..], q);
                }
                let at = index % CHUNK;
                if step.turns {
                    Moved::Turned(Turn {
                        sin: turns.sin[at],
                        cos: turns.cos[at],
                    })
                } else {
                    Moved::Slid(turns.angles[at])
                }
            };
            let visit = |step: &Step, frame: &Frame<Quad>| {
                record.axis(step, frame.z.array(), frame.p.array());
            };
            let frame = run(canonical, frame, |x| x, motion, visit);
            let columns = [frame.x, frame.y, frame.z, frame.p].map(Quad::array);
            let [x, y, z, p] = columns;
            super::pose_of(&Frame { x, y, z, p })
        }
    }

    /// Displacements of a few steps, with the sines and cosines of those that turn.
    struct Turns {
        angles: [f64; CHUNK],
        sin: [f64; CHUNK],
        cos: [f64; CHUNK],
    }

    impl Turns {
        #[inline(always)]
        fn fill(&mut self, simd: V3, steps: &[Step], q: &[f64]) {
            let mut largest = 0.0_f64;
            for (angle, step) in self.angles.iter_mut().zip(steps) {
                *angle = step.drive.displacement(q);
                largest = largest.max(angle.abs());
            }
            if largest > lanes::MAX_REDUCED {
                for at in 0..CHUNK {
                    (self.sin[at], self.cos[at]) = self.angles[at].sin_cos();
                }
                return;
            }
            for at in [0, 4] {
                let [a, b, c, d] = [0, 1, 2, 3].map(|lane| self.angles[at + lane]);
                let turn = lanes::sin_cos(Lanes {
                    simd,
                    value: f64x4(a, b, c, d),
                });
                let store =
                    |to: &mut [f64], f64x4(a, b, c, d): f64x4| to.copy_from_slice(&[a, b, c, d]);
                store(&mut self.sin[at..at + 4], turn.sin.value);
                store(&mut self.cos[at..at + 4], turn.cos.value);
            }
        }
    }
}
