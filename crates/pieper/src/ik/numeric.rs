//! Any chain, numerically: damped least squares from many starts.

use std::f64::consts::PI;
use std::sync::Arc;

use super::arm::{Arm, MAX_JOINTS};
use super::classify::{Class, Structure};
use super::curve;
use super::descent::damped;
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::{Branch, JointVector};
use crate::spatial::Pose;

/// Deterministic restarts of the damped descent. Finds what it finds: no proof of completeness.
#[derive(Clone, Copy, Debug)]
struct Numeric {
    starts: usize,
    redundant: bool,
}

/// Starts for six joints: enough to meet each of up to sixteen roots several times.
const STARTS: usize = 300;

/// Starts for more joints: members of families, not isolated roots, are looked for.
const STARTS_REDUNDANT: usize = 40;

/// Below this smallest rate of change of the pose a root may lie on a family.
const FLAT: f64 = 1e-7;

/// Prepares any arm.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::General {
        return None;
    }
    let redundant = arm.chain().dof() > 6;
    let starts = if redundant { STARTS_REDUNDANT } else { STARTS };
    Some(Arc::new(Numeric { starts, redundant }))
}

impl Prepared for Numeric {
    fn solve(&self, _: &Pose, sink: &mut Sink<'_>) {
        let (arm, pose) = (sink.arm(), sink.pose());
        let mut least = f64::INFINITY;
        for index in 0..self.starts {
            let found = damped(arm, &start(arm, index), pose, false);
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
        }
        if least.is_finite() {
            sink.fail(Part::NothingFound, least);
        }
    }
}

/// A descent that ends with a smaller error is close enough for Newton's method.
const CONVERGED: f64 = 1e-7;

/// Deterministic start number `index`: zero, then points of an additive recurrence that fills the joints' ranges
/// evenly (Roberts 2018: powers of the inverse of the root of `x^(d+1) = x + 1`).
pub(super) fn start(arm: &Arm, index: usize) -> JointVector {
    let mut q = [0.0; MAX_JOINTS];
    if index == 0 {
        return q;
    }
    let variables = arm.chain().variables();
    let mut root = 2.0_f64;
    for _ in 0..30 {
        root = (1.0 + root).powf(1.0 / (variables.len() as f64 + 1.0));
    }
    for (j, variable) in variables.iter().enumerate() {
        let step = root.powi(-(j as i32 + 1));
        let part = (0.5 + step * index as f64).fract();
        let range = if variable.kind.is_angular() {
            PI
        } else {
            arm.extent()
        };
        q[j] = range * (2.0 * part - 1.0);
        if let (Some(limits), false) = (variable.limits, variable.kind.is_angular()) {
            q[j] = limits.lower() + part * (limits.upper() - limits.lower());
        }
    }
    q
}
