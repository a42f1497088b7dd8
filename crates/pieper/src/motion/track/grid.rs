//! The path, cut into intervals so short that nothing is left open between their ends.

use super::link::{Link, Span};
use super::sample::{Sample, Sampler};
use crate::error::{Error, Result};

/// The tool moves or turns by this much (extents, rad) between first samples.
const FIRST_STRIDE: f64 = 0.1;

/// Intervals are halved down to this part of the path's duration: what happens within is said to happen at once.
const SHORTEST: f64 = 1e-10;

/// Of a double's digits, time must keep so many units in the last place within the shortest interval.
const ULPS: f64 = 16.0;

/// How many poses are solved within one first interval before what is still open there is given up. A clean end of a
/// branch takes some thirty, a wrist that whirls past a singularity some hundred.
const MOST_WITHIN: usize = 3000;

/// Where a sample falls into a singularity by chance, it is moved by these parts of the interval.
const ASIDE: [f64; 2] = [0.0367, -0.0823];

/// Samples along a path and the links between them.
#[derive(Debug, Default)]
pub(super) struct Grid {
    pub(super) samples: Vec<Sample>,
    /// By their ends. A solution that stands alone has at most one to each side.
    pub(super) links: Vec<Span>,
}

/// Samples a path. `progress` is told the share that is done.
pub(super) fn sample(
    sampler: &mut Sampler<'_>,
    tolerance: f64,
    budget: usize,
    progress: &mut dyn FnMut(f64),
) -> Result<Grid> {
    let times = first_times(sampler, budget)?;
    let (start, end) = (times[0], times[times.len() - 1]);
    let size = start.abs().max(end.abs());
    let shortest = (SHORTEST * (end - start)).max(ULPS * f64::EPSILON * size);
    let mut grid = Grid::default();
    // By the times of the samples: the places of samples are known in the end only.
    let mut found: Vec<([f64; 2], Vec<Link>)> = Vec::new();
    grid.samples.push(sampler.at(start)?);
    for pair in times.windows(2) {
        progress((pair[0] - start) / (end - start));
        let allowed = sampler.solves + MOST_WITHIN;
        let mut ahead = vec![first(sampler, pair)?];
        while let Some(next) = ahead.pop() {
            let Some(last) = grid.samples.last() else {
                break;
            };
            let linked = sampler.link(last, &next, tolerance)?;
            let length = next.time - last.time;
            found.push(([last.time, next.time], linked.links));
            if linked.is_clear || length <= 2.0 * shortest || sampler.solves >= allowed {
                grid.samples.push(next);
                continue;
            }
            if sampler.solves >= budget {
                return Err(too_many(budget, last.time));
            }
            let middle = between(sampler, last.time, next.time)?;
            ahead.extend([next, middle]);
        }
    }
    progress(1.0);
    grid.links = chosen(&grid.samples, &found);
    Ok(grid)
}

/// The links that count: what was clear for an interval stays so when it is halved for other branches, so the longest
/// come first.
fn chosen(samples: &[Sample], found: &[([f64; 2], Vec<Link>)]) -> Vec<Span> {
    let place = |time: f64| samples.partition_point(|sample| sample.time < time);
    let mut spans = Vec::new();
    for ([from, to], links) in found {
        let samples = [place(*from), place(*to)];
        spans.extend(links.iter().map(|&link| Span { samples, link }));
    }
    // Stable: of equal length, those found first.
    spans.sort_by_key(|span| std::cmp::Reverse(span.samples[1] - span.samples[0]));
    let taken = || -> Vec<Vec<bool>> {
        let nodes = samples.iter().map(|sample| vec![false; sample.nodes.len()]);
        nodes.collect()
    };
    let [mut leaves, mut comes] = [taken(), taken()];
    let is_set = |(sample, node): (usize, usize)| samples[sample].nodes[node].set.is_some();
    spans.retain(|span| {
        let (from, to) = (span.from(), span.to());
        let is_free =
            (is_set(from) || !leaves[from.0][from.1]) && (is_set(to) || !comes[to.0][to.1]);
        if is_free {
            (leaves[from.0][from.1], comes[to.0][to.1]) = (true, true);
        }
        is_free
    });
    spans.sort_by_key(|span| (span.to(), span.from()));
    spans
}

#[cold]
fn too_many(budget: usize, time: f64) -> Error {
    Error::input(
        format!("the path at t = {time} s"),
        format!(
            "its refinement stopped here after {budget} poses: a larger tolerance, fewer rows or a shorter path was expected"
        ),
    )
}

/// The sample at the end of a first interval: at a row exactly, elsewhere off singularities.
fn first(sampler: &mut Sampler<'_>, pair: &[f64]) -> Result<Sample> {
    let (from, to) = (pair[0], pair[1]);
    let rows = sampler.law.times();
    let row = rows.partition_point(|&row| row < to);
    match rows.get(row) == Some(&to) {
        true => sampler.at(to),
        false => beside(sampler, to, to - from),
    }
}

/// A sample within an interval.
fn between(sampler: &mut Sampler<'_>, from: f64, to: f64) -> Result<Sample> {
    beside(sampler, from + 0.5 * (to - from), to - from)
}

/// A sample at a time or nearly, off any singularity that only the exact time meets.
fn beside(sampler: &mut Sampler<'_>, time: f64, length: f64) -> Result<Sample> {
    let sample = sampler.at(time)?;
    if !sample.has_sets() {
        return Ok(sample);
    }
    for aside in ASIDE {
        let beside = sampler.at(time + aside * length)?;
        if !beside.has_sets() {
            return Ok(beside);
        }
    }
    Ok(sample)
}

/// The rows' times, and times between them where the tool moves far.
fn first_times(sampler: &Sampler<'_>, budget: usize) -> Result<Vec<f64>> {
    let (law, extent) = (sampler.law, sampler.space.extent);
    let rows = law.times();
    let mut times = vec![rows[0]];
    for row in 1..rows.len() {
        let (way, turn) = law.step(row - 1);
        let parts = (law.profile().peak_rate() * (way / extent).max(turn) / FIRST_STRIDE).ceil();
        if times.len() as f64 + parts > budget as f64 {
            return Err(too_many(budget, rows[row - 1]));
        }
        let (start, span) = (rows[row - 1], rows[row] - rows[row - 1]);
        let parts = parts as usize;
        times.extend((1..parts).map(|k| start + span * k as f64 / parts as f64));
        times.push(rows[row]);
    }
    times.dedup();
    Ok(times)
}
