//! Arms made to break solvers: axes nearly parallel and nearly meeting, lengths from 1e-6 to 1e6, any number of joints.

use super::random_arms::{Row, solver as prepared};
use crate::support::{difference, random_joints};
use pieper::ik::{Goal, Question, Solutions, Solver};
use pieper::kinematics::tool_pose;
use std::f64::consts::{FRAC_PI_2, PI};
use std::time::{Duration, Instant};

fn hair(random: &mut fastrand::Rng) -> f64 {
    let size = 10_f64.powf(-16.0 * random.f64());
    if random.bool() { size } else { -size }
}

fn row(random: &mut fastrand::Rng, scale: f64) -> Row {
    let mut length = || match random.u8(..5) {
        0 | 1 => 0.0,
        2 => scale * hair(random),
        3 => scale * (random.f64() - 0.5),
        _ => 10_f64.powf(12.0 * random.f64() - 6.0),
    };
    let (d, a) = (length(), length());
    let right = [0.0, FRAC_PI_2, -FRAC_PI_2, PI][random.usize(..4)];
    let alpha = match random.u8(..4) {
        0 | 1 => right,
        2 => right + hair(random),
        _ => 6.0 * (random.f64() - 0.5),
    };
    Row {
        turns: random.u8(..6) > 0,
        theta: [0.0, FRAC_PI_2, 1.0, hair(random)][random.usize(..4)],
        d,
        a,
        alpha,
    }
}

/// Whatever is answered verifies, and within a bounded time.
#[test]
fn whatever_is_answered_verifies() {
    let mut random = fastrand::Rng::with_seed(71);
    let mut found = Solutions::default();
    let (mut answers, mut slowest) = (0, Duration::ZERO);
    for arm in 0..400 {
        let joints = random.usize(1..=8);
        let scale = 10_f64.powf(4.0 * random.f64() - 2.0);
        let rows: Vec<Row> = (0..joints).map(|_| row(&mut random, scale)).collect();
        let whole = prepared(&rows);
        let reach: f64 = rows.iter().map(|row| row.a.abs() + row.d.abs()).sum();
        for goal in Goal::ALL {
            let question = Question {
                goal,
                ..Question::default()
            };
            let Ok(solver) = Solver::prepare(whole.chain(), &question) else {
                // Nothing turns.
                assert!(goal == Goal::Axis && rows.iter().all(|row| !row.turns));
                continue;
            };
            let mut q = random_joints(solver.chain(), &mut random);
            if random.bool() {
                q.fill(0.0);
            }
            let mut pose = tool_pose(solver.chain(), &q).unwrap();
            if random.u8(..4) == 0 {
                pose.translation.vector *= 1.0 + hair(&mut random);
            }
            let begin = Instant::now();
            solver.solve_into(&pose, &mut found).unwrap();
            slowest = slowest.max(begin.elapsed());
            let text = format!("arm {arm} {goal:?} {} {q:?} {rows:?}", solver.choice().name);
            let scale = 1.0
                + reach
                + pose.translation.vector.norm()
                + q.iter().fold(0.0, |m, x| x.abs().max(m));
            for solution in &found {
                answers += 1;
                let reached = tool_pose(solver.chain(), solution.q()).unwrap();
                let (shift, turn) = goal.miss(&reached, &pose);
                assert!(
                    shift <= 1e-11 * scale && turn <= 1e-11,
                    "{text}: {shift:e} {turn:e}"
                );
                if goal == Goal::Pose {
                    let miss = difference(&reached, &pose);
                    assert!(
                        (miss - solution.residual).abs() <= 1e-13 * scale,
                        "{text}: {miss:e}"
                    );
                }
            }
            for family in found.families() {
                answers += 1;
                let reached = tool_pose(solver.chain(), family.q()).unwrap();
                let (shift, turn) = goal.miss(&reached, &pose);
                assert!(
                    shift <= 1e-11 * scale && turn <= 1e-11,
                    "{text}: {shift:e} {turn:e}"
                );
            }
        }
    }
    assert!(answers > 2000, "{answers}");
    // Debug builds and busy machines included.
    assert!(slowest < Duration::from_secs(20), "{slowest:?}");
}

/// A slide that follows a joint that turns: a whole turn of that joint is no way to wrap its value.
#[test]
fn a_slide_that_follows_a_turn_keeps_its_value() {
    use pieper::model::{Chain, ChainParts, Drive, Joint, JointKind, Motion, Variable};
    use pieper::spatial::Pose;
    let joint = |name: &str, motion| Joint {
        name: name.to_owned(),
        link: name.to_owned(),
        before: Pose::identity(),
        motion,
        after: pieper::spatial::shift(nalgebra::Vector3::new(0.3, 0.0, 0.0)),
    };
    let drive = Drive {
        variable: 0,
        factor: 1.0,
        offset: 0.0,
    };
    let chain = Chain::new(ChainParts {
        variables: vec![Variable::new("q1", JointKind::Revolute)],
        joints: vec![
            joint("turn", Motion::turn_z(drive)),
            joint(
                "lift",
                Motion::slide_z(Drive {
                    factor: 0.5,
                    ..drive
                }),
            ),
        ],
        base: Pose::identity(),
        tool: Pose::identity(),
    })
    .unwrap();
    let solver = Solver::new(&chain).unwrap();
    for q in [-3.0, 0.4, 3.1, 3.5] {
        let pose = tool_pose(&chain, &[q]).unwrap();
        let found = solver.solve(&pose).unwrap();
        assert_eq!(found.len(), 1, "{q} {:?}", found.reason());
        assert!(
            (found.as_slice()[0].q()[0] - q).abs() < 1e-9,
            "{q} {found:?}"
        );
    }
}
