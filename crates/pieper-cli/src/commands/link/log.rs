//! `pieper link log`

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use pieper_link::{Entry, Record, Sample, records};
use pieper_plot::{Panel, Series, Theme, TimeChart, time_chart};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::read_text;

/// Show a recorded session, plot it, or take its motion out
#[derive(Args)]
#[command(after_help = "\
Examples, after a session:
  pieper link log
  pieper link log --out out/session

Writes tracking.svg and tracking.png (where the joints were sent and where they were, and the difference), session.csv (both), and \
motion.csv: what was commanded, as a motion table, which `pieper link send` and `pieper run` take again.")]
pub(crate) struct Arguments {
    /// A record (default: the newest)
    #[arg(value_name = "FILE.jsonl")]
    file: Option<PathBuf>,

    /// A folder for figures and tables; it is made if need be
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// One JSON document
    #[arg(long)]
    json: bool,
}

/// How many notes a person is shown.
const SHOWN: usize = 40;

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let file = self.file.clone().or_else(records::newest);
        let file = file.ok_or_else(|| {
            Failure::input(format!(
                "no session was recorded yet in {}",
                records::folder().display()
            ))
        })?;
        let record = Record::read(&read_text(&file)?)
            .map_err(|error| Failure::input(format!("{}: {error}", file.display())))?;
        let summary = Summary::of(&record);
        let written = match &self.out {
            Some(folder) => write(folder, &record)?,
            None => Vec::new(),
        };
        match self.json {
            true => output::document(&summary.document(&file, &record, &written))?,
            false => output::answer(&summary.text(&file, &record, &written))?,
        }
        Ok(Outcome::Done)
    }
}

/// A session in numbers.
struct Summary {
    samples: usize,
    duration: f64,
    /// For each joint the largest difference between command and measurement.
    errors: Vec<f64>,
    /// Mean and largest time to an answer, seconds.
    latency: Option<[f64; 2]>,
}

impl Summary {
    fn of(record: &Record) -> Self {
        let mut errors = vec![0.0_f64; record.joints.len()];
        let (mut samples, mut first, mut last) = (0, None, 0.0);
        let (mut sum, mut worst, mut count) = (0.0, 0.0_f64, 0_u32);
        for sample in record.samples() {
            samples += 1;
            first.get_or_insert(sample.time);
            last = sample.time;
            let pairs = sample.commanded.iter().zip(&sample.measured);
            for (error, (commanded, measured)) in errors.iter_mut().zip(pairs) {
                *error = error.max((commanded - measured).abs());
            }
            if let Some(latency) = sample.latency {
                sum += latency;
                worst = worst.max(latency);
                count += 1;
            }
        }
        Self {
            samples,
            duration: last - first.unwrap_or(last),
            errors,
            latency: (count > 0).then(|| [sum / f64::from(count), worst]),
        }
    }

    fn text(&self, file: &Path, record: &Record, written: &[String]) -> String {
        let mut out = format!(
            "{}\n{}, {} at {}: {} set-points in {:.1} s\n",
            file.display(),
            record.robot,
            record.protocol,
            record.address,
            self.samples,
            self.duration
        );
        let notes = record.entries.iter().filter_map(|entry| match entry {
            Entry::Note { time, text } => Some((time, text)),
            Entry::Sample(_) => None,
        });
        let count = notes.clone().count();
        for (time, text) in notes.take(SHOWN) {
            let _ = writeln!(out, "  {time:9.3} s  {text}");
        }
        if count > SHOWN {
            let _ = writeln!(out, "  and {} more notes", count - SHOWN);
        }
        if self.samples > 0 {
            let errors = record.joints.iter().zip(&self.errors);
            let shown = errors.map(|((name, is_angle), error)| match is_angle {
                true => format!("{name} {:.3}°", error.to_degrees()),
                false => format!("{name} {:.3} mm", error * 1e3),
            });
            let _ = writeln!(
                out,
                "farthest from where they were sent: {}",
                shown.collect::<Vec<_>>().join(", ")
            );
        }
        if let Some([mean, worst]) = self.latency {
            let _ = writeln!(
                out,
                "answers after {:.2} ms on average, {:.2} ms at most",
                mean * 1e3,
                worst * 1e3
            );
        }
        if !written.is_empty() {
            let _ = writeln!(out, "written: {}", written.join("  "));
        }
        out
    }

    fn document(&self, file: &Path, record: &Record, written: &[String]) -> Value {
        let note = |entry: &Entry| match entry {
            Entry::Note { time, text } => Some(json!({ "t": time, "text": text })),
            Entry::Sample(_) => None,
        };
        json!({
            "file": file.display().to_string(),
            "robot": record.robot,
            "protocol": record.protocol,
            "address": record.address,
            "joints": record.joints.iter().map(|(name, _)| name.as_str()).collect::<Value>(),
            "samples": self.samples,
            "duration": self.duration,
            "worst_errors": self.errors,
            "latency": self.latency.map(|[mean, worst]| json!({ "mean": mean, "worst": worst })),
            "notes": record.entries.iter().filter_map(note).collect::<Value>(),
            "written": written,
        })
    }
}

fn write(folder: &Path, record: &Record) -> Result<Vec<String>, Failure> {
    fs::create_dir_all(folder).map_err(|error| Failure::file("made", folder.display(), &error))?;
    let samples: Vec<&Sample> = record.samples().collect();
    if samples.is_empty() {
        return Err(Failure::input(
            "nothing was sent in this session: there is nothing to plot",
        ));
    }
    let mut written = Vec::new();
    let mut put = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, bytes)
            .map_err(|error| Failure::file("written", path.display(), &error))?;
        written.push(path.display().to_string());
        Ok::<(), Failure>(())
    };
    put("motion.csv", motion(record, &samples).as_bytes())?;
    put("session.csv", session(record, &samples).as_bytes())?;
    let figure = time_chart(&chart(record, &samples))
        .map_err(|error| Failure::World(format!("the figure could not be drawn: {error}")))?;
    put("tracking.svg", figure.to_svg(Theme::Standalone).as_bytes())?;
    let png = figure
        .to_png(2.0)
        .map_err(|error| Failure::World(format!("the figure could not be drawn: {error}")))?;
    put("tracking.png", &png)?;
    Ok(written)
}

/// What was commanded, as a motion table: times from zero, each later than the one before.
fn motion(record: &Record, samples: &[&Sample]) -> String {
    let mut out = String::from("t");
    for (name, _) in &record.joints {
        let _ = write!(out, ",{name}");
    }
    out.push('\n');
    let mut before = f64::NEG_INFINITY;
    for sample in samples {
        let time = sample.time - samples[0].time;
        if time > before {
            before = time;
            let _ = write!(out, "{time}");
            for q in &sample.commanded {
                let _ = write!(out, ",{q}");
            }
            out.push('\n');
        }
    }
    out
}

fn session(record: &Record, samples: &[&Sample]) -> String {
    let mut out = String::from("t");
    for kind in ["commanded", "measured"] {
        for (name, _) in &record.joints {
            let _ = write!(out, ",{name}_{kind}");
        }
    }
    out.push_str(",latency\n");
    for sample in samples {
        let _ = write!(out, "{}", sample.time);
        for q in sample.commanded.iter().chain(&sample.measured) {
            let _ = write!(out, ",{q}");
        }
        let latency = sample.latency.map_or(String::new(), |l| l.to_string());
        let _ = writeln!(out, ",{latency}");
    }
    out
}

fn chart(record: &Record, samples: &[&Sample]) -> TimeChart {
    let times = samples.iter().map(|s| s.time - samples[0].time).collect();
    let unit = |is_angle: bool| {
        if is_angle {
            (180.0 / std::f64::consts::PI, "°")
        } else {
            (1e3, "mm")
        }
    };
    let lines = |of: &dyn Fn(&Sample, usize) -> f64, is_angle: bool| -> Vec<Series> {
        let joints = record.joints.iter().enumerate();
        let mine = joints.filter(|(_, (_, angle))| *angle == is_angle);
        mine.map(|(joint, (name, _))| {
            let values = samples.iter().map(|s| of(s, joint) * unit(is_angle).0);
            Series::new(name, values.collect())
        })
        .collect()
    };
    let mut panels = Vec::new();
    for is_angle in [true, false] {
        if record.joints.iter().all(|(_, angle)| *angle != is_angle) {
            continue;
        }
        let label = unit(is_angle).1;
        panels.push(Panel::new(
            "Commanded",
            label,
            lines(&|s, j| s.commanded[j], is_angle),
        ));
        panels.push(Panel::new(
            "Measured",
            label,
            lines(&|s, j| s.measured[j], is_angle),
        ));
        panels.push(Panel::new(
            "Difference",
            label,
            lines(&|s, j| s.commanded[j] - s.measured[j], is_angle),
        ));
    }
    TimeChart {
        title: format!("{}: sent and measured", record.robot),
        times,
        panels,
        marks: vec![],
    }
}
