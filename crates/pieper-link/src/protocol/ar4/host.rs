//! The program's side of dialect A.

use std::time::Duration;

use super::AXES;
use super::command::{Command, Move};
use super::reply::{Position, Reply};
use crate::arm::MotorOf;
use crate::protocol::{Event, Host, Lines, Pace, Setup};

/// How often an idle controller is asked where it is.
const QUESTIONS: Duration = Duration::from_millis(150);

/// How long an answer to a question may take, and how much longer than asked for a move.
const ANSWER: Duration = Duration::from_secs(3);

/// The longest move, so that a stop takes effect soon: the firmware ends the move it is in.
const MOVE: Duration = Duration::from_millis(500);

/// How long it may take to find the switches: each joint's whole way, twice, at the firmware's rates.
const HOMING: Duration = Duration::from_secs(180);

/// What the controller owes us.
#[derive(Clone, Copy, Debug)]
struct Owed {
    since: Duration,
    until: Duration,
    what: What,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    Answer,
    Move,
    Switches,
}

impl What {
    fn name(self) -> &'static str {
        match self {
            Self::Answer => "a question",
            Self::Move => "a move",
            Self::Switches => "the search for its switches",
        }
    }
}

/// A conversation with an AR4.
pub struct Ar4Host {
    motors: Vec<MotorOf>,
    lines: Lines,
    owed: Option<Owed>,
    /// Axes to be driven to their switches as soon as nothing is owed.
    homes: Option<[bool; AXES]>,
    spoken: Duration,
    measured: Vec<f64>,
    is_identified: bool,
    is_armed: bool,
    latency: Option<Duration>,
}

impl Ar4Host {
    /// A conversation that has not begun.
    pub fn new(setup: Setup) -> Self {
        Self {
            measured: vec![0.0; setup.motors.len()],
            motors: setup.motors,
            lines: Lines::default(),
            owed: None,
            homes: None,
            spoken: Duration::ZERO,
            is_identified: false,
            is_armed: false,
            latency: None,
        }
    }

    fn say(&mut self, now: Duration, command: Command, time: Duration, out: &mut Vec<u8>) {
        command.write(out);
        self.spoken = now;
        self.owed = Some(Owed {
            since: now,
            until: now + time + ANSWER,
            what: match command {
                Command::Position => What::Answer,
                Command::Joints(_) => What::Move,
                Command::Home(_) => What::Switches,
            },
        });
    }

    fn position(&mut self, at: &Position, events: &mut Vec<Event>) {
        for ((place, motor), value) in self.measured.iter_mut().zip(&self.motors).zip(at.joints) {
            *place = match motor.is_angle {
                true => value.to_radians(),
                false => value * 1e-3,
            };
        }
        if !self.is_identified {
            self.is_identified = true;
            let text = "an AR4 (firmware 4.x): it moves from rest to rest, and a stop takes effect \
                        when the move under way has ended, after half a second at most";
            events.push(Event::Identified(text.to_owned()));
        }
        events.push(Event::Measured);
        let collided: Vec<_> = (at.collided.iter().enumerate())
            .filter(|(_, collided)| **collided)
            .map(|(axis, _)| format!("J{}", axis + 1))
            .collect();
        if at.is_stopped {
            self.is_armed = false;
            let text = "the emergency stop is pressed";
            events.push(Event::Fault(text.to_owned()));
        } else if !collided.is_empty() {
            self.is_armed = false;
            events.push(Event::Fault(format!(
                "{}: encoder and step count differ: a collision, or lost steps",
                collided.join(", ")
            )));
        } else if at.was_slower {
            let text = "the controller could not go as fast as it was asked to";
            events.push(Event::Noise(text.to_owned()));
        }
    }
}

impl Host for Ar4Host {
    fn pace(&self) -> Pace {
        Pace::Moves(MOVE)
    }

    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>) {
        match self.owed {
            Some(owed) if now > owed.until => {
                self.owed = None;
                self.is_armed = false;
                let what = owed.what.name();
                let waited = (now - owed.since).as_secs_f64();
                events.push(Event::Fault(format!(
                    "no answer to {what} for {waited:.1} s: is the controller on, and is this its port?"
                )));
            }
            Some(_) => {}
            None if self.homes.is_some() => {
                if let Some(axes) = self.homes.take() {
                    self.say(now, Command::Home(axes), HOMING, out);
                }
            }
            None if now.saturating_sub(self.spoken) >= QUESTIONS || self.spoken.is_zero() => {
                self.say(
                    now.max(Duration::from_nanos(1)),
                    Command::Position,
                    Duration::ZERO,
                    out,
                );
            }
            None => {}
        }
    }

    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>) {
        let mut lines = std::mem::take(&mut self.lines);
        lines.texts(bytes, |line| match line {
            Ok(line) => match Reply::read(line) {
                Some(reply) => {
                    let owed = self.owed.take();
                    if let Some(owed) = owed.filter(|owed| owed.what == What::Answer) {
                        self.latency = Some(now.saturating_sub(owed.since));
                    }
                    match reply {
                        Reply::Position(at) => self.position(&at, events),
                        Reply::Refused(refusal) => {
                            self.is_armed = false;
                            events.push(Event::Refused(refusal.sentence()));
                        }
                    }
                }
                None => events.push(Event::Noise(format!("no reply of an AR4: {line:.60}"))),
            },
            Err(noise) => events.push(Event::Noise(noise)),
        });
        self.lines = lines;
    }

    fn measured(&self) -> Option<&[f64]> {
        self.is_identified.then_some(&self.measured)
    }

    fn arm(&mut self, _: Duration, _: &mut Vec<u8>, events: &mut Vec<Event>) {
        // Whoever sends a move moves it: the firmware knows no arming.
        self.is_armed = true;
        events.push(Event::Armed);
    }

    fn is_ready(&self) -> bool {
        self.is_armed && self.owed.is_none()
    }

    fn is_moving(&self) -> bool {
        self.owed.is_some_and(|owed| owed.what == What::Move)
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], over: Duration, out: &mut Vec<u8>) {
        let mut joints = [0.0; AXES];
        for ((place, motor), value) in joints.iter_mut().zip(&self.motors).zip(motors) {
            *place = match motor.is_angle {
                true => value.to_degrees(),
                false => value * 1e3,
            };
        }
        let seconds = over.as_secs_f64();
        self.say(now, Command::Joints(Move { joints, seconds }), over, out);
    }

    fn home(&mut self, motors: &[bool]) -> Result<(), String> {
        let mut axes = [false; AXES];
        for (axis, homes) in axes.iter_mut().zip(motors) {
            *axis = *homes;
        }
        self.homes = Some(axes);
        Ok(())
    }

    fn is_homing(&self) -> bool {
        let searches = |owed: Owed| owed.what == What::Switches;
        self.homes.is_some() || self.owed.is_some_and(searches)
    }

    fn stop(&mut self, _: Duration, _: &mut Vec<u8>) {
        self.is_armed = false;
    }

    fn patience(&self) -> Duration {
        // A lost answer is told by the question's own time.
        ANSWER + MOVE + QUESTIONS * 2
    }

    fn latency(&self) -> Option<Duration> {
        self.latency
    }
}
