//! Comma-separated text, cut into cells that know their place.
//!
//! Written here because error messages need the place of every cell, not only of every line.

use std::borrow::Cow;

use crate::error::{Error, Place, Result};

/// Lines with more cells are refused: no arm has as many joints.
const MOST_CELLS: usize = 1000;

/// A cell: its text without surrounding blanks and quotes.
#[derive(Clone, Debug)]
pub(in crate::describe) struct Cell<'a> {
    pub(in crate::describe) text: Cow<'a, str>,
    /// The offset of its first character, or of its opening quote.
    pub(in crate::describe) start: usize,
}

impl Cell<'_> {
    /// The text in quotes, shortened to what fits in a message.
    pub(in crate::describe) fn shown(&self) -> String {
        if self.text.chars().count() > 40 {
            let start: String = self.text.chars().take(40).collect();
            format!("{:?}", format!("{start}..."))
        } else {
            format!("{:?}", self.text)
        }
    }
}

/// The lines that hold something, one after the other.
pub(in crate::describe) struct Records<'a> {
    file: &'a str,
    text: &'a str,
    at: usize,
    line_end: usize,
}

impl<'a> Records<'a> {
    pub(in crate::describe) fn new(file: &'a str, text: &'a str) -> Self {
        Self {
            file,
            text,
            at: 0,
            line_end: 0,
        }
    }

    /// Where the line last read ended.
    pub(in crate::describe) fn line_end(&self) -> usize {
        self.line_end
    }

    /// Puts the next line's cells into `cells`; `false` at the end of the text.
    pub(in crate::describe) fn read(&mut self, cells: &mut Vec<Cell<'a>>) -> Result<bool> {
        cells.clear();
        while self.at < self.text.len() {
            let line = self.rest().lines().next().unwrap_or_default();
            let start = line.trim_start();
            if start.is_empty() || start.starts_with('#') {
                self.at += line.len();
                self.skip_line_break();
                continue;
            }
            loop {
                if cells.len() == MOST_CELLS {
                    let text = format!("at most {MOST_CELLS} cells in a line were expected");
                    return Err(self.error(self.at, text));
                }
                cells.push(self.cell()?);
                if self.rest().starts_with(',') {
                    self.at += 1;
                } else {
                    break;
                }
            }
            self.line_end = self.at;
            self.skip_line_break();
            return Ok(true);
        }
        Ok(false)
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_line_break(&mut self) {
        let rest = self.rest();
        if rest.starts_with("\r\n") {
            self.at += 2;
        } else if rest.starts_with('\n') {
            self.at += 1;
        }
    }

    fn skip_blanks(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '\t']).len();
    }

    fn cell(&mut self) -> Result<Cell<'a>> {
        self.skip_blanks();
        let start = self.at;
        if self.rest().starts_with('"') {
            let text = self.quoted()?;
            self.skip_blanks();
            let rest = self.rest();
            let ended =
                rest.is_empty() || rest.starts_with([',', '\n']) || rest.starts_with("\r\n");
            if !ended {
                let text = "a comma or the end of the line was expected after the closing quote";
                return Err(self.error(self.at, text));
            }
            return Ok(Cell { text, start });
        }
        let rest = self.rest();
        let length = rest.find([',', '\n']).unwrap_or(rest.len());
        let cell = &rest[..length];
        // The carriage return of a line break is not the cell's.
        let cell = match rest[length..].starts_with(',') {
            true => cell,
            false => cell.strip_suffix('\r').unwrap_or(cell),
        };
        self.at += cell.len();
        Ok(Cell {
            text: cell.trim_end().into(),
            start,
        })
    }

    /// The text between quotes; two quotes stand for one.
    fn quoted(&mut self) -> Result<Cow<'a, str>> {
        let start = self.at;
        let mut text = Cow::Borrowed("");
        self.at += 1;
        loop {
            let Some(length) = self.rest().find('"') else {
                return Err(self.error(start, "a closing quote was expected"));
            };
            let part = &self.rest()[..length];
            self.at += length + 1;
            if text.is_empty() {
                text = part.into();
            } else {
                text.to_mut().push_str(part);
            }
            if !self.rest().starts_with('"') {
                return Ok(text);
            }
            text.to_mut().push('"');
            self.at += 1;
        }
    }

    #[cold]
    fn error(&self, offset: usize, expected: impl Into<String>) -> Error {
        let place = Place::of_offset(self.file, self.text, offset);
        let start: String = self.text[offset..]
            .lines()
            .next()
            .unwrap_or_default()
            .chars()
            .take(20)
            .collect();
        let subject = match start.is_empty() {
            true => start,
            false => format!("{start:?}"),
        };
        Error::parse(place, subject, expected)
    }
}
