//! Claims as written: trees that can be changed in one place and printed again.

use crate::number::{self, Rational};

/// A formula as written, with the byte offset it starts at.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Expr {
    pub(crate) node: Node,
    pub(crate) offset: usize,
}

/// A node of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Node {
    Number(Rational),
    /// A name and its index.
    Name(String, String),
    Neg(Box<Expr>),
    Add(Box<Expr>, Box<Expr>),
    Sub(Box<Expr>, Box<Expr>),
    Mul(Box<Expr>, Box<Expr>),
    Div(Box<Expr>, Box<Expr>),
    Power(Box<Expr>, u32),
    /// A function by name.
    Call(String, Vec<Expr>),
    /// A matrix by rows.
    Matrix(Vec<Vec<Expr>>),
    /// An entry of a named matrix, row and column counted from 1.
    Entry(String, String, usize, usize),
}

/// A claim: sides that are said to be equal.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Equation {
    pub(crate) sides: Vec<Expr>,
    /// What holds while they are: a joint and its value.
    pub(crate) conditions: Vec<(Expr, Expr)>,
    pub(crate) offset: usize,
}

impl Expr {
    /// The parts one level down.
    pub(crate) fn children(&self) -> Vec<&Expr> {
        match &self.node {
            Node::Number(_) | Node::Name(..) | Node::Entry(..) => Vec::new(),
            Node::Neg(a) | Node::Power(a, _) => vec![a],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => vec![a, b],
            Node::Call(_, arguments) => arguments.iter().collect(),
            Node::Matrix(rows) => rows.iter().flatten().collect(),
        }
    }

    pub(crate) fn children_mut(&mut self) -> Vec<&mut Expr> {
        match &mut self.node {
            Node::Number(_) | Node::Name(..) | Node::Entry(..) => Vec::new(),
            Node::Neg(a) | Node::Power(a, _) => vec![a],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => vec![a, b],
            Node::Call(_, arguments) => arguments.iter_mut().collect(),
            Node::Matrix(rows) => rows.iter_mut().flatten().collect(),
        }
    }

    /// The part at the end of a path of child numbers.
    pub(crate) fn at(&self, path: &[usize]) -> Option<&Expr> {
        path.iter()
            .try_fold(self, |expr, &child| expr.children().get(child).copied())
    }

    /// The formula with the part at the end of a path replaced.
    pub(crate) fn with(&self, path: &[usize], node: Node) -> Option<Expr> {
        let mut changed = self.clone();
        let mut part = &mut changed;
        for &child in path {
            part = part.children_mut().into_iter().nth(child)?;
        }
        part.node = node;
        Some(changed)
    }

    /// The paths of all parts, outermost first.
    pub(crate) fn paths(&self) -> Vec<Vec<usize>> {
        let mut all = vec![Vec::new()];
        let mut next = 0;
        while let Some(path) = all.get(next).cloned() {
            next += 1;
            let count = self.at(&path).map_or(0, |part| part.children().len());
            all.extend((0..count).map(|child| [&path[..], &[child]].concat()));
        }
        all
    }

    /// The formula in plain notation.
    pub(crate) fn text(&self) -> String {
        let inside = |part: &Expr, at_least: u8| match part.binding() < at_least {
            true => format!("({})", part.text()),
            false => part.text(),
        };
        match &self.node {
            Node::Number(value) => number::text(value),
            Node::Name(base, index) => super::token::joined(base, index),
            Node::Neg(a) => format!("-{}", inside(a, 2)),
            Node::Add(a, b) => format!("{} + {}", a.text(), inside(b, 1)),
            Node::Sub(a, b) => format!("{} - {}", a.text(), inside(b, 1)),
            Node::Mul(a, b) => format!("{}*{}", inside(a, 2), inside(b, 2)),
            Node::Div(a, b) => format!("{}/{}", inside(a, 2), inside(b, 3)),
            Node::Power(a, exponent) => format!("{}^{exponent}", inside(a, 3)),
            Node::Call(name, arguments) => {
                let arguments: Vec<String> = arguments.iter().map(Expr::text).collect();
                format!("{name}({})", arguments.join(", "))
            }
            Node::Matrix(rows) => {
                let row =
                    |row: &Vec<Expr>| row.iter().map(Expr::text).collect::<Vec<_>>().join(", ");
                format!("[{}]", rows.iter().map(row).collect::<Vec<_>>().join("; "))
            }
            Node::Entry(base, index, row, column) => {
                format!("{}[{row}, {column}]", super::token::joined(base, index))
            }
        }
    }

    fn binding(&self) -> u8 {
        match &self.node {
            Node::Add(..) | Node::Sub(..) => 0,
            Node::Neg(_) => 1,
            Node::Mul(..) | Node::Div(..) => 2,
            Node::Number(value) if !value.is_int() || number::is_negative(value) => 1,
            _ => 3,
        }
    }
}
