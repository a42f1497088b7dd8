//! The solvers: one row each, asked in order; the first that takes an arm solves it.

use std::fmt;
use std::sync::Arc;

use super::arm::Arm;
use super::classify::{Class, Structure};
use super::sink::Sink;
use super::solutions::JointVector;
use super::{
    elimination, fewer, locked, numeric, parallel, planar, spherical, swivel, three_slides,
};
use crate::spatial::Pose;

/// A solver prepared for one arm.
///
/// It proposes displacements to the [`Sink`], which verifies, refines, merges and names families; a proposal may
/// therefore be wrong, but a root that is not proposed is lost.
pub trait Prepared: fmt::Debug + Send + Sync {
    /// Proposes every solution of `Z_1 L_1 ... Z_m L_m = target` (links of the arm, target seen from the first
    /// axis), or says what fails. Must not allocate.
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>);

    /// The angle that a solver's families run over at given joint values, for a solver that has one.
    fn swivel(&self, _: &Arm, _: &JointVector) -> Option<f64> {
        None
    }

    /// How far the arm misses what this solver takes it for, beyond the miss of its class; relative.
    fn slack(&self) -> f64 {
        0.0
    }
}

/// An arm's prepared solver, and the class it is solved as.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The row's name.
    pub name: &'static str,
    /// The class.
    pub class: Class,
    /// How far the arm misses that class, relative; rounding counts as 0.
    pub slack: f64,
    /// The solver.
    pub solver: Arc<dyn Prepared>,
}

/// One solver.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Its name.
    pub name: &'static str,
    /// What it does, in a line.
    pub summary: &'static str,
    /// Prepares it for an arm of this class, if it takes that.
    pub prepare: fn(&Arm, &Structure, Class) -> Option<Arc<dyn Prepared>>,
}

/// All rows, the most special first.
pub const ROWS: &[Row] = &[
    Row {
        name: "spherical",
        summary: "three neighbouring axes through one point, any other three: a quartic at most, then the orientation",
        prepare: spherical::prepare,
    },
    Row {
        name: "three-parallel",
        summary: "three neighbouring parallel axes of six: two angles by closed form, then a triangle",
        prepare: parallel::prepare,
    },
    Row {
        name: "offset-wrist",
        summary: "axes 2 and 3 parallel, axis 5 meets a neighbour: an equation of degree 8 in one angle, then closed form",
        prepare: elimination::prepare_offset_wrist,
    },
    Row {
        name: swivel::NAME,
        summary: "seven axes, spherical shoulder and wrist: eight families over the swivel of the elbow",
        prepare: swivel::prepare,
    },
    Row {
        name: "planar",
        summary: "all axes parallel (SCARA, planar arms): a triangle, an angle and a height",
        prepare: planar::prepare,
    },
    Row {
        name: "three-slides",
        summary: "six joints of which three slide: the angles from the orientation, then the slides, two solutions",
        prepare: three_slides::prepare,
    },
    Row {
        name: "locked",
        summary: "any seven joints: families over the first or the last, the other six solved by one of these rows",
        prepare: locked::prepare,
    },
    Row {
        name: "fewer",
        summary: "up to five joints: joints that the arm does not have make up six, and must come out at zero",
        prepare: fewer::prepare,
    },
    Row {
        name: "general",
        summary: "six axes in any position, up to two sliding: elimination to one angle, all real solutions up to sixteen",
        prepare: elimination::prepare,
    },
    Row {
        name: numeric::NAME,
        summary: "damped least squares from many starts: any chain, no proof that all solutions are found",
        prepare: numeric::prepare,
    },
];

/// The first row that takes the arm, trying its classes in order.
pub(super) fn choose(arm: &Arm, structure: &Structure) -> Option<Choice> {
    let pairs = structure
        .classes
        .iter()
        .flat_map(|&(class, miss)| ROWS.iter().map(move |row| (row, class, miss)));
    for (row, class, miss) in pairs {
        if let Some(solver) = (row.prepare)(arm, structure, class) {
            let miss = miss.max(solver.slack());
            return Some(Choice {
                name: row.name,
                class,
                slack: if miss < super::TOLERANCES.exact {
                    0.0
                } else {
                    miss
                },
                solver,
            });
        }
    }
    None
}
