//! Between motors and joints: what drives an arm, and how far.
//!
//! A [`Transmission`] has one [`Motor`] for each variable of a chain. A motor drives its joint directly, as a weighted
//! sum of joints (parallelograms, wrists whose shafts run through one another), through a [`FourBar`] linkage, or as a
//! servo within a window. Joint values become motor values and back; [`Ratios`] carries speeds, torques and Jacobians
//! over. What a drive cannot reach is an answer, [`OutOfReach`], that names the drive and says by how much; it is no
//! error, and it is not a matter of the joints' own limits.
//!
//! ```
//! use pieper::describe::Robot;
//! let text = r#"
//! name = "two links, the second counted against the ground"
//! convention = "standard"
//! [[joint]]
//! theta = "q1"
//! a = 0.3
//! [[joint]]
//! theta = "q2"
//! a = 0.2
//! [[transmission]]
//! kind = "linear"
//! motor = "m2"
//! joints = { q1 = 1, q2 = 1 }
//! "#;
//! let transmission = Robot::from_toml("two.toml", text)?.transmission()?;
//! let mut motors = [0.0; 2];
//! transmission.motors(&[0.5, 0.25], &mut motors)?.expect("no limits");
//! assert_eq!(motors, [0.5, 0.75]);
//! let mut joints = [0.0; 2];
//! transmission.joints(&motors, &mut joints)?.expect("no limits");
//! assert_eq!(joints, [0.5, 0.25]);
//! # Ok::<(), pieper::Error>(())
//! ```

mod answer;
mod four_bar;
mod motor;
mod plan;
mod range;
mod ratios;
mod sections;

pub use answer::{OutOfReach, Past, Quantity};
pub use four_bar::{Assembly, FourBar, Lengths};
pub use motor::{Linkage, Motor, MotorKind};
pub use ratios::Ratios;
pub use sections::{DeadPoint, Rest, Section, Span};

use crate::error::{Error, Result};
use crate::model::{Chain, JointKind};
use plan::Block;

/// The motors of an arm, one for each of its variables.
///
/// The joint vector's order is the chain's; motor `k` stands in the place of variable `k`, and drives it directly unless
/// it was given otherwise.
#[derive(Clone, Debug)]
pub struct Transmission {
    motors: Vec<Motor>,
    /// Whether each variable is an angle.
    angular: Vec<bool>,
    blocks: Vec<Block>,
}

/// Two transmissions of equal motors on equal joints are equal: the rest follows.
impl PartialEq for Transmission {
    fn eq(&self, other: &Self) -> bool {
        self.motors == other.motors && self.angular == other.angular
    }
}

impl Transmission {
    /// The transmission of a chain, with these motors in the places of these variables; the others are driven directly
    /// by motors named `m1`, `m2`, ...
    ///
    /// # Errors
    /// A model error for a place or a joint that the chain does not have, a place given twice, or motors that do not
    /// determine the joints; if a four-bar's rocker and other joints could only be found together.
    pub fn new(chain: &Chain, motors: impl IntoIterator<Item = (usize, Motor)>) -> Result<Self> {
        let count = chain.dof();
        let mut places: Vec<Option<Motor>> = vec![None; count];
        for (place, motor) in motors {
            let error = |text: String| Err(Error::model(format!("motor {}", motor.name()), text));
            let beyond = |index: &usize| *index >= count;
            if let Some(joint) = motor.variables().chain([place]).find(beyond) {
                let text = format!("there is no joint {}: the arm has {count}", joint + 1);
                return error(text);
            }
            if places[place].is_some() {
                return error(format!(
                    "two motors stand in the place of joint {}",
                    place + 1
                ));
            }
            places[place] = Some(motor);
        }
        let direct = |place: usize| Motor::direct(format!("m{}", place + 1), place);
        let motors: Vec<Motor> = places
            .into_iter()
            .enumerate()
            .map(|(place, motor)| motor.unwrap_or_else(|| direct(place)))
            .collect();
        Ok(Self {
            blocks: plan::blocks(&motors)?,
            angular: chain
                .variables()
                .iter()
                .map(|variable| variable.kind.is_angular())
                .collect(),
            motors,
        })
    }

    /// The number of motors, and of joints.
    pub fn dof(&self) -> usize {
        self.motors.len()
    }

    /// The motors.
    pub fn all(&self) -> &[Motor] {
        &self.motors
    }

    /// Whether every motor drives its joint directly: motor values are joint values then.
    pub fn is_direct(&self) -> bool {
        let is_direct = |motor: &Motor| motor.kind() == MotorKind::Direct;
        self.motors.iter().all(is_direct)
    }

    /// Whether the motor's value is an angle: always, except where it drives directly a joint that slides.
    pub fn motor_kind(&self, motor: usize) -> JointKind {
        let slides = |motor: &Motor| motor.variables().any(|joint| !self.angular[joint]);
        match self.motors.get(motor) {
            Some(motor) if motor.kind() == MotorKind::Direct && slides(motor) => {
                JointKind::Prismatic
            }
            _ => JointKind::Revolute,
        }
    }

    /// One motor's value at the joint vector `q`.
    ///
    /// A four-bar's rocker is taken modulo whole turns, as the linkage is; sums are not.
    ///
    /// # Errors
    /// An input error unless there is such a motor and `q` has one finite value for each joint. Within: the drive's answer.
    pub fn motor(&self, motor: usize, q: &[f64]) -> Result<Result<f64, OutOfReach<'_>>> {
        self.check(q, "joint")?;
        let Some(motor) = self.motors.get(motor) else {
            let text = format!("there are {}", self.dof());
            return Err(Error::input(format!("motor {}", motor + 1), text));
        };
        let value = motor.value(q);
        Ok(value.and_then(|value| motor.check_limits(value).map(|()| value)))
    }

    /// The motor values at the joint vector `q`, into `motors`.
    ///
    /// # Errors
    /// An input error unless `q` has one finite value and `motors` room for each joint. Within: the first drive that
    /// cannot reach `q`; the values before it are set.
    pub fn motors(&self, q: &[f64], motors: &mut [f64]) -> Result<Result<(), OutOfReach<'_>>> {
        self.check(q, "joint")?;
        self.check_room(motors.len(), "motor")?;
        for (out, motor) in motors.iter_mut().zip(&self.motors) {
            let value = motor.value(q);
            match value.and_then(|value| motor.check_limits(value).map(|()| value)) {
                Ok(value) => *out = value,
                Err(answer) => return Ok(Err(answer)),
            }
        }
        Ok(Ok(()))
    }

    /// The joint vector at the motor values, into `q`.
    ///
    /// Of a four-bar the rocker's angle in the section it works in, as an angle of that section.
    ///
    /// # Errors
    /// An input error unless `motors` has one finite value and `q` room for each joint. Within: the first motor whose
    /// value lies past its limits or past a dead point.
    pub fn joints(&self, motors: &[f64], q: &mut [f64]) -> Result<Result<(), OutOfReach<'_>>> {
        self.check(motors, "motor")?;
        self.check_room(q.len(), "joint")?;
        for (motor, &value) in self.motors.iter().zip(motors) {
            if let Err(answer) = motor.check_limits(value) {
                return Ok(Err(answer));
            }
        }
        for block in &self.blocks {
            if let Err(answer) = self.solve(block, motors, q) {
                return Ok(Err(answer));
            }
        }
        Ok(Ok(()))
    }

    fn solve(&self, block: &Block, values: &[f64], q: &mut [f64]) -> Result<(), OutOfReach<'_>> {
        if let ([motor], [joint]) = (&block.motors[..], &block.joints[..]) {
            q[*joint] = self.motors[*motor].solve(values[*motor], *joint, q)?;
            return Ok(());
        }
        // The joints of the block at zero, what is left of each motor's value is the block's doing.
        block.joints.iter().for_each(|&joint| q[joint] = 0.0);
        for &motor in &block.motors {
            self.motors[motor].value(q)?;
        }
        let rest = |motor: usize, q: &[f64]| {
            let at_zero = self.motors[motor].value(q).unwrap_or(f64::NAN);
            values[motor] - at_zero
        };
        let mut found = [0.0; MAX_BLOCK];
        for (row, value) in found.iter_mut().enumerate().take(block.joints.len()) {
            let columns = block.motors.iter().enumerate();
            *value = columns
                .map(|(column, &motor)| block.inverse[(row, column)] * rest(motor, q))
                .sum();
        }
        for (&joint, value) in block.joints.iter().zip(found) {
            q[joint] = value;
        }
        Ok(())
    }

    fn check(&self, values: &[f64], of: &str) -> Result<()> {
        if values.len() != self.dof() {
            let text = format!("{} were expected, {} were given", self.dof(), values.len());
            return Err(Error::input(format!("{of} values"), text));
        }
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => {
                let subject = format!("{of} value {} = {}", index + 1, values[index]);
                Err(Error::input(subject, "a finite number was expected"))
            }
        }
    }

    fn check_room(&self, room: usize, of: &str) -> Result<()> {
        if room == self.dof() {
            return Ok(());
        }
        let text = format!(
            "room for {} was expected, there is room for {room}",
            self.dof()
        );
        Err(Error::input(format!("{of} values"), text))
    }
}

/// Joints that can only be found together: more than this is no arm's gear, and would need memory of its own.
const MAX_BLOCK: usize = 16;
