//! Expressions into syntax trees.

use super::expr::{Access, Binary, Compare, Expr};
use super::token::{Token, tokens};
use super::value::Outcome;

/// Brackets and prefixes nested deeper than this are refused: parsing and evaluation recurse.
const MAX_DEPTH: usize = 40;

pub(super) fn parse(text: &str) -> Outcome<Expr> {
    let mut parser = Parser {
        tokens: tokens(text)?,
        next: 0,
        depth: 0,
    };
    let expr = parser.expression()?;
    match parser.peek() {
        None => Ok(expr),
        Some(Token::Symbol(",")) => {
            let mut items = vec![expr];
            while parser.take(",") && parser.peek().is_some() {
                items.push(parser.expression()?);
            }
            parser.end()?;
            Ok(Expr::List(items))
        }
        Some(_) => Err(parser.unexpected("the end of the expression")),
    }
}

struct Parser {
    tokens: Vec<Token>,
    next: usize,
    depth: usize,
}

/// Operators of each level, loosest first.
const LEVELS: [&[(&str, Binary)]; 2] = [
    &[("+", Binary::Add), ("-", Binary::Subtract)],
    &[
        ("*", Binary::Multiply),
        ("//", Binary::FloorDivide),
        ("/", Binary::Divide),
        ("%", Binary::Modulo),
    ],
];

const COMPARISONS: [(&str, Compare); 6] = [
    ("==", Compare::Equal),
    ("!=", Compare::NotEqual),
    ("<=", Compare::LessEqual),
    ("<", Compare::Less),
    (">=", Compare::GreaterEqual),
    (">", Compare::Greater),
];

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next)
    }

    /// Takes this symbol or word if it comes next.
    fn take(&mut self, text: &str) -> bool {
        let found = match self.peek() {
            Some(Token::Symbol(symbol)) => *symbol == text,
            Some(Token::Name(name)) => name == text,
            _ => false,
        };
        self.next += usize::from(found);
        found
    }

    fn expect(&mut self, text: &str) -> Outcome<()> {
        if self.take(text) {
            Ok(())
        } else {
            Err(self.unexpected(&format!("'{text}'")))
        }
    }

    fn end(&self) -> Outcome<()> {
        match self.peek() {
            None => Ok(()),
            Some(_) => Err(self.unexpected("the end of the expression")),
        }
    }

    fn unexpected(&self, expected: &str) -> String {
        match self.peek() {
            None => format!("{expected} was expected, the expression ends"),
            Some(token) => format!("{expected} was expected, not {token}"),
        }
    }

    fn expression(&mut self) -> Outcome<Expr> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(format!("it is nested more than {MAX_DEPTH} deep"));
        }
        let value = self.either()?;
        let expr = if self.take("if") {
            let condition = self.either()?;
            self.expect("else")?;
            Expr::If {
                then: Box::new(value),
                condition: Box::new(condition),
                otherwise: Box::new(self.expression()?),
            }
        } else {
            value
        };
        self.depth -= 1;
        Ok(expr)
    }

    fn either(&mut self) -> Outcome<Expr> {
        let mut items = vec![self.both()?];
        while self.take("or") {
            items.push(self.both()?);
        }
        Ok(single(items, Expr::Or))
    }

    fn both(&mut self) -> Outcome<Expr> {
        let mut items = vec![self.negation()?];
        while self.take("and") {
            items.push(self.negation()?);
        }
        Ok(single(items, Expr::And))
    }

    fn negation(&mut self) -> Outcome<Expr> {
        let mut count = 0;
        while self.take("not") {
            count += 1;
        }
        let mut expr = self.comparison()?;
        // Two are as good as four: what is left is a truth value all the same.
        for _ in 0..(if count > 2 { 2 - count % 2 } else { count }) {
            expr = Expr::Not(Box::new(expr));
        }
        Ok(expr)
    }

    fn comparison(&mut self) -> Outcome<Expr> {
        let first = self.binary(0)?;
        let mut rest = Vec::new();
        while let Some(compare) = self.comparator()? {
            rest.push((compare, self.binary(0)?));
        }
        Ok(if rest.is_empty() {
            first
        } else {
            Expr::Compare(Box::new(first), rest)
        })
    }

    fn comparator(&mut self) -> Outcome<Option<Compare>> {
        for (text, compare) in COMPARISONS {
            if self.take(text) {
                return Ok(Some(compare));
            }
        }
        if self.take("not") {
            self.expect("in")?;
            return Ok(Some(Compare::NotIn));
        }
        if self.take("is") {
            let not = self.take("not");
            return Ok(Some(if not {
                Compare::NotEqual
            } else {
                Compare::Equal
            }));
        }
        Ok(self.take("in").then_some(Compare::In))
    }

    fn binary(&mut self, level: usize) -> Outcome<Expr> {
        let Some(operators) = LEVELS.get(level) else {
            return self.unary();
        };
        let first = self.binary(level + 1)?;
        let mut rest = Vec::new();
        'next: loop {
            for &(text, binary) in *operators {
                if self.take(text) {
                    rest.push((binary, self.binary(level + 1)?));
                    continue 'next;
                }
            }
            break;
        }
        Ok(if rest.is_empty() {
            first
        } else {
            Expr::Chain(Box::new(first), rest)
        })
    }

    fn unary(&mut self) -> Outcome<Expr> {
        let (mut signs, mut negative) = (0, false);
        loop {
            if self.take("-") {
                negative = !negative;
            } else if !self.take("+") {
                break;
            }
            signs += 1;
        }
        let operand = self.power()?;
        Ok(match (signs, negative) {
            (0, _) => operand,
            (_, true) => Expr::Negative(Box::new(operand)),
            (_, false) => Expr::Positive(Box::new(operand)),
        })
    }

    fn power(&mut self) -> Outcome<Expr> {
        let base = self.access()?;
        if !self.take("**") {
            return Ok(base);
        }
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(format!("it is nested more than {MAX_DEPTH} deep"));
        }
        let exponent = self.unary()?;
        self.depth -= 1;
        Ok(Expr::Chain(Box::new(base), vec![(Binary::Power, exponent)]))
    }

    fn access(&mut self) -> Outcome<Expr> {
        let operand = self.atom()?;
        let mut rest = Vec::new();
        loop {
            if self.take(".") {
                match self.tokens.get(self.next) {
                    Some(Token::Name(name)) => rest.push(Access::Attribute(name.clone())),
                    _ => return Err(self.unexpected("a name")),
                }
                self.next += 1;
            } else if self.take("[") {
                rest.push(self.index()?);
            } else if self.take("(") {
                rest.push(self.call()?);
            } else {
                break;
            }
        }
        Ok(if rest.is_empty() {
            operand
        } else {
            Expr::Access(Box::new(operand), rest)
        })
    }

    fn index(&mut self) -> Outcome<Access> {
        let start = if matches!(self.peek(), Some(Token::Symbol(":"))) {
            None
        } else {
            Some(self.expression()?)
        };
        if self.take(":") {
            let end = if matches!(self.peek(), Some(Token::Symbol("]"))) {
                None
            } else {
                Some(self.expression()?)
            };
            self.expect("]")?;
            return Ok(Access::Slice(start, end));
        }
        self.expect("]")?;
        start
            .map(Access::Index)
            .ok_or_else(|| "an index was expected".to_owned())
    }

    fn call(&mut self) -> Outcome<Access> {
        let (mut plain, mut named) = (Vec::new(), Vec::new());
        while !self.take(")") {
            if let (Some(Token::Name(name)), Some(Token::Symbol("="))) =
                (self.peek(), self.tokens.get(self.next + 1))
            {
                let name = name.clone();
                self.next += 2;
                named.push((name, self.expression()?));
            } else {
                plain.push(self.expression()?);
            }
            if !self.take(",") && !matches!(self.peek(), Some(Token::Symbol(")"))) {
                return Err(self.unexpected("',' or ')'"));
            }
        }
        Ok(Access::Call(plain, named))
    }

    fn atom(&mut self) -> Outcome<Expr> {
        let expr = match self.peek() {
            Some(Token::Int(value)) => Expr::Int(*value),
            Some(Token::Float(value)) => Expr::Float(*value),
            Some(Token::Str(text)) => {
                let mut text = text.clone();
                // Neighbouring texts are one.
                while let Some(Token::Str(more)) = self.tokens.get(self.next + 1) {
                    text.push_str(more);
                    self.next += 1;
                }
                Expr::Str(text)
            }
            Some(Token::Name(name)) if !is_word(name) => Expr::Name(name.clone()),
            Some(Token::Symbol("(")) => return self.bracket(),
            Some(Token::Symbol("[")) => {
                self.next += 1;
                return Ok(Expr::List(self.items("]")?.0));
            }
            Some(Token::Symbol("{")) => {
                self.next += 1;
                return self.dict();
            }
            _ => return Err(self.unexpected("a value")),
        };
        self.next += 1;
        Ok(expr)
    }

    /// `(a)` is `a`; `()`, `(a,)` and `(a, b)` are lists to us.
    fn bracket(&mut self) -> Outcome<Expr> {
        self.next += 1;
        let (mut items, comma) = self.items(")")?;
        match (items.pop(), items.is_empty(), comma) {
            (Some(only), true, false) => Ok(only),
            (last, _, _) => {
                items.extend(last);
                Ok(Expr::List(items))
            }
        }
    }

    /// Expressions up to the closing bracket, and whether a comma stood among them.
    fn items(&mut self, close: &str) -> Outcome<(Vec<Expr>, bool)> {
        let (mut items, mut comma) = (Vec::new(), false);
        while !self.take(close) {
            items.push(self.expression()?);
            if self.take(",") {
                comma = true;
            } else if !matches!(self.peek(), Some(Token::Symbol(s)) if *s == close) {
                return Err(self.unexpected(&format!("',' or '{close}'")));
            }
        }
        Ok((items, comma))
    }

    fn dict(&mut self) -> Outcome<Expr> {
        let mut entries = Vec::new();
        while !self.take("}") {
            let key = self.expression()?;
            self.expect(":")?;
            entries.push((key, self.expression()?));
            if !self.take(",") && !matches!(self.peek(), Some(Token::Symbol("}"))) {
                return Err(self.unexpected("',' or '}'"));
            }
        }
        Ok(Expr::Dict(entries))
    }
}

fn single(mut items: Vec<Expr>, many: fn(Vec<Expr>) -> Expr) -> Expr {
    match (items.pop(), items.is_empty()) {
        (Some(only), true) => only,
        (last, _) => {
            items.extend(last);
            many(items)
        }
    }
}

/// Words that are no names.
pub(super) fn is_word(name: &str) -> bool {
    const WORDS: [&str; 9] = [
        "if", "else", "and", "or", "not", "in", "is", "for", "lambda",
    ];
    WORDS.contains(&name)
}
