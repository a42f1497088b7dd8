//! Random arms of each class: the generating joint values are always in the set.

use super::{check_closes, contains};
use crate::support::random_joints;
use pieper::describe::Robot;
use pieper::ik::{Solutions, Solver};
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian, tool_pose};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::fmt::Write as _;

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) turns: bool,
    pub(crate) theta: f64,
    pub(crate) d: f64,
    pub(crate) a: f64,
    pub(crate) alpha: f64,
}

pub(crate) fn solver(rows: &[Row]) -> Solver {
    let mut text = "name = 'r'\nconvention = 'standard'\n".to_owned();
    for (index, row) in rows.iter().enumerate() {
        let (theta, d) = (row.theta, row.d);
        let moving = |offset: f64| format!("\"{offset} + q{}\"", index + 1);
        let (theta, d) = if row.turns {
            (moving(theta), d.to_string())
        } else {
            (theta.to_string(), moving(d))
        };
        let _ = writeln!(
            text,
            "[[joint]]\ntheta = {theta}\nd = {d}\na = {}\nalpha = {}",
            row.a, row.alpha
        );
    }
    let robot = Robot::from_toml("random.toml", &text).unwrap();
    Solver::new(&robot.chain().unwrap()).unwrap()
}

/// Twists of 0, 45 and 90 degrees or odd ones, half of all lengths zero.
pub(crate) fn row(random: &mut fastrand::Rng, turns: bool) -> Row {
    let mut length = || {
        if random.bool() {
            0.0
        } else {
            random.f64() - 0.5
        }
    };
    let (d, a) = (length(), length());
    let alpha = match random.u8(..5) {
        0 => 0.0,
        1 => FRAC_PI_4,
        2 => FRAC_PI_2,
        3 => -FRAC_PI_2,
        _ => 3.0 * (random.f64() - 0.5),
    };
    let theta = if random.bool() {
        0.0
    } else {
        6.0 * (random.f64() - 0.5)
    };
    Row {
        turns,
        theta,
        d,
        a,
        alpha,
    }
}

/// Makes the axes `first` to `first + 2` pass through a point.
pub(crate) fn meet(rows: &mut [Row], first: usize, random: &mut fastrand::Rng) {
    for row in &mut rows[first..first + 2] {
        row.a = 0.0;
        row.alpha = match random.u8(..3) {
            0 => FRAC_PI_2,
            1 => -FRAC_PI_2,
            _ => 0.3 + 2.0 * random.f64(),
        };
    }
    rows[first + 1].d = 0.0;
}

/// Makes them parallel.
pub(crate) fn align(rows: &mut [Row], first: usize, random: &mut fastrand::Rng) {
    for row in &mut rows[first..first + 2] {
        row.a = 0.2 + 0.3 * random.f64();
        row.alpha = if random.u8(..4) == 0 {
            std::f64::consts::PI
        } else {
            0.0
        };
    }
}

/// The smallest singular value of the Jacobian.
pub(crate) fn sigma(solver: &Solver, q: &[f64]) -> f64 {
    let mut jacobian = Jacobian::zeros(q.len());
    pose_and_jacobian(solver.chain(), q, Reference::Base, &mut jacobian).unwrap();
    jacobian.singular_values().min()
}

/// Runs `arms` random arms with `targets` each; those that the row `name` does not take are left out.
fn check(name: &str, make: impl Fn(&mut fastrand::Rng) -> Vec<Row>, arms: usize, targets: usize) {
    let mut random = fastrand::Rng::with_seed(7);
    let (mut taken, mut missed, mut regular) = (0, 0, 0);
    let mut found = Solutions::default();
    let mut first = String::new();
    for arm in 0..arms {
        let rows = make(&mut random);
        let solver = solver(&rows);
        if solver.choice().name != name {
            continue;
        }
        taken += 1;
        for target in 0..targets {
            let q = random_joints(solver.chain(), &mut random);
            let sigma = sigma(&solver, &q);
            if sigma < 1e-5 {
                continue;
            }
            regular += 1;
            let pose = tool_pose(solver.chain(), &q).unwrap();
            solver.solve_into(&pose, &mut found).unwrap();
            let what = format!(
                "{name} arm {arm} {:?} target {target} {q:?}",
                solver
                    .chain()
                    .variables()
                    .iter()
                    .map(|v| v.kind.is_angular() as u8)
                    .collect::<Vec<_>>()
            );
            check_closes(&solver, &q, &found, &what);
            if !contains(&solver, &q, &found, (1e-12 / sigma).max(1e-8)) {
                missed += 1;
                if first.is_empty() {
                    first = format!(
                        "{what} sigma {sigma:e} {:?} {} {:?}",
                        solver.choice().class,
                        found.len(),
                        found.reason()
                    );
                }
            }
        }
    }
    assert!(
        taken * 4 > arms,
        "{name}: only {taken} of {arms} arms belong to the class"
    );
    assert_eq!(
        missed, 0,
        "{name}: missed of {regular} over {taken} arms, first {first}"
    );
}

#[test]
fn spherical_wrists_anywhere() {
    for first in [3, 0, 1, 2] {
        let make = |random: &mut fastrand::Rng| {
            let mut rows: Vec<Row> = (0..6).map(|_| row(random, true)).collect();
            meet(&mut rows, first, random);
            rows
        };
        check("spherical", make, 500, 40);
    }
}

#[test]
fn three_parallel_axes_anywhere() {
    for first in [1, 2, 0, 3] {
        let make = |random: &mut fastrand::Rng| {
            let mut rows: Vec<Row> = (0..6).map(|_| row(random, true)).collect();
            align(&mut rows, first, random);
            rows
        };
        check("three-parallel", make, 500, 40);
    }
}

#[test]
fn spherical_wrists_behind_slides() {
    for kinds in 0..7_u8 {
        let make = |random: &mut fastrand::Rng| {
            let mut rows: Vec<Row> = (0..6)
                .map(|k| row(random, k > 2 || kinds >> k & 1 == 1))
                .collect();
            meet(&mut rows, 3, random);
            rows
        };
        check("spherical", make, 200, 30);
    }
}

/// Six joints of which as many as given slide, in every order.
fn with_slides(name: &str, count: u32, arms: usize, targets: usize) {
    for kinds in (0..63_u8).filter(|kinds| kinds.count_ones() == count) {
        let make = |random: &mut fastrand::Rng| -> Vec<Row> {
            (0..6).map(|k| row(random, kinds >> k & 1 == 0)).collect()
        };
        check(name, make, arms, targets);
    }
}

#[test]
fn one_slide_anywhere() {
    with_slides("general", 1, 20, 20);
}

#[test]
fn two_slides_anywhere() {
    with_slides("general", 2, 10, 20);
}

#[test]
fn three_slides_anywhere() {
    with_slides("three-slides", 3, 40, 20);
}
