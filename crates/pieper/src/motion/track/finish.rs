//! Fewer knots, and how well what is left follows the path.

use super::compose::Knot;
use super::space::{Miss, Space, add, minus};
use crate::error::Result;
use crate::motion::PoseLaw;

/// Knots are left out where the joints' straight motion follows the path to this part of the tolerance without them.
const FINE: f64 = 0.05;

/// At most so many neighbouring knots are left out.
const MOST: usize = 64;

/// Where between two knots the motion is compared with the path.
const BETWEEN: usize = 8;

/// Joint rates count relative to the joints' limits; where there are none, to these (rad/s, m/s).
const USUAL_TURNING: f64 = std::f64::consts::PI;
const USUAL_SLIDING: f64 = 1.0;

/// Leaves out knots that a straight motion does not need; rows of the path stay.
pub(super) fn thinned(
    space: &Space<'_>,
    law: &PoseLaw,
    knots: &[Knot],
    tolerance: f64,
) -> Result<Vec<Knot>> {
    let mut kept: Vec<Knot> = knots.first().copied().into_iter().collect();
    let mut from = 0;
    while from + 1 < knots.len() {
        let (mut to, mut tried) = (from + 1, from + 2);
        while tried < knots.len() && tried - from <= MOST && may_skip(law, knots, tried - 1) {
            if !follows(space, law, &knots[from..=tried], FINE * tolerance)? {
                break;
            }
            to = tried;
            tried += 1;
        }
        kept.push(knots[to]);
        from = to;
    }
    Ok(kept)
}

/// Whether a knot is no row of the path and no part of a standing turn.
fn may_skip(law: &PoseLaw, knots: &[Knot], index: usize) -> bool {
    let time = knots[index].time;
    let stands = |k: Option<&Knot>| k.is_some_and(|knot| knot.time == time);
    let row = law.times().partition_point(|&row| row < time);
    law.times().get(row) != Some(&time)
        && !stands(knots.get(index + 1))
        && !stands(index.checked_sub(1).and_then(|k| knots.get(k)))
}

/// Whether a straight motion from the first of some knots to the last follows the path as well.
fn follows(space: &Space<'_>, law: &PoseLaw, knots: &[Knot], tolerance: f64) -> Result<bool> {
    let (first, last) = (knots[0], knots[knots.len() - 1]);
    let way = minus(&last.q, &first.q);
    // The knots between, and places between the knots at the ends, where few knots would hide a bend.
    let duration = last.time - first.time;
    let inner = knots[1..knots.len() - 1].iter().map(|knot| knot.time);
    let regular = [0.25, 0.5, 0.75].map(|share| first.time + share * duration);
    for time in inner.chain(regular) {
        let q = add(&first.q, &way, (time - first.time) / duration);
        if !space.miss(&q, &law.at(time))?.within(tolerance) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The most that a motion misses the path by, and when.
pub(super) fn deviation(space: &Space<'_>, law: &PoseLaw, knots: &[Knot]) -> Result<(Miss, f64)> {
    let (mut most, mut when) = (Miss::default(), knots.first().map_or(0.0, |knot| knot.time));
    let mut look = |time: f64, q: &crate::ik::JointVector| -> Result<()> {
        let miss = space.miss(q, &law.at(time))?;
        if miss.position > most.position || miss.angle > most.angle {
            when = time;
        }
        most = most.max(miss);
        Ok(())
    };
    for pair in knots.windows(2) {
        let way = minus(&pair[1].q, &pair[0].q);
        for k in 0..BETWEEN {
            let share = k as f64 / BETWEEN as f64;
            let time = pair[0].time + share * (pair[1].time - pair[0].time);
            look(time, &add(&pair[0].q, &way, share))?;
        }
    }
    if let Some(last) = knots.last() {
        look(last.time, &last.q)?;
    }
    Ok((most, when))
}

/// The largest rate of a joint relative to its limit, and the sum of all joints' travel (rad, or extents).
pub(super) fn effort(space: &Space<'_>, knots: &[Knot]) -> (f64, f64) {
    let (mut fastest, mut travel) = (0.0_f64, 0.0);
    for pair in knots.windows(2) {
        let way = minus(&pair[1].q, &pair[0].q);
        let duration = pair[1].time - pair[0].time;
        for (j, &angular) in space.angular.iter().enumerate() {
            travel += way[j].abs() / if angular { 1.0 } else { space.extent };
            if duration > 0.0 {
                fastest = fastest.max(way[j].abs() / duration / speed(space, j));
            }
        }
    }
    (fastest, travel)
}

/// The rate a joint is measured by.
pub(super) fn speed(space: &Space<'_>, joint: usize) -> f64 {
    let usual = match space.angular[joint] {
        true => USUAL_TURNING,
        false => USUAL_SLIDING,
    };
    let limit = space.chain.variables()[joint].velocity;
    limit.filter(|limit| *limit > 0.0).unwrap_or(usual)
}
