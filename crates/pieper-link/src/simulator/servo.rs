//! A simulated I/O board with hobby servos.

use std::time::Duration;

use super::Device;
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::protocol::Lines;

/// The lag of a hobby servo, seconds.
const LAG: f64 = 0.05;

pub(super) struct ServoDevice {
    plant: Plant,
    lines: Lines,
    sent: Vec<u8>,
    last: Duration,
    boots_until: Duration,
}

impl ServoDevice {
    pub(super) fn new(motors: Vec<SimMotor>) -> Self {
        let plant = Plant::new(motors, LAG);
        let degrees = |motor: &f64| motor.to_degrees().round().clamp(0.0, 180.0) as u8;
        Self {
            sent: plant.place().iter().map(degrees).collect(),
            plant,
            lines: Lines::default(),
            last: Duration::ZERO,
            boots_until: Duration::ZERO,
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
