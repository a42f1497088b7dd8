//! The program's side of the state packets.

use std::time::Duration;

use super::frame::Deframer;
use super::message::{Axes, Code, Mode, Packet, State, ToDevice, ToHost, VERSION};
use crate::protocol::{Event, Host, Pace, Setup};

/// How often a greeting is repeated until it is answered, and after what silence it is said again: a controller that was reset
/// says nothing until it is greeted.
const GREETING: Duration = Duration::from_millis(150);

/// How often the controller hears of us while no set-points go out: well within its 250 ms.
const HEARTBEAT: Duration = Duration::from_millis(80);

/// How long an answer to the arming may take.
const ARMING: Duration = Duration::from_millis(500);

/// Whether the controller follows us.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Following {
    No,
    Asked(Duration),
    Yes,
}

/// A conversation with a small controller.
pub struct PacketHost {
    setup: Setup,
    deframer: Deframer,
    sequence: u16,
    greeted: Option<Duration>,
    /// When the last state came; at first, long enough ago.
    heard: Duration,
    is_known: bool,
    period: Option<Duration>,
    measured: Vec<f64>,
    has_measured: bool,
    following: Following,
    session: u32,
    armed_at: Duration,
    spoken: Duration,
    last_code: Code,
    last_taken: u32,
    latency: Option<Duration>,
}

impl PacketHost {
    /// A conversation that has not begun.
    pub fn new(setup: Setup) -> Self {
        Self {
            measured: vec![0.0; setup.motors.len()],
            // Zero stands for no session.
            session: setup.nonce.max(1),
            setup,
            deframer: Deframer::default(),
            sequence: 0,
            greeted: None,
            heard: Duration::ZERO,
            is_known: false,
            period: None,
            has_measured: false,
            following: Following::No,
            armed_at: Duration::ZERO,
            spoken: Duration::ZERO,
            last_code: Code::None,
            last_taken: 0,
            latency: None,
        }
    }

    fn say(&mut self, now: Duration, message: ToDevice, out: &mut Vec<u8>) {
        message.encode(self.sequence, out);
        self.sequence = self.sequence.wrapping_add(1);
        self.spoken = now;
    }

    /// Milliseconds since the session was armed.
    fn clock(&self, now: Duration) -> u32 {
        now.saturating_sub(self.armed_at).as_millis() as u32
    }

    fn hear(&mut self, now: Duration, message: ToHost, events: &mut Vec<Event>) {
        match message {
            ToHost::Capabilities(of) => {
                if !(of.versions[0]..=of.versions[1]).contains(&VERSION) {
                    events.push(Event::Fault(format!(
                        "the controller speaks versions {} to {} of the packets, this program {VERSION}",
                        of.versions[0], of.versions[1]
                    )));
                    return;
                }
                if of.ranges.len() != self.measured.len() {
                    events.push(Event::Fault(format!(
                        "the controller has {} motors, the arm has {}",
                        of.ranges.len(),
                        self.measured.len()
                    )));
                    return;
                }
                let period = u64::from(of.period.clamp(2, 1000));
                self.period = Some(Duration::from_millis(period));
                if self.is_known {
                    return;
                }
                self.is_known = true;
                let how = match of.measures {
                    true => "measures its positions",
                    false => "tells where it sent its motors",
                };
                events.push(Event::Identified(format!(
                    "{}, {} motors, a state every {period} ms, {how}, stops after {} ms of silence",
                    of.name,
                    of.ranges.len(),
                    of.timeout
                )));
            }
            ToHost::State(state) => self.state(now, &state, events),
            // The states say why we are not armed any more: that is worth more than that we are not.
            ToHost::Refused {
                code: Code::NotArmed,
                ..
            } if !matches!(self.following, Following::Asked(_)) => {}
            ToHost::Refused { code, axis, .. } => {
                let motor = self.setup.motors.get(usize::from(axis));
                let whose = motor.map_or(String::new(), |motor| format!(" (motor {})", motor.name));
                events.push(Event::Refused(format!(
                    "the controller refused: {code}{whose}"
                )));
            }
        }
    }

    fn state(&mut self, now: Duration, state: &State, events: &mut Vec<Event>) {
        if state.axes.micro().len() != self.measured.len() {
            events.push(Event::Noise(
                "a state of another number of motors".to_owned(),
            ));
            return;
        }
        self.heard = now;
        state.axes.read(&mut self.measured);
        self.has_measured = true;
        events.push(Event::Measured);
        let ours = state.session == self.session && state.mode == Mode::Armed;
        match self.following {
            Following::Asked(_) if ours => {
                self.following = Following::Yes;
                self.last_taken = state.taken;
                events.push(Event::Armed);
            }
            Following::Asked(since) if now.saturating_sub(since) > ARMING => {
                self.following = Following::No;
                let why = match state.code {
                    Code::None => "it did not take up the session".to_owned(),
                    code => code.to_string(),
                };
                events.push(Event::Refused(format!("the controller did not arm: {why}")));
            }
            Following::Yes if !ours => {
                self.following = Following::No;
                let why = match (state.mode, state.code) {
                    (_, code) if code != Code::None => format!("the controller stopped: {code}"),
                    (Mode::Idle, _) => "the controller was reset".to_owned(),
                    _ => "the controller stopped".to_owned(),
                };
                events.push(Event::Fault(why));
            }
            Following::Yes if state.taken != self.last_taken => {
                self.last_taken = state.taken;
                let taken = self.armed_at + Duration::from_millis(u64::from(state.taken));
                self.latency = Some(now.saturating_sub(taken));
            }
            Following::No if state.code != Code::None && state.code != self.last_code => {
                events.push(Event::Noise(format!("the controller says: {}", state.code)));
            }
            _ => {}
        }
        self.last_code = state.code;
    }
}

impl Host for PacketHost {
    fn pace(&self) -> Pace {
        Pace::Every(self.period.unwrap_or(Duration::from_millis(20)))
    }

    fn poll(&mut self, now: Duration, out: &mut Vec<u8>, _: &mut Vec<Event>) {
        let is_due = |since: Duration, pause| now.saturating_sub(since) >= pause;
        let is_silent = !self.has_measured || is_due(self.heard, GREETING);
        if is_silent && self.greeted.is_none_or(|since| is_due(since, GREETING)) {
            self.greeted = Some(now);
            // A zero first: whatever was cut off before us ends here.
            out.push(0);
            self.say(now, ToDevice::Hello, out);
        }
        if self.following == Following::Yes && is_due(self.spoken, HEARTBEAT) {
            let (session, time) = (self.session, self.clock(now));
            self.say(now, ToDevice::Heartbeat { session, time }, out);
        }
    }

    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>) {
        let mut deframer = std::mem::take(&mut self.deframer);
        deframer.push(bytes, |packet| match packet.map(ToHost::decode) {
            Ok(Ok((_, message))) => self.hear(now, message, events),
            Ok(Err(malformed)) => events.push(Event::Noise(malformed.to_string())),
            Err(damage) => events.push(Event::Noise(damage.to_string())),
        });
        self.deframer = deframer;
    }

    fn measured(&self) -> Option<&[f64]> {
        self.has_measured.then_some(&self.measured)
    }

    fn arm(&mut self, now: Duration, out: &mut Vec<u8>, _: &mut Vec<Event>) {
        // Another number for every arming: packets of the session before are of no use any more.
        self.session = self.session.wrapping_add(1).max(1);
        self.following = Following::Asked(now);
        self.armed_at = now;
        let session = self.session;
        self.say(now, ToDevice::Arm { session }, out);
    }

    fn is_ready(&self) -> bool {
        self.following == Following::Yes
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], _: Duration, out: &mut Vec<u8>) {
        if let Some(axes) = Axes::of(motors) {
            let (session, time) = (self.session, self.clock(now));
            let message = ToDevice::SetPoint {
                session,
                time,
                axes,
            };
            self.say(now, message, out);
        }
    }

    fn stop(&mut self, now: Duration, out: &mut Vec<u8>) {
        self.following = Following::No;
        self.say(now, ToDevice::Stop, out);
    }

    fn disarm(&mut self, now: Duration, out: &mut Vec<u8>) {
        self.following = Following::No;
        self.say(now, ToDevice::Disarm, out);
    }

    fn patience(&self) -> Duration {
        Duration::from_millis(300).max(self.period.unwrap_or_default() * 5)
    }

    fn latency(&self) -> Option<Duration> {
        self.latency
    }
}
