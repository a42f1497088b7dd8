//! A closed-form inverse in numbers.

use pieper::spatial::Pose;

use super::{Inverse, OneUnknown, Rule, Step};
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
    let mut state = State::new(inverse, &rows_of(pose), free);
    state.step(0);
    state.found
}

/// The first three rows of a pose's matrix.
fn rows_of(pose: &Pose) -> [[f64; 4]; 3] {
    let matrix = pose.to_homogeneous();
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)]))
}

impl OneUnknown {
    /// The joint vectors that the formulas give for a pose where the unknown joint has this value, each with what the equation leaves:
    /// zero where it is right. Metres and radians; as [`solve`] otherwise.
    pub fn at(&self, pose: &Pose, value: f64, free: f64) -> Vec<(Vec<f64>, f64)> {
        self.of_rows(&rows_of(pose), value, free)
    }

    fn of_rows(&self, rows: &[[f64; 4]; 3], value: f64, free: f64) -> Vec<(Vec<f64>, f64)> {
        let mut state = State::new(&self.inverse, rows, free);
        state.q[self.joint] = value;
        state.condition = Some((self.at, &self.equation));
        state.step(0);
        state.found.into_iter().zip(state.left).collect()
    }

    /// Whether the equation holds at the joint vector of a pose, and not beside it.
    pub(super) fn decides(&self, q: &[f64]) -> bool {
        let arm = &self.inverse.arm;
        let rows = arm.pose_at(q, &|name| arm.parameter(name));
        let right = |(found, left): &(Vec<f64>, f64)| {
            let near = found
                .iter()
                .zip(q)
                .all(|(a, b)| ((a - b) * 0.5).sin().abs() < 1e-7);
            near && left.abs() < 1e-9
        };
        let at = |value: f64| self.of_rows(&rows, value, 0.0);
        let here = q[self.joint];
        let beside = [-0.3, -0.1, -0.02, 0.02, 0.1, 0.3];
        let mut off = beside.iter().flat_map(|by| at(here + by)).peekable();
        at(here).iter().any(right) && off.peek().is_some() && off.all(|(_, left)| left.abs() > 1e-9)
    }
}

struct State<'a> {
    inverse: &'a Inverse,
    values: Vec<(Var, f64)>,
    q: Vec<f64>,
    free: f64,
    found: Vec<Vec<f64>>,
    /// An equation to look at before a step, and what it leaves now and left for each that was found.
    condition: Option<(usize, &'a Poly)>,
    now: f64,
    left: Vec<f64>,
}

impl<'a> State<'a> {
    fn new(inverse: &'a Inverse, rows: &[[f64; 4]; 3], free: f64) -> Self {
        let target = inverse.target.iter().enumerate();
        let values = target.flat_map(|(row, vars)| {
            let entries = vars.iter().enumerate();
            entries.map(move |(column, var)| (*var, rows[row][column]))
        });
        Self {
            inverse,
            values: values.collect(),
            q: vec![0.0; inverse.arm.dof()],
            free,
            found: Vec::new(),
            condition: None,
            now: 0.0,
            left: Vec::new(),
        }
    }

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
        if let Some((_, equation)) = self.condition.filter(|(at, _)| *at == index) {
            self.now = self.value(equation);
        }
        let Some(step) = inverse.steps.get(index) else {
            self.found.push(self.q.clone());
            self.left.push(self.now);
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
