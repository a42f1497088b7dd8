//! A simulated board with the ROS driver's firmware. Like the original it checks ranges badly: the host must.

use std::time::Duration;

use super::Device;
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::Lines;
use crate::protocol::ros::{JOINTS, VERSION, read, write};

/// The lag of its steppers, seconds.
const LAG: f64 = 0.02;

pub(super) struct RosDevice {
    plant: Plant,
    lines: Lines,
    is_greeted: bool,
    last: Duration,
    boots_until: Duration,
}

impl RosDevice {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        Self {
            plant: Plant::new(motors, LAG),
            lines: Lines::default(),
            is_greeted: false,
            last: Duration::ZERO,
            boots_until: Duration::ZERO,
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
        if now < self.boots_until {
            return;
        }
        let mut lines = Vec::new();
        self.lines
            .push(bytes, |line| lines.extend(line.map(str::to_owned)));
        for line in lines {
            if let Some(answer) = self.answer(&line) {
                out.extend_from_slice(answer.as_bytes());
                out.extend_from_slice(b"\r\n");
            }
        }
    }

    fn tick(&mut self, now: Duration, _: &mut Vec<u8>) {
        let seconds = now.saturating_sub(self.last).as_secs_f64();
        self.last = now;
        self.plant.advance(seconds);
    }

    fn period(&self) -> Duration {
        Duration::from_millis(5)
    }

    fn inject(&mut self, now: Duration, fault: Fault) {
        match fault {
            Fault::Reset => {
                self.plant.hold();
                self.is_greeted = false;
                self.lines = Lines::default();
                self.boots_until = now + Duration::from_millis(800);
            }
            Fault::EmergencyStop => self.plant.emergency_stop(true),
            Fault::LoseSteps => self.plant.lose_steps(0.5),
            // It has no clock on the wire.
            _ => {}
        }
    }

    fn motors(&self) -> Vec<f64> {
        self.plant.place().to_vec()
    }
}
