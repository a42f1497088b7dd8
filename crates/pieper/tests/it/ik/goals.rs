//! Parts of poses: position, axis, both; and why they cannot be met.

use super::contains;
use super::random_arms::{Row, row, solver as random_solver};
use crate::support::random_joints;
use nalgebra::Vector3;
use pieper::ik::{Goal, Question, Solutions, Solver, Status};
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian, tool_pose};
use pieper::model::Chain;
use pieper::spatial::shift;

fn asked(chain: &Chain, goal: Goal) -> Solver {
    let question = Question {
        goal,
        ..Question::default()
    };
    Solver::prepare(chain, &question).unwrap()
}

/// The smallest singular value of the conditions that a goal sets.
fn sigma(chain: &Chain, q: &[f64], goal: Goal) -> f64 {
    let mut jacobian = Jacobian::zeros(q.len());
    pose_and_jacobian(chain, q, Reference::Tool, &mut jacobian).unwrap();
    let rows = match goal {
        Goal::Pose => vec![0, 1, 2, 3, 4, 5],
        Goal::Position => vec![0, 1, 2],
        Goal::Axis => vec![3, 4],
        Goal::PositionAxis => vec![0, 1, 2, 3, 4],
    };
    jacobian.select_rows(&rows).singular_values().min()
}

/// Random arms with as many joints as the goal has conditions, or fewer: all solutions, the generating one among them.
fn check_isolated(goal: Goal, joints: usize) {
    let mut random = fastrand::Rng::with_seed(31);
    let (mut regular, mut missed) = (0, 0);
    let mut first = String::new();
    for arm in 0..60 {
        let rows: Vec<Row> = (0..joints).map(|_| row(&mut random, true)).collect();
        let chain = random_solver(&rows).chain().clone();
        let solver = asked(&chain, goal);
        for _ in 0..10 {
            let q = random_joints(&chain, &mut random);
            if sigma(&chain, &q, goal) < 1e-3 {
                continue;
            }
            regular += 1;
            let pose = tool_pose(&chain, &q).unwrap();
            let found = solver.solve(&pose).unwrap();
            let text = format!("{goal:?} {joints} arm {arm} {} {q:?}", solver.choice().name);
            for solution in &found {
                let reached = tool_pose(&chain, solution.q()).unwrap();
                let (shift, turn) = goal.miss(&reached, &pose);
                assert!(shift < 1e-11 && turn < 1e-11, "{text}: {shift:e} {turn:e}");
                assert!(solution.residual < 1e-11);
                assert_eq!(solution.q().len(), joints);
            }
            if !contains(&solver, &q, &found, 1e-7) {
                missed += 1;
                first = format!("{text} {:?} {:?} {found:?}", found.status(), found.reason());
            }
        }
    }
    assert!(regular > 150, "{goal:?} {joints}: {regular}");
    assert_eq!(missed, 0, "{goal:?} {joints}: of {regular}, last {first}");
}

#[test]
fn as_many_joints_as_conditions() {
    check_isolated(Goal::Position, 3);
    check_isolated(Goal::Axis, 2);
    check_isolated(Goal::PositionAxis, 5);
}

#[test]
fn fewer_joints_than_conditions() {
    check_isolated(Goal::Position, 2);
    check_isolated(Goal::Axis, 1);
    check_isolated(Goal::PositionAxis, 4);
    check_isolated(Goal::PositionAxis, 3);
}

/// More joints than conditions: families, whose members meet the goal, the generating joint values on one of them.
#[test]
fn more_joints_than_conditions() {
    let mut random = fastrand::Rng::with_seed(32);
    for id in ["ar3", "ur5", "stanford", "cobra600", "panda", "gantry"] {
        let chain = pieper_robots::find(id).unwrap().robot().chain().unwrap();
        for goal in Goal::ALL {
            let solver = asked(&chain, goal);
            let mut on_one = 0;
            for _ in 0..6 {
                let mut q = random_joints(&chain, &mut random);
                if goal == Goal::Axis {
                    // What slides does not matter, and stands as close to zero as it may.
                    for (value, variable) in q.iter_mut().zip(chain.variables()) {
                        if !variable.kind.is_angular() {
                            *value = variable
                                .limits
                                .map_or(0.0, |l| 0.0_f64.clamp(l.lower(), l.upper()));
                        }
                    }
                }
                let pose = tool_pose(&chain, &q).unwrap();
                let found = solver.solve(&pose).unwrap();
                let text = format!("{id} {goal:?} {} {q:?}", solver.choice().name);
                assert_ne!(found.status(), Status::Unreachable, "{text}");
                for family in found.families() {
                    let samples = solver.samples(family, 10);
                    assert!(samples.len() >= 8, "{text}: {}", samples.len());
                    assert_eq!(family.q().len(), chain.dof());
                    for member in samples.iter().map(Vec::as_slice).chain([family.q()]) {
                        let reached = tool_pose(&chain, member).unwrap();
                        let (shift, turn) = goal.miss(&reached, &pose);
                        assert!(shift < 1e-11 && turn < 1e-11, "{text}: {shift:e} {turn:e}");
                    }
                    for member in solver.samples_within(family, 10) {
                        assert!(
                            chain.limit_violations(&member).is_empty(),
                            "{text} {member:?}"
                        );
                        let (shift, turn) = goal.miss(&tool_pose(&chain, &member).unwrap(), &pose);
                        assert!(shift < 1e-11 && turn < 1e-11, "{text}: {shift:e} {turn:e}");
                    }
                }
                on_one += usize::from(contains(&solver, &q, &found, 1e-6));
            }
            assert_eq!(on_one, 6, "{id} {goal:?} {}", solver.choice().name);
        }
    }
}

/// The part of a pose that an arm lacks joints for is named, with the least miss.
#[test]
fn the_part_that_fails() {
    let text = "name = 'five'
convention = 'standard'
[[joint]]
theta = 'q1'
d = 0.3
alpha = 'pi/2'
[[joint]]
theta = 'q2'
a = 0.4
[[joint]]
theta = 'q3'
a = 0.3
[[joint]]
theta = 'q4'
alpha = 'pi/2'
[[joint]]
theta = 'q5'
d = 0.1";
    let robot = pieper::describe::Robot::from_toml("five.toml", text).unwrap();
    let chain = robot.chain().unwrap();
    let solver = Solver::new(&chain).unwrap();
    let q = [0.3, 0.8, -1.2, 0.5, 0.7];
    let pose = tool_pose(&chain, &q).unwrap();
    assert!(contains(&solver, &q, &solver.solve(&pose).unwrap(), 1e-9));

    let far = shift(Vector3::new(0.0, 0.0, 1.25)) * pose;
    let mut found = Solutions::default();
    let count = crate::hot_calls::allocations(|| solver.solve_into(&far, &mut found).unwrap());
    assert_eq!(count, 0, "measuring a miss allocates nothing");
    let reason = found.reason().unwrap().to_string();
    assert!(
        reason.starts_with("the tool's point comes no closer than "),
        "{reason}"
    );
    let nearest = found.nearest().unwrap();
    let reach = (far.translation.vector - Vector3::new(0.0, 0.0, 0.3)).norm() - 0.8;
    assert!(
        (nearest.position_error - reach).abs() < 1e-6,
        "{nearest:?} {reach}"
    );

    // Axis 5 stays in the upright plane through axis 1 and the tool's point: a tilt out of it fails by that tilt.
    let radial = Vector3::new(pose.translation.x, pose.translation.y, 0.0).normalize();
    let tilt = nalgebra::Rotation3::from_scaled_axis(radial * 0.03);
    let mut tilted = pose;
    tilted.rotation = tilt * pose.rotation;
    let out_of_plane = (tilted.rotation * Vector3::z())
        .dot(&radial.cross(&Vector3::z()))
        .asin()
        .abs();
    let found = solver.solve(&tilted).unwrap();
    let reason = found.reason().unwrap();
    assert!(
        reason.to_string().starts_with("the tool's axis: "),
        "{reason}"
    );
    assert!(
        (reason.amount - out_of_plane).abs() < 1e-6,
        "{reason} {out_of_plane}"
    );
    assert!(found.nearest().unwrap().position_error < 1e-6);

    // Four joints of it put point and axis in place, and cannot turn the tool.
    let question = Question {
        held: vec![(4, 0.0)],
        ..Question::default()
    };
    let four = Solver::prepare(&chain, &question).unwrap();
    let turned = tool_pose(&chain, &[0.3, 0.8, -1.2, 0.5, 0.25]).unwrap();
    let found = four.solve(&turned).unwrap();
    let reason = found.reason().unwrap();
    assert!(
        reason
            .to_string()
            .starts_with("the turn about the tool's axis: 0.2500 rad"),
        "{reason}"
    );
}
