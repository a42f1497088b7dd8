//! The bounds that every set-point keeps.

use std::fmt;
use std::sync::Arc;

use pieper::model::Limits;
use pieper::motion::{Law, Limited, Profile, State};

use crate::arm::Arm;

/// Rates where the arm's description names none: 60 deg/s and 0.25 m/s.
const RATES: [f64; 2] = [std::f64::consts::FRAC_PI_3, 0.25];

/// Accelerations where the arm's description names none: full rate within a quarter of a second.
const PER_SECOND: f64 = 4.0;

/// Rounding is no excess.
const ROUNDING: f64 = 1.0 + 1e-9;

/// Why something is not done, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal(pub String);

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Refusal {}

impl From<String> for Refusal {
    fn from(text: String) -> Self {
        Self(text)
    }
}

/// Joint limits, motor limits, rates and accelerations of an arm.
#[derive(Clone, Debug)]
pub struct Envelope {
    arm: Arc<Arm>,
    rates: Vec<f64>,
    accelerations: Vec<f64>,
}

impl Envelope {
    /// The envelope of an arm, at a share of its rates and accelerations; a share outside 0.01 to 1 counts as the nearer end.
    ///
    /// Where the arm's description names no rate or acceleration, 60 deg/s and 0.25 m/s are taken, reached in a quarter of a second.
    pub fn of(arm: Arc<Arm>, share: f64) -> Self {
        let share = if share.is_finite() {
            share.clamp(0.01, 1.0)
        } else {
            0.01
        };
        let mut rates = Vec::with_capacity(arm.dof());
        let mut accelerations = Vec::with_capacity(arm.dof());
        for variable in arm.chain.variables() {
            let usual = RATES[usize::from(!variable.kind.is_angular())];
            let rate = variable.velocity.unwrap_or(usual);
            rates.push(rate * share);
            accelerations.push(variable.acceleration.unwrap_or(rate * PER_SECOND) * share);
        }
        Self {
            arm,
            rates,
            accelerations,
        }
    }

    /// The arm.
    pub fn arm(&self) -> &Arc<Arm> {
        &self.arm
    }

    /// The largest rates, rad/s or m/s.
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }

    /// The largest accelerations, rad/s^2 or m/s^2.
    pub fn accelerations(&self) -> &[f64] {
        &self.accelerations
    }

    /// Whether the arm may be at `q`.
    ///
    /// # Errors
    /// A refusal that names the joint or the motor: not a number, outside its limits, out of the drive's reach.
    pub fn allows(&self, q: &[f64]) -> Result<(), Refusal> {
        if q.len() != self.arm.dof() {
            return Err(Refusal(format!(
                "{} joint values were expected, {} were given",
                self.arm.dof(),
                q.len()
            )));
        }
        for (joint, (&value, variable)) in q.iter().zip(self.arm.chain.variables()).enumerate() {
            let name = &variable.name;
            if !value.is_finite() {
                return Err(Refusal(format!("{name} = {value}: no number")));
            }
            if let Some(limits) = variable.limits.filter(|limits| !limits.contains(value)) {
                return Err(self.outside(joint, value, limits));
            }
        }
        for motor in 0..self.arm.dof() {
            let answer = self.arm.transmission.motor(motor, q);
            let answer = answer.map_err(|error| Refusal(error.to_string()))?;
            answer.map_err(|past| Refusal(past.to_string()))?;
        }
        Ok(())
    }

    /// Whether the joints may go from `from` to `to` within `seconds`: within their limits, and not faster than they may. A joint that is
    /// outside its limits, because it was moved there by hand, may come back; the others keep theirs. The motors are looked at where
    /// their values are computed.
    ///
    /// # Errors
    /// A refusal that names the joint.
    pub fn allows_step(&self, from: &[f64], to: &[f64], seconds: f64) -> Result<(), Refusal> {
        for (joint, variable) in self.arm.chain.variables().iter().enumerate() {
            let way = (to[joint] - from[joint]).abs();
            // Asked this way round, what is no number is refused too.
            let fits = way <= self.rates[joint] * seconds * ROUNDING + 1e-12;
            if !fits {
                return Err(Refusal(format!(
                    "{} would turn at {} per second, its largest rate is {}",
                    variable.name,
                    self.arm.shown(joint, way / seconds),
                    self.arm.shown(joint, self.rates[joint])
                )));
            }
            let Some(limits) = variable.limits else {
                continue;
            };
            let beyond = |value: f64| {
                (limits.lower() - value)
                    .max(value - limits.upper())
                    .max(0.0)
            };
            let comes_back = beyond(from[joint]) > 0.0 && beyond(to[joint]) <= beyond(from[joint]);
            if !limits.contains(to[joint]) && !comes_back {
                return Err(self.outside(joint, to[joint], limits));
            }
        }
        Ok(())
    }

    fn outside(&self, joint: usize, value: f64, limits: Limits) -> Refusal {
        Refusal(format!(
            "{} = {} is outside its limits, {} to {}",
            self.arm.joint_name(joint),
            self.arm.shown(joint, value),
            self.arm.shown(joint, limits.lower()),
            self.arm.shown(joint, limits.upper())
        ))
    }

    /// Whether a motion may be run as it is: every row allowed, rates and accelerations within theirs, the motors' too.
    ///
    /// # Errors
    /// A refusal that names the time and the joint; for rates, with the factor by which the motion should be slower.
    pub fn allows_motion(&self, law: &Law) -> Result<(), Refusal> {
        if law.profile() == Profile::Linear && law.rows().len() > 1 {
            return Err(Refusal(
                "with the profile linear the rates jump at every row, which no arm can follow: take cubic, \
                 quintic or trapezoid"
                    .to_owned(),
            ));
        }
        for (time, row) in law.times().iter().zip(law.rows()) {
            self.allows(row)
                .map_err(|refusal| Refusal(format!("t = {time} s: {refusal}")))?;
        }
        self.allows_speeds(law)?;
        self.allows_between(law)
    }

    fn allows_speeds(&self, law: &Law) -> Result<(), Refusal> {
        let profile = law.profile();
        // The factor by which times must grow; accelerations fall with its square.
        let mut worst: Option<(f64, String)> = None;
        let moves = law.times().windows(2).zip(law.rows().windows(2));
        for (times, rows) in moves {
            let duration = times[1] - times[0];
            for joint in 0..self.arm.dof() {
                let way = (rows[1][joint] - rows[0][joint]).abs();
                let rate = way * profile.peak_rate() / duration;
                let acceleration =
                    profile.peak_acceleration().unwrap_or(0.0) * way / (duration * duration);
                let bounds = [
                    (Limited::Rate, rate, self.rates[joint], 1.0),
                    (
                        Limited::Acceleration,
                        acceleration,
                        self.accelerations[joint],
                        0.5,
                    ),
                ];
                for (limited, value, bound, power) in bounds {
                    let factor = (value / bound).powf(power);
                    let is_worse = worst.as_ref().is_none_or(|(worst, _)| factor > *worst);
                    if factor > ROUNDING && is_worse {
                        let unit = match limited {
                            Limited::Acceleration => "/s²",
                            _ => "/s",
                        };
                        let shown = |value| format!("{}{unit}", self.arm.shown(joint, value));
                        let name = self.arm.joint_name(joint);
                        let text = format!(
                            "t = {} s: {name} would reach {}, it may {}",
                            times[0],
                            shown(value),
                            shown(bound)
                        );
                        worst = Some((factor, text));
                    }
                }
            }
        }
        match worst {
            None => Ok(()),
            Some((factor, text)) => {
                // Rounded so that what is advised suffices.
                let speed = (100.0 / factor).floor() / 100.0;
                Err(Refusal(format!(
                    "{text}; at {speed} of its speed the motion could be run"
                )))
            }
        }
    }

    /// Between the rows the joints go straight, the motors of a linkage do not: they are looked at along the way.
    fn allows_between(&self, law: &Law) -> Result<(), Refusal> {
        if self.arm.transmission.is_direct() {
            return Ok(());
        }
        let mut state = State::default();
        for times in law.times().windows(2) {
            let steps = 64;
            for step in 1..steps {
                let share = f64::from(step) / f64::from(steps);
                let time = times[0] + (times[1] - times[0]) * share;
                law.at(time, &mut state);
                self.allows(&state.position)
                    .map_err(|refusal| Refusal(format!("t = {time:.3} s: {refusal}")))?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hand has put one joint outside its limits: it may come back, and lets no other joint out.
    #[test]
    fn a_joint_that_comes_back_lets_no_other_out() {
        let robot = pieper_robots::find("ar4").unwrap().robot();
        let envelope = Envelope::of(Arc::new(Arm::of(&robot).unwrap()), 1.0);
        let step = |from: [f64; 2], to: [f64; 2]| {
            let all = |[one, two]: [f64; 2]| [one, two, 0.0, 0.0, 0.0, 0.0].map(f64::to_radians);
            envelope.allows_step(&all(from), &all(to), 0.1)
        };
        // J1 turns 170 degrees either way, J2 from -42 to 90.
        assert!(step([172.0, 0.0], [171.0, 0.0]).is_ok());
        assert!(step([171.0, 0.0], [172.0, 0.0]).is_err());
        let refusal = step([172.0, 89.5], [171.0, 90.5]).unwrap_err().to_string();
        assert!(
            refusal.contains("J2 = 90.50° is outside its limits"),
            "{refusal}"
        );
        assert!(step([0.0, 0.0], [f64::NAN, 0.0]).is_err());
    }
}
