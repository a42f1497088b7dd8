//! The packets, field by field. All numbers are little-endian; positions are micro-radians or micrometres.

use std::fmt;

use super::frame::frame;

/// The version of the protocol that this is.
pub const VERSION: u8 = 1;

/// The most motors a controller can have.
pub const AXES: usize = 12;

/// The longest name of a controller, in bytes.
const NAME: usize = 24;

/// Values of up to twelve motors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Axes {
    values: [i32; AXES],
    count: u8,
}

impl Axes {
    /// Of motor values in radians or metres. `None` for too many of them, or one that does not fit: not finite, or beyond
    /// 2147 rad.
    pub fn of(motors: &[f64]) -> Option<Self> {
        let mut axes = Self {
            count: u8::try_from(motors.len()).ok()?,
            ..Self::default()
        };
        let places = axes.values.get_mut(..motors.len())?;
        for (place, motor) in places.iter_mut().zip(motors) {
            let micro = (motor * 1e6).round();
            let fits = micro.abs() <= f64::from(i32::MAX);
            *place = fits.then_some(micro as i32)?;
        }
        Some(axes)
    }

    /// The values in micro-radians or micrometres.
    pub fn micro(&self) -> &[i32] {
        &self.values[..usize::from(self.count)]
    }

    /// The values in radians or metres, into the front of `motors`.
    pub fn read(&self, motors: &mut [f64]) {
        for (motor, &micro) in motors.iter_mut().zip(self.micro()) {
            *motor = f64::from(micro) * 1e-6;
        }
    }
}

/// What a controller does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// It shows where it is and moves nothing.
    Idle,
    /// It follows set-points of one session.
    Armed,
    /// It was stopped, by packet or by a button.
    Stopped,
    /// It stopped itself: [`State::code`] says why.
    Fault,
}

/// Why a controller stopped or refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// Nothing is wrong.
    None,
    /// No set-point and no heartbeat came in time.
    HeartbeatLost,
    /// The emergency stop is pressed.
    EmergencyStop,
    /// A set-point outside a motor's range.
    OutOfRange,
    /// A set-point farther from the last than the motor can go in a cycle.
    TooFast,
    /// A set-point older than one already taken, or late.
    Stale,
    /// A set-point of another session, or of none.
    NotArmed,
    /// A motor is not where it was sent.
    PositionLost,
    /// A number of motors that the controller does not have.
    WrongCount,
    /// A version of the protocol that the controller does not speak.
    Version,
}

impl Code {
    const ALL: [Self; 10] = [
        Self::None,
        Self::HeartbeatLost,
        Self::EmergencyStop,
        Self::OutOfRange,
        Self::TooFast,
        Self::Stale,
        Self::NotArmed,
        Self::PositionLost,
        Self::WrongCount,
        Self::Version,
    ];
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::None => "nothing is wrong",
            Self::HeartbeatLost => "the controller heard nothing for too long and stopped",
            Self::EmergencyStop => "the emergency stop is pressed",
            Self::OutOfRange => "a set-point outside the motor's range",
            Self::TooFast => "a set-point too far from the last one",
            Self::Stale => "a set-point that came late",
            Self::NotArmed => "a set-point while not armed",
            Self::PositionLost => "a motor is not where it was sent",
            Self::WrongCount => "set-points for another number of motors",
            Self::Version => "another version of the protocol",
        })
    }
}

/// What the program says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToDevice {
    /// Who are you? Answered with [`ToHost::Capabilities`]; states follow from then on.
    Hello,
    /// Take the set-points of this session. The clock of the session starts.
    Arm {
        /// The session's number.
        session: u32,
    },
    /// Be there.
    SetPoint {
        /// The session's number.
        session: u32,
        /// Milliseconds since the program armed.
        time: u32,
        /// Where.
        axes: Axes,
    },
    /// I am alive.
    Heartbeat {
        /// The session's number.
        session: u32,
        /// Milliseconds since the program armed.
        time: u32,
    },
    /// Stop at once and hold; the session is over.
    Stop,
    /// Hold; the session is over.
    Disarm,
}

/// What a controller is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Capabilities {
    /// The lowest and the highest version that it speaks.
    pub versions: [u8; 2],
    /// The time between its states, in milliseconds.
    pub period: u16,
    /// The silence after which it stops, in milliseconds.
    pub timeout: u16,
    /// Whether it measures where its motors are, rather than knowing where it sent them.
    pub measures: bool,
    /// The ends of the motors' ranges, micro-radians or micrometres.
    pub ranges: Vec<[i32; 2]>,
    /// Its name, at most 24 bytes.
    pub name: String,
}

/// Where a controller is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct State {
    /// Its own clock, in milliseconds.
    pub clock: u32,
    /// The session that it is armed for, 0 for none.
    pub session: u32,
    /// The time of the last set-point or heartbeat that it took.
    pub taken: u32,
    /// What it does.
    pub mode: Mode,
    /// Why it stopped.
    pub code: Code,
    /// Where its motors are.
    pub axes: Axes,
}

/// What a controller says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ToHost {
    /// Who it is.
    Capabilities(Capabilities),
    /// Where it is.
    State(State),
    /// It did not do what it was told.
    Refused {
        /// The sequence number of the packet that said so.
        sequence: u16,
        /// Why not.
        code: Code,
        /// The motor that it was about, counted from 0; 255 for none.
        axis: u8,
    },
}

/// Why a packet that passed its check is nevertheless none of ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Malformed {
    /// Of another version.
    Version(u8),
    /// Of a kind that is not known: skipped, so that newer controllers may say more.
    Kind(u8),
    /// Too short, too long, or a value that cannot be.
    Body(u8),
}

impl fmt::Display for Malformed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Version(version) => write!(f, "a packet of version {version}"),
            Self::Kind(kind) => write!(f, "a packet of the unknown kind 0x{kind:02x}"),
            Self::Body(kind) => write!(f, "a packet of kind 0x{kind:02x} with a wrong body"),
        }
    }
}

/// A message that goes one way or the other.
pub trait Packet: Sized {
    /// Its kind, and its body.
    fn write(&self, body: &mut Writer) -> u8;

    /// From a kind and a body. `None` for a body that does not fit, an inner `None` for a kind that does not exist.
    fn read(kind: u8, body: &mut Reader<'_>) -> Option<Option<Self>>;

    /// Appends the message as a frame.
    fn encode(&self, sequence: u16, out: &mut Vec<u8>) {
        let mut writer = Writer::default();
        writer.put(&[VERSION, 0]);
        writer.put(&sequence.to_le_bytes());
        let kind = self.write(&mut writer);
        writer.bytes[1] = kind;
        frame(&writer.bytes[..writer.length], out);
    }

    /// Takes a packet apart: its sequence number and the message.
    ///
    /// # Errors
    /// [`Malformed`]: of another version, of an unknown kind, or with a body that does not fit.
    fn decode(packet: &[u8]) -> Result<(u16, Self), Malformed> {
        let [version, kind, low, high, body @ ..] = packet else {
            return Err(Malformed::Body(packet.get(1).copied().unwrap_or(0)));
        };
        if *version != VERSION {
            return Err(Malformed::Version(*version));
        }
        let mut reader = Reader(body);
        let message = Self::read(*kind, &mut reader).ok_or(Malformed::Body(*kind))?;
        let message = message.ok_or(Malformed::Kind(*kind))?;
        match reader.0.is_empty() {
            true => Ok((u16::from_le_bytes([*low, *high]), message)),
            false => Err(Malformed::Body(*kind)),
        }
    }
}

impl Packet for ToDevice {
    fn write(&self, body: &mut Writer) -> u8 {
        match self {
            Self::Hello => 0x01,
            Self::Arm { session } => {
                body.u32(*session);
                0x02
            }
            Self::SetPoint {
                session,
                time,
                axes,
            } => {
                body.u32(*session);
                body.u32(*time);
                body.axes(axes);
                0x03
            }
            Self::Heartbeat { session, time } => {
                body.u32(*session);
                body.u32(*time);
                0x04
            }
            Self::Stop => 0x05,
            Self::Disarm => 0x06,
        }
    }

    fn read(kind: u8, body: &mut Reader<'_>) -> Option<Option<Self>> {
        Some(Some(match kind {
            0x01 => Self::Hello,
            0x02 => Self::Arm {
                session: body.u32()?,
            },
            0x03 => Self::SetPoint {
                session: body.u32()?,
                time: body.u32()?,
                axes: body.axes()?,
            },
            0x04 => Self::Heartbeat {
                session: body.u32()?,
                time: body.u32()?,
            },
            0x05 => Self::Stop,
            0x06 => Self::Disarm,
            _ => return Some(None),
        }))
    }
}

impl Packet for ToHost {
    fn write(&self, body: &mut Writer) -> u8 {
        match self {
            Self::Capabilities(of) => {
                body.put(&of.versions);
                body.u16(of.period);
                body.u16(of.timeout);
                body.put(&[u8::from(of.measures)]);
                let ranges = &of.ranges[..of.ranges.len().min(AXES)];
                body.put(&[ranges.len() as u8]);
                for end in ranges.iter().flatten() {
                    body.put(&end.to_le_bytes());
                }
                let name = of.name.as_bytes();
                body.put(&name[..name.len().min(NAME)]);
                0x81
            }
            Self::State(state) => {
                body.u32(state.clock);
                body.u32(state.session);
                body.u32(state.taken);
                body.put(&[state.mode as u8, state.code as u8]);
                body.axes(&state.axes);
                0x82
            }
            Self::Refused {
                sequence,
                code,
                axis,
            } => {
                body.u16(*sequence);
                body.put(&[*code as u8, *axis]);
                0x83
            }
        }
    }

    fn read(kind: u8, body: &mut Reader<'_>) -> Option<Option<Self>> {
        Some(Some(match kind {
            0x81 => {
                let versions = [body.u8()?, body.u8()?];
                let (period, timeout) = (body.u16()?, body.u16()?);
                let measures = body.flag()?;
                let count = body.count()?;
                let range = |body: &mut Reader<'_>| Some([body.i32()?, body.i32()?]);
                let ranges: Option<Vec<_>> = (0..count).map(|_| range(body)).collect();
                let name = body.rest();
                Self::Capabilities(Capabilities {
                    versions,
                    period,
                    timeout,
                    measures,
                    ranges: ranges?,
                    name: std::str::from_utf8(name.get(..name.len().min(NAME))?)
                        .ok()
                        .filter(|_| name.len() <= NAME)?
                        .to_owned(),
                })
            }
            0x82 => Self::State(State {
                clock: body.u32()?,
                session: body.u32()?,
                taken: body.u32()?,
                mode: body.mode()?,
                code: body.code()?,
                axes: body.axes()?,
            }),
            0x83 => Self::Refused {
                sequence: body.u16()?,
                code: body.code()?,
                axis: body.u8()?,
            },
            _ => return Some(None),
        }))
    }
}

/// A packet being written. What does not fit is left out, and then the frame's reader refuses it: no message is that long.
pub struct Writer {
    bytes: [u8; super::frame::PACKET],
    length: usize,
}

impl Default for Writer {
    fn default() -> Self {
        Self {
            bytes: [0; super::frame::PACKET],
            length: 0,
        }
    }
}

impl Writer {
    fn put(&mut self, bytes: &[u8]) {
        if let Some(place) = self.bytes.get_mut(self.length..self.length + bytes.len()) {
            place.copy_from_slice(bytes);
            self.length += bytes.len();
        }
    }

    fn u16(&mut self, value: u16) {
        self.put(&value.to_le_bytes());
    }

    fn u32(&mut self, value: u32) {
        self.put(&value.to_le_bytes());
    }

    fn axes(&mut self, axes: &Axes) {
        self.put(&[axes.count]);
        for micro in axes.micro() {
            self.put(&micro.to_le_bytes());
        }
    }
}

/// A packet being read, from the front.
pub struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (front, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*front)
    }

    fn rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.0)
    }

    fn u8(&mut self) -> Option<u8> {
        self.take::<1>().map(|[byte]| byte)
    }

    fn u16(&mut self) -> Option<u16> {
        self.take().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn i32(&mut self) -> Option<i32> {
        self.take().map(i32::from_le_bytes)
    }

    fn flag(&mut self) -> Option<bool> {
        match self.u8()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    fn count(&mut self) -> Option<usize> {
        let count = usize::from(self.u8()?);
        (count <= AXES).then_some(count)
    }

    fn axes(&mut self) -> Option<Axes> {
        let count = self.count()?;
        let mut axes = Axes {
            count: count as u8,
            ..Axes::default()
        };
        for place in &mut axes.values[..count] {
            *place = self.i32()?;
        }
        Some(axes)
    }

    fn mode(&mut self) -> Option<Mode> {
        let modes = [Mode::Idle, Mode::Armed, Mode::Stopped, Mode::Fault];
        modes.get(usize::from(self.u8()?)).copied()
    }

    fn code(&mut self) -> Option<Code> {
        Code::ALL.get(usize::from(self.u8()?)).copied()
    }
}
