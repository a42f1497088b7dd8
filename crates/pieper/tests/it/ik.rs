//! Inverse kinematics: forward kinematics closes, and the joint values that made a pose are among the answers.

mod adversarial;
mod classes;
mod fewer;
mod goals;
mod hair;
mod methods;
mod offset_wrists;
mod random_arms;
mod redundant;
mod search;
mod singular;

use crate::support::{arms, difference, random_joints};
use pieper::ik::{Goal, Question, Solutions, Solver, Status};
use pieper::kinematics::{link_poses, tool_pose};
use pieper::model::Chain;

/// The largest difference of two joint vectors, angles modulo whole turns.
pub(crate) fn distance(chain: &Chain, a: &[f64], b: &[f64]) -> f64 {
    let gap = |(variable, (x, y)): (&pieper::model::Variable, (&f64, &f64))| {
        let step = x - y;
        if variable.kind.is_angular() {
            (step - std::f64::consts::TAU * (step / std::f64::consts::TAU).round()).abs()
        } else {
            step.abs()
        }
    };
    chain
        .variables()
        .iter()
        .zip(a.iter().zip(b))
        .map(gap)
        .fold(0.0, f64::max)
}

/// Every solution closes to 1e-12, no two are the same, angles are wrapped; the family members close to 1e-9.
pub(crate) fn check_closes(solver: &Solver, q: &[f64], found: &Solutions, what: &str) {
    let chain = solver.chain();
    let pose = tool_pose(chain, q).unwrap();
    let scale = pose.translation.vector.amax().max(1.0);
    for (index, solution) in found.iter().enumerate() {
        let miss = difference(&tool_pose(chain, solution.q()).unwrap(), &pose);
        assert!(
            miss <= 1e-12 * scale,
            "{what}: a solution misses by {miss:e}"
        );
        assert!(
            (miss - solution.residual).abs() < 1e-14 * scale,
            "{what}: residual says {}, measured {miss}",
            solution.residual
        );
        for (value, variable) in solution.q().iter().zip(chain.variables()) {
            let wrapped = -std::f64::consts::PI < *value && *value <= std::f64::consts::PI;
            assert!(
                wrapped || !variable.kind.is_angular(),
                "{what}: {value} is not wrapped"
            );
        }
        for other in &found.as_slice()[..index] {
            let gap = distance(chain, solution.q(), other.q());
            assert!(
                gap > 1e-9,
                "{what}: a solution is listed twice, {gap:e} apart at {:?}",
                solution.q()
            );
        }
    }
}

fn contains(solver: &Solver, q: &[f64], found: &Solutions, tolerance: f64) -> bool {
    let near = |other: &[f64]| distance(solver.chain(), other, q) <= tolerance;
    found.iter().any(|solution| near(solution.q()))
        || found
            .families()
            .iter()
            .any(|family| near(&solver.nearest_member(family, q).unwrap()))
}

/// Arms whose solver is a closed form: not those with an offset wrist, whose equation is solved in numbers.
fn closed_forms() -> impl Iterator<Item = (&'static str, Solver)> {
    arms()
        .map(|(id, chain)| (id, Solver::new(&chain).unwrap()))
        .filter(|(_, solver)| {
            !["offset-wrist", "general", "numeric"].contains(&solver.choice().name)
        })
}

#[test]
fn the_generating_joint_values_are_found() {
    let mut random = fastrand::Rng::with_seed(11);
    for (id, solver) in closed_forms().filter(|(_, solver)| solver.chain().dof() <= 6) {
        let mut found = Solutions::default();
        for round in 0..1000 {
            let q = random_joints(solver.chain(), &mut random);
            let pose = tool_pose(solver.chain(), &q).unwrap();
            solver.solve_into(&pose, &mut found).unwrap();
            let what = format!("{id} target {round} {q:?}");
            assert_eq!(found.status(), Status::Solved, "{what}");
            check_closes(&solver, &q, &found, &what);
            let tolerance = 1e-8;
            assert!(
                contains(&solver, &q, &found, tolerance),
                "{what}: not among {:?}",
                found.as_slice()
            );
        }
    }
}

#[test]
fn solving_allocates_nothing() {
    let mut random = fastrand::Rng::with_seed(2);
    let mut found = Solutions::default();
    let goals = ["irb140", "cobra600", "panda"].into_iter().flat_map(|id| {
        let chain = pieper_robots::find(id).unwrap().robot().chain().unwrap();
        Goal::ALL.map(|goal| {
            let question = Question {
                goal,
                ..Question::default()
            };
            (id, Solver::prepare(&chain, &question).unwrap())
        })
    });
    for (id, solver) in closed_forms().chain(goals) {
        for singular in [false, true] {
            let mut q = random_joints(solver.chain(), &mut random);
            if singular {
                q.fill(0.0);
            }
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let count =
                crate::hot_calls::allocations(|| solver.solve_into(&pose, &mut found).unwrap());
            assert_eq!(count, 0, "{id} {:?}", solver.goal());
        }
    }
}

#[test]
fn whole_turns_within_limits_and_order() {
    let chain = pieper_robots::find("ur5").unwrap().robot().chain().unwrap();
    let solver = Solver::new(&chain).unwrap();
    let q = [0.3, -1.0, 1.2, 0.4, 0.9, -2.0];
    let found = solver.solve(&tool_pose(&chain, &q).unwrap()).unwrap();
    let mut all = pieper::ik::windings(&chain, &found);
    // Six joints of two turns each: each of up to eight solutions has 64 copies.
    assert_eq!(all.len(), 64 * found.len());
    let seed = [0.3, -1.0, 1.2, 0.4 - std::f64::consts::TAU, 0.9, -2.0];
    pieper::ik::rank(&chain, &mut all, pieper::ik::Ranking::Seed(&seed));
    assert!(
        all[0]
            .q()
            .iter()
            .zip(seed)
            .all(|(a, b)| (a - b).abs() < 1e-9)
    );
    assert!(all.iter().all(|one| one.within_limits));
}

/// Seven joints: families, every sampled member closes, and the generating joint values are on one of them.
/// Front and back as a person standing beside the arm says it: by whether the wrist lies on the side of axis 1 to which the
/// shoulder is set off, or, without an offset, to which the table's x points.
#[test]
fn shoulders_are_named_as_people_see_them() {
    let mut random = fastrand::Rng::with_seed(12);
    let mut seen = [0, 0];
    for (id, solver) in closed_forms().filter(|(id, _)| {
        [
            "ar3",
            "irb120",
            "irb2400",
            "irb6640",
            "kuka-kr6-r700",
            "fanuc-m10ia",
            "staubli-tx60",
        ]
        .contains(id)
    }) {
        let chain = solver.chain();
        let mut frames = Vec::new();
        for _ in 0..60 {
            let q = random_joints(chain, &mut random);
            link_poses(chain, &q, &mut frames).unwrap();
            let axis = chain.canonical().base;
            let wrist = axis.inverse_transform_point(&frames[3].translation.vector.into());
            let shoulder = axis.inverse_transform_point(&frames[0].translation.vector.into());
            let mut forward = nalgebra::Vector2::new(shoulder.x, shoulder.y);
            if forward.norm() < 1e-9 {
                let x = axis
                    .inverse_transform_vector(&frames[0].rotation.matrix().column(0).into_owned());
                forward = nalgebra::Vector2::new(x.x, x.y);
            }
            let front = forward.x * wrist.x + forward.y * wrist.y > 0.0;
            let found = solver.solve(&tool_pose(chain, &q).unwrap()).unwrap();
            let own = found.iter().find(|s| distance(chain, s.q(), &q) < 1e-6);
            let own = own.unwrap_or_else(|| panic!("{id} {q:?}"));
            let named = own.branch.to_string().contains("shoulder-front");
            assert_eq!(named, front, "{id} {q:?} {}", own.branch);
            seen[usize::from(front)] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 60), "{seen:?}");
}

#[test]
fn seven_joints_have_families() {
    let mut random = fastrand::Rng::with_seed(13);
    for (id, solver) in closed_forms().filter(|(_, solver)| solver.chain().dof() == 7) {
        let mut on_one = 0;
        for _ in 0..20 {
            let q = random_joints(solver.chain(), &mut random);
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let found = solver.solve(&pose).unwrap();
            assert_eq!(found.status(), Status::Redundant, "{id} {q:?}");
            // Spherical shoulder and wrist: elbow, shoulder and wrist have two ways each, some of them out of range.
            let least = if solver.choice().name == "swivel" {
                4
            } else {
                1
            };
            assert!(found.families().len() >= least, "{id} {q:?}");
            for family in found.families() {
                for sample in solver.samples(family, 8) {
                    let miss = difference(&tool_pose(solver.chain(), &sample).unwrap(), &pose);
                    assert!(miss < 1e-11, "{id} {q:?}: a member misses by {miss:e}");
                }
            }
            on_one += usize::from(contains(&solver, &q, &found, 1e-6));
        }
        assert!(on_one >= 19, "{id}: {on_one} of 20");
    }
}
