//! Formula to text, with no more parentheses than it takes to read the same formula back.

use std::fmt;

use super::{Expr, Operator, Unit};

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(value, unit) => {
                write!(f, "{value}")?;
                let name = Unit::NAMED.iter().find(|(_, named)| named == unit);
                name.map_or(Ok(()), |(name, _)| write!(f, " {name}"))
            }
            Self::Pi => f.write_str("pi"),
            Self::Symbol(name) => f.write_str(name),
            Self::Neg(inner) => {
                f.write_str("-")?;
                inside(f, inner, inner.binding() < SIGN)
            }
            Self::Binary(operator, left, right) => {
                let (text, binding) = operator.text();
                let loose_left = left.binding() < binding + i32::from(*operator == Operator::Pow);
                inside(f, left, loose_left)?;
                f.write_str(text)?;
                inside(f, right, right.binding() <= binding)
            }
            Self::Call(function, arguments) => {
                write!(f, "{}(", function.name())?;
                for (index, argument) in arguments.iter().enumerate() {
                    if index > 0 {
                        f.write_str(", ")?;
                    }
                    write!(f, "{argument}")?;
                }
                f.write_str(")")
            }
        }
    }
}

/// How tightly a leading sign binds.
const SIGN: i32 = 3;

impl Operator {
    fn text(self) -> (&'static str, i32) {
        match self {
            Self::Add => (" + ", 1),
            Self::Sub => (" - ", 1),
            Self::Mul => ("*", 2),
            Self::Div => ("/", 2),
            Self::Pow => ("^", 4),
        }
    }
}

impl Expr {
    fn binding(&self) -> i32 {
        match self {
            Self::Neg(_) => SIGN,
            Self::Binary(operator, ..) => operator.text().1,
            // "5 mm^2" would read as (5 mm)^2 does, but looks like something else.
            Self::Number(_, unit) if *unit != Unit::None => SIGN,
            _ => 5,
        }
    }
}

fn inside(f: &mut fmt::Formatter<'_>, expr: &Expr, parentheses: bool) -> fmt::Result {
    if parentheses {
        write!(f, "({expr})")
    } else {
        write!(f, "{expr}")
    }
}
