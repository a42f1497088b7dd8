//! `pieper convert`

use std::fs;

use clap::{Args, ValueEnum};
use pieper::describe::{Convention, DhTable, Form, Robot, ScrewTable, urdf};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;

/// Write a robot in another description: table, screws or URDF, numerically equal
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper convert ar3 --to urdf
  pieper convert ur5 --to modified --out ur5-craig.toml

A table or screws of a URDF keep the tool's pose, not the URDF's link frames.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The description to write
    #[arg(long, value_name = "FORM")]
    to: Target,

    /// Where to; standard output if left out
    #[arg(long, value_name = "FILE")]
    out: Option<String>,
}

/// A description to write.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Target {
    /// A robot file with a standard (distal) Denavit-Hartenberg table
    Standard,
    /// A robot file with a modified (Craig's) Denavit-Hartenberg table
    Modified,
    /// A robot file with screw axes
    Screws,
    /// A URDF
    Urdf,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let chain = robot.chain()?;
        let form = match self.to {
            Target::Standard => Form::Dh(DhTable::of_chain(&chain, Convention::Standard)?),
            Target::Modified => Form::Dh(DhTable::of_chain(&chain, Convention::Modified)?),
            Target::Screws => Form::Screws(ScrewTable::of_chain(&chain)?),
            Target::Urdf => {
                return self.write(&urdf::write_chain(&identifier(&robot.name), &chain));
            }
        };
        // Numbers have taken the place of the parameters.
        let values = robot.values()?;
        let motors = robot.motors.iter().map(|motor| motor.in_numbers(&values));
        let converted = Robot {
            form,
            motors: motors.collect::<pieper::Result<_>>()?,
            parameters: Vec::new(),
            golden: Vec::new(),
            ..robot
        };
        self.write(&converted.to_toml()?)
    }

    fn write(&self, text: &str) -> Result<Outcome, Failure> {
        match &self.out {
            None => output::answer(text)?,
            Some(path) => {
                fs::write(path, text).map_err(|error| Failure::file("written", path, &error))?
            }
        }
        Ok(Outcome::Done)
    }
}

/// A name that ROS tools accept for a robot.
fn identifier(name: &str) -> String {
    let word = |c: char| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '_'
        }
    };
    name.chars().map(word).collect()
}
