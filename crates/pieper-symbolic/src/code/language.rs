//! What differs between the languages.

use super::Precision;

/// A language to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Rust without the standard library; it links the C mathematics library.
    Rust,
    /// C99.
    C,
    /// C++11.
    Cpp,
    /// Python 3.
    Python,
    /// MATLAB and Octave.
    Matlab,
}

/// Words that cannot name a quantity in one of the languages, or that the generated code uses itself.
const TAKEN: [&str; 44] = [
    "as", "break", "c", "case", "const", "continue", "do", "else", "end", "enum", "extern",
    "false", "float", "fn", "for", "free", "function", "global", "if", "in", "int", "is", "lambda",
    "let", "loop", "match", "math", "mod", "mut", "not", "or", "pi", "pub", "q", "return", "s",
    "self", "static", "switch", "true", "type", "use", "while", "x",
];

impl Language {
    pub(super) fn is_c(self) -> bool {
        matches!(self, Self::C | Self::Cpp)
    }

    pub(super) fn comment(self) -> &'static str {
        match self {
            Self::Rust | Self::C | Self::Cpp => "//",
            Self::Python => "#",
            Self::Matlab => "%",
        }
    }

    pub(super) fn number_type(self, precision: Precision) -> &'static str {
        match (self, precision) {
            (Self::Rust, Precision::Double) => "f64",
            (Self::Rust, Precision::Float) => "f32",
            (_, Precision::Double) => "double",
            (_, Precision::Float) => "float",
        }
    }

    /// A function of the mathematics library.
    pub(super) fn function(self, name: &str, precision: Precision) -> String {
        match (self, precision) {
            (Self::Rust, _) => format!("math::{name}"),
            (Self::C, Precision::Float) => format!("{name}f"),
            (Self::Cpp, _) => format!("std::{name}"),
            (Self::Python, _) => format!("math.{name}"),
            _ => name.to_owned(),
        }
    }

    /// A number.
    pub(super) fn number(self, value: f64, precision: Precision) -> String {
        let text = format!("{value:?}");
        match (self.is_c(), precision) {
            (true, Precision::Float) => format!("{text}f"),
            _ => text,
        }
    }

    /// Ends a statement.
    pub(super) fn stop(self) -> &'static str {
        if self == Self::Python { "" } else { ";" }
    }

    /// An entry of a vector, counted from 0.
    pub(super) fn at(self, name: &str, index: usize) -> String {
        match self {
            Self::Matlab => format!("{name}({})", index + 1),
            _ => format!("{name}[{index}]"),
        }
    }

    /// An entry of a matrix, counted from 0.
    pub(super) fn entry(self, name: &str, row: usize, column: usize) -> String {
        match self {
            Self::Matlab => format!("{name}({}, {})", row + 1, column + 1),
            _ => format!("{name}[{row}][{column}]"),
        }
    }

    /// A name the language allows.
    pub(super) fn name(self, name: &str) -> String {
        let mut plain: String = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
            .collect();
        if plain.starts_with(|c: char| c.is_ascii_digit() || c == '_') {
            plain.insert(0, 'p');
        }
        if TAKEN.contains(&plain.as_str()) {
            plain.push('_');
        }
        plain
    }
}
