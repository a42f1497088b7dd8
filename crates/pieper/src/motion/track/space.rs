//! Joint space as the tracker measures it, and how far joint values miss a pose.

use nalgebra::{Matrix6, Vector3, Vector6};

use crate::error::Result;
use crate::ik::{JointVector, MAX_JOINTS};
use crate::kinematics::{self, Jacobian, Reference};
use crate::model::Chain;
use crate::spatial::Pose;

/// Newton's steps before giving up: a double root halves its error with each.
const MOST_STEPS: usize = 40;

/// Damping of Newton's method, squared: directions that move the tool less than this (squared) are left alone, so
/// that rounding there does not turn joints.
const DAMPING: f64 = 1e-14;

/// Entries of the pose within this are met: rounding of forward kinematics.
const CLOSES: f64 = 1e-12;

/// How far joint values miss a pose: metres, radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Miss {
    pub(super) position: f64,
    pub(super) angle: f64,
}

impl Miss {
    pub(super) fn within(&self, tolerance: f64) -> bool {
        self.position <= tolerance && self.angle <= tolerance
    }

    pub(super) fn max(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            angle: self.angle.max(other.angle),
        }
    }
}

/// A chain with what distances in its joint space are measured by.
#[derive(Debug)]
pub(super) struct Space<'a> {
    pub(super) chain: &'a Chain,
    pub(super) angular: Vec<bool>,
    /// The length (m) that counts as one radian.
    pub(super) extent: f64,
}

impl<'a> Space<'a> {
    pub(super) fn new(chain: &'a Chain) -> Self {
        let lengths = chain
            .joints()
            .iter()
            .map(|j| j.before.translation.vector.norm() + j.after.translation.vector.norm());
        let extent = lengths.sum::<f64>() + chain.tool().translation.vector.norm();
        let angular = chain
            .variables()
            .iter()
            .map(|variable| variable.kind.is_angular())
            .collect();
        Self {
            chain,
            angular,
            extent: if extent > 0.0 { extent } else { 1.0 },
        }
    }

    pub(super) fn dof(&self) -> usize {
        self.angular.len()
    }

    pub(super) fn vector(&self, q: &[f64]) -> JointVector {
        let mut out = [0.0; MAX_JOINTS];
        out.iter_mut().zip(q).for_each(|(to, from)| *to = *from);
        out
    }

    /// `b - a`, angles by the shortest way.
    pub(super) fn way(&self, a: &JointVector, b: &JointVector) -> JointVector {
        use std::f64::consts::TAU;
        let mut out = [0.0; MAX_JOINTS];
        for (j, &angular) in self.angular.iter().enumerate() {
            let step = b[j] - a[j];
            out[j] = match angular {
                true => step - TAU * (step / TAU).round(),
                false => step,
            };
        }
        out
    }

    /// `b`, its angles shifted by whole turns to where they are closest to `a`.
    pub(super) fn beside(&self, a: &JointVector, b: &JointVector) -> JointVector {
        add(a, &self.way(a, b), 1.0)
    }

    /// The largest entry, lengths counted in extents.
    pub(super) fn size(&self, way: &JointVector) -> f64 {
        let entries = self.angular.iter().zip(way);
        entries.fold(0.0, |most: f64, (&angular, x)| {
            let unit = if angular { 1.0 } else { self.extent };
            most.max(x.abs() / unit)
        })
    }

    pub(super) fn pose(&self, q: &JointVector) -> Result<Pose> {
        kinematics::tool_pose(self.chain, &q[..self.dof()])
    }

    /// By how much the tool misses `pose` at `q`.
    pub(super) fn miss(&self, q: &JointVector, pose: &Pose) -> Result<Miss> {
        let error = error(&self.pose(q)?, pose);
        Ok(Miss {
            position: error.fixed_rows::<3>(0).norm(),
            angle: error.fixed_rows::<3>(3).norm(),
        })
    }

    /// Joint values near `start` that reach `pose`, by Newton's method damped so that no joint turns for nothing;
    /// `None` if it does not settle.
    pub(super) fn refine(&self, start: &JointVector, pose: &Pose) -> Result<Option<JointVector>> {
        let (mut q, mut jacobian) = (*start, Jacobian::zeros(self.dof()));
        for _ in 0..MOST_STEPS {
            let at = kinematics::pose_and_jacobian(
                self.chain,
                &q[..self.dof()],
                Reference::Base,
                &mut jacobian,
            )?;
            let error = self.scaled(&error(&at, pose));
            if error.amax() <= CLOSES {
                return Ok(Some(q));
            }
            let Some(step) = self.step(&jacobian, &error) else {
                return Ok(None);
            };
            if self.size(&step) > 1.0 {
                return Ok(None);
            }
            q = add(&q, &step, 1.0);
        }
        Ok(None)
    }

    /// `J^T (J J^T + damping)^-1 error`, lengths counted in extents.
    fn step(&self, jacobian: &Jacobian, error: &Vector6<f64>) -> Option<JointVector> {
        let column = |j: usize| {
            let unit = if self.angular[j] { 1.0 } else { self.extent };
            self.scaled(&jacobian.column(j).into_owned()) * unit
        };
        let mut gram = Matrix6::from_diagonal_element(DAMPING);
        for j in 0..self.dof() {
            let column = column(j);
            gram += column * column.transpose();
        }
        let solved = gram.lu().solve(error)?;
        let mut step = [0.0; MAX_JOINTS];
        for (j, &angular) in self.angular.iter().enumerate() {
            let unit = if angular { 1.0 } else { self.extent };
            step[j] = column(j).dot(&solved) * unit;
        }
        step.iter().all(|x| x.is_finite()).then_some(step)
    }

    fn scaled(&self, twist: &Vector6<f64>) -> Vector6<f64> {
        let mut out = *twist;
        (0..3).for_each(|k| out[k] /= self.extent);
        out
    }

    /// The smallest singular value of the Jacobian, lengths counted in extents, and the unit joint motion (radians and
    /// metres) that moves the tool least. `None` for other than six joints.
    pub(super) fn idle(&self, q: &JointVector) -> Result<Option<(f64, JointVector)>> {
        if self.dof() != 6 {
            return Ok(None);
        }
        let mut jacobian = Jacobian::zeros(6);
        kinematics::pose_and_jacobian(self.chain, &q[..6], Reference::Base, &mut jacobian)?;
        let unit = |j: usize| if self.angular[j] { 1.0 } else { self.extent };
        let columns: [Vector6<f64>; 6] =
            std::array::from_fn(|j| self.scaled(&jacobian.column(j).into_owned()) * unit(j));
        let matrix = Matrix6::from_columns(&columns);
        // The product of all singular values: far from zero, none of them is small.
        let product = matrix.lu().determinant().abs();
        if product > CLEARLY_REGULAR {
            return Ok(Some((product, [0.0; MAX_JOINTS])));
        }
        let Some(svd) = matrix.try_svd(false, true, f64::EPSILON, 1000) else {
            return Ok(None);
        };
        let (index, least) = svd.singular_values.argmin();
        let mut way = [0.0; MAX_JOINTS];
        if let Some(v_t) = svd.v_t {
            (0..6).for_each(|j| way[j] = v_t[(index, j)] * unit(j));
        }
        let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
        way.iter_mut()
            .for_each(|x| *x /= length.max(f64::MIN_POSITIVE));
        Ok(Some((least, way)))
    }
}

impl Space<'_> {
    /// Two joints that turn about one line, if there are two: the unit joint motion that turns them against each other,
    /// by which the tool stays where it is however far it goes.
    pub(super) fn twins(&self, q: &JointVector) -> Result<Option<JointVector>> {
        let mut jacobian = Jacobian::zeros(self.dof());
        kinematics::pose_and_jacobian(
            self.chain,
            &q[..self.dof()],
            Reference::Base,
            &mut jacobian,
        )?;
        let turning = |&j: &usize| self.angular[j];
        for i in (0..self.dof()).filter(turning) {
            for k in (i + 1..self.dof()).filter(turning) {
                let (a, b) = (
                    self.scaled(&jacobian.column(i).into_owned()),
                    self.scaled(&jacobian.column(k).into_owned()),
                );
                let ratio = a.dot(&b) / b.norm_squared();
                if ratio.is_finite() && (a - b * ratio).norm() < ONE_LINE * a.norm() {
                    let mut free = [0.0; MAX_JOINTS];
                    let length = ratio.hypot(1.0);
                    (free[i], free[k]) = (1.0 / length, -ratio / length);
                    return Ok(Some(free));
                }
            }
        }
        Ok(None)
    }
}

/// Two axes whose directions (rad) and places (extents) differ by less than this are one line.
const ONE_LINE: f64 = 1e-7;

/// A determinant of the scaled Jacobian above this leaves no singular value near the smallest that matter (its largest
/// five multiply to at most some ten).
const CLEARLY_REGULAR: f64 = 1e-5;

/// `a + share * way`
pub(super) fn add(a: &JointVector, way: &JointVector, share: f64) -> JointVector {
    let mut out = *a;
    out.iter_mut().zip(way).for_each(|(x, y)| *x += share * y);
    out
}

/// `b - a` as it stands, whole turns included.
pub(super) fn minus(b: &JointVector, a: &JointVector) -> JointVector {
    add(b, a, -1.0)
}

pub(super) fn dot(a: &JointVector, b: &JointVector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The twist (m, rad; base axes) from one pose to another.
fn error(from: &Pose, to: &Pose) -> Vector6<f64> {
    let shift = to.translation.vector - from.translation.vector;
    let turn = to.rotation.matrix() * from.rotation.matrix().transpose();
    let axis = Vector3::new(
        turn[(2, 1)] - turn[(1, 2)],
        turn[(0, 2)] - turn[(2, 0)],
        turn[(1, 0)] - turn[(0, 1)],
    ) * 0.5;
    let sine = axis.norm();
    let angle = sine.atan2((turn.trace() - 1.0) * 0.5);
    let turn = if sine > 0.0 {
        axis * (angle / sine)
    } else {
        axis
    };
    Vector6::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
}
