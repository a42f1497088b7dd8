//! The closed-form inverse: a loop for each branch, every solution put back into the forward kinematics.

use super::graph::{Graph, Id};
use super::program::Program;
use super::{Language, Precision};
use crate::form;
use crate::inverse::{Inverse, Rule, Step};
use crate::names::Var;
use crate::poly::Poly;
use crate::print;

impl Program<'_> {
    pub(super) fn inverse(&mut self, inverse: &Inverse) {
        let (count, number, open) = (self.emit.arm.dof(), self.number(), self.open_declared());
        let most = inverse.most();
        let name = self.name("inverse");
        let language = self.emit.language;
        self.emit.comment(&format!("Every set of joint values that puts the tool at T, {most} at most; how many there are is returned."));
        self.emit.comment("A joint that a singular pose leaves free gets the value `free`; each solution was put back into fk.");
        let text = match language {
            Language::C => format!(
                "int {name}({number} T[3][4], {number} free, {number} found[{most}][{count}]{open}) {{"
            ),
            Language::Cpp => {
                format!(
                    "inline int {name}(const {number} (&T)[3][4], {number} free, {number} (&found)[{most}][{count}]{open}) {{"
                )
            }
            Language::Rust => {
                format!(
                    "pub fn {name}(T: &[[{number}; 4]; 3], free: {number}, found: &mut [[{number}; {count}]; {most}]{open}) -> usize {{"
                )
            }
            Language::Python => format!("def {name}(T, free=0.0{open}):"),
            Language::Matlab => format!("function found = {name}(T, free{open})"),
        };
        self.emit.line(&text);
        self.emit.indent += 1;
        match language {
            Language::C | Language::Cpp => {
                self.emit.line("int count = 0;");
                self.emit.line(&format!("{number} q[{count}];"));
            }
            Language::Rust => {
                self.emit.line("let mut count = 0;");
                self.emit.line(&format!("let mut q = [0.0; {count}];"));
            }
            Language::Python => {
                self.emit.line("found = []");
                self.emit.line(&format!("q = [0.0] * {count}"));
            }
            Language::Matlab => {
                self.emit.line(&format!("found = zeros(0, {count});"));
                self.emit.line(&format!("q = zeros(1, {count});"));
            }
        }
        let mut declared = Vec::new();
        let targets: Vec<Var> = inverse.target.iter().flatten().copied().collect();
        let mut needed: Vec<Var> = Vec::new();
        for step in &inverse.steps {
            needed.extend(polys(step).iter().flat_map(|poly| poly.vars()));
        }
        for (index, var) in targets.iter().enumerate() {
            if needed.contains(var) {
                let name = self.emit.var(*var);
                self.emit
                    .declare(&name, &language.entry("T", index / 4, index % 4));
            }
            declared.push(*var);
        }
        let mut depth = 0;
        for step in &inverse.steps {
            let mut vars: Vec<Var> = polys(step).iter().flat_map(|poly| poly.vars()).collect();
            vars.sort_unstable();
            vars.dedup();
            self.emit.declare_vars(vars, &mut declared);
            match step {
                Step::Define { quantities, .. } => {
                    let mut graph = Graph::default();
                    let outputs: Vec<Id> = quantities
                        .iter()
                        .map(|(_, poly)| graph.poly(self.emit.names, poly))
                        .collect();
                    let prefix = format!("d{}_", self.emit.out.len());
                    let texts = self.emit.graph(&graph, &outputs, &prefix);
                    for ((var, _), text) in quantities.iter().zip(texts) {
                        let name = self.emit.var(*var);
                        self.emit.declare(&name, &text);
                        declared.push(*var);
                    }
                }
                Step::Joint { joint, rule, .. } => depth += usize::from(self.joint(*joint, rule)),
            }
        }
        self.verify();
        (0..depth).for_each(|_| self.emit.close());
        match language {
            Language::Rust => self.emit.line("count"),
            Language::C | Language::Cpp => self.emit.line("return count;"),
            Language::Python => self.emit.line("return found"),
            Language::Matlab => {}
        }
        self.emit.close();
        self.emit.line("");
    }

    /// One joint; whether a loop was opened for its branches.
    fn joint(&mut self, joint: usize, rule: &Rule) -> bool {
        let language = self.emit.language;
        let (q, index) = (language.at("q", joint), joint + 1);
        let values = |program: &mut Self, polys: &[&Poly]| -> Vec<String> {
            polys.iter().map(|poly| program.emit.poly(poly)).collect()
        };
        match rule {
            Rule::One { sin, cos } => {
                let arguments = values(self, &[sin, cos]);
                let call = format!(
                    "{}({}, {}, free)",
                    self.name("one"),
                    arguments[0],
                    arguments[1]
                );
                self.emit.comment(&format!("q{index}"));
                self.emit.assign(&q, &call);
                false
            }
            Rule::Slide { above, below } => {
                let parts = values(self, &[above, below]);
                self.emit.comment(&format!("q{index}"));
                self.emit
                    .assign(&q, &format!("({}) / ({})", parts[0], parts[1]));
                false
            }
            Rule::Two {
                a,
                b,
                k,
                sine_square,
            } => {
                let shown =
                    |poly: &Poly| print::text(&form::of(self.emit.names, poly), self.emit.names);
                let text = format!(
                    "q{index}: ({})*c{index} + ({})*s{index} = {}",
                    shown(a),
                    shown(b),
                    shown(k)
                );
                self.emit.comment(&text);
                let mut arguments = values(self, &[a, b, k]);
                let has_square = sine_square.as_ref().map(|square| self.emit.poly(square));
                arguments.push(has_square.unwrap_or_else(|| "-1.0".to_owned()));
                self.branches(joint, "two", &arguments);
                true
            }
            Rule::Square {
                coefficients: [c, b, a],
            } => {
                let arguments = values(self, &[c, b, a]);
                self.emit
                    .comment(&format!("q{index}: a quadratic equation"));
                self.branches(joint, "square", &arguments);
                true
            }
        }
    }

    fn branches(&mut self, joint: usize, helper: &str, arguments: &[String]) {
        let (language, number) = (self.emit.language, self.number());
        let (index, q, name) = (joint + 1, language.at("q", joint), self.name(helper));
        let arguments = arguments.join(", ");
        let extra = if helper == "two" { ", free" } else { "" };
        let (roots, branch, many) = (
            format!("roots{index}"),
            format!("branch{index}"),
            format!("many{index}"),
        );
        match language {
            Language::C | Language::Cpp => {
                self.emit.line(&format!("{number} {roots}[2];"));
                self.emit.line(&format!(
                    "const int {many} = {name}({arguments}{extra}, {roots});"
                ));
            }
            Language::Rust => self.emit.line(&format!(
                "let ({many}, {roots}) = {name}({arguments}{extra});"
            )),
            Language::Python => {
                self.emit
                    .line(&format!("for {q} in {name}({arguments}{extra}):"));
                self.emit.indent += 1;
                return;
            }
            Language::Matlab => {
                self.emit
                    .line(&format!("{roots} = {name}({arguments}{extra});"));
                self.emit.open_loop(&branch, &format!("numel({roots})"));
                self.emit.line(&format!("{q} = {roots}({branch});"));
                return;
            }
        }
        self.emit.open_loop(&branch, &many);
        self.emit.assign(&q, &format!("{roots}[{branch}]"));
    }

    /// Puts the joint values into fk and keeps them if the pose comes out.
    fn verify(&mut self) {
        let (number, passed, fk) = (self.number(), self.open_passed(), self.name("fk"));
        let tolerance = match self.emit.precision {
            Precision::Double => "1e-9",
            Precision::Float => "2e-4",
        };
        let count = self.emit.arm.dof();
        let fabs = self.emit.function("fabs");
        let lines = match self.emit.language {
            Language::C | Language::Cpp => format!(
                "{number} back[3][4], off = 0;\n{fk}(q, back{passed});\nfor (int i = 0; i < 3; ++i)\n    for (int j = 0; j < 4; ++j) {{\n        const {number} one = {fabs}(back[i][j] - T[i][j]);\n        off = one > off ? one : off;\n    }}\nif (off < {tolerance}) {{\n    for (int i = 0; i < {count}; ++i) found[count][i] = q[i];\n    ++count;\n}}"
            ),
            Language::Rust => format!(
                "let back = {fk}(&q{passed});\nlet mut off: {number} = 0.0;\nfor i in 0..3 {{\n    for j in 0..4 {{\n        off = off.max({fabs}(back[i][j] - T[i][j]));\n    }}\n}}\nif off < {tolerance} {{\n    found[count] = q;\n    count += 1;\n}}"
            ),
            Language::Python => format!(
                "back = {fk}(q{passed})\nif max(abs(back[i][j] - T[i][j]) for i in range(3) for j in range(4)) < {tolerance}:\n    found.append(q[:])"
            ),
            Language::Matlab => format!(
                "back = {fk}(q{passed});\nif max(max(abs(back - T(1:3, :)))) < {tolerance}\n    found(end + 1, :) = q;\nend"
            ),
        };
        lines.lines().for_each(|line| self.emit.line(line));
    }
}

fn polys(step: &Step) -> Vec<&Poly> {
    match step {
        Step::Define { quantities, .. } => quantities.iter().map(|(_, poly)| poly).collect(),
        Step::Joint { rule, .. } => rule.polys(),
    }
}
