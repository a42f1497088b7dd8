//! Expressions into tokens.

use std::fmt;

use super::value::Outcome;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Int(i64),
    Float(f64),
    Str(String),
    Name(String),
    Symbol(&'static str),
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(value) => write!(f, "{value}"),
            Self::Float(value) => write!(f, "{value}"),
            Self::Str(text) => write!(f, "the text '{text}'"),
            Self::Name(name) => write!(f, "'{name}'"),
            Self::Symbol(symbol) => write!(f, "'{symbol}'"),
        }
    }
}

/// Longer ones first: the first that fits is taken.
const SYMBOLS: [&str; 25] = [
    "**", "//", "==", "!=", "<=", ">=", "+", "-", "*", "/", "%", "<", ">", "(", ")", "[", "]", "{",
    "}", ",", ":", ".", "=", "|", "&",
];

pub(super) fn tokens(text: &str) -> Outcome<Vec<Token>> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let starts_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
        let (token, length) = if starts_number(rest) || (first == '.' && starts_number(&rest[1..]))
        {
            number(rest)?
        } else if first == '\'' || first == '"' {
            string(rest, first)?
        } else if is_name_start(first) {
            let end = rest.find(|c| !is_name_part(c)).unwrap_or(rest.len());
            (Token::Name(rest[..end].to_owned()), end)
        } else if let Some(&symbol) = SYMBOLS.iter().find(|symbol| rest.starts_with(**symbol)) {
            (Token::Symbol(symbol), symbol.len())
        } else {
            return Err(format!("'{first}' has no meaning here"));
        };
        tokens.push(token);
        rest = rest[length..].trim_start();
    }
    Ok(tokens)
}

fn is_name_start(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn is_name_part(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a text can be the name of a property.
pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(is_name_start) && text.chars().all(is_name_part)
}

fn number(text: &str) -> Outcome<(Token, usize)> {
    let digits = |from: usize| {
        let rest = &text[from..];
        from + rest
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(rest.len())
    };
    let mut end = digits(0);
    let mut is_integer = true;
    if text[end..].starts_with('.') {
        is_integer = false;
        end = digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let exponent = digits(end + 1 + sign);
        if exponent > end + 1 + sign {
            is_integer = false;
            end = exponent;
        }
    }
    let word = &text[..end];
    let wrong = || format!("{word} is no number");
    if text[end..].starts_with(is_name_part) {
        return Err(format!(
            "{word} is followed directly by '{}'",
            text[end..].chars().next().unwrap_or_default()
        ));
    }
    match word.parse() {
        Ok(value) if is_integer => Ok((Token::Int(value), end)),
        _ => match word.parse() {
            Ok(value) => Ok((Token::Float(value), end)),
            Err(_) => Err(wrong()),
        },
    }
}

fn string(text: &str, quote: char) -> Outcome<(Token, usize)> {
    let mut out = String::new();
    let mut chars = text.char_indices().skip(1);
    while let Some((at, c)) = chars.next() {
        if c == quote {
            return Ok((Token::Str(out), at + 1));
        }
        if c != '\\' {
            out.push(c);
            continue;
        }
        match chars.next() {
            Some((_, 'n')) => out.push('\n'),
            Some((_, 't')) => out.push('\t'),
            Some((_, c @ ('\\' | '\'' | '"'))) => out.push(c),
            Some((_, c)) => {
                out.push('\\');
                out.push(c);
            }
            None => break,
        }
    }
    Err(format!("the closing {quote} is missing"))
}
