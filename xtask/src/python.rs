//! Checks against independent programs, which live in Python packages.
//!
//! They are installed into `target/peers`, a virtual environment of its own; nothing outside the folder changes.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::steps::{run, say};

/// The independent checks; passed as well where there is no Python, with a word about it, except in the
/// continuous integration.
pub(crate) fn checks() -> bool {
    let Some(python) = environment() else {
        let missing = "not run: the checks against Pinocchio, mpmath, SymPy and protobuf (they need python3 >= 3.11 with venv, and PyPI)";
        say(missing);
        return std::env::var_os("CI").is_none();
    };
    let check = |step: &str, arguments: &[&str]| {
        let mut command = Command::new(&python);
        command.args(arguments);
        run(step, command)
    };
    check("golden poses, by mpmath", &["robots/golden.py", "--check"])
        && check(
            "URDF frames, by Pinocchio",
            &["tests/urdf_peer.py", "--bin", "target/release/pieper"],
        )
        && check(
            "equality of formulas, by SymPy",
            &["tests/sympy_peer.py", "--bin", "target/release/pieper"],
        )
        && check("EGM messages, by Google's protobuf", &["tests/egm_peer.py"])
}

/// The virtual environment's interpreter, made and filled if need be.
fn environment() -> Option<PathBuf> {
    let folder = Path::new("target/peers");
    let python = folder.join("bin/python");
    if !python.exists() {
        let mut command = Command::new("python3");
        command
            .args(["-m", "venv"])
            .arg(folder)
            .stderr(Stdio::inherit());
        run("Python environment", command).then_some(())?;
    }
    let mut install = Command::new(&python);
    install.args([
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "-r",
        "tests/requirements.txt",
    ]);
    run("Python packages", install).then_some(python)
}
