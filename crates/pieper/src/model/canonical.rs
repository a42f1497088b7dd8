//! The chain as kernels and solvers want it: every motion about or along z, every link constant.

mod names;
mod ortho;

use nalgebra::{Matrix3, Rotation3, UnitVector3, Vector3};

use super::chain::ChainParts;
use super::joint::{Drive, Motion};
use crate::error::{Error, Result};
use crate::spatial::{self, Pose, Quarters};

pub(crate) use names::{Names, StepRow};
pub(crate) use ortho::Ortho;

/// `base_from_tool = base * Z_1(q) L_1 * Z_2(q) L_2 * ... * Z_m(q) L_m * tail`.
///
/// `Z_i` turns about or slides along z by `offset + factor * q[variable]`; `L_i` is constant. Equal to the
/// chain's own product to rounding, and to the last bit for a Denavit-Hartenberg table, whose rows are the steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Canonical {
    /// From the world to the first axis.
    pub base: Pose,
    /// One step for each joint that moves, base to tool.
    pub steps: Vec<Step>,
    /// What is left between the last link and the tool; `None` where it is the identity.
    pub tail: Option<Pose>,
    packed: PackedDrives,
    ortho: Option<Ortho>,
}

/// The drives of all steps as arrays that vector instructions load, padded with zeros to a multiple of [`PACK`].
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PackedDrives {
    pub(crate) factors: Vec<[f64; PACK]>,
    pub(crate) offsets: Vec<[f64; PACK]>,
    /// Whether step `i` is driven by variable `i` throughout: then `q` itself can be loaded.
    pub(crate) in_order: bool,
}

/// Drives in one pack: the lanes of the widest register.
pub(crate) const PACK: usize = 8;

impl PackedDrives {
    fn of(steps: &[Step]) -> Self {
        let pack = |value: fn(&Drive) -> f64| {
            let chunk = |chunk: &[Step]| {
                std::array::from_fn(|lane| chunk.get(lane).map_or(0.0, |step| value(&step.drive)))
            };
            steps.chunks(PACK).map(chunk).collect()
        };
        Self {
            factors: pack(|drive| drive.factor),
            offsets: pack(|drive| drive.offset),
            in_order: steps
                .iter()
                .enumerate()
                .all(|(index, step)| step.drive.variable == index),
        }
    }
}

/// One moving joint and the link behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Whether the joint turns about z; otherwise it slides along z.
    pub turns: bool,
    /// The displacement as a function of the joint vector.
    pub drive: Drive,
    /// The link behind the joint.
    pub link: LinkShape,
}

/// A link, in the cheapest form that expresses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkShape {
    /// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`; theta is 0 behind a joint that turns.
    Dh {
        /// Sine and cosine of theta; `None` where theta is 0.
        theta: Option<(f64, f64)>,
        /// Shift along z, metres.
        d: f64,
        /// Shift along the turned x, metres.
        a: f64,
        /// Sine and cosine of alpha.
        alpha: (f64, f64),
        /// Alpha as a multiple of a right angle, where it is one exactly: kernels then swap columns.
        quarters: Option<Quarters>,
    },
    /// Any rigid motion: axes that are nearly, but not exactly, parallel have no well-conditioned `d`.
    General(Pose),
}

impl LinkShape {
    /// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`, angles by sine and cosine.
    fn dh(theta: (f64, f64), d: f64, a: f64, alpha: (f64, f64)) -> Self {
        Self::Dh {
            theta: (theta != (0.0, 1.0)).then_some(theta),
            d,
            a,
            alpha,
            quarters: Quarters::of(alpha.0, alpha.1),
        }
    }

    /// The link as a pose.
    pub fn pose(&self) -> Pose {
        match *self {
            Self::General(pose) => pose,
            Self::Dh {
                theta,
                d,
                a,
                alpha: (sa, ca),
                ..
            } => {
                let (st, ct) = theta.unwrap_or((0.0, 1.0));
                let m = Matrix3::new(ct, -st * ca, st * sa, st, ct * ca, -ct * sa, 0.0, sa, ca);
                let rotation = Rotation3::from_matrix_unchecked(m);
                Pose::from_parts(Vector3::new(a * ct, a * st, d).into(), rotation)
            }
        }
    }
}

/// Below this sine of the angle between neighbouring axes the common normal is ill-conditioned: a Denavit-Hartenberg
/// `d` would magnify rounding by its reciprocal.
const MIN_SINE: f64 = 0.1;

/// Entries of a rotation below this are rounding of an exact zero.
const DUST: f64 = 4.0 * f64::EPSILON;

impl Canonical {
    /// The canonical form of a chain's parts.
    pub(super) fn of(parts: &ChainParts) -> Self {
        let (base, raw) = about_z(parts);
        let mut steps: Vec<Step> = Vec::with_capacity(raw.len());
        let mut carried = Pose::identity();
        for (turns, mut drive, link) in raw {
            let (shape, rest) = split(turns, &mut drive, &(carried * link), MIN_SINE);
            steps.push(Step {
                turns,
                drive,
                link: shape,
            });
            carried = rest;
        }
        let tail = (carried != Pose::identity()).then_some(carried);
        let packed = PackedDrives::of(&steps);
        let mut canonical = Self {
            base,
            steps,
            tail,
            packed,
            ortho: None,
        };
        canonical.ortho = Ortho::of(&canonical);
        canonical
    }

    /// The arm as one with a spherical wrist behind two parallel axes, if it is of that kind.
    pub(crate) fn ortho(&self) -> Option<&Ortho> {
        self.ortho.as_ref()
    }

    pub(crate) fn packed(&self) -> &PackedDrives {
        &self.packed
    }

    /// The constant link behind step `index`; the last one includes the tail.
    pub fn link(&self, index: usize) -> Pose {
        let link = self.steps[index].link.pose();
        match self.tail {
            Some(tail) if index + 1 == self.steps.len() => link * tail,
            _ => link,
        }
    }
}

/// The chain as Denavit-Hartenberg rows throughout: `base * rows * tail`.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// From the world to the first axis.
    pub base: Pose,
    /// One row for each joint that moves.
    pub rows: Vec<Row>,
    /// What is left between the last row and the tool.
    pub tail: Pose,
}

/// One standard Denavit-Hartenberg row, in numbers. The drive's displacement adds to theta or to d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Whether the joint turns about z; otherwise it slides along z.
    pub turns: bool,
    /// The displacement as a function of the joint vector.
    pub drive: Drive,
    /// Constant turn about z; 0 for a joint that turns.
    pub theta: f64,
    /// Constant shift along z.
    pub d: f64,
    /// Shift along x.
    pub a: f64,
    /// Turn about x.
    pub alpha: f64,
}

impl Canonical {
    /// The chain as Denavit-Hartenberg rows, also where the common normal is ill-conditioned.
    ///
    /// # Errors
    /// A model error for neighbouring axes that are parallel only almost: closer than 1e-7 rad.
    pub fn to_rows(&self) -> Result<Rows> {
        let mut rows = Vec::with_capacity(self.steps.len());
        let mut carried = Pose::identity();
        for (index, step) in self.steps.iter().enumerate() {
            let mut drive = step.drive;
            let link = carried * step.link.pose();
            let (shape, rest) = split(step.turns, &mut drive, &link, MIN_SINE_ROWS);
            let LinkShape::Dh {
                theta, d, a, alpha, ..
            } = shape
            else {
                let pair = format!("axes {} and {}", index + 1, index + 2);
                return Err(Error::model(
                    pair,
                    "they are parallel only almost: no table expresses that",
                ));
            };
            let angle = |(sin, cos): (f64, f64)| spatial::snap(sin.atan2(cos));
            let (theta, alpha) = (theta.map_or(0.0, angle), angle(alpha));
            rows.push(Row {
                turns: step.turns,
                drive,
                theta,
                d,
                a,
                alpha,
            });
            carried = rest;
        }
        let tail = carried * self.tail.unwrap_or_else(Pose::identity);
        Ok(Rows {
            base: self.base,
            rows,
            tail,
        })
    }
}

/// Below this sine a table would place its frames beyond ten million times the arm's size.
const MIN_SINE_ROWS: f64 = 1e-7;

/// Every motion turned to z: the base, and (turns, drive, constant pose up to the next axis) for each moving joint.
fn about_z(parts: &ChainParts) -> (Pose, Vec<(bool, Drive, Pose)>) {
    let mut base = parts.base;
    let mut steps: Vec<(bool, Drive, Pose)> = Vec::new();
    let append = |steps: &mut Vec<(bool, Drive, Pose)>, base: &mut Pose, pose: &Pose| {
        let end = steps.last_mut().map_or(base, |step| &mut step.2);
        *end *= pose;
    };
    for joint in &parts.joints {
        append(&mut steps, &mut base, &joint.before);
        if let (Some(axis), Some(&drive)) = (joint.motion.axis(), joint.motion.drive()) {
            let (frame, sign) = frame_on(axis);
            let drive = Drive {
                factor: sign * drive.factor,
                offset: sign * drive.offset,
                ..drive
            };
            append(&mut steps, &mut base, &frame);
            steps.push((
                matches!(joint.motion, Motion::Turn(..)),
                drive,
                frame.inverse(),
            ));
        }
        append(&mut steps, &mut base, &joint.after);
    }
    append(&mut steps, &mut base, &parts.tool);
    (base, steps)
}

/// A frame whose z lies on `axis` times the sign; exact where the axis is a coordinate axis.
fn frame_on(axis: &UnitVector3<f64>) -> (Pose, f64) {
    let from = |x: Vector3<f64>, y: Vector3<f64>, z: Vector3<f64>| {
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, z]));
        Pose::from_parts(Vector3::zeros().into(), rotation)
    };
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    let u = axis.into_inner();
    for (unit, frame) in [(z, from(x, y, z)), (x, from(y, z, x)), (y, from(z, x, y))] {
        if u == unit {
            return (frame, 1.0);
        }
        if u == -unit {
            return (frame, -1.0);
        }
    }
    let side = u.cross(&if u.x.abs() < 0.5 { x } else { y }).normalize();
    (from(side, u.cross(&side), u), 1.0)
}

/// Splits `link` into a shape and a rest `Rz Tz` that commutes with the next motion; a turn about z in front of the
/// shape goes into the drive's offset of a joint that turns.
fn split(turns: bool, drive: &mut Drive, link: &Pose, min_sine: f64) -> (LinkShape, Pose) {
    let m = link.rotation.matrix();
    let t = link.translation.vector;
    let direction = m.column(2).into_owned();
    let sine = direction.x.hypot(direction.y);
    if is_dh(link) {
        let shape = LinkShape::dh((0.0, 1.0), t.z, t.x, (m[(2, 1)], m[(2, 2)]));
        return (shape, Pose::identity());
    }
    let (theta, d, along) = if sine <= DUST {
        (t.y.atan2(t.x), t.z, 0.0)
    } else if sine < min_sine {
        return (LinkShape::General(*link), Pose::identity());
    } else {
        let theta = direction.x.atan2(-direction.y);
        let (sin, cos) = spatial::sin_cos_exact(theta);
        let along = -(cos * t.y - sin * t.x) / sine;
        (theta, t.z - along * direction.z, along)
    };
    let (sin, cos) = spatial::sin_cos_exact(theta);
    let a = cos * t.x + sin * t.y;
    let alpha = if sine <= DUST {
        (0.0, direction.z.signum())
    } else {
        (sine, direction.z)
    };
    let shape = LinkShape::dh((sin, cos), d, a, alpha);
    let mut rest = Pose::from_parts(
        Vector3::zeros().into(),
        shape.pose().rotation.inverse() * link.rotation,
    );
    clean_turn(&mut rest);
    rest.translation.vector.z = along;
    if !turns {
        return (shape, rest);
    }
    drive.offset = spatial::snap(drive.offset + theta);
    (LinkShape::dh((0.0, 1.0), d, a, alpha), rest)
}

/// Whether the link is `Tz(d) Tx(a) Rx(alpha)` to the last bit.
fn is_dh(link: &Pose) -> bool {
    let m = link.rotation.matrix();
    link.translation.vector.y == 0.0
        && m[(0, 0)] == 1.0
        && [(0, 1), (0, 2), (1, 0), (2, 0)]
            .iter()
            .all(|&entry| m[entry] == 0.0)
}

/// Makes a rotation that is about z up to rounding exactly so.
fn clean_turn(pose: &mut Pose) {
    let m = pose.rotation.matrix();
    let angle = m[(1, 0)].atan2(m[(0, 0)]);
    *pose = spatial::turn(&Vector3::z_axis(), spatial::sin_cos_exact(angle));
}
