//! Numeric inverse kinematics from one random start: `cargo run --release --manifest-path bench/Cargo.toml --bin numeric`
//!
//! Every contender gets the same targets (poses of random joint values) and the same random start for each. Reached means:
//! within 1e-6 m and 1e-6 rad by our own forward kinematics. `one start` is a descent from the given start alone; the other
//! row goes on, where that ends in a local minimum, from further starts of its own (up to 31, fixed points).

use std::f64::consts::PI;
use std::time::Instant;

use k::nalgebra::{Unit, Vector3};
use k::{InverseKinematicsSolver, Isometry3, JacobianIkSolver, JointType, Node, NodeBuilder, Translation3, UnitQuaternion, connect};
use pieper::ik::{Nearest, Options, Search, Solver};
use pieper::kinematics::tool_pose;
use pieper::model::Chain;
use pieper::spatial::Pose;

const TARGETS: usize = 5000;
const TOLERANCE: f64 = 1e-6;

fn main() {
    for id in ["ur5", "puma560"] {
        let chain = pieper_robots::find(id).expect("built in").robot().chain().expect("numbers");
        let mut random = fastrand::Rng::with_seed(1);
        let mut joints = || -> [f64; 6] { std::array::from_fn(|_| PI * (2.0 * random.f64() - 1.0)) };
        let cases: Vec<(Pose, [f64; 6])> =
            (0..TARGETS).map(|_| (tool_pose(&chain, &joints()).unwrap(), joints())).collect();
        let search = Search::new(&chain).unwrap();
        let k_arm = k_chain(&chain);
        for (pose, q) in &cases {
            k_arm.set_joint_positions_unchecked(q);
            let theirs = k_arm.end_transform().translation;
            let ours = tool_pose(&chain, q).unwrap().translation.vector;
            assert!((ours - nalgebra::Vector3::new(theirs.x, theirs.y, theirs.z)).norm() < 1e-12, "the peer computes another arm");
            assert!(pose.translation.vector.norm() < 3.0);
        }
        println!("\n{id}, {TARGETS} targets, one random start each, one thread\n");
        println!("| | median us | 90 % us | reached |\n|---|---|---|---|");
        let from_one = Options { starts: 1, ..Options::default() };
        run("pieper, one start", &chain, &cases, |pose, start| search.find(pose, start, &from_one).unwrap().q().to_vec());
        run("pieper, further starts if stuck", &chain, &cases, |pose, start| {
            search.find(pose, start, &Options::default()).unwrap().q().to_vec()
        });
        for (name, gain, tries) in [("k 0.32, gain 0.5, 100 steps", 0.5, 100), ("k 0.32, gain 1, 100 steps", 1.0, 100)] {
            let solver = JacobianIkSolver::new(TOLERANCE, TOLERANCE, gain, tries);
            run(name, &chain, &cases, |pose, start| {
                k_arm.set_joint_positions_unchecked(start);
                let _ = solver.solve(&k_arm, &k_pose(pose));
                k_arm.joint_positions()
            });
        }
        let solver = Solver::new(&chain).unwrap();
        let mut found = pieper::ik::Solutions::default();
        run("pieper, all solutions in closed form", &chain, &cases, |pose, _| {
            solver.solve_into(pose, &mut found).unwrap();
            found.as_slice().first().map_or(vec![0.0; 6], |solution| solution.q().to_vec())
        });
    }
}

/// Times each case by itself; the contenders follow one another so closely that the machine's drift does not matter much.
fn run(name: &str, chain: &Chain, cases: &[(Pose, [f64; 6])], mut solve: impl FnMut(&Pose, &[f64; 6]) -> Vec<f64>) {
    let (mut times, mut reached) = (Vec::with_capacity(cases.len()), 0);
    for (pose, start) in cases {
        let begin = Instant::now();
        let q = solve(pose, start);
        times.push(begin.elapsed().as_nanos() as f64 / 1e3);
        let miss = Nearest::at(chain, &q, pose).unwrap();
        reached += usize::from(miss.position_error <= TOLERANCE && miss.orientation_error <= TOLERANCE);
    }
    times.sort_by(f64::total_cmp);
    let share = 100.0 * reached as f64 / cases.len() as f64;
    println!("| {name} | {:.1} | {:.1} | {share:.2} % |", times[cases.len() / 2], times[cases.len() * 9 / 10]);
}

fn k_pose(pose: &Pose) -> Isometry3<f64> {
    let m = pose.rotation.matrix();
    let rotation = k::nalgebra::Matrix3::from_fn(|i, j| m[(i, j)]);
    let rotation = k::nalgebra::Rotation3::from_matrix_unchecked(rotation);
    let t = pose.translation.vector;
    Isometry3::from_parts(Translation3::new(t.x, t.y, t.z), UnitQuaternion::from_rotation_matrix(&rotation))
}

/// The chain for `k`: one node a joint, its own constant link in front of the next.
fn k_chain(chain: &Chain) -> k::SerialChain<f64> {
    let canonical = chain.canonical();
    let mut nodes: Vec<Node<f64>> = Vec::new();
    let mut link = k_pose(&canonical.base);
    let mut push = |node: Node<f64>| {
        if let Some(last) = nodes.last() {
            connect!(last => node);
        }
        nodes.push(node);
    };
    for (index, step) in canonical.steps.iter().enumerate() {
        let origin = link * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), step.drive.offset);
        let axis = Unit::new_normalize(Vector3::z() * step.drive.factor);
        let builder = NodeBuilder::new().name(&format!("q{}", index + 1)).joint_type(JointType::Rotational { axis });
        push(builder.translation(origin.translation).rotation(origin.rotation).into_node());
        link = k_pose(&canonical.link(index));
    }
    let tool = NodeBuilder::new().name("tool").joint_type(JointType::Fixed);
    push(tool.translation(link.translation).rotation(link.rotation).into_node());
    k::SerialChain::from_end(nodes.last().expect("seven nodes"))
}
