//! `pieper calibrate`

mod plan;
mod report;
mod table;

use std::fs;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use pieper::calibration::{Calibration, Groups, Kind, Model, Simulation, simulate};
use pieper::describe::{Measurement, measurements_from_csv};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::{Source, read_text};

/// Identify the arm that is really there from measurements
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper calibrate irb120 --simulate --out out/m.csv
  pieper calibrate irb120 examples/irb120-measurements.csv --out out/irb120-real.toml
  pieper calibrate irb120 --design 20 --out out/plan.csv

MEASUREMENTS is a table of comma-separated values with a header: the joints as q1, q2, ... or by their names (radians and metres; \
q1_deg for degrees), or the motors as m1, m2, ..., and what was seen there: x,y,z with qw,qx,qy,qz or roll,pitch,yaw (poses), x,y,z alone (positions), distance and \
anchor (a ball bar or a wire, with a name), plane or contact (a name). px,py,pz is the point of the tool that was looked at; sigma and \
sigma_angle are standard deviations (x_mm, sigma_mm in millimetres). Kinds may be mixed: cells of the others stay empty.

With --parameters base,tool it is hand-eye calibration: of a marker on the tool that a device beside the arm sees (AX = YB), or, with \
--eye-in-hand, of a camera on the tool that looks at a target (AX = XB). The arm's own numbers stay as they are.

Parameters that the measurements cannot tell apart are named and held. The result is a robot file, which `pieper fk`, `ik`, \
`run` and `studio` take, and a report beside it (.html). Exit code 1: it did not converge.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// A table of measurements
    #[arg(value_name = "MEASUREMENTS", required_unless_present_any = ["simulate", "design"])]
    measurements: Option<PathBuf>,

    /// The robot file to write; with --simulate or --design, the table
    #[arg(long, value_name = "FILE")]
    out: PathBuf,

    /// What is estimated: theta, d, a, alpha, beta (between nearly parallel axes), gear, drive (motors' ratios, couplings, four-bars), base, tool
    #[arg(
        long,
        value_name = "GROUPS",
        default_value = "theta,d,a,alpha,beta,base,tool"
    )]
    parameters: String,

    /// Count every measurement alike, also those that do not agree with the others
    #[arg(long)]
    plain: bool,

    /// The poses are those of a target in the frame of a camera on the tool: the base becomes the target, the tool the camera
    #[arg(long, conflicts_with_all = ["simulate", "design"])]
    eye_in_hand: bool,

    /// Make measurements of an arm whose numbers are a little wrong
    #[arg(long, conflicts_with = "measurements")]
    simulate: bool,

    /// Choose the postures to measure: this many, that say most about the parameters
    #[arg(long, value_name = "N", conflicts_with_all = ["measurements", "simulate"])]
    design: Option<usize>,

    /// With --simulate or --design: what is measured
    #[arg(long, value_name = "KIND", default_value = "poses")]
    kind: Measured,

    /// With --simulate or --design: motor values in the place of joint values
    #[arg(long, conflicts_with = "measurements")]
    motors: bool,

    /// With --simulate: how many measurements
    #[arg(long, value_name = "N", default_value_t = 60)]
    count: usize,

    /// With --simulate: the share of measurements that are grossly wrong
    #[arg(long, value_name = "SHARE", default_value_t = 0.0)]
    outliers: f64,

    /// With --simulate or --design: another arm, other postures
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// One JSON document
    #[arg(long)]
    json: bool,
}

/// What is measured.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Measured {
    /// Whole poses
    Poses,
    /// The tool's point
    Position,
    /// Three points of the tool in turn
    Positions,
    /// Distances to two anchors
    Distances,
}

impl From<Measured> for Kind {
    fn from(kind: Measured) -> Self {
        match kind {
            Measured::Poses => Self::Poses,
            Measured::Position => Self::Position,
            Measured::Positions => Self::Positions,
            Measured::Distances => Self::Distances,
        }
    }
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let model = Model::of(&robot, Groups::parse(&self.parameters)?)?;
        if self.simulate {
            return self.make(&model);
        }
        if let Some(budget) = self.design {
            return self.plan(&model, budget);
        }
        let Some(file) = &self.measurements else {
            return Err(Failure::input("MEASUREMENTS was expected"));
        };
        let name = file.display().to_string();
        let measurements = measurements_from_csv(
            &name,
            &read_text(file)?,
            model.chain(),
            &robot.transmission()?,
        )?;
        let measurements: Vec<_> = match self.eye_in_hand {
            true => measurements
                .into_iter()
                .map(Measurement::of_eye_in_hand)
                .collect(),
            false => measurements,
        };
        let calibration = Calibration::new(model.clone(), measurements.clone())?;
        let result = calibration.robust(!self.plain).run()?;
        let report = report::Report {
            robot: &robot.name,
            file: &name,
            measurements: &measurements,
            result: &result,
        };
        let page = self.out.with_extension("html");
        self.write(&self.out, &result.robot(report.source())?.to_toml()?)?;
        self.write(&page, &report.html()?)?;
        match self.json {
            true => output::document(&report.document(&self.out, &page))?,
            false => output::answer(&report.text(&self.out, &page))?,
        }
        Ok(match result.converged {
            true => Outcome::Done,
            false => Outcome::Negative,
        })
    }

    fn write(&self, path: &std::path::Path, text: &str) -> Result<(), Failure> {
        if let Some(folder) = path
            .parent()
            .filter(|folder| !folder.as_os_str().is_empty())
        {
            fs::create_dir_all(folder)
                .map_err(|error| Failure::file("made", folder.display(), &error))?;
        }
        fs::write(path, text).map_err(|error| Failure::file("written", path.display(), &error))
    }

    fn simulation(&self, count: usize) -> Simulation {
        Simulation {
            count,
            kind: self.kind.into(),
            of_motors: self.motors,
            outliers: self.outliers,
            seed: self.seed,
            ..Simulation::default()
        }
    }

    /// Measurements of an arm that is not there.
    fn make(&self, model: &Model) -> Result<Outcome, Failure> {
        if !(1..=100_000).contains(&self.count) || !(0.0..=1.0).contains(&self.outliers) {
            return Err(Failure::input(
                "--count from 1 to 100000 and --outliers from 0 to 1 were expected",
            ));
        }
        let (truth, measurements) = simulate(model, &self.simulation(self.count))?;
        self.write(&self.out, &table::csv(model, &measurements, &truth)?)?;
        if self.json {
            let parameters = model.parameters().iter().zip(&truth);
            let truth: serde_json::Map<_, _> = parameters
                .map(|(parameter, value)| (parameter.name.clone(), serde_json::json!(value)))
                .collect();
            output::document(&serde_json::json!({
                "out": self.out.display().to_string(), "measurements": measurements.len(), "truth": truth,
            }))?;
        } else {
            output::answer(&format!(
                "{} measurements of an arm that is a little off, written to {}; its true numbers are in the file's comments\n",
                measurements.len(),
                self.out.display()
            ))?;
        }
        Ok(Outcome::Done)
    }

    /// The postures that say most.
    fn plan(&self, model: &Model, budget: usize) -> Result<Outcome, Failure> {
        if !(1..=500).contains(&budget) {
            return Err(Failure::input("--design: from 1 to 500 were expected"));
        }
        let plan = plan::of(model, &self.simulation(plan::CANDIDATES), budget)?;
        self.write(&self.out, &plan.csv(model)?)?;
        match self.json {
            true => output::document(&plan.document(&self.out))?,
            false => output::answer(&plan.text(&self.out))?,
        }
        Ok(Outcome::Done)
    }
}
