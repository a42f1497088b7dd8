//! Six joints, up to two of them sliding, that no closed form takes: the solver of [`general`](super::general) as two rows, one
//! for the arms for which it has an equation without elimination.

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

/// Prepares an arm of six joints, each with a variable of its own, of which up to two slide.
pub(super) fn prepare(arm: &Arm, _: &Structure, class: Class) -> Option<Arc<dyn Prepared>> {
    if class != Class::General || !arm.is_independent() {
        return None;
    }
    Some(Arc::new(Elimination(general(arm)?)))
}

/// Prepares an arm with an offset wrist, unless it is so special that the equation has double roots only.
pub(super) fn prepare_offset_wrist(
    arm: &Arm,
    _: &Structure,
    class: Class,
) -> Option<Arc<dyn Prepared>> {
    let Class::OffsetWrist { .. } = class else {
        return None;
    };
    let general = general(arm)?;
    general
        .has_equation()
        .then(|| -> Arc<dyn Prepared> { Arc::new(Elimination(general)) })
}

fn general(arm: &Arm) -> Option<General> {
    let links = arm.links().try_into().ok()?;
    let turns: [bool; 6] = arm.turns().try_into().ok()?;
    let slides = std::array::from_fn(|joint| (!turns[joint]).then(|| travel(arm, joint)));
    // An arm that is singular everywhere is refused there; the numeric row then takes it.
    General::prepare_with_slides(links, &slides).ok()
}

/// By how much a sliding joint moves: its range, if that is no more than the arm is long.
fn travel(arm: &Arm, joint: usize) -> f64 {
    let drive = arm.drives()[joint];
    let limits = arm.chain().variables()[drive.variable].limits;
    let range = limits.map_or(f64::INFINITY, |limits| {
        (limits.upper() - limits.lower()) * drive.factor.abs()
    });
    if range > 0.0 {
        range.min(arm.size())
    } else {
        arm.size()
    }
}

impl Prepared for Elimination {
    fn solve(&self, target: &Pose, sink: &mut Sink<'_>) {
        let mut roots = Roots::default();
        self.0.solve(target, &mut roots);
        for (index, root) in roots.iter().enumerate() {
            // Copies of one root may come out side by side, or a family pass through it.
            let marks = Marks {
                multiplicity: root.multiplicity,
                edge: root.open,
                free: root.open,
            };
            let branch = Branch {
                root: index as u8 + 1,
                ..Branch::default()
            };
            sink.push_turns(&root.turns, branch, marks);
        }
        if roots.is_empty() {
            // By how much it fails is measured by a search, if somebody asks.
            sink.fail(Part::NothingFound, f64::NAN);
        }
    }
}
