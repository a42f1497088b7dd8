//! One pose as fast as it goes: all sines and cosines in one vector call, a column of the frame in one register.

#[cfg(all(target_arch = "x86_64", feature = "avx2"))]
mod x86;

use nalgebra::Vector3;

use super::kernel::{Column, Frame, Turn};
use crate::error::Result;
use crate::model::{Canonical, Chain, LinkShape, Step};
use crate::spatial::Pose;

/// Runs steps of a chain's product on from `frame`; `visit` sees each step with the frame whose z is the step's axis.
#[inline(always)]
pub(super) fn run<C: Column>(
    steps: &[Step],
    mut frame: Frame<C>,
    lift: impl Fn(f64) -> C::Scalar + Copy,
    mut motion: impl FnMut(usize, &Step) -> Moved<C::Scalar>,
    mut visit: impl FnMut(&Step, &Frame<C>),
) -> Frame<C> {
    for (index, step) in steps.iter().enumerate() {
        visit(step, &frame);
        match motion(index, step) {
            Moved::Turned(turn) => frame.turn_z(&turn),
            Moved::Slid(by) => frame.shift_z(&by),
        }
        append_link(&mut frame, &step.link, lift);
    }
    frame
}

/// Appends what is left between the last step and the tool.
#[inline(always)]
pub(super) fn append_tail<C: Column>(
    frame: &mut Frame<C>,
    canonical: &Canonical,
    lift: impl Fn(f64) -> C::Scalar,
) {
    if let Some(tail) = &canonical.tail {
        frame.append(&rows_of(tail, lift));
    }
}

/// What a joint did.
pub(super) enum Moved<S> {
    /// Turned by the angle with this sine and cosine.
    Turned(Turn<S>),
    /// Slid by this length.
    Slid(S),
}

#[inline(always)]
pub(super) fn append_link<C: Column>(
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
            if let Some((sin, cos)) = *theta {
                frame.turn_z(&Turn {
                    sin: lift(sin),
                    cos: lift(cos),
                });
            }
            // Also by zero: asking costs more than the shift.
            frame.shift_z(&lift(*d));
            frame.shift_x(&lift(*a));
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
    let columns = [frame.x, frame.y, frame.z].map(Vector3::from);
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
    let mut frame = run(
        &canonical.steps,
        base_frame(&canonical.base),
        |x| x,
        motion,
        visit,
    );
    append_tail(&mut frame, canonical, |x| x);
    frame
}

/// A column in space, in plain numbers or in a register.
pub(super) trait SpaceColumn: Column<Scalar = f64> {
    /// `self x other`
    fn cross(&self, other: &Self) -> Self;

    /// `self - other`
    fn minus(&self, other: &Self) -> Self;

    /// The column as a register is stored: three numbers and one of no meaning.
    fn padded(&self) -> [f64; 4];

    /// Three numbers as a column like this one.
    fn load(&self, from: &[f64; 3]) -> Self;

    /// The column as three numbers.
    fn store(&self) -> [f64; 3];
}

impl SpaceColumn for [f64; 3] {
    #[inline(always)]
    fn cross(&self, other: &Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self, other);
        [b * z - c * y, c * x - a * z, a * y - b * x]
    }

    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        [self[0] - other[0], self[1] - other[1], self[2] - other[2]]
    }

    #[inline(always)]
    fn padded(&self) -> [f64; 4] {
        [self[0], self[1], self[2], 0.0]
    }

    #[inline(always)]
    fn load(&self, from: &[f64; 3]) -> Self {
        *from
    }

    #[inline(always)]
    fn store(&self) -> [f64; 3] {
        *self
    }
}

/// The velocity that a step's variable gives the base's origin, at rate 1, and its angular velocity.
///
/// Adds up over several steps of one variable; at another point p it is `v + omega x p`.
pub(super) fn moment<C: SpaceColumn>(
    step: &Step,
    frame: &Frame<C>,
) -> (Vector3<f64>, Vector3<f64>) {
    let z = Vector3::from(frame.z.store()) * step.drive.factor;
    if !step.turns {
        return (z, Vector3::zeros());
    }
    (Vector3::from(frame.p.store()).cross(&z), z)
}

/// What a caller wants of the frames along the chain.
pub(super) trait Record {
    /// Called for each step, base to tool, with the frame whose z is the step's axis.
    fn axis<C: SpaceColumn>(&mut self, step: &Step, frame: &Frame<C>);

    /// Called last, with the tool's frame.
    fn tool<C: SpaceColumn>(&mut self, frame: &Frame<C>);
}

/// Wants nothing.
pub(super) struct Nothing;

impl Record for Nothing {
    #[inline(always)]
    fn axis<C: SpaceColumn>(&mut self, _: &Step, _: &Frame<C>) {}

    #[inline(always)]
    fn tool<C: SpaceColumn>(&mut self, _: &Frame<C>) {}
}

/// The tool's pose by the fastest way this processor has; `record` sees the axes.
///
/// The result is made where it is wanted: a copy of a pose that was just stored waits for the store.
///
/// # Errors
/// An input error unless `q` has one value for each variable and every displacement is finite.
#[inline(always)]
pub(super) fn tool_pose(chain: &Chain, q: &[f64], record: &mut impl Record) -> Result<Pose> {
    chain.check_joint_count(q)?;
    #[cfg(all(target_arch = "x86_64", feature = "avx512"))]
    if let Some(simd) = pulp::x86::V4::try_new() {
        return x86::tool_pose(simd, *simd, chain, q, record);
    }
    #[cfg(all(target_arch = "x86_64", feature = "avx2"))]
    if let Some(simd) = pulp::x86::V3::try_new() {
        return x86::tool_pose(simd, simd, chain, q, record);
    }
    let canonical = chain.canonical();
    let displacement = |step: &Step| step.drive.displacement(q);
    if !canonical
        .steps
        .iter()
        .all(|step| displacement(step).is_finite())
    {
        return Err(chain.not_finite_error(q));
    }
    let frame = tool_frame_plain(canonical, displacement, |step, frame| {
        record.axis(step, frame)
    });
    record.tool(&frame);
    Ok(pose_of(&frame))
}
