//! Chains with joints that the arm does not have, and chains without some that it has.

use nalgebra::Vector3;

use super::goal::Goal;
use super::normal::Normal;
use crate::error::Result;
use crate::model::{Chain, ChainParts, Drive, Joint, JointKind, Motion, Variable};
use crate::spatial::{Pose, shift, turn};

use super::arm::Arm;

/// A joint to add: it moves about or along the z axis of `frame`, and changes nothing at zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extra {
    pub(super) place: Place,
    pub(super) frame: Pose,
    pub(super) turns: bool,
}

/// Where an extra joint stands, and from where its frame is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// In front of the first joint, seen from the chain's base.
    Base,
    /// Behind the tool, seen from the tool.
    Tool,
}

/// The chain with extra joints, in their order; their variables come behind those of the chain.
pub(super) fn extended(chain: &Chain, extras: &[Extra]) -> Result<Chain> {
    let parts = chain.parts();
    let mut variables = parts.variables.clone();
    let (mut before, mut after) = (Vec::new(), Vec::new());
    for (index, extra) in extras.iter().enumerate() {
        let name = format!("extra {}", index + 1);
        let kind = if extra.turns {
            JointKind::Continuous
        } else {
            JointKind::Prismatic
        };
        let drive = Drive {
            variable: variables.len(),
            factor: 1.0,
            offset: 0.0,
        };
        variables.push(Variable::new(name.clone(), kind));
        let joint = Joint {
            link: name.clone(),
            name,
            before: extra.frame,
            motion: if extra.turns {
                Motion::turn_z(drive)
            } else {
                Motion::slide_z(drive)
            },
            after: extra.frame.inverse(),
        };
        match extra.place {
            Place::Base => before.push(joint),
            Place::Tool => after.push(joint),
        }
    }
    if let Some(first) = after.first_mut() {
        first.before = parts.tool * first.before;
    }
    let tool = if after.is_empty() {
        parts.tool
    } else {
        Pose::identity()
    };
    let joints = [before, parts.joints.clone(), after].concat();
    Chain::new(ChainParts {
        variables,
        joints,
        base: parts.base,
        tool,
    })
}

/// The chain with one variable held at a value: every joint that it drives is fixed there.
///
/// # Errors
/// A model error if no other joint moves.
pub(super) fn held(chain: &Chain, variable: usize, value: f64) -> Result<Chain> {
    let mut parts = chain.parts().clone();
    let mut q = vec![0.0; chain.dof()];
    q[variable] = value;
    parts.variables.remove(variable);
    for joint in &mut parts.joints {
        let moved = joint.motion.pose(&q);
        match &mut joint.motion {
            Motion::Turn(_, drive) | Motion::Slide(_, drive) if drive.variable == variable => {
                joint.before *= moved;
                joint.motion = Motion::Fixed;
            }
            Motion::Turn(_, drive) | Motion::Slide(_, drive) if drive.variable > variable => {
                drive.variable -= 1;
            }
            _ => {}
        }
    }
    Chain::new(parts)
}

/// The chain without its first or last moving joint and the link that this carries: up to where it stands.
///
/// # Errors
/// A model error if no other joint moves.
pub(super) fn without_end(chain: &Chain, end: Place) -> Result<Chain> {
    let canonical = chain.canonical();
    let count = canonical.steps.len();
    let (gone, kept) = match end {
        Place::Base => (0, 1..count),
        Place::Tool => (count - 1, 0..count - 1),
    };
    let gone = canonical.steps[gone].drive.variable;
    let mut variables = chain.variables().to_vec();
    variables.remove(gone);
    let joint = |index: usize| {
        let step = &canonical.steps[index];
        let variable = step.drive.variable;
        let drive = Drive {
            variable: variable - usize::from(variable > gone),
            ..step.drive
        };
        Joint {
            name: format!("{}", index + 1),
            link: format!("{}", index + 1),
            before: Pose::identity(),
            motion: if step.turns {
                Motion::turn_z(drive)
            } else {
                Motion::slide_z(drive)
            },
            after: canonical.link(index),
        }
    };
    Chain::new(ChainParts {
        variables,
        joints: kept.map(joint).collect(),
        base: match end {
            Place::Base => Pose::identity(),
            Place::Tool => canonical.base,
        },
        tool: Pose::identity(),
    })
}

/// The chain with joints that make up for the parts of a pose which a goal leaves open: any pose that meets the goal is
/// one that the longer chain reaches.
///
/// - The position: three turns through the tool's point.
/// - Position and axis: a turn about the tool's z axis.
/// - The axis: that turn, and slides of the base along x, y, z. Where the chain's own links are does not matter then, so
///   they are all put at the origin.
pub(super) fn open_to(chain: &Chain, goal: Goal) -> Result<Chain> {
    let spin = Extra {
        place: Place::Tool,
        frame: Pose::identity(),
        turns: true,
    };
    match goal {
        Goal::Pose => Ok(chain.clone()),
        Goal::PositionAxis => extended(chain, &[spin]),
        Goal::Position => {
            let mut frame = Pose::identity();
            extended(
                chain,
                &TWISTS.map(|twist| {
                    let place = Extra { frame, ..spin };
                    frame *= turn(&Vector3::z_axis(), twist.sin_cos())
                        * turn(&Vector3::x_axis(), (1.0, 0.0));
                    place
                }),
            )
        }
        Goal::Axis => {
            let mut parts = chain.parts().clone();
            for pose in [&mut parts.base, &mut parts.tool].into_iter().chain(
                parts
                    .joints
                    .iter_mut()
                    .flat_map(|joint| [&mut joint.before, &mut joint.after]),
            ) {
                pose.translation.vector = Vector3::zeros();
            }
            // z to x, z to y, z.
            let axes = [
                turn(&Vector3::y_axis(), (1.0, 0.0)),
                turn(&Vector3::x_axis(), (-1.0, 0.0)),
                Pose::identity(),
            ];
            let slides = axes.map(|frame| Extra {
                place: Place::Base,
                frame,
                turns: false,
            });
            extended(&Chain::new(parts)?, &[&slides[..], &[spin]].concat())
        }
    }
}

/// Angles at which extra axes stand to those before them: any that make no right angle with anything.
const TWISTS: [f64; 3] = [0.7, 0.9, 1.1];

/// Where on or off an axis extra axes meet, in sizes of the arm: any point that no arm's own axes pass.
const ASIDE: [f64; 3] = [0.31, 0.23, 0.37];

/// How extra axes at one end stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stand {
    /// Up to three of them and, if fewer, the arm's own axes at that end pass through one point where that is possible: a
    /// spherical joint, which closed forms take.
    Ball,
    /// Far from meeting one another.
    Askew,
}

/// `count` extra turns at one end.
pub(super) fn turns_at(place: Place, count: usize, stand: Stand, arm: &Arm) -> Vec<Extra> {
    let (links, steps, turns) = (arm.links(), arm.steps(), arm.turns());
    // The outermost axis, seen from that end, and where the next one crosses it.
    let next_to = |next: usize, link: usize, height: fn(&Normal) -> f64| {
        let normal = (steps > 1 && turns[next]).then(|| Normal::of(&links[link], arm.size()));
        normal.filter(Normal::crosses).map(|normal| height(&normal))
    };
    let (axis, outer_turns, crossing) = match place {
        Place::Tool => {
            let before = steps.saturating_sub(2);
            let crossing = next_to(before, before, |normal| -normal.e);
            (links[steps - 1].inverse(), turns[steps - 1], crossing)
        }
        Place::Base => {
            let base = arm.chain().base().inverse() * arm.chain().canonical().base;
            (base, turns[0], next_to(1, 0, |normal| normal.d))
        }
    };
    let aside = Vector3::from(ASIDE.map(|part| part * arm.size()));
    let at = match (count, crossing, stand) {
        (1, Some(height), Stand::Ball) if outer_turns => Vector3::new(0.0, 0.0, height),
        (2, _, Stand::Ball) if outer_turns => Vector3::new(0.0, 0.0, aside.z),
        _ => aside,
    };
    let mut frame = axis * shift(at);
    let mut extras = Vec::with_capacity(count);
    for twist in TWISTS.into_iter().cycle().take(count) {
        frame *= turn(&Vector3::z_axis(), twist.sin_cos()) * turn(&Vector3::x_axis(), (1.0, 0.0));
        extras.push(Extra {
            place,
            frame,
            turns: true,
        });
        if stand == Stand::Askew {
            frame *= shift(aside);
        }
    }
    if place == Place::Base {
        extras.reverse();
    }
    extras
}
