//! A simulated ABB controller: calls every 4 ms, follows with a lag, and stops as its program would.

use std::time::Duration;

use nalgebra::{IsometryMatrix3, Quaternion, Translation3, UnitQuaternion};
use pieper::ik::Solver;

use super::Device;
use super::fault::Fault;
use super::plant::{Plant, SimMotor};
use crate::arm::Arm;
use crate::protocol::egm::{
    Clock, Header, Joints, MessageKind, Motors, Planned, Pose, Rapid, Robot, Running, Sensor,
};

/// The controller's cycle.
const CYCLE: Duration = Duration::from_millis(4);

/// The lag between a position and the arm, seconds: 10 to 20 ms in the controller's documentation.
const LAG: f64 = 0.015;

/// The controller's `\CommTimeout`: the longest silence after the first answer.
const TIMEOUT: Duration = Duration::from_secs(1);

/// `\MaxSpeedDeviation` stands in for this: how far a position may be from where the arm is, radians.
const JUMP: f64 = 0.35;

/// Joints in the list of the arm's own.
const OWN: usize = 6;

pub(super) struct EgmDevice {
    plant: Plant,
    arm: Arm,
    /// For positions of the tool. `None` for an arm whose inverse is not to be had.
    solver: Option<Solver>,
    sequence: u32,
    motors: Motors,
    running: Running,
    rapid: Rapid,
    last: Duration,
    heard: Option<Duration>,
    answered: Option<u32>,
    /// What its clock is off by.
    jump: Duration,
    boots_until: Duration,
}

impl EgmDevice {
    pub(super) fn new(motors: Vec<SimMotor>, arm: &Arm) -> Self {
        Self {
            plant: Plant::new(motors, LAG),
            arm: arm.clone(),
            solver: Solver::new(&arm.chain).ok(),
            sequence: 0,
            motors: Motors::On,
            running: Running::Running,
            rapid: Rapid::Running,
            last: Duration::ZERO,
            heard: None,
            answered: None,
            jump: Duration::ZERO,
            boots_until: Duration::ZERO,
        }
    }

    fn fail(&mut self) {
        self.running = Running::Error;
        self.rapid = Rapid::Stopped;
        self.plant.hold();
    }

    /// The motor values that a position asks for. `None` where it is none.
    fn wanted(&self, planned: &Planned) -> Option<Vec<f64>> {
        let count = self.plant.motors().len();
        if let Some(joints) = &planned.joints {
            let externals = planned.externals.unwrap_or_default();
            let degrees = joints.degrees().iter().chain(externals.degrees());
            let wanted: Vec<f64> = degrees.take(count).map(|d| d.to_radians()).collect();
            return (wanted.len() == count).then_some(wanted);
        }
        self.of_pose(&planned.pose?)
    }

    /// The solution nearest to where the arm is.
    fn of_pose(&self, pose: &Pose) -> Option<Vec<f64>> {
        let ([x, y, z], [w, i, j, k]) = (pose.position?, pose.quaternion?);
        let turn = UnitQuaternion::try_new(Quaternion::new(w, i, j, k), 1e-6)?;
        let place = Translation3::new(x * 1e-3, y * 1e-3, z * 1e-3);
        let goal = IsometryMatrix3::from_parts(place, turn.to_rotation_matrix());
        let mut here = vec![0.0; self.plant.place().len()];
        self.arm
            .transmission
            .joints(self.plant.place(), &mut here)
            .ok()?
            .ok()?;
        let solver = self.solver.as_ref()?;
        let solutions = solver.solve(&goal).ok()?;
        let families = solutions.families().iter();
        let members = families.filter_map(|family| solver.nearest_member(family, &here).ok());
        let all = solutions.iter().map(|solution| solution.q().to_vec());
        let way = |q: &[f64]| -> f64 { q.iter().zip(&here).map(|(a, b)| (a - b).powi(2)).sum() };
        let nearest = (all.chain(members)).min_by(|a, b| way(a).total_cmp(&way(b)))?;
        let mut motors = vec![0.0; here.len()];
        self.arm
            .transmission
            .motors(&nearest, &mut motors)
            .ok()?
            .ok()?;
        Some(motors)
    }

    fn told(&self) -> Planned {
        let degrees = self.plant.place().iter().map(|motor| motor.to_degrees());
        let externals = Joints::of(degrees.clone().skip(OWN));
        Planned {
            joints: Some(Joints::of(degrees.take(OWN))),
            externals: (!externals.degrees().is_empty()).then_some(externals),
            clock: Some(Clock {
                seconds: self.last.as_secs(),
                micros: u64::from(self.last.subsec_micros()),
            }),
            pose: None,
        }
    }
}

impl Device for EgmDevice {
    fn receive(&mut self, now: Duration, bytes: &[u8], _: &mut Vec<u8>) {
        let Some(sensor) = Sensor::read(bytes) else {
            return;
        };
        let header = sensor.header;
        let is_new =
            self.answered.is_none_or(|last| header.sequence > last) || header.sequence == 0;
        if header.kind != MessageKind::Correction || !is_new || self.running != Running::Running {
            return;
        }
        self.answered = Some(header.sequence);
        self.heard = Some(now);
        let Some(wanted) = sensor.planned.and_then(|planned| self.wanted(&planned)) else {
            return self.fail();
        };
        for (index, motor) in self.plant.motors().iter().enumerate() {
            let [lower, upper] = motor.range;
            let is_far = (wanted[index] - self.plant.place()[index]).abs() > JUMP;
            if !(lower - 1e-9..=upper + 1e-9).contains(&wanted[index]) || is_far {
                return self.fail();
            }
        }
        for (index, value) in wanted.iter().enumerate() {
            self.plant.send(index, *value);
        }
    }

    fn tick(&mut self, now: Duration, out: &mut Vec<u8>) {
        let seconds = now.saturating_sub(self.last).as_secs_f64();
        self.last = now;
        self.plant.advance(seconds);
        if now < self.boots_until {
            return;
        }
        if self
            .heard
            .is_some_and(|heard| now.saturating_sub(heard) > TIMEOUT)
        {
            // ERR_UDPUC_COMM: the program ends.
            self.heard = None;
            self.running = Running::Stopped;
            self.rapid = Rapid::Stopped;
            self.plant.hold();
        }
        let told = self.told();
        let robot = Robot {
            header: Header {
                sequence: self.sequence,
                time: (now + self.jump).as_millis() as u32,
                kind: MessageKind::Data,
            },
            feedback: Some(told),
            planned: Some(told),
            motors: self.motors,
            running: self.running,
            has_converged: false,
            rapid: self.rapid,
            utilization: Some(12.5),
        };
        robot.write(out);
        self.sequence += 1;
    }

    fn period(&self) -> Duration {
        CYCLE
    }

    fn inject(&mut self, now: Duration, fault: Fault) {
        match fault {
            Fault::Reset => {
                self.boots_until = now + Duration::from_millis(300);
                self.sequence = 0;
                (self.heard, self.answered) = (None, None);
                (self.motors, self.running) = (Motors::Off, Running::Undefined);
                self.rapid = Rapid::Undefined;
                self.plant.hold();
            }
            Fault::EmergencyStop => {
                self.plant.emergency_stop(true);
                (self.motors, self.running) = (Motors::Off, Running::Stopped);
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
