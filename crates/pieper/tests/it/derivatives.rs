//! Jacobians and the Hessian against dual numbers, finite differences and the laws they obey.

use crate::support::{arms, random_joints};
use nalgebra::{Matrix3, Vector3, Vector6};
use pieper::kinematics::kernel::{Frame, Turn};
use pieper::kinematics::{
    Jacobian, Orientation, Reference, analytic_jacobian, hessian, joint_torques, pose_and_jacobian,
    tool_pose, twist,
};
use pieper::model::{Chain, LinkShape};
use pieper::scalar::{Dual, Trigonometric};

/// The tool's frame on dual numbers by the kernel, variable `along` being the one derived by.
fn dual_frame(chain: &Chain, q: &[f64], along: usize) -> Frame<[Dual; 3]> {
    let canonical = chain.canonical();
    let m = canonical.base.rotation.matrix();
    let column = |j: usize| [0, 1, 2].map(|i| Dual::constant(m[(i, j)]));
    let p = canonical.base.translation.vector;
    let mut frame = Frame {
        x: column(0),
        y: column(1),
        z: column(2),
        p: [p.x, p.y, p.z].map(Dual::constant),
    };
    let rows = |pose: &pieper::spatial::Pose| {
        let m = pose.to_homogeneous();
        [0, 1, 2].map(|i| [0, 1, 2, 3].map(|j| Dual::constant(m[(i, j)])))
    };
    for step in &canonical.steps {
        let value = q[step.drive.variable];
        let value = if step.drive.variable == along {
            Dual::variable(value)
        } else {
            Dual::constant(value)
        };
        let moved = value * Dual::constant(step.drive.factor) + Dual::constant(step.drive.offset);
        if step.turns {
            let (sin, cos) = moved.sin_cos();
            frame.turn_z(&Turn { sin, cos });
        } else {
            frame.shift_z(&moved);
        }
        frame.append(&rows(&step.link.pose()));
    }
    if let Some(tail) = &canonical.tail {
        frame.append(&rows(tail));
    }
    frame
}

/// Velocity and angular velocity from a frame's derivative: `R' R^T` is the cross product with omega.
fn velocity(frame: &Frame<[Dual; 3]>) -> [f64; 6] {
    let columns = [&frame.x, &frame.y, &frame.z];
    let rotation = Matrix3::from_fn(|i, j| columns[j][i].value);
    let change = Matrix3::from_fn(|i, j| columns[j][i].derivative);
    let w = change * rotation.transpose();
    let v = frame.p.map(|p| p.derivative);
    [v[0], v[1], v[2], w[(2, 1)], w[(0, 2)], w[(1, 0)]]
}

#[test]
fn the_jacobian_equals_the_dual_numbers_derivative() {
    let mut random = fastrand::Rng::with_seed(5);
    for (id, chain) in arms() {
        let mut base = Jacobian::zeros(chain.dof());
        let mut tool = Jacobian::zeros(chain.dof());
        for _ in 0..20 {
            let q = random_joints(&chain, &mut random);
            let pose = pose_and_jacobian(&chain, &q, Reference::Base, &mut base).unwrap();
            pose_and_jacobian(&chain, &q, Reference::Tool, &mut tool).unwrap();
            for j in 0..chain.dof() {
                let expected = velocity(&dual_frame(&chain, &q, j));
                let column: Vec<f64> = base.column(j).iter().copied().collect();
                let off = column
                    .iter()
                    .zip(expected)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, f64::max);
                assert!(off < 1e-14, "{id}: column {j} is off by {off:e}");
                for half in [0, 3] {
                    let in_base = pose.rotation * Vector3::from_fn(|i, _| tool[(half + i, j)]);
                    let off = (in_base - Vector3::from_fn(|i, _| base[(half + i, j)])).amax();
                    assert!(off < 1e-14, "{id}: the tool's column {j} is off by {off:e}");
                }
            }
        }
    }
}

#[test]
fn the_hessian_is_the_derivative_of_the_jacobian() {
    let mut random = fastrand::Rng::with_seed(6);
    let step = 1e-5;
    for (id, chain) in arms() {
        let (mut plus, mut minus, mut slices) =
            (Jacobian::zeros(0), Jacobian::zeros(0), Vec::new());
        let q = random_joints(&chain, &mut random);
        hessian(&chain, &q, &mut slices).unwrap();
        for (i, slice) in slices.iter().enumerate() {
            let mut moved = q.clone();
            moved[i] = q[i] + step;
            pose_and_jacobian(&chain, &moved, Reference::Base, &mut plus).unwrap();
            moved[i] = q[i] - step;
            pose_and_jacobian(&chain, &moved, Reference::Base, &mut minus).unwrap();
            let off = ((&plus - &minus) / (2.0 * step) - slice).amax();
            assert!(off < 1e-8, "{id}: slice {i} is off by {off:e}");
        }
    }
}

#[test]
fn analytic_jacobians_are_the_derivatives_of_the_parameters() {
    let mut random = fastrand::Rng::with_seed(7);
    let step = 1e-6;
    for (id, chain) in arms() {
        let q = random_joints(&chain, &mut random);
        for orientation in [
            Orientation::RollPitchYaw,
            Orientation::EulerZyz,
            Orientation::RotationVector,
            Orientation::Quaternion,
        ] {
            // A SCARA's tool hangs straight down: some parameters are singular for it at every joint vector.
            let Ok(analytic) = analytic_jacobian(&chain, &q, orientation) else {
                continue;
            };
            for j in 0..chain.dof() {
                let at = |delta: f64| {
                    let mut moved = q.clone();
                    moved[j] += delta;
                    let pose = tool_pose(&chain, &moved).unwrap();
                    let p: Vec<f64> = pose.translation.vector.iter().copied().collect();
                    [p, orientation.parameters(&pose.rotation)].concat()
                };
                for (row, (plus, minus)) in at(step).iter().zip(at(-step)).enumerate() {
                    let change = plus - minus;
                    // Parameters jump by full turns at the ends of their ranges.
                    if change.abs() > 1.0 {
                        continue;
                    }
                    let off = (change / (2.0 * step) - analytic[(row, j)]).abs();
                    let scale = analytic.amax().max(1.0);
                    assert!(
                        off < 1e-7 * scale * scale,
                        "{id} {orientation:?}: row {row}, column {j}: {off:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn power_is_the_same_at_the_joints_and_at_the_tool() {
    let mut random = fastrand::Rng::with_seed(8);
    for (id, chain) in arms() {
        let q = random_joints(&chain, &mut random);
        let rates: Vec<f64> = (0..chain.dof()).map(|_| random.f64() - 0.5).collect();
        let wrench = Vector6::from_fn(|_, _| random.f64() - 0.5);
        let mut torques = vec![0.0; chain.dof()];
        for reference in [Reference::Base, Reference::Tool] {
            let mut jacobian = Jacobian::zeros(chain.dof());
            pose_and_jacobian(&chain, &q, reference, &mut jacobian).unwrap();
            joint_torques(&jacobian, &wrench, &mut torques).unwrap();
            let at_joints: f64 = torques.iter().zip(&rates).map(|(t, r)| t * r).sum();
            let at_tool = wrench.dot(&twist(&jacobian, &rates).unwrap());
            assert!((at_joints - at_tool).abs() < 1e-14, "{id}");
        }
        assert!(twist(&Jacobian::zeros(chain.dof()), &[]).is_err());
    }
}

#[test]
fn general_links_and_rows_compose_alike() {
    // The kernel's two ways to append a link: by its four numbers, and by its matrix.
    let mut random = fastrand::Rng::with_seed(9);
    for (id, chain) in arms() {
        let q = random_joints(&chain, &mut random);
        let by_rows = dual_frame(&chain, &q, 0);
        let pose = tool_pose(&chain, &q).unwrap();
        let off = (0..3)
            .map(|i| (by_rows.p[i].value - pose.translation.vector[i]).abs())
            .fold(0.0, f64::max);
        assert!(off < 1e-14, "{id}: off by {off:e}");
        let is_dh = |step: &pieper::model::Step| matches!(step.link, LinkShape::Dh { .. });
        assert!(
            chain.canonical().steps.iter().all(is_dh),
            "{id}: a table's links are rows"
        );
    }
}
