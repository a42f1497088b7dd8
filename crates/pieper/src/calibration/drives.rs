//! The numbers of an arm's drives that may be wrong, and how its joints move with them where the motors are known.

use nalgebra::DVector;

use super::parameter::{Group, Parameter, Unit};
use crate::describe::Robot;
use crate::describe::drives::{CouplingExpr, GearExpr, MotorExpr};
use crate::describe::expr::{Expr, Values};
use crate::error::Result;
use crate::model::Chain;
use crate::transmission::{Motor, Ratios, Transmission};

/// Spreads: 3 degrees for zeros, 2 percent for what is a ratio, or only counts as one: a linkage's lengths all doubled are the same drive.
const ZERO: f64 = 0.05;
const SHARE: f64 = 0.02;

/// Which number of a motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    /// Its value where the shaft is at zero.
    Offset,
    /// Its turns for one of the shaft, without their sign where it is told apart.
    Ratio,
    /// How much this joint, of those it does not stand in the place of, turns its shaft.
    Factor(usize),
    /// A length of its linkage: crank, coupler, rocker, frame.
    Length(usize),
    /// The angle of the rocker where its joint is at zero.
    Rocker,
    /// And of the frame.
    Frame,
}

#[derive(Clone, Copy, Debug)]
struct Number {
    /// The motor, among those of the description.
    motor: usize,
    what: What,
    parameter: usize,
}

/// For each parameter of the drives, how the joints move with it.
pub(super) type Driven = Vec<(usize, DVector<f64>)>;

/// The motors of an arm, in numbers, of which some are parameters.
#[derive(Clone, Debug)]
pub(super) struct Drives {
    motors: Vec<MotorExpr>,
    numbers: Vec<Number>,
}

impl Drives {
    /// The drives as described; their numbers join the parameters where they are to be estimated.
    pub(super) fn of(
        robot: &Robot,
        chain: &Chain,
        are_parameters: bool,
        parameters: &mut Vec<Parameter>,
    ) -> Result<Self> {
        let values = robot.values()?;
        let motors = robot.motors.iter().map(|motor| motor.in_numbers(&values));
        let mut motors: Vec<MotorExpr> = motors.collect::<Result<_>>()?;
        let mut numbers = Vec::new();
        for (index, motor) in motors.iter_mut().enumerate().filter(|_| are_parameters) {
            let name = motor.name.clone();
            for (what, expr) in numbers_of(motor) {
                let nominal = expr.evaluate(&Values::new())?;
                let (word, unit, spread) = match what {
                    What::Offset => ("offset".to_owned(), Unit::Angle, ZERO),
                    What::Ratio => ("ratio".to_owned(), Unit::Ratio, SHARE * nominal.abs()),
                    What::Factor(joint) => {
                        (chain.variables()[joint].name.clone(), Unit::Ratio, SHARE)
                    }
                    What::Length(which) => {
                        (LENGTHS[which].to_owned(), Unit::Length, SHARE * nominal)
                    }
                    What::Rocker => ("rocker_angle".to_owned(), Unit::Angle, ZERO),
                    What::Frame => ("frame_angle".to_owned(), Unit::Angle, ZERO),
                };
                numbers.push(Number {
                    motor: index,
                    what,
                    parameter: parameters.len(),
                });
                parameters.push(Parameter {
                    name: format!("{name}.{word}"),
                    group: Group::Drive,
                    unit,
                    nominal,
                    spread,
                });
            }
        }
        Ok(Self { motors, numbers })
    }

    /// The motors with these values of the parameters.
    pub(super) fn motors_with(&self, values: &[f64]) -> Vec<MotorExpr> {
        let mut motors = self.motors.clone();
        for number in &self.numbers {
            let mut own = numbers_of(&mut motors[number.motor]);
            let found = own.iter_mut().find(|(what, _)| *what == number.what);
            if let Some((_, expr)) = found {
                **expr = Expr::number(values[number.parameter]);
            }
        }
        motors
    }

    /// The transmission with these values of the parameters.
    pub(super) fn with(&self, chain: &Chain, values: &[f64]) -> Result<Transmission> {
        let numbers = Values::new();
        let motors = self.motors_with(values);
        let motors = motors
            .iter()
            .map(|motor| Ok((motor.place, motor.motor(chain, &numbers)?)));
        Transmission::new(chain, motors.collect::<Result<Vec<_>>>()?)
    }

    /// How the joints move with each parameter of the drives while the motors stand still: a motor's value is to stay, so what the parameter
    /// does to it the joints must undo. `None` at a dead point.
    pub(super) fn rates(&self, transmission: &Transmission, q: &[f64]) -> Option<Driven> {
        if self.numbers.is_empty() {
            return Some(Vec::new());
        }
        let mut ratios = Ratios::zeros(q.len());
        transmission.ratios(q, &mut ratios).ok()?.ok()?;
        let mut rates = Vec::with_capacity(self.numbers.len());
        for number in &self.numbers {
            let place = self.motors[number.motor].place;
            let rate = number.what.rate(&transmission.all()[place], q)?;
            let column = ratios.joints_by_motors().column(place);
            rates.push((number.parameter, column * -rate));
        }
        Some(rates)
    }
}

const LENGTHS: [&str; 4] = ["crank", "coupler", "rocker", "frame"];

/// The numbers of a motor that may be wrong. Its own joint's factor is its ratio's, and no number of its own.
fn numbers_of(motor: &mut MotorExpr) -> Vec<(What, &mut Expr)> {
    let place = motor.place;
    match &mut motor.coupling {
        CouplingExpr::Linear { joints, gear: own } => {
            let others = joints.iter_mut().filter(|(joint, _)| *joint != place);
            let factors = others.map(|(joint, factor)| (What::Factor(*joint), factor));
            gear(own).into_iter().chain(factors).collect()
        }
        CouplingExpr::FourBar {
            lengths,
            rocker_angle,
            frame_angle,
            gear: own,
            ..
        } => {
            let lengths = lengths.iter_mut().enumerate();
            let lengths = lengths.map(|(which, length)| (What::Length(which), length));
            let frame = frame_angle.iter_mut();
            let frame = frame.map(|angle| (What::Frame, &mut angle.offset));
            let rocker = (What::Rocker, &mut rocker_angle.offset);
            let gear = gear(own).into_iter();
            gear.chain(lengths).chain([rocker]).chain(frame).collect()
        }
        CouplingExpr::Servo {
            centre,
            ratio,
            window,
            ..
        } => {
            let none = Values::new();
            let ends = window.each_ref().map(|end| end.evaluate(&none));
            let middle = match ends {
                [Ok(lower), Ok(upper)] => f64::midpoint(lower, upper),
                _ => f64::NAN,
            };
            let centre = centre.get_or_insert_with(|| Expr::number(middle));
            vec![(What::Offset, centre), (What::Ratio, ratio)]
        }
    }
}

impl What {
    /// How the motor's value grows with the number, at the joint vector `q`.
    fn rate(self, motor: &Motor, q: &[f64]) -> Option<f64> {
        let terms = motor.terms().iter();
        let sum: f64 = terms.map(|term| term.displacement(q)).sum();
        let linkage = motor.linkage();
        let phi = match linkage {
            Some(linkage) => linkage.section.place(linkage.rocker.displacement(q)).ok(),
            None => None,
        };
        Some(match self {
            Self::Offset => 1.0,
            Self::Ratio => {
                let psi = match linkage {
                    Some(linkage) => linkage.four_bar.crank_angle(phi?)?,
                    None => 0.0,
                };
                // A servo's ratio is written without its sign.
                let sign = match motor.kind() {
                    crate::transmission::MotorKind::Servo => motor.ratio().signum(),
                    _ => 1.0,
                };
                sign * (sum + psi)
            }
            Self::Factor(joint) => motor.ratio() * q[joint],
            Self::Length(which) => motor.ratio() * linkage?.four_bar.rates(phi?)?[which],
            Self::Rocker => motor.ratio() * linkage?.four_bar.ratio(phi?)?,
            Self::Frame => motor.ratio(),
        })
    }
}

fn gear(GearExpr { ratio, offset, .. }: &mut GearExpr) -> [(What, &mut Expr); 2] {
    [(What::Offset, offset), (What::Ratio, ratio)]
}
