//! Tokens: what both notations, plain and LaTeX, are cut into.

/// A piece of a claim, with its byte offset in the file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) offset: usize,
}

/// What a piece is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    /// Digits, perhaps with a point.
    Number(String),
    /// A name with its index: `Theta` and `1`; the index is empty where there is none.
    Name(String, String),
    /// `+ - * / ^ =`
    Operator(char),
    /// `(` and its kin; true for a bracket that may start a matrix.
    Open(bool),
    /// `)` and its kin.
    Close,
    /// `,` or `&` in a matrix.
    Comma,
    /// A new row of a matrix.
    Row,
    /// A line that ends: the claim goes on if it must.
    Line,
    /// The end of a claim.
    End,
}

impl Kind {
    /// The piece as a person would name it.
    pub(crate) fn shown(&self) -> String {
        match self {
            Self::Number(text) => format!("{text:?}"),
            Self::Name(base, index) => format!("{:?}", joined(base, index)),
            Self::Operator(c) => format!("{:?}", c.to_string()),
            Self::Open(_) => "an opening bracket".to_owned(),
            Self::Close => "a closing bracket".to_owned(),
            Self::Comma => "a comma".to_owned(),
            Self::Row => "a new row".to_owned(),
            Self::Line | Self::End => "the end of the claim".to_owned(),
        }
    }
}

/// A name as written in plain text.
pub(crate) fn joined(base: &str, index: &str) -> String {
    let glued = index.is_empty()
        || index.starts_with(|c: char| c.is_ascii_digit()) && base.chars().count() == 1;
    if glued {
        format!("{base}{index}")
    } else {
        format!("{base}_{index}")
    }
}

/// Resolves line ends: a sign printed on both sides of a break counts once, a claim that cannot be over goes on, and
/// one starts where a line holds an equation of its own.
pub(crate) fn resolve_lines(tokens: Vec<Token>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut depth = 0_usize;
    let mut index = 0;
    while index < tokens.len() {
        let token = &tokens[index];
        match token.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::End => depth = 0,
            _ => {}
        }
        index += 1;
        if token.kind != Kind::Line {
            out.push(token.clone());
            continue;
        }
        while tokens
            .get(index)
            .is_some_and(|next| next.kind == Kind::Line)
        {
            index += 1;
        }
        let next = tokens.get(index).map(|next| &next.kind);
        let before = out.last().map(|last| last.kind.clone());
        match (&before, next) {
            (Some(Kind::Operator(a)), Some(Kind::Operator(b))) if a == b && *a != '=' => index += 1,
            (Some(Kind::Operator(_) | Kind::Open(_) | Kind::Comma), _)
            | (_, Some(Kind::Operator(_))) => {}
            (None | Some(Kind::End), _) => {}
            _ if depth == 0 && starts_equation(&tokens[index..]) => {
                out.push(Token {
                    kind: Kind::End,
                    offset: token.offset,
                });
            }
            _ => {}
        }
    }
    out
}

/// Whether a line holds an equals sign outside brackets.
fn starts_equation(tokens: &[Token]) -> bool {
    let mut depth = 0_i32;
    for token in tokens {
        match token.kind {
            Kind::Open(_) => depth += 1,
            Kind::Close => depth -= 1,
            Kind::Operator('=') if depth == 0 => return true,
            Kind::End | Kind::Line => return depth > 0,
            _ => {}
        }
    }
    // Nothing more in the file: whatever stands there is a claim of its own, or a mistake to be told.
    true
}
