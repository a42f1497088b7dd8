//! The commands, one file each.

mod convert;
mod fk;
mod ik;
mod info;
mod motors;
mod robots;
mod run;

use clap::Subcommand;

use crate::error::{Failure, Outcome};

/// What to do.
#[derive(Subcommand)]
pub(crate) enum Command {
    /// List the built-in robots
    Robots(robots::Arguments),
    /// Show a robot: table, frames at zero, limits, reach
    Info(info::Arguments),
    /// Forward kinematics: joint values in, the tool's pose out
    Fk(fk::Arguments),
    /// Run a motion table: figures, a report, matrices and samples
    Run(run::Arguments),
    /// Write a robot in another description: table, screws or URDF
    Convert(convert::Arguments),
    /// Inverse kinematics: a pose in, every solution out
    Ik(ik::Arguments),
}

impl Command {
    /// Does it.
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        match self {
            Self::Robots(arguments) => arguments.run(),
            Self::Info(arguments) => arguments.run(),
            Self::Fk(arguments) => arguments.run(),
            Self::Run(arguments) => arguments.run(),
            Self::Convert(arguments) => arguments.run(),
            Self::Ik(arguments) => arguments.run(),
        }
    }
}
