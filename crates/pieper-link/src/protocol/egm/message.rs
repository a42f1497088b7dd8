//! The messages, as far as they are used; fields of newer versions are skipped.

use super::JOINTS;
use super::wire::{Fields, Value, double, doubles, nested, number};

/// What a message is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MessageKind {
    /// Not told.
    #[default]
    Undefined,
    /// A command.
    Command,
    /// From the robot.
    Data,
    /// From us: a position.
    Correction,
    /// From us: a correction of a path.
    PathCorrection,
}

/// `EgmHeader`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// Counts messages.
    pub sequence: u32,
    /// Milliseconds of the sender's clock.
    pub time: u32,
    /// What the message is for.
    pub kind: MessageKind,
}

/// `EgmJoints`: degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joints {
    values: [f64; JOINTS],
    count: usize,
}

impl Joints {
    /// Of values in degrees; what is more than twelve is left out.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Self {
        let mut joints = Self::default();
        for (place, value) in joints.values.iter_mut().zip(values) {
            *place = value;
            joints.count += 1;
        }
        joints
    }

    /// The values in degrees.
    pub fn degrees(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

/// `EgmPose`: millimetres, and a quaternion with the scalar first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose {
    /// x, y, z in millimetres.
    pub position: Option<[f64; 3]>,
    /// u0 (the scalar), u1, u2, u3.
    pub quaternion: Option<[f64; 4]>,
    /// Angles about x, y, z in degrees; they win over the quaternion.
    pub euler: Option<[f64; 3]>,
}

/// `EgmClock`: since 1970.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clock {
    /// Seconds.
    pub seconds: u64,
    /// And microseconds.
    pub micros: u64,
}

/// `EgmPlanned` and `EgmFeedBack`, which are alike in numbers and types.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Planned {
    /// The arm's joints.
    pub joints: Option<Joints>,
    /// The tool.
    pub pose: Option<Pose>,
    /// External axes; the seventh joint of a seven-axis arm is the first of them.
    pub externals: Option<Joints>,
    /// When.
    pub clock: Option<Clock>,
}

/// `EgmMotorState`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motors {
    /// Not told.
    #[default]
    Undefined,
    /// On.
    On,
    /// Off.
    Off,
}

/// `EgmMCIState`: the motion controller's interface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Running {
    /// Not told.
    #[default]
    Undefined,
    /// It has failed.
    Error,
    /// It takes no positions.
    Stopped,
    /// It takes positions.
    Running,
}

/// `EgmRapidCtrlExecState`: the controller's own program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rapid {
    /// Not told.
    #[default]
    Undefined,
    /// It stands.
    Stopped,
    /// It runs.
    Running,
}

/// `EgmRobot`: from the controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Robot {
    /// Count, clock, kind.
    pub header: Header,
    /// Where the arm is.
    pub feedback: Option<Planned>,
    /// Where the controller wants it to be.
    pub planned: Option<Planned>,
    /// The motors.
    pub motors: Motors,
    /// The motion controller.
    pub running: Running,
    /// Whether the arm has arrived.
    pub has_converged: bool,
    /// The controller's own program.
    pub rapid: Rapid,
    /// How much of what it can the arm is asked for, in percent.
    pub utilization: Option<f64>,
}

/// `EgmSensor`: to the controller.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sensor {
    /// Count, clock, kind.
    pub header: Header,
    /// Where the arm is to be.
    pub planned: Option<Planned>,
    /// The joints' rates in degrees per second, for controllers with `\PosCorrGain` 0.
    pub speeds: Option<Joints>,
}

/// A small whole number, as one of these.
fn one_of<T: Copy>(value: Value<'_>, all: &[T]) -> Option<T> {
    match value {
        // What newer versions add is none of these: as if it had not been told.
        Value::Varint(index) => all
            .get(usize::try_from(index).ok()?)
            .or(all.first())
            .copied(),
        _ => None,
    }
}

fn whole(value: Value<'_>) -> Option<u64> {
    match value {
        Value::Varint(value) => Some(value),
        _ => None,
    }
}

fn inner(value: Value<'_>) -> Option<&[u8]> {
    match value {
        Value::Bytes(bytes) => Some(bytes),
        _ => None,
    }
}

/// Reads every field of a message. `None` where one is broken, or `take` does not like it.
fn each<'a>(bytes: &'a [u8], mut take: impl FnMut(u32, Value<'a>) -> Option<()>) -> Option<()> {
    let mut fields = Fields::of(bytes);
    for (field, value) in fields.by_ref() {
        take(field, value)?;
    }
    (!fields.is_broken()).then_some(())
}

const KINDS: [MessageKind; 5] = [
    MessageKind::Undefined,
    MessageKind::Command,
    MessageKind::Data,
    MessageKind::Correction,
    MessageKind::PathCorrection,
];
const MOTORS: [Motors; 3] = [Motors::Undefined, Motors::On, Motors::Off];
const RUNNING: [Running; 4] = [
    Running::Undefined,
    Running::Error,
    Running::Stopped,
    Running::Running,
];
const RAPID: [Rapid; 3] = [Rapid::Undefined, Rapid::Stopped, Rapid::Running];

impl Header {
    fn read(bytes: &[u8]) -> Option<Self> {
        let mut header = Self::default();
        each(bytes, |field, value| {
            match field {
                1 => header.sequence = whole(value)? as u32,
                2 => header.time = whole(value)? as u32,
                3 => header.kind = one_of(value, &KINDS)?,
                _ => {}
            }
            Some(())
        })?;
        Some(header)
    }

    fn write(&self, out: &mut Vec<u8>) {
        nested(1, out, |out| {
            number(1, u64::from(self.sequence), out);
            number(2, u64::from(self.time), out);
            number(3, self.kind as u64, out);
        });
    }
}

impl Joints {
    fn read(bytes: &[u8]) -> Option<Self> {
        let mut joints = Self::default();
        each(bytes, |field, value| match field {
            1 => doubles(value, &mut joints.values, &mut joints.count),
            _ => Some(()),
        })?;
        Some(joints)
    }

    fn write(&self, field: u32, out: &mut Vec<u8>) {
        nested(field, out, |out| {
            for degrees in self.degrees() {
                double(1, *degrees, out);
            }
        });
    }
}

/// A message of required doubles numbered from 1.
fn required<const N: usize>(bytes: &[u8]) -> Option<[f64; N]> {
    let mut values = [None; N];
    each(bytes, |field, value| {
        if let Some(place) = values.get_mut((field - 1) as usize) {
            let Value::Double(value) = value else {
                return None;
            };
            *place = Some(value);
        }
        Some(())
    })?;
    let mut all = [0.0; N];
    for (place, value) in all.iter_mut().zip(values) {
        *place = value?;
    }
    Some(all)
}

fn write_required(field: u32, values: &[f64], out: &mut Vec<u8>) {
    nested(field, out, |out| {
        for (index, value) in (1..).zip(values) {
            double(index, *value, out);
        }
    });
}

impl Pose {
    fn read(bytes: &[u8]) -> Option<Self> {
        let mut pose = Self::default();
        each(bytes, |field, value| {
            match field {
                1 => pose.position = Some(required(inner(value)?)?),
                2 => pose.quaternion = Some(required(inner(value)?)?),
                3 => pose.euler = Some(required(inner(value)?)?),
                _ => {}
            }
            Some(())
        })?;
        Some(pose)
    }

    fn write(&self, field: u32, out: &mut Vec<u8>) {
        nested(field, out, |out| {
            if let Some(position) = &self.position {
                write_required(1, position, out);
            }
            if let Some(quaternion) = &self.quaternion {
                write_required(2, quaternion, out);
            }
            if let Some(euler) = &self.euler {
                write_required(3, euler, out);
            }
        });
    }
}

impl Clock {
    fn read(bytes: &[u8]) -> Option<Self> {
        let (mut seconds, mut micros) = (None, None);
        each(bytes, |field, value| {
            match field {
                1 => seconds = Some(whole(value)?),
                2 => micros = Some(whole(value)?),
                _ => {}
            }
            Some(())
        })?;
        Some(Self {
            seconds: seconds?,
            micros: micros?,
        })
    }
}

impl Planned {
    fn read(bytes: &[u8]) -> Option<Self> {
        let mut planned = Self::default();
        each(bytes, |field, value| {
            match field {
                1 => planned.joints = Some(Joints::read(inner(value)?)?),
                2 => planned.pose = Some(Pose::read(inner(value)?)?),
                3 => planned.externals = Some(Joints::read(inner(value)?)?),
                4 => planned.clock = Some(Clock::read(inner(value)?)?),
                _ => {}
            }
            Some(())
        })?;
        Some(planned)
    }

    fn write(&self, field: u32, out: &mut Vec<u8>) {
        nested(field, out, |out| {
            if let Some(joints) = &self.joints {
                joints.write(1, out);
            }
            if let Some(pose) = &self.pose {
                pose.write(2, out);
            }
            if let Some(externals) = &self.externals {
                externals.write(3, out);
            }
            if let Some(clock) = &self.clock {
                nested(4, out, |out| {
                    number(1, clock.seconds, out);
                    number(2, clock.micros, out);
                });
            }
        });
    }
}

/// A nested message that holds one enumeration, field 1, which is required.
fn state<T: Copy>(value: Value<'_>, all: &[T]) -> Option<T> {
    let mut state = None;
    each(inner(value)?, |field, value| {
        if field == 1 {
            state = Some(one_of(value, all)?);
        }
        Some(())
    })?;
    state
}

impl Robot {
    /// Reads a datagram. `None` where it is no such message.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let mut robot = Self::default();
        let mut has_header = false;
        each(bytes, |field, value| {
            match field {
                1 => {
                    robot.header = Header::read(inner(value)?)?;
                    has_header = true;
                }
                2 => robot.feedback = Some(Planned::read(inner(value)?)?),
                3 => robot.planned = Some(Planned::read(inner(value)?)?),
                4 => robot.motors = state(value, &MOTORS)?,
                5 => robot.running = state(value, &RUNNING)?,
                6 => robot.has_converged = whole(value)? != 0,
                8 => robot.rapid = state(value, &RAPID)?,
                10 => {
                    let Value::Double(share) = value else {
                        return None;
                    };
                    robot.utilization = Some(share);
                }
                _ => {}
            }
            Some(())
        })?;
        has_header.then_some(robot)
    }

    /// Appends the datagram.
    pub fn write(&self, out: &mut Vec<u8>) {
        self.header.write(out);
        if let Some(feedback) = &self.feedback {
            feedback.write(2, out);
        }
        if let Some(planned) = &self.planned {
            planned.write(3, out);
        }
        nested(4, out, |out| number(1, self.motors as u64, out));
        nested(5, out, |out| number(1, self.running as u64, out));
        number(6, u64::from(self.has_converged), out);
        nested(8, out, |out| number(1, self.rapid as u64, out));
        if let Some(share) = self.utilization {
            double(10, share, out);
        }
    }
}

impl Sensor {
    /// Reads a datagram. `None` where it is no such message.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let mut sensor = Self::default();
        let mut has_header = false;
        each(bytes, |field, value| {
            match field {
                1 => {
                    sensor.header = Header::read(inner(value)?)?;
                    has_header = true;
                }
                2 => sensor.planned = Some(Planned::read(inner(value)?)?),
                3 => each(inner(value)?, |field, value| {
                    if field == 1 {
                        sensor.speeds = Some(Joints::read(inner(value)?)?);
                    }
                    Some(())
                })?,
                _ => {}
            }
            Some(())
        })?;
        has_header.then_some(sensor)
    }

    /// Appends the datagram.
    pub fn write(&self, out: &mut Vec<u8>) {
        self.header.write(out);
        if let Some(planned) = &self.planned {
            planned.write(2, out);
        }
        if let Some(speeds) = &self.speeds {
            nested(3, out, |out| speeds.write(1, out));
        }
    }
}
