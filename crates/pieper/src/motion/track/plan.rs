//! Where no motion lives through the whole path: the fewest motions that cover it, one after the other.

use super::sample::Sampler;
use super::space::{Space, minus};
use super::{End, Event, Track, Tracks};
use crate::error::Result;
use crate::ik::Shortfall;

/// Times closer than this part of the path's duration are the same.
const SAME: f64 = 1e-8;

/// Moments of a gap at which the failure is measured.
const LOOKS: usize = 65;

/// A part of the path that a motion covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Index of the motion.
    pub track: usize,
    /// From this time.
    pub from: f64,
    /// To this time.
    pub to: f64,
}

/// A change from one motion to the next: the tool leaves its path, and comes back to where it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Switch {
    /// When, in seconds.
    pub time: f64,
    /// By how much each joint turns or slides.
    pub travel: Vec<f64>,
}

/// A part of the path for which there are no joint values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// From this time.
    pub from: f64,
    /// To this time.
    pub to: f64,
    /// The largest failure found there; `None` if solutions exist, but none within the joints' limits.
    pub worst: Option<Shortfall>,
}

/// Fills legs, switches and gaps: the fewest legs, of equal ones those of least effort, with switches where the
/// joints have least to turn.
pub(super) fn plan(sampler: &mut Sampler<'_>, out: &mut Tracks) -> Result<()> {
    let times = sampler.law.times();
    let (start, end) = (times[0], times[times.len() - 1]);
    let same = SAME * (end - start);
    let mut at = start;
    loop {
        match longest(&out.tracks, at, same) {
            Some(track) => {
                let to = out.tracks[track].to();
                out.legs.push(Leg {
                    track,
                    from: at.max(out.tracks[track].from()),
                    to,
                });
                at = to;
            }
            None => {
                let later = out.tracks.iter().filter(|track| is_motion(track));
                let next = later
                    .map(Track::from)
                    .filter(|&from| from > at + same)
                    .fold(end, f64::min);
                let worst = worst(sampler, at, next)?;
                out.gaps.push(Gap {
                    from: at,
                    to: next,
                    worst,
                });
                at = next;
            }
        }
        if at >= end - same {
            break;
        }
    }
    switches(sampler.space, out, same);
    Ok(())
}

fn is_motion(track: &Track) -> bool {
    let outside = |event: &Event| matches!(event, Event::Outside { .. });
    !matches!(&track.end, End::Dies { event, .. } if outside(event))
}

/// Of the motions that are there at a time, the one that lives longest beyond it.
fn longest(tracks: &[Track], at: f64, same: f64) -> Option<usize> {
    let there = (0..tracks.len()).filter(|&k| {
        let track = &tracks[k];
        is_motion(track) && track.from() <= at + same && track.to() > at + same
    });
    there.fold(None, |best: Option<usize>, k| {
        let Some(kept) = best else { return Some(k) };
        let (a, b) = (&tracks[k], &tracks[kept]);
        let better = match (a.to() - b.to()).abs() > same {
            true => a.to() > b.to(),
            false => (a.stops.len(), a.rate, a.travel) < (b.stops.len(), b.rate, b.travel),
        };
        Some(if better { k } else { kept })
    })
}

/// The largest failure between two times.
fn worst(sampler: &mut Sampler<'_>, from: f64, to: f64) -> Result<Option<Shortfall>> {
    let mut worst: Option<Shortfall> = None;
    for k in 0..LOOKS {
        let share = (k as f64 + 0.5) / LOOKS as f64;
        let found = sampler.at(from + share * (to - from))?.shortfall;
        worst = match (worst, found) {
            (Some(kept), Some(next)) if next.amount > kept.amount => Some(next),
            (None, next) => next,
            (kept, _) => kept,
        };
    }
    Ok(worst)
}

/// Moves the ends of neighbouring legs to where the change is smallest.
fn switches(space: &Space<'_>, out: &mut Tracks, same: f64) {
    for k in 1..out.legs.len() {
        let (before, after) = (out.legs[k - 1], out.legs[k]);
        if after.from > before.to + same {
            continue;
        }
        let (a, b) = (&out.tracks[before.track], &out.tracks[after.track]);
        let [low, high] = [b.from().max(before.from), before.to.min(b.to())];
        let inner = a.times.iter().copied().filter(|t| (low..=high).contains(t));
        let way = |t: f64| minus(&space.vector(&b.at(t)), &space.vector(&a.at(t)));
        let mut best = (high, space.size(&way(high)));
        for time in inner.chain([low]) {
            let size = space.size(&way(time));
            if size < best.1 {
                best = (time, size);
            }
        }
        out.switches.push(Switch {
            time: best.0,
            travel: way(best.0)[..space.dof()].to_vec(),
        });
        (out.legs[k - 1].to, out.legs[k].from) = (best.0, best.0);
    }
}
