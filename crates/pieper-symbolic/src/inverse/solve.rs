//! A closed-form inverse in numbers.

use pieper::spatial::Pose;

use super::{Inverse, Rule, Step};
use crate::names::{SymbolMeaning, Var, VarKind};
use crate::number;
use crate::poly::Poly;

/// How far a root's square may fall below zero and still be rounding of zero, relative to its terms.
pub(crate) const ROOT_SLACK: f64 = 1e-12;

/// Below this, sine and cosine are both rounding of zero, and the angle is free; relative to the arm's lengths.
pub(crate) const FREE: f64 = 1e-12;

/// Every set of joint values that the formulas give for a pose of the tool, unverified: radians and metres.
///
/// Symbols have the values of the arm's table. A joint that the pose leaves free gets `free`.
pub fn solve(inverse: &Inverse, pose: &Pose, free: f64) -> Vec<Vec<f64>> {
    let mut state = State {
        inverse,
        values: Vec::new(),
        q: vec![0.0; inverse.arm.dof()],
        free,
        found: Vec::new(),
    };
    let matrix = pose.to_homogeneous();
    for (row, vars) in inverse.target.iter().enumerate() {
        for (column, var) in vars.iter().enumerate() {
            state.values.push((*var, matrix[(row, column)]));
        }
    }
    state.step(0);
    state.found
}

struct State<'a> {
    inverse: &'a Inverse,
    values: Vec<(Var, f64)>,
    q: Vec<f64>,
    free: f64,
    found: Vec<Vec<f64>>,
}

impl State<'_> {
    fn value(&self, poly: &Poly) -> f64 {
        let inverse = self.inverse;
        poly.evaluate(&0.0, |var| {
            if let VarKind::Symbol(_) = var.kind()
                && let Some(SymbolMeaning::Auxiliary) = inverse.names.symbol_meaning(var)
            {
                let known = self.values.iter().rev().find(|(known, _)| *known == var);
                return known.map_or(f64::NAN, |(_, value)| *value);
            }
            inverse
                .arm
                .value_at(var, &self.q, &|name| inverse.arm.parameter(name))
        })
    }

    /// The size of a polynomial's terms: what its rounding is to be measured by.
    fn size(&self, poly: &Poly) -> f64 {
        let terms = poly.terms().iter();
        terms
            .map(|term| {
                (number::to_f64(&term.coefficient)
                    * self.value(&Poly::from_terms([crate::poly::Term {
                        monomial: term.monomial,
                        coefficient: number::whole(1),
                    }])))
                .abs()
            })
            .sum()
    }

    fn step(&mut self, index: usize) {
        let inverse = self.inverse;
        let Some(step) = inverse.steps.get(index) else {
            self.found.push(self.q.clone());
            return;
        };
        match step {
            Step::Define { quantities, .. } => {
                let before = self.values.len();
                for (var, poly) in quantities {
                    let value = self.value(poly);
                    self.values.push((*var, value));
                }
                self.step(index + 1);
                self.values.truncate(before);
            }
            Step::Joint { joint, rule, .. } => {
                for value in self.roots(rule) {
                    let turns = inverse.arm.rows[*joint].turns;
                    self.q[*joint] = if turns {
                        value.sin().atan2(value.cos())
                    } else {
                        value
                    };
                    self.step(index + 1);
                }
            }
        }
    }

    fn roots(&self, rule: &Rule) -> Vec<f64> {
        match rule {
            Rule::Two {
                a,
                b,
                k,
                sine_square,
            } => {
                let (a_value, b_value, k_value) = (self.value(a), self.value(b), self.value(k));
                let (radius, size) = (
                    a_value.hypot(b_value),
                    self.size(a) + self.size(b) + self.size(k),
                );
                if radius <= FREE * size {
                    return vec![self.free];
                }
                let square = match sine_square {
                    Some(square) => self.value(square),
                    None => (radius - k_value) * (radius + k_value),
                };
                let middle = b_value.atan2(a_value);
                match () {
                    () if square > ROOT_SLACK * size * size => {
                        let half = square.sqrt().atan2(k_value);
                        vec![middle + half, middle - half]
                    }
                    () if square >= -ROOT_SLACK * size * size => {
                        vec![middle + 0.0_f64.atan2(k_value)]
                    }
                    () => Vec::new(),
                }
            }
            Rule::One { sin, cos } => {
                let (sin_value, cos_value) = (self.value(sin), self.value(cos));
                let size = self.size(sin) + self.size(cos);
                match sin_value.hypot(cos_value) <= FREE * size {
                    true => vec![self.free],
                    false => vec![sin_value.atan2(cos_value)],
                }
            }
            Rule::Slide { above, below } => {
                let below = self.value(below);
                if below == 0.0 {
                    vec![self.free]
                } else {
                    vec![self.value(above) / below]
                }
            }
            Rule::Square {
                coefficients: [c, b, a],
            } => {
                let (c, b, a) = (self.value(c), self.value(b), self.value(a));
                let square = b * b - 4.0 * a * c;
                if a == 0.0 || square < 0.0 {
                    return Vec::new();
                }
                let root = square.sqrt();
                vec![(-b + root) / (2.0 * a), (-b - root) / (2.0 * a)]
            }
        }
    }
}
