//! How a command ends: its exit code, and what it says on standard error.

use std::fmt::Display;
use std::io;
use std::process::ExitCode;

/// A command's result that is no error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// Exit code 0.
    Done,
    /// Exit code 1: the question has a negative answer.
    Negative,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Done => Self::SUCCESS,
            Outcome::Negative => Self::from(1),
        }
    }
}

/// Why a command could not do its work.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Exit code 2: bad input, in words that name the place and what was expected.
    Input(String),
    /// Exit code 3: the outside world failed.
    World(String),
    /// Whoever read our output has gone; nothing is left to say.
    ClosedPipe,
}

impl Failure {
    /// Bad input.
    pub(crate) fn input(text: impl Into<String>) -> Self {
        Self::Input(text.into())
    }

    /// A file could not be read, written or made.
    pub(crate) fn file(action: &str, path: impl Display, error: &io::Error) -> Self {
        let text = format!("{path}: it could not be {action}: {error}");
        match error.kind() {
            io::ErrorKind::NotFound | io::ErrorKind::IsADirectory | io::ErrorKind::InvalidData => {
                Self::Input(text)
            }
            _ => Self::World(text),
        }
    }

    /// The exit code, and what to say; nothing where nobody is left to tell.
    pub(crate) fn verdict(&self) -> (ExitCode, Option<&str>) {
        match self {
            Self::ClosedPipe => (ExitCode::SUCCESS, None),
            Self::Input(text) => (ExitCode::from(2), Some(text)),
            Self::World(text) => (ExitCode::from(3), Some(text)),
        }
    }
}

impl From<pieper::Error> for Failure {
    fn from(error: pieper::Error) -> Self {
        let hint = match error.is_missing_value() {
            true => ": give them with --set NAME=VALUE",
            false => "",
        };
        Self::Input(format!("{error}{hint}"))
    }
}
