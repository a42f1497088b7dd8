//! Strands: solutions that go on as one another without a choice.

use super::grid::Grid;
use super::sample::Node;

/// A chain of linked solutions over neighbouring samples: of such that stand alone, or of sets.
#[derive(Clone, Debug)]
pub(super) struct Strand {
    /// Index of its first sample.
    pub(super) first: usize,
    /// Its node in every sample from there on.
    pub(super) nodes: Vec<u8>,
    pub(super) is_set: bool,
    /// Strands that go on as this one.
    pub(super) before: Vec<usize>,
    /// Strands that this one goes on as.
    pub(super) after: Vec<usize>,
}

impl Strand {
    /// Index of its last sample.
    pub(super) fn last(&self) -> usize {
        self.first + self.nodes.len() - 1
    }

    /// Its node in a sample.
    pub(super) fn node<'a>(&self, grid: &'a Grid, sample: usize) -> &'a Node {
        let index = sample.clamp(self.first, self.last()) - self.first;
        &grid.samples[self.first + index].nodes[usize::from(self.nodes[index])]
    }
}

/// All strands, in the order in which they begin.
pub(super) fn strands(grid: &Grid) -> Vec<Strand> {
    let mut strands: Vec<Strand> = Vec::new();
    // For each node of the sample before, its strand.
    let mut owners: Vec<usize> = Vec::new();
    for (k, sample) in grid.samples.iter().enumerate() {
        let links = match k.checked_sub(1) {
            Some(before) => &grid.links[before][..],
            None => &[],
        };
        let count = |pick: &dyn Fn(&super::link::Link) -> bool| links.iter().filter(|l| pick(l)).count();
        let mut next = Vec::with_capacity(sample.nodes.len());
        for (index, node) in sample.nodes.iter().enumerate() {
            let coming: Vec<_> = links
                .iter()
                .filter(|link| usize::from(link.to) == index)
                .collect();
            let only = match coming[..] {
                [link] if count(&|other| other.from == link.from) == 1 => {
                    Some(owners[usize::from(link.from)])
                }
                _ => None,
            };
            match only.filter(|&owner| strands[owner].is_set == node.set.is_some()) {
                Some(owner) => {
                    strands[owner].nodes.push(index as u8);
                    next.push(owner);
                }
                None => {
                    let before = coming
                        .iter()
                        .map(|link| owners[usize::from(link.from)])
                        .collect();
                    next.push(strands.len());
                    strands.push(Strand {
                        first: k,
                        nodes: vec![index as u8],
                        is_set: node.set.is_some(),
                        before,
                        after: Vec::new(),
                    });
                }
            }
        }
        owners = next;
    }
    for index in 0..strands.len() {
        for before in strands[index].before.clone() {
            strands[before].after.push(index);
        }
    }
    strands
}
