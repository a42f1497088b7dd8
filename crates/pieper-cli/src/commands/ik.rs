//! `pieper ik`

mod answer;
mod family;
mod pose;

use clap::{Args, ValueEnum};
use pieper::ik::{Goal, Method, Question, Ranking, Solver};
use pieper::model::Chain;
use serde_json::Value;

use crate::batch::{Files, Request, shown};
use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;
use answer::{Answer, Wish};

pub(super) use family::{family_document, family_text};

/// Inverse kinematics: a pose in, every solution out
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper ik ar3 --pose 0.3,0.2,0.35,0.1,0.8,0.3
  pieper ik ur5 --pose 0.4,0.2,0.3,0.7071068,0,0.7071068,0 --seed 0,-1,1,0,1,0 --deg
  pieper fk ar3 --q 0,45,-30,0,60,0 --deg --json > pose.json; pieper ik ar3 --pose pose.json
  pieper ik cobra600 --pose 0.4,0.2,0.1,180,0,0 --deg --goal position+axis
  pieper ik panda --pose 0.4,0.1,0.4,180,0,0 --deg --lock q7=45
  pieper ik iiwa14 --pose 0.5,0.1,0.4,180,0,0 --deg --swivel 30
  echo '{\"id\": 1, \"pose\": [[1,0,0,0.2],[0,1,0,0.3],[0,0,1,0.3],[0,0,0,1]]}' | pieper ik ar3 --input -

A pose is x,y,z,roll,pitch,yaw (fixed axes, as in URDF), x,y,z,qw,qx,qy,qz, a 4x4 matrix as nested JSON lists, or a
file that holds one of these. Metres and radians; with --deg joint angles and roll, pitch, yaw are degrees.
With more joints than the goal needs, or at a singular pose, solutions form families: each is shown by a member, the
direction in which it goes on, its parts within the limits, and more members (with --limits, those within them).
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

    /// The part of the pose to be met: all of it, the tool's point, the direction of the tool's z axis, or both of these
    #[arg(long, value_enum, default_value_t, hide_default_value = true)]
    goal: GoalName,

    /// Hold a joint at a value (by its name, or qN for the Nth), several times for several
    #[arg(long = "lock", value_name = "JOINT=VALUE", allow_hyphen_values = true)]
    locks: Vec<String>,

    /// Of an arm of seven joints with a spherical shoulder and wrist: the angle of its elbow about the line from shoulder to
    /// wrist, 0 where the elbow's axis is at a right angle to axis 1; leaves up to eight isolated solutions
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    swivel: Option<f64>,

    /// How the orientation of a spherical wrist is solved; the answers are the same
    #[arg(long, value_enum, default_value_t, hide_default_value = true)]
    method: MethodName,

    /// What comes first: close to the seed (with --seed that is the default), far from limits, far from singular poses
    #[arg(long, value_enum)]
    rank: Option<RankName>,

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

/// The words of `--goal`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum GoalName {
    #[default]
    Pose,
    Position,
    Axis,
    #[value(name = "position+axis")]
    PositionAxis,
}

impl From<GoalName> for Goal {
    fn from(name: GoalName) -> Self {
        match name {
            GoalName::Pose => Self::Pose,
            GoalName::Position => Self::Position,
            GoalName::Axis => Self::Axis,
            GoalName::PositionAxis => Self::PositionAxis,
        }
    }
}

/// The words of `--method`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum MethodName {
    #[default]
    Matrix,
    Quaternion,
}

impl From<MethodName> for Method {
    fn from(name: MethodName) -> Self {
        match name {
            MethodName::Matrix => Self::Matrix,
            MethodName::Quaternion => Self::Quaternion,
        }
    }
}

/// The words of `--rank`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RankName {
    Seed,
    Limits,
    Singularity,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = robot.chain()?;
        let question = Question {
            goal: self.goal.into(),
            held: self.held(&chain)?,
            method: self.method.into(),
            swivel: self
                .swivel
                .map(|angle| if self.deg { angle.to_radians() } else { angle }),
        };
        let solver = Solver::prepare(&chain, &question)?;
        let drives = super::motors::of(&robot)?;
        let seed = match &self.seed {
            Some(text) => Some(self.seed_from_text(&chain, text)?),
            None => None,
        };
        if self.rank == Some(RankName::Seed) && seed.is_none() && self.files.input.is_none() {
            return Err(Failure::input("--rank seed: --seed was expected with it"));
        }
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
        let answer = Answer::compute(&solver, &pose, &self.wish(seed.as_deref()))?;
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

    fn wish<'a>(&self, seed: Option<&'a [f64]>) -> Wish<'a> {
        let ranking = match (self.rank, seed) {
            (Some(RankName::Limits), _) => Some(Ranking::Margin),
            (Some(RankName::Singularity), _) => Some(Ranking::Singularity),
            (_, Some(seed)) => Some(Ranking::Seed(seed)),
            (_, None) => None,
        };
        Wish {
            seed,
            ranking,
            limits: self.limits,
        }
    }

    /// The joints of `--lock`.
    fn held(&self, chain: &Chain) -> Result<Vec<(usize, f64)>, Failure> {
        let lock = |text: &String| {
            let wrong = || {
                let names: Vec<&str> = chain.variables().iter().map(|v| v.name.as_str()).collect();
                let names = names.join(", ");
                Failure::input(format!(
                    "--lock {text}: JOINT=VALUE was expected, JOINT one of {names} or q1 to q{}",
                    chain.dof()
                ))
            };
            let (name, value) = text.split_once('=').ok_or_else(wrong)?;
            let value: f64 = value.trim().parse().map_err(|_| wrong())?;
            let named = chain.variables().iter().position(|v| v.name == name.trim());
            let numbered = || -> Option<usize> {
                let number: usize = name.trim().strip_prefix('q')?.parse().ok()?;
                (1..=chain.dof()).contains(&number).then(|| number - 1)
            };
            let joint = named.or_else(numbered).ok_or_else(wrong)?;
            let angular = chain.variables()[joint].kind.is_angular();
            let value = if self.deg && angular {
                value.to_radians()
            } else {
                value
            };
            Ok((joint, value))
        };
        self.locks.iter().map(lock).collect()
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
        Answer::compute(solver, &pose, &self.wish(seed)).map_err(|error| error.to_string())
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
