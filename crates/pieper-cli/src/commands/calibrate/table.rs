//! Measurements as a table.

use std::fmt::Write as _;

use nalgebra::UnitQuaternion;
use pieper::calibration::{Measurement, Model, Readings, Seen, Unit};

use crate::error::Failure;

/// The columns of what the arm tells: joints or motors, in degrees and millimetres, as people read them.
pub(super) struct Columns {
    names: Vec<String>,
    /// What a number is multiplied with.
    factors: Vec<f64>,
}

impl Columns {
    /// As these measurements have it.
    pub(super) fn of(model: &Model, measurements: &[Measurement]) -> Result<Self, Failure> {
        let transmission = model.robot().transmission()?;
        let of_motors = matches!(
            measurements.first().map(|m| &m.readings),
            Some(Readings::Motors(_))
        );
        let variables = model.chain().variables().iter().enumerate();
        let column = |(index, variable): (usize, &pieper::model::Variable)| match of_motors {
            true => (
                transmission.all()[index].name().to_owned(),
                transmission.motor_kind(index).is_angular(),
            ),
            false => (variable.name.clone(), variable.kind.is_angular()),
        };
        let units = variables
            .map(column)
            .map(|(name, is_angle)| match is_angle {
                true => (format!("{name}_deg"), 1_f64.to_degrees()),
                false => (format!("{name}_mm"), 1e3),
            });
        let (names, factors) = units.unzip();
        Ok(Self { names, factors })
    }

    /// The header's part.
    pub(super) fn names(&self) -> String {
        self.names.join(",")
    }

    /// A row's part.
    pub(super) fn cells(&self, readings: &Readings, decimals: usize) -> String {
        let cells = readings.values().iter().zip(&self.factors);
        let cells = cells.map(|(value, factor)| format!("{:.decimals$}", value * factor));
        cells.collect::<Vec<_>>().join(",")
    }
}

/// A number with its unit, in those that people read.
pub(super) fn in_unit(unit: Unit, value: f64) -> (f64, &'static str) {
    match unit {
        Unit::Angle => (value.to_degrees(), "deg"),
        Unit::Length => (value * 1e3, "mm"),
        Unit::Ratio => (value * 1e3, "1/1000"),
    }
}

/// A table of measurements of one kind, with the true numbers as comments.
pub(super) fn csv(
    model: &Model,
    measurements: &[Measurement],
    truth: &[f64],
) -> Result<String, Failure> {
    let mut out = format!(
        "# Simulated measurements of an {} whose numbers are a little off.\n",
        model.robot().name
    );
    for (parameter, value) in model.parameters().iter().zip(truth) {
        let (off, unit) = in_unit(parameter.unit, value - parameter.nominal);
        let _ = writeln!(out, "# truth: {} {off:+.4} {unit}", parameter.name);
    }
    let seen = match measurements.first().map(|m| &m.seen) {
        Some(Seen::Pose(_)) => "x_mm,y_mm,z_mm,qw,qx,qy,qz",
        Some(Seen::Position { .. }) => "x_mm,y_mm,z_mm,px_mm,py_mm,pz_mm",
        Some(Seen::Distance { .. }) => "distance_mm,anchor",
        Some(Seen::Plane { .. }) => "plane",
        _ => "contact",
    };
    let columns = Columns::of(model, measurements)?;
    let _ = writeln!(out, "{},{seen},sigma_mm,sigma_angle_deg", columns.names());
    let mm = |xyz: [f64; 3]| {
        let [x, y, z] = xyz.map(|v| v * 1e3);
        format!("{x:.5},{y:.5},{z:.5}")
    };
    for measurement in measurements {
        let cells = match &measurement.seen {
            Seen::Pose(pose) => {
                let q = UnitQuaternion::from_rotation_matrix(&pose.rotation);
                format!(
                    "{},{:.9},{:.9},{:.9},{:.9}",
                    mm(pose.translation.vector.into()),
                    q.w,
                    q.i,
                    q.j,
                    q.k
                )
            }
            Seen::Position { point, at } => format!("{},{}", mm(*point), mm(*at)),
            Seen::Distance {
                anchor, distance, ..
            } => format!("{:.5},{anchor}", distance * 1e3),
            Seen::Plane { plane, .. } => plane.clone(),
            Seen::Contact { contact, .. } => contact.clone(),
        };
        let _ = writeln!(
            out,
            "{},{cells},{},{}",
            columns.cells(&measurement.readings, 8),
            measurement.sigma * 1e3,
            measurement.sigma_angle.to_degrees()
        );
    }
    Ok(out)
}
