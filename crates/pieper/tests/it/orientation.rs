//! Orientation from tool points, the geometric quaternion, and poses handed in as matrices.

use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector3};
use pieper::spatial::{geometric_quaternion, orientation_from_points, pose_from_rows};

fn random_unit(random: &mut fastrand::Rng) -> Unit<Vector3<f64>> {
    loop {
        let v = Vector3::from_fn(|_, _| 2.0 * random.f64() - 1.0);
        if (0.01..1.0).contains(&v.norm_squared()) {
            return Unit::new_normalize(v);
        }
    }
}

fn random_rotation(random: &mut fastrand::Rng) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&random_unit(random), 6.3 * random.f64())
}

fn check_turn(before: &Rotation3<f64>, turn: &Rotation3<f64>) {
    let after = turn * before;
    let q = geometric_quaternion(before, &after);
    let off = (q.to_rotation_matrix() * before).matrix() - after.matrix();
    assert!(
        off.amax() < 4e-15,
        "off by {:e} for a turn of {}",
        off.amax(),
        turn.angle()
    );
    assert!(q.w >= 0.0);
}

#[test]
fn the_geometric_quaternion_is_the_turn() {
    let mut random = fastrand::Rng::with_seed(15);
    let right_angles = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()];
    for round in 0..3000 {
        let before = if round % 3 == 0 {
            Rotation3::identity()
        } else {
            random_rotation(&mut random)
        };
        // Every degenerate case: no turn, tiny and half turns, right angles, axes along i, j, k and between them.
        let mut axes = vec![random_unit(&mut random)];
        axes.extend(right_angles);
        axes.push(Unit::new_normalize(Vector3::new(1.0, 1.0, 0.0)));
        axes.push(before * Vector3::x_axis());
        for axis in axes {
            let exponent = -16.0 * random.f64();
            for angle in [
                0.0,
                10.0_f64.powf(exponent),
                std::f64::consts::FRAC_PI_2,
                std::f64::consts::PI,
                std::f64::consts::PI - 10.0_f64.powf(exponent),
                6.2 * random.f64(),
            ] {
                check_turn(&before, &Rotation3::from_axis_angle(&axis, angle));
            }
        }
    }
}

#[test]
fn three_points_give_the_orientation_they_came_from() {
    let mut random = fastrand::Rng::with_seed(16);
    for _ in 0..2000 {
        let rotation = random_rotation(&mut random);
        let tip = Vector3::from_fn(|_, _| random.f64());
        let point = |x, y, z| tip + rotation * Vector3::new(x, y, z);
        let (long, side, along) = (0.1 + random.f64(), 0.1 + random.f64(), random.f64() - 0.5);
        let found = orientation_from_points(&tip, &point(0.0, 0.0, long), &point(0.0, side, along))
            .unwrap();
        assert!((found.matrix() - rotation.matrix()).amax() < 1e-13);
        let q = geometric_quaternion(&Rotation3::identity(), &found);
        let expected = UnitQuaternion::from_rotation_matrix(&found);
        assert!(
            q.angle_to(&expected) < 1e-7
                && (q.to_rotation_matrix().matrix() - found.matrix()).amax() < 1e-13
        );
    }
}

#[test]
fn points_that_fix_no_orientation_are_refused_in_words() {
    let point = Vector3::new;
    let origin = point(0.0, 0.0, 0.0);
    for (k, e, expected) in [
        (point(0.0, 0.0, 1.0), point(0.0, 0.0, 2.0), "collinear"),
        (point(0.0, 0.0, 1.0), point(0.0, 1e-14, 2.0), "collinear"),
        (point(1.0, 1.0, 1.0), point(-2.0, -2.0, -2.0), "collinear"),
        (origin, point(0.0, 1.0, 0.0), "D and K are the same point"),
        (point(0.0, 0.0, 1.0), origin, "D and E are the same point"),
        (
            point(0.0, f64::NAN, 1.0),
            point(0.0, 1.0, 0.0),
            "not a finite number",
        ),
    ] {
        let error = orientation_from_points(&origin, &k, &e).unwrap_err();
        assert!(
            error.is_input() && error.to_string().contains(expected),
            "{error}"
        );
    }
}

#[test]
fn a_pose_is_projected_within_tolerance_and_refused_beyond() {
    let good = vec![
        vec![1.0, 0.0, 0.0, 0.1],
        vec![0.0, 1.0, 0.0, 0.2],
        vec![0.0, 0.0, 1.0, 0.3],
        vec![0.0, 0.0, 0.0, 1.0],
    ];
    let with = |row: usize, column: usize, value: f64| {
        let mut rows = good.clone();
        rows[row][column] = value;
        rows
    };
    assert_eq!(
        pose_from_rows(&good).unwrap().rotation,
        Rotation3::identity()
    );
    let near = pose_from_rows(&with(0, 1, 3e-7)).unwrap();
    let m = near.rotation.matrix();
    assert!((m.transpose() * m - nalgebra::Matrix3::identity()).amax() < 1e-15);
    for (rows, expected) in [
        (with(0, 1, 3e-6), "off the identity by 3.000e-6"),
        (with(0, 0, -1.0), "reflection"),
        (with(1, 3, f64::NAN), "not a finite number"),
        (with(3, 0, 1.0), "its last row"),
        (good[..2].to_vec(), "4x4 matrix"),
    ] {
        let error = pose_from_rows(&rows).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
}
