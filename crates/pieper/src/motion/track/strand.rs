//! Strands: solutions that go on as one another without a choice.

use super::grid::Grid;
use super::sample::Node;

/// A chain of linked solutions: of such that stand alone, or of sets.
#[derive(Clone, Debug)]
pub(super) struct Strand {
    /// Sample and node of each, in order of time.
    pub(super) places: Vec<(usize, usize)>,
    pub(super) is_set: bool,
    /// Strands that go on as this one.
    pub(super) before: Vec<usize>,
    /// Strands that this one goes on as.
    pub(super) after: Vec<usize>,
}

impl Strand {
    /// Index of its first sample.
    pub(super) fn first(&self) -> usize {
        self.places[0].0
    }

    /// Index of its last sample.
    pub(super) fn last(&self) -> usize {
        self.places[self.places.len() - 1].0
    }

    /// Its node in its first sample.
    pub(super) fn start<'a>(&self, grid: &'a Grid) -> &'a Node {
        node(grid, self.places[0])
    }

    /// Its node in its last sample.
    pub(super) fn end<'a>(&self, grid: &'a Grid) -> &'a Node {
        node(grid, self.places[self.places.len() - 1])
    }
}

pub(super) fn node(grid: &Grid, (sample, node): (usize, usize)) -> &Node {
    &grid.samples[sample].nodes[node]
}

/// All strands, in the order in which they begin.
pub(super) fn strands(grid: &Grid) -> Vec<Strand> {
    let mut strands: Vec<Strand> = Vec::new();
    let none = |_: &_| usize::MAX;
    // For each node of each sample, its strand.
    let mut owners: Vec<Vec<usize>> = grid
        .samples
        .iter()
        .map(|sample| sample.nodes.iter().map(none).collect())
        .collect();
    let leaving = leaving(grid);
    for sample in 0..grid.samples.len() {
        for index in 0..grid.samples[sample].nodes.len() {
            let place = (sample, index);
            let low = grid.links.partition_point(|span| span.to() < place);
            let high = grid.links.partition_point(|span| span.to() <= place);
            let coming = &grid.links[low..high];
            let is_set = node(grid, place).set.is_some();
            let owner = |(sample, node): (usize, usize)| owners[sample][node];
            let only = match coming {
                [span] if leaving[span.from().0][span.from().1] == 1 => Some(owner(span.from())),
                _ => None,
            };
            let strand = match only.filter(|&owner| strands[owner].is_set == is_set) {
                Some(owner) => {
                    strands[owner].places.push(place);
                    owner
                }
                None => {
                    let before = coming.iter().map(|span| owner(span.from())).collect();
                    strands.push(Strand {
                        places: vec![place],
                        is_set,
                        before,
                        after: Vec::new(),
                    });
                    strands.len() - 1
                }
            };
            owners[sample][index] = strand;
        }
    }
    without_ghosts(grid, strands)
}

/// How many links leave each node.
fn leaving(grid: &Grid) -> Vec<Vec<usize>> {
    let nodes = grid.samples.iter();
    let mut counts: Vec<Vec<usize>> = nodes.map(|sample| vec![0; sample.nodes.len()]).collect();
    for span in &grid.links {
        counts[span.from().0][span.from().1] += 1;
    }
    counts
}

/// Leaves out strands that lie within a longer link: the link's own solutions between its ends, seen when its interval was
/// halved for others.
fn without_ghosts(grid: &Grid, strands: Vec<Strand>) -> Vec<Strand> {
    // For each sample, how far the links that begin before it reach.
    let mut reach = vec![0; grid.samples.len()];
    for span in &grid.links {
        let [from, to] = span.samples;
        for far in &mut reach[(from + 1).min(to)..to] {
            *far = to.max(*far);
        }
    }
    let is_ghost = |strand: &Strand| strand.last() < reach[strand.first()];
    let mut names = Vec::with_capacity(strands.len());
    let mut kept = 0;
    for strand in &strands {
        let name = (!is_ghost(strand)).then_some(kept);
        kept += usize::from(name.is_some());
        names.push(name);
    }
    let mut out = Vec::with_capacity(kept);
    for (strand, name) in strands.into_iter().zip(&names) {
        if let Some(name) = *name {
            let before: Vec<usize> = strand.before.iter().filter_map(|&old| names[old]).collect();
            for &before in &before {
                let earlier: &mut Strand = &mut out[before];
                earlier.after.push(name);
            }
            out.push(Strand { before, ..strand });
        }
    }
    out
}
