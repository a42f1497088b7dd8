//! Estimating.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, Vector3};

use super::columns::check_columns;
use super::identify::{Held, identify};
use super::model::Model;
use super::parameter::{Parameter, Unit};
use super::place::{place_frames, place_sets, sets_of};
use super::problem::Problem;
use super::robust::{OUTLIER, reweigh};
use super::validate::{HeldOut, hold_out};
use crate::describe::{Measurement, Robot, Seen};

use crate::error::{Error, Result};

/// A parameter as estimated.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name.
    pub name: String,
    /// What it measures.
    pub unit: Unit,
    /// The description's value.
    pub nominal: f64,
    /// The estimate.
    pub value: f64,
    /// Its standard deviation. `None` where it was held.
    pub sigma: Option<f64>,
}

/// What is left of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// The distance between the tool's point and what was seen, metres.
    pub length: f64,
    /// The angle between the tool's frame and what was seen, radians; for poses.
    pub angle: Option<f64>,
    /// How much it counted: 0 for an outlier, 1 otherwise.
    pub weight: f64,
}

/// A finished calibration.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Whether the solver converged; if not, what is here is the best it found.
    pub converged: bool,
    /// Why it ended.
    pub ending: String,
    /// Every parameter.
    pub estimates: Vec<Estimate>,
    /// Those held, and what they show together with.
    pub held: Vec<Held>,
    /// Correlation of the fitted parameters, in the order of `fitted`.
    pub correlation: DMatrix<f64>,
    /// The indices of the fitted parameters among the estimates.
    pub fitted: Vec<usize>,
    /// Covariance of the fitted parameters.
    pub covariance: DMatrix<f64>,
    /// Largest over smallest singular value of the scaled rates: how well the best and the worst known combination differ.
    pub condition: f64,
    /// What was left of each measurement before, and is now.
    pub before: Vec<Residual>,
    /// After.
    pub after: Vec<Residual>,
    /// Measurements that do not agree with the others.
    pub outliers: Vec<usize>,
    /// Residuals of measurements that took no part in the fit that predicts them. `None` where there were too few.
    pub held_out: Option<HeldOut>,
    /// The mean square of what is left, in standard deviations; near 1 where they are honest.
    pub variance: f64,
    values: Vec<f64>,
    model: Model,
}

impl Outcome {
    /// The estimated arm, with a text that says where its numbers come from.
    ///
    /// # Errors
    /// A model error for an estimate that makes no arm.
    pub fn robot(&self, source: String) -> Result<Robot> {
        let own = self.model.parameters().len();
        self.model.robot_with(&self.values[..own], source)
    }
}

/// A calibration that is set up.
#[derive(Clone, Debug)]
pub struct Calibration {
    problem: Problem,
    is_robust: bool,
}

/// Lengths and angles above this, metres and radians, are no arm's, and their squares would be no numbers.
const MOST: f64 = 1e6;

/// The most rounds of reweighing.
const ROUNDS: usize = 30;

/// Cross-validation leaves out a fifth at a time.
const FOLDS: usize = 5;

impl Calibration {
    /// A calibration of a model by measurements; outliers count less.
    ///
    /// # Errors
    /// An input error: no measurements, no parameters, fewer numbers than parameters that can be told apart, measurements that do not fit
    /// the arm; with what to do. Where lengths are a thousand times too long or too short, that is said.
    pub fn new(model: Model, measurements: Vec<Measurement>) -> Result<Self> {
        let fail = |text: &str| Err(Error::input("calibration", text));
        if model.parameters().is_empty() {
            return fail("parameters to estimate were expected");
        }
        if measurements.is_empty() {
            return fail("measurements were expected");
        }
        for (index, measurement) in measurements.iter().enumerate() {
            let subject = || format!("measurement {}", index + 1);
            model
                .joints(&measurement.readings)
                .map_err(|error| Error::input(subject(), error.to_string()))?;
            let is_positive = |sigma: f64| (1e-15..MOST).contains(&sigma);
            if !is_positive(measurement.sigma) || !is_positive(measurement.sigma_angle) {
                let text = "a standard deviation above zero was expected";
                return Err(Error::input(subject(), text));
            }
            let readings = measurement.readings.values();
            if let Some(value) = readings
                .iter()
                .chain(&measurement.seen.lengths())
                .find(|x| x.is_nan() || x.abs() > MOST)
            {
                let text = format!("{value} is no arm's: at most {MOST:e} was expected");
                return Err(Error::input(subject(), text));
            }
        }
        check_units(&model, &measurements)?;
        let mut parameters: Vec<Parameter> = model.parameters().to_vec();
        let mut values = model.nominal();
        let (sets, set_of) = sets_of(&measurements);
        for set in &sets {
            let own = Problem::set_parameters(set.kind, &set.name);
            values.extend(own.iter().map(|p| p.nominal));
            parameters.extend(own);
        }
        let mut problem = Problem {
            weights: vec![1.0; measurements.len()],
            model,
            measurements,
            sets,
            set_of,
            parameters,
            values,
            free: Vec::new(),
        };
        place_frames(&mut problem);
        place_sets(&mut problem);
        check_columns(&problem)?;
        Ok(Self {
            problem,
            is_robust: true,
        })
    }

    /// Whether outliers count less; they do unless this says otherwise.
    #[must_use]
    pub fn robust(mut self, is_robust: bool) -> Self {
        self.is_robust = is_robust;
        self
    }

    /// Estimates.
    ///
    /// # Errors
    /// An input error where there are fewer numbers than parameters that can be told apart.
    pub fn run(self) -> Result<Outcome> {
        let before = residuals(&self.nominal());
        let is_robust = self.is_robust;
        let mut problem = self.problem;
        let (free, held) = identify(&problem);
        if free.is_empty() {
            let text = "none of the parameters shows in these measurements: other postures, or other parameters, were expected";
            return Err(Error::input("calibration", text));
        }
        let numbers = problem.starts()[problem.measurements.len()];
        if numbers <= free.len() {
            return Err(Error::input(
                "calibration",
                format!(
                    "{numbers} measured numbers cannot determine {} parameters and show how well: measure more, or choose fewer parameters",
                    free.len()
                ),
            ));
        }
        problem.free = free;
        let start = problem.values.clone();
        let (mut problem, mut ending) = fit(problem, is_robust);
        // Where the description's numbers are far off, what is left over can look like information. At the estimate it does not.
        let mut held = held;
        for _ in 0..3 {
            let (kept, more) = identify(&problem);
            if more.is_empty() {
                break;
            }
            for index in problem.free.iter().filter(|index| !kept.contains(index)) {
                problem.values[*index] = start[*index];
            }
            held.extend(more);
            problem.free = kept;
            (problem, ending) = fit(problem, is_robust);
        }
        let (covariance, condition) = covariance(&problem);
        let (residual, _) = problem.rows(false);
        let weighted: f64 = problem
            .starts()
            .windows(2)
            .zip(&problem.weights)
            .map(|(pair, w)| {
                residual[pair[0]..pair[1]]
                    .iter()
                    .map(|r| r * r * w)
                    .sum::<f64>()
            })
            .sum();
        let counted: f64 = problem
            .measurements
            .iter()
            .zip(&problem.weights)
            .map(|(m, w)| m.seen.count() as f64 * w)
            .sum();
        let variance = weighted / (counted - problem.free.len() as f64).max(1.0);
        let after = residuals(&problem);
        let outliers = (0..problem.weights.len())
            .filter(|&k| problem.weights[k] < OUTLIER)
            .collect();
        let held_out = hold_out(&problem, FOLDS);
        // The sets are told with the estimates, as they were found.
        let sigma = |index: usize| {
            let at = problem.free.iter().position(|&free| free == index);
            at.map(|at| covariance[(at, at)].max(0.0).sqrt())
        };
        let estimates = problem
            .parameters
            .iter()
            .enumerate()
            .map(|(index, parameter)| Estimate {
                name: parameter.name.clone(),
                unit: parameter.unit,
                nominal: parameter.nominal,
                value: problem.values[index],
                sigma: sigma(index),
            })
            .collect();
        let correlation = DMatrix::from_fn(covariance.nrows(), covariance.ncols(), |i, j| {
            covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt()
        });
        Ok(Outcome {
            converged: ending.is_ok(),
            ending: ending.unwrap_or_else(|text| text),
            estimates,
            held,
            correlation,
            fitted: problem.free.clone(),
            covariance,
            condition,
            before,
            after,
            outliers,
            held_out,
            variance,
            values: problem.values,
            model: problem.model,
        })
    }

    /// The problem with the description's own numbers; anchors, planes and contacts as they were placed.
    fn nominal(&self) -> Problem {
        self.problem.clone()
    }
}

/// Fits, reweighing until the weights stand. How it ended: in words, or why it did not.
pub(super) fn fit(
    problem: Problem,
    is_robust: bool,
) -> (Problem, std::result::Result<String, String>) {
    let (mut problem, mut ending) = minimise(problem);
    if is_robust {
        for _ in 0..ROUNDS {
            if reweigh(&mut problem) < 1e-3 {
                break;
            }
            (problem, _) = minimise(problem);
        }
        // Now that they are known: outliers do not count, and the others count in full, which is as sharp as can be.
        for weight in &mut problem.weights {
            *weight = if *weight < OUTLIER { 0.0 } else { 1.0 };
        }
        (problem, ending) = minimise(problem);
    }
    (problem, ending)
}

fn minimise(problem: Problem) -> (Problem, std::result::Result<String, String>) {
    let start = problem.clone();
    let solver = LevenbergMarquardt::new().with_patience(60);
    let (found, report) = solver.minimize(problem);
    let is_finite = found.values.iter().all(|value| value.is_finite());
    let words = format!(
        "{:?} after {} evaluations",
        report.termination, report.number_of_evaluations
    );
    match (is_finite, report.termination.was_successful()) {
        (true, true) => (found, Ok(words)),
        (true, false) => (found, Err(words)),
        (false, _) => (start, Err(words)),
    }
}

/// The covariance of the fitted parameters, and the condition of their scaled rates.
pub(super) fn covariance(problem: &Problem) -> (DMatrix<f64>, f64) {
    let (_, rates) = problem.rows(true);
    let count = problem.free.len();
    let Some(rates) = rates else {
        return (DMatrix::zeros(count, count), f64::INFINITY);
    };
    let starts = problem.starts();
    let mut scaled = DMatrix::from_fn(rates.nrows(), count, |row, column| {
        let index = problem.free[column];
        rates[(row, index)] * problem.parameters[index].spread
    });
    for (pair, weight) in starts.windows(2).zip(&problem.weights) {
        for row in pair[0]..pair[1] {
            scaled.row_mut(row).scale_mut(weight.sqrt());
        }
    }
    let svd = scaled.svd(false, true);
    let (largest, smallest) = (svd.singular_values.max(), svd.singular_values.min());
    let Some(v) = svd.v_t.map(|v| v.transpose()) else {
        return (DMatrix::zeros(count, count), f64::INFINITY);
    };
    let inverse = svd
        .singular_values
        .map(|s| if s > 0.0 { 1.0 / (s * s) } else { 0.0 });
    let mut covariance = &v * DMatrix::from_diagonal(&inverse) * v.transpose();
    for i in 0..count {
        for j in 0..count {
            let spread = |k: usize| problem.parameters[problem.free[k]].spread;
            covariance[(i, j)] *= spread(i) * spread(j);
        }
    }
    (covariance, largest / smallest)
}

/// What is left of each measurement, in metres and radians.
pub(super) fn residuals(problem: &Problem) -> Vec<Residual> {
    let (rows, _) = problem.rows(false);
    let starts = problem.starts();
    let of = |(index, measurement): (usize, &Measurement)| {
        let own = &rows[starts[index]..starts[index + 1]];
        let length = own
            .iter()
            .take(3)
            .map(|r| (r * measurement.sigma).powi(2))
            .sum::<f64>()
            .sqrt();
        let angle = (own.len() == 6).then(|| {
            let turned = own[3..]
                .iter()
                .map(|r| (r * measurement.sigma_angle).powi(2));
            turned.sum::<f64>().sqrt()
        });
        Residual {
            length,
            angle,
            weight: problem.weights[index],
        }
    };
    problem.measurements.iter().enumerate().map(of).collect()
}

/// Lengths that fit a thousand times better in another unit.
fn check_units(model: &Model, measurements: &[Measurement]) -> Result<()> {
    let mut ratios = Vec::new();
    let values = model.nominal();
    let arm = model.with(&values);
    for measurement in measurements {
        let seen = match &measurement.seen {
            Seen::Pose(pose) => pose.translation.vector,
            Seen::Position { point, .. } => Vector3::from(*point),
            _ => continue,
        };
        let Some(sensed) = arm.sense(&measurement.readings) else {
            continue;
        };
        let there = sensed.tool.translation.vector;
        if there.norm() > 1e-3 && seen.norm() > 0.0 {
            ratios.push(seen.norm() / there.norm());
        }
    }
    let ratio = super::robust::median(&ratios);
    let text = match ratio {
        r if r > 200.0 => {
            "the measured lengths are a thousand times those of the arm: are they in millimetres? Columns such as x_mm are"
        }
        r if r > 0.0 && r < 0.005 => {
            "the measured lengths are a thousandth of those of the arm: are columns in metres called x_mm?"
        }
        _ => return Ok(()),
    };
    Err(Error::input("calibration", text))
}
