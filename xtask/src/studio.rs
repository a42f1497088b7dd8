//! The studio's page: its unit tests, whether the built page is what its source makes, and the whole in a real browser.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::steps::{found, in_integration, install, run, say};

/// The page's source.
const PAGE: &str = "crates/pieper-studio/page";

/// The page's checks; passed as well where there is no Node.js or no Chromium, with a word about it, except in the continuous
/// integration.
pub(crate) fn checks() -> bool {
    if !found("node") || !found("npm") {
        say(
            "not run: the checks of the studio's page (they need Node.js 20.19 or later with npm, and Chromium)",
        );
        return !in_integration();
    }
    npm("packages of the page", &["ci", "--no-audit", "--no-fund"])
        && npm("the page's unit tests", &["test"])
        && is_built()
        && in_browser()
}

/// Builds the page from its source: for whoever changes it.
pub(crate) fn build() -> bool {
    npm("packages of the page", &["ci", "--no-audit", "--no-fund"])
        && npm("the page", &["run", "build"])
}

/// Whether the page that is committed is the one that its source makes.
fn is_built() -> bool {
    let out = env::current_dir()
        .unwrap_or_default()
        .join("target/studio-page");
    let out = out.display().to_string();
    if !npm(
        "the page, anew",
        &["run", "build", "--", "--emptyOutDir", "--outDir", &out],
    ) {
        return false;
    }
    let same = files(Path::new(&out)) == files(&Path::new(PAGE).join("dist"));
    if !same {
        say(&format!(
            "{PAGE}/dist is not what its source makes: run `cargo xtask page` and commit it"
        ));
    }
    same
}

/// All files below a folder, by their paths from it.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if let (Ok(name), Ok(bytes)) = (path.strip_prefix(folder), fs::read(&path)) {
                found.insert(name.to_owned(), bytes);
            }
        }
    }
    found
}

fn in_browser() -> bool {
    if !found("chromium") {
        install("Chromium", &["chromium"]);
    }
    let Some(chromium) = [
        "/usr/bin/chromium",
        "/usr/bin/chromium-browser",
        "/usr/bin/google-chrome",
    ]
    .into_iter()
    .find(|path| Path::new(path).exists()) else {
        say(
            "not run: the studio in a browser (Chromium is not installed: apt-get install chromium)",
        );
        return !in_integration();
    };
    let mut command = Command::new("node");
    let program = env::current_dir()
        .unwrap_or_default()
        .join("target/release/pieper");
    command
        .arg("tests/browser/run.mjs")
        .current_dir(PAGE)
        .env("PIEPER", program)
        .env("CHROMIUM", chromium);
    run("the studio in a browser", command)
}

fn npm(step: &str, arguments: &[&str]) -> bool {
    let mut command = Command::new("npm");
    command.args(arguments).current_dir(PAGE);
    run(step, command)
}
