//! First guesses: where the anchors, planes and contacts are, where the measuring device stands, how the tool is mounted.

use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Vector3};

use super::parameter::Group;
use super::problem::{Problem, Set};
use crate::describe::{Measurement, Seen};
use crate::spatial::{Pose, to_rpy};

/// Anchors, planes and contacts, each once, and which one a measurement is of.
pub(super) fn sets_of(measurements: &[Measurement]) -> (Vec<Set>, Vec<Option<usize>>) {
    let mut sets: Vec<Set> = Vec::new();
    let mut of = Vec::with_capacity(measurements.len());
    for measurement in measurements {
        of.push(measurement.seen.set().map(|(kind, name)| {
            let known = sets
                .iter()
                .position(|set| set.kind == kind && set.name == name);
            known.unwrap_or_else(|| {
                sets.push(Set {
                    kind,
                    name: name.to_owned(),
                    normal: Vector3::z(),
                });
                sets.len() - 1
            })
        }));
    }
    (sets, of)
}

/// The points of the tool as the model has them, of the measurements that are of a set.
fn points(problem: &Problem, wanted: impl Fn(usize) -> bool) -> Vec<(usize, Vector3<f64>)> {
    let arm = problem.model.with(&problem.values);
    let indices = (0..problem.measurements.len()).filter(|&index| wanted(index));
    indices
        .filter_map(|index| {
            let measurement = &problem.measurements[index];
            let sensed = arm.sense(&measurement.readings)?;
            let at = sensed.tool.rotation * measurement.seen.at();
            Some((index, sensed.tool.translation.vector + at))
        })
        .collect()
}

/// A first guess of anchors, planes and contacts from where the model has the tool.
pub(super) fn place_sets(problem: &mut Problem) {
    let own = problem.model.parameters().len();
    for set in 0..problem.sets.len() {
        let points = points(problem, |index| problem.set_of[index] == Some(set));
        let mean = points.iter().map(|(_, p)| p).sum::<Vector3<f64>>() / points.len() as f64;
        let numbers = match problem.sets[set].kind {
            "plane" => {
                let spread: Matrix3<f64> = points
                    .iter()
                    .map(|(_, p)| (p - mean) * (p - mean).transpose())
                    .sum();
                let eigen = spread.symmetric_eigen();
                let normal: Vector3<f64> =
                    eigen.eigenvectors.column(eigen.eigenvalues.imin()).into();
                problem.sets[set].normal = normal;
                [normal.dot(&mean), 0.0, 0.0]
            }
            "anchor" => anchor(problem, &points).unwrap_or(mean).into(),
            _ => mean.into(),
        };
        for (k, number) in numbers.into_iter().enumerate() {
            problem.values[own + 3 * set + k] = number;
            problem.parameters[own + 3 * set + k].nominal = number;
        }
    }
}

/// The point at given distances from several others: linear in differences of squares.
fn anchor(problem: &Problem, points: &[(usize, Vector3<f64>)]) -> Option<Vector3<f64>> {
    let distance = |index: usize| match &problem.measurements[index].seen {
        Seen::Distance { distance, .. } => *distance,
        _ => 0.0,
    };
    let (first, rest) = points.split_first().filter(|(_, rest)| !rest.is_empty())?;
    let mut left = DMatrix::zeros(rest.len(), 3);
    let mut right = DVector::zeros(rest.len());
    for (row, (index, point)) in rest.iter().enumerate() {
        left.row_mut(row)
            .copy_from(&(2.0 * (point - first.1)).transpose());
        right[row] = point.norm_squared() - first.1.norm_squared() - distance(*index).powi(2)
            + distance(first.0).powi(2);
    }
    let found = left.svd(true, true).solve(&right, 1e-9).ok()?;
    let found = Vector3::new(found[0], found[1], found[2]);
    found.iter().all(|x| x.is_finite()).then_some(found)
}

/// Points nearer than this to where the model has them, metres, and frames than this, radians, need no first guess.
const NEAR: f64 = 0.05;
const ALIKE: f64 = 0.3;

/// A first guess of base and tool where the measuring device stands elsewhere, or a camera is mounted somewhere: by whole poses both,
/// by points the base alone.
pub(super) fn place_frames(problem: &mut Problem) {
    let has = |group: Group| {
        problem
            .model
            .parameters()
            .iter()
            .filter(|p| p.group == group)
            .count()
            == 6
    };
    if !has(Group::Base) {
        return;
    }
    let arm = problem.model.with(&problem.values);
    let poses: Vec<(Pose, &Pose)> = problem
        .measurements
        .iter()
        .filter_map(|measurement| match &measurement.seen {
            Seen::Pose(seen) => Some((arm.sense(&measurement.readings)?.tool, seen)),
            _ => None,
        })
        .collect();
    let far = |(tool, seen): &(Pose, &Pose)| {
        let way = (tool.translation.vector - seen.translation.vector).norm();
        way > NEAR || (tool.rotation.inverse() * seen.rotation).angle() > ALIKE
    };
    if has(Group::Tool) && poses.len() >= 3 {
        if 2 * poses.iter().filter(|pair| far(pair)).count() > poses.len()
            && let Some((base, tool)) = base_and_tool(problem)
        {
            set_frame(problem, "base", &base);
            set_frame(problem, "tool", &tool);
        }
        return;
    }
    if let Some(motion) = rigid_motion(problem) {
        let base = motion * problem.model.chain().base();
        set_frame(problem, "base", &base);
    }
}

fn set_frame(problem: &mut Problem, name: &str, pose: &Pose) {
    let [roll, pitch, yaw] = to_rpy(&pose.rotation);
    let p = pose.translation.vector;
    let numbers = [
        ("x", p.x),
        ("y", p.y),
        ("z", p.z),
        ("yaw", yaw),
        ("pitch", pitch),
        ("roll", roll),
    ];
    for (word, number) in numbers {
        let name = format!("{name}.{word}");
        let own = problem.model.parameters();
        if let Some(index) = own.iter().position(|p| p.name == name) {
            problem.values[index] = number;
        }
    }
}

/// Base and tool from whole poses: `A X = Y B` with the arm's own motion A, the pose seen B, the tool X, and the base's inverse Y, by
/// the singular vectors of the sum of `B (x) A` (Shah, Solving the robot-world/hand-eye calibration problem using the Kronecker
/// product, 2013, equations 13 to 21), and then both translations by least squares.
fn base_and_tool(problem: &Problem) -> Option<(Pose, Pose)> {
    let own = problem.model.parameters().len();
    let mut bare = problem.values[..own].to_vec();
    for (value, parameter) in bare.iter_mut().zip(problem.model.parameters()) {
        if matches!(parameter.group, Group::Base | Group::Tool) {
            *value = 0.0;
        }
    }
    let arm = problem.model.with(&bare);
    let pairs: Vec<(Pose, Pose)> = problem
        .measurements
        .iter()
        .filter_map(|measurement| match &measurement.seen {
            Seen::Pose(seen) => Some((arm.sense(&measurement.readings)?.tool, *seen)),
            _ => None,
        })
        .collect();
    if pairs.is_empty() {
        return None;
    }
    let mut sum = DMatrix::<f64>::zeros(9, 9);
    for (a, b) in &pairs {
        sum += b.rotation.matrix().kronecker(a.rotation.matrix());
    }
    let svd = sum.svd(true, true);
    let (u, v) = (svd.u?, svd.v_t?.transpose());
    let largest = svd.singular_values.imax();
    let turn_x = closest(&rotation_of(&v, largest)?)?;
    let turn_y = closest(&rotation_of(&u, largest)?)?;
    let mut left = DMatrix::zeros(3 * pairs.len(), 6);
    let mut right = DVector::zeros(3 * pairs.len());
    for (k, (a, b)) in pairs.iter().enumerate() {
        left.view_mut((3 * k, 0), (3, 3))
            .copy_from(a.rotation.matrix());
        left.view_mut((3 * k, 3), (3, 3))
            .copy_from(&(-Matrix3::identity()));
        let off = turn_y * b.translation.vector - a.translation.vector;
        right.rows_mut(3 * k, 3).copy_from(&off);
    }
    let found = left.svd(true, true).solve(&right, 1e-9).ok()?;
    let x = Pose::from_parts(Vector3::new(found[0], found[1], found[2]).into(), turn_x);
    let y = Pose::from_parts(Vector3::new(found[3], found[4], found[5]).into(), turn_y);
    found
        .iter()
        .all(|value| value.is_finite())
        .then(|| (y.inverse(), x))
}

/// A column of nine as a matrix of determinant 1, as near as a factor makes it.
fn rotation_of(columns: &DMatrix<f64>, index: usize) -> Option<Matrix3<f64>> {
    let m = Matrix3::from_column_slice(columns.column(index).clone_owned().as_slice());
    let determinant = m.determinant();
    let size = determinant.abs().cbrt();
    (size > 1e-6).then(|| m * (determinant.signum() / size))
}

/// The rotation nearest to a matrix, however far it is from one.
fn closest(m: &Matrix3<f64>) -> Option<Rotation3<f64>> {
    let svd = m.svd(true, true);
    let (u, v) = (svd.u?, svd.v_t?);
    let mut flip = Matrix3::identity();
    flip[(2, 2)] = (u * v).determinant().signum();
    Some(Rotation3::from_matrix_unchecked(u * flip * v))
}

/// The rigid motion that brings the model's points nearest to those seen, where they are far from one another.
fn rigid_motion(problem: &Problem) -> Option<Pose> {
    let seen = |index: usize| match &problem.measurements[index].seen {
        Seen::Pose(pose) => Some(pose.translation.vector),
        Seen::Position { point, .. } => Some(Vector3::from(*point)),
        _ => None,
    };
    let pairs: Vec<(Vector3<f64>, Vector3<f64>)> = points(problem, |index| seen(index).is_some())
        .into_iter()
        .filter_map(|(index, p)| Some((p, seen(index)?)))
        .collect();
    if pairs.len() < 3 {
        return None;
    }
    let count = pairs.len() as f64;
    let off = pairs.iter().map(|(a, b)| (a - b).norm()).sum::<f64>() / count;
    if off < NEAR {
        return None;
    }
    let from = pairs.iter().map(|(a, _)| a).sum::<Vector3<f64>>() / count;
    let to = pairs.iter().map(|(_, b)| b).sum::<Vector3<f64>>() / count;
    let cross: Matrix3<f64> = pairs
        .iter()
        .map(|(a, b)| (b - to) * (a - from).transpose())
        .sum();
    let turn = closest(&cross)?;
    Some(Pose::from_parts((to - turn * from).into(), turn))
}
