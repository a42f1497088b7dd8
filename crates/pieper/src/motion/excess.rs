//! Where a motion asks for more than the joints allow.

use super::law::Law;
use crate::model::{Chain, Limits};

/// What a joint is limited in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// Its value.
    Position,
    /// Its rate.
    Rate,
    /// Its acceleration.
    Acceleration,
}

/// A joint that leaves its limits, where it does so most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excess {
    /// Index of the variable.
    pub joint: usize,
    /// In what.
    pub limited: Limited,
    /// The value farthest outside.
    pub value: f64,
    /// The limit it should have kept.
    pub limit: f64,
    /// The time of the row where that is; for rates and accelerations, of the row where the move begins.
    pub time: f64,
    /// How many rows, or moves, are outside.
    pub count: usize,
}

/// Every limit that the motion exceeds, joint by joint.
///
/// Exact: between two rows every value lies between theirs, and the largest rate and acceleration of a move follow
/// from its profile. Accelerations of motions whose rates jump are not looked at.
pub fn excesses(law: &Law, chain: &Chain) -> Vec<Excess> {
    let mut found = Vec::new();
    for (joint, variable) in chain.variables().iter().enumerate() {
        if let Some(limits) = variable.limits {
            found.extend(position(law, joint, limits));
        }
        if let Some(limit) = variable.velocity {
            found.extend(derivative(law, joint, Limited::Rate, limit));
        }
        if let Some(limit) = variable.acceleration {
            found.extend(derivative(law, joint, Limited::Acceleration, limit));
        }
    }
    found
}

/// The widest of several excesses of one kind, and how many they are.
fn widest(excesses: impl Iterator<Item = Excess>) -> Option<Excess> {
    let beyond = |excess: &Excess| (excess.value - excess.limit).abs();
    excesses.fold(None, |worst: Option<Excess>, next| {
        let Some(worst) = worst else {
            return Some(next);
        };
        let count = worst.count + 1;
        let kept = if beyond(&next) > beyond(&worst) {
            next
        } else {
            worst
        };
        Some(Excess { count, ..kept })
    })
}

fn position(law: &Law, joint: usize, limits: Limits) -> Option<Excess> {
    let rows = law.times().iter().zip(law.rows());
    let outside = rows.filter(|(_, row)| !limits.contains(row[joint]));
    widest(outside.map(|(&time, row)| {
        let value = row[joint];
        Excess {
            joint,
            limited: Limited::Position,
            value,
            limit: if value > limits.upper() {
                limits.upper()
            } else {
                limits.lower()
            },
            time,
            count: 1,
        }
    }))
}

/// A rate or an acceleration beyond this multiple of its limit is outside: rounding is not.
const ROUNDING: f64 = 1.0 + 1e-12;

fn derivative(law: &Law, joint: usize, limited: Limited, limit: f64) -> Option<Excess> {
    let (peak, order) = match limited {
        Limited::Position => return None,
        Limited::Rate => (law.profile().peak_rate(), 1),
        Limited::Acceleration => (law.profile().peak_acceleration()?, 2),
    };
    let moves = law.times().windows(2).zip(law.rows().windows(2));
    let peaks = moves.map(|(times, rows)| {
        let way = (rows[1][joint] - rows[0][joint]).abs();
        Excess {
            joint,
            limited,
            value: way * peak / (times[1] - times[0]).powi(order),
            limit,
            time: times[0],
            count: 1,
        }
    });
    widest(peaks.filter(|excess| excess.value > limit * ROUNDING))
}
