//! The crate's one error type: which figure, which part of its data, and what was expected.

use std::fmt;

/// What the crate's fallible functions return.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// An error of the crate.
///
/// ```
/// let error = pieper_plot::Error::input("times", "at least one was expected");
/// assert!(error.is_input());
/// assert_eq!(error.to_string(), "times: at least one was expected");
/// ```
#[derive(Debug)]
pub struct Error {
    kind: Kind,
    subject: String,
    message: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Input,
    Render,
}

impl Error {
    /// Data that cannot be drawn: empty, not finite, or of unequal lengths.
    #[cold]
    pub fn input(subject: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Kind::Input, subject.into(), message.into())
    }

    /// A figure that could not be turned into a bitmap.
    #[cold]
    pub(crate) fn render(message: impl Into<String>) -> Self {
        Self::new(Kind::Render, "PNG".to_owned(), message.into())
    }

    fn new(kind: Kind, subject: String, message: String) -> Self {
        Self {
            kind,
            subject,
            message,
        }
    }

    /// Whether the data handed in could not be drawn.
    pub fn is_input(&self) -> bool {
        self.kind == Kind::Input
    }

    /// Whether a bitmap could not be made: too large, or no memory for it.
    pub fn is_render(&self) -> bool {
        self.kind == Kind::Render
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.subject, self.message)
    }
}

impl std::error::Error for Error {}

/// Beyond this a range of numbers may overflow on its way to a picture.
const LARGEST: f64 = 1e100;

/// Refuses numbers that have no place in a picture.
pub(crate) fn finite<'a>(subject: &str, values: impl IntoIterator<Item = &'a f64>) -> Result<()> {
    let bad = |value: &&f64| value.is_nan() || value.abs() > LARGEST;
    match values.into_iter().enumerate().find(|(_, value)| bad(value)) {
        Some((index, value)) => Err(Error::input(
            subject,
            format!(
                "number {index} (from 0) is {value}; only numbers up to {LARGEST:e} can be drawn"
            ),
        )),
        None => Ok(()),
    }
}
