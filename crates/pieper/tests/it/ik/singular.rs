//! At and near singular poses: no root lost, none listed twice, families recognised.

use super::random_arms::{Row, sigma};
use super::{check_closes, closed_forms, contains, distance};
use crate::support::{difference, random_joints};
use nalgebra::DMatrix;
use pieper::describe::Robot;
use pieper::ik::classify::Class;
use pieper::ik::{Solution, Solutions, Solver, Status};
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian, tool_pose};
use pieper::spatial::shift;
use std::f64::consts::{FRAC_PI_2, PI};

fn solver(id: &str) -> Solver {
    let chain = pieper_robots::find(id).unwrap().robot().chain().unwrap();
    Solver::new(&chain).unwrap()
}

/// Joints whose value alone makes the arm singular: (arm, joint, value).
fn singular_values() -> Vec<(&'static str, Solver, usize, f64)> {
    let mut random = fastrand::Rng::with_seed(3);
    let mut out = Vec::new();
    for (id, solver) in closed_forms().filter(|(_, solver)| solver.chain().dof() == 6) {
        for joint in 0..6 {
            for value in [0.0, FRAC_PI_2, PI, -FRAC_PI_2] {
                let mut q = random_joints(solver.chain(), &mut random);
                q[joint] = value;
                if sigma(&solver, &q) < 1e-12 {
                    out.push((id, solver.clone(), joint, value));
                }
            }
        }
    }
    assert!(out.len() > 40, "every wrist has one");
    out
}

#[test]
fn nearly_singular_roots_are_neither_lost_nor_doubled() {
    let mut random = fastrand::Rng::with_seed(5);
    let mut found = Solutions::default();
    for (id, solver, joint, value) in singular_values() {
        for exponent in 3..=12 {
            for _ in 0..10 {
                let mut q = random_joints(solver.chain(), &mut random);
                q[joint] = value + 10_f64.powi(-exponent);
                let pose = tool_pose(solver.chain(), &q).unwrap();
                solver.solve_into(&pose, &mut found).unwrap();
                let what = format!("{id} joint {joint} at {value} + 1e-{exponent} {q:?}");
                assert_ne!(found.status(), Status::Unreachable, "{what}");
                check_closes(&solver, &q, &found, &what);
                let tolerance = (1e-13 / sigma(&solver, &q)).max(1e-8);
                assert!(
                    contains(&solver, &q, &found, 10.0 * tolerance),
                    "{what}: {:?}",
                    found.as_slice()
                );
            }
        }
    }
}

#[test]
fn singular_poses_have_families_or_merged_roots() {
    let mut random = fastrand::Rng::with_seed(6);
    for (id, solver, joint, value) in singular_values() {
        for _ in 0..3 {
            let mut q = random_joints(solver.chain(), &mut random);
            q[joint] = value;
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let found = solver.solve(&pose).unwrap();
            let what = format!("{id} joint {joint} at {value} {q:?}");
            check_closes(&solver, &q, &found, &what);
            assert!(contains(&solver, &q, &found, 1e-6), "{what}: {found:?}");
            match found.status() {
                Status::Solved => assert!(found.iter().any(|s| s.multiplicity > 1), "{what}"),
                Status::Singular => {
                    for family in found.families() {
                        let samples = solver.samples(family, 12);
                        assert_eq!(samples.len(), 12);
                        for sample in samples {
                            let miss =
                                difference(&tool_pose(solver.chain(), &sample).unwrap(), &pose);
                            assert!(miss < 1e-12, "{what}: a sample misses by {miss:e}");
                        }
                    }
                }
                status => panic!("{what}: {status:?}"),
            }
        }
    }
}

/// A straight wrist on a stretched elbow: two directions keep the pose to first order, only one of them truly.
#[test]
fn a_family_stays_one_where_another_joint_is_singular_too() {
    let mut random = fastrand::Rng::with_seed(8);
    let mut alone = Vec::new();
    for (id, solver, joint, value) in singular_values() {
        let mut q = random_joints(solver.chain(), &mut random);
        q[joint] = value;
        let pose = tool_pose(solver.chain(), &q).unwrap();
        let family = solver.solve(&pose).unwrap().status() == Status::Singular;
        alone.push((id, solver, joint, value, family));
    }
    let mut tried = 0;
    for (id, solver, joint, value, _) in alone.iter().filter(|case| case.4) {
        // Two families that meet would be a surface.
        let others = alone
            .iter()
            .filter(|case| case.0 == *id && case.2 != *joint && !case.4);
        for (_, _, other, also, _) in others {
            for _ in 0..10 {
                let mut q = random_joints(solver.chain(), &mut random);
                (q[*joint], q[*other]) = (*value, *also);
                let pose = tool_pose(solver.chain(), &q).unwrap();
                let found = solver.solve(&pose).unwrap();
                let what = format!("{id}: joint {joint} at {value}, {other} at {also}: {q:?}");
                assert_eq!(
                    found.status(),
                    Status::Singular,
                    "{what}: {:?}",
                    found.as_slice()
                );
                assert!(contains(solver, &q, &found, 1e-6), "{what}");
                tried += 1;
            }
        }
    }
    assert!(tried > 300, "{tried}");
}

/// The wrist centre of the AR3 brought to axis 1, or close to it.
#[test]
fn wrist_centre_near_axis_1() {
    let solver = solver("ar3");
    let mut random = fastrand::Rng::with_seed(9);
    for _ in 0..20 {
        let turn = tool_pose(solver.chain(), &random_joints(solver.chain(), &mut random))
            .unwrap()
            .rotation;
        for exponent in [3, 6, 9, 12, 400] {
            let offset = if exponent == 400 {
                0.0
            } else {
                10_f64.powi(-exponent)
            };
            let centre = nalgebra::Vector3::new(offset, 0.0, 0.164 + 0.2 + 0.2 * random.f64());
            let mut pose = shift(centre);
            pose.rotation = turn;
            pose.translation.vector += turn * nalgebra::Vector3::new(0.0, 0.0, 0.0);
            let flange = turn * tool_axis(&solver) * 0.0777;
            pose.translation.vector += flange;
            let found = solver.solve(&pose).unwrap();
            if offset == 0.0 {
                assert_eq!(found.status(), Status::Singular, "{pose}");
                assert!(found.families().len() >= 2);
            } else {
                assert_eq!(found.status(), Status::Solved, "{offset:e} {pose}");
                assert_eq!(found.len(), 8, "{offset:e} {pose}");
                for s in &found {
                    assert!(s.residual < 1e-13);
                }
            }
        }
    }
}

/// The direction of the last axis in the tool's frame.
fn tool_axis(solver: &Solver) -> nalgebra::Vector3<f64> {
    let last = solver.chain().canonical().link(5);
    last.rotation.inverse() * nalgebra::Vector3::z()
}

/// Wherever the Jacobian's determinant vanishes, not only where one joint's value makes it: the root is in the set, and two
/// roots that are nearly one are told apart as far as the pose tells them.
#[test]
fn roots_beside_any_singularity_are_in_the_set() {
    let mut random = fastrand::Rng::with_seed(21);
    let mut tried = 0;
    for id in ["irb120", "puma560", "ur5", "jaco2", "xarm6", "general"] {
        let solver = match id {
            "general" => general(),
            id => solver(id),
        };
        for exponent in [3, 5, 7, 9, 11] {
            for _ in 0..60 {
                let joint = random.usize(1..5);
                let Some(mut q) = beside(&solver, joint, &mut random) else {
                    continue;
                };
                q[joint] += 10_f64.powi(-exponent);
                let what = format!("{id} joint {joint} at 1e-{exponent}");
                check_found(&solver, &q, told(&solver, &q), &what);
                tried += 1;
            }
        }
    }
    assert!(tried > 600, "only {tried}");
}

/// Real roots come in pairs: where two merge, the one that is listed counts as two, and the sum is even. But for flat folds, whose
/// roots rounding moves by some 1e-6: copies of them are listed, or counted.
#[test]
fn merged_roots_count_as_two() {
    let mut random = fastrand::Rng::with_seed(23);
    let mut solvers: Vec<Solver> = (0..40).map(|_| offset_wrist(&mut random)).collect();
    solvers.extend((0..10).map(|_| general()));
    let (mut tried, mut wrong) = (0, Vec::new());
    for solver in &solvers {
        for _ in 0..20 {
            let joint = random.usize(1..5);
            let Some(q) = beside(solver, joint, &mut random) else {
                continue;
            };
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let found = solver.solve(&pose).unwrap();
            if found.status() != Status::Solved {
                continue;
            }
            let near = |s: &&Solution| distance(solver.chain(), s.q(), &q) < 1e-6;
            let here = found.iter().filter(near).map(|s| s.multiplicity);
            let all = found.iter().map(|s| u32::from(s.multiplicity));
            let (here, all) = (here.collect::<Vec<_>>(), all.sum::<u32>());
            if here != [2] || !all.is_multiple_of(2) {
                wrong.push((q, found.as_slice().to_vec()));
            }
            tried += 1;
        }
    }
    assert!(tried > 300, "only {tried}");
    assert!(wrong.len() <= tried / 100, "{tried}: {wrong:?}");
}

/// How well a pose tells joint values: what rounding moves them by.
fn told(solver: &Solver, q: &[f64]) -> f64 {
    (1e-13 / sigma(solver, q)).max(2e-6)
}

/// Whether joint values are among the solutions of their pose.
fn check_found(solver: &Solver, q: &[f64], tolerance: f64, what: &str) {
    let pose = tool_pose(solver.chain(), q).unwrap();
    let found = solver.solve(&pose).unwrap();
    check_closes(solver, q, &found, what);
    assert!(
        contains(solver, q, &found, tolerance),
        "{what} {q:?}: {:?}",
        found.as_slice()
    );
}

/// A random arm whose axis 5 meets axis 4 or 6, behind two parallel axes; half of them with right angles and half of the lengths zero.
fn offset_wrist(random: &mut fastrand::Rng) -> Solver {
    let structured = random.bool();
    let mut signed = || 2.0 * random.f64() - 1.0;
    let mut row = |length: f64| {
        let (d, a, twist) = (signed(), signed(), signed());
        match structured {
            true => (d.max(0.0), a.max(0.0), FRAC_PI_2.copysign(twist)),
            false => (d, a + length.copysign(a), PI * twist),
        }
    };
    let mut rows: [(f64, f64, f64); 6] = std::array::from_fn(|_| row(0.1));
    rows[1].1 += 0.2;
    rows[1].2 = 0.0;
    let meets = if random.bool() { 3 } else { 4 };
    rows[meets].1 = 0.0;
    super::random_arms::solver(&rows.map(turning))
}

/// Where several solutions are near one another, the equation of an offset wrist drowns in its rounding and is looked at closely.
#[test]
fn offset_wrists_beside_any_singularity() {
    let mut random = fastrand::Rng::with_seed(22);
    let (mut tried, mut offset) = (0, 0);
    for arm in 0..60 {
        let solver = offset_wrist(&mut random);
        offset += usize::from(solver.choice().name == "offset-wrist");
        for exponent in [5, 7, 9, 12] {
            for _ in 0..6 {
                let joint = random.usize(1..5);
                let Some(mut q) = beside(&solver, joint, &mut random) else {
                    continue;
                };
                q[joint] += 10_f64.powi(-exponent);
                let what = format!("arm {arm} joint {joint} at 1e-{exponent}");
                check_found(&solver, &q, told(&solver, &q), &what);
                tried += 1;
            }
        }
    }
    assert!(offset > 20 && tried > 500, "{offset} arms, {tried} poses");
}

/// Joint values that were lost: an elbow 1e-7 from stretched, whose two ways to bend a nearly straight wrist makes much of; and a fold
/// with short levers beside it, where the error of the pose is no parabola for long.
#[test]
fn solutions_that_were_lost_beside_singularities() {
    let h = FRAC_PI_2;
    let elbow = [
        (0.0, 0.16313281605693453, -h),
        (0.0, 0.9450767257927313, 0.0),
        (0.34352994212137933, 0.7133462711162888, h),
        (-0.44766185609795694, 0.0, -h),
        (0.0, 0.0, -h),
        (0.08998660678386372, 0.0, 0.3),
    ];
    let levers = [
        (0.0, 0.0, -h),
        (0.8349794858151207, 0.2283021854913907, 0.0),
        (0.6403415352532384, 0.954640047261025, -h),
        (0.7988602545404391, 0.0, h),
        (0.00033273448360970903, 0.0, -h),
        (0.024404205297092085, 0.0, 0.3),
    ];
    let stretched = [
        3.016256668544212,
        3.534572745293288,
        1.6201019222059148,
        3.1398342570887574,
        -0.004596809088528211,
        -0.4767185803722434,
    ];
    let folded = [
        -1.3020914808864639,
        1.5143964070368223,
        2.4909281303946846,
        0.8073722901406024,
        -2.1471263343674827,
        -0.9811499570817813,
    ];
    for (rows, q) in [(elbow, stretched), (levers, folded)] {
        let solver = super::random_arms::solver(&rows.map(turning));
        check_found(&solver, &q, 2e-6, "lost once");
    }
    // Pairs of roots beside other pairs, which the polynomial takes for one pair somewhere between them.
    let crx = "fanuc-crx10ia";
    let beside_others = [
        (
            crx,
            [
                -3.08901658583621819,
                -1.49013828656764113,
                -1.56979632679489711,
                -1.35997673689211496,
                2.67582395138101425,
                0.02921819788489943,
            ],
        ),
        (
            crx,
            [
                -1.90960059751978251,
                2.16041882434603938,
                -0.39086524265537670,
                -3.13975370665211662,
                2.31726723827631043,
                2.59357219698650088,
            ],
        ),
        (
            "xarm6",
            [
                -0.68088494278085776,
                3.11359839225645718,
                -3.01904410874935092,
                -1.28126807226841777,
                -1.09628424656452861,
                0.82275986500103926,
            ],
        ),
    ];
    for (id, q) in beside_others {
        check_found(&solver(id), &q, 2e-6, id);
    }
}

/// Folded, the wrist of a CRX is close to where axes 1 and 2 cross, about which four joints turn then: all its solutions there have the
/// last joint nearly where it is, and stand in mirrored pairs.
#[test]
fn a_folded_arm_has_all_its_solutions() {
    let mut random = fastrand::Rng::with_seed(23);
    let solver = solver("fanuc-crx10ia");
    let mut tried = 0;
    for exponent in 2..=8 {
        for _ in 0..100 {
            let mut q = random_joints(solver.chain(), &mut random);
            q[2] = -FRAC_PI_2 + 10_f64.powi(-exponent);
            let sigma = sigma(&solver, &q);
            if sigma < 1e-11 {
                // To rounding it is a family.
                continue;
            }
            tried += 1;
            let tolerance = (1e-14 / sigma).max(2e-6);
            check_found(&solver, &q, tolerance, &format!("folded to 1e-{exponent}"));
            let mirrored = [q[0] + PI, -q[1], -PI - q[2], q[3] + PI, q[4], q[5]];
            let found = solver
                .solve(&tool_pose(solver.chain(), &q).unwrap())
                .unwrap();
            assert!(
                contains(&solver, &mirrored, &found, tolerance),
                "{q:?} mirrored"
            );
            let roots: u32 = found.iter().map(|s| u32::from(s.multiplicity)).sum();
            assert!(
                !found.families().is_empty() || roots.is_multiple_of(4),
                "{q:?}: {found:?}"
            );
        }
    }
    assert!(tried > 600, "only {tried}");
}

/// An arm without any structure.
fn general() -> Solver {
    let rows = [
        (0.31, 0.12, 1.1),
        (0.07, 0.42, -0.35),
        (-0.11, 0.2, 1.4),
        (0.38, 0.05, -0.9),
        (0.06, -0.08, 1.25),
        (0.12, 0.03, 0.4),
    ];
    let solver = super::random_arms::solver(&rows.map(turning));
    assert_eq!(solver.choice().name, "general");
    solver
}

/// A row of a joint that turns: d, a, alpha.
fn turning((d, a, alpha): (f64, f64, f64)) -> Row {
    Row {
        turns: true,
        theta: 0.0,
        d,
        a,
        alpha,
    }
}

/// With two neighbouring axes on one line, only the sum of two angles counts: there is no isolated solution, although the rest of
/// the arm is of a class.
#[test]
fn arms_that_are_singular_everywhere_have_families_only() {
    let h = FRAC_PI_2;
    let ball_on_arm = [
        (0.3, 0.1, h),
        (0.0, 0.4, 0.0),
        (0.0, 0.0, 0.0),
        (0.35, 0.0, -h),
        (0.0, 0.0, h),
        (0.1, 0.0, 0.0),
    ];
    let three_parallel = [
        (0.1, 0.0, h),
        (0.0, 0.4, 0.0),
        (0.0, 0.3, 0.0),
        (0.1, 0.0, h),
        (0.1, 0.0, 0.0),
        (0.1, 0.05, 0.3),
    ];
    let mut random = fastrand::Rng::with_seed(31);
    for rows in [ball_on_arm, three_parallel] {
        let solver = super::random_arms::solver(&rows.map(turning));
        let structure = solver.structure();
        assert!(structure.singular && structure.class() == Class::General);
        assert!(structure.evidence(Class::General)[0].starts_with("singular everywhere"));
        for _ in 0..5 {
            let q = random_joints(solver.chain(), &mut random);
            let pose = tool_pose(solver.chain(), &q).unwrap();
            let found = solver.solve(&pose).unwrap();
            assert_eq!(found.status(), Status::Singular, "{q:?}");
            check_closes(&solver, &q, &found, "singular everywhere");
            assert!(contains(&solver, &q, &found, 1e-6), "{q:?}: {found:?}");
        }
    }
    // What is regular somewhere is of its class, wherever it is singular.
    assert!(!solver("irb120").structure().singular);
}

/// Axes beside the three parallel ones that are parallel but for a hair, in the table or in a pose: that is a cone, however blunt.
#[test]
fn nearly_parallel_axes_beside_three_parallel_ones() {
    let mut random = fastrand::Rng::with_seed(32);
    for exponent in 2..=6 {
        let hair = 10_f64.powi(-exponent);
        let rows = [
            (0.3, 0.0, hair),
            (-0.46, -0.43, 0.8),
            (0.0, -0.4, -FRAC_PI_2),
            (0.0, 0.43, 0.0),
            (0.0, 0.46, 0.0),
            (0.0, 0.0, 0.8),
        ];
        let solver = super::random_arms::solver(&rows.map(turning));
        assert_eq!(solver.choice().name, "three-parallel");
        for _ in 0..100 {
            let q = random_joints(solver.chain(), &mut random);
            let found = solver
                .solve(&tool_pose(solver.chain(), &q).unwrap())
                .unwrap();
            let what = format!("twist {hair:e} {q:?}");
            check_closes(&solver, &q, &found, &what);
            let tolerance = (1e-13 / sigma(&solver, &q)).max(1e-8);
            assert!(contains(&solver, &q, &found, tolerance), "{what}");
        }
    }
}

/// Where the determinant of the Jacobian changes its sign as a joint of a random joint vector moves.
fn beside(solver: &Solver, joint: usize, random: &mut fastrand::Rng) -> Option<Vec<f64>> {
    let mut jacobian = Jacobian::zeros(6);
    let mut determinant = |q: &[f64]| {
        pose_and_jacobian(solver.chain(), q, Reference::Base, &mut jacobian).unwrap();
        DMatrix::from_fn(6, 6, |i, j| jacobian[(i, j)]).determinant()
    };
    let mut low: Vec<f64> = (0..6).map(|_| (2.0 * random.f64() - 1.0) * PI).collect();
    let mut high = low.clone();
    high[joint] += 3.0 * random.f64();
    let sign = determinant(&low);
    if sign * determinant(&high) > 0.0 {
        return None;
    }
    for _ in 0..70 {
        let mut middle = low.clone();
        middle[joint] = 0.5 * (low[joint] + high[joint]);
        match determinant(&middle) * sign > 0.0 {
            true => low = middle,
            false => high = middle,
        }
    }
    Some(low)
}

/// What is near depends on the arm's size: an arm of a few millimetres has the roots of one a thousand times as large.
#[test]
fn small_arms_keep_roots_that_are_near() {
    for size in [1.0, 1e-3] {
        let text = format!(
            "name = 'small'\nconvention = 'standard'\n\
             [[joint]]\ntheta = 'q1'\nalpha = 'pi/2'\nd = {size}\n\
             [[joint]]\ntheta = 'q2'\na = {size}\nalpha = 'pi/3'\n\
             [[joint]]\ntheta = 'q3'\na = {}\nalpha = 'pi/2'\n\
             [[joint]]\ntheta = 'q4'\nd = {}\nalpha = '-pi/2'\n\
             [[joint]]\ntheta = 'q5'\nalpha = 'pi/2'\n\
             [[joint]]\ntheta = 'q6'\nd = {}\n",
            0.2 * size,
            0.7 * size,
            0.1 * size
        );
        let chain = Robot::from_toml("small.toml", &text)
            .unwrap()
            .chain()
            .unwrap();
        let solver = Solver::new(&chain).unwrap();
        let mut random = fastrand::Rng::with_seed(4);
        let mut tried = 0;
        for _ in 0..200 {
            let Some(mut q) = beside(&solver, 2, &mut random) else {
                continue;
            };
            q[2] += 2e-5;
            let found = solver.solve(&tool_pose(&chain, &q).unwrap()).unwrap();
            assert!(
                contains(&solver, &q, &found, 2e-6),
                "size {size}, {q:?}: {found:?}"
            );
            tried += 1;
        }
        assert!(tried > 50, "only {tried}");
    }
}
