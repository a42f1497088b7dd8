//! The steps that need nothing but the Rust toolchain.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Format, lints, tests, doc tests, documentation, and the release build that other checks drive.
pub(crate) fn workspace() -> bool {
    let tests: &[&str] = if has_nextest() {
        &[
            "nextest",
            "run",
            "--workspace",
            "--all-features",
            "--no-fail-fast",
        ]
    } else {
        say(
            "cargo-nextest is not installed (cargo install cargo-nextest): cargo test runs the tests instead, slower",
        );
        &[
            "test",
            "--workspace",
            "--all-features",
            "--lib",
            "--bins",
            "--tests",
            "--examples",
        ]
    };
    octave();
    avr();
    cargo("format", &["fmt", "--all", "--check"])
        && cargo(
            "lints",
            &[
                "clippy",
                "--workspace",
                "--all-targets",
                "--all-features",
                "--",
                "-D",
                "warnings",
            ],
        )
        && cargo("tests", tests)
        && cargo(
            "examples in the documentation",
            &["test", "--workspace", "--all-features", "--doc"],
        )
        && documentation()
        && program()
}

/// The program, as users build it.
pub(crate) fn program() -> bool {
    cargo("program", &["build", "--release"])
}

fn documentation() -> bool {
    let arguments = ["doc", "--workspace", "--all-features", "--no-deps"];
    let mut command = Command::new("cargo");
    command.args(arguments).env("RUSTDOCFLAGS", "-D warnings");
    run("documentation", command)
}

/// Octave, which runs the generated MATLAB code. Without it that test is left out with a word about it.
fn octave() {
    if !found("octave-cli") {
        install("Octave", &["octave"]);
    }
}

/// The AVR compiler and simavr, which run the reference firmware as a board would. Without them that test is left out with a word
/// about it.
fn avr() {
    if !found("avr-gcc") || !Path::new("/usr/include/simavr/sim_avr.h").exists() {
        let packages = ["gcc-avr", "avr-libc", "libsimavr-dev", "libelf-dev"];
        install("AVR compiler and simavr", &packages);
    }
}

/// Whether the project's continuous integration runs this, rather than a person.
pub(crate) fn in_integration() -> bool {
    std::env::var_os("CI").is_some()
}

/// Whether a program is there.
pub(crate) fn found(program: &str) -> bool {
    let mut command = Command::new(program);
    command
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Installs packages in the continuous integration where Debian's packages are at hand; on a person's computer nothing is
/// installed.
pub(crate) fn install(step: &str, packages: &[&str]) {
    if !in_integration() || !found("apt-get") {
        return;
    }
    let mut update = Command::new("apt-get");
    update.args(["update", "-qq"]);
    let mut install = Command::new("apt-get");
    install
        .args(["install", "-y", "-qq", "--no-install-recommends"])
        .args(packages)
        .env("DEBIAN_FRONTEND", "noninteractive");
    let _ = run("package lists", update) && run(step, install);
}

fn has_nextest() -> bool {
    let mut command = Command::new("cargo");
    command
        .args(["nextest", "--version"])
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

fn cargo(step: &str, arguments: &[&str]) -> bool {
    let mut command = Command::new("cargo");
    command.args(arguments);
    run(step, command)
}

/// Runs one step and says how it went.
pub(crate) fn run(step: &str, mut command: Command) -> bool {
    let shown = format!("{command:?}").replace('"', "");
    say(&format!("\n=== {step}: {shown}"));
    let start = Instant::now();
    let passed = match command.status() {
        Ok(status) => status.success(),
        Err(error) => {
            say(&format!("it could not be started: {error}"));
            false
        }
    };
    let verdict = if passed { "passed" } else { "FAILED" };
    say(&format!(
        "=== {step}: {verdict} in {:.1} s",
        start.elapsed().as_secs_f64()
    ));
    passed
}

/// A line for whoever watches; without anyone, there is nobody to tell.
pub(crate) fn say(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}
