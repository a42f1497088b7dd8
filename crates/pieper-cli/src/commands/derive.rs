//! `pieper derive`

use std::fs;

use clap::{Args, ValueEnum};
use pieper_symbolic::derive::{self, Scope};
use pieper_symbolic::sheet::Format;
use pieper_symbolic::{Arm, Lengths};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;

/// Derive the formulas: table, matrices, pose, Jacobian and singularities; or the closed-form inverse
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper derive ar3
  pieper derive puma560 --inverse --format html --out puma560-inverse.html
  pieper derive six-axis --format latex --out six-axis.tex

Named lengths stay symbols unless --numeric puts their values in. LaTeX compiles as it is; HTML is self-contained.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The closed-form inverse, as numbered steps in the order in which one computes them
    #[arg(long)]
    inverse: bool,

    /// Put the values of named lengths in their place
    #[arg(long)]
    numeric: bool,

    /// What to write
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Shape,

    /// Where to; standard output if left out
    #[arg(long, value_name = "FILE")]
    out: Option<String>,
}

/// A format of a sheet.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Shape {
    /// For a terminal
    Text,
    /// Markdown with mathematics between dollar signs
    Markdown,
    /// A LaTeX document that compiles as it is
    Latex,
    /// A self-contained page
    Html,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let lengths = if self.numeric {
            Lengths::Numbers
        } else {
            Lengths::Symbols
        };
        let arm = Arm::new(&robot, lengths)?;
        let scope = if self.inverse {
            Scope::Inverse
        } else {
            Scope::Forward
        };
        let format = match self.format {
            Shape::Text => Format::Text,
            Shape::Markdown => Format::Markdown,
            Shape::Latex => Format::Latex,
            Shape::Html => Format::Html,
        };
        let text = derive::sheet(&arm, scope)?.print(format);
        match &self.out {
            None => output::answer(&text)?,
            Some(path) => {
                fs::write(path, text).map_err(|error| Failure::file("written", path, &error))?
            }
        }
        Ok(Outcome::Done)
    }
}
