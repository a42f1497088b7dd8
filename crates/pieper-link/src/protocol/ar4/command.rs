//! The commands that are used, both ways: written by the host, read by the simulator.

use std::io::Write as _;

use super::{AXES, JOINT_TAGS, JOINTS};

/// A joint move, `RJ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// J1 to J9, degrees or millimetres.
    pub joints: [f64; AXES],
    /// For the whole move.
    pub seconds: f64,
}

/// A command of the firmware.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// `RP`: where are you?
    Position,
    /// `LL`: drive these of J1 to J9 to their switches.
    Home([bool; AXES]),
    /// `RJ`: go there, every joint on its own way, all together.
    Joints(Move),
}

/// The share of a move spent speeding up and slowing down, in percent, as the desktop program's default.
const RAMPS: &str = "Ac10Dc10Rm80";

impl Command {
    /// Appends the command as a line. Joints have three decimals and external axes two, as in the firmware's own replies.
    pub fn write(&self, out: &mut Vec<u8>) {
        // Writing to a vector cannot fail.
        let _ = match self {
            Self::Position => writeln!(out, "RP"),
            Self::Home(axes) => {
                // The letters go on: A to I choose axes, J to R are offsets, which are the robot's own settings.
                out.extend_from_slice(b"LL");
                for (letter, homes) in (b'A'..).zip(axes) {
                    out.extend_from_slice(&[letter, if *homes { b'1' } else { b'0' }]);
                }
                for letter in (b'A' + AXES as u8..).take(AXES) {
                    out.extend_from_slice(&[letter, b'0']);
                }
                writeln!(out)
            }
            Self::Joints(to) => {
                out.extend_from_slice(b"RJ");
                for (axis, (tag, value)) in JOINT_TAGS.iter().zip(to.joints).enumerate() {
                    let decimals = if axis < JOINTS { 3 } else { 2 };
                    let _ = write!(out, "{tag}{value:.decimals$}");
                }
                let seconds = to.seconds;
                writeln!(out, "Ss{seconds:.3}{RAMPS}WNLm000000")
            }
        };
    }

    /// Reads a line. `None` for a command that is not one of these, or not well-formed.
    ///
    /// ```
    /// use pieper_link::protocol::ar4::Command;
    /// let line = "RJA0.000B0.000C0.000D0.000E90.000F0.000J70.00J80.00J90.00Ss2.000Ac10Dc10Rm80WNLm000000";
    /// let Some(Command::Joints(to)) = Command::read(line) else { panic!() };
    /// assert_eq!((to.joints[4], to.seconds), (90.0, 2.0));
    /// let mut bytes = Vec::new();
    /// Command::Joints(to).write(&mut bytes);
    /// assert_eq!(bytes, format!("{line}\n").as_bytes());
    /// ```
    pub fn read(line: &str) -> Option<Self> {
        if line == "RP" {
            return Some(Self::Position);
        }
        if let Some(rest) = line.strip_prefix("LL") {
            return home(rest).map(Self::Home);
        }
        let mut rest = line.strip_prefix("RJ")?;
        let mut joints = [0.0; AXES];
        for (tag, joint) in JOINT_TAGS.iter().zip(&mut joints) {
            rest = rest.strip_prefix(tag)?;
            let next = rest.find(|c: char| c.is_ascii_uppercase())?;
            *joint = number(&rest[..next])?;
            rest = &rest[next..];
        }
        let rest = rest.strip_prefix("Ss")?;
        let (seconds, rest) = rest.split_once("Ac")?;
        let (_, wrist) = rest.split_once('W')?;
        wrist.split_once("Lm")?;
        let seconds = number(seconds).filter(|&seconds| seconds >= 0.0)?;
        Some(Self::Joints(Move { joints, seconds }))
    }
}

/// What follows `LL`: nine axes, nine offsets.
fn home(mut rest: &str) -> Option<[bool; AXES]> {
    let mut axes = [false; AXES];
    for (letter, axis) in ('A'..).zip(&mut axes) {
        let flag = rest.strip_prefix(letter)?;
        *axis = match flag.get(..1)? {
            "0" => false,
            "1" => true,
            _ => return None,
        };
        rest = &flag[1..];
    }
    for letter in ('A'..).skip(AXES).take(AXES) {
        rest = rest.strip_prefix(letter)?;
        let next = rest.find(|c: char| c.is_ascii_uppercase());
        let (offset, after) = rest.split_at(next.unwrap_or(rest.len()));
        number(offset)?;
        rest = after;
    }
    rest.is_empty().then_some(axes)
}

/// A finite decimal number.
pub(super) fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}
