//! The project's chores, run the same by people and by the continuous integration: `cargo xtask test`.

mod python;
mod steps;
mod studio;

use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask test     everything a change has to pass: format, lints, tests, documentation, checks against other programs
cargo xtask quick    the same without the checks that install Python or Node packages
cargo xtask page     builds the studio's page anew, after a change of its source
cargo xtask peers    only the checks against other programs (Pinocchio, mpmath, SymPy), installed below target/";

fn main() -> ExitCode {
    let argument = std::env::args().nth(1).unwrap_or_default();
    let done = match argument.as_str() {
        "test" => steps::workspace() && studio::checks() && python::checks(),
        "page" => studio::build(),
        "quick" => steps::workspace(),
        "peers" => steps::program() && python::checks(),
        _ => {
            steps::say(USAGE);
            return ExitCode::from(2);
        }
    };
    if done {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
