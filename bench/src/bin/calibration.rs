//! Calibration: how fast, and whether its estimates are as good as they say.
//!
//!     cargo run --release --manifest-path bench/Cargo.toml --bin calibration              # 1,000 trials for each arm
//!     cargo run --release --manifest-path bench/Cargo.toml --bin calibration -- 100
//!
//! `bench/calibration_peer.py` does the same fit with SciPy on the same data.

use std::time::Instant;

use pieper::calibration::{Calibration, Groups, Measurement, Model, Outcome, Random, Simulation, Unit, measure, posture, simulate};
use pieper::kinematics::tool_pose;
use pieper::model::Chain;

fn main() {
    let trials = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(1000);
    println!("| arm | fitted | a fit, ms (median) | in the 95 % ellipsoid | held-out error before / after | 5 % outliers against none |");
    println!("|---|---|---|---|---|---|");
    for id in ["ar3", "irb120"] {
        arm(id, trials);
    }
}

fn arm(id: &str, trials: u64) {
    let robot = pieper_robots::find(id).expect("it is built in").robot();
    let model = Model::of(&robot, Groups::USUAL).expect("it has numbers");
    // 60 poses, 0.05 mm and 0.01 degrees of noise.
    let simulation = Simulation::default();
    let (_, measurements) = simulate(&model, &simulation).expect("joint values");
    let fitted = run(&model, measurements).fitted;
    let (mut inside, mut gains, mut times, mut ratios) = (0, Vec::new(), Vec::new(), Vec::new());
    for seed in 1..=trials {
        let mut random = Random::new(seed);
        // What cannot be told apart is as the description says: there is a truth to compare with.
        let truth: Vec<f64> = (model.parameters().iter().enumerate())
            .map(|(index, parameter)| {
                let wrong = if parameter.unit == Unit::Angle { 5e-3 } else { 1e-3 };
                let off = wrong * random.normal();
                parameter.nominal + if fitted.contains(&index) { off } else { 0.0 }
            })
            .collect();
        let measurements = measure(&model, &truth, &simulation, &mut random).expect("joint values");
        let start = Instant::now();
        let result = run(&model, measurements);
        times.push(start.elapsed().as_secs_f64() * 1e3);
        let off: Vec<f64> = result.fitted.iter().map(|&k| result.estimates[k].value - truth[k]).collect();
        let off = nalgebra::DVector::from_vec(off);
        let inverse = result.covariance.clone().try_inverse().expect("it was told apart");
        if off.dot(&(inverse * &off)) < quantile(result.fitted.len()) {
            inside += 1;
        }
        if let Some(held_out) = result.held_out {
            gains.push(held_out.before / held_out.after);
        }
        if seed <= trials / 5 {
            let dirty = Simulation { outliers: 0.05, ..simulation };
            let with = run(&model, measure(&model, &truth, &dirty, &mut random).expect("joint values"));
            let real = model.chain_with(&truth).expect("it is an arm");
            ratios.push(error(&model, &with, &real) / error(&model, &result, &real));
        }
    }
    println!(
        "| {id} | {} | {:.1} | {inside} of {trials} | {:.0} times smaller (median; least {:.0}) | {:.2} times (median) |",
        fitted.len(),
        middle(&mut times),
        middle(&mut gains),
        gains.iter().copied().fold(f64::INFINITY, f64::min),
        middle(&mut ratios)
    );
}

fn run(model: &Model, measurements: Vec<Measurement>) -> Outcome {
    Calibration::new(model.clone(), measurements).expect("they fit").run().expect("they suffice")
}

/// The root mean square of the tool's error over postures that were not measured.
fn error(model: &Model, result: &Outcome, real: &Chain) -> f64 {
    let found = result.robot(String::new()).and_then(|robot| robot.chain()).expect("it is an arm");
    let mut random = Random::new(4242);
    let mut sum = 0.0;
    for _ in 0..200 {
        let q = posture(model, &mut random);
        let tool = |chain: &Chain| tool_pose(chain, &q).expect("as many values as joints").translation.vector;
        sum += (tool(&found) - tool(real)).norm_squared();
    }
    (sum / 200.0_f64).sqrt()
}

/// The 95 % quantile of the chi-squared distribution, by Wilson and Hilferty's cube root: exact to three digits here.
fn quantile(degrees: usize) -> f64 {
    let k = degrees as f64;
    let part = 2.0 / (9.0 * k);
    k * (1.0 - part + 1.644_854 * part.sqrt()).powi(3)
}

fn middle(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
