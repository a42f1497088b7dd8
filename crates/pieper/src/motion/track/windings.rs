//! Whole turns of the joints, and where a motion leaves their limits.

use std::f64::consts::TAU;

use super::compose::Knot;
use super::space::{Space, add, minus};
use crate::ik::{JointVector, MAX_JOINTS, TOLERANCES};
use crate::model::Limits;

/// Turns further off are not looked at: limits of a million turns mean none.
const MOST_TURNS: f64 = 64.0;

/// A part of a motion that keeps all limits.
pub(super) struct Piece {
    pub(super) knots: Vec<Knot>,
    /// The limit at which it ends, unless the motion itself ends.
    pub(super) stop: Option<Stop>,
}

/// A joint at its limit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    pub(super) joint: usize,
    pub(super) limit: f64,
    pub(super) time: f64,
}

/// Cuts a motion into parts within the limits. Each joint starts with the number of whole turns that keeps its limits
/// longest; of equals, with the one nearest to `home`.
pub(super) fn pieces(space: &Space<'_>, knots: &[Knot], home: &JointVector) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while at < knots.len() {
        let Some((turns, end, joint)) = longest(space, knots, at, home) else {
            at += 1;
            continue;
        };
        let turned = |knot: &Knot| Knot {
            q: add(&knot.q, &turns, 1.0),
            ..*knot
        };
        let mut inside = before(space, knots, at, &turned);
        inside.extend(knots[at..end].iter().map(turned));
        let stop = joint.map(|joint| {
            let (last, next) = (inside[inside.len() - 1], turned(&knots[end]));
            let knot = crossing(space, joint, &last, &next);
            let limits = space.chain.variables()[joint].limits;
            let limit = limits.map_or(knot.q[joint], |limits| nearest(limits, next.q[joint]));
            if knot.time > last.time {
                inside.push(knot);
            }
            Stop {
                joint,
                limit,
                time: knot.time,
            }
        });
        pieces.push(Piece {
            knots: inside,
            stop,
        });
        at = end.max(at + 1);
    }
    pieces
}

/// How far a part of a motion that is within limits from knot `at` on reaches back: its knots, from where it enters.
fn before(
    space: &Space<'_>,
    knots: &[Knot],
    at: usize,
    turned: &impl Fn(&Knot) -> Knot,
) -> Vec<Knot> {
    let variables = space.chain.variables();
    let outside = |knot: &Knot| -> Vec<usize> {
        let is_out = |j: &usize| {
            variables[*j]
                .limits
                .is_some_and(|limits| !within(limits, knot.q[*j]))
        };
        (0..space.dof()).filter(is_out).collect()
    };
    let mut entry = Vec::new();
    for index in (0..at).rev() {
        let knot = turned(&knots[index]);
        let out = outside(&knot);
        if out.is_empty() {
            entry.push(knot);
            continue;
        }
        let inside = entry.last().copied().unwrap_or_else(|| turned(&knots[at]));
        let crossings = out
            .iter()
            .map(|&joint| crossing(space, joint, &inside, &knot));
        let latest = crossings.max_by(|a, b| a.time.total_cmp(&b.time));
        entry.extend(latest.filter(|knot| knot.time < inside.time));
        break;
    }
    entry.reverse();
    entry
}

/// From knot `at`: the turns to add, the first knot outside, and the joint that is.
fn longest(
    space: &Space<'_>,
    knots: &[Knot],
    at: usize,
    home: &JointVector,
) -> Option<(JointVector, usize, Option<usize>)> {
    let mut turns = [0.0; MAX_JOINTS];
    let (mut end, mut joint) = (knots.len(), None);
    for j in 0..space.dof() {
        let value = knots[at].q[j];
        let nearest = TAU * ((home[j] - value) / TAU).round();
        let Some(limits) = space.chain.variables()[j].limits else {
            turns[j] = if space.angular[j] { nearest } else { 0.0 };
            continue;
        };
        let mut best: Option<(usize, f64)> = None;
        for shift in shifts(space.angular[j], limits, value) {
            let outside = knots[at..]
                .iter()
                .position(|knot| !within(limits, knot.q[j] + shift));
            let outside = outside.map_or(knots.len(), |k| at + k);
            let better = best.is_none_or(|(longest, kept)| {
                outside > longest
                    || (outside == longest && (shift - nearest).abs() < (kept - nearest).abs())
            });
            if outside > at && better {
                best = Some((outside, shift));
            }
        }
        let (outside, shift) = best?;
        turns[j] = shift;
        if outside < end {
            (end, joint) = (outside, Some(j));
        }
    }
    Some((turns, end, joint))
}

/// The whole turns that may bring a value within limits.
fn shifts(angular: bool, limits: Limits, value: f64) -> Vec<f64> {
    if !angular {
        return vec![0.0];
    }
    let slack = TOLERANCES.limit;
    let first = ((limits.lower() - slack - value) / TAU)
        .ceil()
        .max(-MOST_TURNS) as i64;
    let last = ((limits.upper() + slack - value) / TAU)
        .floor()
        .min(MOST_TURNS) as i64;
    (first..=last).map(|turn| turn as f64 * TAU).collect()
}

/// Joint values shifted by whole turns to where they are closest to `near` within the limits; `None` if a joint has no
/// turn that keeps them.
pub(super) fn beside(
    space: &Space<'_>,
    q: &JointVector,
    near: &JointVector,
) -> Option<JointVector> {
    let mut out = space.beside(near, q);
    for j in 0..space.dof() {
        let Some(limits) = space.chain.variables()[j].limits else {
            continue;
        };
        let turns = shifts(space.angular[j], limits, q[j]);
        let copies = turns
            .iter()
            .map(|shift| q[j] + shift)
            .filter(|&value| within(limits, value));
        out[j] = copies.min_by(|a, b| (a - near[j]).abs().total_cmp(&(b - near[j]).abs()))?;
    }
    Some(out)
}

fn within(limits: Limits, value: f64) -> bool {
    let slack = TOLERANCES.limit;
    limits.lower() - slack <= value && value <= limits.upper() + slack
}

fn nearest(limits: Limits, value: f64) -> f64 {
    value.clamp(limits.lower(), limits.upper())
}

/// Where a joint meets its limit between two knots.
fn crossing(space: &Space<'_>, joint: usize, last: &Knot, next: &Knot) -> Knot {
    let limits = space.chain.variables()[joint].limits;
    let way = minus(&next.q, &last.q);
    let share = match limits {
        Some(limits) if way[joint] != 0.0 => {
            (nearest(limits, next.q[joint]) - last.q[joint]) / way[joint]
        }
        _ => 0.0,
    };
    let share = share.clamp(0.0, 1.0);
    Knot {
        time: last.time + share * (next.time - last.time),
        q: add(&last.q, &way, share),
    }
}

/// Which joint keeps no limits at a knot, whatever its whole turns, with its value and the limit nearest to it.
pub(super) fn outside(space: &Space<'_>, q: &JointVector) -> Option<(usize, f64, f64)> {
    (0..space.dof()).find_map(|j| {
        let limits = space.chain.variables()[j].limits?;
        let is_inside = shifts(space.angular[j], limits, q[j])
            .iter()
            .any(|shift| within(limits, q[j] + shift));
        (!is_inside).then(|| (j, q[j], nearest(limits, q[j])))
    })
}
