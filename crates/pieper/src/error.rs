//! The library's one error type: what went wrong, where, and what was expected.

use std::fmt;

/// What the library's fallible functions return.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// An error of the library.
///
/// Opaque: ask it with the `is_*` predicates, print it with `Display`. The text names the place
/// (file, line and column where there is one), the offending text, and what was expected.
///
/// ```
/// let error = pieper::Error::input("joint values", "6 were expected, 5 were given");
/// assert!(error.is_input());
/// assert_eq!(error.to_string(), "joint values: 6 were expected, 5 were given");
/// ```
pub struct Error(Box<Inner>);

struct Inner {
    kind: Kind,
    place: Option<Place>,
    subject: String,
    message: String,
    cause: Option<Error>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Parse,
    Model,
    Input,
    MissingValue,
    Resource,
}

/// A place in a text file, counted from 1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The file's name as the caller gave it; empty for text without a name.
    pub file: String,
    /// Line, from 1; 0 where unknown.
    pub line: usize,
    /// Column in characters, from 1; 0 where unknown.
    pub column: usize,
}

impl Place {
    /// The place of the byte `offset` in `text`, a file called `file`.
    ///
    /// ```
    /// let place = pieper::error::Place::of_offset("arm.toml", "a = 1\nb = x\n", 10);
    /// assert_eq!((place.line, place.column), (2, 5));
    /// ```
    pub fn of_offset(file: &str, text: &str, offset: usize) -> Self {
        let mut end = offset.min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &text[..end];
        let line = before.matches('\n').count() + 1;
        let column = before
            .rsplit('\n')
            .next()
            .unwrap_or_default()
            .chars()
            .count()
            + 1;
        Self {
            file: file.to_owned(),
            line,
            column,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = if self.file.is_empty() {
            "text"
        } else {
            &self.file
        };
        match (self.line, self.column) {
            (0, _) => write!(f, "{file}"),
            (line, 0) => write!(f, "{file}:{line}"),
            (line, column) => write!(f, "{file}:{line}:{column}"),
        }
    }
}

impl Error {
    /// A text that does not read: `subject` is the offending text, `message` says what was expected.
    ///
    /// A default place is none: [`Error::at`] can add it later.
    #[cold]
    pub fn parse(place: Place, subject: impl Into<String>, message: impl Into<String>) -> Self {
        let place = (place != Place::default()).then_some(place);
        Self::new(Kind::Parse, place, subject.into(), message.into())
    }

    /// A description that reads, but is no valid arm.
    #[cold]
    pub fn model(subject: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Kind::Model, None, subject.into(), message.into())
    }

    /// A call's argument that does not fit: wrong count, not finite, not a rotation.
    #[cold]
    pub fn input(subject: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Kind::Input, None, subject.into(), message.into())
    }

    /// A number was asked for, but depends on symbols without a value.
    #[cold]
    pub fn missing_value(subject: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Kind::MissingValue, None, subject.into(), message.into())
    }

    /// A file or package that a description refers to cannot be had.
    #[cold]
    pub fn resource(subject: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(Kind::Resource, None, subject.into(), message.into())
    }

    fn new(kind: Kind, place: Option<Place>, subject: String, message: String) -> Self {
        Self(Box::new(Inner {
            kind,
            place,
            subject,
            message,
            cause: None,
        }))
    }

    /// The same error, with the place it was found at, unless it already knows one.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        self.0.place.get_or_insert(place);
        self
    }

    /// The same error, with the error that caused it.
    #[must_use]
    pub fn caused_by(mut self, cause: Error) -> Self {
        self.0.cause = Some(cause);
        self
    }

    /// Whether a text did not read.
    pub fn is_parse(&self) -> bool {
        self.0.kind == Kind::Parse
    }

    /// Whether a description was no valid arm.
    pub fn is_model(&self) -> bool {
        self.0.kind == Kind::Model
    }

    /// Whether an argument did not fit.
    pub fn is_input(&self) -> bool {
        self.0.kind == Kind::Input
    }

    /// Whether symbols without a value stood in the way of a number.
    pub fn is_missing_value(&self) -> bool {
        self.0.kind == Kind::MissingValue
    }

    /// Whether a file or package could not be had.
    pub fn is_resource(&self) -> bool {
        self.0.kind == Kind::Resource
    }

    /// Where in a text the error stands, if it came from one.
    pub fn place(&self) -> Option<&Place> {
        self.0.place.as_ref()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Inner {
            place,
            subject,
            message,
            ..
        } = &*self.0;
        if let Some(place) = place {
            write!(f, "{place}: ")?;
        }
        if !subject.is_empty() {
            write!(f, "{subject}: ")?;
        }
        f.write_str(message)
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} error: {self}", self.0.kind)?;
        match &self.0.cause {
            Some(cause) => write!(f, "\ncaused by: {cause:?}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.0.cause.as_ref().map(|cause| cause as _)
    }
}
