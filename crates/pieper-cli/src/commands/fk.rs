//! `pieper fk`

mod answer;
mod joints;

use clap::{Args, ValueEnum};
use pieper::kinematics::Reference;
use serde_json::json;

use crate::batch::Files;
use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;
use answer::Answer;

/// Forward kinematics: joint values in, the tool's pose out
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper fk ar3 --q 0,45,-30,0,60,0 --deg
  pieper fk ar3 --q 0,0.5,0,0,1,0 --jacobian tool --json
  pieper fk abb-paper --motors 90,90,120,90,90,90 --deg
  echo '{\"id\": 1, \"q\": [0,0,0,0,0,0]}' | pieper fk ar3 --input -

Joint values are radians and metres; --deg reads and writes angles in degrees.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// Joint values, separated by commas
    #[arg(
        long,
        value_name = "Q1,Q2,...",
        allow_hyphen_values = true,
        conflicts_with = "input",
        required_unless_present_any = ["input", "motors"]
    )]
    q: Option<String>,

    /// Motor values instead of joint values, for an arm with a transmission
    #[arg(
        long,
        value_name = "M1,M2,...",
        allow_hyphen_values = true,
        conflicts_with_all = ["input", "q"]
    )]
    motors: Option<String>,

    /// Angles in degrees, in and out
    #[arg(long)]
    deg: bool,

    #[command(flatten)]
    shown: Shown,

    /// Warn about values outside the joints' limits
    #[arg(long)]
    limits: bool,

    /// One JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    files: Files,
}

/// What an answer holds besides the pose.
#[derive(Args, Clone, Debug)]
pub(crate) struct Shown {
    /// The pose of every link frame
    #[arg(long)]
    frames: bool,

    /// The Jacobian, in the base's or the tool's axes
    #[arg(long, value_name = "AXES")]
    jacobian: Option<Axes>,

    /// How transforms are composed; the answers are equal to rounding
    #[arg(long, value_name = "METHOD", default_value = "matrix")]
    method: Method,
}

/// The axes a Jacobian is written in.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Axes {
    /// The base's
    Base,
    /// The tool's
    Tool,
}

impl From<Axes> for Reference {
    fn from(axes: Axes) -> Self {
        match axes {
            Axes::Base => Self::Base,
            Axes::Tool => Self::Tool,
        }
    }
}

/// How transforms are composed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Rotation matrices
    Matrix,
    /// Unit quaternions
    Quaternion,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = robot.chain()?;
        let drives = super::motors::of(&robot)?;
        if let Some(input) = &self.files.input {
            return self.files.answer(input, |request| {
                let joints = match (request.get("q"), request.get("motors")) {
                    (Some(q), _) => joints::from_json(&robot, &chain, q, self.deg)?,
                    (None, Some(motors)) => {
                        joints::from_motor_json(&robot, &chain, drives.as_ref(), motors, self.deg)?
                    }
                    (None, None) => {
                        return Err("\"q\" was expected: the joint values".to_owned());
                    }
                };
                let answer = Answer::compute(&robot, &chain, drives.as_ref(), &joints, &self.shown)
                    .map_err(|e| e.to_string())?;
                Ok(answer.batch_fields(self.limits, self.deg))
            });
        }
        let joints = match &self.motors {
            None => {
                let text = self.q.as_deref().unwrap_or_default();
                joints::from_text(&robot, &chain, text, self.deg)?
            }
            Some(text) => match joints::from_motor_text(&robot, &chain, text, self.deg)? {
                Ok(joints) => joints,
                Err(reason) => return self.unreachable(&robot.name, &reason),
            },
        };
        let answer = Answer::compute(&robot, &chain, drives.as_ref(), &joints, &self.shown)?;
        if self.limits {
            answer
                .violations
                .iter()
                .for_each(|text| output::warning(text));
        }
        if self.json {
            output::document(&answer.document(&robot.name, self.deg))?;
        } else {
            output::answer(&answer.text(&robot.name, self.deg))?;
        }
        Ok(Outcome::Done)
    }

    /// No joint values belong to the motors'.
    fn unreachable(&self, robot: &str, reason: &str) -> Result<Outcome, Failure> {
        match self.json {
            true => output::document(&json!({"robot": robot, "pose": null, "drive": reason}))?,
            false => output::answer(&format!("{robot}: the motors cannot stand so\n{reason}\n"))?,
        }
        Ok(Outcome::Negative)
    }
}
