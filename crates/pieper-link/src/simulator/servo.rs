//! A simulated I/O board with hobby servos.

use std::time::Duration;

use super::Device;
use super::board::{Board, TICK};
use super::fault::Fault;
use super::plant::{Plant, SimMotor};

/// The lag of a hobby servo, seconds.
const LAG: f64 = 0.05;

pub(super) struct ServoDevice {
    plant: Plant,
    board: Board,
    sent: Vec<u8>,
    last: Duration,
}

impl ServoDevice {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        let plant = Plant::new(motors, LAG);
        let degrees = |motor: &f64| motor.to_degrees().round().clamp(0.0, 180.0) as u8;
        Self {
            sent: plant.place().iter().map(degrees).collect(),
            plant,
            board: Board::default(),
            last: Duration::ZERO,
        }
    }

    fn answer(&mut self, line: &str) -> Option<String> {
        if let Some(rest) = line.strip_prefix("SP") {
            let servo: usize = rest.parse().ok()?;
            return Some(self.sent.get(servo)?.to_string());
        }
        if let Some(rest) = line.strip_prefix("SV") {
            let (servo, degrees) = rest.split_once('P')?;
            let servo: usize = servo.parse().ok()?;
            // The original does not clamp; a servo's own stop does.
            let degrees: u8 = degrees.parse().ok()?;
            *self.sent.get_mut(servo)? = degrees;
            self.plant.send(servo, f64::from(degrees).to_radians());
            return Some("Done".to_owned());
        }
        match line {
            "ST" => Some("simulated I/O board".to_owned()),
            _ => line.strip_prefix("TM").map(str::to_owned),
        }
    }
}

impl Device for ServoDevice {
    fn receive(&mut self, now: Duration, bytes: &[u8], out: &mut Vec<u8>) {
        let mut board = std::mem::take(&mut self.board);
        board.receive(now, bytes, out, |line| self.answer(line));
        self.board = board;
    }

    fn tick(&mut self, now: Duration, _: &mut Vec<u8>) {
        let seconds = now.saturating_sub(self.last).as_secs_f64();
        self.last = now;
        self.plant.advance(seconds);
    }

    fn period(&self) -> Duration {
        TICK
    }

    fn inject(&mut self, now: Duration, fault: Fault) {
        match fault {
            Fault::Reset => {
                self.board.reset(now);
            }
            // It has no clock on the wire.
            other => self.plant.suffer(other, 0.5),
        }
    }

    fn motors(&self) -> Vec<f64> {
        self.plant.place().to_vec()
    }
}
