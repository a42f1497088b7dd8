//! What to measure: postures chosen for what they say.

use std::fmt::Write as _;
use std::path::Path;

use pieper::calibration::{Calibration, Measurement, Model, Simulation, design, simulate};
use pieper::kinematics::tool_pose;
use serde_json::{Value, json};

use crate::error::Failure;

/// Postures that are chosen from: within the limits, and above the floor that the base stands on.
pub(super) const CANDIDATES: usize = 800;

pub(super) struct Plan {
    pub(super) chosen: Vec<Measurement>,
    /// The parameters' standard deviations by the plan, and by as many postures at random: geometric means of the ratios.
    gain: f64,
}

pub(super) fn of(model: &Model, simulation: &Simulation, budget: usize) -> Result<Plan, Failure> {
    let (_, candidates) = simulate(model, simulation)?;
    let is_above = |measurement: &Measurement| {
        let q = model.joints(&measurement.readings);
        q.and_then(|q| tool_pose(model.chain(), &q))
            .is_ok_and(|pose| (model.chain().base().inverse() * pose).translation.z > 0.0)
    };
    let above: Vec<Measurement> = candidates.iter().filter(|m| is_above(m)).cloned().collect();
    let candidates = if above.len() >= budget {
        above
    } else {
        candidates
    };
    let chosen = design(model, &candidates, budget)?;
    let chosen: Vec<Measurement> = chosen.into_iter().map(|k| candidates[k].clone()).collect();
    let sharpness = |measurements: Vec<Measurement>| {
        let result = Calibration::new(model.clone(), measurements)
            .ok()?
            .robust(false)
            .run()
            .ok()?;
        let diagonal = result.covariance.diagonal();
        let sum: f64 = diagonal.iter().map(|v| 0.5 * v.ln()).sum();
        Some((sum / diagonal.len() as f64).exp())
    };
    let random = candidates.iter().take(budget).cloned().collect();
    let gain = match (sharpness(chosen.clone()), sharpness(random)) {
        (Some(chosen), Some(random)) if chosen > 0.0 => random / chosen,
        _ => f64::NAN,
    };
    Ok(Plan { chosen, gain })
}

impl Plan {
    /// A table to fill in.
    pub(super) fn csv(&self, model: &Model) -> Result<String, Failure> {
        let mut out = String::from(
            "# Postures to measure, chosen for what they say: fill in what is seen there.\n",
        );
        let columns = super::table::Columns::of(model, &self.chosen)?;
        let _ = writeln!(out, "{},x_mm,y_mm,z_mm,qw,qx,qy,qz", columns.names());
        for measurement in &self.chosen {
            let cells = columns.cells(&measurement.readings, 3);
            let _ = writeln!(out, "{cells},,,,,,,");
        }
        Ok(out)
    }

    pub(super) fn text(&self, out: &Path) -> String {
        let gain = match self.gain.is_finite() {
            true => format!(
                "; parameters {:.1} times as sharp as by as many at random",
                self.gain
            ),
            false => String::new(),
        };
        format!(
            "{} postures to measure, written to {}{gain}\n",
            self.chosen.len(),
            out.display()
        )
    }

    pub(super) fn document(&self, out: &Path) -> Value {
        json!({
            "out": out.display().to_string(),
            "postures": self.chosen.iter().map(|m| m.readings.values()).collect::<Vec<_>>(),
            "gain": self.gain.is_finite().then_some(self.gain),
        })
    }
}
