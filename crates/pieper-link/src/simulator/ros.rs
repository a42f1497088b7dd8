//! A simulated board with the ROS driver's firmware. Like the original it checks ranges badly: the host must.

use std::time::Duration;

use super::Device;
use super::board::{Board, TICK};
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::ros::{JOINTS, VERSION, read, write};

/// The lag of its steppers, seconds.
const LAG: f64 = 0.02;

pub(super) struct RosDevice {
    plant: Plant,
    board: Board,
    is_greeted: bool,
    last: Duration,
}

impl RosDevice {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        Self {
            plant: Plant::new(motors, LAG),
            board: Board::default(),
            is_greeted: false,
            last: Duration::ZERO,
        }
    }

    fn answer(&mut self, line: &str) -> Option<String> {
        if let Some(rest) = line.strip_prefix("STA") {
            let (version, model) = rest.split_once('B')?;
            let (fits, fits_model) = (version == VERSION, model == "mk1");
            self.is_greeted = fits && fits_model;
            let (fits, fits_model) = (u8::from(fits), u8::from(fits_model));
            return Some(format!("STA{fits}B{VERSION}C{fits_model}Dmk1"));
        }
        if !self.is_greeted {
            return None;
        }
        let stopped = format!("ES{}", u8::from(self.plant.is_stopped()));
        if let Some(rest) = line.strip_prefix("MT") {
            let degrees = read(rest)?;
            for (joint, degrees) in degrees.iter().enumerate() {
                // The original's check lets large negative targets pass.
                if *degrees <= 380.0 {
                    self.plant.send(joint, degrees.to_radians());
                }
            }
            return Some(stopped);
        }
        if let Some(rest) = line.strip_prefix("JC") {
            // It is there at once: the original says nothing while it looks for its switches.
            let digits = rest.strip_prefix(['0', '1', '2', '3'])?;
            for joint in digits.chars() {
                let joint = joint.to_digit(10)? as usize;
                let start = self.plant.motors().get(joint)?.start;
                self.plant.find(joint);
                self.plant.put(joint, start);
            }
            return Some(write("JC", &[0.0; JOINTS]));
        }
        match line {
            "JP" => {
                let mut degrees = [0.0; JOINTS];
                for (place, motor) in degrees.iter_mut().zip(self.plant.place()) {
                    *place = motor.to_degrees();
                }
                Some(write("JP", &degrees))
            }
            "RE" => {
                self.plant.emergency_stop(false);
                Some("ES0".to_owned())
            }
            _ => None,
        }
    }
}

impl Device for RosDevice {
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
                self.plant.hold();
                self.is_greeted = false;
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
