//! `pieper codegen`

use std::fs;
use std::path::Path;

use clap::{Args, ValueEnum};
use pieper_symbolic::code::{self, Language, Precision, What};
use pieper_symbolic::{Arm, Lengths};

use crate::error::{Failure, Outcome};
use crate::output;
use crate::source::Source;

/// Generate source code: forward kinematics, Jacobian and closed-form inverse, free of dependencies
#[derive(Args)]
#[command(after_help = "\
Examples:
  pieper codegen ar3 --lang c --out ar3.c
  pieper codegen ur5 --lang python --what inverse

Lengths without a value become the functions' last arguments. C and C++ test themselves when compiled with
-DPIEPER_SELF_TEST, Rust with its test harness, Python when run, MATLAB and Octave by k.self_test().")]
pub(crate) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// The language
    #[arg(long, value_name = "LANGUAGE")]
    lang: Lang,

    /// What to generate; `all` leaves out what the arm does not have
    #[arg(long, value_name = "WHAT", default_value = "all")]
    what: Part,

    /// Single precision (Rust, C and C++)
    #[arg(long)]
    float: bool,

    /// Where to; standard output if left out
    #[arg(long, value_name = "FILE")]
    out: Option<String>,
}

/// A language.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Lang {
    /// Rust without the standard library
    Rust,
    /// C99 without allocation
    C,
    /// C++11
    Cpp,
    /// Python 3
    Python,
    /// MATLAB and Octave
    Matlab,
}

/// A part of an arm's kinematics.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Part {
    /// Forward kinematics
    Fk,
    /// Forward kinematics and the Jacobian
    Jacobian,
    /// Forward kinematics and the closed-form inverse
    Inverse,
    /// All of it
    All,
}

impl Arguments {
    pub(crate) fn run(self) -> Result<Outcome, Failure> {
        let robot = self.source.robot()?;
        let arm = Arm::new(&robot, Lengths::Symbols)?;
        let language = match self.lang {
            Lang::Rust => Language::Rust,
            Lang::C => Language::C,
            Lang::Cpp => Language::Cpp,
            Lang::Python => Language::Python,
            Lang::Matlab => Language::Matlab,
        };
        let what = match self.what {
            Part::Fk => What::Forward,
            Part::Jacobian => What::Jacobian,
            Part::Inverse => What::Inverse,
            Part::All => What::All,
        };
        let precision = if self.float {
            Precision::Float
        } else {
            Precision::Double
        };
        let stem = Path::new(&self.source.robot)
            .file_stem()
            .and_then(|stem| stem.to_str())
            .unwrap_or("arm");
        let text = code::generate(&arm, stem, language, what, precision)?;
        match &self.out {
            None => output::answer(&text)?,
            Some(path) => {
                fs::write(path, text).map_err(|error| Failure::file("written", path, &error))?
            }
        }
        Ok(Outcome::Done)
    }
}
