//! Seven joints: the listed families are all there are, and each is listed once; joints held; ranges within limits.

use super::{closed_forms, contains, distance};
use crate::support::{difference, random_joints};
use pieper::ik::{Options, Question, Search, Solver, Status};
use pieper::kinematics::tool_pose;

fn seven() -> impl Iterator<Item = (&'static str, Solver)> {
    closed_forms().filter(|(_, solver)| solver.chain().dof() == 7)
}

/// What a numeric search finds from many starts lies on listed families; no listed member lies on another family.
#[test]
fn families_are_complete_and_distinct() {
    let mut random = fastrand::Rng::with_seed(41);
    let (mut reached, mut missed) = (0, 0);
    for (id, solver) in seven() {
        let search = Search::new(solver.chain()).unwrap();
        let one = Options {
            starts: 1,
            tolerance: 1e-9,
            ..Options::default()
        };
        for _ in 0..4 {
            let pose =
                tool_pose(solver.chain(), &random_joints(solver.chain(), &mut random)).unwrap();
            let found = solver.solve(&pose).unwrap();
            for _ in 0..12 {
                let from = random_joints(solver.chain(), &mut random);
                let other = search.find(&pose, &from, &one).unwrap();
                if other.reached {
                    reached += 1;
                    missed += usize::from(!contains(&solver, other.q(), &found, 1e-5));
                }
            }
            if solver.choice().name != "locked" {
                continue;
            }
            for (index, family) in found.families().iter().enumerate() {
                for other in &found.families()[..index] {
                    let near = solver.nearest_member(other, family.q()).unwrap();
                    let gap = distance(solver.chain(), &near, family.q());
                    assert!(gap > 1e-3, "{id}: families {gap:e} apart");
                }
            }
        }
    }
    assert!(reached > 200);
    assert_eq!(missed, 0, "of {reached}");
}

/// At the elbow's angle of a joint vector that vector is among the isolated solutions, and all of them have that angle.
#[test]
fn a_swivel_angle_leaves_isolated_solutions() {
    let mut random = fastrand::Rng::with_seed(43);
    let mut arms = 0;
    for (id, solver) in seven().filter(|(_, solver)| solver.choice().name == "swivel") {
        arms += 1;
        let chain = solver.chain();
        for _ in 0..300 {
            let q = random_joints(chain, &mut random);
            let swivel = solver.swivel(&q).unwrap();
            assert!(swivel.is_some(), "{id}: {q:?}");
            let pose = tool_pose(chain, &q).unwrap();
            let question = Question {
                swivel,
                ..Question::default()
            };
            let at = Solver::prepare(chain, &question).unwrap();
            let found = at.solve(&pose).unwrap();
            assert_eq!(found.status(), Status::Solved, "{id}: {q:?}");
            assert!(
                found.len() >= 4 && found.families().is_empty(),
                "{id}: {}",
                found.len()
            );
            assert!(contains(&at, &q, &found, 1e-8), "{id}: {q:?}");
            for solution in found.iter() {
                let off = difference(&tool_pose(chain, solution.q()).unwrap(), &pose);
                assert!(off < 1e-12, "{id}: {off:e}");
                let other = solver.swivel(solution.q()).unwrap().unwrap();
                let turn = (other - swivel.unwrap()).rem_euclid(std::f64::consts::TAU);
                let turn = turn.min(std::f64::consts::TAU - turn);
                assert!(turn < 1e-9, "{id}: elbow at {other}, not {swivel:?}");
            }
        }
    }
    assert!(arms >= 2, "{arms}");
    // Arms without such an angle say so, and so do numbers that are none.
    let ar3 = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let iiwa = pieper_robots::find("iiwa14")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    for (chain, angle) in [(&ar3, 0.3), (&iiwa, f64::NAN)] {
        let question = Question {
            swivel: Some(angle),
            ..Question::default()
        };
        let error = Solver::prepare(chain, &question).unwrap_err().to_string();
        assert!(error.contains("swivel"), "{error}");
    }
    assert_eq!(Solver::new(&ar3).unwrap().swivel(&[0.1; 6]).unwrap(), None);
}

#[test]
fn a_held_joint_leaves_all_isolated_solutions() {
    let mut random = fastrand::Rng::with_seed(42);
    for (id, solver) in seven() {
        let chain = solver.chain();
        for joint in 0..7 {
            let q = random_joints(chain, &mut random);
            let question = Question {
                held: vec![(joint, q[joint])],
                ..Question::default()
            };
            let held = Solver::prepare(chain, &question).unwrap();
            let pose = tool_pose(chain, &q).unwrap();
            let found = held.solve(&pose).unwrap();
            // Of shoulder, elbow and wrist with right angles the elbow's value follows from the pose alone.
            let elbow = solver.choice().name == "swivel" && joint == 3;
            if elbow {
                assert_eq!(found.status(), Status::Singular, "{id} {joint}");
            } else {
                assert_eq!(
                    found.status(),
                    Status::Solved,
                    "{id} {joint} {:?}",
                    found.reason()
                );
            }
            assert!(
                contains(&held, &q, &found, 1e-7),
                "{id} joint {joint} {} {q:?}",
                held.choice().name
            );
            for solution in &found {
                assert_eq!(solution.q()[joint], q[joint]);
                assert!(difference(&tool_pose(chain, solution.q()).unwrap(), &pose) < 1e-12);
            }
        }
    }
}

#[test]
fn odd_questions_are_refused() {
    let chain = pieper_robots::find("panda")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    for held in [
        vec![(7, 0.0)],
        vec![(0, f64::NAN)],
        vec![(1, 0.0), (1, 0.0)],
    ] {
        let question = Question {
            held,
            ..Question::default()
        };
        assert!(Solver::prepare(&chain, &question).unwrap_err().is_input());
    }
    let question = Question {
        held: (0..7).map(|joint| (joint, 0.0)).collect(),
        ..Question::default()
    };
    assert!(Solver::prepare(&chain, &question).is_err());
}

/// Ends of ranges lie within the limits, and just beyond them the family leaves these.
#[test]
fn ranges_end_at_limits() {
    let mut random = fastrand::Rng::with_seed(43);
    let (mut parts, mut whole) = (0, 0);
    for (id, solver) in seven() {
        let chain = solver.chain();
        for _ in 0..4 {
            // A pose that the arm reaches within its limits.
            let inside: Vec<f64> = chain
                .variables()
                .iter()
                .map(|v| {
                    v.limits
                        .map_or(0.0, |l| l.lower() + random.f64() * (l.upper() - l.lower()))
                })
                .collect();
            let pose = tool_pose(chain, &inside).unwrap();
            let found = solver.solve(&pose).unwrap();
            let mut any = false;
            for family in found.families() {
                let ranges = solver.ranges(family);
                any |= !ranges.is_empty();
                let within = solver.within_limits(family);
                assert_eq!(within.is_some(), !ranges.is_empty(), "{id}");
                if let Some(within) = within {
                    assert!(
                        chain.limit_violations(within.q()).is_empty(),
                        "{id} {:?}",
                        within.q()
                    );
                    assert!(difference(&tool_pose(chain, within.q()).unwrap(), &pose) < 1e-11);
                    let samples = solver.samples_within(family, 12);
                    assert!(!samples.is_empty() && samples.len() <= 12);
                    for q in samples {
                        assert!(chain.limit_violations(&q).is_empty(), "{id} {q:?}");
                        assert!(difference(&tool_pose(chain, &q).unwrap(), &pose) < 1e-11);
                    }
                }
                for range in ranges {
                    for end in [&range.from, &range.to] {
                        assert!(
                            chain
                                .limit_violations(end)
                                .iter()
                                .all(|_| near_limit(chain, end)),
                            "{id} {end:?}"
                        );
                        assert!(difference(&tool_pose(chain, end).unwrap(), &pose) < 1e-11);
                    }
                    if distance(chain, &range.from, &range.to) > 1e-6 {
                        parts += 1;
                        assert!(
                            near_limit(chain, &range.from) && near_limit(chain, &range.to),
                            "{id} {range:?}"
                        );
                    } else {
                        whole += 1;
                    }
                }
            }
            assert!(
                any,
                "{id}: the joint values that made the pose lie within the limits"
            );
        }
    }
    assert!(parts > 20, "{parts} {whole}");
}

fn near_limit(chain: &pieper::model::Chain, q: &[f64]) -> bool {
    chain.variables().iter().zip(q).any(|(variable, value)| {
        variable.limits.is_some_and(|limits| {
            (value - limits.lower()).abs() < 1e-6 || (value - limits.upper()).abs() < 1e-6
        })
    })
}
