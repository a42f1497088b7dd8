//! Computations as a graph in which equal parts are one node.

use std::collections::HashMap;

use crate::form::Form;
use crate::names::Var;
use crate::number::{self, Rational};
use crate::poly::Poly;
use crate::{form, names::Names};

/// A node of a graph.
pub(crate) type Id = usize;

/// What a node computes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    Number(Rational),
    Var(Var),
    Neg(Id),
    Add(Id, Id),
    Sub(Id, Id),
    Mul(Id, Id),
}

/// Nodes, each after those it is made of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    pub(crate) nodes: Vec<Node>,
    known: HashMap<Node, Id>,
}

/// How many multiplications and additions a computation takes, sines and cosines apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operations {
    /// Multiplications.
    pub multiplications: usize,
    /// Additions and subtractions.
    pub additions: usize,
}

impl Operations {
    /// All of them.
    pub fn total(self) -> usize {
        self.multiplications + self.additions
    }
}

impl Graph {
    fn node(&mut self, node: Node) -> Id {
        if let Some(&id) = self.known.get(&node) {
            return id;
        }
        self.nodes.push(node.clone());
        self.known.insert(node, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    pub(crate) fn number(&mut self, value: Rational) -> Id {
        if number::is_negative(&value) {
            let positive = self.node(Node::Number(-value));
            return self.node(Node::Neg(positive));
        }
        self.node(Node::Number(value))
    }

    pub(crate) fn zero(&mut self) -> Id {
        self.number(Rational::ZERO)
    }

    pub(crate) fn var(&mut self, var: Var) -> Id {
        self.node(Node::Var(var))
    }

    fn value(&self, id: Id) -> Option<&Rational> {
        match &self.nodes[id] {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.value(id).is_some_and(|value| *value == Rational::ZERO)
    }

    fn is_one(&self, id: Id) -> bool {
        self.value(id).is_some_and(|value| *value == Rational::ONE)
    }

    /// A node without its sign.
    fn signed(&self, id: Id) -> (bool, Id) {
        match self.nodes[id] {
            Node::Neg(inner) => (true, inner),
            _ => (false, id),
        }
    }

    pub(crate) fn neg(&mut self, a: Id) -> Id {
        if self.is_zero(a) {
            return a;
        }
        match self.nodes[a] {
            Node::Neg(inner) => inner,
            Node::Sub(x, y) => self.node(Node::Sub(y, x)),
            _ => self.node(Node::Neg(a)),
        }
    }

    pub(crate) fn add(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        match (self.signed(a), self.signed(b)) {
            ((false, a), (false, b)) => self.node(Node::Add(a.min(b), a.max(b))),
            ((false, a), (true, b)) => self.node(Node::Sub(a, b)),
            ((true, a), (false, b)) => self.node(Node::Sub(b, a)),
            ((true, a), (true, b)) => {
                let sum = self.node(Node::Add(a.min(b), a.max(b)));
                self.node(Node::Neg(sum))
            }
        }
    }

    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        let b = self.neg(b);
        self.add(a, b)
    }

    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        let ((a_negative, a), (b_negative, b)) = (self.signed(a), self.signed(b));
        let product = if self.is_zero(a) || self.is_one(b) {
            a
        } else if self.is_zero(b) || self.is_one(a) {
            b
        } else {
            self.node(Node::Mul(a.min(b), a.max(b)))
        };
        if a_negative == b_negative {
            product
        } else {
            self.neg(product)
        }
    }

    /// A pair turned: `cos x - sin y` and `sin x + cos y`.
    pub(crate) fn turned(&mut self, (sin, cos): (Id, Id), (x, y): (Id, Id)) -> (Id, Id) {
        let (cx, sy, sx, cy) = (
            self.mul(cos, x),
            self.mul(sin, y),
            self.mul(sin, x),
            self.mul(cos, y),
        );
        (self.sub(cx, sy), self.add(sx, cy))
    }

    /// A polynomial, grouped as a person would.
    pub(crate) fn poly(&mut self, names: &Names, poly: &Poly) -> Id {
        self.form(&form::of(names, poly))
    }

    fn form(&mut self, form: &Form) -> Id {
        match form {
            Form::Number(value) => self.number(value.clone()),
            Form::Var(var) => self.var(*var),
            Form::Neg(inner) => {
                let inner = self.form(inner);
                self.neg(inner)
            }
            Form::Sum(terms) => {
                let zero = self.zero();
                terms.iter().fold(zero, |sum, term| {
                    let term = self.form(term);
                    self.add(sum, term)
                })
            }
            Form::Product(factors) => {
                let one = self.number(number::whole(1));
                factors.iter().fold(one, |product, factor| {
                    let factor = self.form(factor);
                    self.mul(product, factor)
                })
            }
            Form::Power(base, exponent) => {
                let base = self.form(base);
                let one = self.number(number::whole(1));
                (0..*exponent).fold(one, |product, _| self.mul(product, base))
            }
            // Polynomials hold nothing else.
            _ => self.zero(),
        }
    }

    /// What it takes to compute the outputs.
    pub(crate) fn operations(&self, outputs: &[Id]) -> Operations {
        let uses = self.uses(outputs);
        let mut found = Operations {
            multiplications: 0,
            additions: 0,
        };
        for (node, _) in self.nodes.iter().zip(uses).filter(|(_, uses)| *uses > 0) {
            match node {
                Node::Mul(..) => found.multiplications += 1,
                Node::Add(..) | Node::Sub(..) => found.additions += 1,
                _ => {}
            }
        }
        found
    }

    /// The nodes a node is made of.
    pub(crate) fn parts(&self, id: Id) -> Vec<Id> {
        match self.nodes[id] {
            Node::Number(_) | Node::Var(_) => Vec::new(),
            Node::Neg(a) => vec![a],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) => vec![a, b],
        }
    }

    /// How often each node is needed for the outputs; 0 for those that are not.
    pub(crate) fn uses(&self, outputs: &[Id]) -> Vec<usize> {
        let mut uses = vec![0; self.nodes.len()];
        outputs.iter().for_each(|&output| uses[output] += 1);
        for id in (0..self.nodes.len()).rev() {
            if uses[id] > 0 {
                self.parts(id).into_iter().for_each(|part| uses[part] += 1);
            }
        }
        uses
    }
}
