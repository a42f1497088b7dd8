//! What came out: text, JSON, a page with figures, and the words in the robot file.

use std::fmt::Write as _;
use std::path::Path;

use pieper::calibration::{Estimate, Measurement, Outcome, Residual, Unit};
use pieper_plot::{Panel, Section, Series, Table, TimeChart, chart_along};
use serde_json::{Value, json};

use super::table::in_unit;
use crate::error::Failure;
use crate::text;

pub(super) struct Report<'a> {
    pub(super) robot: &'a str,
    pub(super) file: &'a str,
    pub(super) measurements: &'a [Measurement],
    pub(super) result: &'a Outcome,
}

/// Correlations above this are named.
const CORRELATED: f64 = 0.98;

/// A value in the unit people read it in.
fn shown(estimate: &Estimate, value: f64, decimals: usize) -> String {
    format!("{:.decimals$}", in_unit(estimate.unit, value).0)
}

fn rms(residuals: &[Residual]) -> f64 {
    let sum: f64 = residuals.iter().map(|r| r.length * r.length).sum();
    (sum / residuals.len().max(1) as f64).sqrt()
}

impl Report<'_> {
    /// Where the numbers of the robot file come from.
    pub(super) fn source(&self) -> String {
        let mut out = format!(
            "Identified by pieper calibrate from {} measurements in {}. Nominal arm: {}. Residuals {:.4} mm before, {:.4} mm after (root mean square).\n",
            self.measurements.len(),
            self.file,
            self.robot,
            rms(&self.result.before) * 1e3,
            rms(&self.result.after) * 1e3
        );
        out.push_str("Parameter: nominal, identified, standard deviation (mm, deg, thousandths of ratios).\n");
        for estimate in &self.result.estimates {
            let sigma = match estimate.sigma {
                Some(sigma) => shown(estimate, sigma, 5),
                None => "held".to_owned(),
            };
            let _ = writeln!(
                out,
                "{}: {}, {}, {sigma}",
                estimate.name,
                shown(estimate, estimate.nominal, 5),
                shown(estimate, estimate.value, 5)
            );
        }
        out
    }

    /// Sentences that a person must know.
    fn remarks(&self) -> Vec<String> {
        let result = self.result;
        let mut out = Vec::new();
        if !result.converged {
            out.push(format!(
                "It did not converge ({}): this is the best that was found.",
                result.ending
            ));
        }
        for held in &result.held {
            out.push(format!("{}: {} is held.", held.sentence(), held.name));
        }
        if !result.outliers.is_empty() {
            let rows: Vec<String> = result
                .outliers
                .iter()
                .map(|k| (k + 1).to_string())
                .collect();
            out.push(format!(
                "Measurements that do not agree with the others, and count nothing or little: rows {}.",
                rows.join(", ")
            ));
        }
        if result.variance > 4.0 || result.variance < 0.25 {
            out.push(format!(
                "What is left is {:.2} times what sigma says: are the standard deviations right, is a parameter missing?",
                result.variance.sqrt()
            ));
        }
        for i in 0..result.fitted.len() {
            for j in 0..i {
                let r = result.correlation[(i, j)];
                if r.abs() > CORRELATED {
                    let name = |k: usize| &result.estimates[result.fitted[k]].name;
                    out.push(format!(
                        "{} and {} are hard to tell apart here (correlation {r:.3}).",
                        name(j),
                        name(i)
                    ));
                }
            }
        }
        out
    }

    fn rows(&self) -> Vec<Vec<String>> {
        let row = |estimate: &Estimate| {
            let interval = match estimate.sigma {
                // 95 % of a normal distribution.
                Some(sigma) => format!("± {}", shown(estimate, 1.96 * sigma, 4)),
                None => "held".to_owned(),
            };
            vec![
                estimate.name.clone(),
                shown(estimate, estimate.nominal, 4),
                shown(estimate, estimate.value, 4),
                format!(
                    "{}",
                    Signed(shown(estimate, estimate.value - estimate.nominal, 4))
                ),
                interval,
                in_unit(estimate.unit, 0.0).1.to_owned(),
            ]
        };
        self.result.estimates.iter().map(row).collect()
    }

    fn facts(&self) -> Vec<(&'static str, String)> {
        let result = self.result;
        let worst = |residuals: &[Residual]| residuals.iter().map(|r| r.length).fold(0.0, f64::max);
        let mut out = vec![
            ("measurements", self.measurements.len().to_string()),
            (
                "parameters",
                format!("{} fitted, {} held", result.fitted.len(), result.held.len()),
            ),
            (
                "before",
                format!(
                    "{:.4} mm, at most {:.4}",
                    rms(&result.before) * 1e3,
                    worst(&result.before) * 1e3
                ),
            ),
            (
                "after",
                format!(
                    "{:.4} mm, at most {:.4}",
                    rms(&result.after) * 1e3,
                    worst(&result.after) * 1e3
                ),
            ),
        ];
        if let Some(held_out) = &result.held_out {
            out.push((
                "predicted",
                format!(
                    "{:.4} mm where it was not measured ({} fits), {:.4} before",
                    held_out.after * 1e3,
                    held_out.folds,
                    held_out.before * 1e3
                ),
            ));
        }
        out.push(("condition", format!("{:.0}", result.condition)));
        out
    }

    pub(super) fn text(&self, out: &Path, page: &Path) -> String {
        let mut text = format!("{}\n", self.robot);
        let facts = self.facts().into_iter();
        text.push_str(&text::listing(
            &facts
                .map(|(name, value)| vec![name.to_owned(), value])
                .collect::<Vec<_>>(),
        ));
        let mut rows = vec![
            [
                "parameter",
                "nominal",
                "identified",
                "difference",
                "95 %",
                "unit",
            ]
            .map(str::to_owned)
            .to_vec(),
        ];
        rows.extend(self.rows());
        text.push_str(&text::table(&rows));
        for remark in self.remarks() {
            let _ = writeln!(text, "{remark}");
        }
        let _ = writeln!(text, "written: {}  {}", out.display(), page.display());
        text
    }

    pub(super) fn document(&self, out: &Path, page: &Path) -> Value {
        let result = self.result;
        let residual = |(before, after): (&Residual, &Residual)| {
            json!({
                "before": before.length, "after": after.length, "angle_before": before.angle, "angle_after": after.angle,
                "weight": after.weight,
            })
        };
        let estimate = |estimate: &Estimate| {
            json!({
                "name": estimate.name, "nominal": estimate.nominal, "value": estimate.value, "sigma": estimate.sigma,
                "unit": match estimate.unit { Unit::Angle => "rad", Unit::Length => "m", Unit::Ratio => "1" },
            })
        };
        let held = |held: &pieper::calibration::Held| {
            let with = held
                .with
                .iter()
                .map(|w| json!({ "name": w.name, "factor": w.factor }));
            json!({ "name": held.name, "with": with.collect::<Value>(), "sentence": held.sentence() })
        };
        let matrix = |m: &nalgebra::DMatrix<f64>| -> Value {
            m.row_iter()
                .map(|row| row.iter().copied().collect::<Value>())
                .collect()
        };
        json!({
            "robot": self.robot, "measurements": self.measurements.len(), "converged": result.converged, "ending": result.ending,
            "out": out.display().to_string(), "report": page.display().to_string(),
            "parameters": result.estimates.iter().map(estimate).collect::<Value>(),
            "held": result.held.iter().map(held).collect::<Value>(),
            "fitted": result.fitted.iter().map(|&k| result.estimates[k].name.as_str()).collect::<Value>(),
            "covariance": matrix(&result.covariance), "correlation": matrix(&result.correlation), "condition": result.condition,
            "residuals": result.before.iter().zip(&result.after).map(residual).collect::<Value>(),
            "rms_before": rms(&result.before), "rms_after": rms(&result.after), "variance": result.variance,
            "outliers": result.outliers.iter().map(|k| k + 1).collect::<Value>(),
            "held_out": result.held_out.map(|h| json!({ "before": h.before, "after": h.after, "folds": h.folds })),
            "remarks": self.remarks(),
        })
    }

    pub(super) fn html(&self) -> Result<String, Failure> {
        let figure = |chart: TimeChart| {
            chart_along(&chart, "Measurement")
                .map_err(|error| Failure::World(format!("the figure could not be drawn: {error}")))
        };
        let numbers: Vec<f64> = (1..=self.measurements.len()).map(|k| k as f64).collect();
        let line = |name: &str, residuals: &[Residual]| {
            Series::new(name, residuals.iter().map(|r| r.length * 1e3).collect())
        };
        let before = vec![
            line("before", &self.result.before),
            line("after", &self.result.after),
        ];
        let mut panels = vec![Panel::new("Distance", "mm", before)];
        panels.push(Panel::new(
            "After",
            "mm",
            vec![line("after", &self.result.after)],
        ));
        let drawn = figure(TimeChart {
            title: "What is left of each measurement".to_owned(),
            times: numbers,
            panels,
            marks: vec![],
        })?;
        let mut table = Table::new(
            "Parameters",
            [
                "parameter",
                "nominal",
                "identified",
                "difference",
                "95 %",
                "unit",
            ],
        );
        table = table.words([0]);
        for row in self.rows() {
            table = table.row(row);
        }
        let mut remarks = Section::new("Remarks");
        for remark in self.remarks() {
            remarks = remarks.paragraph(remark);
        }
        let mut report = pieper_plot::Report::new(format!("{}, calibrated", self.robot)).lead(format!(
            "From {} measurements in {}: residuals of {:.3} mm before and {:.3} mm after, root mean square.",
            self.measurements.len(),
            self.file,
            rms(&self.result.before) * 1e3,
            rms(&self.result.after) * 1e3
        ));
        for (name, value) in self.facts() {
            report = report.fact(name, value);
        }
        Ok(report
            .section(Section::new("Residuals").figure(
                &drawn,
                "Above with the nominal arm and with the identified one, below the identified one alone.",
            ))
            .section(Section::new("Parameters").table(table))
            .section(remarks)
            .to_html())
    }
}

/// A number that was printed, with its sign.
struct Signed(String);

impl std::fmt::Display for Signed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0.starts_with('-') {
            true => f.write_str(&self.0),
            false => write!(f, "+{}", self.0),
        }
    }
}
