//! Times of the solvers of built-in arms, and of forward kinematics: `cargo run --release -p pieper --example solver_times -- [arms]`.
//!
//! Run it with `CARGO_PROFILE_RELEASE_LTO=off` as well, where not even the parts of one crate are optimised together.

// A measuring program: it prints, and it stops where it must not go on.
#![allow(clippy::print_stdout, clippy::unwrap_used)]

use std::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;

use pieper::ik::{Solutions, Solver};
use pieper::kinematics::tool_pose;

const ARMS: [&str; 8] = [
    "irb120",
    "ar3",
    "ur5",
    "stanford",
    "gantry",
    "cobra600",
    "fanuc-crx10ia",
    "crb15000",
];

/// The median over random targets of the best of five calls, nanoseconds.
fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn best(repeats: usize, mut call: impl FnMut()) -> f64 {
    (0..5)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..repeats {
                call();
            }
            start.elapsed().as_nanos() as f64 / repeats as f64
        })
        .fold(f64::INFINITY, f64::min)
}

fn main() {
    let mut asked: Vec<String> = std::env::args().skip(1).collect();
    if asked.is_empty() {
        asked.extend(ARMS.map(str::to_owned));
    }
    for id in &asked {
        let chain = pieper_robots::find(id).unwrap().robot().chain().unwrap();
        let solver = Solver::new(&chain).unwrap();
        let mut random = fastrand::Rng::with_seed(1);
        let (mut solving, mut posing, mut roots) = (Vec::new(), Vec::new(), 0);
        let mut found = Solutions::default();
        for _ in 0..200 {
            let q: Vec<f64> = chain
                .variables()
                .iter()
                .map(|_| PI * (2.0 * random.f64() - 1.0))
                .collect();
            let pose = tool_pose(&chain, &q).unwrap();
            solving.push(best(5, || {
                solver.solve_into(black_box(&pose), &mut found).unwrap();
            }));
            posing.push(best(100, || {
                black_box(tool_pose(&chain, black_box(&q)).unwrap());
            }));
            roots += found.len();
        }
        println!(
            "{id:16} {:16} solutions {:5.2}  solve {:9.1} ns  forward {:6.1} ns",
            solver.choice().name,
            roots as f64 / 200.0,
            median(solving),
            median(posing),
        );
    }
}
