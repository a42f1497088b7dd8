//! Bad weather: what goes wrong on demand.

use std::fmt;
use std::str::FromStr;

/// Something that goes wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Bits of the next messages are flipped.
    Corrupt,
    /// The next messages are cut short.
    Truncate,
    /// The next messages come twice.
    Duplicate,
    /// The next messages come in another order.
    Reorder,
    /// A flood of bytes that mean nothing.
    Flood,
    /// The controller falls silent.
    Mute,
    /// The cable is pulled.
    Unplug,
    /// The controller restarts.
    Reset,
    /// Somebody presses the emergency stop.
    EmergencyStop,
    /// The first motor loses steps, or is pushed.
    LoseSteps,
    /// The controller's clock jumps.
    ClockJump,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Corrupt,
        Self::Truncate,
        Self::Duplicate,
        Self::Reorder,
        Self::Flood,
        Self::Mute,
        Self::Unplug,
        Self::Reset,
        Self::EmergencyStop,
        Self::LoseSteps,
        Self::ClockJump,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Corrupt => "corrupt",
            Self::Truncate => "truncate",
            Self::Duplicate => "duplicate",
            Self::Reorder => "reorder",
            Self::Flood => "flood",
            Self::Mute => "mute",
            Self::Unplug => "unplug",
            Self::Reset => "reset",
            Self::EmergencyStop => "estop",
            Self::LoseSteps => "lose-steps",
            Self::ClockJump => "clock-jump",
        }
    }

    /// Whether it is the wire's, not the controller's own.
    pub fn is_of_wire(self) -> bool {
        matches!(
            self,
            Self::Corrupt
                | Self::Truncate
                | Self::Duplicate
                | Self::Reorder
                | Self::Flood
                | Self::Mute
                | Self::Unplug
        )
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|fault| fault.name() == text);
        found.ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|fault| fault.name()).collect();
            format!("{text}: one of {} was expected", names.join(", "))
        })
    }
}

/// How many messages a fault of the wire spoils.
const MESSAGES: u32 = 10;

/// The wire, and what it does to messages on their way to the program.
#[derive(Debug, Default)]
pub struct Weather {
    fault: Option<(Fault, u32)>,
    held: Vec<u8>,
    seed: u64,
    is_mute: bool,
}

impl Weather {
    /// From now on, this goes wrong.
    pub fn inject(&mut self, fault: Fault) {
        match fault {
            Fault::Mute => self.is_mute = true,
            _ => self.fault = Some((fault, MESSAGES)),
        }
    }

    /// A message passes: what arrives of it.
    pub fn pass(&mut self, message: &[u8], out: &mut Vec<u8>) {
        if self.is_mute || message.is_empty() {
            return;
        }
        let Some((fault, left)) = self.fault else {
            out.extend_from_slice(message);
            return;
        };
        self.fault = (left > 1).then_some((fault, left - 1));
        let begin = out.len();
        match fault {
            Fault::Corrupt => {
                out.extend_from_slice(message);
                let place = begin + self.random(message.len());
                out[place] ^= 1 << self.random(8);
            }
            Fault::Truncate => {
                let kept = self.random(message.len());
                out.extend_from_slice(&message[..kept]);
            }
            Fault::Duplicate => {
                out.extend_from_slice(message);
                out.extend_from_slice(message);
            }
            Fault::Reorder => match self.held.is_empty() {
                true => self.held.extend_from_slice(message),
                false => {
                    out.extend_from_slice(message);
                    out.append(&mut self.held);
                }
            },
            Fault::Flood => {
                for _ in 0..2000 {
                    let byte = self.random(256) as u8;
                    out.push(byte);
                }
                out.extend_from_slice(message);
            }
            _ => out.extend_from_slice(message),
        }
        // What was held back comes at the latest when the weather clears.
        if self.fault.is_none() {
            out.append(&mut self.held);
        }
    }

    /// A number below `end`, the same in every run.
    fn random(&mut self, end: usize) -> usize {
        self.seed = self
            .seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.seed >> 33) as usize) % end.max(1)
    }
}
