//! Columns of a table that look as if they were exchanged.

use nalgebra::{Quaternion, UnitQuaternion};

use super::parameter::Group;
use super::place::{place_frames, place_sets};
use super::problem::Problem;
use super::robust::median;
use super::solve::residuals;
use crate::describe::{Measurement, Readings, Seen};
use crate::error::{Error, Result};

/// Arms are looked at whose measurements miss the description by more than this, metres: an arm that is a little off misses it by less.
const SUSPECT: f64 = 0.03;

/// Columns are exchanged where that leaves less than this share of what was missed.
const BETTER: f64 = 0.2;

/// Readings that miss no more than so many times what the best misses are as good: some are placed anew, which hides a part of it.
const ALIKE: f64 = 4.0;

/// How an angle of a pose weighs against a length, metres for a radian.
const ARM: f64 = 0.3;

/// What a table may have meant.
struct Reading {
    /// How it is read.
    words: String,
    /// What to ask the person.
    question: &'static str,
    change: Box<dyn Fn(&mut Measurement)>,
}

impl Reading {
    fn new(
        words: impl Into<String>,
        question: &'static str,
        change: impl Fn(&mut Measurement) + 'static,
    ) -> Self {
        Self {
            words: words.into(),
            question,
            change: Box::new(change),
        }
    }
}

const EXCHANGED: &str = "are columns exchanged?";

/// Refuses measurements that fit the description much better when columns are read in another way.
///
/// # Errors
/// An input error that says in which.
pub(super) fn check_columns(problem: &Problem) -> Result<()> {
    let given = missed(problem);
    if given < SUSPECT {
        return Ok(());
    }
    let readings = joint_readings(problem).into_iter().chain(seen_readings());
    let tried = readings.map(|reading| {
        let mut other = problem.clone();
        other.measurements.iter_mut().for_each(&reading.change);
        // What is known of the frames was learnt by the table as it was read first.
        other.values = other.parameters.iter().map(|p| p.nominal).collect();
        place_frames(&mut other);
        place_sets(&mut other);
        (reading, missed(&other), moved(&other))
    });
    let good = tried.filter(|(_, missed, _)| *missed < BETTER * given);
    let good: Vec<(Reading, f64, f64)> = good.collect();
    let least = good.iter().map(|(_, missed, _)| *missed);
    let least = least.fold(f64::INFINITY, f64::min);
    // Positions alone are the same arm elsewhere in several orders: then it is the one that has it least far away.
    let alike = good
        .iter()
        .filter(|(_, missed, _)| *missed <= ALIKE * least);
    let Some((reading, left, _)) = alike.min_by(|a, b| a.2.total_cmp(&b.2)) else {
        return Ok(());
    };
    let (given, left) = (given * 1e3, left * 1e3);
    let text = format!(
        "the measurements miss the arm by {given:.1} mm, and by {left:.1} mm {}: {}",
        reading.words, reading.question
    );
    Err(Error::input("calibration", text))
}

/// What the description misses of half of the measurements, with frames, anchors and planes as they were placed.
fn missed(problem: &Problem) -> f64 {
    let sizes = residuals(problem).into_iter();
    let sizes: Vec<f64> = sizes
        .map(|r| r.length + ARM * r.angle.unwrap_or(0.0))
        .collect();
    median(&sizes)
}

/// How far the frames were placed from where the description has them, in spreads.
fn moved(problem: &Problem) -> f64 {
    let off = problem.parameters.iter().zip(&problem.values);
    off.filter(|(parameter, _)| matches!(parameter.group, Group::Base | Group::Tool))
        .map(|(parameter, value)| (value - parameter.nominal).abs() / parameter.spread)
        .sum()
}

/// Two joints, or two motors, in the other's place.
fn joint_readings(problem: &Problem) -> Vec<Reading> {
    let variables = problem.model.chain().variables();
    let of_motors = problem
        .measurements
        .iter()
        .any(|m| matches!(m.readings, Readings::Motors(_)));
    let name = |index: usize| match of_motors {
        true => format!("motor {}", index + 1),
        false => variables[index].name.clone(),
    };
    let mut readings: Vec<Reading> = Vec::new();
    for one in 0..variables.len() {
        for other in 0..one {
            let words = format!("with {} and {} exchanged", name(other), name(one));
            readings.push(Reading::new(words, EXCHANGED, move |m| {
                m.readings.values_mut().swap(one, other);
            }));
        }
    }
    let angular: Vec<bool> = variables
        .iter()
        .map(|variable| variable.kind.is_angular())
        .collect();
    let scaled = |words: &str, question: &'static str, factor: f64| {
        let angular = angular.clone();
        Reading::new(words, question, move |m| {
            let values = m.readings.values_mut().iter_mut().zip(&angular);
            for (value, _) in values.filter(|(_, is_angular)| **is_angular) {
                *value *= factor;
            }
        })
    };
    readings.push(scaled(
        "with the joints in degrees",
        "columns in degrees are called q1_deg",
        1_f64.to_radians(),
    ));
    readings.push(scaled(
        "with the joints in radians",
        "columns in radians are called q1, without _deg",
        1_f64.to_degrees(),
    ));
    readings
}

/// Coordinates in another order, and the parts of quaternions.
fn seen_readings() -> Vec<Reading> {
    const ORDERS: [([usize; 3], &str); 5] = [
        ([1, 0, 2], "x and y"),
        ([2, 1, 0], "x and z"),
        ([0, 2, 1], "y and z"),
        ([1, 2, 0], "x, y and z (y, z, x)"),
        ([2, 0, 1], "x, y and z (z, x, y)"),
    ];
    let orders = ORDERS.map(|(order, names)| {
        Reading::new(
            format!("with {names} exchanged"),
            EXCHANGED,
            move |m| match &mut m.seen {
                Seen::Pose(pose) => {
                    let p = pose.translation.vector;
                    pose.translation.vector = order.map(|k| p[k]).into();
                }
                Seen::Position { point, .. } => *point = order.map(|k| point[k]),
                _ => {}
            },
        )
    });
    // Many programs write the scalar last.
    let scalar_last = Reading::new(
        "with the quaternions' numbers in the order x, y, z, w",
        EXCHANGED,
        |m| {
            if let Seen::Pose(pose) = &mut m.seen {
                let q = UnitQuaternion::from_rotation_matrix(&pose.rotation);
                let first = Quaternion::new(q.k, q.w, q.i, q.j);
                pose.rotation = UnitQuaternion::from_quaternion(first).to_rotation_matrix();
            }
        },
    );
    let inverse = Reading::new(
        "with every pose turned into its inverse",
        "is the camera on the tool (eye in hand)?",
        |m| {
            if let Seen::Pose(pose) = &mut m.seen {
                *pose = pose.inverse();
            }
        },
    );
    orders.into_iter().chain([scalar_last, inverse]).collect()
}
