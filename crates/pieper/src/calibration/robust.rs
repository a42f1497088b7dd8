//! Outliers: measurements that do not agree with the others count less and less.

use super::problem::Problem;

/// Tukey's constant: 95 % as sharp as plain squares where there are no outliers.
const TUKEY: f64 = 4.685;

/// A measurement with less weight than this is called an outlier.
pub(super) const OUTLIER: f64 = 0.1;

/// The size of each measurement's residual, in standard deviations of one of its numbers.
pub(super) fn sizes(problem: &Problem) -> Vec<f64> {
    let (residuals, _) = problem.rows(false);
    let starts = problem.starts();
    starts
        .windows(2)
        .map(|pair| {
            let own = &residuals[pair[0]..pair[1]];
            (own.iter().map(|r| r * r).sum::<f64>() / own.len().max(1) as f64).sqrt()
        })
        .collect()
}

/// New weights by Tukey's function of the sizes, in units of their median; how much they changed.
pub(super) fn reweigh(problem: &mut Problem) -> f64 {
    let sizes = sizes(problem);
    let scale = median(&sizes).max(1e-12);
    let mut change = 0.0_f64;
    for (weight, size) in problem.weights.iter_mut().zip(&sizes) {
        // The median size of honest measurements is near 1: of 3 to 6 numbers each.
        let x = size / (scale * TUKEY);
        let new = if x < 1.0 { (1.0 - x * x).powi(2) } else { 0.0 };
        change = change.max((new - *weight).abs());
        *weight = new;
    }
    change
}

/// The middle value.
pub(super) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}
