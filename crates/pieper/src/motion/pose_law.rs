//! A motion through tool poses.

use nalgebra::{Rotation3, UnitQuaternion, Vector3};

use super::profile::Profile;
use crate::error::{Error, Result};
use crate::spatial::Pose;

/// Two rows whose orientations differ by half a turn within this (rad) leave open which way round the tool turns.
const HALF_TURN: f64 = 1e-7;

/// The tool's pose as a function of time: through given poses at given times.
///
/// Between two rows the tool's point moves on the straight line, and the tool turns about one fixed axis by the
/// smaller angle (the shortest great circle of unit quaternions); both with the same [`Profile`] of time.
///
/// ```
/// use nalgebra::Vector3;
/// use pieper::motion::{PoseLaw, Profile};
/// use pieper::spatial::{from_xyz_rpy, Pose};
/// let rows = vec![from_xyz_rpy([0.0; 3], [0.0; 3]), from_xyz_rpy([0.2, 0.0, 0.0], [0.0, 0.0, 1.0])];
/// let law = PoseLaw::new(vec![0.0, 2.0], rows, Profile::Linear)?;
/// let half = law.at(1.0);
/// assert!((half.translation.vector - Vector3::new(0.1, 0.0, 0.0)).norm() < 1e-15);
/// assert!((half.rotation.scaled_axis() - Vector3::new(0.0, 0.0, 0.5)).norm() < 1e-15);
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PoseLaw {
    times: Vec<f64>,
    poses: Vec<Pose>,
    /// From each row to the next: the turn as axis times angle, in the axes of the row's tool.
    turns: Vec<Vector3<f64>>,
    profile: Profile,
}

impl PoseLaw {
    /// A motion that is at `poses[k]` at `times[k]`.
    ///
    /// # Errors
    /// An input error unless there is at least one pose, one for each time, times rise, and all numbers are finite;
    /// and where the orientations of neighbouring rows differ by half a turn: either way round would be as short, so
    /// a row between the two has to say which is meant.
    pub fn new(times: Vec<f64>, poses: Vec<Pose>, profile: Profile) -> Result<Self> {
        let error = |text: &str| Err(Error::input("motion", text));
        if poses.is_empty() || poses.len() != times.len() {
            return error("one pose for each time was expected");
        }
        let finite = |pose: &Pose| {
            let entries = pose.rotation.matrix().iter();
            entries
                .chain(pose.translation.vector.iter())
                .all(|x| x.is_finite())
        };
        if !(times.iter().all(|t| t.is_finite()) && poses.iter().all(finite)) {
            return error("finite numbers were expected");
        }
        if times.windows(2).any(|pair| pair[0] >= pair[1]) {
            return error("times were expected each later than the one before");
        }
        let mut turns = Vec::with_capacity(poses.len() - 1);
        for (row, pair) in poses.windows(2).enumerate() {
            let turn = turn_between(&pair[0].rotation, &pair[1].rotation);
            if std::f64::consts::PI - turn.norm() < HALF_TURN {
                let subject = format!(
                    "the rows at t = {} s and t = {} s",
                    times[row],
                    times[row + 1]
                );
                let text = "the tool turns by half a turn, and either way round is as short: a row between them was expected";
                return Err(Error::input(subject, text));
            }
            turns.push(turn);
        }
        Ok(Self {
            times,
            poses,
            turns,
            profile,
        })
    }

    /// The times of the rows.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The rows of poses.
    pub fn poses(&self) -> &[Pose] {
        &self.poses
    }

    /// The course of the moves between rows.
    pub fn profile(&self) -> Profile {
        self.profile
    }

    /// The pose at time `t`; at a row's time the row's, to the last bit. Before the first row and after the last the
    /// tool rests.
    pub fn at(&self, t: f64) -> Pose {
        let last = self.times.len() - 1;
        let after = self.times.partition_point(|&time| time <= t);
        if after == 0 || after > last {
            return self.poses[after.min(last)];
        }
        let (row, start) = (after - 1, self.times[after - 1]);
        let [share, ..] = self.profile.at((t - start) / (self.times[after] - start));
        // From the nearer end, so that both ends are met to the last bit.
        let (near, part) = if share <= 0.5 {
            (row, share)
        } else {
            (after, share - 1.0)
        };
        let way = self.poses[after].translation.vector - self.poses[row].translation.vector;
        let turn = Rotation3::from_scaled_axis(self.turns[row] * part);
        Pose::from_parts(
            (self.poses[near].translation.vector + way * part).into(),
            self.poses[near].rotation * turn,
        )
    }

    /// The length of the way (m) and the angle of the turn (rad) from row `row` to the next.
    pub(super) fn step(&self, row: usize) -> (f64, f64) {
        let way = self.poses[row + 1].translation.vector - self.poses[row].translation.vector;
        (way.norm(), self.turns[row].norm())
    }
}

/// Axis times angle of the turn from one rotation to another, in the axes of the first; at most half a turn.
fn turn_between(from: &Rotation3<f64>, to: &Rotation3<f64>) -> Vector3<f64> {
    let relative = UnitQuaternion::from_rotation_matrix(&(from.inverse() * to));
    let vector = relative.imag();
    let length = vector.norm();
    if length == 0.0 {
        return Vector3::zeros();
    }
    // Either sign of a quaternion is the same turn; the positive scalar part has the smaller angle.
    let angle = 2.0 * length.atan2(relative.w.abs());
    vector * (angle / length).copysign(relative.w)
}
