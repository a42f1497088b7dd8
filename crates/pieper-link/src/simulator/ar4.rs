//! A simulated AR4: whole moves, answered when they have ended.

use std::time::Duration;

use super::Device;
use super::board::{Board, TICK, say};
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::ar4::{AXES, Command, JOINTS, Move, Position, Refusal, Reply};

/// How much a joint's encoder may differ from its step count, radians: five steps of 1/44 degree.
const COLLISION: f64 = 0.002;

/// A move under way.
struct UnderWay {
    from: Vec<f64>,
    to: Vec<f64>,
    since: Duration,
    time: Duration,
    was_slower: bool,
    /// The axes whose count is right again at the end.
    homes: [bool; AXES],
}

/// Axes find their switches at this share of their largest rates, as the firmware has it.
const HOMING: f64 = 0.5;

pub(super) struct Ar4Device {
    plant: Plant,
    board: Board,
    move_now: Option<UnderWay>,
}

impl Ar4Device {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        Self {
            plant: Plant::new(motors, 0.0),
            board: Board::default(),
            move_now: None,
        }
    }

    fn position(&self, was_slower: bool) -> Reply {
        let mut at = Position {
            was_slower,
            is_stopped: self.plant.is_stopped(),
            ..Position::default()
        };
        for (axis, motor) in self.plant.motors().iter().enumerate() {
            let place = self.plant.place()[axis];
            at.joints[axis] = match motor.is_angle {
                true => place.to_degrees(),
                false => place * 1e3,
            };
            if axis < JOINTS {
                at.collided[axis] = self.plant.differs(axis, COLLISION);
            }
        }
        // The tool's pose is the program's business: the firmware's own numbers are not modelled.
        Reply::Position(at)
    }

    fn obey(&mut self, now: Duration, command: &Command) -> Option<Reply> {
        match command {
            Command::Position => Some(self.position(false)),
            Command::Joints(to) => self.start(now, to),
            Command::Home(axes) => self.home(now, *axes),
        }
    }

    fn start(&mut self, now: Duration, to: &Move) -> Option<Reply> {
        if self.plant.is_stopped() {
            return Some(self.position(false));
        }
        let motors = self.plant.motors();
        let wanted: Vec<f64> = motors
            .iter()
            .zip(to.joints)
            .map(|(motor, value)| match motor.is_angle {
                true => value.to_radians(),
                false => value * 1e-3,
            })
            .collect();
        let mut beyond = [false; AXES];
        for ((beyond, motor), value) in beyond.iter_mut().zip(motors).zip(&wanted) {
            // Three decimals on the wire: a value at the end may be rounded past it.
            *beyond = !(motor.range[0] - 1e-5..=motor.range[1] + 1e-5).contains(value);
        }
        if beyond.contains(&true) {
            return Some(Reply::Refused(Refusal::Limit(beyond)));
        }
        let from = self.plant.place().to_vec();
        let needed = (from.iter().zip(&wanted).zip(motors))
            .map(|((from, to), motor)| (to - from).abs() / motor.rate)
            .fold(0.0, f64::max);
        let time = to.seconds.max(needed);
        self.move_now = Some(UnderWay {
            from,
            to: wanted,
            since: now,
            time: Duration::from_secs_f64(time.min(3600.0)),
            was_slower: needed > to.seconds + 1e-3,
            homes: [false; AXES],
        });
        None
    }

    /// To the lower ends, where the switches are taken to be, and back to where the arm starts.
    fn home(&mut self, now: Duration, axes: [bool; AXES]) -> Option<Reply> {
        if self.plant.is_stopped() {
            return Some(self.position(false));
        }
        let motors = self.plant.motors();
        if let Some(axis) = (motors.len()..AXES).find(|&axis| axes[axis]) {
            let axis = char::from_digit(axis as u32 + 1, 10)?;
            return Some(Reply::Refused(Refusal::Switch(axis)));
        }
        let from = self.plant.place().to_vec();
        let mut to = from.clone();
        let mut seconds = 0.0_f64;
        for (axis, motor) in motors.iter().enumerate().filter(|(axis, _)| axes[*axis]) {
            to[axis] = motor.start;
            let way = (from[axis] - motor.range[0]) + (motor.start - motor.range[0]);
            seconds = seconds.max(way / (motor.rate * HOMING));
        }
        self.move_now = Some(UnderWay {
            from,
            to,
            since: now,
            time: Duration::from_secs_f64(seconds.min(3600.0)),
            was_slower: false,
            homes: axes,
        });
        None
    }

    /// The firmware answers nothing to what it does not know, and so its host waits.
    fn answer(&mut self, now: Duration, line: &str) -> Option<String> {
        let command = Command::read(line)?;
        self.obey(now, &command).map(|reply| reply.write())
    }
}

/// Where a joint is on its way over its switch, after this share of the time.
fn by_switch(from: f64, to: f64, switch: f64, share: f64) -> f64 {
    let (there, back) = (from - switch, to - switch);
    let way = (there + back) * share;
    match way < there {
        true => from - way,
        false => switch + (way - there),
    }
}

impl Device for Ar4Device {
    fn receive(&mut self, now: Duration, bytes: &[u8], out: &mut Vec<u8>) {
        let mut board = std::mem::take(&mut self.board);
        board.receive(now, bytes, out, |line| self.answer(now, line));
        self.board = board;
    }

    fn tick(&mut self, now: Duration, out: &mut Vec<u8>) {
        let Some(under_way) = &self.move_now else {
            return;
        };
        let gone = now.saturating_sub(under_way.since).as_secs_f64();
        let whole = under_way.time.as_secs_f64();
        let share = if whole > 0.0 {
            (gone / whole).min(1.0)
        } else {
            1.0
        };
        let (from, to) = (under_way.from.clone(), under_way.to.clone());
        let was_slower = under_way.was_slower;
        let under_way_homes = under_way.homes;
        for (axis, (from, to)) in from.iter().zip(&to).enumerate() {
            let place = match under_way_homes[axis] {
                true => by_switch(*from, *to, self.plant.motors()[axis].range[0], share),
                false => from + (to - from) * share,
            };
            self.plant.put(axis, place);
        }
        if share >= 1.0 || self.plant.is_stopped() {
            self.move_now = None;
            for axis in (0..self.plant.motors().len()).filter(|&axis| under_way_homes[axis]) {
                self.plant.find(axis);
            }
            let reply = self.position(was_slower);
            say(&reply.write(), out);
        }
    }

    fn period(&self) -> Duration {
        TICK
    }

    fn inject(&mut self, now: Duration, fault: Fault) {
        match fault {
            Fault::Reset => {
                self.move_now = None;
                self.board.reset(now);
            }
            // It has no clock on the wire.
            other => self.plant.suffer(other, 0.05),
        }
    }

    fn motors(&self) -> Vec<f64> {
        self.plant.place().to_vec()
    }
}
