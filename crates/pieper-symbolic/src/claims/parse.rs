//! Tokens to claims, by recursive descent.

use pieper::error::{Error, Place, Result};

use super::ast::{Equation, Expr, Node};
use super::token::{Kind, Token, joined};
use crate::number;

/// Formulas nest at most this deep: more is a mistake, and would exhaust the stack.
const MAX_DEPTH: usize = 60;

/// Sums and products are at most this long, for the same reason.
const MAX_CHAIN: usize = 400;

/// Exponents are at most this.
const MAX_EXPONENT: u32 = 16;

/// Functions a claim may call, with their numbers of arguments.
const FUNCTIONS: [(&str, usize); 10] = [
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("asin", 1),
    ("acos", 1),
    ("atan", 1),
    ("atan2", 2),
    ("sqrt", 1),
    ("abs", 1),
    ("det", 1),
];

/// Reads every claim.
pub(crate) fn equations(file: &str, text: &str, tokens: &[Token]) -> Result<Vec<Equation>> {
    let mut parser = Parser {
        file,
        text,
        tokens,
        position: 0,
        depth: 0,
    };
    let mut found = Vec::new();
    loop {
        while parser.take(&Kind::End) || parser.take(&Kind::Line) {}
        if parser.position == tokens.len() {
            return Ok(found);
        }
        found.push(parser.equation()?);
    }
}

/// Reads one formula that ends where the tokens do.
pub(crate) fn formula(file: &str, text: &str, tokens: &[Token]) -> Result<Expr> {
    let mut parser = Parser {
        file,
        text,
        tokens,
        position: 0,
        depth: 0,
    };
    let expr = parser.sum()?;
    match parser.peek() {
        None => Ok(expr),
        Some(_) => Err(parser.error("an operator or the end of the formula")),
    }
}

struct Parser<'a> {
    file: &'a str,
    text: &'a str,
    tokens: &'a [Token],
    position: usize,
    depth: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Kind> {
        self.tokens.get(self.position).map(|token| &token.kind)
    }

    fn offset(&self) -> usize {
        self.tokens
            .get(self.position)
            .map_or(self.text.trim_end().len(), |token| token.offset)
    }

    fn take(&mut self, kind: &Kind) -> bool {
        let found = self.peek() == Some(kind);
        self.position += usize::from(found);
        found
    }

    fn error(&self, expected: &str) -> Error {
        let place = Place::of_offset(self.file, self.text, self.offset());
        let found = self
            .peek()
            .map_or_else(|| "the end of the file".to_owned(), Kind::shown);
        Error::parse(
            place,
            "",
            format!("{expected} was expected, {found} was found"),
        )
    }

    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.error("a less deeply nested formula"));
        }
        let result = read(self);
        self.depth -= 1;
        result
    }

    fn equation(&mut self) -> Result<Equation> {
        let offset = self.offset();
        let mut sides = vec![self.sum()?];
        while self.take(&Kind::Operator('=')) {
            sides.push(self.sum()?);
        }
        if sides.len() == 1 {
            return Err(self.error("an operator or '=' with what the formula is said to be"));
        }
        let mut conditions = Vec::new();
        if self.word(&["when", "where", "if", "for"]) {
            loop {
                let left = self.sum()?;
                if !self.take(&Kind::Operator('=')) {
                    return Err(self.error("'=' with the joint's value"));
                }
                conditions.push((left, self.sum()?));
                if !(self.take(&Kind::Comma) || self.word(&["and"])) {
                    break;
                }
            }
        }
        match self.peek() {
            None | Some(Kind::End | Kind::Line) => Ok(Equation {
                sides,
                conditions,
                offset,
            }),
            Some(_) => Err(self.error("an operator or the end of the claim")),
        }
    }

    fn word(&mut self, words: &[&str]) -> bool {
        let found = matches!(self.peek(), Some(Kind::Name(name, index)) if index.is_empty() && words.contains(&name.as_str()));
        self.position += usize::from(found);
        found
    }

    fn sum(&mut self) -> Result<Expr> {
        let mut left = self.product()?;
        for _ in 0..MAX_CHAIN {
            let offset = self.offset();
            let make = if self.take(&Kind::Operator('+')) {
                Node::Add
            } else if self.take(&Kind::Operator('-')) {
                Node::Sub
            } else {
                return Ok(left);
            };
            let right = self.product()?;
            left = Expr {
                node: make(Box::new(left), Box::new(right)),
                offset,
            };
        }
        Err(self.error("a sum of fewer terms"))
    }

    fn product(&mut self) -> Result<Expr> {
        let mut left = self.signed()?;
        for _ in 0..MAX_CHAIN {
            let offset = self.offset();
            let make = if self.take(&Kind::Operator('*')) {
                Node::Mul
            } else if self.take(&Kind::Operator('/')) {
                Node::Div
            } else if self.starts_factor() {
                let right = self.power()?;
                left = Expr {
                    node: Node::Mul(Box::new(left), Box::new(right)),
                    offset,
                };
                continue;
            } else {
                return Ok(left);
            };
            let right = self.signed()?;
            left = Expr {
                node: make(Box::new(left), Box::new(right)),
                offset,
            };
        }
        Err(self.error("a product of fewer factors"))
    }

    /// Whether a factor follows without a sign between: `c1 c4`, `2 l`, `s1 (a + b)`.
    fn starts_factor(&self) -> bool {
        match self.peek() {
            Some(Kind::Name(name, index)) if index.is_empty() => {
                !["when", "where", "if", "for", "and"].contains(&name.as_str())
            }
            Some(Kind::Name(..) | Kind::Number(_) | Kind::Open(false)) => true,
            _ => false,
        }
    }

    fn signed(&mut self) -> Result<Expr> {
        let offset = self.offset();
        if self.take(&Kind::Operator('-')) {
            let inner = self.nested(Self::signed)?;
            return Ok(Expr {
                node: Node::Neg(Box::new(inner)),
                offset,
            });
        }
        if self.take(&Kind::Operator('+')) {
            return self.nested(Self::signed);
        }
        self.power()
    }

    fn power(&mut self) -> Result<Expr> {
        let offset = self.offset();
        let base = self.atom()?;
        if !self.take(&Kind::Operator('^')) {
            return Ok(base);
        }
        let exponent = self.exponent()?;
        Ok(Expr {
            node: Node::Power(Box::new(base), exponent),
            offset,
        })
    }

    fn exponent(&mut self) -> Result<u32> {
        let bracket = self.take(&Kind::Open(false));
        let exponent = match self.peek() {
            Some(Kind::Number(digits)) => digits
                .parse::<u32>()
                .ok()
                .filter(|value| *value <= MAX_EXPONENT),
            _ => None,
        };
        let Some(exponent) = exponent else {
            return Err(self.error(&format!("a whole exponent of at most {MAX_EXPONENT}")));
        };
        self.position += 1;
        if bracket && !self.take(&Kind::Close) {
            return Err(self.error("a closing bracket"));
        }
        Ok(exponent)
    }

    fn atom(&mut self) -> Result<Expr> {
        let offset = self.offset();
        match self.peek().cloned() {
            Some(Kind::Number(digits)) => {
                let Some(value) = number::parse(digits.trim_end_matches('.')) else {
                    return Err(self.error("a number"));
                };
                self.position += 1;
                Ok(Expr {
                    node: Node::Number(value),
                    offset,
                })
            }
            Some(Kind::Open(false)) => {
                self.position += 1;
                let inner = self.nested(Self::sum)?;
                self.close()?;
                Ok(inner)
            }
            Some(Kind::Open(true)) => self.nested(Self::matrix),
            Some(Kind::Name(base, index)) => {
                self.position += 1;
                self.named(base, index, offset)
            }
            _ => Err(self.error("a number, a name or an opening bracket")),
        }
    }

    fn close(&mut self) -> Result<()> {
        match self.take(&Kind::Close) {
            true => Ok(()),
            false => Err(self.error("an operator or a closing bracket")),
        }
    }

    fn named(&mut self, base: String, index: String, offset: usize) -> Result<Expr> {
        if base == "frac" {
            let above = self.nested(Self::group)?;
            let below = self.nested(Self::group)?;
            return Ok(Expr {
                node: Node::Div(Box::new(above), Box::new(below)),
                offset,
            });
        }
        if let Some(&(_, count)) = FUNCTIONS
            .iter()
            .find(|(name, _)| *name == base && index.is_empty())
        {
            return self.nested(|parser| parser.call(&base, count, offset));
        }
        // A5[1, 2]: an entry of a named matrix.
        if self.peek() == Some(&Kind::Open(true))
            && let Some((row, column)) = self.indices()
        {
            return Ok(Expr {
                node: Node::Entry(base, index, row, column),
                offset,
            });
        }
        Ok(Expr {
            node: Node::Name(base, index),
            offset,
        })
    }

    /// Row and column in brackets, if that is what follows.
    fn indices(&mut self) -> Option<(usize, usize)> {
        let kinds: Vec<&Kind> = self
            .tokens
            .iter()
            .skip(self.position)
            .take(5)
            .map(|token| &token.kind)
            .collect();
        if let [
            Kind::Open(true),
            Kind::Number(row),
            Kind::Comma,
            Kind::Number(column),
            Kind::Close,
        ] = kinds[..]
        {
            let found = (row.parse().ok()?, column.parse().ok()?);
            self.position += 5;
            return Some(found);
        }
        None
    }

    fn group(&mut self) -> Result<Expr> {
        match self.peek() {
            Some(Kind::Open(false)) => self.atom(),
            _ => Err(self.error("a group in braces")),
        }
    }

    /// A function: its arguments in brackets, or one factor right behind it; `sin^2 x` is the square of the sine.
    fn call(&mut self, name: &str, count: usize, offset: usize) -> Result<Expr> {
        let exponent = if self.take(&Kind::Operator('^')) {
            Some(self.exponent()?)
        } else {
            None
        };
        let mut arguments = Vec::new();
        if self.take(&Kind::Open(false)) {
            arguments.push(self.sum()?);
            while self.take(&Kind::Comma) {
                arguments.push(self.sum()?);
            }
            self.close()?;
        } else {
            let argument_offset = self.offset();
            let first = self.atom()?;
            let doubled = matches!(first.node, Node::Number(_))
                && matches!(self.peek(), Some(Kind::Name(..)));
            arguments.push(match doubled {
                true => Expr {
                    node: Node::Mul(Box::new(first), Box::new(self.atom()?)),
                    offset: argument_offset,
                },
                false => first,
            });
        }
        // The cosine of two arguments is a direction cosine, of two unit vectors.
        if arguments.len() != count && !(name == "cos" && arguments.len() == 2) {
            return Err(self.error(&format!("{count} argument(s) of {name}")));
        }
        let call = Expr {
            node: Node::Call(name.to_owned(), arguments),
            offset,
        };
        Ok(match exponent {
            Some(exponent) => Expr {
                node: Node::Power(Box::new(call), exponent),
                offset,
            },
            None => call,
        })
    }

    /// Rows of cells; in plain notation also a list of rows, `[[1, 2], [3, 4]]`.
    fn matrix(&mut self) -> Result<Expr> {
        let offset = self.offset();
        self.position += 1;
        let mut rows = vec![Vec::new()];
        loop {
            if self.peek() == Some(&Kind::Close) {
                break;
            }
            let cell = self.sum()?;
            rows.last_mut()
                .into_iter()
                .for_each(|row| row.push(cell.clone()));
            if self.take(&Kind::Row) {
                rows.push(Vec::new());
            } else if !self.take(&Kind::Comma) {
                break;
            }
        }
        self.close()?;
        if rows.len() == 1
            && rows[0]
                .iter()
                .all(|cell| matches!(cell.node, Node::Matrix(_)))
        {
            let inner = std::mem::take(&mut rows[0]);
            rows = inner
                .into_iter()
                .filter_map(|cell| match cell.node {
                    Node::Matrix(rows) => Some(rows.into_iter().flatten().collect()),
                    _ => None,
                })
                .collect();
        }
        rows.retain(|row| !row.is_empty());
        let width = rows.first().map_or(0, Vec::len);
        if width == 0 || rows.iter().any(|row| row.len() != width) {
            return Err(self.error("a matrix with rows of one length"));
        }
        Ok(Expr {
            node: Node::Matrix(rows),
            offset,
        })
    }
}

/// A name as a person would print it.
pub(crate) fn shown(expr: &Expr) -> String {
    match &expr.node {
        Node::Name(base, index) => joined(base, index),
        _ => expr.text(),
    }
}
