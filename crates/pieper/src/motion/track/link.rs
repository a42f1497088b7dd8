//! Which solutions of one moment go on as which of the next.

use super::sample::{Node, Sample, Sampler};
use super::space::{Miss, add};
use crate::error::Result;
use crate::ik::JointVector;

/// Joints (rad, or extents) may change by this much between samples: far less than what lies between branches, but
/// for those about to meet.
const STRIDE: f64 = 0.35;

/// Where a motion between two samples is compared with the path.
const SHARES: [f64; 3] = [0.25, 0.5, 0.75];

/// Samples are set until the joints' straight motion between them follows the path to this part of the tolerance, so
/// that rates come out smooth.
const FINE: f64 = 0.02;

/// The same where a solution that stands alone goes on as a member of a set, or comes from one: a finer part of the path
/// would tell the member better, a coarser one might miss that the way through the set is smooth.
const FINE_TO_SET: f64 = 0.125;

/// A correction of joint values this large, as part of the joints' change, is no bend of a smooth motion.
const ROUGH: f64 = 0.5;

/// A solution that goes on as another: indices of nodes of two samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Link {
    pub(super) from: u8,
    pub(super) to: u8,
}

/// A link with its samples. Where an interval was halved for the sake of other branches, it spans more than one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Span {
    pub(super) samples: [usize; 2],
    pub(super) link: Link,
}

impl Span {
    /// Sample and node at its end.
    pub(super) fn to(&self) -> (usize, usize) {
        (self.samples[1], usize::from(self.link.to))
    }

    /// Sample and node at its start.
    pub(super) fn from(&self) -> (usize, usize) {
        (self.samples[0], usize::from(self.link.from))
    }
}

/// How well a straight motion of the joints between two samples follows the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quality {
    /// So well that the samples are dense enough.
    Fine,
    /// Within the tolerance, and more samples would not help: the path passes a singularity closer than the tolerance.
    Passes,
    /// Not well enough, or not proved.
    Unclear,
}

/// The links between two samples, and whether they leave nothing open.
pub(super) struct Linked {
    pub(super) links: Vec<Link>,
    pub(super) is_clear: bool,
}

impl Sampler<'_> {
    /// Links the solutions of two samples.
    pub(super) fn link(&self, a: &Sample, b: &Sample, tolerance: f64) -> Result<Linked> {
        let mut linked = Linked {
            links: Vec::new(),
            is_clear: true,
        };
        let [mut from, mut to] = [vec![false; a.nodes.len()], vec![false; b.nodes.len()]];
        for (distance, link) in self.pairs(a, b) {
            let (i, k) = (usize::from(link.from), usize::from(link.to));
            if distance > STRIDE || from[i] || to[k] {
                continue;
            }
            let (p, q) = (a.nodes[i].q, b.nodes[k].q);
            let q = self.space.beside(&p, &q);
            if self.quality(a, &p, b, &q, tolerance)? != Quality::Unclear {
                (from[i], to[k]) = (true, true);
                linked.links.push(link);
            }
        }
        self.link_sets(a, b, tolerance, &mut linked, (&mut from, &mut to))?;
        linked.is_clear = from.iter().chain(&to).all(|is_linked| *is_linked);
        Ok(linked)
    }

    /// Pairs of solutions that stand alone, the closest first.
    fn pairs(&self, a: &Sample, b: &Sample) -> Vec<(f64, Link)> {
        let alone = |nodes: &[Node]| -> Vec<usize> {
            (0..nodes.len())
                .filter(|&index| nodes[index].set.is_none())
                .collect()
        };
        let ends = alone(&b.nodes);
        let mut pairs = Vec::new();
        for from in alone(&a.nodes) {
            for &to in &ends {
                let way = self.space.way(&a.nodes[from].q, &b.nodes[to].q);
                let link = Link {
                    from: from as u8,
                    to: to as u8,
                };
                pairs.push((self.space.size(&way), link));
            }
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        pairs
    }

    /// Links sets with what has a member of theirs beside it.
    fn link_sets(
        &self,
        a: &Sample,
        b: &Sample,
        tolerance: f64,
        linked: &mut Linked,
        (from, to): (&mut [bool], &mut [bool]),
    ) -> Result<()> {
        for (i, one) in a.nodes.iter().enumerate() {
            for (k, other) in b.nodes.iter().enumerate() {
                let wanted = match (one.set.is_some(), other.set.is_some()) {
                    (false, false) => false,
                    (true, true) => true,
                    (true, false) => !to[k],
                    (false, true) => !from[i],
                };
                if wanted && self.sets_touch((a, one), (b, other), tolerance)? {
                    (from[i], to[k]) = (true, true);
                    linked.links.push(Link {
                        from: i as u8,
                        to: k as u8,
                    });
                }
            }
        }
        Ok(())
    }

    fn sets_touch(
        &self,
        (a, one): (&Sample, &Node),
        (b, other): (&Sample, &Node),
        tolerance: f64,
    ) -> Result<bool> {
        let allowed = match one.set.is_some() && other.set.is_some() {
            true => tolerance,
            false => FINE_TO_SET * tolerance,
        };
        // Of two sets either may be the one that tells where on the other to look.
        let mut starts = Vec::new();
        if let Some(p) = self.member(a, one, &other.q)? {
            starts.push((p, self.member(b, other, &p)?.unwrap_or(other.q)));
        }
        if let Some(q) = self.member(b, other, &one.q)? {
            starts.push((self.member(a, one, &q)?.unwrap_or(one.q), q));
        }
        for (p, q) in starts {
            let q = self.space.beside(&p, &q);
            let near = self.space.size(&self.space.way(&p, &q)) <= STRIDE;
            if near && self.largest_miss(a, &p, b, &q, allowed)?.within(allowed) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// How far the tool is off the path where all joints move straight from `p` to `q`; the search ends where it is
    /// more than `enough`.
    pub(super) fn largest_miss(
        &self,
        a: &Sample,
        p: &JointVector,
        b: &Sample,
        q: &JointVector,
        enough: f64,
    ) -> Result<Miss> {
        let way = self.space.way(p, q);
        let mut most = Miss::default();
        for share in SHARES {
            let pose = self.law.at(a.time + share * (b.time - a.time));
            most = most.max(self.space.miss(&add(p, &way, share), &pose)?);
            if !most.within(enough) {
                break;
            }
        }
        Ok(most)
    }

    fn quality(
        &self,
        a: &Sample,
        p: &JointVector,
        b: &Sample,
        q: &JointVector,
        tolerance: f64,
    ) -> Result<Quality> {
        let most = self.largest_miss(a, p, b, q, tolerance)?;
        if most.within(FINE * tolerance) {
            return Ok(Quality::Fine);
        }
        if !most.within(tolerance) {
            return Ok(Quality::Unclear);
        }
        // A bend is cured by more samples. Near a singularity the joints would have to turn far for a hair of a miss.
        let way = self.space.way(p, q);
        let middle = add(p, &way, 0.5);
        let pose = self.law.at(a.time + 0.5 * (b.time - a.time));
        let bend = match self.space.refine(&middle, &pose)? {
            Some(exact) => self.space.size(&self.space.way(&middle, &exact)),
            None => f64::INFINITY,
        };
        Ok(match bend > ROUGH * self.space.size(&way) {
            true => Quality::Passes,
            false => Quality::Unclear,
        })
    }
}
