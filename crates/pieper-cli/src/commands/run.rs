//! `pieper run`

mod figures;
mod folder;
mod limits;
mod matrices;
mod names;
mod progress;
mod recording;
mod report;
mod samples;
mod skeleton;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use pieper::describe::{MotionTable, MotionValues, Robot};
use pieper::model::Chain;
use pieper::motion::{self, Law, Profile};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::{Source, read_text};
use folder::Folder;
use progress::Progress;
use recording::Recording;

/// Run a motion table: figures, a report, matrices and samples
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper run ar3 examples/ar3-programme.csv --out out/ar3
  pieper run puma560 examples/ar3-programme.csv --out out/puma --profile quintic --limits

MOTION is a table of comma-separated values with a header: the time t in seconds, then the joints as q1, q2, ... \
or by their names (radians and metres; q1_deg for degrees, q3_mm for millimetres). A column mark names reference \
positions; without it every row is one.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// A motion table: CSV with the columns t, q1, q2, ... and mark
    #[arg(value_name = "MOTION")]
    motion: PathBuf,

    /// The folder to write to; it is made if need be, and files of the same names are overwritten
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// The course of the moves between rows
    #[arg(long, value_name = "PROFILE", default_value = "linear")]
    profile: Course,

    /// Samples per second; every row's own time is always among them
    #[arg(long, value_name = "PER_SECOND", default_value_t = 50.0)]
    rate: f64,

    /// Warn about values, rates and accelerations outside the joints' limits
    #[arg(long)]
    limits: bool,

    /// One JSON document: the files written, the matrices, the limits exceeded
    #[arg(long)]
    json: bool,
}

/// The course of a move in time.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Course {
    /// Constant rates, which jump at the rows
    Linear,
    /// Smooth start and stop at every row
    Cubic,
    /// Accelerations start and stop smoothly too
    Quintic,
    /// A third of the time speeding up, a third at constant rate, a third slowing down
    Trapezoid,
}

impl From<Course> for Profile {
    fn from(course: Course) -> Self {
        match course {
            Course::Linear => Self::Linear,
            Course::Cubic => Self::Cubic,
            Course::Quintic => Self::Quintic,
            Course::Trapezoid => Self::Trapezoid,
        }
    }
}

/// What is run: everything the answers are made of.
struct Run {
    robot: Robot,
    chain: Chain,
    law: Law,
    recording: Recording,
    /// The name of the motion's file, without its folder.
    motion: String,
    /// Samples per second.
    rate: f64,
    /// Limits exceeded, as sentences.
    warnings: Vec<String>,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = robot.chain()?;
        let (law, marks) = self.law(&chain)?;
        let times = motion::sample_times(law.times(), self.rate)
            .map_err(|error| Failure::input(format!("--rate: {error}")))?;
        let mut progress = Progress::new();
        let folder = Folder::make(&self.out)?;
        let warnings = limits::sentences(&motion::excesses(&law, &chain), &chain);
        let recording = Recording::make(&chain, &law, marks, times, &mut progress)?;
        let run = Run {
            robot,
            chain,
            law,
            recording,
            motion: file_name(&self.motion),
            rate: self.rate,
            warnings,
        };
        let files = write(&run, folder, &mut progress)?;
        progress.finish();
        if self.limits {
            run.warnings.iter().for_each(|text| output::warning(text));
        }
        if self.json {
            output::document(&self.document(&run, &files))?;
        } else {
            output::answer(&self.text(&run, &files))?;
        }
        Ok(Outcome::Done)
    }
}

impl Arguments {
    /// The motion the table gives, and its reference positions.
    fn law(&self, chain: &Chain) -> Result<(Law, Vec<(usize, String)>), Failure> {
        let name = self.motion.display().to_string();
        let table = MotionTable::from_csv(&name, &read_text(&self.motion)?, chain)?;
        let marks = table.reference_positions();
        match table.values {
            MotionValues::Joints(rows) => {
                let law = Law::new(table.times, rows, self.profile.into())?;
                Ok((law, marks))
            }
            MotionValues::Poses(_) | MotionValues::Points(_) => Err(Failure::input(format!(
                "{name}: a tool path needs the inverse kinematics, which `run` does not use yet; \
                 joint columns q1, q2, ... were expected"
            ))),
        }
    }

    fn text(&self, run: &Run, files: &[String]) -> String {
        let mut out = format!("{}: {}\n", run.robot.name, run.summary());
        let _ = writeln!(out, "{} files in {}:", files.len(), self.out.display());
        for line in files.chunks(8) {
            let _ = writeln!(out, "  {}", line.join("  "));
        }
        if !run.warnings.is_empty() {
            let limits = names::count(run.warnings.len(), "limit is", "limits are");
            let hint = match self.limits {
                true => "",
                false => "; --limits names them",
            };
            let _ = writeln!(out, "{limits} exceeded: see the report{hint}");
        }
        let _ = writeln!(out, "open {}", self.out.join(report::FILE).display());
        out
    }

    fn document(&self, run: &Run, files: &[String]) -> Value {
        let path = |name: &String| self.out.join(name).display().to_string();
        let (times, marks) = (&run.recording.times, &run.recording.marks);
        json!({
            "robot": run.robot.name,
            "motion": self.motion.display().to_string(),
            "profile": run.law.profile().name(),
            "rate": run.rate,
            "samples": times.len(),
            "from": times.first(),
            "to": times.last(),
            "report": self.out.join(report::FILE).display().to_string(),
            "files": files.iter().map(path).collect::<Value>(),
            "marks": marks.iter().map(|mark| matrices::entry(run, mark)).collect::<Value>(),
            "warnings": run.warnings,
        })
    }
}

impl Run {
    /// How long the motion is, in a few words.
    fn summary(&self) -> String {
        let recording = &self.recording;
        let marks = names::count(
            recording.marks.len(),
            "reference position",
            "reference positions",
        );
        let samples = names::count(recording.times.len(), "sample", "samples");
        format!(
            "{} s, {marks}, {samples}",
            names::trimmed(recording.duration(), 3)
        )
    }
}

/// Writes every file; their names, in the order of writing.
fn write(run: &Run, mut folder: Folder, progress: &mut Progress) -> Result<Vec<String>, Failure> {
    let drawn = figures::draw(run, progress)?;
    for drawing in &drawn {
        folder.write_figure(drawing)?;
        progress.advance();
    }
    folder.write("matrices.txt", matrices::text(run))?;
    folder.write("matrices.tex", matrices::latex(run))?;
    folder.write("matrices.json", matrices::json(run))?;
    folder.write("samples.csv", samples::csv(run))?;
    folder.write(report::FILE, report::html(run, &drawn))?;
    Ok(folder.written())
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
