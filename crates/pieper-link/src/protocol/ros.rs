//! The firmware of the AR4's ROS driver 2.1: set-points in degrees, one line each way.

use std::fmt::Write as _;
use std::time::Duration;

use super::{Event, Host, Lines, Pace, Setup};

/// The firmware that is spoken to.
pub const VERSION: &str = "2.1.0";

/// Joints of the arm.
pub const JOINTS: usize = 6;

/// The time between set-points: a set-point and a position are some 150 characters, 13 ms at 115200 baud.
const PERIOD: Duration = Duration::from_millis(25);

/// How long an answer may take.
const ANSWER: Duration = Duration::from_millis(500);

/// How often an idle controller is asked where it is.
const QUESTIONS: Duration = Duration::from_millis(40);

const TAGS: [char; JOINTS] = ['A', 'B', 'C', 'D', 'E', 'F'];

/// A line with six numbers behind their tags, after a prefix such as `MT` or `JP`.
pub fn write(prefix: &str, values: &[f64; JOINTS]) -> String {
    let mut line = prefix.to_owned();
    for (tag, value) in TAGS.iter().zip(values) {
        let _ = write!(line, "{tag}{value:.4}");
    }
    line
}

/// Reads what follows the prefix. `None` unless all six are there, in order, and finite.
///
/// ```
/// use pieper_link::protocol::ros;
/// let line = ros::write("JP", &[0.0, -1.5, 2.0, 0.0, 90.0, 45.25]);
/// assert_eq!(line, "JPA0.0000B-1.5000C2.0000D0.0000E90.0000F45.2500");
/// assert_eq!(ros::read(&line[2..]), Some([0.0, -1.5, 2.0, 0.0, 90.0, 45.25]));
/// ```
pub fn read(text: &str) -> Option<[f64; JOINTS]> {
    let mut values = [0.0; JOINTS];
    let mut rest = text.strip_prefix(TAGS[0])?;
    for (index, place) in values.iter_mut().enumerate() {
        let (value, after) = match TAGS.get(index + 1) {
            Some(&tag) => rest.split_once(tag)?,
            None => (rest, ""),
        };
        *place = value.trim().parse().ok().filter(|x: &f64| x.is_finite())?;
        rest = after;
    }
    Some(values)
}

/// What is expected next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Owed {
    Greeting,
    Taken,
    Position,
    /// `RE`: whether the emergency stop is released.
    Released,
    /// `JC`: the search for the switches.
    Switches,
}

/// How long it may take to find the switches.
const HOMING: Duration = Duration::from_secs(180);

/// The calibration command: all these joints together, as the firmware's first kind of sequence has it. A joint may be named twice, so that
/// six digits choose fewer.
///
/// ```
/// use pieper_link::protocol::ros;
/// assert_eq!(ros::calibration(&[true; 6]).as_deref(), Some("JC0012345"));
/// assert_eq!(ros::calibration(&[false, true, false, false, true, false]).as_deref(), Some("JC0144444"));
/// assert_eq!(ros::calibration(&[false; 6]), None);
/// ```
pub fn calibration(joints: &[bool; JOINTS]) -> Option<String> {
    let chosen: Vec<usize> = (0..JOINTS).filter(|&joint| joints[joint]).collect();
    let last = *chosen.last()?;
    let digits = chosen.iter().copied().chain(std::iter::repeat(last));
    let digits: String = digits.take(JOINTS).map(|joint| joint.to_string()).collect();
    Some(format!("JC0{digits}"))
}

/// A conversation with that firmware.
pub struct RosHost {
    lines: Lines,
    owed: Option<(Owed, Duration)>,
    spoken: Duration,
    is_greeted: bool,
    /// The emergency stop was told: it has to be released before anything moves.
    is_stopped: bool,
    /// The calibration command that goes out as soon as nothing is owed.
    homes: Option<String>,
    measured: Vec<f64>,
    has_measured: bool,
    is_armed: bool,
    latency: Option<Duration>,
}

impl RosHost {
    /// A conversation that has not begun.
    pub fn new(_: Setup) -> Self {
        Self {
            lines: Lines::default(),
            owed: None,
            spoken: Duration::ZERO,
            is_greeted: false,
            is_stopped: false,
            homes: None,
            measured: vec![0.0; JOINTS],
            has_measured: false,
            is_armed: false,
            latency: None,
        }
    }

    fn say(&mut self, now: Duration, line: &str, owed: Owed, out: &mut Vec<u8>) {
        out.extend_from_slice(line.as_bytes());
        out.push(b'\n');
        self.owed = Some((owed, now));
        self.spoken = now;
    }

    fn hear(&mut self, now: Duration, line: &str, events: &mut Vec<Event>) {
        if line.starts_with("DB:") || line.starts_with("WN:") {
            return events.push(Event::Noise(format!("the controller says {line:.80}")));
        }
        if let Some(error) = line.strip_prefix("ER:") {
            self.is_armed = false;
            if let Some((Owed::Switches, _)) = self.owed {
                self.owed = None;
            }
            return events.push(Event::Fault(format!(
                "the controller stopped: {}",
                error.trim()
            )));
        }
        let Some((owed, since)) = self.owed else {
            return events.push(Event::Noise(format!(
                "an answer to nothing that was asked: {line:.60}"
            )));
        };
        let understood = match owed {
            Owed::Greeting => line
                .strip_prefix("ST")
                .map(|rest| self.greeting(rest, events)),
            Owed::Taken => line.strip_prefix("ES").map(|rest| {
                self.latency = Some(now.saturating_sub(since));
                if rest.trim() != "0" {
                    self.is_armed = false;
                    self.is_stopped = true;
                    events.push(Event::Fault("the emergency stop is pressed".to_owned()));
                }
            }),
            Owed::Released => line
                .strip_prefix("ES")
                .map(|rest| self.released(rest.trim() == "0", events)),
            Owed::Switches => line.strip_prefix("JC").map(|_| ()),
            Owed::Position => line.strip_prefix("JP").and_then(read).map(|degrees| {
                for (place, degrees) in self.measured.iter_mut().zip(degrees) {
                    *place = degrees.to_radians();
                }
                self.has_measured = true;
                events.push(Event::Measured);
            }),
        };
        match understood {
            Some(()) => self.owed = None,
            None => events.push(Event::Noise(format!(
                "no reply of this firmware: {line:.60}"
            ))),
        }
    }

    fn released(&mut self, is_so: bool, events: &mut Vec<Event>) {
        self.is_stopped = !is_so;
        self.is_armed = is_so;
        events.push(match is_so {
            true => Event::Armed,
            false => Event::Fault("the emergency stop is still pressed".to_owned()),
        });
    }

    /// `A<version ok>B<version>C<model ok>D<model>`
    fn greeting(&mut self, rest: &str, events: &mut Vec<Event>) {
        let parts = || {
            let (fits, rest) = rest.strip_prefix('A')?.split_once('B')?;
            let (version, rest) = rest.split_once('C')?;
            let (fits_model, model) = rest.split_once('D')?;
            Some((fits == "1", version, fits_model == "1", model))
        };
        match parts() {
            Some((true, version, true, model)) => {
                self.is_greeted = true;
                events.push(Event::Identified(format!(
                    "the ROS driver's firmware {version} on an AR4 {model}"
                )));
            }
            Some((false, version, ..)) => events.push(Event::Fault(format!(
                "the firmware is {version}, this program speaks {VERSION}: reset the board after changing it"
            ))),
            Some((_, _, false, model)) => events.push(Event::Fault(format!(
                "the firmware is made for an AR4 {model}, not mk1: reset the board after changing it"
            ))),
            None => events.push(Event::Noise(format!("an unknown greeting: ST{rest:.60}"))),
        }
    }
}

impl Host for RosHost {
    fn pace(&self) -> Pace {
        Pace::Every(PERIOD)
    }

    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>) {
        if let Some((owed, since)) = self.owed {
            let patience = match owed {
                Owed::Switches => HOMING,
                _ => ANSWER,
            };
            if now.saturating_sub(since) > patience {
                self.owed = None;
                if self.is_armed {
                    self.is_armed = false;
                    let text = "the controller did not answer for half a second: is the cable in?";
                    events.push(Event::Fault(text.to_owned()));
                } else if owed == Owed::Switches {
                    let text = "no answer to the search for the switches for three minutes";
                    events.push(Event::Fault(text.to_owned()));
                } else if owed != Owed::Greeting {
                    // It may have been reset: it must be greeted before anything else.
                    self.is_greeted = false;
                }
            }
            return;
        }
        if !self.is_greeted {
            let line = format!("STA{VERSION}Bmk1");
            self.say(now, &line, Owed::Greeting, out);
        } else if let Some(line) = self.homes.take() {
            self.say(now, &line, Owed::Switches, out);
        } else if !self.has_measured || now.saturating_sub(self.spoken) >= QUESTIONS {
            self.say(now, "JP", Owed::Position, out);
        }
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
        self.has_measured.then_some(&self.measured)
    }

    fn arm(&mut self, now: Duration, out: &mut Vec<u8>, events: &mut Vec<Event>) {
        if self.is_stopped {
            return self.say(now, "RE", Owed::Released, out);
        }
        // Whoever sends a target moves it: the firmware knows no arming.
        self.is_armed = true;
        events.push(Event::Armed);
    }

    fn is_ready(&self) -> bool {
        self.is_armed && self.owed.is_none()
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], _: Duration, out: &mut Vec<u8>) {
        let mut degrees = [0.0; JOINTS];
        for (place, motor) in degrees.iter_mut().zip(motors) {
            *place = motor.to_degrees();
        }
        self.say(now, &write("MT", &degrees), Owed::Taken, out);
        // The next question is for the position, at once after the answer.
        self.spoken = now.saturating_sub(QUESTIONS);
    }

    fn home(&mut self, motors: &[bool]) -> Result<(), String> {
        let mut joints = [false; JOINTS];
        for (joint, homes) in joints.iter_mut().zip(motors) {
            *joint = *homes;
        }
        let line = calibration(&joints).ok_or("a joint to home was expected")?;
        self.homes = Some(line);
        Ok(())
    }

    fn is_homing(&self) -> bool {
        self.homes.is_some() || matches!(self.owed, Some((Owed::Switches, _)))
    }

    fn stop(&mut self, _: Duration, _: &mut Vec<u8>) {
        self.is_armed = false;
    }

    fn patience(&self) -> Duration {
        ANSWER + PERIOD * 2
    }

    fn latency(&self) -> Option<Duration> {
        self.latency
    }
}
