//! `pieper ik`

mod answer;
mod family;
mod pose;

use clap::Args;
use pieper::ik::Solver;
use pieper::model::Chain;
use serde_json::Value;

use crate::batch::{Files, Request, shown};
use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;
use answer::Answer;

pub(super) use family::{family_document, family_text};

/// Inverse kinematics: a pose in, every solution out
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper ik ar3 --pose 0.3,0.2,0.35,0.1,0.8,0.3
  pieper ik ur5 --pose 0.4,0.2,0.3,0.7071068,0,0.7071068,0 --seed 0,-1,1,0,1,0 --deg
  pieper fk ar3 --q 0,45,-30,0,60,0 --deg --json > pose.json; pieper ik ar3 --pose pose.json
  echo '{\"id\": 1, \"pose\": [[1,0,0,0.2],[0,1,0,0.3],[0,0,1,0.3],[0,0,0,1]]}' | pieper ik ar3 --input -

A pose is x,y,z,roll,pitch,yaw (fixed axes, as in URDF), x,y,z,qw,qx,qy,qz, a 4x4 matrix as nested JSON lists, or a
file that holds one of these. Metres and radians; with --deg joint angles and roll, pitch, yaw are degrees.
Exit code 1 if the pose cannot be reached.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The tool's pose
    #[arg(
        long,
        value_name = "POSE",
        allow_hyphen_values = true,
        conflicts_with = "input",
        required_unless_present = "input"
    )]
    pose: Option<String>,

    /// Joint values to sort by: the closest solution first, and of a family the closest member
    #[arg(long, value_name = "Q1,Q2,...", allow_hyphen_values = true)]
    seed: Option<String>,

    /// Only what lies within the joints' limits, with every copy by whole turns that fits
    #[arg(long)]
    limits: bool,

    /// Angles in degrees, in and out
    #[arg(long)]
    deg: bool,

    /// One JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    files: Files,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = robot.chain()?;
        let solver = Solver::new(&chain)?;
        let drives = super::motors::of(&robot)?;
        let seed = match &self.seed {
            Some(text) => Some(self.seed_from_text(&chain, text)?),
            None => None,
        };
        if let Some(input) = &self.files.input {
            return self.files.answer(input, |request| {
                let answer = self.answer_request(&solver, request, seed.as_deref())?;
                let answer = answer.driven_by(drives.as_ref(), self.limits);
                let answer = answer.map_err(|error| error.to_string())?;
                Ok(answer.fields(&chain, self.deg))
            });
        }
        let text = self.pose.as_deref().unwrap_or_default();
        let pose = pose::from_text(text, self.deg).map_err(Failure::input)?;
        let answer = Answer::compute(&solver, &pose, seed.as_deref(), self.limits)?;
        let answer = answer.driven_by(drives.as_ref(), self.limits)?;
        if self.json {
            output::document(&answer.document(&robot.name, &solver, self.deg))?;
        } else {
            output::answer(&answer.text(&robot.name, &solver, self.deg))?;
        }
        Ok(match answer.is_reached() {
            true => Outcome::Done,
            false => Outcome::Negative,
        })
    }

    fn answer_request(
        &self,
        solver: &Solver,
        request: &Request,
        seed: Option<&[f64]>,
    ) -> Result<Answer, String> {
        let pose = request
            .get("pose")
            .ok_or("\"pose\" was expected: the tool's pose")?;
        let pose = pose::from_json(pose, self.deg).map_err(|text| format!("\"pose\": {text}"))?;
        let own = match request.get("seed") {
            None | Some(Value::Null) => None,
            Some(value) => Some(self.seed_from_json(solver.chain(), value)?),
        };
        let seed = own.as_deref().or(seed);
        Answer::compute(solver, &pose, seed, self.limits).map_err(|error| error.to_string())
    }

    fn seed_from_text(&self, chain: &Chain, text: &str) -> Result<Vec<f64>, Failure> {
        let values = pose::numbers(text).ok_or_else(|| {
            Failure::input(format!(
                "--seed {text}: numbers separated by commas were expected"
            ))
        })?;
        self.checked_seed(chain, values)
            .map_err(|text| Failure::input(format!("--seed: {text}")))
    }

    fn seed_from_json(&self, chain: &Chain, value: &Value) -> Result<Vec<f64>, String> {
        let list = value
            .as_array()
            .and_then(|list| list.iter().map(Value::as_f64).collect());
        let values: Vec<f64> = list
            .ok_or_else(|| format!("\"seed\": {}: a list of numbers was expected", shown(value)))?;
        self.checked_seed(chain, values)
            .map_err(|text| format!("\"seed\": {text}"))
    }

    fn checked_seed(&self, chain: &Chain, mut values: Vec<f64>) -> Result<Vec<f64>, String> {
        chain
            .check_joint_values(&values)
            .map_err(|error| error.to_string())?;
        for (value, variable) in values.iter_mut().zip(chain.variables()) {
            if self.deg && variable.kind.is_angular() {
                *value = value.to_radians();
            }
        }
        Ok(values)
    }
}
