//! A small controller that speaks state packets; the firmware in `firmware/` does the same.

use std::time::Duration;

use super::Device;
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::packets::{
    Axes, Capabilities, Code, Deframer, Mode, Packet, State, ToDevice, ToHost, VERSION,
};

/// The time between states.
const PERIOD: Duration = Duration::from_millis(20);

/// The silence after which it stops.
const TIMEOUT: Duration = Duration::from_millis(250);

/// The lag of its servos, seconds.
const LAG: f64 = 0.015;

/// How much of the largest rate's way in [`TIMEOUT`] a set-point may be from the last.
const JUMP: f64 = 1.0;

pub(super) struct PacketDevice {
    plant: Plant,
    deframer: Deframer,
    sequence: u16,
    is_greeted: bool,
    mode: Mode,
    code: Code,
    session: u32,
    /// When the session began here, and the time of the last packet taken up, in the program's milliseconds.
    began: Duration,
    taken: u32,
    heard: Duration,
    last_sequence: Option<u16>,
    last: Duration,
    said: Duration,
    /// What its clock is off by.
    jump: Duration,
}

impl PacketDevice {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        Self {
            plant: Plant::new(motors, LAG),
            deframer: Deframer::default(),
            sequence: 0,
            is_greeted: false,
            mode: Mode::Idle,
            code: Code::None,
            session: 0,
            began: Duration::ZERO,
            taken: 0,
            heard: Duration::ZERO,
            last_sequence: None,
            last: Duration::ZERO,
            said: Duration::ZERO,
            jump: Duration::ZERO,
        }
    }

    fn say(&mut self, message: &ToHost, out: &mut Vec<u8>) {
        message.encode(self.sequence, out);
        self.sequence = self.sequence.wrapping_add(1);
    }

    fn refuse(&mut self, sequence: u16, code: Code, axis: u8, out: &mut Vec<u8>) {
        let message = ToHost::Refused {
            sequence,
            code,
            axis,
        };
        self.say(&message, out);
    }

    fn end(&mut self, mode: Mode, code: Code) {
        self.plant.hold();
        (self.mode, self.code, self.session) = (mode, code, 0);
    }

    /// Whether a packet of the session may be taken up: newer than the last, and not late.
    fn check(&mut self, now: Duration, sequence: u16, session: u32, time: u32) -> Code {
        if self.mode != Mode::Armed || session != self.session {
            return Code::NotArmed;
        }
        let is_newer = |last: u16| (1..0x8000).contains(&sequence.wrapping_sub(last));
        let here = (now.saturating_sub(self.began)).as_millis() as u32;
        if !self.last_sequence.is_none_or(is_newer)
            || time < self.taken
            || here.saturating_sub(time) > TIMEOUT.as_millis() as u32
        {
            return Code::Stale;
        }
        self.last_sequence = Some(sequence);
        self.taken = time;
        self.heard = now;
        Code::None
    }

    fn hear(&mut self, now: Duration, sequence: u16, message: ToDevice, out: &mut Vec<u8>) {
        match message {
            ToDevice::Hello => {
                self.is_greeted = true;
                let micro = |value: f64| (value * 1e6) as i32;
                let motors = self.plant.motors();
                let capabilities = Capabilities {
                    versions: [VERSION, VERSION],
                    period: PERIOD.as_millis() as u16,
                    timeout: TIMEOUT.as_millis() as u16,
                    measures: true,
                    ranges: motors.iter().map(|m| m.range.map(micro)).collect(),
                    name: "simulated controller".to_owned(),
                };
                self.say(&ToHost::Capabilities(capabilities), out);
            }
            ToDevice::Arm { session } => {
                if self.plant.is_stopped() {
                    self.code = Code::EmergencyStop;
                    return self.refuse(sequence, Code::EmergencyStop, 255, out);
                }
                self.plant.hold();
                (self.mode, self.code, self.session) = (Mode::Armed, Code::None, session);
                (self.began, self.heard, self.taken) = (now, now, 0);
                self.last_sequence = Some(sequence);
            }
            ToDevice::Heartbeat { session, time } => {
                let code = self.check(now, sequence, session, time);
                if code == Code::NotArmed {
                    self.refuse(sequence, code, 255, out);
                }
            }
            ToDevice::SetPoint {
                session,
                time,
                axes,
            } => match self.check(now, sequence, session, time) {
                Code::None => self.go(sequence, &axes, out),
                // Repeated and late ones are dropped without a word: they are nobody's mistake.
                Code::Stale => {}
                code => self.refuse(sequence, code, 255, out),
            },
            ToDevice::Stop => self.end(Mode::Stopped, Code::None),
            ToDevice::Disarm => self.end(Mode::Idle, Code::None),
        }
    }

    fn go(&mut self, sequence: u16, axes: &Axes, out: &mut Vec<u8>) {
        let count = self.plant.motors().len();
        if axes.micro().len() != count {
            return self.refuse(sequence, Code::WrongCount, 255, out);
        }
        let mut wanted = [0.0; crate::protocol::packets::AXES];
        axes.read(&mut wanted);
        for (axis, motor) in self.plant.motors().iter().enumerate() {
            let value = wanted[axis];
            // Rounding to millionths may be just past the end.
            let is_inside = (motor.range[0] - 1e-6..=motor.range[1] + 1e-6).contains(&value);
            let way = (value - self.plant.target()[axis]).abs();
            let code = match is_inside {
                false => Code::OutOfRange,
                true if way > JUMP * motor.rate * TIMEOUT.as_secs_f64() => Code::TooFast,
                true => continue,
            };
            self.refuse(sequence, code, axis as u8, out);
            return self.end(Mode::Fault, code);
        }
        for (axis, value) in wanted[..count].iter().enumerate() {
            self.plant.send(axis, *value);
        }
    }
}

impl Device for PacketDevice {
    fn receive(&mut self, now: Duration, bytes: &[u8], out: &mut Vec<u8>) {
        let now = now + self.jump;
        let mut deframer = std::mem::take(&mut self.deframer);
        deframer.push(bytes, |packet| {
            // A packet that failed its check is as if it had not come.
            if let Ok(packet) = packet
                && let Ok((sequence, message)) = ToDevice::decode(packet)
            {
                self.hear(now, sequence, message, out);
            }
        });
        self.deframer = deframer;
    }

    fn tick(&mut self, now: Duration, out: &mut Vec<u8>) {
        let seconds = now.saturating_sub(self.last).as_secs_f64();
        self.last = now;
        let now = now + self.jump;
        if self.mode == Mode::Armed && now.saturating_sub(self.heard) > TIMEOUT {
            self.end(Mode::Fault, Code::HeartbeatLost);
        }
        self.plant.advance(seconds);
        if self.is_greeted && now.saturating_sub(self.said) >= PERIOD {
            self.said = now;
            let axes = Axes::of(self.plant.place()).unwrap_or_default();
            let state = State {
                clock: now.as_millis() as u32,
                session: self.session,
                taken: self.taken,
                mode: self.mode,
                code: self.code,
                axes,
            };
            self.say(&ToHost::State(state), out);
        }
    }

    fn period(&self) -> Duration {
        Duration::from_millis(5)
    }

    fn inject(&mut self, now: Duration, fault: Fault) {
        match fault {
            Fault::Reset => {
                let place = self.plant.clone();
                *self = Self::new(place.motors().to_vec());
                self.plant = place;
                self.plant.hold();
                self.last = now;
            }
            Fault::EmergencyStop => {
                self.plant.emergency_stop(true);
                self.end(Mode::Fault, Code::EmergencyStop);
            }
            Fault::LoseSteps => self.plant.lose_steps(0.5),
            Fault::ClockJump => self.jump += Duration::from_secs(3600),
            _ => {}
        }
    }

    fn motors(&self) -> Vec<f64> {
        self.plant.place().to_vec()
    }
}
