//! Fewer than six joints: every solution of poses in reach, the part that fails of those out of it.

use super::random_arms::{Row, align, meet, row, sigma, solver};
use super::{check_closes, contains};
use crate::support::random_joints;
use pieper::ik::Solutions;
use pieper::kinematics::tool_pose;

/// Random arms of `joints` joints: the generating joint values are in the set, nothing is listed twice.
fn check(
    what: &str,
    joints: usize,
    slides: bool,
    shape: impl Fn(&mut Vec<Row>, &mut fastrand::Rng),
) {
    let mut random = fastrand::Rng::with_seed(21);
    let (mut regular, mut missed, mut numeric) = (0, 0, 0);
    let mut first = String::new();
    let mut found = Solutions::default();
    for arm in 0..60 {
        let mut rows: Vec<Row> = (0..joints).map(|_| row(&mut random, true)).collect();
        if slides {
            rows[random.usize(..joints)].turns = false;
        }
        shape(&mut rows, &mut random);
        let solver = solver(&rows);
        if solver.choice().name == "numeric" {
            // Axes that coincide, four that meet or are parallel: no pose has isolated solutions.
            let mut seen = || sigma(&solver, &random_joints(solver.chain(), &mut random));
            let most = (0..8).map(|_| seen()).fold(0.0, f64::max);
            let text = format!("{what} {joints} arm {arm} is left to the search, sigma {most:e}");
            assert!(slides || most < 1e-6, "{text}");
            numeric += 1;
            if most < 1e-6 {
                continue;
            }
        }
        for _ in 0..20 {
            let q = random_joints(solver.chain(), &mut random);
            let sigma = sigma(&solver, &q);
            if sigma < 1e-4 {
                continue;
            }
            regular += 1;
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let count =
                crate::hot_calls::allocations(|| solver.solve_into(&pose, &mut found).unwrap());
            assert_eq!(count, 0, "{what} {joints} arm {arm}");
            let text = format!(
                "{what} {joints} arm {arm} {} {q:?} sigma {sigma:e}",
                solver.choice().name
            );
            check_closes(&solver, &q, &found, &text);
            if !contains(&solver, &q, &found, (1e-12 / sigma).max(1e-8)) {
                missed += 1;
                if first.is_empty() {
                    first = format!("{text} {:?} {:?}", found.status(), found.reason());
                }
            }
        }
    }
    assert_eq!(missed, 0, "{what} {joints}: of {regular}, first {first}");
    assert!(
        numeric < 30,
        "{what} {joints}: {numeric} of 60 arms are left to the search"
    );
}

#[test]
fn random_arms_that_turn() {
    for joints in 1..=5 {
        check("turns", joints, false, |_, _| ());
    }
}

#[test]
fn random_arms_with_a_slide() {
    for joints in 1..=4 {
        check("one slide", joints, true, |_, _| ());
    }
}

/// The usual five-axis arm: a shoulder, three parallel axes, a roll.
#[test]
fn five_axes_three_of_them_parallel() {
    check("parallel", 5, false, |rows, random| align(rows, 1, random));
}

/// The other: an elbow, a bend and a roll that meet.
#[test]
fn five_axes_with_two_that_meet() {
    check("meeting", 5, false, |rows, random| {
        meet(rows, 2, random);
        rows[2].a = 0.3;
    });
}
