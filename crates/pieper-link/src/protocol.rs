//! What controllers speak, from the program's side: bytes in, events out, no sockets inside.

pub mod ar3;
pub mod ar4;
pub mod egm;
mod lines;
pub mod packets;
pub mod ros;
pub mod servo;

pub use lines::Lines;

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

use crate::arm::{Arm, MotorOf};

/// The protocols.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Our own state packets, for small controllers.
    Packets,
    /// Annin AR4, firmware 4.x (dialect A).
    Ar4,
    /// Annin AR3 (dialect B).
    Ar3,
    /// The firmware of the AR4's ROS driver (dialect C).
    Ros,
    /// The I/O board with hobby servos (dialect D).
    Servo,
    /// ABB Externally Guided Motion.
    Egm,
}

impl Kind {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Ar4,
        Self::Ar3,
        Self::Ros,
        Self::Servo,
        Self::Egm,
        Self::Packets,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Packets => "packets",
            Self::Ar4 => "ar4",
            Self::Ar3 => "ar3",
            Self::Ros => "ros",
            Self::Servo => "servo",
            Self::Egm => "egm",
        }
    }

    /// In a line, what it is.
    pub fn summary(self) -> &'static str {
        match self {
            Self::Packets => "state packets of our own, for small controllers (firmware/)",
            Self::Ar4 => "Annin AR4, firmware 4.x: serial, one move at a time",
            Self::Ar3 => "Annin AR3: serial, motor steps, one move at a time",
            Self::Ros => "AR4 with the firmware of its ROS driver: serial, set-points",
            Self::Servo => "I/O board with hobby servos: serial, whole degrees",
            Self::Egm => "ABB Externally Guided Motion: UDP, 250 Hz, the controller calls",
        }
    }

    /// The rate that its serial line is set to.
    pub fn baud(self) -> u32 {
        match self {
            Self::Ar4 => 9600,
            _ => 115_200,
        }
    }

    /// The built-in robot that a controller of this kind drives, or is tried with.
    pub fn robot(self) -> &'static str {
        match self {
            Self::Ar4 | Self::Ros => "ar4",
            Self::Ar3 => "ar3-annin",
            Self::Egm => "irb120",
            // The ABB paper's arm: six servos, and a four-bar linkage.
            Self::Packets | Self::Servo => "abb-paper",
        }
    }

    /// The program's side of a conversation with such a controller.
    ///
    /// # Errors
    /// A sentence where the protocol cannot carry this arm: too many motors, or one that slides where only angles are spoken.
    pub fn host(self, setup: Setup) -> Result<Box<dyn Host>, String> {
        let (least, most) = match self {
            Self::Packets => (1, packets::AXES),
            Self::Ar4 => (1, ar4::AXES),
            Self::Ar3 | Self::Ros => (6, 6),
            Self::Servo => (1, servo::SERVOS),
            Self::Egm => (6, 7),
        };
        let count = setup.motors.len();
        if !(least..=most).contains(&count) {
            let wanted = match least == most {
                true => format!("{most}"),
                false => format!("{least} to {most}"),
            };
            return Err(format!(
                "the protocol {self} carries {wanted} motors, this arm has {count}"
            ));
        }
        let only_angles = matches!(self, Self::Ar3 | Self::Ros | Self::Servo | Self::Egm);
        if let Some(sliding) = setup.motors.iter().find(|motor| !motor.is_angle)
            && only_angles
        {
            return Err(format!(
                "the protocol {self} carries angles only, motor {} of this arm slides",
                sliding.name
            ));
        }
        Ok(match self {
            Self::Packets => Box::new(packets::PacketHost::new(setup)),
            Self::Ar4 => Box::new(ar4::Ar4Host::new(setup)),
            Self::Ar3 => Box::new(ar3::Ar3Host::new(setup)),
            Self::Ros => Box::new(ros::RosHost::new(setup)),
            Self::Servo => Box::new(servo::ServoHost::new(setup)),
            Self::Egm => Box::new(egm::EgmHost::new(setup)),
        })
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Kind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|kind| kind.name() == text);
        found.ok_or_else(|| {
            let names: Vec<_> = Self::ALL.iter().map(|kind| kind.name()).collect();
            format!("{text}: one of {} was expected", names.join(", "))
        })
    }
}

/// What a host is made from.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The motors whose values go over the wire.
    pub motors: Vec<MotorOf>,
    /// EGM: send the tool's pose instead of the joints, of this arm.
    pub poses_of: Option<Arc<Arm>>,
    /// A number that differs from one connection to the next, so that nothing left over from an earlier one is taken up.
    pub nonce: u32,
}

/// How a controller wants to be driven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// A set-point every so often.
    Every(Duration),
    /// One in answer to every state that the controller sends, which is expected this often.
    Answer(Duration),
    /// Whole moves, from rest to rest, each after the one before has ended, and none longer than this: a stop takes effect
    /// when the move under way has ended.
    Moves(Duration),
}

/// What came from a controller.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// It has said who it is.
    Identified(String),
    /// It has told where its motors are: [`Host::measured`].
    Measured,
    /// It takes set-points from now on.
    Armed,
    /// It refused a command: nothing moved.
    Refused(String),
    /// It has stopped by itself.
    Fault(String),
    /// Bytes were dropped, and why.
    Noise(String),
}

/// One controller's language from the program's side. Times are since the connection was made.
pub trait Host: Send {
    /// How the controller wants to be driven.
    fn pace(&self) -> Pace;

    /// What there is to say unasked: greetings, heartbeats, questions. Called often.
    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>);

    /// Takes bytes from the controller; of a datagram protocol, one datagram.
    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>);

    /// The motors' values as last told, radians and metres.
    fn measured(&self) -> Option<&[f64]>;

    /// Asks the controller to take set-points.
    fn arm(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>);

    /// Whether a set-point can be given now.
    fn is_ready(&self) -> bool;

    /// Whether a whole move is under way whose end has not been told yet.
    fn is_moving(&self) -> bool {
        false
    }

    /// Sends the motors somewhere: there at once, or within the time `over` for [`Pace::Moves`].
    fn set_point(&mut self, now: Duration, motors: &[f64], over: Duration, out: &mut Vec<u8>);

    /// Stops: the controller takes no set-points any more, as far as its protocol can say so.
    fn stop(&mut self, now: Duration, out: &mut Vec<u8>);

    /// Lets go in peace: the controller holds where it is, and takes no set-points any more.
    fn disarm(&mut self, now: Duration, out: &mut Vec<u8>) {
        self.stop(now, out);
    }

    /// Has the controller drive these motors to their switches, by its own rates and on its own ways, as soon as nothing else is under
    /// way: afterwards it knows where they are.
    ///
    /// # Errors
    /// A sentence where the protocol has no such command.
    fn home(&mut self, motors: &[bool]) -> Result<(), String> {
        let _ = motors;
        Err("controllers of this kind find no switches when they are asked to".to_owned())
    }

    /// Whether the controller is under way to its switches: it answers nothing else meanwhile.
    fn is_homing(&self) -> bool {
        false
    }

    /// How long after the last measured values the controller counts as gone.
    fn patience(&self) -> Duration;

    /// The time from a set-point to the first state that answers it, where the protocol tells.
    fn latency(&self) -> Option<Duration>;
}
