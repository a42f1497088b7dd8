//! The motors of an arm as a robot file describes them.

use super::expr::{Expr, Values};
use crate::error::Result;
use crate::model::{Chain, Drive, Limits};
use crate::transmission::{Assembly, FourBar, Lengths, Motor};

/// One `[[transmission]]`: the motor in the place of a joint, and what it drives. Numbers may be formulas.
#[derive(Clone, Debug, PartialEq)]
pub struct MotorExpr {
    /// The place in the motor vector, from 0: that of the joint with the same number.
    pub place: usize,
    /// The motor's name; `m1`..`mn` unless the file gives one.
    pub name: String,
    /// What it drives, and how.
    pub coupling: CouplingExpr,
}

/// How a motor drives its joints. See [`Motor`] for the equations.
#[derive(Clone, Debug, PartialEq)]
pub enum CouplingExpr {
    /// `offset + ratio * sum of factors * joints`
    Linear {
        /// Joints by index, with their factors.
        joints: Vec<(usize, Expr)>,
        /// Gear and zero.
        gear: GearExpr,
    },
    /// `offset + ratio * (frame_angle + psi(rocker_angle))`
    FourBar {
        /// Crank, coupler, rocker, frame.
        lengths: Box<[Expr; 4]>,
        /// Which of the two.
        assembly: Assembly,
        /// The angle of the rocker, 0 where it is perpendicular to the frame.
        rocker_angle: AngleExpr,
        /// The turn of the frame against the link the crank's pivot stands on; `None` if they are one.
        frame_angle: Option<AngleExpr>,
        /// Gear and zero.
        gear: GearExpr,
    },
    /// `centre + sign * ratio * joint`, within the window
    Servo {
        /// The joint's index.
        joint: usize,
        /// The servo's angle where the joint is at zero; `None`: the middle of the window.
        centre: Option<Expr>,
        /// +1 or -1.
        sign: f64,
        /// Servo turns for one of the joint.
        ratio: Expr,
        /// The angles it can turn to.
        window: [Expr; 2],
    },
}

/// Motor turns for one of the shaft, the motor's value where the shaft is at zero, and its limits.
#[derive(Clone, Debug, PartialEq)]
pub struct GearExpr {
    /// Motor turns for one of the shaft; negative if the motor turns the other way.
    pub ratio: Expr,
    /// The motor's value where the shaft is at zero.
    pub offset: Expr,
    /// The range of the motor's value.
    pub limits: Option<[Expr; 2]>,
}

/// An angle that follows a joint: `offset + q` or `offset - q`.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleExpr {
    /// The joint's index.
    pub joint: usize,
    /// +1 or -1.
    pub sign: f64,
    /// The angle where the joint is at zero.
    pub offset: Expr,
}

impl MotorExpr {
    /// The motor, with these values for the symbols.
    ///
    /// # Errors
    /// A missing-value error for a symbol without a value; a model error for numbers that make no motor.
    pub fn motor(&self, chain: &Chain, values: &Values) -> Result<Motor> {
        match &self.coupling {
            CouplingExpr::Linear { joints, gear } => {
                let term = |(joint, factor): &(usize, Expr)| {
                    Ok(Drive {
                        variable: *joint,
                        factor: factor.evaluate(values)?,
                        offset: 0.0,
                    })
                };
                let terms: Vec<Drive> = joints.iter().map(term).collect::<Result<_>>()?;
                gear.apply(Motor::linear(&self.name, terms)?, values)
            }
            CouplingExpr::FourBar {
                lengths,
                assembly,
                rocker_angle,
                frame_angle,
                gear,
            } => {
                let [crank, coupler, rocker, frame] = &**lengths;
                let lengths = Lengths {
                    crank: crank.evaluate(values)?,
                    coupler: coupler.evaluate(values)?,
                    rocker: rocker.evaluate(values)?,
                    frame: frame.evaluate(values)?,
                };
                let four_bar = FourBar::new(lengths, *assembly).map_err(|error| {
                    crate::Error::model(format!("motor {}", self.name), error.to_string())
                })?;
                let rocker = rocker_angle.drive(values)?;
                let frame = frame_angle
                    .as_ref()
                    .map(|angle| angle.drive(values))
                    .transpose()?;
                let works_at = working_value(chain, &four_bar, &rocker);
                let motor = Motor::four_bar(&self.name, four_bar, rocker, frame, works_at)?;
                gear.apply(motor, values)
            }
            CouplingExpr::Servo {
                joint,
                centre,
                sign,
                ratio,
                window,
            } => {
                let motor = Motor::servo(&self.name, *joint, limits(&self.name, window, values)?)?;
                let centre = centre.as_ref().map(|centre| centre.evaluate(values));
                let centre = centre.transpose()?.unwrap_or(motor.offset());
                motor.geared(sign * ratio.evaluate(values)?, centre)
            }
        }
    }

    /// The same, every formula replaced by its number.
    ///
    /// # Errors
    /// A missing-value error for a symbol without a value.
    pub fn in_numbers(&self, values: &Values) -> Result<Self> {
        let mut motor = self.clone();
        for expr in motor.exprs_mut() {
            *expr = Expr::number(expr.evaluate(values)?);
        }
        Ok(motor)
    }

    fn exprs_mut(&mut self) -> Vec<&mut Expr> {
        match &mut self.coupling {
            CouplingExpr::Linear { joints, gear } => {
                let factors = joints.iter_mut().map(|(_, factor)| factor);
                factors.chain(gear.exprs_mut()).collect()
            }
            CouplingExpr::FourBar {
                lengths,
                rocker_angle,
                frame_angle,
                gear,
                ..
            } => {
                let offsets = frame_angle.iter_mut().map(|angle| &mut angle.offset);
                let own = lengths.iter_mut().chain([&mut rocker_angle.offset]);
                own.chain(offsets).chain(gear.exprs_mut()).collect()
            }
            CouplingExpr::Servo {
                centre,
                ratio,
                window,
                ..
            } => window.iter_mut().chain(centre).chain([ratio]).collect(),
        }
    }
}

impl GearExpr {
    fn apply(&self, motor: Motor, values: &Values) -> Result<Motor> {
        let motor = motor.geared(self.ratio.evaluate(values)?, self.offset.evaluate(values)?)?;
        match &self.limits {
            None => Ok(motor),
            Some(ends) => {
                let limits = limits(motor.name(), ends, values)?;
                Ok(motor.limited(limits))
            }
        }
    }

    fn exprs_mut(&mut self) -> impl Iterator<Item = &mut Expr> {
        let limits = self.limits.iter_mut().flatten();
        [&mut self.ratio, &mut self.offset]
            .into_iter()
            .chain(limits)
    }
}

impl AngleExpr {
    fn drive(&self, values: &Values) -> Result<Drive> {
        Ok(Drive {
            variable: self.joint,
            factor: self.sign,
            offset: self.offset.evaluate(values)?,
        })
    }
}

fn limits(name: &str, ends: &[Expr; 2], values: &Values) -> Result<Limits> {
    let limits = Limits::new(ends[0].evaluate(values)?, ends[1].evaluate(values)?);
    limits.map_err(|error| crate::Error::model(format!("motor {name}"), error.to_string()))
}

/// A joint value at which the linkage works: the middle of the joint's limits, or else zero.
fn working_value(chain: &Chain, four_bar: &FourBar, rocker: &Drive) -> f64 {
    let variable = chain.variables().get(rocker.variable);
    let middle = variable
        .and_then(|variable| variable.limits)
        .map(|limits| f64::midpoint(limits.lower(), limits.upper()));
    let works = |value: &f64| {
        let phi = rocker.factor.mul_add(*value, rocker.offset);
        four_bar.section_at(phi).is_some()
    };
    middle.filter(works).unwrap_or(0.0)
}
