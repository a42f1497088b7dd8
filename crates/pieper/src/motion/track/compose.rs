//! From strands to continuous motions of the joints.

use super::grid::Grid;
use super::sample::{Node, Sampler};
use super::standing::{self, Home, Stretch};
use super::strand::{Strand, node};
use crate::error::Result;
use crate::ik::{Branch, JointVector};

/// The most ways through singularities that are followed from one start.
const MOST_WAYS: usize = 32;

/// A moment of a motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot {
    pub(super) time: f64,
    pub(super) q: JointVector,
}

/// A continuous motion of the joints, as long as the strands go.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    /// The branch it starts in.
    pub(super) branch: Branch,
    /// In order of time; knots at one time are a standing turn.
    pub(super) knots: Vec<Knot>,
    /// Why it ends, unless it lives to the end of the path.
    pub(super) end: Ending,
}

/// Where a motion's last strand ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Ending {
    /// With the path.
    Alive,
    /// At a sample, as a strand.
    Strand {
        /// Index of the strand.
        strand: usize,
        /// Index of its last sample.
        sample: usize,
    },
    /// Continuation found nothing more.
    Lost,
}

/// Every motion from the first sample on, and those that begin later.
pub(super) fn motions(
    sampler: &Sampler<'_>,
    grid: &Grid,
    strands: &[Strand],
    home: &Home,
    tolerance: f64,
) -> Result<Vec<Motion>> {
    let composer = Composer {
        sampler,
        grid,
        strands,
        home,
        tolerance,
    };
    let mut motions = Vec::new();
    let mut used = vec![false; strands.len()];
    // Strands stand in the order in which they begin: whatever no motion goes through is a start of its own.
    for start in 0..strands.len() {
        if used[start] {
            continue;
        }
        for way in composer.ways(start)? {
            way.iter().for_each(|&strand| used[strand] = true);
            motions.push(composer.motion(&way)?);
        }
    }
    Ok(motions)
}

struct Composer<'a, 'b> {
    sampler: &'a Sampler<'b>,
    grid: &'a Grid,
    strands: &'a [Strand],
    home: &'a Home,
    tolerance: f64,
}

impl Composer<'_, '_> {
    /// Chains of strands from one of them on, as far as they go.
    fn ways(&self, start: usize) -> Result<Vec<Vec<usize>>> {
        let (mut ways, mut open) = (Vec::new(), vec![vec![start]]);
        while let Some(way) = open.pop() {
            let next = self.next(&way)?;
            if next.is_empty() || ways.len() + open.len() >= MOST_WAYS {
                ways.push(way);
                continue;
            }
            for &strand in next.iter().rev() {
                let mut longer = way.clone();
                longer.push(strand);
                open.push(longer);
            }
        }
        Ok(ways)
    }

    /// How a chain of strands may go on: smoothly if there is a smooth way, else with the smallest turns first.
    fn next(&self, way: &[usize]) -> Result<Vec<usize>> {
        let Some(&last) = way.last() else {
            return Ok(Vec::new());
        };
        let strand = &self.strands[last];
        let before = way.len().checked_sub(2).map(|k| &self.strands[way[k]]);
        let Some(before) = before.filter(|before| strand.is_set && !before.is_set) else {
            return Ok(strand.after.clone());
        };
        let entry = (before.last(), before.end(self.grid).q);
        let mut smooth = Vec::new();
        let mut turns = Vec::new();
        for &next in &strand.after {
            let after = &self.strands[next];
            if after.is_set {
                turns.push((0.0, next));
                continue;
            }
            let exit = (after.first(), after.start(self.grid).q);
            let items = self.items(strand);
            let stretch = Stretch {
                items: &items,
                entry: Some(entry),
                exit: Some(exit),
            };
            let passed =
                standing::pass(self.sampler, self.grid, &stretch, self.home, self.tolerance)?;
            match passed.len() == items.len() {
                true => smooth.push(next),
                false => {
                    let (from, to) = (passed[items.len() - 1].1, passed[passed.len() - 1].1);
                    let way = super::space::minus(&to, &from);
                    turns.push((self.sampler.space.size(&way), next));
                }
            }
        }
        // A smooth way of one moment is the only one that a motion through it needs.
        if !smooth.is_empty() && strand.places.len() == 1 {
            return Ok(smooth);
        }
        turns.sort_by(|a, b| a.0.total_cmp(&b.0));
        smooth.extend(turns.iter().map(|turn| turn.1));
        Ok(smooth)
    }

    fn items(&self, strand: &Strand) -> Vec<(usize, &Node)> {
        let places = strand.places.iter();
        places
            .map(|&place| (place.0, node(self.grid, place)))
            .collect()
    }

    fn motion(&self, way: &[usize]) -> Result<Motion> {
        let items: Vec<(usize, &Node)> = way
            .iter()
            .flat_map(|&strand| self.items(&self.strands[strand]))
            .collect();
        let mut knots: Vec<Knot> = Vec::with_capacity(items.len());
        let mut at: usize = 0;
        while at < items.len() {
            let (sample, node) = items[at];
            let before = knots.last().map(|knot| knot.q);
            if node.set.is_none() {
                let q = before.map_or(node.q, |q| self.sampler.space.beside(&q, &node.q));
                let time = self.grid.samples[sample].time;
                knots.push(Knot { time, q });
                at += 1;
                continue;
            }
            let length = items[at..].iter().take_while(|item| item.1.set.is_some());
            let end = at + length.count();
            let stretch = Stretch {
                items: &items[at..end],
                entry: at.checked_sub(1).map(|k| items[k].0).zip(before),
                exit: items.get(end).map(|item| (item.0, item.1.q)),
            };
            let passed =
                standing::pass(self.sampler, self.grid, &stretch, self.home, self.tolerance)?;
            knots.extend(passed.iter().map(|&(sample, q)| Knot {
                time: self.grid.samples[sample].time,
                q,
            }));
            at = end;
        }
        let strand = way[way.len() - 1];
        let sample = self.strands[strand].last();
        let end = match sample + 1 == self.grid.samples.len() {
            true => Ending::Alive,
            false => Ending::Strand { strand, sample },
        };
        Ok(Motion {
            branch: items[0].1.branch,
            knots,
            end,
        })
    }
}
