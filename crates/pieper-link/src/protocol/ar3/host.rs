//! The program's side of dialect B.

use std::time::Duration;

use super::message::{Ask, JOINTS, Reply, angle, steps};
use crate::protocol::{Event, Host, Lines, Pace, Setup};

/// How often an idle controller is asked where it is.
const QUESTIONS: Duration = Duration::from_millis(200);

/// How long an answer to a question may take, and how much longer than reckoned for a move.
const ANSWER: Duration = Duration::from_secs(4);

/// The longest move, so that a stop takes effect soon: the firmware ends the move it is in.
const MOVE: Duration = Duration::from_millis(500);

/// Steps per second at 100 percent: what percent mean in time is not in the protocol, and depends on the motors' drivers.
pub(crate) const FULL: f64 = 6000.0;

/// Steps that a comparison finds to be none: the firmware's own threshold is about 51, and 25 for J5.
const START: [i32; JOINTS] = [7600, 2322, 0, 7600, 2287, 3312];

/// A conversation with an AR3.
pub struct Ar3Host {
    lines: Lines,
    /// When the answer that is owed must have come, and whether it is a move's.
    owed: Option<(Duration, bool)>,
    asked: Duration,
    /// The step counts, and those that the move under way ends with.
    counts: [i32; JOINTS],
    next: [i32; JOINTS],
    measured: Vec<f64>,
    is_identified: bool,
    is_armed: bool,
    latency: Option<Duration>,
}

impl Ar3Host {
    /// A conversation that has not begun.
    pub fn new(_: Setup) -> Self {
        Self {
            lines: Lines::default(),
            owed: None,
            asked: Duration::ZERO,
            counts: START,
            next: START,
            measured: vec![0.0; JOINTS],
            is_identified: false,
            is_armed: false,
            latency: None,
        }
    }

    fn say(&mut self, now: Duration, ask: &Ask, time: Duration, out: &mut Vec<u8>) {
        out.extend_from_slice(ask.write().as_bytes());
        out.push(b'\n');
        self.asked = now;
        self.owed = Some((now + time + ANSWER, matches!(ask, Ask::Move { .. })));
    }

    fn hear(&mut self, reply: Reply, was_move: bool, events: &mut Vec<Event>) {
        match reply {
            Reply::Agrees(counts) => {
                self.counts = counts.filter(|_| !was_move).unwrap_or(self.next)
            }
            Reply::Differs(differs, counts) => {
                self.counts = counts;
                let named = differs.iter().enumerate().filter(|(_, differs)| **differs);
                let names: Vec<_> = named.map(|(joint, _)| format!("J{}", joint + 1)).collect();
                // The first answer tells where the arm was left: that is no error.
                if self.is_identified && self.is_armed {
                    self.is_armed = false;
                    events.push(Event::Fault(format!(
                        "{}: encoder and step count differ: a collision, or lost steps",
                        names.join(", ")
                    )));
                }
            }
        }
        self.next = self.counts;
        for (joint, place) in self.measured.iter_mut().enumerate() {
            *place = angle(joint, self.counts[joint]);
        }
        if !self.is_identified {
            self.is_identified = true;
            let text = "an AR3: it moves from rest to rest, and a stop takes effect when the move under way has ended; its \
                        speed is in percent, so times are as near as 6000 steps a second at full speed are right";
            events.push(Event::Identified(text.to_owned()));
        }
        events.push(Event::Measured);
    }
}

impl Host for Ar3Host {
    fn pace(&self) -> Pace {
        Pace::Moves(MOVE)
    }

    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>) {
        match self.owed {
            Some((until, _)) if now > until => {
                self.owed = None;
                self.is_armed = false;
                let text = "no answer came: is the controller on, and is this its port?";
                events.push(Event::Fault(text.to_owned()));
            }
            Some(_) => {}
            None if now.saturating_sub(self.asked) >= QUESTIONS || !self.is_identified => {
                let counts = self.counts;
                self.say(now, &Ask::Compare(counts), Duration::ZERO, out);
            }
            None => {}
        }
    }

    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>) {
        let mut lines = std::mem::take(&mut self.lines);
        lines.texts(bytes, |line| match line {
            Ok(line) => match (Reply::read(line), self.owed) {
                (Some(reply), Some((_, was_move))) => {
                    self.owed = None;
                    if !was_move {
                        self.latency = Some(now.saturating_sub(self.asked));
                    }
                    self.hear(reply, was_move, events);
                }
                (Some(_), None) => {
                    let text = "an answer to nothing that was asked";
                    events.push(Event::Noise(text.to_owned()));
                }
                (None, _) => events.push(Event::Noise(format!("no reply of an AR3: {line:.60}"))),
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
        matches!(self.owed, Some((_, true)))
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], over: Duration, out: &mut Vec<u8>) {
        let mut by = [0; JOINTS];
        for (joint, angle) in motors.iter().enumerate().take(JOINTS) {
            self.next[joint] = steps(joint, *angle);
            by[joint] = self.next[joint] - self.counts[joint];
        }
        let most = by.iter().map(|by| by.abs()).max().unwrap_or(0);
        let percent = f64::from(most) / over.as_secs_f64().max(1e-3) / FULL * 100.0;
        let speed = percent.ceil().clamp(1.0, 100.0) as u8;
        let to = self.next;
        self.say(now, &Ask::Move { by, speed, to }, over * 4, out);
    }

    fn stop(&mut self, _: Duration, _: &mut Vec<u8>) {
        self.is_armed = false;
    }

    fn patience(&self) -> Duration {
        ANSWER + MOVE * 4 + QUESTIONS * 2
    }

    fn latency(&self) -> Option<Duration> {
        self.latency
    }
}
