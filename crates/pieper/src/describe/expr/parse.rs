//! Text to formula, by recursive descent.

use super::{Expr, Function, Operator, Unit};
use crate::error::{Error, Place, Result};

/// Formulas nest at most this deep: more is a mistake, and would exhaust the stack.
const MAX_DEPTH: usize = 100;

/// Formulas are at most this long, in bytes.
const MAX_LENGTH: usize = 10_000;

impl Expr {
    /// Reads a formula.
    ///
    /// # Errors
    /// A parse error with the column, the offending text and what was expected.
    pub fn parse(text: &str) -> Result<Self> {
        if text.len() > MAX_LENGTH {
            let shown: String = text.chars().take(40).collect();
            return Err(Error::parse(
                Place::default(),
                format!("{shown:?}..."),
                format!("a formula of at most {MAX_LENGTH} bytes was expected"),
            ));
        }
        let mut parser = Parser {
            text,
            position: 0,
            depth: 0,
        };
        let expr = parser.sum()?;
        parser.skip_space();
        if parser.position < text.len() {
            return Err(parser.error("an operator or the end of the formula"));
        }
        Ok(expr)
    }
}

struct Parser<'a> {
    text: &'a str,
    position: usize,
    depth: usize,
}

impl Parser<'_> {
    fn rest(&self) -> &str {
        &self.text[self.position..]
    }

    fn skip_space(&mut self) {
        self.position = self.text.len() - self.rest().trim_start().len();
    }

    fn take(&mut self, token: &str) -> bool {
        self.skip_space();
        let found = self.rest().starts_with(token);
        if found {
            self.position += token.len();
        }
        found
    }

    fn error(&mut self, expected: &str) -> Error {
        self.skip_space();
        let column = self.text[..self.position].chars().count() + 1;
        let at = match self.rest().chars().next() {
            None => "at its end".to_owned(),
            Some(character) => format!("at {character:?} (character {column})"),
        };
        let message = format!("{expected} was expected {at}");
        Error::parse(Place::default(), format!("{:?}", self.text), message)
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

    fn sum(&mut self) -> Result<Expr> {
        self.left_associative(&[("+", Operator::Add), ("-", Operator::Sub)], Self::product)
    }

    fn product(&mut self) -> Result<Expr> {
        self.left_associative(&[("*", Operator::Mul), ("/", Operator::Div)], Self::signed)
    }

    fn left_associative(
        &mut self,
        operators: &[(&str, Operator)],
        operand: fn(&mut Self) -> Result<Expr>,
    ) -> Result<Expr> {
        let mut left = operand(self)?;
        let mut length = 0;
        while let Some(&(_, operator)) = operators.iter().find(|(token, _)| self.take(token)) {
            length += 1;
            if length > MAX_DEPTH {
                return Err(self.error("a formula with fewer terms"));
            }
            let right = operand(self)?;
            left = Expr::Binary(operator, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<Expr> {
        if self.take("-") {
            return Ok(Expr::Neg(Box::new(self.nested(Self::signed)?)));
        }
        if self.take("+") {
            return self.nested(Self::signed);
        }
        self.power()
    }

    fn power(&mut self) -> Result<Expr> {
        let base = self.atom()?;
        if self.take("**") || self.take("^") {
            let exponent = self.nested(Self::signed)?;
            return Ok(Expr::Binary(
                Operator::Pow,
                Box::new(base),
                Box::new(exponent),
            ));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<Expr> {
        if self.take("(") {
            let inner = self.nested(Self::sum)?;
            if !self.take(")") {
                return Err(self.error("')'"));
            }
            return Ok(inner);
        }
        self.skip_space();
        match self.rest().chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => {
                let name = self.name();
                self.named(name)
            }
            _ => Err(self.error("a number, a symbol or '('")),
        }
    }

    fn number(&mut self) -> Result<Expr> {
        let rest = self.rest();
        let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
        let mut length = digits(rest);
        if rest[length..].starts_with('.') {
            length += 1 + digits(&rest[length + 1..]);
        }
        let exponent = rest[length..].strip_prefix(['e', 'E']).map(|exponent| {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            (sign, digits(&exponent[sign..]))
        });
        if let Some((sign, count)) = exponent.filter(|(_, count)| *count > 0) {
            length += 1 + sign + count;
        }
        let value = rest[..length]
            .parse::<f64>()
            .ok()
            .filter(|value| value.is_finite());
        let Some(value) = value else {
            return Err(self.error("a finite number"));
        };
        self.position += length;
        Ok(Expr::Number(value, self.unit()))
    }

    /// The unit behind a number, if a unit's name and nothing longer stands there.
    fn unit(&mut self) -> Unit {
        let start = self.position;
        self.skip_space();
        let name = self.name();
        if let Some(&(_, unit)) = Unit::NAMED.iter().find(|(unit, _)| *unit == name) {
            return unit;
        }
        self.position = start;
        Unit::None
    }

    fn name(&mut self) -> String {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let rest = self.rest();
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let name = rest[..end].to_owned();
        self.position += end;
        name
    }

    fn named(&mut self, name: String) -> Result<Expr> {
        if name == "pi" || name == "π" {
            return Ok(Expr::Pi);
        }
        let Some(&(_, function, arity)) = Function::NAMED.iter().find(|row| row.0 == name) else {
            return Ok(Expr::Symbol(name));
        };
        if !self.take("(") {
            return Err(self.error(&format!("'(' behind the function {name}")));
        }
        let mut arguments = vec![self.nested(Self::sum)?];
        while self.take(",") {
            arguments.push(self.nested(Self::sum)?);
        }
        if arguments.len() != arity {
            return Err(self.error(&format!("{arity} argument(s) of {name}")));
        }
        if !self.take(")") {
            return Err(self.error("')'"));
        }
        Ok(Expr::Call(function, arguments))
    }
}
