//! Times and losses near singularities: `cargo run --release -p pieper --example near_singular -- [targets] [arms]`.
//!
//! A random joint vector is moved in one of joints 2 to 5 until the Jacobian's determinant is zero, and then by a given distance.
//! For each joint and distance: the median, the 90 % and the longest time of a call (best of three) in nanoseconds, and how often
//! the joint vector is not among the solutions, up to what rounding of the pose moves it by. Then for each arm all of them together: the
//! longest of 99 % and of 99.9 %, and how many take more than twice as long as a regular pose usually does.

// A measuring program: it prints, and it stops where it must not go on.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use nalgebra::Matrix6;
use pieper::describe::Robot;
use pieper::ik::{Solutions, Solver};
use pieper::kinematics::{Jacobian, Reference, pose_and_jacobian, tool_pose};
use pieper::model::Chain;

const ARMS: [&str; 7] = [
    "irb120",
    "puma560",
    "ur5",
    "fanuc-crx10ia",
    "jaco2",
    "xarm6",
    GENERAL,
];

/// An arm without any structure, as in `bench/`.
const GENERAL: &str = "general";

/// An arm by its name.
fn chain(id: &str) -> Chain {
    let rows = [
        (0.31, 0.12, 1.1),
        (0.07, 0.42, -0.35),
        (-0.11, 0.2, 1.4),
        (0.38, 0.05, -0.9),
        (0.06, -0.08, 1.25),
        (0.12, 0.03, 0.4),
    ];
    if id != GENERAL {
        return pieper_robots::find(id).unwrap().robot().chain().unwrap();
    }
    let mut text = "name = 'general'\nconvention = 'standard'\n".to_owned();
    for (index, (d, a, alpha)) in rows.iter().enumerate() {
        let joint = index + 1;
        text += &format!("[[joint]]\ntheta = 'q{joint}'\nd = {d}\na = {a}\nalpha = {alpha}\n");
    }
    Robot::from_toml("general.toml", &text)
        .unwrap()
        .chain()
        .unwrap()
}

fn jacobian(chain: &Chain, q: &[f64; 6]) -> Matrix6<f64> {
    let mut columns = Jacobian::zeros(6);
    pose_and_jacobian(chain, q, Reference::Base, &mut columns).unwrap();
    Matrix6::from_fn(|row, column| columns[(row, column)])
}

fn random_joints(random: &mut fastrand::Rng) -> [f64; 6] {
    std::array::from_fn(|_| (2.0 * random.f64() - 1.0) * PI)
}

/// A joint vector where the determinant vanishes, moved there in one joint.
fn singular(chain: &Chain, joint: usize, random: &mut fastrand::Rng) -> Option<[f64; 6]> {
    let mut low = random_joints(random);
    let mut high = low;
    high[joint] += 3.0 * random.f64();
    let sign = jacobian(chain, &low).determinant();
    if sign * jacobian(chain, &high).determinant() > 0.0 {
        return None;
    }
    for _ in 0..70 {
        let mut middle = low;
        middle[joint] = 0.5 * (low[joint] + high[joint]);
        match jacobian(chain, &middle).determinant() * sign > 0.0 {
            true => low = middle,
            false => high = middle,
        }
    }
    Some(low)
}

/// The best of three calls.
fn time(solver: &Solver, q: &[f64; 6], found: &mut Solutions) -> f64 {
    let pose = tool_pose(solver.chain(), q).unwrap();
    let call = |found: &mut Solutions| {
        let start = Instant::now();
        solver.solve_into(&pose, found).unwrap();
        start.elapsed().as_nanos() as f64
    };
    (0..3).map(|_| call(found)).fold(f64::INFINITY, f64::min)
}

/// Whether the joint vector is listed or on a family that is, up to what 3e-15 of the pose moves it by.
fn is_found(solver: &Solver, q: &[f64; 6], found: &Solutions) -> bool {
    let values = jacobian(solver.chain(), q).singular_values();
    let allowed = (3e-15 * values.max() / values.min()).max(2e-6);
    let turn = |a: f64, b: f64| ((a - b) / TAU - ((a - b) / TAU).round()).abs() * TAU;
    let near = |other: &[f64]| other.iter().zip(q).all(|(a, b)| turn(*a, *b) < allowed);
    let on_family = |family| {
        solver
            .nearest_member(family, q)
            .is_ok_and(|member| near(&member))
    };
    found.iter().any(|solution| near(solution.q())) || found.families().iter().any(on_family)
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().map_or(100, |text| text.parse().unwrap());
    let named: Vec<String> = arguments.collect();
    let mut random = fastrand::Rng::with_seed(3);
    let mut found = Solutions::default();
    for id in ARMS {
        if !named.is_empty() && !named.iter().any(|name| name == id) {
            continue;
        }
        let chain = chain(id);
        let solver = Solver::new(&chain).unwrap();
        let mut regular: Vec<f64> = (0..400)
            .map(|_| time(&solver, &random_joints(&mut random), &mut found))
            .collect();
        regular.sort_by(f64::total_cmp);
        let usual = regular[200];
        println!("{id}: regular {usual:.0} ns");
        let mut all = Vec::new();
        for joint in 1..5 {
            for exponent in [3, 5, 7, 9, 12] {
                let (mut times, mut lost) = (Vec::new(), 0);
                for _ in 0..100 * count {
                    if times.len() == count {
                        break;
                    }
                    let Some(mut q) = singular(&chain, joint, &mut random) else {
                        continue;
                    };
                    q[joint] += 10_f64.powi(-exponent);
                    times.push(time(&solver, &q, &mut found));
                    lost += usize::from(!is_found(&solver, &q, &found));
                }
                times.sort_by(f64::total_cmp);
                let Some(longest) = times.last() else {
                    continue;
                };
                println!(
                    "  joint {} 1e-{exponent:<2}  median {:>7.0}  90 % {:>7.0}  longest {longest:>7.0}  lost {lost} of {}",
                    joint + 1,
                    times[times.len() / 2],
                    times[times.len() * 9 / 10],
                    times.len()
                );
                all.extend(times);
            }
        }
        if all.is_empty() {
            continue;
        }
        all.sort_by(f64::total_cmp);
        let of = |share: f64| all[(all.len() as f64 * share) as usize];
        let slow = all.iter().filter(|time| **time > 2.0 * usual).count();
        println!(
            "  all          99 % {:>7.0}  99.9 % {:>7.0}  more than twice the regular time: {:.1} % of {}",
            of(0.99),
            of(0.999),
            100.0 * slow as f64 / all.len() as f64,
            all.len()
        );
    }
}
