//! Through sets of solutions: which member a motion passes through, and where the arm has to turn without its tool.

use std::f64::consts::TAU;

use super::grid::Grid;
use super::sample::{Node, Sample, Sampler};
use super::space::{add, dot, minus};
use crate::error::Result;
use crate::ik::JointVector;

/// Parts of a standing turn along a set that is no line.
const PARTS: usize = 16;

/// Members closer than this are the same, and no turn is needed: the direction in which a path leaves a set is known
/// from a sample nearby only.
const SAME: f64 = 1e-6;

/// A joint with a smaller share of a set's direction stands still in it.
const STILL: f64 = 1e-6;

/// A stretch of samples at each of which the motion is in a set.
pub(super) struct Stretch<'a> {
    /// Sample and node of each.
    pub(super) items: &'a [(usize, &'a Node)],
    /// Sample and joint values before, if there are any.
    pub(super) entry: Option<(usize, JointVector)>,
    /// A sample after, and a solution there, if there is one.
    pub(super) exit: Option<(usize, JointVector)>,
}

/// What a free start is nearest to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Home {
    pub(super) q: JointVector,
    /// Whether somebody asked for it; else it only decides between equals.
    pub(super) is_asked_for: bool,
}

/// The members for a stretch: `(sample, joint values)`, several for one sample where the arm turns there.
///
/// The joints' travel within the stretch (the sum of absolute values) is the least that leads from entry to exit; a free
/// start is, among those of least travel, the nearest to `home`. What has to be turned in addition is spread over
/// the time of the stretch; in a stretch of one moment, the arm stops and turns.
pub(super) fn pass(
    sampler: &Sampler<'_>,
    grid: &Grid,
    stretch: &Stretch<'_>,
    home: &Home,
    tolerance: f64,
) -> Result<Vec<(usize, JointVector)>> {
    let walk = Walk { sampler, grid };
    if let (&[item], Some(entry), Some(exit)) = (stretch.items, stretch.entry, stretch.exit)
        && let Some(member) = walk.smooth(item, &entry, &exit, tolerance)?
    {
        return Ok(vec![(item.0, member)]);
    }
    let last = stretch.items[stretch.items.len() - 1];
    let leaving = match stretch.exit {
        Some((_, exit)) => Some(walk.member(last, &exit)?),
        None => None,
    };
    let (mut line, shift, total) = match (stretch.entry, leaving) {
        (Some((_, entry)), Some(leaving)) => {
            let line = walk.along(stretch.items, &entry)?;
            let end = line[line.len() - 1];
            let gap = gap(sampler, last.1, &end, &leaving);
            (line, 0.0, gap)
        }
        (None, Some(leaving)) => {
            let backwards: Vec<_> = stretch.items.iter().rev().copied().collect();
            let mut line = walk.along(&backwards, &leaving)?;
            line.reverse();
            let first = stretch.items[0];
            let wanted = walk.member(first, &home.q)?;
            let shift = gap(sampler, first.1, &line[0], &wanted);
            let steps = walk.steps(stretch.items, &line);
            let [low, high] = [0, 1].map(|k| steps.iter().map(|step| step.flat[k]).sum::<f64>());
            let shift = match home.is_asked_for {
                true => shift,
                false => shift.clamp(-high, -low),
            };
            (line, shift, -shift)
        }
        (Some((_, start)), None) => (walk.along(stretch.items, &start)?, 0.0, 0.0),
        (None, None) => (walk.along(stretch.items, &home.q)?, 0.0, 0.0),
    };
    if shift != 0.0 || total != 0.0 {
        walk.spread(stretch.items, &mut line, shift, total)?;
    }
    let mut out: Vec<_> = stretch.items.iter().map(|item| item.0).zip(line).collect();
    if let (Some(leaving), Some(&(sample, q))) = (leaving, out.last()) {
        let goal = add(&q, &around(sampler, last.1, &q, &leaving), 1.0);
        if sampler.space.size(&minus(&goal, &q)) > SAME {
            walk.turn(sample, last, &q, &goal, &mut out)?;
        }
    }
    Ok(out)
}

/// The way within a set from a member to another: of the copies by whole turns the one that the set leads to.
fn around(sampler: &Sampler<'_>, node: &Node, from: &JointVector, to: &JointVector) -> JointVector {
    let way = sampler.space.way(from, to);
    let Some(set) = &node.set else { return way };
    let moving: Vec<usize> = (0..sampler.space.dof())
        .filter(|&j| sampler.space.angular[j] && set.free[j].abs() > STILL)
        .collect();
    let cost = |way: &JointVector| {
        let along = dot(&set.free, way);
        let off = add(way, &set.free, -along);
        (dot(&off, &off).sqrt(), along.abs())
    };
    let mut best = way;
    if moving.len() > 3 {
        return best;
    }
    for code in 0..3_usize.pow(moving.len() as u32) {
        let mut copy = way;
        let mut rest = code;
        for &j in &moving {
            copy[j] += TAU * [0.0, 1.0, -1.0][rest % 3];
            rest /= 3;
        }
        let (given, least) = (cost(&copy), cost(&best));
        let nearer = given.0 < least.0 + STILL && given.1 < least.1 - STILL;
        if given.0 < least.0 - STILL || nearer {
            best = copy;
        }
    }
    best
}

/// How far along a set's direction another member lies.
fn gap(sampler: &Sampler<'_>, node: &Node, from: &JointVector, to: &JointVector) -> f64 {
    let way = around(sampler, node, from, to);
    node.set.as_ref().map_or(0.0, |set| dot(&set.free, &way))
}

/// A step of a stretch: how far along the set it may go without more travel than needed, and its duration.
struct Step {
    flat: [f64; 2],
    duration: f64,
}

struct Walk<'a, 'b> {
    sampler: &'a Sampler<'b>,
    grid: &'a Grid,
}

impl Walk<'_, '_> {
    fn sample(&self, index: usize) -> &Sample {
        &self.grid.samples[index]
    }

    fn member(&self, (sample, node): (usize, &Node), seed: &JointVector) -> Result<JointVector> {
        let member = self.sampler.member(self.sample(sample), node, seed)?;
        Ok(member.unwrap_or_else(|| self.sampler.space.beside(seed, &node.q)))
    }

    /// From set to set, each time to the nearest member.
    fn along(&self, items: &[(usize, &Node)], start: &JointVector) -> Result<Vec<JointVector>> {
        let (mut q, mut line) = (*start, Vec::with_capacity(items.len()));
        for &item in items {
            q = self.member(item, &q)?;
            line.push(q);
        }
        Ok(line)
    }

    /// The member of a single moment's set on the straight way from before to after, if the way is one.
    fn smooth(
        &self,
        (sample, node): (usize, &Node),
        (before, entry): &(usize, JointVector),
        (after, exit): &(usize, JointVector),
        tolerance: f64,
    ) -> Result<Option<JointVector>> {
        let (before, after) = (self.sample(*before), self.sample(*after));
        let here = self.sample(sample);
        let share = (here.time - before.time) / (after.time - before.time);
        let seed = add(entry, &self.sampler.space.way(entry, exit), share);
        let member = self.member((sample, node), &seed)?;
        let misses = [
            self.sampler
                .largest_miss(before, entry, here, &member, tolerance)?,
            self.sampler
                .largest_miss(here, &member, after, exit, tolerance)?,
        ];
        let passes = misses.iter().all(|miss| miss.within(tolerance));
        Ok(passes.then_some(member))
    }

    fn steps(&self, items: &[(usize, &Node)], line: &[JointVector]) -> Vec<Step> {
        let pairs = items.windows(2).zip(line.windows(2));
        let step = |(items, line): (&[(usize, &Node)], &[JointVector])| {
            let free = items[1].1.set.map(|set| set.free).unwrap_or_default();
            let free = aligned(&free, items[0].1);
            Step {
                flat: flat(&minus(&line[1], &line[0]), &free),
                duration: self.sample(items[1].0).time - self.sample(items[0].0).time,
            }
        };
        pairs.map(step).collect()
    }

    /// Shifts a line of members along their sets: by `shift` at the first, and by `total` more at the last.
    fn spread(
        &self,
        items: &[(usize, &Node)],
        line: &mut [JointVector],
        shift: f64,
        total: f64,
    ) -> Result<()> {
        let steps = self.steps(items, line);
        let parts = shares(&steps, total);
        let mut along = shift;
        let mut free = items[0].1.set.map(|set| set.free).unwrap_or_default();
        for (k, item) in items.iter().enumerate() {
            if let Some(before) = k.checked_sub(1) {
                along += parts[before];
                let next = item.1.set.map(|set| set.free).unwrap_or_default();
                free = if dot(&free, &next) < 0.0 {
                    next.map(|x| -x)
                } else {
                    next
                };
            }
            line[k] = self.member(*item, &add(&line[k], &free, along))?;
        }
        Ok(())
    }

    /// A standing turn, as members one after the other at one sample.
    fn turn(
        &self,
        sample: usize,
        item: (usize, &Node),
        from: &JointVector,
        to: &JointVector,
        out: &mut Vec<(usize, JointVector)>,
    ) -> Result<()> {
        let way = minus(to, from);
        for part in 1..PARTS {
            let seed = add(from, &way, part as f64 / PARTS as f64);
            out.push((sample, self.member(item, &seed)?));
        }
        out.push((sample, *to));
        Ok(())
    }
}

/// A direction, with the sign of a node's.
fn aligned(free: &JointVector, node: &Node) -> JointVector {
    match &node.set {
        Some(set) if dot(&set.free, free) < 0.0 => free.map(|x| -x),
        _ => *free,
    }
}

/// Where `sum |step_j + s free_j|` is least: an interval of s, the weighted medians of the places where a joint stands
/// still.
fn flat(step: &JointVector, free: &JointVector) -> [f64; 2] {
    let moving = step.iter().zip(free).filter(|(_, f)| f.abs() > STILL);
    let mut places: Vec<(f64, f64)> = moving.map(|(x, f)| (-x / f, f.abs())).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let half = 0.5 * places.iter().map(|place| place.1).sum::<f64>();
    let mut sum = 0.0;
    for (k, (place, weight)) in places.iter().enumerate() {
        sum += weight;
        if sum >= half - STILL {
            let next = match (sum - half).abs() <= STILL {
                true => places.get(k + 1).map_or(*place, |next| next.0),
                false => *place,
            };
            return [*place, next];
        }
    }
    [0.0; 2]
}

/// How far to go along the set in each step, so that it comes to `total`, with the least travel.
fn shares(steps: &[Step], total: f64) -> Vec<f64> {
    let least: Vec<f64> = steps
        .iter()
        .map(|step| 0.0_f64.clamp(step.flat[0], step.flat[1]))
        .collect();
    let open = total - least.iter().sum::<f64>();
    let side = usize::from(open > 0.0);
    let room: Vec<f64> = steps
        .iter()
        .zip(&least)
        .map(|(step, least)| step.flat[side] - least)
        .collect();
    let all: f64 = room.iter().sum();
    let open = if (open - all).abs() < SAME { all } else { open };
    let share = if all == 0.0 {
        0.0
    } else {
        (open / all).min(1.0)
    };
    let duration: f64 = steps.iter().map(|step| step.duration).sum();
    let excess = match duration > 0.0 {
        true => (open - share * all) / duration,
        false => 0.0,
    };
    let parts = steps.iter().zip(&least).zip(&room);
    parts
        .map(|((step, least), room)| least + share * room + excess * step.duration)
        .collect()
}
