//! The motors along a motion: their values at every sample, and where a drive cannot follow.

use std::fmt::Write as _;

use pieper::describe::Robot;
use pieper::transmission::Transmission;

use super::names;
use super::recording::Recording;
use super::samples::{cell, number};
use crate::commands::motors;
use crate::error::Failure;

/// The name of the file.
pub(super) const FILE: &str = "motors.csv";

/// For an arm whose motors do not all drive their joints directly.
pub(super) struct Drives {
    transmission: Transmission,
    /// A row for each sample: a value for each motor, none where the drive cannot reach the joint values.
    rows: Vec<Vec<Option<f64>>>,
    /// A sentence for each motor that cannot follow.
    pub(super) warnings: Vec<String>,
}

impl Drives {
    /// `None` where motor values are joint values.
    pub(super) fn along(robot: &Robot, recording: &Recording) -> Result<Option<Self>, Failure> {
        let Some(transmission) = motors::of(robot)? else {
            return Ok(None);
        };
        let mut rows = vec![Vec::with_capacity(transmission.dof()); recording.times.len()];
        let mut warnings = Vec::new();
        for motor in 0..transmission.dof() {
            // How far past its end the drive is at worst, the sentence for it, and how often it is.
            let mut worst: Option<(f64, String)> = None;
            let mut count = 0;
            for (row, (time, q)) in rows
                .iter_mut()
                .zip(recording.times.iter().zip(&recording.joints))
            {
                let answer = transmission.motor(motor, q)?;
                row.push(answer.ok());
                let Err(answer) = answer else { continue };
                count += 1;
                if worst.as_ref().is_none_or(|(by, _)| answer.by() > *by) {
                    let time = names::trimmed(*time, 3);
                    worst = Some((answer.by(), format!("at t = {time} s {answer}")));
                }
            }
            if let Some((_, sentence)) = worst {
                let samples = names::count(count, "sample is", "samples are");
                warnings.push(format!("{sentence}; {samples} out of this drive's reach"));
            }
        }
        Ok(Some(Self {
            transmission,
            rows,
            warnings,
        }))
    }

    /// Times and motor values, radians and metres; an empty cell where a drive cannot reach.
    pub(super) fn csv(&self, times: &[f64]) -> String {
        let mut out = String::from("t");
        for motor in self.transmission.all() {
            let _ = write!(out, ",{}", cell(motor.name()));
        }
        for (time, row) in times.iter().zip(&self.rows) {
            let _ = write!(out, "\n{}", number(*time));
            for value in row {
                let _ = write!(out, ",{}", value.map_or(String::new(), number));
            }
        }
        out.push('\n');
        out
    }
}
