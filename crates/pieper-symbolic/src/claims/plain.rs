//! Plain notation: `t11 = c1*(c4*c6 - s4*c5*s6)`, one claim a line.

use pieper::error::{Error, Place, Result};

use super::token::{Kind, Token};

/// Cuts a text into tokens. `#` starts a comment.
pub(crate) fn tokens(file: &str, text: &str) -> Result<Vec<Token>> {
    let mut out = Vec::new();
    let mut rest = text;
    // Open brackets, each with whether it holds a matrix.
    let mut open: Vec<bool> = Vec::new();
    while let Some(c) = rest.chars().next() {
        let offset = text.len() - rest.len();
        let mut length = c.len_utf8();
        let kind = match c {
            '#' => {
                length = rest.find('\n').unwrap_or(rest.len());
                None
            }
            '\n' if open.is_empty() => Some(Kind::Line),
            c if c.is_whitespace() => None,
            '0'..='9' | '.' => {
                length = number_length(rest);
                Some(Kind::Number(rest[..length].to_owned()))
            }
            c if c.is_alphabetic() => {
                let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
                length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
                Some(name(&rest[..length]))
            }
            '+' | '*' | '/' | '^' | '=' => Some(Kind::Operator(c)),
            '-' | '−' => Some(Kind::Operator('-')),
            '·' | '×' => Some(Kind::Operator('*')),
            '(' | '{' => {
                open.push(false);
                Some(Kind::Open(false))
            }
            '[' => {
                open.push(is_matrix(rest));
                Some(Kind::Open(open.last() == Some(&true)))
            }
            ')' | ']' | '}' => {
                open.pop();
                Some(Kind::Close)
            }
            ',' => Some(Kind::Comma),
            ';' if open.last() == Some(&true) => Some(Kind::Row),
            ';' => Some(Kind::End),
            other => {
                let place = Place::of_offset(file, text, offset);
                return Err(Error::parse(
                    place,
                    format!("{other:?}"),
                    "a formula was expected here",
                ));
            }
        };
        if c == '*' && rest[length..].starts_with('*') {
            length += 1;
            out.push(Token {
                kind: Kind::Operator('^'),
                offset,
            });
        } else {
            out.extend(kind.map(|kind| Token { kind, offset }));
        }
        rest = &rest[length..];
    }
    Ok(out)
}

/// The length of the decimal at the start.
pub(crate) fn number_length(text: &str) -> usize {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(text);
    let fraction = match text[whole..].strip_prefix('.') {
        Some(rest) => 1 + digits(rest),
        None => 0,
    };
    (whole + fraction).max(1)
}

/// A name and its index: what stands behind an underscore, or the digits behind the letters.
pub(crate) fn name(text: &str) -> Kind {
    let (base, index) = match text.split_once('_') {
        Some((base, index)) if !base.is_empty() => (base, index),
        _ => {
            let letters = text
                .find(|c: char| c.is_ascii_digit())
                .unwrap_or(text.len());
            text.split_at(letters)
        }
    };
    // atan2 is one word.
    if matches!(base, "atan" | "arctan") && index == "2" {
        return Kind::Name("atan2".to_owned(), String::new());
    }
    Kind::Name(base.to_owned(), index.to_owned())
}

/// Whether the bracket at the start holds a comma or a semicolon: a matrix or an index, no grouping.
fn is_matrix(text: &str) -> bool {
    let mut depth = 0_usize;
    for c in text.chars() {
        match c {
            '[' | '(' | '{' => depth += 1,
            ']' | ')' | '}' => depth = depth.saturating_sub(1),
            ',' | ';' if depth == 1 => return true,
            _ => {}
        }
        if depth == 0 {
            return false;
        }
    }
    false
}
