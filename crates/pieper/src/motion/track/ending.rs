//! Why a motion ends, in words and numbers.

use nalgebra::Vector3;

use super::compose::{Ending, Motion};
use super::sample::{Node, Sampler};
use super::space::Space;
use super::windings::{self, Piece, Stop};
use super::{Found, Track, make};
use crate::ik::{Branch, JointVector, Part, Shortfall};
use crate::kinematics;
use crate::model::{Chain, Variable};

/// Branches that end within this of each other (rad, extents) at one moment have met: they close in with the square
/// root of the time left, some 1e-5 of the path's duration to the half.
const MEETING: f64 = 1e-2;

/// By how much the elbow is bent to see whether it was stretched (rad).
const BEND: f64 = 0.05;

/// How a motion ends.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// It lives to the end of the path.
    Alive,
    /// It ends before.
    Dies {
        /// When, in seconds.
        time: f64,
        /// Why.
        event: Event,
    },
}

/// Why a motion ends before the path does.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Its branch and another one meet and end: the arm is singular.
    Meets {
        /// What the arm looks like there.
        pose: &'static str,
        /// The other branch, if it was found.
        other: Option<String>,
        /// Why the path cannot be reached beyond, if it cannot be reached by any branch.
        beyond: Option<Shortfall>,
    },
    /// A joint passes its limit.
    Limit {
        /// Index of the variable.
        joint: usize,
        /// The limit.
        limit: f64,
    },
    /// A joint is outside its limits from the start.
    Outside {
        /// Index of the variable.
        joint: usize,
        /// Its value.
        value: f64,
        /// The limit nearest to it.
        limit: f64,
    },
    /// The pose cannot be reached.
    Unreachable(Shortfall),
    /// Its continuation was not found.
    Lost,
}

impl Event {
    /// The event as half a sentence; `chain` gives the joints' names. Angles in degrees, lengths in millimetres.
    pub fn sentence(&self, chain: &Chain) -> String {
        let variable = |joint: &usize| chain.variables().get(*joint);
        match self {
            Self::Meets {
                pose,
                other,
                beyond,
            } => {
                let other = match other {
                    Some(other) => format!("this branch and {other} meet"),
                    None => "two branches meet".to_owned(),
                };
                let beyond = beyond.map_or(String::new(), |beyond| {
                    format!(
                        "; just beyond, no branch reaches the path: {}",
                        cause(&beyond)
                    )
                });
                format!("{pose}: {other}{beyond}")
            }
            Self::Limit { joint, limit } => {
                let (name, limit) = named(variable(joint), *limit);
                format!("{name} passes its limit {limit}")
            }
            Self::Outside {
                joint,
                value,
                limit,
            } => {
                let (name, limit) = named(variable(joint), *limit);
                let (_, value) = named(variable(joint), *value);
                format!("{name} would be {value}, its limit is {limit}")
            }
            Self::Unreachable(shortfall) => format!("out of reach: {shortfall}"),
            Self::Lost => "its continuation was not found".to_owned(),
        }
    }
}

/// Why a pose just out of reach cannot be reached; by how much would be next to nothing.
fn cause(shortfall: &Shortfall) -> &'static str {
    match shortfall.part {
        Part::WristBeyond | Part::ElbowBeyond => "the wrist centre is beyond the arm's reach",
        Part::WristTooNear | Part::ElbowTooNear => {
            "the wrist centre is nearer to the shoulder than the arm folds"
        }
        Part::WristInside | Part::Inside => {
            "it enters the region around an axis that the arm's offsets leave out"
        }
        Part::Orientation => "the wrist cannot turn to the orientation",
        Part::ToolAxis => "the tool's axis leaves the direction that the arm keeps",
        Part::Point => "the tool's point is beyond the arm's reach",
        Part::Axis | Part::Direction => "the tool's axis cannot be turned to the direction",
        Part::Spin => "the turn about the tool's axis cannot be made",
        Part::Slides => "the point leaves what the sliding joints reach",
        Part::NothingFound | Part::NoneCloses => "no joint values were found",
    }
}

/// A joint's name, and a value of it with its unit.
fn named(variable: Option<&Variable>, value: f64) -> (&str, String) {
    let Some(variable) = variable else {
        return ("a joint", value.to_string());
    };
    let shown = |value: f64| {
        let text = format!("{value:.3}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        if text == "-0" {
            "0".to_owned()
        } else {
            text.to_owned()
        }
    };
    let value = match variable.kind.is_angular() {
        true => format!("{}°", shown(value.to_degrees())),
        false => format!("{} mm", shown(value * 1000.0)),
    };
    (&variable.name, value)
}

pub(super) fn at_limit(stop: &Stop) -> End {
    End::Dies {
        time: stop.time,
        event: Event::Limit {
            joint: stop.joint,
            limit: stop.limit,
        },
    }
}

/// A motion from the path's start whose joints are outside their limits there: a track of one moment.
pub(super) fn dead_at_start(
    space: &Space<'_>,
    motion: &Motion,
    pieces: &[Piece],
    start: f64,
) -> Option<Track> {
    let first = motion.knots.first().filter(|knot| knot.time <= start)?;
    if pieces
        .first()
        .is_some_and(|piece| piece.knots[0].time <= first.time)
    {
        return None;
    }
    let (joint, value, limit) = windings::outside(space, &first.q)?;
    let end = End::Dies {
        time: first.time,
        event: Event::Outside {
            joint,
            value,
            limit,
        },
    };
    Some(make(space, motion.branch.to_string(), &[*first], end))
}

/// The end of a motion that no limit ended.
pub(super) fn of(sampler: &Sampler<'_>, found: &Found, motion: &Motion) -> End {
    let Ending::Strand { strand, sample } = motion.end else {
        return match motion.end {
            Ending::Alive => End::Alive,
            _ => End::Dies {
                time: motion.knots.last().map_or(0.0, |knot| knot.time),
                event: Event::Lost,
            },
        };
    };
    let samples = &found.grid.samples;
    let time = samples[sample].time;
    let beyond = samples.get(sample + 1).and_then(|next| next.shortfall);
    let own = &found.strands[strand];
    let node = own.end(&found.grid);
    let partner = found.strands.iter().enumerate().find_map(|(index, other)| {
        let ends_here = index != strand && other.last() == sample && other.after.is_empty();
        let before = own.is_set && own.before.contains(&index);
        let other = other.end(&found.grid);
        let distance = sampler.space.size(&sampler.space.way(&node.q, &other.q));
        (ends_here && !before && distance < MEETING).then_some(other)
    });
    let event = match (partner, own.is_set, beyond) {
        (Some(other), ..) => meets(sampler.space, node, Some(other), beyond),
        (None, true, _) => meets(sampler.space, node, None, beyond),
        (None, false, Some(shortfall)) => Event::Unreachable(shortfall),
        (None, false, None) => Event::Lost,
    };
    End::Dies { time, event }
}

fn meets(space: &Space<'_>, node: &Node, other: Option<&Node>, beyond: Option<Shortfall>) -> Event {
    Event::Meets {
        pose: match other {
            Some(other) => look(space, &node.q, &node.branch, &other.branch),
            None => "the arm is singular",
        },
        other: other.map(|other| other.branch.to_string()),
        beyond,
    }
}

/// What an arm looks like where two branches meet: told from the words in which their names differ.
fn look(space: &Space<'_>, q: &JointVector, a: &Branch, b: &Branch) -> &'static str {
    if a.shoulder != b.shoulder {
        return "the wrist comes as near to axis 1 as it can";
    }
    if a.elbow != b.elbow {
        return match is_stretched(space, q) {
            Some(true) => "the elbow is stretched",
            Some(false) => "the elbow is folded",
            None => "the elbow is stretched or folded",
        };
    }
    match a.wrist != b.wrist {
        true => "the wrist is straight",
        false => "the arm is singular",
    }
}

/// Whether bending joint 3 brings joint 5 nearer to axis 2.
fn is_stretched(space: &Space<'_>, q: &JointVector) -> Option<bool> {
    let distance = |bend: f64| -> Option<f64> {
        let mut q = *q;
        q[2] += bend;
        let mut poses = Vec::new();
        kinematics::link_poses(space.chain, &q[..space.dof()], &mut poses).ok()?;
        let moving: Vec<usize> = (0..poses.len())
            .filter(|&k| space.chain.joints()[k].motion.drive().is_some())
            .collect();
        let frame = |joint: usize| {
            let index = *moving.get(joint)?;
            let parent = match index.checked_sub(1) {
                Some(before) => poses[before],
                None => *space.chain.base(),
            };
            Some((parent * space.chain.joints()[index].before, index))
        };
        let (second, index) = frame(1)?;
        let (fifth, _) = frame(4)?;
        let axis: Vector3<f64> =
            second.rotation * space.chain.joints()[index].motion.axis()?.into_inner();
        let lever = fifth.translation.vector - second.translation.vector;
        Some(axis.cross(&lever).norm())
    };
    let (here, bent) = (distance(0.0)?, distance(BEND)?.max(distance(-BEND)?));
    Some(bent < here)
}
