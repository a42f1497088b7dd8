//! Motor values in the program's answers, for arms whose motors do not all drive their joints directly.

use pieper::Result;
use pieper::describe::Robot;
use pieper::model::JointKind;
use pieper::transmission::Transmission;
use serde_json::{Map, Value, json};

/// The arm's transmission; `None` where motor values are joint values.
pub(super) fn of(robot: &Robot) -> Result<Option<Transmission>> {
    if robot.motors.is_empty() {
        return Ok(None);
    }
    Ok(Some(robot.transmission()?))
}

/// Whether the motor's value is an angle.
pub(super) fn is_angle(transmission: &Transmission, motor: usize) -> bool {
    transmission.motor_kind(motor) != JointKind::Prismatic
}

/// The motors at one joint vector.
#[derive(Clone, Debug)]
pub(super) struct Motors {
    /// A value for each motor, and whether it is an angle; none where the drive cannot reach the joint vector.
    values: Vec<(Option<f64>, bool)>,
    /// Which drive cannot and why, in words.
    pub(super) reason: Option<String>,
}

impl Motors {
    pub(super) fn at(transmission: &Transmission, q: &[f64]) -> Result<Self> {
        let mut values = Vec::with_capacity(transmission.dof());
        let mut reasons = Vec::new();
        for index in 0..transmission.dof() {
            let answer = transmission.motor(index, q)?;
            if let Err(answer) = answer {
                reasons.push(answer.to_string());
            }
            values.push((answer.ok(), is_angle(transmission, index)));
        }
        let reason = (!reasons.is_empty()).then(|| reasons.join("; "));
        Ok(Self { values, reason })
    }

    pub(super) fn are_reached(&self) -> bool {
        self.reason.is_none()
    }

    /// The values in the units of the answer.
    pub(super) fn in_units(&self, deg: bool) -> impl Iterator<Item = Option<f64>> {
        self.values.iter().map(move |&(value, is_angle)| {
            value.map(|value| match deg && is_angle {
                true => value.to_degrees(),
                false => value,
            })
        })
    }

    /// `"motors"`, null for a drive that cannot reach, and then `"drive"` with the reason.
    pub(super) fn fields(&self, deg: bool) -> Map<String, Value> {
        let mut fields = Map::new();
        let values: Vec<Option<f64>> = self.in_units(deg).collect();
        fields.insert("motors".to_owned(), json!(values));
        if let Some(reason) = &self.reason {
            fields.insert("drive".to_owned(), json!(reason));
        }
        fields
    }

    /// The values for a person's table, `-` for a drive that cannot reach.
    pub(super) fn cells(&self, deg: bool) -> impl Iterator<Item = String> {
        self.in_units(deg)
            .map(|value| value.map_or("-".to_owned(), crate::text::number))
    }
}
