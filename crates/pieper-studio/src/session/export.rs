//! The motion as files: tables, and the figures that `pieper run` makes.

use std::fmt::Write as _;

use pieper::model::JointKind;
use pieper_plot::{
    Figure, Panel, PathMark, PathViews, Series, Space, Theme, TimeChart, TimeMark, path_views,
    time_chart,
};
use serde_json::json;

use super::Session;
use crate::motion::Samples;

/// Samples a second in a file.
const RATE: f64 = 50.0;

/// Keyframes that are marked in a figure; more would cover what they name.
const MOST_MARKS: usize = 24;

/// Pixels of a PNG figure for each of the figure's own units.
const SCALE: f64 = 2.0;

impl Session {
    /// A file by its name: `motion.csv`, `motion.json`, or `joints`, `rates`, `accelerations`, `path` as `.svg` or `.png`. Its media
    /// type and its content.
    ///
    /// # Errors
    /// A sentence: no such file, or no motion.
    pub fn export(&self, name: &str) -> Result<(&'static str, Vec<u8>), String> {
        let samples = self.motion.samples(&self.arm, RATE);
        if samples.t.is_empty() {
            return Err(
                "there is no motion to export: two keyframes or a table make one".to_owned(),
            );
        }
        match name {
            "motion.csv" => return Ok(("text/csv; charset=utf-8", table(&samples).into_bytes())),
            "motion.json" => {
                return Ok(("application/json", json!(samples).to_string().into_bytes()));
            }
            _ => {}
        }
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
        let figure = match stem {
            "joints" => self.chart("joint values", "", &samples.t, &samples.q),
            "rates" => self.chart("rates of the joints", "/s", &samples.t, &samples.qd),
            "accelerations" => self.chart(
                "accelerations of the joints",
                "/s\u{b2}",
                &samples.t,
                &samples.qdd,
            ),
            "path" => self.path(&samples),
            _ => {
                return Err(format!(
                    "{name}: motion, joints, rates, accelerations or path was expected"
                ));
            }
        };
        let figure = figure.map_err(|error| error.to_string())?;
        match ending {
            "svg" => Ok((
                "image/svg+xml",
                figure.to_svg(Theme::Standalone).into_bytes(),
            )),
            "png" => Ok((
                "image/png",
                figure.to_png(SCALE).map_err(|error| error.to_string())?,
            )),
            _ => Err(format!("{name}: .svg or .png was expected")),
        }
    }

    fn chart(
        &self,
        what: &str,
        per: &str,
        times: &[f64],
        tracks: &[Vec<f64>],
    ) -> pieper_plot::Result<Figure> {
        let panel = |slides: bool, name: &str, unit: &str, scale: f64| {
            let series: Vec<Series> = self
                .arm
                .chain
                .variables()
                .iter()
                .zip(tracks)
                .filter(|(variable, _)| (variable.kind == JointKind::Prismatic) == slides)
                .map(|(variable, values)| {
                    Series::new(
                        variable.name.clone(),
                        values.iter().map(|value| value * scale).collect(),
                    )
                })
                .collect();
            (!series.is_empty()).then(|| Panel::new(name, format!("{unit}{per}"), series))
        };
        let panels = [
            panel(false, "turning", "\u{b0}", 180.0 / std::f64::consts::PI),
            panel(true, "sliding", "mm", 1000.0),
        ];
        time_chart(&TimeChart {
            title: format!("{}: {what}", self.arm.robot.name),
            times: times.to_vec(),
            panels: panels.into_iter().flatten().collect(),
            marks: self
                .marks()
                .into_iter()
                .map(|(label, time)| TimeMark { label, time })
                .collect(),
        })
    }

    fn path(&self, samples: &Samples) -> pieper_plot::Result<Figure> {
        let nearest = |time: f64| {
            samples
                .t
                .partition_point(|t| *t < time)
                .min(samples.t.len() - 1)
        };
        path_views(&PathViews {
            title: format!("{}: path of the tool\u{2019}s point", self.arm.robot.name),
            axes: ["x\u{2080}".into(), "y\u{2080}".into(), "z\u{2080}".into()],
            space: Space::Positions,
            path: samples.tool.clone(),
            marks: self
                .marks()
                .into_iter()
                .map(|(label, time)| PathMark {
                    label,
                    at: samples.tool[nearest(time)],
                })
                .collect(),
        })
    }

    /// The keyframes with a name, thinned out where they are many.
    fn marks(&self) -> Vec<(String, f64)> {
        let named: Vec<(String, f64)> = self
            .motion
            .keyframes
            .iter()
            .filter(|k| !k.label.is_empty())
            .map(|k| (k.label.clone(), k.t))
            .collect();
        let step = named.len().div_ceil(MOST_MARKS).max(1);
        named.into_iter().step_by(step).collect()
    }
}

/// Comma-separated values as `pieper run` reads them.
fn table(samples: &Samples) -> String {
    let mut out = String::from("t");
    (1..=samples.q.len()).for_each(|joint| {
        let _ = write!(out, ",q{joint}");
    });
    for (k, t) in samples.t.iter().enumerate() {
        let _ = write!(out, "\n{t}");
        for track in &samples.q {
            let _ = write!(out, ",{}", track[k]);
        }
    }
    out.push('\n');
    out
}
