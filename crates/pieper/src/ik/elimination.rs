//! Six revolute joints that no closed form takes: the elimination of [`general`](super::general) as a row.

use std::sync::Arc;

use super::arm::Arm;
use super::classify::{Class, Structure};
use super::general::{General, Roots};
use super::reason::Part;
use super::registry::Prepared;
use super::sink::{Marks, Sink};
use super::solutions::Branch;
use crate::spatial::Pose;

#[derive(Debug)]
struct Elimination(General);

/// Below this smallest singular value copies of one root may come out side by side, or a family pass through it: the
/// elimination calls such roots singular.
const SINGULAR: f64 = 1e-7;

/// Prepares an arm of six joints that turn, each by a variable of its own.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    let turns_freely = arm.is_independent() && arm.turns().iter().all(|&turns| turns);
    if class != Class::General || !turns_freely {
        return None;
    }
    let links = arm.links().try_into().ok()?;
    // An arm that is singular everywhere is refused there; the numeric row then takes it.
    Some(Arc::new(Elimination(General::prepare(links).ok()?)))
}

impl Prepared for Elimination {
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        let mut roots = Roots::default();
        self.0.solve(target, &mut roots);
        for root in roots.iter() {
            let singular = root.sigma < SINGULAR;
            let marks = Marks {
                multiplicity: 1,
                edge: singular,
                free: singular,
            };
            let branch = Branch {
                root: sink.found() as u8 + 1,
                ..Branch::default()
            };
            sink.push(&root.q, branch, marks);
        }
        if roots.is_empty() {
            // By how much it fails is measured by a search, if somebody asks.
            sink.fail(Part::NothingFound, f64::NAN);
        }
    }
}
