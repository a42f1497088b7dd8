//! Limits that a motion exceeds, as sentences.

use pieper::model::{Chain, Variable};
use pieper::motion::{Excess, Limited};

use super::names;

/// One sentence for each excess.
pub(super) fn sentences(excesses: &[Excess], chain: &Chain) -> Vec<String> {
    let variable = |excess: &Excess| &chain.variables()[excess.joint];
    excesses
        .iter()
        .map(|excess| sentence(excess, variable(excess)))
        .collect()
}

fn sentence(excess: &Excess, variable: &Variable) -> String {
    let (what, unit) = match (excess.limited, variable.kind.is_angular()) {
        (Limited::Position, true) => ("", "°"),
        (Limited::Position, false) => ("", " mm"),
        (Limited::Rate, true) => ("the rate of ", " °/s"),
        (Limited::Rate, false) => ("the rate of ", " mm/s"),
        (Limited::Acceleration, true) => ("the acceleration of ", " °/s²"),
        (Limited::Acceleration, false) => ("the acceleration of ", " mm/s²"),
    };
    let shown = |value: f64| {
        let value = match variable.kind.is_angular() {
            true => value.to_degrees(),
            false => value * 1000.0,
        };
        format!("{}{unit}", names::trimmed(value, 3))
    };
    let (name, time) = (&variable.name, names::trimmed(excess.time, 3));
    let (value, limit) = (shown(excess.value), shown(excess.limit));
    let (verb, when) = match excess.limited {
        Limited::Position => ("is", format!("at t = {time} s")),
        _ => (
            "gets to",
            format!("in the move that begins at t = {time} s"),
        ),
    };
    let others = match (excess.count, excess.limited) {
        (1, _) => String::new(),
        (count, Limited::Position) => format!("; {count} rows are outside"),
        (count, _) => format!("; {count} moves are outside"),
    };
    format!("{what}{name} {verb} {value} {when}, its limit is {limit}{others}")
}
