//! Numbers, poses and matrices as JSON. The program's own types: the library knows no JSON.

use nalgebra::Matrix6xX;
use pieper::spatial::Pose;
use serde_json::{Value, json};

/// A pose as a row-major 4x4 nested list.
pub(crate) fn pose(pose: &Pose) -> Value {
    let (m, p) = (pose.rotation.matrix(), &pose.translation.vector);
    let row = |i: usize| json!([m[(i, 0)], m[(i, 1)], m[(i, 2)], p[i]]);
    json!([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]])
}

/// A Jacobian as six rows.
pub(crate) fn jacobian(jacobian: &Matrix6xX<f64>) -> Value {
    jacobian
        .row_iter()
        .map(|row| row.iter().copied().collect::<Value>())
        .collect()
}
