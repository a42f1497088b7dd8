//! Where the tool is by the model, and how it moves with each parameter.

use nalgebra::{Rotation3, Translation3, Unit, Vector3};

use super::drives::Driven;
use super::model::{Elementary, Model};
use crate::describe::Readings;
use crate::spatial::{Pose, shift};
use crate::transmission::Transmission;

/// A model with values of its parameters.
pub(super) struct Valued<'a> {
    model: &'a Model,
    values: &'a [f64],
    /// `None` where the values make no drives.
    transmission: Option<Transmission>,
}

/// Where the tool is, and how it moves with each parameter.
#[derive(Clone, Debug)]
pub(super) struct Sensed {
    pub(super) tool: Pose,
    /// For each parameter: the tool frame's angular and linear rate, base axes.
    pub(super) rates: Vec<[Vector3<f64>; 2]>,
}

impl Model {
    /// The model with these values of its parameters; there may be more values, of the measurement's own.
    pub(super) fn with<'a>(&'a self, values: &'a [f64]) -> Valued<'a> {
        Valued {
            model: self,
            values,
            transmission: self.drives.with(&self.chain, values).ok(),
        }
    }

    /// How the tool frame moves with each parameter while the arm's sensors tell the same: angular and linear rate in the base's axes, for a
    /// unit a second. `None` where the drives cannot reach what the sensors tell.
    ///
    /// As many values as parameters and as many readings as joints are expected.
    pub fn rates(&self, values: &[f64], readings: &Readings) -> Option<Vec<[Vector3<f64>; 2]>> {
        Some(self.with(values).sense(readings)?.rates)
    }
}

/// An axis that something turns about, or slides along: whether it turns, the axis times what a unit does, and a point on it.
type Axis = (bool, Vector3<f64>, Vector3<f64>);

impl Valued<'_> {
    /// The joint values, and how they move with each parameter of the drives.
    fn joints(&self, readings: &Readings) -> Option<(Vec<f64>, Driven)> {
        match readings {
            Readings::Joints(q) => Some((q.clone(), Vec::new())),
            Readings::Motors(motors) => {
                let transmission = self.transmission.as_ref()?;
                let mut q = vec![0.0; motors.len()];
                transmission.joints(motors, &mut q).ok()?.ok()?;
                let rates = self.model.drives.rates(transmission, &q)?;
                Some((q, rates))
            }
        }
    }

    /// The pose of one element at joint values.
    fn displacement(&self, element: &Elementary, q: &[f64]) -> f64 {
        let own = element.parameter.map_or(element.value, |p| self.values[p]);
        let driven = element.drive.map_or(0.0, |(joint, sign, gear)| {
            sign * gear.map_or(1.0, |g| self.values[g]) * q[joint]
        });
        own + driven
    }

    /// Where the tool is, and how it moves with each parameter. `None` where the drives cannot reach what the sensors tell.
    pub(super) fn sense(&self, readings: &Readings) -> Option<Sensed> {
        let (q, driven) = self.joints(readings)?;
        let mut frame = Pose::identity();
        let still = (false, Vector3::zeros(), Vector3::zeros());
        let mut moves: Vec<Axis> = vec![still; self.model.parameters.len()];
        let mut joints: Vec<Axis> = vec![still; q.len()];
        for element in &self.model.elements {
            let axis = Vector3::ith(element.axis, 1.0);
            let along = frame.rotation * axis;
            let place = frame.translation.vector;
            if let Some(parameter) = element.parameter {
                moves[parameter] = (element.turns, along, place);
            }
            if let Some((joint, sign, gear)) = element.drive {
                let factor = sign * gear.map_or(1.0, |g| self.values[g]);
                joints[joint] = (element.turns, along * factor, place);
                if let Some(gear) = gear {
                    moves[gear] = (element.turns, along * (sign * q[joint]), place);
                }
            }
            let by = self.displacement(element, &q);
            frame *= match element.turns {
                true => Pose::from_parts(
                    Translation3::identity(),
                    Rotation3::from_axis_angle(&Unit::new_unchecked(axis), by),
                ),
                false => shift(axis * by),
            };
        }
        let tool = frame.translation.vector;
        let rate = |&(turns, along, place): &Axis| match turns {
            true => [along, along.cross(&(tool - place))],
            false => [Vector3::zeros(), along],
        };
        let mut rates: Vec<[Vector3<f64>; 2]> = moves.iter().map(rate).collect();
        for (parameter, by_joint) in driven {
            let twists = joints.iter().map(rate).zip(by_joint.iter());
            rates[parameter] = twists.fold(rates[parameter], |[w, v], ([turn, shift], by)| {
                [w + turn * *by, v + shift * *by]
            });
        }
        Some(Sensed { tool: frame, rates })
    }
}
