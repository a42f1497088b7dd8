//! Closed-form inverses: as many verified solutions as the library finds, on every arm that has a closed form.

use pieper::kinematics;
use pieper_symbolic::{Arm, Lengths, inverse};

use crate::numbers::with_numbers;

/// Arms whose closed form must be found; the library knows more arms than Paul's method does.
const CLOSED: &[&str] = &[
    "ar3",
    "ar3-annin",
    "ar4",
    "ar4-modified",
    "six-axis",
    "puma560",
    "stanford",
    "cobra600",
    "irb120",
    "irb1200",
    "irb140",
    "irb2400",
    "ur3",
    "ur5",
    "ur5e",
    "ur10",
    "ur10e",
    "ur16e",
    "ur20",
    "ur30",
    "kuka-kr6-r700",
    "staubli-tx60",
];

fn check(id: &str) {
    let robot = with_numbers(&pieper_robots::find(id).unwrap().robot());
    let chain = robot.chain().unwrap();
    let arm = Arm::new(&robot, Lengths::Symbols).unwrap();
    let inverse = inverse::derive(&arm).unwrap_or_else(|error| panic!("{id}: {error}"));
    let solver = pieper::ik::Solver::new(&chain).unwrap();
    let mut random = fastrand::Rng::with_seed(11);
    for _ in 0..100 {
        let q: Vec<f64> = (0..arm.dof()).map(|_| 6.0 * random.f64() - 3.0).collect();
        let pose = kinematics::tool_pose(&chain, &q).unwrap();
        let is_solution = |q: &Vec<f64>| {
            let other = kinematics::tool_pose(&chain, q).unwrap();
            (other.to_homogeneous() - pose.to_homogeneous()).amax() < 1e-8
        };
        let found: Vec<Vec<f64>> = inverse::solve(&inverse, &pose, 0.0)
            .into_iter()
            .filter(is_solution)
            .collect();
        let expected = solver.solve(&pose).unwrap();
        assert_eq!(found.len(), expected.iter().count(), "{id} at {q:?}");
        for solution in expected.iter() {
            let off = |other: &Vec<f64>| {
                let differences = other.iter().zip(solution.q()).map(|(a, b)| {
                    let difference = a - b;
                    difference.sin().atan2(difference.cos()).abs()
                });
                differences.fold(0.0, f64::max)
            };
            assert!(
                found.iter().any(|other| off(other) < 1e-6),
                "{id} at {q:?}: {:?}",
                solution.q()
            );
        }
    }
}

#[test]
fn closed_forms_find_what_the_library_finds() {
    CLOSED.iter().for_each(|id| check(id));
}

#[test]
fn arms_without_a_closed_form_are_told_why() {
    for (id, words) in [
        ("iiwa7", "7 joints"),
        ("jaco2", "no equation with a single unknown"),
    ] {
        let robot = pieper_robots::find(id).unwrap().robot();
        let error = inverse::derive(&Arm::new(&robot, Lengths::Symbols).unwrap())
            .unwrap_err()
            .to_string();
        assert!(
            error.contains(words) && error.contains("pieper ik"),
            "{error}"
        );
    }
}

/// The equation with one unknown holds at every solution the library finds, the other joints follow from it, and beside the solutions it does
/// not hold.
#[test]
fn one_unknown_holds_at_every_solution() {
    let offset = include_str!("../../../../examples/ar3-offset-wrist.toml");
    let offset = pieper::describe::Robot::from_toml("ar3-offset-wrist.toml", offset).unwrap();
    let built_in = |id: &str| pieper_robots::find(id).unwrap().robot();
    for robot in [offset, built_in("jaco2"), built_in("fanuc-crx10ia")] {
        let id = robot.name.clone();
        let chain = robot.chain().unwrap();
        let arm = Arm::new(&robot, Lengths::Symbols).unwrap();
        assert!(inverse::derive(&arm).is_err(), "{id} has a closed form");
        let found = inverse::OneUnknown::derive(&arm).unwrap();
        let solver = pieper::ik::Solver::new(&chain).unwrap();
        let mut random = fastrand::Rng::with_seed(7);
        let (mut solutions, mut beside) = (0, 0);
        for _ in 0..100 {
            let q: Vec<f64> = (0..arm.dof()).map(|_| 6.0 * random.f64() - 3.0).collect();
            let pose = kinematics::tool_pose(&chain, &q).unwrap();
            for solution in solver.solve(&pose).unwrap().iter() {
                let is_it = |(other, left): &(Vec<f64>, f64)| {
                    let near = other
                        .iter()
                        .zip(solution.q())
                        .all(|(a, b)| ((a - b) * 0.5).sin().abs() < 1e-6);
                    near && left.abs() < 1e-7
                };
                let branches = found.at(&pose, solution.q()[found.joint], 0.0);
                assert!(branches.iter().any(is_it), "{id} at {:?}", solution.q());
                solutions += 1;
            }
            for (_, left) in found.at(&pose, 6.0 * random.f64() - 3.0, 0.0) {
                beside += usize::from(left.abs() > 1e-7);
            }
        }
        assert!(
            solutions >= 200 && beside >= 50,
            "{id}: {solutions} {beside}"
        );
    }
}
