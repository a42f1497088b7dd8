//! What was seen of the tool, as residuals and rates.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::sense::Sensed;
use crate::describe::{Measurement, Seen};

impl Seen {
    /// The number of residuals.
    pub fn count(&self) -> usize {
        match self {
            Self::Pose(_) => 6,
            Self::Position { .. } | Self::Contact { .. } => 3,
            Self::Distance { .. } | Self::Plane { .. } => 1,
        }
    }

    /// The kind and the name of what else is estimated with it: three numbers.
    pub(super) fn set(&self) -> Option<(&'static str, &str)> {
        match self {
            Self::Pose(_) | Self::Position { .. } => None,
            Self::Distance { anchor, .. } => Some(("anchor", anchor)),
            Self::Plane { plane, .. } => Some(("plane", plane)),
            Self::Contact { contact, .. } => Some(("contact", contact)),
        }
    }

    /// All its lengths.
    pub(super) fn lengths(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.at().iter().copied().collect();
        match self {
            Self::Pose(pose) => all.extend(pose.translation.vector.iter()),
            Self::Position { point, .. } => all.extend(point),
            Self::Distance { distance, .. } => all.push(*distance),
            Self::Plane { .. } | Self::Contact { .. } => {}
        }
        all
    }

    /// The point of the tool that is looked at.
    pub(super) fn at(&self) -> Vector3<f64> {
        match self {
            Self::Pose(_) => Vector3::zeros(),
            Self::Position { at, .. }
            | Self::Distance { at, .. }
            | Self::Plane { at, .. }
            | Self::Contact { at, .. } => Vector3::from(*at),
        }
    }
}

/// A residual and its rates: by the model's parameters, and by the set's three numbers.
pub(super) struct Row {
    pub(super) value: f64,
    pub(super) by_model: Vec<f64>,
    pub(super) by_set: [f64; 3],
}

impl Measurement {
    /// The residuals in standard deviations, with the set's numbers: an anchor's or contact's place; a plane's offset from the origin
    /// and two slopes against its normal at the start.
    pub(super) fn rows(&self, sensed: &Sensed, set: &[f64; 3], normal: &Vector3<f64>) -> Vec<Row> {
        let tool = &sensed.tool;
        let at = tool.rotation * self.seen.at();
        let point = tool.translation.vector + at;
        // How the point moves with each parameter.
        let rates: Vec<Vector3<f64>> = sensed
            .rates
            .iter()
            .map(|[turn, shift]| shift + turn.cross(&at))
            .collect();
        let along = |direction: Vector3<f64>, value: f64, by_set: [f64; 3]| Row {
            value: value / self.sigma,
            by_model: rates
                .iter()
                .map(|rate| direction.dot(rate) / self.sigma)
                .collect(),
            by_set: by_set.map(|x| x / self.sigma),
        };
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        match &self.seen {
            Seen::Pose(pose) => {
                let off = point - pose.translation.vector;
                let mut rows: Vec<Row> = axes
                    .iter()
                    .map(|e| along(*e, e.dot(&off), [0.0; 3]))
                    .collect();
                let turn = rotation_vector(&(tool.rotation * pose.rotation.inverse()));
                let inverse = inverse_left_jacobian(&turn);
                for axis in 0..3 {
                    let by =
                        |[rate, _]: &[Vector3<f64>; 2]| (inverse * rate)[axis] / self.sigma_angle;
                    rows.push(Row {
                        value: turn[axis] / self.sigma_angle,
                        by_model: sensed.rates.iter().map(by).collect(),
                        by_set: [0.0; 3],
                    });
                }
                rows
            }
            Seen::Position { point: there, .. } => {
                let off = point - Vector3::from(*there);
                axes.iter()
                    .map(|e| along(*e, e.dot(&off), [0.0; 3]))
                    .collect()
            }
            Seen::Contact { .. } => {
                let off = point - Vector3::from(*set);
                let row = |e: &Vector3<f64>| along(*e, e.dot(&off), [-e.x, -e.y, -e.z]);
                axes.iter().map(row).collect()
            }
            Seen::Distance { distance, .. } => {
                let way = point - Vector3::from(*set);
                let length = way.norm();
                // At the anchor itself no direction is better than another.
                let direction = if length > 0.0 {
                    way / length
                } else {
                    Vector3::z()
                };
                let by_set = [-direction.x, -direction.y, -direction.z];
                vec![along(direction, length - distance, by_set)]
            }
            Seen::Plane { .. } => {
                let (one, two) = beside(normal);
                let raw = normal + one * set[1] + two * set[2];
                let length = raw.norm();
                let n = raw / length;
                // The unit normal turns by the part of the change that is across it.
                let slope = |e: Vector3<f64>| ((e - n * n.dot(&e)) / length).dot(&point);
                let by_set = [-1.0, slope(one), slope(two)];
                vec![along(n, n.dot(&point) - set[0], by_set)]
            }
        }
    }
}

/// Two unit vectors across a unit vector, and across one another.
pub(super) fn beside(normal: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let helper = match normal.x.abs() < 0.6 {
        true => Vector3::x(),
        false => Vector3::y(),
    };
    let one = normal.cross(&helper).normalize();
    (one, normal.cross(&one))
}

/// The axis times the angle, exact for small angles, where the inverse cosine of the trace is not.
fn rotation_vector(turn: &Rotation3<f64>) -> Vector3<f64> {
    let m = turn.matrix();
    let twice = Vector3::new(
        m[(2, 1)] - m[(1, 2)],
        m[(0, 2)] - m[(2, 0)],
        m[(1, 0)] - m[(0, 1)],
    );
    let (sine, cosine) = (twice.norm() * 0.5, (m.trace() - 1.0) * 0.5);
    match sine > 1e-8 {
        true => twice * (0.5 * sine.atan2(cosine) / sine),
        // Nearly nothing, or nearly half a turn, where only the other way is exact.
        false if cosine > 0.0 => twice * 0.5,
        false => turn.scaled_axis(),
    }
}

/// How the rotation vector changes with a small turn before the rotation.
fn inverse_left_jacobian(turn: &Vector3<f64>) -> Matrix3<f64> {
    let angle = turn.norm();
    let cross = turn.cross_matrix();
    let factor = match angle < 1e-4 {
        true => 1.0 / 12.0 + angle * angle / 720.0,
        false => 1.0 / (angle * angle) - (1.0 + angle.cos()) / (2.0 * angle * angle.sin()),
    };
    Matrix3::identity() - cross * 0.5 + cross * cross * factor
}
