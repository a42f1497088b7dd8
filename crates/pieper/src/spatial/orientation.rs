//! Orientation from tool points, and the quaternion found by geometry.

use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};

use crate::error::{Error, Result};

/// The sine of the angle between DK and DE below which three points count as collinear:
/// of coordinates given in doubles, fewer than four digits of the axes would be left.
const COLLINEAR: f64 = 1e-12;

/// The tool's orientation from three of its points: `tip` (D), `on_z` (K, on the tool's z axis) and `beside` (E, which
/// fixes the y axis). All in one frame, any unit of length.
///
/// `k = DK/|DK|`, `i = (DE x k)/|DE x k|`, `j = k x i`: E lies on the side of +y.
///
/// # Errors
/// An input error if a coordinate is not finite, if two of the points coincide, or if the three are collinear.
///
/// ```
/// use nalgebra::Vector3;
/// let rotation = pieper::spatial::orientation_from_points(
///     &Vector3::new(1.0, 0.0, 0.0), // D
///     &Vector3::new(1.0, 0.0, 2.0), // K
///     &Vector3::new(1.0, 3.0, 1.0), // E
/// )?;
/// assert_eq!(rotation, nalgebra::Rotation3::identity());
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn orientation_from_points(
    tip: &Vector3<f64>,
    on_z: &Vector3<f64>,
    beside: &Vector3<f64>,
) -> Result<Rotation3<f64>> {
    let (dk, de) = (on_z - tip, beside - tip);
    let side = de.cross(&dk);
    let (long, wide, height) = (dk.norm(), de.norm(), side.norm());
    let text = if !(long.is_finite() && wide.is_finite()) {
        "a coordinate is not a finite number"
    } else if long == 0.0 {
        "D and K are the same point: K was expected on the tool's z axis"
    } else if wide == 0.0 {
        "D and E are the same point: E was expected beside the tool's z axis"
    } else if height <= COLLINEAR * long * wide {
        "D, K and E are collinear: E was expected beside the line through D and K"
    } else {
        let (k, i) = (dk / long, side / height);
        let axes = Matrix3::from_columns(&[i, k.cross(&i), k]);
        return Ok(Rotation3::from_matrix_unchecked(axes));
    };
    Err(Error::input("tool points", text))
}

/// The unit quaternion that turns `before` into `after`, by geometry alone: w >= 0.
///
/// With A, B the tips of two unit vectors before (0) and after (1) the turn, the axis is `(A1 - A0) x (B1 - B0)` and the
/// angle lies between the planes (axis, A0) and (axis, A1), signed about the axis. Of the three unit vectors, the pair
/// whose differences are least parallel gives the axis, and the one farthest from it the angle; so the half turn, small
/// turns and turns about i, j or k work like all others. No turn gives the identity. The axis of a half turn has no
/// sense: either sign may come out.
///
/// ```
/// use nalgebra::{Rotation3, Vector3};
/// let before = Rotation3::identity();
/// let after = Rotation3::from_axis_angle(&Vector3::x_axis(), 3.0);
/// let q = pieper::spatial::geometric_quaternion(&before, &after);
/// assert!((q.angle() - 3.0).abs() < 1e-15);
/// ```
pub fn geometric_quaternion(
    before: &Rotation3<f64>,
    after: &Rotation3<f64>,
) -> UnitQuaternion<f64> {
    let tip =
        |rotation: &Rotation3<f64>, index: usize| rotation.matrix().column(index).into_owned();
    let moved = [0, 1, 2].map(|index| tip(after, index) - tip(before, index));
    let axes = [(0, 1), (1, 2), (2, 0)].map(|(a, b): (usize, usize)| moved[a].cross(&moved[b]));
    let longest = axes
        .into_iter()
        .max_by(|a, b| a.norm_squared().total_cmp(&b.norm_squared()));
    let Some(axis) = longest.and_then(|axis| Unit::try_new(axis, 0.0)) else {
        return UnitQuaternion::identity();
    };
    let normal = |rotation, index| axis.cross(&tip(rotation, index));
    let farthest = |a: &usize, b: &usize| {
        normal(before, *a)
            .norm_squared()
            .total_cmp(&normal(before, *b).norm_squared())
    };
    let index = (0..3).max_by(farthest).unwrap_or(0);
    let (n0, n1) = (normal(before, index), normal(after, index));
    let angle = n0.cross(&n1).dot(&axis).atan2(n0.dot(&n1));
    UnitQuaternion::from_axis_angle(&axis, angle)
}
