//! Texts with `${expression}` and `$(command argument)` in them.

/// A piece of a text, with its byte offset in it.
#[derive(Debug, PartialEq)]
pub(super) enum Piece<'a> {
    /// As it stands.
    Plain(&'a str),
    /// What stands between `${` and `}`.
    Expression(&'a str, usize),
    /// What stands between `$(` and `)`.
    Command(&'a str, usize),
}

/// Splits a text; an error is the offset of a bracket that is not closed.
///
/// Doubled dollar signs keep an expression from being one: `$${a}` is the text `${a}`.
pub(super) fn pieces(text: &str) -> Result<Vec<Piece<'_>>, usize> {
    let mut pieces = Vec::new();
    let (mut plain, mut at) = (0, 0);
    let bytes = text.as_bytes();
    while at < bytes.len() {
        if bytes[at] != b'$' {
            at += 1;
            continue;
        }
        let dollars = bytes[at..].iter().take_while(|&&b| b == b'$').count();
        let bracket = bytes.get(at + dollars).copied();
        if !matches!(bracket, Some(b'{' | b'(')) {
            at += dollars;
            continue;
        }
        if plain < at {
            pieces.push(Piece::Plain(&text[plain..at]));
        }
        if dollars > 1 {
            // One dollar fewer, and the bracket is plain text.
            plain = at + 1;
            at += dollars + 1;
            continue;
        }
        let start = at + 2;
        let is_expression = bracket == Some(b'{');
        let length = closing(&bytes[start..], is_expression).ok_or(at)?;
        let inner = &text[start..start + length];
        pieces.push(if is_expression {
            Piece::Expression(inner, start)
        } else {
            Piece::Command(inner, start)
        });
        at = start + length + 1;
        plain = at;
    }
    if plain < text.len() {
        pieces.push(Piece::Plain(&text[plain..]));
    }
    Ok(pieces)
}

/// Where the bracket that was opened just before closes; brackets in quotes do not count in an expression.
fn closing(bytes: &[u8], is_expression: bool) -> Option<usize> {
    let (open, close) = if is_expression {
        (b'{', b'}')
    } else {
        (b'(', b')')
    };
    let mut depth = 0usize;
    let mut quote = None;
    let mut escaped = false;
    for (at, &byte) in bytes.iter().enumerate() {
        if let Some(q) = quote {
            if escaped {
                escaped = false;
            } else if byte == b'\\' {
                escaped = true;
            } else if byte == q {
                quote = None;
            }
        } else if is_expression && (byte == b'\'' || byte == b'"') {
            quote = Some(byte);
        } else if byte == open {
            depth += 1;
        } else if byte == close {
            if depth == 0 {
                return Some(at);
            }
            depth -= 1;
        }
    }
    None
}
