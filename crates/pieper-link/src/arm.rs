//! The arm at the other end, as the link sees it.

use pieper::Result;
use pieper::describe::Robot;
use pieper::model::{Chain, Limits};
use pieper::transmission::Transmission;

/// An arm and what drives it: joint values on the program's side, motor values on the wire.
///
/// An arm without a transmission has motors that are its joints. Radians and metres on both sides.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The robot's name.
    pub name: String,
    /// The kinematic chain, with its limits.
    pub chain: Chain,
    /// From joints to motors and back.
    pub transmission: Transmission,
}

impl Arm {
    /// The arm that a robot description tells of.
    ///
    /// # Errors
    /// A model error where the description has no numbers, or motors that do not determine the joints.
    pub fn of(robot: &Robot) -> Result<Self> {
        Ok(Self {
            name: robot.name.clone(),
            chain: robot.chain()?,
            transmission: robot.transmission()?,
        })
    }

    /// The same number of servos from 0 to 180 degrees, each a joint of its own: what an arm is before its servos are matched.
    ///
    /// # Errors
    /// None today: such a chain can always be made.
    pub fn with_bare_servos(&self) -> Result<Self> {
        let mut parts = self.chain.parts().clone();
        for (variable, motor) in parts.variables.iter_mut().zip(self.transmission.all()) {
            motor.name().clone_into(&mut variable.name);
            variable.limits = Some(Limits::new(0.0, std::f64::consts::PI)?);
        }
        let chain = Chain::new(parts)?;
        Ok(Self {
            name: self.name.clone(),
            transmission: Transmission::new(&chain, [])?,
            chain,
        })
    }

    /// The number of joints, and of motors.
    pub fn dof(&self) -> usize {
        self.chain.dof()
    }

    /// Whether the joint's value is an angle.
    pub fn is_angle(&self, joint: usize) -> bool {
        self.chain.variables()[joint].kind.is_angular()
    }

    /// The joint's name.
    pub fn joint_name(&self, joint: usize) -> &str {
        &self.chain.variables()[joint].name
    }

    /// A value of a joint for people: degrees or millimetres, with the unit.
    pub fn shown(&self, joint: usize, value: f64) -> String {
        let (value, unit) = match self.is_angle(joint) {
            true => (value.to_degrees(), "°"),
            false => (value * 1000.0, " mm"),
        };
        // Rounded before it is printed, and what is nothing has no sign.
        let rounded = (value * 100.0).round() / 100.0 + 0.0;
        format!("{rounded:.2}{unit}")
    }

    /// What the controllers' side must know: which motors turn and which slide, and their names.
    pub fn motors(&self) -> Vec<MotorOf> {
        (0..self.dof())
            .map(|index| MotorOf {
                name: self.transmission.all()[index].name().to_owned(),
                is_angle: self.transmission.motor_kind(index).is_angular(),
            })
            .collect()
    }
}

/// One motor, as a protocol needs it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MotorOf {
    /// Its name.
    pub name: String,
    /// Whether its value is an angle, rather than a length.
    pub is_angle: bool,
}
