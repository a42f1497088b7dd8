//! Syntax trees of expressions: the part of Python's grammar that descriptions use.
//!
//! Operators of one precedence make one flat node, so that the depth of a tree is that of its brackets.

#[derive(Debug)]
pub(super) enum Expr {
    Int(i64),
    Float(f64),
    Str(String),
    Name(String),
    List(Vec<Expr>),
    Dict(Vec<(Expr, Expr)>),
    /// An operand and what is done to it from left to right.
    Chain(Box<Expr>, Vec<(Binary, Expr)>),
    /// `a < b <= c`.
    Compare(Box<Expr>, Vec<(Compare, Expr)>),
    And(Vec<Expr>),
    Or(Vec<Expr>),
    Not(Box<Expr>),
    Negative(Box<Expr>),
    Positive(Box<Expr>),
    /// `then if condition else otherwise`.
    If {
        then: Box<Expr>,
        condition: Box<Expr>,
        otherwise: Box<Expr>,
    },
    Access(Box<Expr>, Vec<Access>),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    FloorDivide,
    Modulo,
    Power,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Compare {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    In,
    NotIn,
}

/// What follows an operand directly.
#[derive(Debug)]
pub(super) enum Access {
    Attribute(String),
    Index(Expr),
    Slice(Option<Expr>, Option<Expr>),
    Call(Vec<Expr>, Vec<(String, Expr)>),
}
