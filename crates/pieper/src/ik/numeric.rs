//! Any chain, numerically: damped least squares from many starts.

use std::f64::consts::PI;
use std::sync::Arc;

use super::arm::{Arm, MAX_JOINTS};
use super::classify::{Class, Structure};
use super::curve;
use super::descent::{ROUNDING, Room, damped};
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, JointVector};
use crate::spatial::Pose;

/// The row's name.
pub(super) const NAME: &str = "numeric";

/// Deterministic restarts of the damped descent. Finds what it finds: no proof of completeness.
#[derive(Clone, Copy, Debug)]
struct Numeric {
    starts: usize,
    redundant: bool,
}

/// Starts for six joints: enough to meet each of up to sixteen roots several times.
const STARTS: usize = 300;

/// Starts for more joints, and for arms that are singular everywhere: members of families, not isolated roots, are looked for.
const STARTS_FAMILIES: usize = 40;

/// Below this smallest rate of change of the pose a root may lie on a family.
const FLAT: f64 = 1e-7;

/// Prepares any arm.
pub(super) fn prepare(arm: &Arm, structure: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::General {
        return None;
    }
    let redundant = arm.chain().dof() > 6;
    let starts = match redundant || structure.singular {
        true => STARTS_FAMILIES,
        false => STARTS,
    };
    Some(Arc::new(Numeric { starts, redundant }))
}

impl Prepared for Numeric {
    fn solve(&self, _: &Pose, sink: &mut Sink<'_>) {
        let (arm, pose) = (sink.arm(), sink.pose());
        let mut least = f64::INFINITY;
        for index in 0..self.starts {
            let found = damped(
                arm,
                &start(arm, index, Room::Free),
                pose,
                Room::Free,
                ROUNDING,
            );
            if found.error > CONVERGED {
                least = least.min(found.error * arm.extent());
                continue;
            }
            let mut q = found.q;
            arm.wrap(&mut q);
            let free = !self.redundant && curve::tangent(arm, &q).1 < FLAT;
            let branch = Branch {
                root: sink.found() as u8 + 1,
                ..Branch::default()
            };
            let marks = Marks {
                multiplicity: 1,
                edge: true,
                free,
            };
            sink.push_joints(q, branch, marks);
            // One surface, as far as a search can tell; or an arm that is singular everywhere, with more families than
            // are listed.
            if self.redundant && curve::is_surface(arm, &q) || sink.is_full() {
                break;
            }
        }
        if least.is_finite() {
            sink.fail(Part::NothingFound, least);
        }
    }
}

/// A descent that ends with a smaller error is close enough for Newton's method.
const CONVERGED: f64 = 1e-7;

/// The roots of `x^(d+1) = x + 1` for d from 1.
const ROOTS: [f64; MAX_JOINTS] = [
    1.618_033_988_749_895,
    1.324_717_957_244_746,
    1.220_744_084_605_759_6,
    1.167_303_978_261_418_7,
    1.134_724_138_401_519_4,
    1.112_775_684_278_705_5,
    1.096_981_557_798_559_8,
    1.085_070_245_491_451,
    1.075_766_066_086_837,
    1.068_297_188_920_841_2,
    1.062_169_167_864_255,
    1.057_050_575_221_228_5,
];

/// Deterministic start number `index`: zero, then points of an additive recurrence that fills the joints' ranges
/// evenly (Roberts 2018: powers of the inverse of the root of `x^(d+1) = x + 1`). Angles fill the whole turn, or
/// their limits where these bound the search.
pub(super) fn start(arm: &Arm, index: usize, room: Room) -> JointVector {
    let mut q = [0.0; MAX_JOINTS];
    let variables = arm.chain().variables();
    let step = 1.0 / ROOTS[variables.len().clamp(1, MAX_JOINTS) - 1];
    let mut power = 1.0;
    for (value, variable) in q.iter_mut().zip(variables) {
        power *= step;
        let part = if index == 0 {
            0.5
        } else {
            (0.5 + power * index as f64).fract()
        };
        let angular = variable.kind.is_angular();
        let range = if angular { PI } else { arm.extent() };
        *value = match variable.limits {
            Some(limits) if !angular || room == Room::Limits => {
                limits.lower() + part * (limits.upper() - limits.lower())
            }
            _ => range * (2.0 * part - 1.0),
        };
    }
    q
}
