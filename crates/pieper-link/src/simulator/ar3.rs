//! A simulated AR3: counts steps, and compares them with encoders.

use std::time::Duration;

use super::Device;
use super::board::{Board, TICK, say};
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::ar3::{Ask, FULL, JOINTS, Reply, angle, steps};

/// Steps by which encoder and count may differ: the multiplier by ten, 25 for J5.
const THRESHOLD: [i32; JOINTS] = [51, 51, 51, 51, 25, 51];

struct UnderWay {
    from: [i32; JOINTS],
    by: [i32; JOINTS],
    expected: [i32; JOINTS],
    since: Duration,
    seconds: f64,
}

pub(super) struct Ar3Device {
    plant: Plant,
    board: Board,
    /// Steps made, as the firmware counts them.
    counts: [i32; JOINTS],
    move_now: Option<UnderWay>,
}

impl Ar3Device {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        let plant = Plant::new(motors, 0.0);
        let mut counts = [0; JOINTS];
        for (joint, count) in counts.iter_mut().enumerate() {
            *count = steps(joint, plant.place()[joint]);
        }
        Self {
            plant,
            board: Board::default(),
            counts,
            move_now: None,
        }
    }

    /// Encoders against the counts that are expected. Where all agree, the encoders are overwritten with them.
    fn compare(&mut self, expected: [i32; JOINTS], is_complete: bool) -> Reply {
        let mut differs = [false; JOINTS];
        let mut encoders = [0; JOINTS];
        for joint in 0..JOINTS {
            encoders[joint] = steps(joint, self.plant.place()[joint]);
            differs[joint] = (encoders[joint] - expected[joint]).abs() > THRESHOLD[joint];
        }
        if differs.contains(&true) {
            self.counts = encoders;
            return Reply::Differs(differs, encoders);
        }
        self.counts = expected;
        Reply::Agrees(is_complete.then_some(encoders))
    }

    fn answer(&mut self, now: Duration, line: &str) -> Option<String> {
        match Ask::read(line)? {
            Ask::Compare(expected) => Some(self.compare(expected, true).write()),
            Ask::Move { by, speed, to } => {
                let most = by.iter().map(|by| by.abs()).max().unwrap_or(0);
                self.move_now = Some(UnderWay {
                    from: self.counts,
                    by,
                    expected: to,
                    since: now,
                    seconds: f64::from(most) / (FULL * f64::from(speed) / 100.0),
                });
                None
            }
        }
    }
}

impl Device for Ar3Device {
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
        let share = match under_way.seconds > 0.0 {
            true => (gone / under_way.seconds).min(1.0),
            false => 1.0,
        };
        let expected = under_way.expected;
        for joint in 0..JOINTS {
            let made = (f64::from(under_way.by[joint]) * share).round() as i32;
            self.plant
                .put(joint, angle(joint, under_way.from[joint] + made));
        }
        if share >= 1.0 {
            self.move_now = None;
            let reply = self.compare(expected, false);
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
