//! The commands, one file each.

mod calibrate;
mod check;
mod codegen;
mod convert;
mod derive;
mod fk;
mod ik;
mod info;
mod link;
mod motors;
mod robots;
mod run;
mod studio;

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
    /// Derive the formulas: the step sheet of an arm
    Derive(derive::Arguments),
    /// Check printed formulas against an arm
    Check(check::Arguments),
    /// Identify the arm that is really there from measurements
    Calibrate(calibrate::Arguments),
    /// Generate source code: Rust, C, C++, Python or MATLAB
    Codegen(codegen::Arguments),
    /// Inverse kinematics: a pose in, every solution out
    Ik(ik::Arguments),
    /// Watch and move a real arm, or a simulated one
    Link(link::Arguments),
    /// Show a robot in 3D, in the browser: move it, drag it, play motions
    Studio(studio::Arguments),
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
            Self::Derive(arguments) => arguments.run(),
            Self::Check(arguments) => arguments.run(),
            Self::Calibrate(arguments) => arguments.run(),
            Self::Codegen(arguments) => arguments.run(),
            Self::Ik(arguments) => arguments.run(),
            Self::Link(arguments) => arguments.run(),
            Self::Studio(arguments) => arguments.run(),
        }
    }
}
