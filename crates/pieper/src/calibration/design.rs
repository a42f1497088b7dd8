//! What to measure next: the postures that say most about the parameters.

use nalgebra::DMatrix;

use super::identify::identify;
use super::model::Model;
use super::problem::Problem;
use crate::describe::Measurement;
use crate::error::{Error, Result};

/// Chooses postures for a budget: of many candidates those that make the determinant of the information largest, one after the other, and
/// then each exchanged for a better one as long as there is one (D-optimal by exchange).
///
/// `seen` says what is measured at a posture; its values do not matter. The indices of the candidates chosen, in the order of choosing.
///
/// # Errors
/// An input error: no candidates, or no budget.
pub fn design(model: &Model, candidates: &[Measurement], budget: usize) -> Result<Vec<usize>> {
    if candidates.is_empty() || budget == 0 {
        return Err(Error::input(
            "design",
            "candidates and a budget were expected",
        ));
    }
    let problem = Problem {
        model: model.clone(),
        measurements: candidates.to_vec(),
        sets: Vec::new(),
        set_of: vec![None; candidates.len()],
        parameters: model.parameters().to_vec(),
        values: model.nominal(),
        free: Vec::new(),
        weights: vec![1.0; candidates.len()],
    };
    let (free, _) = identify(&problem);
    let (_, rates) = problem.rows(true);
    let Some(rates) = rates else {
        return Ok(Vec::new());
    };
    let starts = problem.starts();
    // The rates of one candidate, in spreads, one column for each number that is measured.
    let rows = |index: usize| {
        DMatrix::from_fn(free.len(), starts[index + 1] - starts[index], |k, row| {
            rates[(starts[index] + row, free[k])] * problem.parameters[free[k]].spread
        })
    };
    let all: Vec<DMatrix<f64>> = (0..candidates.len()).map(rows).collect();
    // Before anything is measured, the spreads themselves are what is known.
    let mut known = DMatrix::<f64>::identity(free.len(), free.len());
    let mut chosen: Vec<usize> = Vec::new();
    // By how much the information grows with a candidate: the determinant's factor.
    let gain = |inverse: &DMatrix<f64>, of: &DMatrix<f64>| {
        let size = of.ncols();
        (DMatrix::identity(size, size) + of.transpose() * inverse * of).determinant()
    };
    while chosen.len() < budget.min(candidates.len()) {
        let Some(inverse) = known.clone().try_inverse() else {
            break;
        };
        let best = (0..all.len())
            .filter(|index| !chosen.contains(index))
            .max_by(|&a, &b| gain(&inverse, &all[a]).total_cmp(&gain(&inverse, &all[b])));
        let Some(best) = best else { break };
        known += &all[best] * all[best].transpose();
        chosen.push(best);
    }
    // Exchanges, until a whole round finds none.
    for _ in 0..10 {
        let mut is_better = false;
        for place in 0..chosen.len() {
            let without = &known - &all[chosen[place]] * all[chosen[place]].transpose();
            let Some(inverse) = without.clone().try_inverse() else {
                continue;
            };
            let now = gain(&inverse, &all[chosen[place]]);
            let others = (0..all.len()).filter(|index| !chosen.contains(index));
            let best = others.map(|index| (index, gain(&inverse, &all[index])));
            let best = best.max_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((index, value)) = best.filter(|(_, value)| *value > now * (1.0 + 1e-6)) {
                debug_assert!(value.is_finite());
                known = without + &all[index] * all[index].transpose();
                chosen[place] = index;
                is_better = true;
            }
        }
        if !is_better {
            break;
        }
    }
    Ok(chosen)
}
