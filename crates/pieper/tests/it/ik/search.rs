//! The numeric search: from one start to a solution, within limits if asked, always the same way.

use crate::support::{arms, random_joints};
use pieper::ik::{Options, Ranking, Search, Solver, rank};
use pieper::kinematics::tool_pose;

#[test]
fn every_arm_is_reached_from_a_random_start() {
    let mut random = fastrand::Rng::with_seed(61);
    let (mut reached, mut count) = (0, 0);
    for (id, chain) in arms() {
        let search = Search::new(&chain).unwrap();
        for _ in 0..50 {
            let pose = tool_pose(&chain, &random_joints(&chain, &mut random)).unwrap();
            let start = random_joints(&chain, &mut random);
            let found = search.find(&pose, &start, &Options::default()).unwrap();
            let again = search.find(&pose, &start, &Options::default()).unwrap();
            assert_eq!(found, again, "{id}");
            let miss = found.nearest;
            let meets = miss.position_error <= 1e-6 && miss.orientation_error <= 1e-6;
            assert_eq!(meets, found.reached, "{id}");
            count += 1;
            reached += usize::from(found.reached);
        }
    }
    assert!(reached * 1000 >= count * 999, "{reached} of {count}");
}

#[test]
fn limits_are_kept() {
    let mut random = fastrand::Rng::with_seed(62);
    let (mut reached, mut count) = (0, 0);
    let options = Options {
        limits: true,
        ..Options::default()
    };
    for (id, chain) in arms() {
        let search = Search::new(&chain).unwrap();
        for _ in 0..20 {
            let inside: Vec<f64> = chain
                .variables()
                .iter()
                .map(|v| {
                    v.limits
                        .map_or(0.0, |l| l.lower() + random.f64() * (l.upper() - l.lower()))
                })
                .collect();
            let pose = tool_pose(&chain, &inside).unwrap();
            let start = random_joints(&chain, &mut random);
            let found = search.find(&pose, &start, &options).unwrap();
            assert!(
                chain.limit_violations(found.q()).is_empty(),
                "{id} {:?}",
                found.q()
            );
            count += 1;
            reached += usize::from(found.reached);
        }
    }
    assert!(reached * 100 >= count * 98, "{reached} of {count}");
}

#[test]
fn a_search_allocates_nothing_and_refuses_bad_input() {
    let chain = pieper_robots::find("ur5").unwrap().robot().chain().unwrap();
    let search = Search::new(&chain).unwrap();
    let pose = tool_pose(&chain, &[0.3, -1.0, 1.2, 0.4, 0.9, -2.0]).unwrap();
    let count = crate::hot_calls::allocations(|| {
        search.find(&pose, &[0.1; 6], &Options::default()).unwrap();
    });
    assert_eq!(count, 0);
    assert!(search.find(&pose, &[0.1; 5], &Options::default()).is_err());
    assert!(
        search
            .find(&pose, &[f64::NAN; 6], &Options::default())
            .is_err()
    );
    let nonsense = Options {
        tolerance: f64::NAN,
        starts: 0,
        ..Options::default()
    };
    assert!(!search.find(&pose, &[0.1; 6], &nonsense).unwrap().reached);
}

#[test]
fn solutions_far_from_singular_ones_come_first() {
    let chain = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let solver = Solver::new(&chain).unwrap();
    let pose = tool_pose(&chain, &[0.3, 0.7, -0.5, 0.2, 0.9, -2.0]).unwrap();
    let mut list = solver.solve(&pose).unwrap().as_slice().to_vec();
    rank(&chain, &mut list, Ranking::Singularity);
    let sigma = |q: &[f64]| {
        let mut jacobian = pieper::kinematics::Jacobian::zeros(6);
        let base = pieper::kinematics::Reference::Base;
        pieper::kinematics::pose_and_jacobian(&chain, q, base, &mut jacobian).unwrap();
        let extent = 0.164_f64.hypot(0.079) + 0.305 + 0.222 + 0.0777;
        jacobian.rows_mut(0, 3).scale_mut(1.0 / extent);
        jacobian.singular_values().min()
    };
    for pair in list.windows(2) {
        assert!(sigma(pair[0].q()) > sigma(pair[1].q()) - 1e-3);
    }
}
