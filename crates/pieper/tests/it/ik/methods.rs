//! Matrices and quaternions give the same answers, also where the wrist has no right angles and where it is singular.

use super::closed_forms;
use super::distance;
use super::random_arms::{Row, meet, row, sigma, solver as random_solver};
use crate::support::random_joints;
use pieper::ik::{Method, Question, Solver};
use pieper::kinematics::tool_pose;

/// With `singular`, some poses have the wrist's middle joint at zero.
fn check(by_matrix: &Solver, singular: bool, random: &mut fastrand::Rng, what: &str) {
    let chain = by_matrix.chain();
    let question = Question {
        method: Method::Quaternion,
        ..Question::default()
    };
    let by_quaternion = Solver::prepare(chain, &question).unwrap();
    for round in 0..20 {
        let mut q = random_joints(chain, random);
        if round % 4 == 0 && singular {
            q[4] = 0.0;
        }
        let pose = tool_pose(chain, &q).unwrap();
        let (a, b) = (
            by_matrix.solve(&pose).unwrap(),
            by_quaternion.solve(&pose).unwrap(),
        );
        let text = format!("{what} {q:?}");
        if !singular && !a.families().is_empty() {
            // Singular at every pose: which roots of a family are proposed is a matter of rounding.
            continue;
        }
        assert_eq!(a.status(), b.status(), "{text}");
        assert_eq!(
            (a.len(), a.families().len()),
            (b.len(), b.families().len()),
            "{text}"
        );
        for (a, b) in a.iter().zip(&b) {
            assert_eq!(
                (a.branch, a.multiplicity),
                (b.branch, b.multiplicity),
                "{text}"
            );
            let gap = distance(chain, a.q(), b.q());
            let sigma = sigma(by_matrix, a.q());
            assert!(
                gap < (1e-12 / sigma).max(1e-9),
                "{text}: {gap:e} sigma {sigma:e}"
            );
        }
    }
}

#[test]
fn matrices_and_quaternions_agree() {
    let mut random = fastrand::Rng::with_seed(51);
    let mut count = 0;
    for (id, solver) in closed_forms() {
        if ["spherical", "swivel"].contains(&solver.choice().name) {
            count += 1;
            check(&solver, true, &mut random, id);
        }
    }
    assert!(count > 20);
    for arm in 0..60 {
        let mut rows: Vec<Row> = (0..6).map(|_| row(&mut random, true)).collect();
        meet(&mut rows, 3, &mut random);
        let solver = random_solver(&rows);
        if solver.choice().name == "spherical" {
            check(&solver, false, &mut random, &format!("random {arm}"));
        }
    }
}
