//! What kind of arm each built-in robot is, and what bad input leads to.

use crate::support::arms;
use pieper::ik::{Solver, Status};
use pieper::kinematics::tool_pose;
use pieper::spatial::{Pose, shift};

/// The families of the built-in robots.
const CLASSES: &[(&str, &str)] = &[
    ("ar3", "spherical wrist, spherical"),
    ("ar3-annin", "spherical wrist, spherical"),
    ("ar4", "spherical wrist, spherical"),
    ("ar4-modified", "spherical wrist, spherical"),
    ("gantry", "spherical wrist, spherical"),
    ("puma560", "spherical wrist, spherical"),
    ("stanford", "spherical wrist, spherical"),
    ("irb120", "spherical wrist, spherical"),
    ("irb140", "spherical wrist, spherical"),
    ("irb1200", "spherical wrist, spherical"),
    ("irb1600", "spherical wrist, spherical"),
    ("irb2400", "spherical wrist, spherical"),
    ("irb2600", "spherical wrist, spherical"),
    ("irb4400", "spherical wrist, spherical"),
    ("irb4600", "spherical wrist, spherical"),
    ("irb6640", "spherical wrist, spherical"),
    ("irb6700", "spherical wrist, spherical"),
    ("crb15000", "offset wrist, offset-wrist"),
    ("irb910sc", "all axes parallel, planar"),
    ("cobra600", "all axes parallel, planar"),
    ("kuka-kr6-r700", "spherical wrist, spherical"),
    ("kuka-kr10-r1100", "spherical wrist, spherical"),
    ("kuka-kr16-2", "spherical wrist, spherical"),
    (
        "iiwa7",
        "spherical shoulder, elbow, spherical wrist, swivel",
    ),
    (
        "iiwa14",
        "spherical shoulder, elbow, spherical wrist, swivel",
    ),
    ("staubli-tx60", "spherical wrist, spherical"),
    ("staubli-tx2-60", "spherical wrist, spherical"),
    ("staubli-tx2-60l", "spherical wrist, spherical"),
    ("staubli-tx2-90", "spherical wrist, spherical"),
    ("fanuc-lrmate200id", "spherical wrist, spherical"),
    ("fanuc-m10ia", "spherical wrist, spherical"),
    ("fanuc-crx5ia", "offset wrist, offset-wrist"),
    ("fanuc-crx10ia", "offset wrist, offset-wrist"),
    ("fanuc-crx10ia-l", "offset wrist, offset-wrist"),
    ("fanuc-crx20ia-l", "offset wrist, offset-wrist"),
    ("yaskawa-gp7", "spherical wrist, spherical"),
    ("yaskawa-gp8", "spherical wrist, spherical"),
    ("ur3", "three parallel axes, three-parallel"),
    ("ur3e", "three parallel axes, three-parallel"),
    ("ur5", "three parallel axes, three-parallel"),
    ("ur5e", "three parallel axes, three-parallel"),
    ("ur10", "three parallel axes, three-parallel"),
    ("ur10e", "three parallel axes, three-parallel"),
    ("ur16e", "three parallel axes, three-parallel"),
    ("ur20", "three parallel axes, three-parallel"),
    ("ur30", "three parallel axes, three-parallel"),
    ("panda", "general, locked"),
    ("fr3", "general, locked"),
    ("jaco2", "offset wrist, offset-wrist"),
    ("kinova-gen3", "general, locked"),
    ("xarm6", "offset wrist, offset-wrist"),
    ("xarm7", "general, locked"),
    ("abb-paper", "spherical wrist, spherical"),
];

#[test]
fn every_built_in_robot_has_its_class() {
    let shown = |solver: &Solver| format!("{}, {}", solver.choice().class, solver.choice().name);
    let all: Vec<(&str, String)> = arms()
        .map(|(id, chain)| (id, shown(&Solver::new(&chain).unwrap())))
        .collect();
    for (id, class) in &all {
        let expected = CLASSES
            .iter()
            .find(|(one, _)| one == id)
            .map(|(_, class)| *class);
        assert_eq!(expected, Some(class.as_str()), "{id}: {all:#?}");
    }
}

#[test]
fn unreachable_poses_say_why() {
    let ar3 = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let solver = Solver::new(&ar3).unwrap();
    let mut pose = tool_pose(&ar3, &[0.0; 6]).unwrap();
    pose.translation.vector.y += 0.01;
    let found = solver.solve(&pose).unwrap();
    assert_eq!(found.status(), Status::Unreachable);
    let reason = found.reason().unwrap().to_string();
    assert_eq!(reason, "wrist centre 0.0100 m beyond the arm's reach");
    let nearest = solver.nearest(&pose).unwrap();
    assert!(nearest.position_error < 0.0101, "{nearest:?}");
}

#[test]
fn every_arm_answers_far_and_odd_poses() {
    for (id, chain) in arms() {
        let solver = Solver::new(&chain).unwrap();
        for pose in [
            shift(nalgebra::Vector3::new(1e3, -2e3, 1e6)),
            shift(nalgebra::Vector3::zeros()),
        ] {
            let found = solver.solve(&pose).unwrap();
            if found.status() == Status::Unreachable {
                let reason = found.reason().unwrap();
                assert!(reason.amount >= 0.0, "{id} {reason}");
            }
        }
    }
}

#[test]
fn bad_poses_are_refused() {
    let ar3 = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let solver = Solver::new(&ar3).unwrap();
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(
            solver
                .solve(&shift(nalgebra::Vector3::new(bad, 0.0, 0.0)))
                .is_err()
        );
    }
    let stretched = nalgebra::Matrix3::identity() * 1.001;
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(stretched);
    let error = solver
        .solve(&Pose::from_parts(
            nalgebra::Vector3::zeros().into(),
            rotation,
        ))
        .unwrap_err();
    assert!(error.is_input());
}
