//! Arms a hair off their class, as calibration leaves them: solved as their class, refined on the true model.

use super::random_arms::sigma;
use super::{check_closes, closed_forms, contains};
use crate::support::random_joints;
use nalgebra::{Rotation3, Vector3};
use pieper::ik::{Solutions, Solver, Status};
use pieper::kinematics::tool_pose;
use pieper::model::Chain;
use pieper::spatial::Pose;

/// The chain with every link moved and turned by about `amount`.
fn disturbed(chain: &Chain, amount: f64, random: &mut fastrand::Rng) -> Chain {
    let mut parts = chain.parts().clone();
    let mut vector = || Vector3::from_fn(|_, _| amount * (2.0 * random.f64() - 1.0));
    for joint in &mut parts.joints {
        let turn = Rotation3::from_scaled_axis(vector());
        joint.after *= Pose::from_parts(vector().into(), turn);
    }
    Chain::new(parts).unwrap()
}

#[test]
fn arms_a_hair_off_their_class() {
    let mut random = fastrand::Rng::with_seed(21);
    let mut found = Solutions::default();
    for (id, nominal) in closed_forms().filter(|(_, solver)| solver.chain().dof() == 6) {
        for amount in [1e-12, 1e-9, 1e-7, 1e-6, 1e-5] {
            let chain = disturbed(nominal.chain(), amount, &mut random);
            let solver = Solver::new(&chain).unwrap();
            assert_eq!(
                solver.choice().name,
                nominal.choice().name,
                "{id} off by {amount:e}"
            );
            for _ in 0..100 {
                let q = random_joints(&chain, &mut random);
                let pose = tool_pose(&chain, &q).unwrap();
                solver.solve_into(&pose, &mut found).unwrap();
                let what = format!(
                    "{id} off by {amount:e} {q:?} sigma {:e} {:?} slack {:e}",
                    sigma(&solver, &q),
                    found.reason(),
                    solver.choice().slack
                );
                assert_eq!(found.status(), Status::Solved, "{what}");
                check_closes(&solver, &q, &found, &what);
                // Within a few misses of a singularity the roots of the class and of the arm differ in number.
                if sigma(&solver, &q) > 1e-3_f64.max(100.0 * amount.sqrt()) {
                    assert!(
                        contains(&solver, &q, &found, 1e-8),
                        "{what}: {:?}",
                        found.as_slice()
                    );
                }
            }
        }
    }
}
