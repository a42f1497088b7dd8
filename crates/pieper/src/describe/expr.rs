//! Formulas as robot files hold them: `"pi/2 + q1"`, `"164 mm"`, `"-l2*sin(beta)"`.
//!
//! Kept as written, so that symbols stay symbols for derivations; evaluated when numbers are asked for.

mod evaluate;
mod linear;
mod parse;
mod print;
mod typed;

pub use evaluate::Values;
pub use linear::Linear;
pub(super) use linear::with_variable;
pub use typed::typed;

/// A formula over numbers, pi, symbols and the usual functions.
///
/// ```
/// use pieper::describe::expr::{Expr, Values};
/// let expr = Expr::parse("2*l2 + 5 mm")?;
/// let values = Values::from([("l2".to_owned(), 0.3)]);
/// assert_eq!(expr.evaluate(&values)?, 0.605);
/// assert_eq!(expr.to_string(), "2*l2 + 5 mm");
/// # Ok::<(), pieper::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// A number, in the unit written behind it.
    Number(f64, Unit),
    /// The circle's number.
    Pi,
    /// A named length, angle or joint variable.
    Symbol(String),
    /// `-x`
    Neg(Box<Expr>),
    /// An operator between two formulas.
    Binary(Operator, Box<Expr>, Box<Expr>),
    /// A function of one or two arguments.
    Call(Function, Vec<Expr>),
}

/// The unit written behind a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// None: metres, radians or a pure number.
    None,
    /// `m`
    Metre,
    /// `cm`
    Centimetre,
    /// `mm`
    Millimetre,
    /// `rad`
    Radian,
    /// `deg`
    Degree,
}

impl Unit {
    /// The units with their names.
    pub const NAMED: [(&'static str, Self); 5] = [
        ("m", Self::Metre),
        ("cm", Self::Centimetre),
        ("mm", Self::Millimetre),
        ("rad", Self::Radian),
        ("deg", Self::Degree),
    ];
}

/// An operator between two formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `^` or `**`
    Pow,
}

/// A function by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Square root.
    Sqrt,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Inverse tangent of two arguments, y and x.
    Atan2,
    /// Absolute value.
    Abs,
    /// Square root of the sum of two squares.
    Hypot,
}

impl Function {
    /// The functions with their names and numbers of arguments.
    pub const NAMED: [(&'static str, Self, usize); 10] = [
        ("sqrt", Self::Sqrt, 1),
        ("sin", Self::Sin, 1),
        ("cos", Self::Cos, 1),
        ("tan", Self::Tan, 1),
        ("asin", Self::Asin, 1),
        ("acos", Self::Acos, 1),
        ("atan", Self::Atan, 1),
        ("atan2", Self::Atan2, 2),
        ("abs", Self::Abs, 1),
        ("hypot", Self::Hypot, 2),
    ];

    /// The function's name.
    pub fn name(self) -> &'static str {
        Self::NAMED
            .iter()
            .find(|(_, function, _)| *function == self)
            .map_or("", |row| row.0)
    }
}

impl Expr {
    /// A pure number.
    pub fn number(value: f64) -> Self {
        if value.is_sign_negative() && value != 0.0 {
            Self::Neg(Box::new(Self::Number(-value, Unit::None)))
        } else {
            Self::Number(value.abs(), Unit::None)
        }
    }

    /// Whether the formula is the number zero.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Number(value, _) if *value == 0.0)
    }

    /// The symbols in the formula, each once, in order of appearance.
    pub fn symbols(&self) -> Vec<&str> {
        unique_symbols([self])
    }

    fn visit_symbols<'a>(&'a self, visit: &mut impl FnMut(&'a str)) {
        match self {
            Self::Number(..) | Self::Pi => {}
            Self::Symbol(name) => visit(name),
            Self::Neg(inner) => inner.visit_symbols(visit),
            Self::Binary(_, left, right) => {
                left.visit_symbols(visit);
                right.visit_symbols(visit);
            }
            Self::Call(_, arguments) => arguments.iter().for_each(|a| a.visit_symbols(visit)),
        }
    }
}

/// The symbols in the formulas, each once, in order of appearance.
pub(super) fn unique_symbols<'a>(exprs: impl IntoIterator<Item = &'a Expr>) -> Vec<&'a str> {
    let mut found = Vec::new();
    for expr in exprs {
        expr.visit_symbols(&mut |name| {
            if !found.contains(&name) {
                found.push(name);
            }
        });
    }
    found
}
