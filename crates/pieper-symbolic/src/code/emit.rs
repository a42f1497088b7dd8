//! Statements and expressions in one of the languages.

use super::graph::{Graph, Id, Node};
use super::{Language, Precision};
use crate::arm::Arm;
use crate::names::{Angle, AngleMeaning, Names, SymbolMeaning, Var, VarKind};
use crate::number;
use crate::poly::Poly;
use crate::print;

/// Writes lines.
pub(super) struct Emit<'a> {
    pub(super) arm: &'a Arm,
    pub(super) names: &'a Names,
    pub(super) language: Language,
    pub(super) precision: Precision,
    pub(super) out: String,
    pub(super) indent: usize,
}

impl Emit<'_> {
    pub(super) fn line(&mut self, text: &str) {
        if !text.is_empty() {
            self.out.push_str(&"    ".repeat(self.indent));
            self.out.push_str(text);
        }
        self.out.push('\n');
    }

    pub(super) fn comment(&mut self, text: &str) {
        let mark = self.language.comment();
        self.line(&format!("{mark} {text}"));
    }

    /// A constant quantity.
    pub(super) fn declare(&mut self, name: &str, value: &str) {
        let number = self.language.number_type(self.precision);
        let text = match self.language {
            Language::C | Language::Cpp => format!("const {number} {name} = {value};"),
            Language::Rust => format!("let {name} = {value};"),
            Language::Python => format!("{name} = {value}"),
            Language::Matlab => format!("{name} = {value};"),
        };
        self.line(&text);
    }

    pub(super) fn assign(&mut self, target: &str, value: &str) {
        let stop = self.language.stop();
        self.line(&format!("{target} = {value}{stop}"));
    }

    pub(super) fn open_loop(&mut self, index: &str, count: &str) {
        let text = match self.language {
            Language::C | Language::Cpp => {
                format!("for (int {index} = 0; {index} < {count}; ++{index}) {{")
            }
            Language::Rust => format!("for {index} in 0..{count} {{"),
            Language::Python => format!("for {index} in range({count}):"),
            Language::Matlab => format!("for {index} = 1:{count}"),
        };
        self.line(&text);
        self.indent += 1;
    }

    pub(super) fn close(&mut self) {
        self.indent -= 1;
        match self.language {
            Language::Python => {}
            Language::Matlab => self.line("end"),
            _ => self.line("}"),
        }
    }

    pub(super) fn function(&self, name: &str) -> String {
        self.language.function(name, self.precision)
    }

    /// The name of a quantity.
    pub(super) fn var(&self, var: Var) -> String {
        match var.kind() {
            VarKind::Sin(angle) | VarKind::Cos(angle) => {
                let is_sin = matches!(var.kind(), VarKind::Sin(_));
                match (
                    print::index_of(self.names, angle),
                    self.names.meaning(angle),
                ) {
                    (Some(index), _) => format!("{}{index}", if is_sin { "s" } else { "c" }),
                    (None, AngleMeaning::Parameter(name)) => {
                        format!(
                            "{}_{}",
                            if is_sin { "sin" } else { "cos" },
                            self.language.name(name)
                        )
                    }
                    (None, _) => self.language.number(self.constant(var), self.precision),
                }
            }
            VarKind::Root(_) => self.language.number(self.constant(var), self.precision),
            VarKind::Symbol(_) => self.language.name(self.names.name(var)),
        }
    }

    fn constant(&self, var: Var) -> f64 {
        self.arm
            .value_at(var, &[], &|name| self.arm.parameter(name))
    }

    /// What the sine and cosine of an angle are taken of, unless they are constants.
    pub(super) fn argument(&self, angle: Angle) -> Option<String> {
        Some(match self.names.meaning(angle) {
            AngleMeaning::Joint(joint) => self.language.at("q", *joint),
            AngleMeaning::Sum(sum) => sum
                .iter()
                .enumerate()
                .map(|(place, (joint, sign))| {
                    let q = self.language.at("q", *joint);
                    match (place, sign) {
                        (0, _) => q,
                        (_, -1) => format!(" - {q}"),
                        _ => format!(" + {q}"),
                    }
                })
                .collect(),
            AngleMeaning::Parameter(name) => {
                let value = self.arm.parameter(name);
                match value.is_nan() {
                    true => self.language.name(name),
                    false => self.language.number(value, self.precision),
                }
            }
            AngleMeaning::Constant(..) => return None,
        })
    }

    /// How a quantity is computed, if it is to be declared: sines and cosines, and lengths with a value.
    pub(super) fn definition(&self, var: Var) -> Option<String> {
        match var.kind() {
            VarKind::Sin(angle) | VarKind::Cos(angle) => {
                let function = self.function(if matches!(var.kind(), VarKind::Sin(_)) {
                    "sin"
                } else {
                    "cos"
                });
                let argument = self.argument(angle)?;
                Some(format!("{function}({argument})"))
            }
            VarKind::Root(_) => None,
            VarKind::Symbol(_) => match self.names.symbol_meaning(var)? {
                SymbolMeaning::Joint(joint) => Some(self.language.at("q", *joint)),
                SymbolMeaning::Parameter | SymbolMeaning::Formula(_) => {
                    let value = self.arm.parameter(self.names.name(var));
                    (!value.is_nan()).then(|| self.language.number(value, self.precision))
                }
                SymbolMeaning::Auxiliary => None,
            },
        }
    }

    /// Declares the quantities a graph's outputs need, those declared already left out.
    pub(super) fn declare_vars(
        &mut self,
        vars: impl IntoIterator<Item = Var>,
        declared: &mut Vec<Var>,
    ) {
        for var in vars {
            if declared.contains(&var) {
                continue;
            }
            declared.push(var);
            if let Some(value) = self.definition(var) {
                let name = self.var(var);
                self.declare(&name, &value);
            }
        }
    }

    /// Computes a graph's outputs: what is used twice gets a name, the rest stands where it is used.
    pub(super) fn graph(&mut self, graph: &Graph, outputs: &[Id], prefix: &str) -> Vec<String> {
        let uses = graph.uses(outputs);
        let mut texts: Vec<(String, u8)> = Vec::with_capacity(graph.nodes.len());
        let mut count = 0;
        for (id, node) in graph.nodes.iter().enumerate() {
            if uses[id] == 0 {
                texts.push((String::new(), 3));
                continue;
            }
            let inside = |part: Id, at_least: u8| {
                let (text, binding) = &texts[part];
                if *binding < at_least {
                    format!("({text})")
                } else {
                    text.clone()
                }
            };
            let (text, binding) = match node {
                Node::Number(value) => (
                    self.language.number(number::to_f64(value), self.precision),
                    3,
                ),
                Node::Var(var) => (self.var(*var), 3),
                Node::Neg(a) => (format!("-{}", inside(*a, 2)), 1),
                Node::Add(a, b) => (format!("{} + {}", inside(*a, 0), inside(*b, 1)), 0),
                Node::Sub(a, b) => (format!("{} - {}", inside(*a, 0), inside(*b, 2)), 0),
                Node::Mul(a, b) => (format!("{} * {}", inside(*a, 2), inside(*b, 3)), 2),
            };
            let is_operation = matches!(node, Node::Add(..) | Node::Sub(..) | Node::Mul(..));
            if is_operation && uses[id] > 1 {
                count += 1;
                let name = format!("{prefix}{count}");
                self.declare(&name, &text);
                texts.push((name, 3));
            } else {
                texts.push((text, binding));
            }
        }
        outputs
            .iter()
            .map(|&output| texts[output].0.clone())
            .collect()
    }

    /// A polynomial as one expression.
    pub(super) fn poly(&mut self, poly: &Poly) -> String {
        let mut graph = Graph::default();
        let id = graph.poly(self.names, poly);
        let prefix = format!("t{}_", self.out.len());
        self.graph(&graph, &[id], &prefix).swap_remove(0)
    }
}

/// The quantities a graph's outputs need.
pub(super) fn vars_of(graph: &Graph, outputs: &[Id]) -> Vec<Var> {
    let uses = graph.uses(outputs);
    let needed = graph.nodes.iter().zip(uses).filter(|(_, uses)| *uses > 0);
    let mut vars: Vec<Var> = needed
        .filter_map(|(node, _)| match node {
            Node::Var(var) => Some(*var),
            _ => None,
        })
        .collect();
    vars.sort_unstable();
    vars
}
