//! The common normal of two neighbouring axes.

use nalgebra::Vector3;

use super::TOLERANCES;
use crate::spatial::Pose;

/// A link as `Rz(phi) Tz(d) Tx(a) Rx(alpha) Rz(psi) Tz(e)`, snapped to its class.
///
/// Axes closer to parallel than the class tolerance are made parallel, axes closer than that to meeting are made
/// to meet; `miss` says by how much that changed the link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Normal {
    pub(super) phi: f64,
    pub(super) d: f64,
    pub(super) a: f64,
    /// Sine and cosine.
    pub(super) alpha: (f64, f64),
    pub(super) psi: f64,
    pub(super) e: f64,
    /// The larger of the change of angle (rad) and of length (relative to the arm's size).
    pub(super) miss: f64,
}

/// How far a component of a unit vector may be from 0 and still mean it.
const DUST: f64 = 8.0 * f64::EPSILON;

impl Normal {
    /// The common normal of a link's axes, for an arm of this size.
    pub(super) fn of(link: &Pose, size: f64) -> Self {
        Self::within(link, size, TOLERANCES.class)
    }

    /// The same with a tolerance of one's own: a link that contains the wanted pose is no part of the arm's class, and
    /// must not be changed by more than [`Tolerances::merely`](super::Tolerances::merely).
    pub(super) fn within(link: &Pose, size: f64, class: f64) -> Self {
        let m = link.rotation.matrix();
        let t = link.translation.vector;
        let sine = m[(0, 2)].hypot(m[(1, 2)]);
        if sine < class {
            return Self::parallel(link, sine, size, class);
        }
        let phi = m[(0, 2)].atan2(-m[(1, 2)]);
        let (sin, cos) = crate::spatial::sin_cos_exact(phi);
        let e = -(cos * t.y - sin * t.x) / sine;
        let a = clean(cos * t.x + sin * t.y, size);
        let meets = a.abs() < class * size;
        let cosine = if m[(2, 2)].abs() < DUST {
            0.0
        } else {
            m[(2, 2)]
        };
        let sine = if cosine == 0.0 { 1.0 } else { sine };
        Self {
            phi,
            d: t.z - e * m[(2, 2)],
            a: if meets { 0.0 } else { a },
            alpha: (sine, cosine),
            psi: m[(2, 0)].atan2(m[(2, 1)]),
            e,
            miss: if meets { a.abs() / size } else { 0.0 },
        }
    }

    fn parallel(link: &Pose, sine: f64, size: f64, class: f64) -> Self {
        let m = link.rotation.matrix();
        let t = link.translation.vector;
        let a = clean(t.x.hypot(t.y), size);
        let coincide = a < class * size;
        let phi = if coincide { 0.0 } else { t.y.atan2(t.x) };
        let (sin, cos) = phi.sin_cos();
        let flip = m[(2, 2)].signum();
        // Rx(alpha) Rz(psi) = Rz(-phi) R: its first column is (cos psi, flip sin psi, 0).
        let x = Vector3::new(
            cos * m[(0, 0)] + sin * m[(1, 0)],
            flip * (cos * m[(1, 0)] - sin * m[(0, 0)]),
            0.0,
        );
        let lost = if coincide { a / size } else { 0.0 };
        Self {
            phi,
            d: t.z,
            a: if coincide { 0.0 } else { a },
            alpha: (0.0, flip),
            psi: x.y.atan2(x.x),
            e: 0.0,
            miss: if sine < DUST { lost } else { sine.max(lost) },
        }
    }

    pub(super) fn is_parallel(&self) -> bool {
        self.alpha.0 == 0.0
    }

    /// Whether the axes meet in exactly one point.
    pub(super) fn crosses(&self) -> bool {
        self.meets() && !self.is_parallel()
    }

    pub(super) fn meets(&self) -> bool {
        self.a == 0.0
    }
}

/// A length without the dust of an exact zero.
fn clean(length: f64, size: f64) -> f64 {
    if length.abs() < DUST * size {
        0.0
    } else {
        length
    }
}
