//! Which parameters the measurements can tell apart.

use nalgebra::{DMatrix, DVector};

use super::parameter::Group;
use super::problem::Problem;

/// A parameter that is held at its nominal value, because the measurements show it only together with others.
#[derive(Clone, Debug, PartialEq)]
pub struct Held {
    /// Its name.
    pub name: String,
    /// What it shows together with. Empty: it does not show at all.
    pub with: Vec<Together>,
}

/// A parameter that shows the same as another.
#[derive(Clone, Debug, PartialEq)]
pub struct Together {
    /// Its name.
    pub name: String,
    /// How much of it has the effect of one unit of the held one.
    pub factor: f64,
}

impl Held {
    /// In words: "d2 and d3 only together".
    pub fn sentence(&self) -> String {
        match self.with.as_slice() {
            [] => format!("{} does not show in these measurements", self.name),
            with => {
                let names: Vec<&str> = with.iter().map(|other| other.name.as_str()).collect();
                format!("{} and {} only together", self.name, names.join(", "))
            }
        }
    }
}

/// A column is another combination of the ones before it where less than this share of it is left. Rounding leaves 1e-13.
const NOTHING: f64 = 1e-9;

/// What a parameter adds by moving as far as its spread, in standard deviations of all measurements together: less than this, and
/// they tell nothing of it that was not known before.
const FAINT: f64 = 1.0;

/// Combinations with less than this share of a unit, in spreads, are not named.
const NAMED: f64 = 1e-4;

/// Frames are held before the arm's own parameters: what shows in both is the arm's.
const LATER: [(Group, f64); 4] = [
    (Group::Base, 1e-3),
    (Group::Tool, 1e-3),
    (Group::Gear, 1e-2),
    (Group::Drive, 1e-2),
];

/// Splits the parameters that are fitted, or all where none is yet, into those that can be told apart, and the others with what they show together with.
pub(super) fn identify(problem: &Problem) -> (Vec<usize>, Vec<Held>) {
    let among: Vec<usize> = match problem.free.is_empty() {
        true => (0..problem.parameters.len()).collect(),
        false => problem.free.clone(),
    };
    let (_, rates) = problem.rows(true);
    let Some(mut rates) = rates else {
        return (Vec::new(), Vec::new());
    };
    let names: Vec<&str> = problem.parameters.iter().map(|p| p.name.as_str()).collect();
    for (column, parameter) in problem.parameters.iter().enumerate() {
        rates.column_mut(column).scale_mut(parameter.spread);
    }
    let (mut kept, rest) = pivot(problem, &rates, among);
    // There are no singular values of nothing.
    let chosen = (!kept.is_empty()).then(|| rates.select_columns(&kept).svd(true, true));
    let mut held = Vec::new();
    for &index in &rest {
        let column: DVector<f64> = rates.column(index).into();
        let spread = problem.parameters[index].spread;
        let with = match chosen.as_ref().filter(|_| column.norm() > 0.0) {
            None => Vec::new(),
            Some(chosen) => {
                let factors = chosen.solve(&column, 1e-12);
                let factors = factors.unwrap_or_else(|_| DVector::zeros(kept.len()));
                let largest = factors.amax();
                let named = kept.iter().zip(factors.iter());
                named
                    .filter(|(_, factor)| factor.abs() > NAMED * largest.max(1e-6))
                    .map(|(&other, factor)| Together {
                        name: names[other].to_owned(),
                        factor: factor * problem.parameters[other].spread / spread,
                    })
                    .collect()
            }
        };
        held.push(Held {
            name: names[index].to_owned(),
            with,
        });
    }
    kept.sort_unstable();
    (kept, held)
}

/// Gram-Schmidt with the largest remaining column first: what is left of the others in the end is what they add.
fn pivot(
    problem: &Problem,
    rates: &DMatrix<f64>,
    mut open: Vec<usize>,
) -> (Vec<usize>, Vec<usize>) {
    let count = rates.ncols();
    let mut left = rates.clone();
    let sizes: Vec<f64> = (0..count).map(|k| rates.column(k).norm()).collect();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let rank = |index: usize| {
        let group = problem.parameters[index].group;
        let found = LATER.iter().find(|(later, _)| *later == group);
        found.map_or(1.0, |(_, share)| *share)
    };
    let mut kept: Vec<usize> = Vec::new();
    loop {
        let remains = |k: usize| left.column(k).norm();
        let adds = |k: usize| remains(k) > FAINT.max(NOTHING * sizes[k].max(1e-6 * largest));
        let next = open
            .iter()
            .copied()
            .filter(|&k| adds(k))
            .max_by(|&a, &b| (remains(a) * rank(a)).total_cmp(&(remains(b) * rank(b))));
        let Some(next) = next else {
            return (kept, open);
        };
        open.retain(|&k| k != next);
        kept.push(next);
        let direction = left.column(next).normalize();
        for &other in &open {
            // Twice is enough: rounding of the first is taken away by the second.
            for _ in 0..2 {
                let share = direction.dot(&left.column(other));
                left.column_mut(other).axpy(-share, &direction, 1.0);
            }
        }
    }
}
