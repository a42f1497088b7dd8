//! Replies, both ways: read by the host, written by the simulator.

use std::fmt::Write as _;

use super::command::number;
use super::{AXES, JOINTS};

/// A reply to a move or a question.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// Where the arm is.
    Position(Position),
    /// Nothing moved.
    Refused(Refusal),
}

/// The position reply.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Position {
    /// J1 to J9, degrees or millimetres.
    pub joints: [f64; AXES],
    /// The tool as the firmware computes it: X, Y, Z in millimetres, Rz, Ry, Rx in degrees.
    pub tool: [f64; 6],
    /// The speed that was asked for was not reached.
    pub was_slower: bool,
    /// Joints whose encoder and step count differ.
    pub collided: [bool; JOINTS],
    /// The emergency stop is pressed.
    pub is_stopped: bool,
}

/// Why nothing moved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// These axes would exceed their limits.
    Limit([bool; AXES]),
    /// The pose is out of reach.
    Unreachable,
    /// A limit switch was not found.
    Switch(char),
    /// Another error, as the firmware wrote it.
    Other(String),
}

impl Refusal {
    /// In words.
    pub fn sentence(&self) -> String {
        match self {
            Self::Limit(axes) => {
                let named = axes.iter().enumerate().filter(|(_, beyond)| **beyond);
                let names: Vec<_> = named.map(|(axis, _)| format!("J{}", axis + 1)).collect();
                format!(
                    "the controller refused: {} would exceed its limit there",
                    names.join(", ")
                )
            }
            Self::Unreachable => "the controller refused: it cannot reach that pose".to_owned(),
            Self::Switch(axis) => {
                format!("the controller's calibration found no limit switch on J{axis}")
            }
            Self::Other(text) => format!("the controller refused: {text}"),
        }
    }
}

/// The tags of a position reply up to the debug text.
const TAGS: [char; 12] = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H', 'I', 'J', 'K', 'L'];

impl Reply {
    /// Reads a line. `None` for what is no such reply, a damaged one included: there is no checksum, so every tag must be in its
    /// place and every number be one.
    pub fn read(line: &str) -> Option<Self> {
        match line.strip_prefix('E') {
            Some(error) => refusal(error).map(Self::Refused),
            None => position(line).map(Self::Position),
        }
    }

    /// The line, without its end.
    pub fn write(&self) -> String {
        match self {
            Self::Refused(refusal) => match refusal {
                Refusal::Limit(axes) => format!("EL{}", digits(axes)),
                Refusal::Unreachable => "ER".to_owned(),
                Refusal::Switch(axis) => format!("EA{axis}"),
                Refusal::Other(text) => text.clone(),
            },
            Self::Position(at) => {
                let mut line = String::new();
                let values = at.joints[..JOINTS].iter().chain(&at.tool);
                for (tag, value) in TAGS.iter().zip(values) {
                    let _ = write!(line, "{tag}{value:.3}");
                }
                let flag = match (at.is_stopped, at.collided.contains(&true)) {
                    (true, _) => "EB".to_owned(),
                    (_, true) => format!("EC{}", digits(&at.collided)),
                    _ => String::new(),
                };
                let [.., j7, j8, j9] = at.joints;
                let slower = u8::from(at.was_slower);
                let _ = write!(line, "M{slower}NO{flag}P{j7:.2}Q{j8:.2}R{j9:.2}");
                line
            }
        }
    }
}

fn digits(flags: &[bool]) -> String {
    flags.iter().map(|&on| if on { '1' } else { '0' }).collect()
}

/// Digits 0 and 1, as flags; as many as there are, at most `N`.
fn flags<const N: usize>(text: &str) -> Option<[bool; N]> {
    let mut flags = [false; N];
    if text.is_empty() || text.len() > N {
        return None;
    }
    for (flag, digit) in flags.iter_mut().zip(text.chars()) {
        *flag = match digit {
            '0' => false,
            '1' => true,
            _ => return None,
        };
    }
    Some(flags)
}

fn refusal(error: &str) -> Option<Refusal> {
    let mut letters = error.chars();
    Some(match letters.next()? {
        'L' => Refusal::Limit(flags(letters.as_str())?),
        'R' if letters.as_str().is_empty() => Refusal::Unreachable,
        'A' => Refusal::Switch(letters.next().filter(char::is_ascii_digit)?),
        'S' | 'G' | 'B' | 'C' => Refusal::Other(format!("E{error}")),
        _ => return None,
    })
}

fn position(line: &str) -> Option<Position> {
    let mut at = Position::default();
    let mut rest = line.strip_prefix('A')?;
    let ends = TAGS.iter().skip(1).chain(&['M']);
    for (index, &end) in ends.enumerate() {
        let (value, after) = rest.split_once(end)?;
        let value = number(value)?;
        match index {
            0..JOINTS => at.joints[index] = value,
            _ => at.tool[index - JOINTS] = value,
        }
        rest = after;
    }
    let (slower, rest) = rest.split_once('N')?;
    at.was_slower = flags::<1>(slower)?[0];
    // The flag may hold letters of its own: from the first O to the last P.
    let (_, rest) = rest.split_once('O')?;
    let (flag, externals) = rest.rsplit_once('P')?;
    match flag.strip_prefix("EC") {
        Some(joints) => at.collided = flags(joints)?,
        None => {
            at.is_stopped = match flag {
                "" => false,
                "EB" => true,
                _ => return None,
            }
        }
    }
    let (j7, rest) = externals.split_once('Q')?;
    let (j8, j9) = rest.split_once('R')?;
    for (place, text) in at.joints[JOINTS..].iter_mut().zip([j7, j8, j9]) {
        *place = number(text)?;
    }
    Some(at)
}
