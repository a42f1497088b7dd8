//! Every inverse solution beside the peers: `cargo run --release --manifest-path bench/Cargo.toml --bin ik`
//!
//! The same targets for all contenders of a class, in turns; every contender has to find the joint values that made each
//! target before it is timed, or how many it lost is printed.

use std::f64::consts::{FRAC_PI_2, PI};
use std::hint::black_box;
use std::time::Instant;

use ik_geo::inverse_kinematics::auxiliary::Kinematics;
use ik_geo::robot::{IKSolver as _, Robot};
use ik_geo_nalgebra as theirs;
use nalgebra::{Matrix3, Vector3};
use pieper::ik::{Solutions, Solver};
use pieper::kinematics::{self, Jacobian, Reference};
use pieper::model::Chain;
use pieper::spatial::Pose;
use pieper_bench::{Contender, print, race};
use rs_opw_kinematics::glam::{DMat3, DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::{Kinematics as _, Pose as OpwPose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

const TARGETS: usize = 512;

fn main() {
    spherical();
    ur5();
    alone();
}

/// A chain, random joint vectors, and where they lead.
struct Class {
    chain: Chain,
    joints: Vec<[f64; 6]>,
    poses: Vec<Pose>,
}

impl Class {
    fn of(chain: Chain, seed: u64) -> Self {
        let mut random = fastrand::Rng::with_seed(seed);
        let joints: Vec<[f64; 6]> =
            (0..TARGETS).map(|_| std::array::from_fn(|_| PI * (2.0 * random.f64() - 1.0))).collect();
        let poses = joints.iter().map(|q| kinematics::tool_pose(&chain, q).expect("finite")).collect();
        Self { chain, joints, poses }
    }

    fn built_in(name: &str) -> Self {
        Self::of(pieper_robots::find(name).expect("built in").robot().chain().expect("numbers"), 1)
    }

    /// How many of the joint vectors are not in the answers.
    fn lost(&self, mut answers: impl FnMut(usize) -> Vec<[f64; 6]>) -> usize {
        let close = |a: &[f64; 6], b: &[f64; 6]| {
            a.iter().zip(b).all(|(a, b)| (a - b - 2.0 * PI * ((a - b) / (2.0 * PI)).round()).abs() < 1e-6)
        };
        (0..TARGETS).filter(|&index| !answers(index).iter().any(|q| close(q, &self.joints[index]))).count()
    }

    fn ours(&self) -> Solver {
        let solver = Solver::new(&self.chain).expect("a solver");
        let lost = self.lost(|index| {
            let found = solver.solve(&self.poses[index]).expect("a pose");
            found.iter().map(|s| s.q().try_into().expect("six")).collect()
        });
        println!("pieper: {} of {TARGETS} lost, row {}", lost, solver.choice().name);
        solver
    }

    /// Axes and points on them, all joints at zero, for IK-Geo; `wrist`: axes 4 to 6 through the origin of frame 5.
    fn screws(&self, wrist: bool) -> (Kinematics<6, 7>, Matrix3<f64>) {
        let mut jacobian = Jacobian::zeros(6);
        let zero = [0.0; 6];
        let tool = kinematics::pose_and_jacobian(&self.chain, &zero, Reference::Base, &mut jacobian).expect("finite");
        let mut frames = Vec::new();
        kinematics::link_poses(&self.chain, &zero, &mut frames).expect("finite");
        let mut points = vec![Vector3::zeros()];
        points.extend(frames.iter().take(5).map(|frame| frame.translation.vector));
        if wrist {
            points[3] = points[5];
            points[4] = points[5];
        }
        points.push(tool.translation.vector);
        let mut kin = Kinematics::<6, 7>::new();
        for (axis, column) in jacobian.column_iter().enumerate() {
            kin.h.set_column(axis, &theirs::Vector3::new(column[3], column[4], column[5]));
        }
        let mut last = Vector3::zeros();
        for (index, point) in points.iter().enumerate() {
            let p = point - last;
            kin.p.set_column(index, &theirs::Vector3::new(p.x, p.y, p.z));
            last = *point;
        }
        (kin, tool.rotation.into_inner())
    }

    /// The targets as IK-Geo takes them: the rotation without the tool's at zero.
    fn for_ik_geo(&self, tool: &Matrix3<f64>) -> Vec<(theirs::Matrix3<f64>, theirs::Vector3<f64>)> {
        let turned = |pose: &Pose| {
            let r = pose.rotation.matrix() * tool.transpose();
            let p = pose.translation.vector;
            (theirs::Matrix3::from_fn(|i, j| r[(i, j)]), theirs::Vector3::new(p.x, p.y, p.z))
        };
        self.poses.iter().map(turned).collect()
    }
}

fn count_ik_geo(class: &Class, robot: &Robot, targets: &[(theirs::Matrix3<f64>, theirs::Vector3<f64>)]) {
    let lost = class.lost(|index| {
        let (r, p) = targets[index];
        robot.ik(r, p).into_iter().map(|(q, _)| std::array::from_fn(|i| q[i])).collect()
    });
    println!("ik-geo: {lost} of {TARGETS} lost");
}

fn spherical() {
    let class = Class::built_in("irb120");
    let opw = OPWKinematics::new(Parameters {
        a1: 0.0,
        a2: -0.07,
        b: 0.0,
        c1: 0.29,
        c2: 0.27,
        c3: 0.302,
        c4: 0.072,
        offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
        sign_corrections: [1; 6],
        dof: 6,
    });
    let opw_poses: Vec<OpwPose> = class.poses.iter().map(|pose| {
        let m = pose.rotation.matrix();
        let column = |j: usize| DVec3::new(m[(0, j)], m[(1, j)], m[(2, j)]);
        let p = pose.translation.vector;
        OpwPose {
            rotation: DQuat::from_mat3(&DMat3::from_cols(column(0), column(1), column(2))),
            translation: DVec3::new(p.x, p.y, p.z),
        }
    }).collect();
    let there = opw.forward(&class.joints[0]).translation;
    let here = class.poses[0].translation.vector;
    assert!((there - DVec3::new(here.x, here.y, here.z)).length() < 1e-12, "the peer computes another arm");
    println!("\nABB IRB 120");
    println!("rs-opw: {} of {TARGETS} lost", class.lost(|index| opw.inverse(&opw_poses[index])));
    let (kin, tool) = class.screws(true);
    let (robot, targets) = (Robot::spherical_two_parallel(kin), class.for_ik_geo(&tool));
    count_ik_geo(&class, &robot, &targets);
    let (solver, mut out) = (class.ours(), Solutions::default());
    let mut contenders = [
        Contender::new("rs-opw-kinematics 3.0", TARGETS, || {
            opw_poses.iter().for_each(|pose| { black_box(opw.inverse(black_box(pose))); });
        }),
        Contender::new("ik-geo 0.1.2", TARGETS, || {
            targets.iter().for_each(|(r, p)| { black_box(robot.ik(black_box(*r), *p)); });
        }),
        Contender::new("pieper", TARGETS, || {
            class.poses.iter().for_each(|pose| {
                solver.solve_into(black_box(pose), &mut out).unwrap();
                black_box(&out);
            });
        }),
    ];
    let times = race(&mut contenders, 300);
    print("Spherical wrist, ABB IRB 120, all solutions", &times, "rs-opw-kinematics 3.0");
}

fn ur5() {
    let class = Class::built_in("ur5");
    println!("\nUR5");
    let (kin, tool) = class.screws(false);
    let (robot, targets) = (Robot::three_parallel_two_intersecting(kin), class.for_ik_geo(&tool));
    count_ik_geo(&class, &robot, &targets);
    let (solver, mut out) = (class.ours(), Solutions::default());
    let mut contenders = [
        Contender::new("ik-geo 0.1.2", TARGETS, || {
            targets.iter().for_each(|(r, p)| { black_box(robot.ik(black_box(*r), *p)); });
        }),
        Contender::new("pieper", TARGETS, || {
            class.poses.iter().for_each(|pose| {
                solver.solve_into(black_box(pose), &mut out).unwrap();
                black_box(&out);
            });
        }),
    ];
    let times = race(&mut contenders, 300);
    print("Three parallel axes, UR5, all solutions", &times, "ik-geo 0.1.2");
}

/// An arm of six joints from its standard Denavit-Hartenberg table.
fn table(rows: &[(f64, f64, f64, f64)]) -> Chain {
    let mut text = "name = 'arm'\nconvention = 'standard'\n".to_owned();
    for (index, (theta, d, a, alpha)) in rows.iter().enumerate() {
        text += &format!("[[joint]]\ntheta = '{theta} + q{}'\nd = {d:?}\na = {a:?}\nalpha = {alpha:?}\n", index + 1);
    }
    pieper::describe::Robot::from_toml("arm.toml", &text).expect("a table").chain().expect("numbers")
}

/// Classes for which no peer here answers in the same order of magnitude: single calls, median and 99th percentile.
fn alone() {
    println!("\nOffset wrists and general arms: single calls\n\n| | median us | 99 % us | lost |\n|---|---|---|---|");
    // theta less q, d, a, alpha of each row.
    let h = FRAC_PI_2;
    let offset = table(&[
        (h, 0.164, 0.079, h),
        (0.0, 0.0, 0.305, 0.0),
        (h, 0.0, 0.0, h),
        (0.0, 0.222, 0.005, -h),
        (0.0, 0.0, 0.0, h),
        (h, 0.0777, 0.0, h),
    ]);
    let general = table(&[
        (0.0, 0.31, 0.12, 1.1),
        (0.0, 0.07, 0.42, -0.35),
        (0.0, -0.11, 0.2, 1.4),
        (0.0, 0.38, 0.05, -0.9),
        (0.0, 0.06, -0.08, 1.25),
        (0.0, 0.12, 0.03, 0.4),
    ]);
    let classes = [
        ("AR3, axis 4 off by 5 mm", Class::of(offset, 2)),
        ("FANUC CRX-10iA", Class::built_in("fanuc-crx10ia")),
        ("Kinova Jaco2", Class::built_in("jaco2")),
        ("a general arm", Class::of(general, 2)),
    ];
    for (name, class) in classes {
        let solver = Solver::new(&class.chain).expect("a solver");
        let mut out = Solutions::default();
        let lost = class.lost(|index| {
            let found = solver.solve(&class.poses[index]).expect("a pose");
            found.iter().map(|s| s.q().try_into().expect("six")).collect()
        });
        let mut times: Vec<f64> = Vec::new();
        for _ in 0..20 {
            for pose in &class.poses {
                let start = Instant::now();
                solver.solve_into(black_box(pose), &mut out).unwrap();
                black_box(&out);
                times.push(start.elapsed().as_secs_f64() * 1e6);
            }
        }
        times.sort_by(f64::total_cmp);
        let at = |share: f64| times[(share * times.len() as f64) as usize];
        println!("| {name} | {:.1} | {:.1} | {lost} of {TARGETS} |", at(0.5), at(0.99));
    }
}
