//! Rows of poses between which the joints go straight.

use pieper::describe::Robot;
use pieper::ik::Solver;
use pieper::kinematics::tool_pose;
use pieper::model::{Chain, Variable};
use pieper::motion::{Stations, TrackOptions, stations};
use pieper::spatial::Pose;

use crate::support::{arms, difference};

fn poses(chain: &Chain, rows: &[Vec<f64>]) -> Vec<Pose> {
    rows.iter().map(|q| tool_pose(chain, q).unwrap()).collect()
}

fn within_limits(chain: &Chain, random: &mut fastrand::Rng) -> Vec<f64> {
    let value = |variable: &Variable| {
        let limits = variable.limits;
        let (lower, upper) = limits.map_or((-3.1, 3.1), |limits| (limits.lower(), limits.upper()));
        lower + random.f64() * (upper - lower)
    };
    chain.variables().iter().map(value).collect()
}

fn travel(chain: &Chain, rows: &[Vec<f64>]) -> f64 {
    let extent =
        chain
            .joints()
            .iter()
            .fold(chain.tool().translation.vector.norm(), |sum, joint| {
                sum + joint.before.translation.vector.norm() + joint.after.translation.vector.norm()
            });
    let step = |(j, (a, b)): (usize, (&f64, &f64))| match chain.variables()[j].kind.is_angular() {
        true => (b - a).abs(),
        false => (b - a).abs() / extent,
    };
    let pairs = rows.windows(2);
    pairs
        .map(|pair| {
            pair[0]
                .iter()
                .zip(&pair[1])
                .enumerate()
                .map(step)
                .sum::<f64>()
        })
        .sum()
}

/// Every pose is met within the limits; and the motion that made the poses is one that could have been found, so the
/// one that was travels no farther.
#[test]
fn stations_meet_their_poses_by_the_shortest_way() {
    for (name, chain) in arms().filter(|(_, chain)| chain.dof() <= 6) {
        let solver = Solver::new(&chain).unwrap();
        for seed in 0..4 {
            let mut random = fastrand::Rng::with_seed(seed);
            let rows: Vec<_> = (0..5).map(|_| within_limits(&chain, &mut random)).collect();
            let poses = poses(&chain, &rows);
            let found = stations(&solver, &poses, &TrackOptions::default()).unwrap();
            let Stations::Rows(found) = found else {
                panic!("{name}, seed {seed}: {found:?}");
            };
            for (q, pose) in found.iter().zip(&poses) {
                let off = difference(&tool_pose(&chain, q).unwrap(), pose);
                assert!(off < 1e-9, "{name}, seed {seed}: {off:e}");
                assert!(
                    chain.limit_violations(q).is_empty(),
                    "{name}, seed {seed}: {q:?}"
                );
            }
            let (found, given) = (travel(&chain, &found), travel(&chain, &rows));
            assert!(
                found <= given + 1e-6,
                "{name}, seed {seed}: {found} for {given}"
            );
        }
    }
}

fn elbow() -> Chain {
    let text = "name = 'elbow'\nconvention = 'standard'\n[[joint]]\ntheta = 'q1'\na = 0.5\n[[joint]]\ntheta = 'q2'\na = 0.4";
    Robot::from_toml("elbow.toml", text)
        .unwrap()
        .chain()
        .unwrap()
}

#[test]
fn a_wish_for_the_start_chooses_the_branch() {
    let (_, chain) = arms().find(|(name, _)| *name == "irb120").unwrap();
    let solver = Solver::new(&chain).unwrap();
    let poses = poses(
        &chain,
        &[
            vec![0.1, 0.2, 0.1, 0.4, 0.7, -0.3],
            vec![0.3, 0.1, 0.2, 0.5, 0.8, -0.2],
        ],
    );
    for wish in solver
        .solve(&poses[0])
        .unwrap()
        .iter()
        .filter(|wish| wish.within_limits)
    {
        let options = TrackOptions {
            start: Some(wish.q().to_vec()),
            ..TrackOptions::default()
        };
        let Ok(Stations::Rows(found)) = stations(&solver, &poses, &options) else {
            panic!("{wish:?}")
        };
        let off = found[0]
            .iter()
            .zip(wish.q())
            .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(off < 1e-12, "{found:?}");
    }
}

#[test]
fn a_pose_out_of_reach_is_named() {
    let chain = elbow();
    let solver = Solver::new(&chain).unwrap();
    let mut given = poses(&chain, &[vec![0.2, 0.8], vec![0.6, 0.5], vec![0.1, 0.1]]);
    given[1].translation.vector *= 2.0;
    let found = stations(&solver, &given, &TrackOptions::default()).unwrap();
    let Stations::Unreachable { index, reason } = found else {
        panic!("{found:?}")
    };
    assert_eq!(index, 1);
    assert!(reason.contains("comes no closer than"), "{reason}");
}
