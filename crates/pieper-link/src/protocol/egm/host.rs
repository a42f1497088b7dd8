//! The program's side of EGM: answers every datagram of the controller, once it is armed.

use std::sync::Arc;
use std::time::Duration;

use super::message::{
    Header, Joints, MessageKind, Motors, Planned, Pose, Rapid, Robot, Running, Sensor,
};
use crate::arm::Arm;
use crate::protocol::{Event, Host, Pace, Setup};

/// The controller's fastest cycle.
const CYCLE: Duration = Duration::from_millis(4);

/// Joints that an arm has in the list of its own; a seventh travels among the external axes.
const OWN: usize = 6;

/// A conversation with an ABB controller.
pub struct EgmHost {
    poses_of: Option<Arc<Arm>>,
    measured: Vec<f64>,
    has_measured: bool,
    robot: Option<Robot>,
    /// Our own count of this session.
    sequence: u32,
    is_armed: bool,
    /// Whether the last datagram waits for its answer.
    is_owed: bool,
    /// Joint values for the pose mode.
    joints: Vec<f64>,
    started: Duration,
}

impl EgmHost {
    /// A conversation that has not begun.
    pub fn new(setup: Setup) -> Self {
        let count = setup.motors.len();
        Self {
            poses_of: setup.poses_of,
            measured: vec![0.0; count],
            has_measured: false,
            robot: None,
            sequence: 0,
            is_armed: false,
            is_owed: false,
            joints: vec![0.0; count],
            started: Duration::ZERO,
        }
    }

    /// Why the controller takes no positions, if it does not.
    fn obstacle(robot: &Robot) -> Option<&'static str> {
        match (robot.motors, robot.running, robot.rapid) {
            (Motors::On, Running::Running, Rapid::Running) => None,
            (Motors::Off, ..) => Some("its motors are off: switch them on"),
            (_, Running::Error, _) => {
                Some("its motion controller reports an error: see its event log")
            }
            (_, Running::Stopped, _) => {
                Some("EGM is not running: its own program must call EGMRunJoint or EGMRunPose")
            }
            (.., Rapid::Stopped) => Some("its own program stands: start it"),
            // After a restart the states are not told; that is no permission.
            _ => Some("it does not tell that motors, EGM and its own program are running"),
        }
    }

    /// Takes up the position told; whether it is one.
    fn take(&mut self, robot: &Robot) -> Result<(), String> {
        let feedback = robot.feedback.unwrap_or_default();
        let own = feedback.joints.unwrap_or_default();
        let externals = feedback.externals.unwrap_or_default();
        let wanted = self.measured.len().min(OWN);
        if own.degrees().len() != wanted {
            return Err(format!(
                "{} joints were told, {wanted} were expected",
                own.degrees().len()
            ));
        }
        let told = own.degrees().iter().chain(externals.degrees());
        if told.clone().count() < self.measured.len() {
            return Err("the seventh joint was not told".to_owned());
        }
        if told.clone().any(|degrees| !degrees.is_finite()) {
            return Err("a joint that is no number was told".to_owned());
        }
        for (place, degrees) in self.measured.iter_mut().zip(told) {
            *place = degrees.to_radians();
        }
        self.has_measured = true;
        Ok(())
    }

    fn begin(&mut self, now: Duration, robot: &Robot, events: &mut Vec<Event>) {
        if self.is_armed {
            self.is_armed = false;
            let text = "the controller began a new session: it was restarted, or its program was";
            events.push(Event::Fault(text.to_owned()));
        }
        self.sequence = 0;
        self.started = now;
        let has_time = robot.feedback.is_some_and(|f| f.clock.is_some());
        let version = match (robot.utilization, has_time) {
            (Some(_), _) => "RobotWare 6.10 or later",
            (_, true) => "RobotWare 6.07 or later",
            _ => "RobotWare before 6.07, whose units are not to be relied on",
        };
        let mode = if self.poses_of.is_some() {
            "pose"
        } else {
            "joint"
        };
        events.push(Event::Identified(format!(
            "an ABB controller ({version}), {mode} mode"
        )));
    }

    fn planned(&mut self, motors: &[f64]) -> Option<Planned> {
        let mut planned = Planned::default();
        match &self.poses_of {
            None => {
                let mut degrees = motors.iter().map(|motor| motor.to_degrees());
                planned.joints = Some(Joints::of(degrees.by_ref().take(OWN)));
                if motors.len() > OWN {
                    planned.externals = Some(Joints::of(degrees));
                }
            }
            Some(arm) => {
                arm.transmission
                    .joints(motors, &mut self.joints)
                    .ok()?
                    .ok()?;
                let tool =
                    pieper::kinematics::tool_pose_by_quaternions(&arm.chain, &self.joints).ok()?;
                let (p, q) = (tool.translation.vector, tool.rotation);
                planned.pose = Some(Pose {
                    position: Some([p.x * 1e3, p.y * 1e3, p.z * 1e3]),
                    quaternion: Some([q.w, q.i, q.j, q.k]),
                    euler: None,
                });
            }
        }
        Some(planned)
    }
}

impl Host for EgmHost {
    fn pace(&self) -> Pace {
        Pace::Answer(CYCLE)
    }

    // The controller begins, and what it is answered is a position: before it is armed, there is nothing to say.
    fn poll(&mut self, _: Duration, _: &mut Vec<u8>, _: &mut Vec<Event>) {}

    fn receive(&mut self, now: Duration, bytes: &[u8], events: &mut Vec<Event>) {
        let Some(robot) = Robot::read(bytes) else {
            let length = bytes.len();
            let text = format!("a datagram of {length} bytes that is no EgmRobot");
            return events.push(Event::Noise(text));
        };
        let previous = self.robot.map(|robot| robot.header.sequence);
        let sequence = robot.header.sequence;
        match previous {
            // A count that runs on is the same session; one that starts again is a new one.
            Some(previous) if sequence > previous => {}
            Some(previous) if sequence != 0 && previous.wrapping_sub(sequence) < 50 => {
                let text = "a datagram that came twice, or late";
                return events.push(Event::Noise(text.to_owned()));
            }
            _ => self.begin(now, &robot, events),
        }
        if let Err(text) = self.take(&robot) {
            return events.push(Event::Noise(text));
        }
        self.robot = Some(robot);
        self.is_owed = true;
        events.push(Event::Measured);
        if self.is_armed
            && let Some(obstacle) = Self::obstacle(&robot)
        {
            self.is_armed = false;
            events.push(Event::Fault(format!("the controller stopped: {obstacle}")));
        }
    }

    fn measured(&self) -> Option<&[f64]> {
        self.has_measured.then_some(&self.measured)
    }

    fn arm(&mut self, _: Duration, _: &mut Vec<u8>, events: &mut Vec<Event>) {
        let obstacle = match &self.robot {
            Some(robot) => Self::obstacle(robot),
            None => Some("it has not called: only its own program can begin"),
        };
        match obstacle {
            None => {
                self.is_armed = true;
                events.push(Event::Armed);
            }
            Some(obstacle) => events.push(Event::Refused(format!(
                "the controller takes no positions: {obstacle}"
            ))),
        }
    }

    fn is_ready(&self) -> bool {
        self.is_armed && self.is_owed
    }

    fn set_point(&mut self, now: Duration, motors: &[f64], _: Duration, out: &mut Vec<u8>) {
        let Some(planned) = self.planned(motors) else {
            return;
        };
        let sensor = Sensor {
            header: Header {
                sequence: self.sequence,
                time: now.saturating_sub(self.started).as_millis() as u32,
                kind: MessageKind::Correction,
            },
            planned: Some(planned),
            speeds: None,
        };
        sensor.write(out);
        self.sequence = self.sequence.wrapping_add(1);
        self.is_owed = false;
    }

    // Silence is the only way to say it: the controller holds its last position, and its own time-out ends EGM.
    fn stop(&mut self, _: Duration, _: &mut Vec<u8>) {
        self.is_armed = false;
    }

    fn patience(&self) -> Duration {
        Duration::from_millis(100)
    }

    fn latency(&self) -> Option<Duration> {
        None
    }
}
