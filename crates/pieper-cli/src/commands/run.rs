//! `pieper run`

mod certificate;
mod drives;
mod figures;
mod folder;
mod limits;
mod matrices;
mod motion;
mod names;
mod progress;
mod recording;
mod report;
mod samples;
mod skeleton;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use pieper::describe::{MotionTable, Robot};
use pieper::model::Chain;
use pieper::motion::{Law, Profile, TrackOptions, excesses, sample_times};
use serde_json::{Value, json};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::{Source, read_text};
use certificate::Certificate;
use drives::Drives;
use folder::Folder;
use motion::{Found, Motion, Path as ToolPath, Wishes};
use progress::Progress;
use recording::Recording;

/// Run a motion table: figures, a report, matrices and samples
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper run ar3 examples/ar3-programme.csv --out out/ar3
  pieper run puma560 examples/ar3-programme.csv --out out/puma --profile quintic --limits
  pieper run ar3 examples/ar3-poses.csv --out out/ar3-poses
  pieper run ar3 examples/ar3-poses.csv --out out/ar3-joints --between joints
  pieper run irb120 examples/irb120-wrist.csv --out out/wrist --start 33,-6,11,50,-41,-55 --deg

MOTION is a table of comma-separated values with a header: the time t in seconds, then the joints as q1, q2, ... \
or by their names (radians and metres; q1_deg for degrees, q3_mm for millimetres), or the tool's pose as \
x,y,z,qw,qx,qy,qz or x,y,z,roll,pitch,yaw, or three of its points as Dx..Dz,Kx..Kz,Ex..Ez. A column mark names \
reference positions; without it every row is one, or the first and the last of more than 24.

Between rows of joints the joints go straight. Between rows of poses or points the tool goes straight: every branch of \
the inverse kinematics is followed without jumps, and the best that lives from the first row to the last is run; \
certificate.txt says what became of each. If none does, the exit code is 1, and the nearest alternative is shown: \
examples/irb120-reach.csv is such a path. With --between joints the joints go straight from pose to pose by the solutions \
with the least travel, and the tool's way between them is what it is.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// A motion table: CSV with the columns t, q1, q2, ... or a pose of the tool, and mark
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

    /// What goes straight between rows of poses or points
    #[arg(long, value_name = "WHAT", default_value = "tool")]
    between: Straight,

    /// How far the tool may be off its path between rows of poses: metres, and the same number of radians
    #[arg(long, value_name = "METRES", default_value_t = TrackOptions::default().tolerance)]
    tolerance: f64,

    /// Joint values that the motion along a path of the tool should start near
    #[arg(
        long,
        value_name = "Q1,Q2,...",
        visible_alias = "seed",
        allow_hyphen_values = true
    )]
    start: Option<String>,

    /// The angles of --start are in degrees
    #[arg(long, requires = "start")]
    deg: bool,

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

/// What goes straight between rows of poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Straight {
    /// The tool: its path is followed
    Tool,
    /// The joints: only the rows' poses are met
    Joints,
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
    /// The times of the table's rows.
    rows: Vec<f64>,
    profile: Profile,
    recording: Recording,
    /// For a path of the tool: what became of it.
    path: Option<ToolPath>,
    /// For an arm with a transmission: its motors.
    drives: Option<Drives>,
    /// What to say where not every row is a reference position.
    note: Option<String>,
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
        let name = self.motion.display().to_string();
        let table = MotionTable::from_csv(&name, &read_text(&self.motion)?, &chain)?;
        // Before the work: a rate that cannot be is told at once.
        self.times(&table.times)?;
        let wishes = Wishes {
            profile: self.profile.into(),
            joints_go_straight: self.between == Straight::Joints,
            options: TrackOptions {
                tolerance: self.tolerance,
                start: self.start(&chain)?,
                ..TrackOptions::default()
            },
        };
        let mut progress = Progress::new();
        match motion::of(&chain, table, wishes, &mut progress)? {
            Found::Motion(found) => self.run_motion(robot, chain, *found, &mut progress),
            Found::Unreachable { row, time, reason } => {
                progress.finish();
                let sentence = format!("row {row}, t = {time} s: {reason}");
                match self.json {
                    true => output::document(&json!({ "error": sentence }))?,
                    false => output::answer(&format!("{sentence}\n"))?,
                }
                Ok(Outcome::Negative)
            }
            Found::Nothing(path) => self.refuse(&robot, &chain, &path, &progress),
        }
    }

    fn run_motion(
        &self,
        robot: Robot,
        chain: Chain,
        found: Motion,
        progress: &mut Progress,
    ) -> Result<Outcome, Failure> {
        let times = self.times(&found.rows)?;
        let folder = Folder::make(&self.out)?;
        let mut warnings = limits::sentences(&excesses(&found.law, &chain), &chain);
        let recording = Recording::make(&chain, &found.law, &found.marks, times, progress)?;
        let drives = Drives::along(&robot, &recording)?;
        warnings.extend(drives.iter().flat_map(|drives| drives.warnings.clone()));
        let run = Run {
            robot,
            chain,
            law: found.law,
            rows: found.rows,
            profile: self.profile.into(),
            recording,
            path: found.path,
            drives,
            note: found.note,
            motion: file_name(&self.motion),
            rate: self.rate,
            warnings,
        };
        let files = write(&run, folder, progress)?;
        progress.finish();
        if self.limits {
            run.warnings.iter().for_each(|text| output::warning(text));
        }
        if self.json {
            output::document(&self.document(&run, &files))?;
        } else {
            output::answer(&self.text(&run, &files))?;
        }
        Ok(match &run.path {
            Some(path) if !path.is_followed() => Outcome::Negative,
            _ => Outcome::Done,
        })
    }

    /// A path of which no part can be reached: the certificate is all there is.
    fn refuse(
        &self,
        robot: &Robot,
        chain: &Chain,
        path: &ToolPath,
        progress: &Progress,
    ) -> Result<Outcome, Failure> {
        let certificate = Certificate {
            robot: &robot.name,
            motion: &file_name(&self.motion),
            chain,
            path,
        };
        let mut folder = Folder::make(&self.out)?;
        write_certificate(&certificate, &mut folder)?;
        progress.finish();
        if self.json {
            output::document(&certificate.document())?;
        } else {
            output::answer(&certificate.text())?;
        }
        Ok(Outcome::Negative)
    }

    /// When the motion is looked at.
    fn times(&self, rows: &[f64]) -> Result<Vec<f64>, Failure> {
        sample_times(rows, self.rate).map_err(|error| Failure::input(format!("--rate: {error}")))
    }

    /// The wish for the start.
    fn start(&self, chain: &Chain) -> Result<Option<Vec<f64>>, Failure> {
        let Some(text) = &self.start else {
            return Ok(None);
        };
        let parts = text.split([',', ' ']).filter(|part| !part.is_empty());
        let values: Option<Vec<f64>> = parts.map(|part| part.parse().ok()).collect();
        let mut values = values.ok_or_else(|| {
            Failure::input(format!(
                "--start {text}: numbers separated by commas were expected"
            ))
        })?;
        chain
            .check_joint_values(&values)
            .map_err(|error| Failure::input(format!("--start: {error}")))?;
        for (value, variable) in values.iter_mut().zip(chain.variables()) {
            if self.deg && variable.kind.is_angular() {
                *value = value.to_radians();
            }
        }
        Ok(Some(values))
    }

    fn text(&self, run: &Run, files: &[String]) -> String {
        let mut out = format!("{}: {}\n", run.robot.name, run.summary());
        if let Some(note) = &run.note {
            let _ = writeln!(out, "{note}");
        }
        if let Some(path) = &run.path {
            for line in run.certificate(path).verdict() {
                let _ = writeln!(out, "{line}");
            }
        }
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
            "profile": run.profile.name(),
            "rate": run.rate,
            "samples": times.len(),
            "from": times.first(),
            "to": times.last(),
            "report": self.out.join(report::FILE).display().to_string(),
            "files": files.iter().map(path).collect::<Value>(),
            "marks": marks.iter().map(|mark| matrices::entry(run, mark)).collect::<Value>(),
            "warnings": run.warnings,
            "certificate": run.path.as_ref().map(|path| run.certificate(path).document()),
        })
    }
}

impl Run {
    fn certificate<'a>(&'a self, path: &'a ToolPath) -> Certificate<'a> {
        Certificate {
            robot: &self.robot.name,
            motion: &self.motion,
            chain: &self.chain,
            path,
        }
    }

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
    folder.write("poses.csv", samples::poses(run))?;
    if let Some(drives) = &run.drives {
        folder.write(drives::FILE, drives.csv(&run.recording.times))?;
    }
    if let Some(path) = &run.path {
        folder.write("joints.csv", samples::joints(run))?;
        write_certificate(&run.certificate(path), &mut folder)?;
    }
    folder.write(report::FILE, report::html(run, &drawn))?;
    Ok(folder.written())
}

fn write_certificate(certificate: &Certificate<'_>, folder: &mut Folder) -> Result<(), Failure> {
    folder.write(certificate::TEXT, certificate.text())?;
    let document = certificate.document();
    folder.write(certificate::JSON, format!("{document:#}\n"))
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
