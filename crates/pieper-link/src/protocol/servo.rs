//! The I/O board with hobby servos: one servo a line, whole degrees from 0 to 180.
//!
//! The board measures nothing: where its servos are is where they were sent.

use std::collections::VecDeque;
use std::time::Duration;

use super::{Event, Host, Lines, Pace, Setup};

/// Servos of the board.
pub const SERVOS: usize = 7;

/// The time between set-points; a servo's own pulse comes every 20 ms.
const PERIOD: Duration = Duration::from_millis(40);

/// How long an answer may take.
const ANSWER: Duration = Duration::from_millis(500);

/// How often the board is asked while nothing is sent, to know that it is there.
const QUESTIONS: Duration = Duration::from_millis(150);

/// What is owed for the line that is out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Line {
    /// `SP<n>`: where was the servo sent?
    Where(usize),
    /// `SV<n>P<deg>`
    Send(usize, u8),
}

/// A conversation with the board.
pub struct ServoHost {
    lines: Lines,
    owed: Option<(Line, Duration)>,
    waiting: VecDeque<Line>,
    /// Where the servos were last sent, and were told to have been.
    sent: Vec<Option<u8>>,
    measured: Vec<f64>,
    spoken: Duration,
    is_identified: bool,
    is_armed: bool,
    refused: Option<String>,
    latency: Option<Duration>,
}

impl ServoHost {
    /// A conversation that has not begun.
    pub fn new(setup: Setup) -> Self {
        let count = setup.motors.len();
        Self {
            lines: Lines::default(),
            owed: None,
            waiting: (0..count).map(Line::Where).collect(),
            sent: vec![None; count],
            measured: vec![0.0; count],
            spoken: Duration::ZERO,
            is_identified: false,
            is_armed: false,
            refused: None,
            latency: None,
        }
    }

    fn next(&mut self, now: Duration, out: &mut Vec<u8>) {
        if self.owed.is_some() {
            return;
        }
        let Some(line) = self.waiting.pop_front() else {
            return;
        };
        let text = match line {
            Line::Where(servo) => format!("SP{servo}\n"),
            Line::Send(servo, degrees) => format!("SV{servo}P{degrees}\n"),
        };
        out.extend_from_slice(text.as_bytes());
        self.owed = Some((line, now));
        self.spoken = now;
    }

    fn hear(&mut self, now: Duration, text: &str, events: &mut Vec<Event>) {
        let Some((line, since)) = self.owed else {
            return events.push(Event::Noise(format!(
                "an answer to nothing that was asked: {text:.40}"
            )));
        };
        let told = match line {
            Line::Where(servo) => text.parse().ok().filter(|&d| d <= 180).map(|d| (servo, d)),
            Line::Send(servo, degrees) => (text == "Done").then_some((servo, degrees)),
        };
        let Some((servo, degrees)) = told else {
            return events.push(Event::Noise(format!("no reply of the board: {text:.40}")));
        };
        self.owed = None;
        self.latency = Some(now.saturating_sub(since));
        self.sent[servo] = Some(degrees);
        self.measured[servo] = f64::from(degrees).to_radians();
        if self.sent.iter().all(Option::is_some) {
            if !self.is_identified {
                self.is_identified = true;
                let text = "the I/O board: its servos tell nothing, so what is shown is where they were sent";
                events.push(Event::Identified(text.to_owned()));
            }
            events.push(Event::Measured);
        }
    }
}

impl Host for ServoHost {
    fn pace(&self) -> Pace {
        Pace::Every(PERIOD)
    }

    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>) {
        if let Some(text) = self.refused.take() {
            self.is_armed = false;
            events.push(Event::Refused(text));
        }
        if let Some((line, since)) = self.owed
            && now.saturating_sub(since) > ANSWER
        {
            self.owed = None;
            match line {
                Line::Where(_) => self.waiting.push_front(line),
                Line::Send(..) => self.waiting.clear(),
            }
            if self.is_armed {
                self.is_armed = false;
                let text = "the board did not answer for half a second: is the cable in?";
                events.push(Event::Fault(text.to_owned()));
            }
        }
        if self.waiting.is_empty()
            && self.is_identified
            && now.saturating_sub(self.spoken) >= QUESTIONS
        {
            self.waiting.push_back(Line::Where(0));
        }
        self.next(now, out);
    }

    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>) {
        let mut lines = std::mem::take(&mut self.lines);
        lines.texts(bytes, |line| match line {
            Ok(line) => self.hear(now, line, events),
            Err(noise) => events.push(Event::Noise(noise)),
        });
        self.lines = lines;
    }

    fn measured(&self) -> Option<&[f64]> {
        self.is_identified.then_some(&self.measured)
    }

    fn arm(&mut self, _: Duration, _: &mut Vec<u8>, events: &mut Vec<Event>) {
        // Whoever sends a servo somewhere moves it: the board knows no arming.
        self.is_armed = true;
        events.push(Event::Armed);
    }

    fn is_ready(&self) -> bool {
        self.is_armed && self.owed.is_none() && self.waiting.is_empty()
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], _: Duration, out: &mut Vec<u8>) {
        for (servo, motor) in motors.iter().enumerate() {
            let degrees = motor.to_degrees().round();
            if !(0.0..=180.0).contains(&degrees) {
                // The board does not clamp: what is outside would be sent to the servo as it is.
                self.refused = Some(format!(
                    "servo {servo} would be sent to {degrees} degrees, it turns from 0 to 180: `pieper link map` finds \
                     its centre, direction and ratio"
                ));
                self.waiting.clear();
                return;
            }
            let degrees = degrees as u8;
            if self.sent.get(servo) != Some(&Some(degrees)) {
                self.waiting.push_back(Line::Send(servo, degrees));
            }
        }
        self.next(now, out);
    }

    fn stop(&mut self, _: Duration, _: &mut Vec<u8>) {
        self.is_armed = false;
        self.waiting.retain(|line| !matches!(line, Line::Send(..)));
    }

    fn patience(&self) -> Duration {
        ANSWER + QUESTIONS * 2
    }

    fn latency(&self) -> Option<Duration> {
        self.latency
    }
}
