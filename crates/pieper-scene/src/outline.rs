//! How far an arm reaches, as a line to draw.

use nalgebra::Point3;
use pieper::kinematics::tool_pose;
use pieper::model::{Chain, JointKind};

/// Rays of the outline, and poses tried for it.
const RAYS: usize = 96;
const SAMPLES: usize = 24_000;

/// The outline of the tool's reach in the half-plane through axis 1, as `[distance from the axis, height along it]` in the first
/// axis's frame; empty for an arm whose first joint does not turn, or whose first axis does not stand upright.
///
/// Sampled: the farthest of some thousand poses within the limits in each of 96 directions from the middle of all. It lies within
/// the true reach, and short of it by what the samples miss (about 1 % of the reach with six joints).
pub fn outline(chain: &Chain) -> Vec<[f64; 2]> {
    let canonical = chain.canonical();
    let upright = canonical.base.rotation.matrix()[(2, 2)].abs() > 0.999;
    if !upright || !canonical.steps.first().is_some_and(|step| step.turns) {
        return Vec::new();
    }
    let ranges: Vec<[f64; 2]> = chain
        .variables()
        .iter()
        .map(|variable| match (variable.limits, variable.kind) {
            (Some(limits), _) => [limits.lower(), limits.upper()],
            (None, JointKind::Prismatic) => [0.0, 0.0],
            (None, _) => [-std::f64::consts::PI, std::f64::consts::PI],
        })
        .collect();
    let axis = canonical.base.inverse();
    let mut points = Vec::with_capacity(SAMPLES);
    let mut q = vec![0.0; ranges.len()];
    for sample in 1..=SAMPLES {
        for (j, (value, range)) in q.iter_mut().zip(&ranges).enumerate() {
            // A low-discrepancy sequence; every third value at an end, where the reach ends too.
            let part = halton(sample, PRIMES[j % PRIMES.len()]);
            let part = ((part - 0.5) * 1.4 + 0.5).clamp(0.0, 1.0);
            *value = range[0] + part * (range[1] - range[0]);
        }
        if let Ok(pose) = tool_pose(chain, &q) {
            let p = axis * Point3::from(pose.translation.vector);
            points.push([p.x.hypot(p.y), p.z]);
        }
    }
    hull_by_rays(&points)
}

const PRIMES: [usize; 8] = [2, 3, 5, 7, 11, 13, 17, 19];

fn halton(mut index: usize, base: usize) -> f64 {
    let (mut value, mut part) = (0.0, 1.0);
    while index > 0 {
        part /= base as f64;
        value += part * (index % base) as f64;
        index /= base;
    }
    value
}

/// For each direction around the middle of the points the farthest point in it.
fn hull_by_rays(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let span = |k: usize| {
        let values = || points.iter().map(move |p| p[k]);
        (
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        )
    };
    let ((_, right), (low, high)) = (span(0), span(1));
    // The middle lies on the axis: the outline is that of a solid of revolution.
    let middle = [0.0, 0.5 * (low + high)];
    if !right.is_finite() || right <= 0.0 {
        return Vec::new();
    }
    let mut far = [None::<([f64; 2], f64)>; RAYS + 1];
    for p in points {
        let (x, y) = (p[0] - middle[0], p[1] - middle[1]);
        let (distance, angle) = (x.hypot(y), x.atan2(-y));
        let ray = (angle / std::f64::consts::PI * RAYS as f64).round() as usize;
        let place = &mut far[ray.min(RAYS)];
        if place.is_none_or(|(_, most)| distance > most) {
            *place = Some((*p, distance));
        }
    }
    far.into_iter().flatten().map(|(point, _)| point).collect()
}
