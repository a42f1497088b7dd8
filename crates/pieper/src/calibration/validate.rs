//! How well the arm is known where it was not measured.

use super::problem::Problem;
use super::solve::{fit, residuals};

/// Residuals of measurements that took no part in the fit that predicts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldOut {
    /// Root mean square of the lengths, metres, with the description's numbers.
    pub before: f64,
    /// With the estimated ones.
    pub after: f64,
    /// How many fits.
    pub folds: usize,
}

/// Cross-validation: every measurement is predicted by a fit without it and its like. Outliers are left out throughout.
pub(super) fn hold_out(problem: &Problem, folds: usize) -> Option<HeldOut> {
    let honest: Vec<usize> = (0..problem.measurements.len())
        .filter(|&k| problem.weights[k] >= super::robust::OUTLIER)
        .collect();
    let numbers: usize = honest
        .iter()
        .map(|&k| problem.measurements[k].seen.count())
        .sum();
    if honest.len() < 2 * folds || numbers * (folds - 1) / folds <= problem.free.len() {
        return None;
    }
    let mut nominal = problem.clone();
    for (value, parameter) in nominal.values.iter_mut().zip(&problem.parameters) {
        *value = parameter.nominal;
    }
    let before = residuals(&nominal);
    let (mut sum_before, mut sum_after) = (0.0, 0.0);
    for fold in 0..folds {
        let mut part = problem.clone();
        for (place, &index) in honest.iter().enumerate() {
            if place % folds == fold {
                part.weights[index] = 0.0;
            }
        }
        let (part, _) = fit(part, false);
        let after = residuals(&part);
        for (_, &index) in honest
            .iter()
            .enumerate()
            .filter(|(place, _)| place % folds == fold)
        {
            sum_before += before[index].length.powi(2);
            sum_after += after[index].length.powi(2);
        }
    }
    let mean = |sum: f64| (sum / honest.len() as f64).sqrt();
    Some(HeldOut {
        before: mean(sum_before),
        after: mean(sum_after),
        folds,
    })
}
