//! Which equation of those at hand gives a joint, and how much it is liked.

use super::search::Search;
use super::{Rule, Source};
use crate::number;
use crate::poly::Poly;
use crate::transform::Transform;

/// A way to find one joint, with how much it is liked: less is better.
pub(super) struct Candidate {
    cost: (u8, usize, usize),
    pub(super) joint: usize,
    pub(super) rule: Rule,
    pub(super) source: Source,
}

/// An equation `poly = 0`.
struct Equation {
    poly: Poly,
    source: Source,
}

impl Search<'_> {
    pub(super) fn best(&self) -> Option<Candidate> {
        let mut singles: Vec<(usize, Equation)> = Vec::new();
        for (source, known, product) in self.equations() {
            for row in 0..3 {
                for column in 0..4 {
                    let poly = &known.0[row][column] - &product.0[row][column];
                    if let [joint] = self.unknowns(&poly)[..] {
                        let source = Source {
                            entries: vec![(row, column)],
                            ..source.clone()
                        };
                        singles.push((joint, Equation { poly, source }));
                    }
                }
            }
            for rows in [&[0, 1][..], &[0, 2], &[1, 2], &[0, 1, 2]] {
                if let Some(poly) = self.squares(&known, &product, rows)
                    && let [joint] = self.unknowns(&poly)[..]
                {
                    let entries = rows.iter().map(|&row| (row, 3)).collect();
                    singles.push((
                        joint,
                        Equation {
                            poly,
                            source: Source {
                                entries,
                                squares: true,
                                ..source.clone()
                            },
                        },
                    ));
                }
            }
        }
        let mut candidates: Vec<Candidate> = Vec::new();
        for (joint, equation) in &singles {
            candidates.extend(self.alone(*joint, equation));
        }
        for (index, (joint, first)) in singles.iter().enumerate() {
            for (_, second) in singles[..index].iter().filter(|(other, _)| other == joint) {
                candidates.extend(self.pair(*joint, second, first));
            }
        }
        candidates.retain(|candidate| self.probe.tells(self.arm, candidate.joint, &candidate.rule));
        candidates
            .into_iter()
            .min_by_key(|candidate| candidate.cost)
    }

    /// The sum of squares of a position's coordinates: known minus unknown parts, one of the unknowns may go.
    fn squares(&self, known: &Transform, product: &Transform, rows: &[usize]) -> Option<Poly> {
        let mut total = Poly::zero();
        for &row in rows {
            let left = &known.0[row][3];
            if !self.unknowns(left).is_empty() {
                return None;
            }
            let (unknown, constant) = product.0[row][3].split(|monomial| {
                monomial.powers().any(|(var, _)| {
                    self.names
                        .joint_of(var)
                        .is_some_and(|joint| !self.solved[joint])
                })
            });
            if unknown.is_zero() {
                return None;
            }
            let known = left - &constant;
            total = total + &known * &known - &unknown * &unknown;
        }
        Some(total)
    }

    /// `a cos q + b sin q - k`, if the equation has that form.
    fn linear(&self, joint: usize, poly: &Poly) -> Option<[Poly; 3]> {
        let angle = self.arm.joint_angle(joint)?;
        let (a, b) = (poly.derivative(angle.cos()), poly.derivative(angle.sin()));
        if a.contains_angle(angle) || b.contains_angle(angle) {
            return None;
        }
        let rest = poly.clone() - &a * &Poly::var(angle.cos()) - &b * &Poly::var(angle.sin());
        Some([a, b, -rest])
    }

    fn alone(&self, joint: usize, equation: &Equation) -> Option<Candidate> {
        let source = equation.source.clone();
        let size = equation.poly.terms().len();
        if !self.arm.rows[joint].turns {
            let var = self.names.find_symbol(&format!("q{}", joint + 1))?;
            let coefficients = [0, 1, 2].map(|power| equation.poly.coefficient_of(var, power));
            return match equation.poly.degree_in(var) {
                1 => {
                    let [constant, below, _] = coefficients;
                    let sure = u8::from(below.constant().is_none());
                    Some(Candidate {
                        cost: (sure, size, joint),
                        joint,
                        rule: Rule::Slide {
                            above: -constant,
                            below,
                        },
                        source,
                    })
                }
                2 => Some(Candidate {
                    cost: (7, size, joint),
                    joint,
                    rule: Rule::Square { coefficients },
                    source,
                }),
                _ => None,
            };
        }
        let [a, b, k] = self.linear(joint, &equation.poly)?;
        let scale = a
            .constant()
            .filter(|value| b.is_zero() && number::magnitude(value) == number::whole(1));
        // A factor of the unknown starts with a plus.
        let leading = if a.is_zero() { &b } else { &a };
        let negative = leading
            .terms()
            .first()
            .is_some_and(|term| number::is_negative(&term.coefficient));
        let sign = number::whole(if negative { -1 } else { 1 });
        let (a, b, k) = (a.scaled(&sign), b.scaled(&sign), k.scaled(&sign));
        let sine_square = if scale.is_some() {
            self.complement(&equation.source, &k)
        } else {
            None
        };
        let kind = match (equation.source.squares, sine_square.is_some()) {
            (false, true) => 4,
            (false, false) => 5,
            (true, _) => 6,
        };
        Some(Candidate {
            cost: (kind, size, joint),
            joint,
            rule: Rule::Two {
                a,
                b,
                k,
                sine_square,
            },
            source,
        })
    }

    /// For an entry of a rotation that is a cosine: the squares of the other entries of its column, or else of its row.
    fn complement(&self, source: &Source, cosine: &Poly) -> Option<Poly> {
        let &[(row, column)] = &source.entries[..] else {
            return None;
        };
        let (_, known, _) = self
            .equations()
            .into_iter()
            .find(|(other, ..)| other.moved == source.moved)?;
        let is_it = |entry: &Poly| *entry == *cosine || -entry.clone() == *cosine;
        if column > 2 || !is_it(&known.0[row][column]) {
            return None;
        }
        let square = |entries: [&Poly; 2]| entries[0] * entries[0] + entries[1] * entries[1];
        let others = |of: usize| [(of + 1) % 3, (of + 2) % 3];
        let by_column = square(others(row).map(|row| &known.0[row][column]));
        let by_row = square(others(column).map(|column| &known.0[row][column]));
        let options = [by_column, by_row]
            .into_iter()
            .filter(|square| self.unknowns(square).is_empty());
        options.min_by_key(|square| square.terms().len())
    }

    /// Two equations for one joint that turns: its sine and its cosine.
    fn pair(&self, joint: usize, first: &Equation, second: &Equation) -> Option<Candidate> {
        let [a1, b1, k1] = self.linear(joint, &first.poly)?;
        let [a2, b2, k2] = self.linear(joint, &second.poly)?;
        let determinant = &a1 * &b2 - &a2 * &b1;
        if determinant.is_zero() || first.source.moved != second.source.moved {
            return None;
        }
        let mut cos = &k1 * &b2 - &k2 * &b1;
        let mut sin = &a1 * &k2 - &a2 * &k1;
        let is_turned = |a: &Poly, b: &Poly, c: &Poly, d: &Poly| *a == *d && *b == -c.clone();
        // [a1 b1; a2 b2] is a turn, or a reflection, times a length: the determinant has one sign.
        let definite = if is_turned(&a1, &b1, &a2, &b2) {
            Some(1)
        } else if is_turned(&a1, &(-b1.clone()), &a2, &(-b2.clone())) {
            Some(-1)
        } else {
            determinant
                .constant()
                .map(|value| if number::is_negative(&value) { -1 } else { 1 })
        };
        match definite {
            Some(sign) => {
                (sin, cos) = (
                    sin.scaled(&number::whole(sign)),
                    cos.scaled(&number::whole(sign)),
                )
            }
            None => (sin, cos) = (&sin * &determinant, &cos * &determinant),
        }
        // A common factor of even power, or none that matters, may go.
        let common = sin.common_monomial().common(&cos.common_monomial());
        let even = common
            .powers()
            .fold(crate::poly::Monomial::ONE, |even, (var, exponent)| {
                even.with_exponent(var, exponent - exponent % 2)
            });
        (sin, cos) = (sin.divided(&even)?, cos.divided(&even)?);
        let sure = match (determinant.constant().is_some(), definite.is_some()) {
            (true, _) => 0,
            (false, true) => 2,
            (false, false) => 8,
        };
        let size = sin.terms().len() + cos.terms().len();
        let entries = [&first.source.entries[..], &second.source.entries].concat();
        let squares = first.source.squares || second.source.squares;
        let source = Source {
            entries,
            squares,
            ..first.source.clone()
        };
        (!squares).then_some(Candidate {
            cost: (sure, size, joint),
            joint,
            rule: Rule::One { sin, cos },
            source,
        })
    }
}
