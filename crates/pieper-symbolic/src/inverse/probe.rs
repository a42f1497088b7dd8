//! Numbers to try equations on.

use pieper::Result;

use super::Rule;
use crate::arm::Arm;
use crate::names::{Names, SymbolMeaning, Var};
use crate::poly::Poly;

/// One joint vector with a value for every symbol: an equation that says nothing there says nothing anywhere.
pub(super) struct Probe {
    pub(super) q: Vec<f64>,
    values: Vec<(Var, f64)>,
}

impl Probe {
    pub(super) fn new(arm: &Arm, names: &Names, target: &[[Var; 4]; 3]) -> Result<Self> {
        let q = (0..arm.dof())
            .map(|joint| 0.61 + 0.37 * joint as f64 - 0.9 * (joint % 2) as f64)
            .collect();
        let mut probe = Self {
            q,
            values: Vec::new(),
        };
        // A value for every symbol without one; near 1, and no two alike.
        for (index, (var, name, meaning)) in names.symbols().enumerate() {
            if *meaning == SymbolMeaning::Parameter && arm.parameter(name).is_nan() {
                probe.values.push((var, 0.83 + 0.171 * index as f64));
            }
        }
        let pose = arm.tool_pose()?;
        for (vars, entries) in target.iter().zip(&pose.0) {
            for (var, entry) in vars.iter().zip(entries) {
                let value = probe.value(arm, entry);
                probe.values.push((*var, value));
            }
        }
        Ok(probe)
    }

    fn value(&self, arm: &Arm, poly: &Poly) -> f64 {
        poly.evaluate(&0.0, |var| {
            match self.values.iter().find(|(known, _)| *known == var) {
                Some((_, value)) => *value,
                None => arm.value_at(var, &self.q, &|name| {
                    let value = arm.parameter(name);
                    if value.is_nan() { 0.77 } else { value }
                }),
            }
        })
    }

    pub(super) fn learn(&mut self, arm: &Arm, quantities: &[(Var, Poly)]) {
        for (var, poly) in quantities {
            let value = self.value(arm, poly);
            self.values.push((*var, value));
        }
    }

    /// Whether the rule says something, and something true.
    pub(super) fn tells(&self, arm: &Arm, joint: usize, rule: &Rule) -> bool {
        let value = |poly: &Poly| self.value(arm, poly);
        let q = self.q[joint];
        let near = |a: f64, b: f64| (a - b).abs() < 1e-7 * (1.0 + a.abs());
        match rule {
            Rule::Two { a, b, k, .. } => {
                let (a, b, k) = (value(a), value(b), value(k));
                a.hypot(b) > 1e-7 && near(a * q.cos() + b * q.sin(), k)
            }
            Rule::One { sin, cos } => {
                let (sin, cos) = (value(sin), value(cos));
                sin.hypot(cos) > 1e-7 && near((sin.atan2(cos) - q).cos(), 1.0)
            }
            Rule::Slide { above, below } => {
                value(below).abs() > 1e-7 && near(value(above) / value(below), q)
            }
            Rule::Square { coefficients } => value(&coefficients[2]).abs() > 1e-7,
        }
    }
}
