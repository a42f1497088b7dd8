//! Along families: members, the part within the limits, the member nearest to given joint values.

use super::curve::{self, Followed};
use super::descent::{ROUNDING, Room, damped};
use super::limits;
use super::numeric::start;
use super::solutions::{Family, JointVector};
use super::solver::Solver;
use crate::error::Result;
use crate::spatial::Pose;

/// A part of a family within the joints' limits: the joint values at its two ends.
///
/// What runs along a family is the length of the way in joint space; there is no other parameter that all families
/// have. A family that lies within the limits as a whole has one range, whose ends are the listed member.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// Joint values where it begins.
    pub from: Vec<f64>,
    /// Where it ends; in the direction of [`Family::free`] from there.
    pub to: Vec<f64>,
}

/// A family as a list of points, a stride apart at most.
struct Trace {
    points: Vec<JointVector>,
    closed: bool,
    /// The place of the listed member.
    member: usize,
}

/// Halvings that bring the end of a range to rounding.
const HALVINGS: usize = 45;

/// The most steps along a surface towards given joint values; each halves the way at least unless the surface bends.
const SURFACE_STEPS: usize = 40;

/// Starts tried for each member of a surface.
const STARTS: usize = 12;

impl Solver {
    /// `count` members of a family, spread evenly along it, the listed member first.
    ///
    /// With more than seven joints (free ones, and those that make up for an open goal) families are surfaces: members
    /// are then found by search from starts spread over the joints' ranges.
    pub fn samples(&self, family: &Family, count: usize) -> Vec<Vec<f64>> {
        if curve::is_surface(&self.arm, &family.at) {
            return self.spread(family, count, Room::Free);
        }
        let Trace {
            mut points,
            closed,
            member,
        } = self.trace(family);
        points.rotate_left(if closed { member } else { 0 });
        let steps = if closed {
            count
        } else {
            count.saturating_sub(1)
        };
        let pick = |k: usize| &points[k * (points.len() - 1) / steps.max(1)];
        let mut picked: Vec<&JointVector> = (0..count).map(pick).collect();
        if !closed && !picked.is_empty() {
            // The listed member takes the place of the one closest to it.
            let place = member * steps.max(1) / (points.len() - 1).max(1);
            picked.remove(place.min(count - 1));
            picked.insert(0, &family.at);
        }
        picked.into_iter().map(|q| self.shown(q)).collect()
    }

    /// Up to `count` members within the joints' limits, spread evenly over the family's [ranges](Self::ranges).
    pub fn samples_within(&self, family: &Family, count: usize) -> Vec<Vec<f64>> {
        if curve::is_surface(&self.arm, &family.at) {
            return self.spread(family, count, Room::Limits);
        }
        let pose = self.arm.pose(&family.at);
        let ways = self.ways(family);
        let total: f64 = ways.iter().map(|way| self.length(way)).sum();
        let mut out = Vec::new();
        for way in &ways {
            let share = (self.length(way) / total.max(f64::MIN_POSITIVE) * count as f64).round();
            let share = if total > 0.0 {
                (share as usize).max(1)
            } else {
                1
            };
            let step = self.length(way) / share as f64;
            let (mut passed, mut next) = (0.0, 0.5 * step);
            for pair in way.windows(2) {
                let gap = self.gap(&pair[0], &pair[1]);
                while next <= passed + gap && out.len() < count {
                    let part = (next - passed) / gap.max(f64::MIN_POSITIVE);
                    let q = self.between(&pair[0], &pair[1], part, &pose);
                    let q = q.filter(|q| limits::fits(self.arm.chain(), q));
                    out.extend(q.map(|q| self.within(&q)));
                    next += step;
                }
                passed += gap;
            }
            if way.len() == 1 && out.len() < count {
                out.push(self.within(&way[0]));
            }
        }
        out
    }

    /// The parts of a family that lie within the joints' limits, a turn by whole turns included.
    ///
    /// A part shorter than 0.2 (radians, or extents of the arm) along the family can be missed, and so can a gap. None for
    /// a family that is a surface.
    pub fn ranges(&self, family: &Family) -> Vec<Range> {
        if curve::is_surface(&self.arm, &family.at) {
            return Vec::new();
        }
        let range = |way: Vec<JointVector>| Range {
            from: self.within(&way[0]),
            to: self.within(&way[way.len() - 1]),
        };
        self.ways(family).into_iter().map(range).collect()
    }

    /// The same family, listed by a member within the joints' limits: the middle of its longest part there, or, on a
    /// surface, the first that a search finds. `None` if none is found.
    pub fn within_limits(&self, family: &Family) -> Option<Family> {
        let pose = self.arm.pose(&family.at);
        let mut at = if curve::is_surface(&self.arm, &family.at) {
            self.members(family, 1, Room::Limits).next()?
        } else {
            let ways = self.ways(family);
            let longest = ways
                .iter()
                .max_by(|a, b| self.length(a).total_cmp(&self.length(b)))?;
            longest[longest.len() / 2]
        };
        limits::bring(self.arm.chain(), &mut at);
        let heading = curve::heading(&self.arm, &at, &pose);
        let moved = Family {
            at,
            heading,
            ..*family
        };
        Some(self.view.family(&self.arm, &moved, &pose))
    }

    /// The member of a family that is closest to the joint values `seed`.
    ///
    /// # Errors
    /// An input error unless `seed` has one finite value for each variable.
    pub fn nearest_member(&self, family: &Family, seed: &[f64]) -> Result<Vec<f64>> {
        self.chain().check_joint_values(seed)?;
        let wanted = self.view.inward(seed);
        let pose = self.arm.pose(&family.at);
        if curve::is_surface(&self.arm, &family.at) {
            return Ok(self.shown(&self.nearest_on_surface(family, &wanted, &pose)));
        }
        // Joints that the caller does not have are where they are: no distance lies in them.
        let distance = |q: &JointVector| -> f64 {
            let step = self.view.difference(&self.arm, q, &wanted);
            step.iter().map(|x| x * x).sum()
        };
        let (mut best, mut least) = (family.at, f64::INFINITY);
        curve::follow(&self.arm, &family.at, &family.heading, &pose, |q, _| {
            if distance(q) < least {
                (best, least) = (*q, distance(q));
            }
            true
        });
        let free = self.view.free_joints();
        Ok(self.shown(&curve::closest(&self.arm, &best, &pose, &wanted, free)))
    }

    /// A member of a surface close to `wanted`: found from there, then moved along the surface while that helps.
    fn nearest_on_surface(
        &self,
        family: &Family,
        wanted: &JointVector,
        pose: &Pose,
    ) -> JointVector {
        let closes = |q: &JointVector| {
            let found = damped(&self.arm, q, pose, Room::Free, ROUNDING);
            (found.error < super::TOLERANCES.closes).then_some(found.q)
        };
        let distance = |q: &JointVector| {
            let step = self.view.difference(&self.arm, q, wanted);
            step.iter().map(|x| x * x).sum::<f64>()
        };
        let Some(mut best) = closes(wanted) else {
            return family.at;
        };
        for _ in 0..SURFACE_STEPS {
            let step = self.view.difference(&self.arm, &best, wanted);
            let step = curve::along(&self.arm, &best, &step, self.view.free_joints());
            let mut next = best;
            for (j, value) in next.iter_mut().enumerate().take(self.arm.chain().dof()) {
                *value += step[j] * self.arm.unit(j);
            }
            match closes(&next) {
                Some(next) if distance(&next) < distance(&best) => best = next,
                _ => break,
            }
        }
        best
    }

    /// The caller's joint values, angles wrapped.
    fn shown(&self, q: &JointVector) -> Vec<f64> {
        let mut q = *q;
        self.arm.wrap(&mut q);
        self.view.outward(&q)[..self.chain().dof()].to_vec()
    }

    /// The same, each angle by the copy that lies within its limits.
    fn within(&self, q: &JointVector) -> Vec<f64> {
        let mut q = *q;
        self.arm.wrap(&mut q);
        limits::bring(self.arm.chain(), &mut q);
        self.view.outward(&q)[..self.chain().dof()].to_vec()
    }

    fn gap(&self, a: &JointVector, b: &JointVector) -> f64 {
        let step = curve::difference(&self.arm, a, b);
        step.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    fn length(&self, way: &[JointVector]) -> f64 {
        way.windows(2)
            .map(|pair| self.gap(&pair[0], &pair[1]))
            .sum()
    }

    /// A point of the family between two that are a stride apart.
    fn between(
        &self,
        a: &JointVector,
        b: &JointVector,
        part: f64,
        pose: &Pose,
    ) -> Option<JointVector> {
        let step = curve::difference(&self.arm, a, b);
        let gap = self.gap(a, b);
        if gap == 0.0 {
            return Some(*a);
        }
        curve::advance(&self.arm, a, &step.map(|x| x / gap), part * gap, pose)
    }

    fn trace(&self, family: &Family) -> Trace {
        let pose = self.arm.pose(&family.at);
        let (mut ahead, mut behind): (Vec<JointVector>, Vec<JointVector>) = Default::default();
        let mut ways = 0;
        let followed = curve::follow(
            &self.arm,
            &family.at,
            &family.heading,
            &pose,
            |q, begins| {
                // The member itself comes first and begins nothing; the way back has a second beginning.
                ways += usize::from(begins);
                if ways > 1 { &mut behind } else { &mut ahead }.push(*q);
                true
            },
        );
        let closed = followed == Followed::Closed;
        if closed {
            ahead.push(family.at);
        }
        behind.reverse();
        Trace {
            member: behind.len(),
            points: [behind, ahead].concat(),
            closed,
        }
    }

    /// The points of the family's parts within the limits, their ends included.
    fn ways(&self, family: &Family) -> Vec<Vec<JointVector>> {
        let pose = self.arm.pose(&family.at);
        let fits = |q: &JointVector| limits::fits(self.arm.chain(), q);
        let Trace {
            mut points, closed, ..
        } = self.trace(family);
        if closed && let Some(outside) = points.iter().position(|q| !fits(q)) {
            // From outside to outside: no part is cut in two.
            points.pop();
            let outside = outside % points.len().max(1);
            points.rotate_left(outside);
            points.extend(points.first().copied());
        }
        let mut ways: Vec<Vec<JointVector>> = Vec::new();
        let mut last: Option<JointVector> = None;
        for q in points {
            match (last.filter(fits).is_some(), fits(&q)) {
                (false, true) => {
                    let end = last.map_or(q, |last| self.border(&q, &last, &pose));
                    ways.push(vec![end, q]);
                }
                (true, true) => ways.iter_mut().rev().take(1).for_each(|way| way.push(q)),
                (true, false) => {
                    let end = last.map_or(q, |last| self.border(&last, &q, &pose));
                    ways.iter_mut().rev().take(1).for_each(|way| way.push(end));
                }
                (false, false) => {}
            }
            last = Some(q);
        }
        ways
    }

    /// The last point within the limits on the way from one within to one outside.
    fn border(&self, inside: &JointVector, outside: &JointVector, pose: &Pose) -> JointVector {
        let (mut low, mut high, mut best) = (0.0, 1.0, *inside);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            match self.between(inside, outside, middle, pose) {
                Some(q) if limits::fits(self.arm.chain(), &q) => (low, best) = (middle, q),
                _ => high = middle,
            }
        }
        best
    }

    /// Members of a surface, by search; the listed one first if it may stand anywhere.
    fn spread(&self, family: &Family, count: usize, room: Room) -> Vec<Vec<f64>> {
        let shown = |q: JointVector| match room {
            Room::Free => self.shown(&q),
            Room::Limits => self.view.outward(&q)[..self.chain().dof()].to_vec(),
        };
        let listed = (room == Room::Free).then_some(family.at);
        let found = self.members(family, count, room);
        listed
            .into_iter()
            .chain(found)
            .take(count)
            .map(shown)
            .collect()
    }

    /// What a search finds of a surface from starts spread over the joints' ranges.
    fn members(
        &self,
        family: &Family,
        count: usize,
        room: Room,
    ) -> impl Iterator<Item = JointVector> {
        let pose = self.arm.pose(&family.at);
        (1..=count * STARTS).filter_map(move |index| {
            let from = start(&self.arm, index, room);
            let found = damped(&self.arm, &from, &pose, room, ROUNDING);
            (found.error < super::TOLERANCES.closes).then_some(found.q)
        })
    }
}
