//! LaTeX as papers write it, cut into the same tokens as plain notation.

use pieper::error::{Error, Place, Result};

use super::plain::number_length;
use super::token::{Kind, Token};

/// Cuts a text into tokens. `%` starts a comment.
pub(crate) fn tokens(file: &str, text: &str) -> Result<Vec<Token>> {
    let mut lexer = Lexer {
        file,
        text,
        rest: text,
        out: Vec::new(),
        open: Vec::new(),
    };
    while !lexer.rest.is_empty() {
        lexer.step()?;
    }
    Ok(lexer.out)
}

struct Lexer<'a> {
    file: &'a str,
    text: &'a str,
    rest: &'a str,
    out: Vec<Token>,
    /// Open brackets and matrices; true for matrices.
    open: Vec<bool>,
}

/// Environments that are matrices.
const MATRICES: [&str; 8] = [
    "matrix",
    "pmatrix",
    "bmatrix",
    "Bmatrix",
    "vmatrix",
    "smallmatrix",
    "array",
    "tabular",
];

/// Commands that say how something looks: what they are applied to is the name.
const ACCENTS: [&str; 15] = [
    "vec",
    "hat",
    "bar",
    "tilde",
    "mathbf",
    "mathrm",
    "mathit",
    "mathsf",
    "mathcal",
    "boldsymbol",
    "bm",
    "text",
    "textrm",
    "operatorname",
    "overrightarrow",
];

/// Commands without meaning here.
const SILENT: [&str; 26] = [
    "left",
    "right",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "quad",
    "qquad",
    "displaystyle",
    "nonumber",
    "notag",
    "limits",
    "hfill",
    "noindent",
    "centering",
    "hline",
    "par",
    "rm",
];

/// Commands that are letters in other commands' clothes.
const SAME: [(&str, &str); 10] = [
    ("vartheta", "theta"),
    ("varphi", "phi"),
    ("varepsilon", "epsilon"),
    ("arctan", "atan"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("cot", "cot"),
    ("dfrac", "frac"),
    ("tfrac", "frac"),
    ("cfrac", "frac"),
];

impl<'a> Lexer<'a> {
    fn offset(&self) -> usize {
        self.text.len() - self.rest.len()
    }

    fn error(&self, offset: usize, subject: &str, expected: &str) -> Error {
        Error::parse(
            Place::of_offset(self.file, self.text, offset),
            format!("{subject:?}"),
            expected,
        )
    }

    fn push(&mut self, kind: Kind, offset: usize) {
        self.out.push(Token { kind, offset });
    }

    fn skip(&mut self, length: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at(length);
        self.rest = rest;
        taken
    }

    fn step(&mut self) -> Result<()> {
        let offset = self.offset();
        let Some(c) = self.rest.chars().next() else {
            return Ok(());
        };
        match c {
            '%' => {
                let length = self.rest.find('\n').unwrap_or(self.rest.len());
                self.skip(length);
            }
            '\n' => {
                self.skip(1);
                let blank = self
                    .rest
                    .split('\n')
                    .next()
                    .is_some_and(|line| line.trim().is_empty());
                if blank && !self.rest.is_empty() && self.open.is_empty() {
                    self.push(Kind::End, offset);
                }
            }
            '\\' => self.command(offset)?,
            '0'..='9' => {
                let mut length = number_length(self.rest);
                // A full stop that ends a sentence is no decimal point.
                if self.rest[..length].ends_with('.') {
                    length -= 1;
                }
                let digits = self.skip(length);
                self.push(Kind::Number(digits.to_owned()), offset);
            }
            c if c.is_alphabetic() => {
                self.skip(c.len_utf8());
                self.name(c.to_string(), offset)?;
            }
            _ => self.symbol(c, offset)?,
        }
        Ok(())
    }

    fn symbol(&mut self, c: char, offset: usize) -> Result<()> {
        self.skip(c.len_utf8());
        match c {
            c if c.is_whitespace() => {}
            '~' | '$' => {}
            '+' | '*' | '/' | '^' | '=' => self.push(Kind::Operator(c), offset),
            '-' | '−' => self.push(Kind::Operator('-'), offset),
            '·' | '×' => self.push(Kind::Operator('*'), offset),
            '(' | '[' | '{' => {
                self.open.push(false);
                self.push(Kind::Open(false), offset);
            }
            ')' | ']' | '}' => {
                self.open.pop();
                self.push(Kind::Close, offset);
            }
            '&' if self.open.last() == Some(&true) => self.push(Kind::Comma, offset),
            '&' => {}
            ',' if self.open.is_empty() => self.push(Kind::End, offset),
            ',' => self.push(Kind::Comma, offset),
            ';' | '.' => self.push(Kind::End, offset),
            other => {
                return Err(self.error(offset, &other.to_string(), "a formula was expected here"));
            }
        }
        Ok(())
    }

    fn command(&mut self, offset: usize) -> Result<()> {
        self.skip(1);
        let length = self
            .rest
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(self.rest.len());
        if length == 0 {
            let Some(c) = self.rest.chars().next() else {
                return Ok(());
            };
            self.skip(c.len_utf8());
            match c {
                '\\' => {
                    // A line break may carry an extra space: \\[2mm]
                    if self.rest.starts_with('[')
                        && let Some(end) = self.rest.find(']')
                    {
                        self.skip(end + 1);
                    }
                    let kind = if self.open.last() == Some(&true) {
                        Kind::Row
                    } else {
                        Kind::Line
                    };
                    self.push(kind, offset);
                }
                '{' => {
                    self.open.push(false);
                    self.push(Kind::Open(false), offset);
                }
                '}' => {
                    self.open.pop();
                    self.push(Kind::Close, offset);
                }
                _ => {}
            }
            return Ok(());
        }
        let word = self.skip(length);
        match word {
            "times" | "cdot" | "ast" => self.push(Kind::Operator('*'), offset),
            "begin" | "end" => self.environment(word == "begin", offset)?,
            "label" | "tag" | "hspace" | "vspace" | "color" => {
                self.braced(offset)?;
            }
            word if ACCENTS.contains(&word) => {
                let name = self.accented(offset)?;
                let trimmed = name.trim();
                if let Some(word) = trimmed.strip_prefix("atan2") {
                    self.push(Kind::Name("atan2".to_owned(), word.to_owned()), offset);
                } else if !trimmed.is_empty() {
                    self.name(trimmed.to_owned(), offset)?;
                }
            }
            word if SILENT.contains(&word) => {
                // \left. and \right. stand for no bracket.
                if matches!(word, "left" | "right") && self.rest.starts_with('.') {
                    self.skip(1);
                }
            }
            word => {
                let same = SAME.iter().find(|(known, _)| *known == word);
                let word = same.map_or(word, |(_, other)| other);
                self.name(word.to_owned(), offset)?;
            }
        }
        Ok(())
    }

    fn environment(&mut self, begins: bool, offset: usize) -> Result<()> {
        let name = self.braced(offset)?.trim_end_matches('*').to_owned();
        if !MATRICES.contains(&name.as_str()) {
            if self.open.is_empty() {
                self.push(Kind::Line, offset);
            }
            return Ok(());
        }
        if begins {
            self.open.push(true);
            self.push(Kind::Open(true), offset);
            // An array's column specification.
            if matches!(name.as_str(), "array" | "tabular")
                && self.rest.trim_start().starts_with('{')
            {
                self.braced(offset)?;
            }
        } else {
            self.open.pop();
            self.push(Kind::Close, offset);
        }
        Ok(())
    }

    /// The text in the braces that follow.
    fn braced(&mut self, offset: usize) -> Result<&'a str> {
        self.rest = self.rest.trim_start();
        let inner = self.rest.strip_prefix('{').and_then(|rest| {
            let mut depth = 1_usize;
            let end = rest.char_indices().find(|(_, c)| {
                match c {
                    '{' => depth += 1,
                    '}' => depth -= 1,
                    _ => {}
                }
                depth == 0
            });
            end.map(|(end, _)| &rest[..end])
        });
        let Some(inner) = inner else {
            return Err(self.error(
                offset,
                "\\",
                "a group in braces was expected behind this command",
            ));
        };
        self.skip(inner.len() + 2);
        Ok(inner)
    }

    /// What an accent stands on: a group, or one letter.
    fn accented(&mut self, offset: usize) -> Result<String> {
        self.rest = self.rest.trim_start();
        if self.rest.starts_with('{') {
            let inner = self.braced(offset)?;
            return Ok(inner.trim_start_matches('\\').replace('\\', ""));
        }
        match self.rest.chars().next() {
            Some(c) => Ok(self.skip(c.len_utf8()).to_owned()),
            None => Err(self.error(offset, "\\", "a name was expected behind this accent")),
        }
    }

    /// A name and the index behind it.
    fn name(&mut self, base: String, offset: usize) -> Result<()> {
        let before = self.rest;
        self.rest = self.rest.trim_start();
        let Some(rest) = self.rest.strip_prefix('_') else {
            self.rest = before;
            self.push(Kind::Name(base, String::new()), offset);
            return Ok(());
        };
        self.rest = rest.trim_start();
        let index = if self.rest.starts_with('{') {
            let inner = self.braced(offset)?;
            let plain: String = inner
                .chars()
                .filter(|c| !matches!(c, '{' | '}' | '\\' | ' ' | ','))
                .collect();
            plain
                .replace("mathrm", "")
                .replace("text", "")
                .replace("rm", "")
        } else {
            match self.rest.chars().next() {
                Some(c) if c.is_alphanumeric() => self.skip(c.len_utf8()).to_owned(),
                _ => {
                    return Err(self.error(
                        offset,
                        &base,
                        "an index was expected behind its underscore",
                    ));
                }
            }
        };
        self.push(Kind::Name(base, index), offset);
        Ok(())
    }
}
