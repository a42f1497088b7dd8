//! The arm as inverse kinematics sees it: constant links about z, and the true model to verify on.

use nalgebra::{Matrix3, Vector3};

use super::angle::{is_periodic, wrap};
use super::limits;
use super::solutions::JointVector;
use crate::error::{Error, Result};
use crate::kinematics;
use crate::model::{Chain, Drive, Step, Variable};
use crate::spatial::Pose;

/// The most joints a solver takes: answers have a fixed size.
pub const MAX_JOINTS: usize = 12;

/// Columns of a Jacobian without a heap.
pub(super) type Columns = [[f64; 6]; MAX_JOINTS];

/// A chain prepared for inverse kinematics: `Z_1 L_1 Z_2 L_2 ... Z_m L_m = target`, the target seen from the first
/// axis, `Z_i` a turn about z or a slide along it by the displacement of step i.
#[derive(Clone, Debug)]
pub struct Arm {
    chain: Chain,
    links: Vec<Pose>,
    turns: Vec<bool>,
    drives: Vec<Drive>,
    first_from_world: Pose,
    size: f64,
    extent: f64,
    /// The length that counts as much as a radian; the extent, unless positions weigh more.
    scale: f64,
    plain: bool,
    periodic: [bool; MAX_JOINTS],
    bounds: [JointVector; 2],
}

impl Arm {
    /// Prepares a chain.
    ///
    /// # Errors
    /// A model error for a chain of more than [`MAX_JOINTS`] joints.
    pub(super) fn new(chain: &Chain) -> Result<Self> {
        let canonical = chain.canonical();
        let count = canonical.steps.len();
        if count > MAX_JOINTS || chain.dof() > MAX_JOINTS {
            let text =
                format!("inverse kinematics takes at most {MAX_JOINTS} joints, it has {count}");
            return Err(Error::model("chain", text));
        }
        let links: Vec<Pose> = (0..count).map(|index| canonical.link(index)).collect();
        let lengths = |links: &[Pose]| -> f64 {
            links
                .iter()
                .map(|link| link.translation.vector.norm())
                .sum()
        };
        let whole = lengths(&links);
        let travel = |variable: &Variable| match (variable.kind.is_angular(), variable.limits) {
            (true, _) => 0.0,
            (false, Some(limits)) => limits.upper() - limits.lower(),
            (false, None) => whole,
        };
        let slides: f64 = chain.variables().iter().map(travel).sum();
        let between_axes = lengths(&links[..count - 1]) + slides;
        let positive = |x: f64, other: f64| if x > 0.0 { x } else { other };
        let size = positive(between_axes, positive(whole, 1.0));
        let one_to_one = |step: &Step| step.drive.factor.abs() == 1.0 || !step.turns;
        let plain = chain.dof() == count && canonical.steps.iter().all(one_to_one);
        let extent = whole.max(size) + canonical.base.translation.vector.norm();
        Ok(Self {
            plain,
            bounds: limits::bounds(chain),
            periodic: std::array::from_fn(|j| j < chain.dof() && is_periodic(chain, j)),
            size,
            extent,
            scale: extent,
            turns: canonical.steps.iter().map(|step| step.turns).collect(),
            drives: canonical.steps.iter().map(|step| step.drive).collect(),
            first_from_world: canonical.base.inverse(),
            chain: chain.clone(),
            links,
        })
    }

    /// The same arm, in whose searches a miss of the position counts so many times more.
    pub(super) fn weighing_position(self, times: f64) -> Self {
        Self {
            scale: self.scale / times,
            ..self
        }
    }

    /// The chain.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The constant link behind each step; the last one includes the tool.
    pub fn links(&self) -> &[Pose] {
        &self.links
    }

    /// Whether each step turns (otherwise it slides).
    pub fn turns(&self) -> &[bool] {
        &self.turns
    }

    /// The number of steps: joints that move, mimics among them.
    pub fn steps(&self) -> usize {
        self.links.len()
    }

    /// The sum of the distances between axes and of the slides' ranges: what lengths are compared with.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The size with base and tool: what positions are as large as.
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Whether every step has a variable of its own; closed forms need that.
    pub fn is_independent(&self) -> bool {
        self.chain.dof() == self.steps() && self.drives.iter().all(|drive| drive.factor != 0.0)
    }

    /// The least and the greatest values within the limits, with what rounding may add; infinite where there are none.
    pub(super) fn bounds(&self) -> &[JointVector; 2] {
        &self.bounds
    }

    pub(super) fn drives(&self) -> &[Drive] {
        &self.drives
    }

    /// Whether every step has a variable of its own that counts displacements one to one, forwards or backwards.
    pub(super) fn is_plain(&self) -> bool {
        self.plain
    }

    /// A pose in the world as the target seen from the first axis.
    pub fn target(&self, pose: &Pose) -> Pose {
        self.first_from_world * pose
    }

    /// The joint vector of an independent arm with these displacements.
    #[inline]
    pub(super) fn joint_vector(&self, displacements: &[f64]) -> JointVector {
        let mut q = [0.0; MAX_JOINTS];
        for ((drive, &value), &turns) in self.drives.iter().zip(displacements).zip(&self.turns) {
            let moved = value - drive.offset;
            q[drive.variable] = if !turns {
                moved / drive.factor
            } else if drive.factor.abs() == 1.0 {
                wrap(moved * drive.factor)
            } else {
                wrap(moved) / drive.factor
            };
        }
        q
    }

    /// Wraps the angles of a joint vector.
    pub(super) fn wrap(&self, q: &mut JointVector) {
        let dof = self.chain.dof();
        for (value, &periodic) in q[..dof].iter_mut().zip(&self.periodic) {
            if periodic {
                *value = wrap(*value);
            }
        }
    }

    /// Whether a whole turn of a variable changes nothing.
    pub(super) fn is_periodic(&self, variable: usize) -> bool {
        self.periodic[variable]
    }

    /// The pose at `q`.
    #[inline]
    pub(super) fn pose(&self, q: &JointVector) -> Pose {
        // The joint vector has the chain's length and is finite: there is no error to hand on.
        kinematics::tool_pose(&self.chain, &q[..self.chain.dof()])
            .unwrap_or_else(|_| crate::spatial::shift(Vector3::repeat(f64::NAN)))
    }

    /// The pose at `q` and the columns of the geometric Jacobian of the tool point, in the world's axes.
    ///
    /// Lengths are divided by the arm's extent, and a sliding joint is counted in extents, so that all entries are
    /// comparable.
    #[inline]
    pub(super) fn pose_and_columns(&self, q: &JointVector, columns: &mut Columns) -> Pose {
        let dof = self.chain.dof();
        let (q, columns) = (&q[..dof], &mut columns[..dof]);
        let Ok(pose) = kinematics::pose_and_columns(&self.chain, q, columns) else {
            // The joint vector has the chain's length: a value is not finite.
            return crate::spatial::shift(Vector3::repeat(f64::NAN));
        };
        for (column, variable) in columns.iter_mut().zip(self.chain.variables()) {
            let scales = if variable.kind.is_angular() {
                [1.0 / self.scale, 1.0]
            } else {
                [self.extent / self.scale, self.extent]
            };
            for i in 0..3 {
                column[i] *= scales[0];
                column[i + 3] *= scales[1];
            }
        }
        pose
    }

    /// One unit of a variable as the columns count it.
    pub(super) fn unit(&self, variable: usize) -> f64 {
        if self.chain.variables()[variable].kind.is_angular() {
            1.0
        } else {
            self.extent
        }
    }

    /// What is missing from `pose` to `target`: position in extents, then the rotation vector.
    pub(super) fn missing(&self, pose: &Pose, target: &Pose) -> [f64; 6] {
        let step = (target.translation.vector - pose.translation.vector) / self.scale;
        let turn = rotation_between(pose.rotation.matrix(), target.rotation.matrix());
        [step.x, step.y, step.z, turn.x, turn.y, turn.z]
    }
}

/// The angle between two orientations.
pub(super) fn angle_between(from: &Matrix3<f64>, to: &Matrix3<f64>) -> f64 {
    // Of the relative rotation: the length of its skew part is twice the sine, its trace one more than twice the cosine.
    let relative = from.transpose() * to;
    let skew = relative - relative.transpose();
    let sine = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]).norm();
    sine.atan2(relative.trace() - 1.0)
}

/// The rotation vector, in the common outer frame, that turns `from` into `to`.
pub(super) fn rotation_between(from: &Matrix3<f64>, to: &Matrix3<f64>) -> Vector3<f64> {
    let column = |m: &Matrix3<f64>, j: usize| m.column(j).into_owned();
    let sine: Vector3<f64> = (0..3)
        .map(|j| column(from, j).cross(&column(to, j)))
        .sum::<Vector3<f64>>()
        * 0.5;
    let cosine = (from.dot(to) - 1.0) * 0.5;
    let length = sine.norm();
    if cosine > 0.9 {
        // Up to 26 degrees the sine serves, corrected to third order: exact at zero, where it matters.
        return sine * (1.0 + length * length / 6.0);
    }
    let angle = length.atan2(cosine);
    if length > 1e-9 {
        return sine * (angle / length);
    }
    // A half turn: any of its axes serves as a direction to go on.
    let axis = (to * from.transpose() + Matrix3::identity())
        .column(0)
        .into_owned();
    axis.try_normalize(1e-3).unwrap_or_else(Vector3::y) * angle
}

/// The largest absolute entry of `pose - target`: (rotation part, position part).
#[inline]
pub(super) fn residuals(pose: &Pose, target: &Pose) -> (f64, f64) {
    let turn = pose.rotation.matrix() - target.rotation.matrix();
    let shift = pose.translation.vector - target.translation.vector;
    let largest = |entries: &[f64]| {
        // `max` would swallow a NaN; a sum of the two does not.
        entries.iter().fold(
            0.0_f64,
            |most, x| {
                if x.abs() <= most { most } else { x.abs() }
            },
        )
    };
    (largest(turn.as_slice()), largest(shift.as_slice()))
}
