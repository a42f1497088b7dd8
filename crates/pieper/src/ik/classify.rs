//! What kind of arm it is, with the evidence: which axes meet, which are parallel, and how closely.

use std::fmt;

use nalgebra::Matrix6;

use super::TOLERANCES;
use super::arm::{Arm, Columns, MAX_JOINTS};
use super::descent::Room;
use super::normal::Normal;
use super::numeric::start;
use crate::error::Result;
use crate::model::Chain;

/// How two neighbouring axes lie to each other, as measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relation {
    /// Parallel at a distance.
    Parallel,
    /// On one line.
    Coincident,
    /// Meeting in a point.
    Meeting,
    /// Neither.
    Skew,
}

/// Two neighbouring axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The first axis, counted from 0.
    pub first: usize,
    /// Their relation within the class tolerance.
    pub relation: Relation,
    /// The angle between them, radians.
    pub angle: f64,
    /// The length of their common normal, metres.
    pub distance: f64,
    /// By how much the relation is missed: radians, or metres relative to the arm's size.
    pub miss: f64,
}

/// The families of arms that solvers know.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// Axes `first`, `first + 1`, `first + 2` (counted from 0) of six pass through one point.
    Spherical {
        /// The first of the three.
        first: usize,
    },
    /// Axes `first`, `first + 1`, `first + 2` of six are parallel, all six turn.
    ThreeParallel {
        /// The first of the three.
        first: usize,
    },
    /// Six axes that turn; of them, counted from the base, or from the tool if mirrored, axes 2 and 3 are parallel and axis 5
    /// meets axis 4 or axis 6. Exactly: arms that miss it are general.
    OffsetWrist {
        /// Whether it is so from the tool.
        mirrored: bool,
    },
    /// Every axis is parallel to every other: SCARA and planar arms.
    AllParallel,
    /// Seven axes that turn: the first three and the last three pass through one point each.
    SphericalRotationalSpherical,
    /// None of these.
    General,
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Spherical { first: 3 } => f.write_str("spherical wrist"),
            Self::Spherical { first: 0 } => {
                f.write_str("spherical shoulder (a mirrored spherical wrist)")
            }
            Self::Spherical { .. } => f.write_str("spherical joint in mid-arm"),
            Self::ThreeParallel { .. } => f.write_str("three parallel axes"),
            Self::OffsetWrist { mirrored: false } => f.write_str("offset wrist"),
            Self::OffsetWrist { mirrored: true } => {
                f.write_str("offset shoulder (a mirrored offset wrist)")
            }
            Self::AllParallel => f.write_str("all axes parallel"),
            Self::SphericalRotationalSpherical => {
                f.write_str("spherical shoulder, elbow, spherical wrist")
            }
            Self::General => f.write_str("general"),
        }
    }
}

/// What is known of an arm's structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// Every pair of neighbouring axes.
    pub pairs: Vec<Pair>,
    /// The classes the arm belongs to, the most useful first; [`Class::General`] is always the last.
    pub classes: Vec<(Class, f64)>,
    /// Whether six joints are too few in every configuration: some motion of them leaves the tool where it is. Every solution is
    /// then one of infinitely many, and such an arm belongs to no class.
    pub singular: bool,
}

impl Structure {
    /// The first class.
    pub fn class(&self) -> Class {
        self.classes
            .first()
            .map_or(Class::General, |&(class, _)| class)
    }
}

/// Measures an arm's axes.
///
/// # Errors
/// A model error for a chain of more than [`MAX_JOINTS`] joints.
pub fn structure(chain: &Chain) -> Result<Structure> {
    Ok(of(&Arm::new(chain)?))
}

pub(super) fn of(arm: &Arm) -> Structure {
    let mut structure = of_axes(arm);
    if arm.steps() == 6 && arm.chain().dof() == 6 && is_singular(arm) {
        structure.singular = true;
        structure.classes = vec![(Class::General, 0.0)];
    }
    structure
}

/// Configurations at which an arm is tried that may be singular everywhere.
const TRIALS: usize = 4;

/// The smallest singular value over the largest, below which a configuration counts as singular: rounding of the Jacobian, with
/// something to spare for arms of very different lengths.
const SINGULAR: f64 = 1e-14;

fn is_singular(arm: &Arm) -> bool {
    (1..=TRIALS).all(|index| {
        let q = start(arm, index, Room::Free);
        let mut columns: Columns = [[0.0; 6]; MAX_JOINTS];
        arm.pose_and_columns(&q, &mut columns);
        let values = Matrix6::from_fn(|row, column| columns[column][row]).singular_values();
        values.min() < SINGULAR * values.max()
    })
}

/// The same without a look at whether the arm is singular everywhere.
pub(super) fn of_axes(arm: &Arm) -> Structure {
    let count = arm.steps();
    let normals: Vec<Normal> = (0..count.saturating_sub(1))
        .map(|index| Normal::of(&arm.links()[index], arm.size()))
        .collect();
    let pairs: Vec<Pair> = (0..normals.len())
        .map(|index| pair(arm, index, &normals[index]))
        .collect();
    let mut classes = Vec::new();
    if arm.is_independent() {
        find_classes(arm, &normals, &pairs, &mut classes);
    }
    classes.push((Class::General, 0.0));
    Structure {
        pairs,
        classes,
        singular: false,
    }
}

fn pair(arm: &Arm, first: usize, normal: &Normal) -> Pair {
    let link = &arm.links()[first];
    let m = link.rotation.matrix();
    let sine = m[(0, 2)].hypot(m[(1, 2)]);
    let t = link.translation.vector;
    let distance = if normal.is_parallel() {
        t.x.hypot(t.y)
    } else {
        ((m[(0, 2)] * t.y - m[(1, 2)] * t.x) / sine).abs()
    };
    let relation = match (normal.is_parallel(), normal.meets()) {
        (true, true) => Relation::Coincident,
        (true, false) => Relation::Parallel,
        (false, true) => Relation::Meeting,
        (false, false) => Relation::Skew,
    };
    Pair {
        first,
        relation,
        angle: sine.atan2(m[(2, 2)]),
        distance,
        miss: normal.miss,
    }
}

/// How far three axes miss a common point, relative to the arm's size; `None` if they are not near one.
pub(super) fn spherical_miss(first: &Normal, second: &Normal, size: f64) -> Option<f64> {
    let meet = first.meets() && second.meets() && !first.is_parallel() && !second.is_parallel();
    let gap = (first.e + second.d).abs() / size;
    (meet && gap < TOLERANCES.class).then(|| first.miss.max(second.miss).max(gap))
}

fn find_classes(arm: &Arm, normals: &[Normal], pairs: &[Pair], classes: &mut Vec<(Class, f64)>) {
    let turns = arm.turns();
    let spherical = |first: usize| {
        let three = turns[first..first + 3].iter().all(|&turns| turns);
        let miss = spherical_miss(&normals[first], &normals[first + 1], arm.size());
        miss.filter(|_| three)
    };
    if arm.steps() == 6 {
        for first in [3, 0, 2, 1] {
            if let Some(miss) = spherical(first) {
                classes.push((Class::Spherical { first }, miss));
            }
        }
        for first in [1, 2, 0, 3] {
            let parallel = |index: usize| pairs[index].relation == Relation::Parallel;
            if turns.iter().all(|&turns| turns) && parallel(first) && parallel(first + 1) {
                let miss = pairs[first].miss.max(pairs[first + 1].miss);
                classes.push((Class::ThreeParallel { first }, miss));
            }
        }
    }
    if arm.steps() == 6 && classes.is_empty() && turns.iter().all(|&turns| turns) {
        for mirrored in [false, true] {
            if let Some(miss) = offset_miss(normals, pairs, mirrored) {
                classes.push((Class::OffsetWrist { mirrored }, miss));
            }
        }
    }
    if arm.steps() == 7
        && turns[3]
        && let (Some(shoulder), Some(wrist)) = (spherical(0), spherical(4))
    {
        classes.push((Class::SphericalRotationalSpherical, shoulder.max(wrist)));
    }
    let all = pairs
        .iter()
        .all(|pair| matches!(pair.relation, Relation::Parallel | Relation::Coincident));
    if all && !pairs.is_empty() {
        let miss = pairs.iter().map(|pair| pair.miss).fold(0.0, f64::max);
        classes.push((Class::AllParallel, miss));
    }
}

/// How far an arm misses an offset wrist, by rounding only; `None` if by more.
fn offset_miss(normals: &[Normal], pairs: &[Pair], mirrored: bool) -> Option<f64> {
    let at = |index: usize| if mirrored { 4 - index } else { index };
    let upper = (pairs[at(1)].relation == Relation::Parallel).then_some(pairs[at(1)].miss)?;
    let parallel = [0, 2].iter().any(|&index| normals[at(index)].is_parallel());
    let crossing = [3, 4]
        .map(|index| normals[at(index)])
        .into_iter()
        .find(|normal| normal.crosses() && normal.miss < TOLERANCES.exact)?;
    let miss = upper.max(crossing.miss);
    (!parallel && miss < TOLERANCES.exact).then_some(miss)
}

impl Structure {
    /// The evidence for a class, one sentence each, with the measured deviations.
    pub fn evidence(&self, class: Class) -> Vec<String> {
        let mut out = Vec::new();
        let axes = |first: usize, last: usize| {
            let names: Vec<String> = (first..=last).map(|axis| (axis + 1).to_string()).collect();
            match names.split_last() {
                Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
                None => String::new(),
            }
        };
        let miss = self
            .classes
            .iter()
            .find(|(one, _)| *one == class)
            .map_or(0.0, |&(_, miss)| miss);
        match class {
            Class::Spherical { first } => out.push(format!(
                "axes {} pass through one point (missed by {miss:.1e} of the arm's size)",
                axes(first, first + 2)
            )),
            Class::ThreeParallel { first } => out.push(format!(
                "axes {} are parallel (missed by {miss:.1e} rad)",
                axes(first, first + 2)
            )),
            Class::OffsetWrist { mirrored } => {
                let [second, third, fourth, fifth, sixth] =
                    [2, 3, 4, 5, 6].map(|axis| if mirrored { 7 - axis } else { axis });
                let meets = |other: usize| {
                    let first = fifth.min(other) - 1;
                    self.pairs[first].relation == Relation::Meeting
                };
                let other = if meets(fourth) { fourth } else { sixth };
                out.push(format!(
                    "axes {} and {} are parallel, and axis {fifth} meets axis {other}: one equation in one angle is left",
                    second.min(third),
                    second.max(third)
                ));
            }
            Class::AllParallel => {
                out.push(format!("all axes are parallel (missed by {miss:.1e} rad)"))
            }
            Class::SphericalRotationalSpherical => {
                out.push(format!(
                    "axes {} pass through one point, axes {} through another (missed by {miss:.1e} of the arm's size)",
                    axes(0, 2),
                    axes(4, 6)
                ));
            }
            Class::General if self.singular => out.push(
                "singular everywhere: in every configuration some motion of the joints leaves the tool where it is"
                    .to_owned(),
            ),
            Class::General => out.push("no closed form here takes such an arm".to_owned()),
        }
        out.extend(self.pairs.iter().map(|pair| pair.sentence()));
        out
    }
}

impl Pair {
    /// What was measured, as a sentence.
    pub fn sentence(&self) -> String {
        let (a, b) = (self.first + 1, self.first + 2);
        let (angle, mm) = (self.angle.to_degrees(), self.distance * 1e3);
        match self.relation {
            Relation::Parallel => format!("axes {a} and {b} are parallel, {mm:.3} mm apart"),
            Relation::Coincident => format!("axes {a} and {b} lie on one line"),
            Relation::Meeting => format!("axes {a} and {b} meet at {angle:.3} degrees"),
            Relation::Skew => {
                format!("axes {a} and {b} pass at {mm:.3} mm, turned by {angle:.3} degrees")
            }
        }
    }
}
