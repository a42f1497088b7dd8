//! Rigid motions: poses, turns with exact right angles, checks.

use crate::error::{Error, Result};
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3, UnitVector3, Vector3};

mod angle;
mod orientation;

pub use angle::{Quarters, sin_cos_exact, snap};
pub use orientation::{geometric_quaternion, orientation_from_points};

/// A pose: rotation matrix and translation. `a_from_b` maps coordinates in frame b to frame a.
///
/// Its columns are the directions n, s, a of frame b's axes x, y, z in frame a, and the origin p of b.
pub type Pose = IsometryMatrix3<f64>;

/// A pure translation.
pub fn shift(by: Vector3<f64>) -> Pose {
    Pose::from_parts(Translation3::from(by), Rotation3::identity())
}

/// A pure rotation about a unit axis, by the angle with this sine and cosine.
///
/// ```
/// use nalgebra::Vector3;
/// use pieper::spatial::{sin_cos_exact, turn};
/// let quarter = turn(&Vector3::z_axis(), sin_cos_exact(std::f64::consts::FRAC_PI_2));
/// assert_eq!(quarter * Vector3::x(), Vector3::y());
/// ```
pub fn turn(axis: &UnitVector3<f64>, (sin, cos): (f64, f64)) -> Pose {
    let u = axis.as_ref();
    let (x, y, z) = (u.x, u.y, u.z);
    let versine = 1.0 - cos;
    let diagonal = |component: f64| component.mul_add(component * versine, cos);
    let rotation = if u == &Vector3::z() {
        Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0)
    } else {
        Matrix3::new(
            diagonal(x),
            x * y * versine - z * sin,
            x * z * versine + y * sin,
            x * y * versine + z * sin,
            diagonal(y),
            y * z * versine - x * sin,
            x * z * versine - y * sin,
            y * z * versine + x * sin,
            diagonal(z),
        )
    };
    Pose::from_parts(
        Translation3::identity(),
        Rotation3::from_matrix_unchecked(rotation),
    )
}

/// A pose from position and fixed-axis roll, pitch, yaw as in URDF: `Rz(yaw) Ry(pitch) Rx(roll)`.
///
/// Angles that are multiples of a right angle give exact zeros and ones.
pub fn from_xyz_rpy(xyz: [f64; 3], rpy: [f64; 3]) -> Pose {
    let [roll, pitch, yaw] = rpy;
    let rotation = turn(&Vector3::z_axis(), sin_cos_exact(yaw))
        * turn(&Vector3::y_axis(), sin_cos_exact(pitch))
        * turn(&Vector3::x_axis(), sin_cos_exact(roll));
    shift(Vector3::from(xyz)) * rotation
}

/// Fixed-axis roll, pitch, yaw of a rotation, `Rz(yaw) Ry(pitch) Rx(roll)`; roll and yaw in (-pi, pi].
///
/// At pitch = +-pi/2 only a sum or difference of roll and yaw is determined; roll is 0 there. Near it the two are hardly
/// determined one by one, so roll is what is left when yaw is undone: together they give the rotation back to rounding.
pub fn to_rpy(rotation: &Rotation3<f64>) -> [f64; 3] {
    let m = rotation.matrix();
    let cos_pitch = m[(0, 0)].hypot(m[(1, 0)]);
    let pitch = (-m[(2, 0)]).atan2(cos_pitch);
    let yaw = if cos_pitch < GIMBAL_LOCK {
        (-m[(0, 1)]).atan2(m[(1, 1)])
    } else {
        m[(1, 0)].atan2(m[(0, 0)])
    };
    let (sin, cos) = sin_cos_exact(yaw);
    let roll = (sin * m[(0, 2)] - cos * m[(1, 2)]).atan2(cos * m[(1, 1)] - sin * m[(0, 1)]);
    // Right angles as such, and no negative zeros.
    [roll, pitch, yaw].map(|angle| snap(angle) + 0.0)
}

/// Cosine of pitch below which roll and yaw can no longer be told apart: their entries of the matrix are then
/// of the size of rounding errors.
const GIMBAL_LOCK: f64 = 1e-15;

/// A pose from the rows of its 4x4 (or 3x4) matrix.
///
/// The rotation part is projected onto the nearest rotation, so that what follows works with an exact one.
///
/// # Errors
/// An input error: wrong shape, an entry that is not finite, a last row other than 0 0 0 1, a rotation part that is
/// more than 1e-6 from orthonormal or a reflection; the message says how far off it is.
pub fn pose_from_rows(rows: &[Vec<f64>]) -> Result<Pose> {
    let shape_is_right = matches!(rows.len(), 3 | 4) && rows.iter().all(|row| row.len() == 4);
    if !shape_is_right {
        return Err(Error::input(
            "pose",
            "a 4x4 matrix was expected, row by row",
        ));
    }
    if let Some(entry) = rows.iter().flatten().find(|entry| !entry.is_finite()) {
        return Err(Error::input(
            "pose",
            format!("its entry {entry} is not a finite number"),
        ));
    }
    if let Some(last) = rows.get(3).filter(|last| last[..] != [0.0, 0.0, 0.0, 1.0]) {
        return Err(Error::input(
            "pose",
            format!("its last row is {last:?}, [0, 0, 0, 1] was expected"),
        ));
    }
    let rotation = Matrix3::from_fn(|i, j| rows[i][j]);
    let position = Vector3::from_fn(|i, _| rows[i][3]);
    Ok(Pose::from_parts(
        position.into(),
        nearest_rotation(&rotation)?,
    ))
}

/// How far a rotation part may be from orthonormal and still be taken for one: the contract of the program.
const ORTHONORMAL_TOLERANCE: f64 = 1e-6;

/// The rotation nearest to a matrix that is one up to rounding.
///
/// # Errors
/// An input error if an entry of `R^T R - 1` exceeds 1e-6, or if the matrix is a reflection.
pub fn nearest_rotation(matrix: &Matrix3<f64>) -> Result<Rotation3<f64>> {
    let off = (matrix.transpose() * matrix - Matrix3::identity()).amax();
    if off.is_nan() || off > ORTHONORMAL_TOLERANCE {
        let text = format!(
            "it is not orthonormal: R^T R is off the identity by {off:.3e}, at most 1e-6 was expected"
        );
        return Err(Error::input("rotation part of the pose", text));
    }
    if matrix.determinant() < 0.0 {
        let text = "it is a reflection (determinant -1), a rotation was expected";
        return Err(Error::input("rotation part of the pose", text));
    }
    // Newton's iteration for the polar factor, X <- X (3 - X^T X) / 2, is quadratic: from 1e-6 one step reaches
    // 1e-12, two reach rounding. A matrix that is exact already stays as it is to the last bit.
    let mut rotation = *matrix;
    for _ in 0..2 {
        let excess = rotation.transpose() * rotation - Matrix3::identity();
        if excess.amax() <= 2.0 * f64::EPSILON {
            break;
        }
        rotation -= rotation * excess * 0.5;
    }
    Ok(Rotation3::from_matrix_unchecked(rotation))
}
