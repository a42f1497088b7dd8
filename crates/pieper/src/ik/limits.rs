//! Joint limits, whole turns, and the order a seed asks for.

use std::f64::consts::TAU;

use super::TOLERANCES;
use super::angle::is_periodic;
use super::arm::{Arm, MAX_JOINTS};
use super::curve;
use super::solutions::{JointVector, Solution, Solutions};
use crate::model::Chain;

/// The least and the greatest values within the joints' limits, with what rounding may add; infinite where there are none.
pub(super) fn bounds(chain: &Chain) -> [JointVector; 2] {
    let mut bounds = [[f64::NEG_INFINITY; MAX_JOINTS], [f64::INFINITY; MAX_JOINTS]];
    for (j, variable) in chain.variables().iter().enumerate().take(MAX_JOINTS) {
        if let Some(limits) = variable.limits {
            bounds[0][j] = limits.lower() - TOLERANCES.limit;
            bounds[1][j] = limits.upper() + TOLERANCES.limit;
        }
    }
    bounds
}

/// Whether every value lies within its joint's limits.
pub(super) fn within([lower, upper]: &[JointVector; 2], q: &JointVector) -> bool {
    let mut within = true;
    for ((value, lower), upper) in q.iter().zip(lower).zip(upper) {
        within &= lower <= value && value <= upper;
    }
    within
}

/// Whether every value, or a copy of it by whole turns, lies within its joint's limits.
pub(super) fn fits(chain: &Chain, q: &JointVector) -> bool {
    (0..chain.dof()).all(|j| copy_within(chain, j, q[j]).is_some())
}

/// Replaces every value by the copy closest to it that lies within its joint's limits, where there is one.
pub(super) fn bring(chain: &Chain, q: &mut JointVector) {
    for (j, value) in q.iter_mut().enumerate().take(chain.dof()) {
        *value = copy_within(chain, j, *value).unwrap_or(*value);
    }
}

/// The copy by whole turns closest to a value that lies within the limits.
fn copy_within(chain: &Chain, variable: usize, value: f64) -> Option<f64> {
    let Some(limits) = chain.variables()[variable].limits else {
        return Some(value);
    };
    let (lower, upper) = (
        limits.lower() - TOLERANCES.limit,
        limits.upper() + TOLERANCES.limit,
    );
    let turns = match is_periodic(chain, variable) {
        true if value < lower => ((lower - value) / TAU).ceil(),
        true if value > upper => -((value - upper) / TAU).ceil(),
        _ => 0.0,
    };
    let value = value + turns * TAU;
    (lower <= value && value <= upper).then_some(value)
}

/// The most copies of one solution that are listed: six joints with three turns each.
const MOST_COPIES: usize = 729;

/// Every solution within the limits: each isolated one with all its copies by whole turns that fit.
///
/// A joint without limits, or one that turns without end, keeps its value in (-pi, pi].
pub fn windings(chain: &Chain, solutions: &Solutions) -> Vec<Solution> {
    solutions
        .iter()
        .flat_map(|solution| copies(chain, solution))
        .collect()
}

fn copies(chain: &Chain, solution: &Solution) -> Vec<Solution> {
    let mut list = vec![Solution {
        within_limits: true,
        ..*solution
    }];
    for j in 0..chain.dof() {
        let values = values_within(chain, j, solution.q[j]);
        let vary = |copy: &Solution| -> Vec<Solution> {
            let with = |&value: &f64| {
                let mut copy = *copy;
                copy.q[j] = value;
                copy
            };
            values.iter().map(with).collect()
        };
        list = list.iter().flat_map(vary).take(MOST_COPIES).collect();
    }
    list
}

/// A value and its copies by whole turns that lie within the limits, the smallest change first.
fn values_within(chain: &Chain, variable: usize, value: f64) -> Vec<f64> {
    let Some(limits) = chain.variables()[variable].limits else {
        return vec![value];
    };
    let (lower, upper) = (
        limits.lower() - TOLERANCES.limit,
        limits.upper() + TOLERANCES.limit,
    );
    if !is_periodic(chain, variable) {
        return Vec::from_iter((lower <= value && value <= upper).then_some(value));
    }
    let first = ((lower - value) / TAU).ceil();
    let last = ((upper - value) / TAU).floor();
    // Limits of a million turns mean none; list the near ones.
    let (first, last) = (first.max(-64.0) as i64, last.min(64.0) as i64);
    let mut turns: Vec<i64> = (first..=last).collect();
    turns.sort_by_key(|turn| (turn.abs(), -turn));
    turns
        .iter()
        .map(|&turn| value + turn as f64 * TAU)
        .collect()
}

/// What comes first in a list of solutions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ranking<'a> {
    /// The one closest to these joint values (sum of squares, radians and metres).
    Seed(&'a [f64]),
    /// The one farthest from its limits (the smallest margin, as part of each joint's range).
    Margin,
    /// The one farthest from a singular pose: by the smallest singular value of the Jacobian there, with lengths in the
    /// arm's extent.
    Singularity,
}

/// Sorts solutions; equal ones keep their order.
pub fn rank(chain: &Chain, solutions: &mut [Solution], ranking: Ranking<'_>) {
    match ranking {
        Ranking::Seed(seed) => {
            let distance = |solution: &Solution| -> f64 {
                let squares = solution
                    .q()
                    .iter()
                    .zip(seed)
                    .map(|(a, b)| (a - b) * (a - b));
                squares.sum()
            };
            solutions.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        }
        Ranking::Margin => {
            let margin = |solution: &Solution| {
                let joints = chain.variables().iter().zip(solution.q());
                let margins = joints.filter_map(|(variable, value)| {
                    let limits = variable.limits?;
                    let range = (limits.upper() - limits.lower()).max(f64::MIN_POSITIVE);
                    Some((value - limits.lower()).min(limits.upper() - value) / range)
                });
                margins.fold(f64::INFINITY, f64::min)
            };
            solutions.sort_by(|a, b| margin(b).total_cmp(&margin(a)));
        }
        Ranking::Singularity => {
            // A chain that no solver takes has no solutions to sort.
            let Ok(arm) = Arm::new(chain) else { return };
            let regular = |solution: &Solution| curve::tangent(&arm, &solution.q).1;
            solutions.sort_by(|a, b| regular(b).total_cmp(&regular(a)));
        }
    }
}
