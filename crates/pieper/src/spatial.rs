//! Rigid motions: poses, turns with exact right angles, checks.

use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3, UnitVector3, Vector3};

mod angle;

pub use angle::{sin_cos_exact, snap};

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
/// At pitch = +-pi/2 only a sum or difference of roll and yaw is determined; roll is 0 there.
pub fn to_rpy(rotation: &Rotation3<f64>) -> [f64; 3] {
    let m = rotation.matrix();
    let cos_pitch = m[(0, 0)].hypot(m[(1, 0)]);
    let pitch = (-m[(2, 0)]).atan2(cos_pitch);
    if cos_pitch < GIMBAL_LOCK {
        let yaw = (-m[(0, 1)]).atan2(m[(1, 1)]);
        return [0.0, pitch, yaw];
    }
    [
        m[(2, 1)].atan2(m[(2, 2)]),
        pitch,
        m[(1, 0)].atan2(m[(0, 0)]),
    ]
}

/// Cosine of pitch below which roll and yaw can no longer be told apart: their entries of the matrix are then
/// of the size of rounding errors.
const GIMBAL_LOCK: f64 = 1e-15;
