//! The program `pieper`: kinematics of robot arms on the command line.
//!
//! A crate of its own because it is its own artifact: the library's users do not build it. One file per command;
//! what they share is reading a robot ([`source`]), joint values and poses, and writing answers.

mod batch;
mod commands;
mod error;
mod files;
mod json;
mod output;
mod source;
mod text;

use std::process::ExitCode;

use clap::Parser;

use commands::Command;

/// Kinematics of robot arms: from a table to poses, Jacobians and figures.
#[derive(Parser)]
#[command(name = "pieper", version, about, after_help = EXAMPLES, max_term_width = 110)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  pieper robots                                    the built-in robots
  pieper fk ar3 --q 0,45,-30,0,60,0 --deg          where the tool is
  pieper info irb120                               table, limits, reach
  pieper run ar3 examples/ar3-programme.csv --out out/ar3
                                                   figures and a report of a motion

ROBOT is a built-in name or a .toml, .urdf or .xacro file.
Exit codes: 0 done, 1 the answer is no, 2 bad input, 3 the outside world failed.";

fn main() -> ExitCode {
    let cli = Cli::parse();
    match cli.command.run() {
        Ok(outcome) => outcome.into(),
        Err(failure) => {
            let (code, text) = failure.verdict();
            text.into_iter().for_each(output::error);
            code
        }
    }
}
