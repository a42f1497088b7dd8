//! Motors that move: with a lag, a largest rate, ends, an emergency stop, and steps that get lost.

use super::fault::Fault;
use crate::arm::Arm;

/// A simulated motor.
#[derive(Clone, Debug)]
pub struct SimMotor {
    /// Its name.
    pub name: String,
    /// Whether its value is an angle.
    pub is_angle: bool,
    /// The ends of its range, radians or metres.
    pub range: [f64; 2],
    /// Its largest rate, per second.
    pub rate: f64,
    /// Where it is when it is switched on.
    pub start: f64,
}

/// Ranges where the arm's description names none, and rates: angles and lengths.
const RANGES: [f64; 2] = [std::f64::consts::PI, 1.0];
const RATES: [f64; 2] = [std::f64::consts::PI, 1.0];

/// The motors of an arm: their own limits, or those of the joint they drive directly. They stand where the joints are at zero, or as
/// near as they can; of a drive that cannot be there, where the joints are in the middle of their ranges.
pub(super) fn motors(arm: &Arm) -> Vec<SimMotor> {
    let limits = |joint: usize| arm.chain.variables()[joint].limits;
    let zero = |joint| limits(joint).map_or(0.0, |l| 0.0_f64.clamp(l.lower(), l.upper()));
    let middle = |joint| limits(joint).map_or(0.0, |l| f64::midpoint(l.lower(), l.upper()));
    let mut start = vec![0.0; arm.dof()];
    for place in [&zero as &dyn Fn(usize) -> f64, &middle] {
        let q: Vec<f64> = (0..arm.dof()).map(place).collect();
        if matches!(arm.transmission.motors(&q, &mut start), Ok(Ok(()))) {
            break;
        }
    }
    let of = |(index, motor): (usize, &pieper::transmission::Motor)| {
        let variable = &arm.chain.variables()[index];
        let is_angle = arm.transmission.motor_kind(index).is_angular();
        let slot = usize::from(!is_angle);
        let is_joint = motor.kind() == pieper::transmission::MotorKind::Direct
            && motor.ratio() == 1.0
            && motor.offset() == 0.0;
        let limits = motor
            .limits()
            .or(variable.limits.filter(|_| is_joint))
            .map_or([-RANGES[slot], RANGES[slot]], |limits| {
                [limits.lower(), limits.upper()]
            });
        let rate = variable.velocity.unwrap_or(RATES[slot]) * motor.ratio().abs();
        SimMotor {
            name: motor.name().to_owned(),
            is_angle,
            range: limits,
            // A simulated controller is a little faster than what is asked of it.
            rate: rate * 1.2,
            start: start[index].clamp(limits[0], limits[1]),
        }
    };
    arm.transmission.all().iter().enumerate().map(of).collect()
}

/// All motors of an arm.
#[derive(Clone, Debug)]
pub struct Plant {
    motors: Vec<SimMotor>,
    /// Where they really are.
    place: Vec<f64>,
    target: Vec<f64>,
    /// Steps that were counted and not made.
    lost: Vec<f64>,
    /// The time constant of the lag, seconds.
    lag: f64,
    is_stopped: bool,
}

impl Plant {
    /// Motors at rest where they start.
    pub fn new(motors: Vec<SimMotor>, lag: f64) -> Self {
        let place: Vec<f64> = motors.iter().map(|motor| motor.start).collect();
        Self {
            lost: vec![0.0; motors.len()],
            target: place.clone(),
            place,
            motors,
            lag,
            is_stopped: false,
        }
    }

    /// The motors.
    pub fn motors(&self) -> &[SimMotor] {
        &self.motors
    }

    /// Where they are.
    pub fn place(&self) -> &[f64] {
        &self.place
    }

    /// Where the controller believes that they are.
    pub fn counted(&self, motor: usize) -> f64 {
        self.place[motor] + self.lost[motor]
    }

    /// Where they are going.
    pub fn target(&self) -> &[f64] {
        &self.target
    }

    /// Whether the emergency stop is pressed.
    pub fn is_stopped(&self) -> bool {
        self.is_stopped
    }

    /// Presses the emergency stop, or lets it go.
    pub fn emergency_stop(&mut self, pressed: bool) {
        self.is_stopped = pressed;
        self.hold();
    }

    /// Holds where the motors are.
    pub fn hold(&mut self) {
        for motor in 0..self.place.len() {
            self.target[motor] = self.counted(motor);
        }
    }

    /// Sends a motor somewhere, by the controller's count. It does not go past its ends.
    pub fn send(&mut self, motor: usize, value: f64) {
        if !self.is_stopped && value.is_finite() {
            self.target[motor] = value;
        }
    }

    /// Puts a motor somewhere at once, as the interpolating controllers do it.
    pub fn put(&mut self, motor: usize, value: f64) {
        if !self.is_stopped {
            let [lower, upper] = self.motors[motor].range;
            self.place[motor] = (value - self.lost[motor]).clamp(lower, upper);
            self.target[motor] = value;
        }
    }

    /// The first motor loses this much: it is counted and not moved.
    pub fn lose_steps(&mut self, much: f64) {
        if let (Some(lost), Some(place)) = (self.lost.first_mut(), self.place.first_mut()) {
            *lost += much;
            *place -= much;
        }
    }

    /// The motor is at its switch: count and place agree from now on.
    pub(super) fn find(&mut self, motor: usize) {
        self.place[motor] += self.lost[motor];
        self.lost[motor] = 0.0;
    }

    /// Suffers a fault that is the motors': the emergency stop, or this much lost.
    pub(super) fn suffer(&mut self, fault: Fault, lost: f64) {
        match fault {
            Fault::EmergencyStop => self.emergency_stop(true),
            Fault::LoseSteps => self.lose_steps(lost),
            _ => {}
        }
    }

    /// Whether the motor's count and its measured place differ by more than this.
    pub fn differs(&self, motor: usize, by: f64) -> bool {
        self.lost[motor].abs() > by
    }

    /// Lets time pass, in seconds.
    pub fn advance(&mut self, seconds: f64) {
        if self.is_stopped {
            return;
        }
        let share = match self.lag > 0.0 {
            true => 1.0 - (-seconds / self.lag).exp(),
            false => 1.0,
        };
        for (index, motor) in self.motors.iter().enumerate() {
            let goal = self.target[index] - self.lost[index];
            let way = (goal - self.place[index]) * share;
            let most = motor.rate * seconds;
            let place = self.place[index] + way.clamp(-most, most);
            self.place[index] = place.clamp(motor.range[0], motor.range[1]);
        }
    }
}
