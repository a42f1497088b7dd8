//! The one place that writes to standard output and standard error.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::error::Failure;

/// Writes an answer to standard output.
pub(crate) fn answer(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|e| written("standard output", e))
}

/// Writes one JSON document to standard output.
pub(crate) fn document(value: &serde_json::Value) -> Result<(), Failure> {
    answer(&format!("{value:#}\n"))
}

/// Where a batch goes: a file, or standard output for `-`.
pub(crate) fn open(path: &str) -> Result<Box<dyn Write>, Failure> {
    if path == "-" {
        return Ok(Box::new(BufWriter::new(io::stdout().lock())));
    }
    let file =
        File::create(Path::new(path)).map_err(|error| Failure::file("written", path, &error))?;
    Ok(Box::new(BufWriter::new(file)))
}

/// What a failed write means.
pub(crate) fn written(what: &str, error: io::Error) -> Failure {
    match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::World(format!("{what}: it could not be written: {error}")),
    }
}

/// Says why a command failed, on standard error. If even that cannot be written, there is nobody to tell.
pub(crate) fn error(text: &str) {
    let _ = writeln!(io::stderr(), "error: {text}");
}

/// Says what a person should know, on standard error.
pub(crate) fn warning(text: &str) {
    let _ = writeln!(io::stderr(), "warning: {text}");
}

/// Says what goes on, on standard error.
pub(crate) fn note(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}
