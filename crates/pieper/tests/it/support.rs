//! What the tests share: seeded joint vectors, differences of poses.

use nalgebra::Matrix4;
use pieper::model::{Chain, JointKind};
use pieper::spatial::Pose;

/// Every built-in arm as a chain, those with symbols without a value left out.
pub(crate) fn arms() -> impl Iterator<Item = (&'static str, Chain)> {
    pieper_robots::ALL
        .iter()
        .filter_map(|built_in| Some((built_in.id, built_in.robot().chain().ok()?)))
}

/// A random joint vector: angles over the whole turn, slides within a metre.
pub(crate) fn random_joints(chain: &Chain, random: &mut fastrand::Rng) -> Vec<f64> {
    let half = |kind: JointKind| {
        if kind.is_angular() {
            std::f64::consts::PI
        } else {
            1.0
        }
    };
    chain
        .variables()
        .iter()
        .map(|v| half(v.kind) * (2.0 * random.f64() - 1.0))
        .collect()
}

/// The largest difference of two poses' entries.
pub(crate) fn difference(a: &Pose, b: &Pose) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).amax()
}

/// A pose's matrix.
pub(crate) fn matrix(pose: &Pose) -> Matrix4<f64> {
    pose.to_homogeneous()
}
