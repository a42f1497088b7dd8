//! The two sides of a claim compared: as polynomials, entry by entry, or as values where it is an angle.

use pieper::error::{Place, Result};

use super::ast::{Expr, Node};
use super::meaning::{self, Fraction, Held, Meaning, Sample};
use super::repair::{self, agree, angle_difference, values};
use super::{Failure, Outcome, Repair};
use crate::basis;
use crate::form;
use crate::poly::Poly;
use crate::print;

/// Joint vectors at which what is no polynomial is compared.
const SAMPLES: usize = 64;

/// Two sides of a claim, under its conditions.
pub(super) struct Claim<'a> {
    pub(super) meaning: &'a Meaning<'a>,
    pub(super) held: &'a [Held],
}

impl Claim<'_> {
    pub(super) fn compare(&self, first: &Expr, side: &Expr) -> Result<Outcome> {
        if let Some(rows) = self.meaning.matrix(first)? {
            return self.compare_matrices(side, &rows);
        }
        if let Node::Matrix(_) = first.node {
            return Err(self.meaning.error(
                first,
                "a matrix stands on the right; on the left its name was expected",
            ));
        }
        let left = self.meaning.fraction(first)?;
        let right = if left.is_some() {
            self.meaning.fraction(side)?
        } else {
            None
        };
        match (left, right) {
            (Some(left), Some(right)) => self.compare_polynomials(first, side, &left, &right),
            _ => self.compare_values(first, side),
        }
    }

    fn compare_matrices(&self, side: &Expr, rows: &[Vec<Poly>]) -> Result<Outcome> {
        let Node::Matrix(cells) = &side.node else {
            let Some(others) = self.meaning.matrix(side)? else {
                return Err(self.meaning.error(side, "a matrix was expected"));
            };
            let equal = rows
                .iter()
                .flatten()
                .zip(others.iter().flatten())
                .all(|(a, b)| self.meaning.under(self.held, &(a - b)).is_zero());
            return match equal {
                true => Ok(Outcome::Holds),
                false => Err(self.meaning.error(
                    side,
                    "two of the arm's own matrices differ: write the entries to be checked",
                )),
            };
        };
        if !matches!(cells.len(), 3 | 4) || !matches!(cells[0].len(), 3 | 4) {
            let size = format!("{} x {}", cells.len(), cells[0].len());
            return Err(self.meaning.error(
                side,
                &format!("a matrix of 3 or 4 rows and columns was expected, this is {size}"),
            ));
        }
        for (row, cells) in cells.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let left = Fraction {
                    above: rows[row][column].clone(),
                    below: Poly::one(),
                };
                let Some(right) = self.meaning.fraction(cell)? else {
                    return Err(self
                        .meaning
                        .error(cell, "sines, cosines and lengths were expected"));
                };
                let outcome = self.compare_polynomials(cell, cell, &left, &right)?;
                if let Outcome::Fails(mut failure) = outcome {
                    failure.entry = Some((row + 1, column + 1));
                    return Ok(Outcome::Fails(failure));
                }
            }
        }
        Ok(Outcome::Holds)
    }

    fn difference(&self, left: &Fraction, right: &Fraction, place: &Expr) -> Result<Poly> {
        let difference = self.meaning.under(self.held, &left.difference(right));
        match difference.is_swollen() {
            true => Err(self.meaning.error(
                place,
                "a claim of fewer terms was expected: this one is too long to decide",
            )),
            false => Ok(difference),
        }
    }

    fn compare_polynomials(
        &self,
        first: &Expr,
        side: &Expr,
        left: &Fraction,
        right: &Fraction,
    ) -> Result<Outcome> {
        let difference = self.difference(left, right, first)?;
        if difference.is_zero() {
            return Ok(Outcome::Holds);
        }
        let arm = self.meaning.arm;
        let samples = self.samples(6);
        let quotient = |fraction: &Fraction, sample: &Sample| {
            sample.value(arm, &fraction.above) / sample.value(arm, &fraction.below)
        };
        let truth: Vec<f64> = samples
            .iter()
            .map(|sample| quotient(left, sample))
            .collect();
        let is_near = |fixed: &Expr| {
            values(self.meaning, fixed, &samples[..2])
                .is_some_and(|values| values.iter().zip(&truth).all(|(a, b)| agree(*a, *b)))
        };
        // A slip may divide by zero or grow past all use: then it was none.
        let is_right = |fixed: &Expr| {
            let Ok(Some(right)) = self.meaning.fraction(fixed) else {
                return Ok(false);
            };
            Ok(self
                .difference(left, &right, first)
                .is_ok_and(|difference| difference.is_zero()))
        };
        let edit = repair::find(self.meaning, side, is_near, is_right)?;
        let claimed: Vec<f64> = samples
            .iter()
            .map(|sample| quotient(right, sample))
            .collect();
        let show = |poly: &Poly| {
            let under = self.meaning.under(self.held, poly);
            let short = basis::shortest(arm, &under);
            print::text(&form::of(&arm.names, &short), &arm.names)
        };
        let whole = |fraction: &Fraction| fraction.below == Poly::one();
        Ok(Outcome::Fails(Box::new(Failure {
            entry: None,
            difference: (whole(left) && whole(right)).then(|| show(&difference)),
            repair: edit.map(|edit| self.repair(edit)),
            right: whole(left).then(|| show(&left.above)),
            ..self.shown_at(&samples, &truth, &claimed)
        })))
    }

    /// The sample that shows the difference best.
    fn shown_at(&self, samples: &[Sample], truth: &[f64], claimed: &[f64]) -> Failure {
        let off = |index: &usize| {
            let off = (truth[*index] - claimed[*index]).abs();
            if off.is_nan() { f64::INFINITY } else { off }
        };
        let best = (0..samples.len())
            .max_by(|a, b| off(a).total_cmp(&off(b)))
            .unwrap_or(0);
        Failure {
            entry: None,
            difference: None,
            q: samples[best].q.clone(),
            parameters: samples[best].parameters.clone(),
            values: (truth[best], claimed[best]),
            repair: None,
            right: None,
        }
    }

    fn repair(&self, edit: repair::Edit) -> Repair {
        let place = Place::of_offset(self.meaning.file, self.meaning.text, edit.offset);
        Repair {
            what: edit.what,
            before: edit.before,
            after: edit.after,
            line: place.line,
            column: place.column,
        }
    }

    /// What is no polynomial: angles and inverse functions, compared at samples.
    fn compare_values(&self, first: &Expr, side: &Expr) -> Result<Outcome> {
        let meaning = self.meaning;
        if self.is_proved_angle(first, side)? {
            return Ok(Outcome::Holds);
        }
        let samples = self.samples(SAMPLES);
        let angular = meaning.linear(first)?.is_some() || is_angle(first) || is_angle(side);
        let off = |a: f64, b: f64| {
            if angular {
                angle_difference(a, b)
            } else {
                a - b
            }
        };
        let value = |expr: &Expr| {
            samples
                .iter()
                .map(|sample| meaning.value(expr, sample))
                .collect::<Result<Vec<_>>>()
        };
        let (truth, claimed) = (value(first)?, value(side)?);
        let good = |values: &[f64]| {
            truth
                .iter()
                .zip(values)
                .all(|(a, b)| off(*a, *b).abs() < 1e-7 * (1.0 + a.abs()))
        };
        // atan2(0, 0) is a number to a computer, but no angle.
        let vague = self.is_vague(side, &samples)?;
        if good(&claimed) && !vague {
            return Ok(Outcome::HoldsAtSamples(samples.len()));
        }
        let is_right = |fixed: &Expr| {
            let fits = values(meaning, fixed, &samples).is_some_and(|values| good(&values));
            Ok(fits && !self.is_vague(fixed, &samples)?)
        };
        let is_near = |fixed: &Expr| {
            values(meaning, fixed, &samples[..2]).is_some_and(|values| {
                truth
                    .iter()
                    .zip(&values)
                    .all(|(a, b)| off(*a, *b).abs() < 1e-7 * (1.0 + a.abs()))
            })
        };
        let edit = match other_entries(side) {
            Some(candidates) => candidates.into_iter().find_map(|fixed| {
                let right = is_near(&fixed) && is_right(&fixed).unwrap_or(false);
                right.then(|| repair::Edit {
                    what: "the entries".to_owned(),
                    before: side.text(),
                    after: fixed.text(),
                    offset: side.offset,
                    fixed,
                })
            }),
            None => None,
        };
        let edit = match edit.or_else(|| both_signs(side, &truth, &claimed)) {
            Some(edit) => Some(edit),
            None => repair::find(meaning, side, is_near, is_right)?,
        };
        Ok(Outcome::Fails(Box::new(Failure {
            repair: edit.map(|edit| self.repair(edit)),
            ..self.shown_at(&samples, &truth, &claimed)
        })))
    }

    /// Whether `angle = atan2(y, x)` is an identity: `y cos - x sin` vanishes and `x cos + y sin` is a positive number.
    fn is_proved_angle(&self, first: &Expr, side: &Expr) -> Result<bool> {
        let Node::Call(name, arguments) = &side.node else {
            return Ok(false);
        };
        let ([y, x], "atan2") = (&arguments[..], name.as_str()) else {
            return Ok(false);
        };
        let turn = self.meaning.linear(first)?.and_then(|linear| linear.turn());
        let (Some(turn), Some(y), Some(x)) =
            (turn, self.meaning.fraction(y)?, self.meaning.fraction(x)?)
        else {
            return Ok(false);
        };
        if y.below != Poly::one() || x.below != Poly::one() {
            return Ok(false);
        }
        let across = self
            .meaning
            .under(self.held, &(&y.above * &turn.cos - &x.above * &turn.sin));
        let along = self
            .meaning
            .under(self.held, &(&x.above * &turn.cos + &y.above * &turn.sin));
        let positive = along
            .constant()
            .is_some_and(|value| value > crate::number::whole(0));
        Ok(across.is_zero() && positive)
    }

    /// Whether an atan2 in the formula has both arguments zero at every sample.
    fn is_vague(&self, expr: &Expr, samples: &[Sample]) -> Result<bool> {
        if let Node::Call(name, arguments) = &expr.node
            && name == "atan2"
        {
            let mut all = true;
            for sample in samples {
                for argument in arguments {
                    all &= self.meaning.value(argument, sample)?.abs() < 1e-12;
                }
            }
            if all {
                return Ok(true);
            }
        }
        for child in expr.children() {
            if self.is_vague(child, samples)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Joint vectors a person can read: tenths of a radian and of a metre; symbols without a value get one.
    fn samples(&self, count: usize) -> Vec<Sample> {
        let arm = self.meaning.arm;
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = |range: u64| {
            // Knuth's MMIX generator: the same samples on every machine.
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % range
        };
        let sample = |_| {
            let q = (0..arm.dof())
                .map(|_| (next(61) as f64 - 30.0) / 10.0)
                .collect();
            let unknown = arm.names.symbols().map(|(_, name, _)| name.to_owned());
            let angles = arm.names.angles().filter_map(|(_, meaning)| match meaning {
                crate::names::AngleMeaning::Parameter(name) => Some(name.clone()),
                _ => None,
            });
            let unknown = unknown
                .chain(angles)
                .filter(|name| arm.parameter(name).is_nan());
            let parameters = unknown
                .map(|name| (name, (next(9) + 1) as f64 / 10.0))
                .collect();
            let mut sample = Sample { q, parameters };
            self.meaning.hold(self.held, &mut sample);
            sample
        };
        (0..count).map(sample).collect()
    }
}

fn is_angle(expr: &Expr) -> bool {
    match &expr.node {
        Node::Call(name, _) => matches!(name.as_str(), "atan2" | "atan" | "asin" | "acos"),
        Node::Add(a, b) | Node::Sub(a, b) => is_angle(a) || is_angle(b),
        Node::Neg(a) => is_angle(a),
        _ => false,
    }
}

/// A formula that is right up to its sign: one branch of two.
fn both_signs(side: &Expr, truth: &[f64], claimed: &[f64]) -> Option<repair::Edit> {
    let mut pairs = truth.iter().zip(claimed);
    pairs
        .all(|(a, b)| (a.abs() - b.abs()).abs() < 1e-7)
        .then(|| repair::Edit {
            what: "both signs: this is one branch of two".to_owned(),
            before: side.text(),
            after: format!("+-{}", side.text()),
            offset: side.offset,
            fixed: side.clone(),
        })
}

/// `atan2` of two entries of one matrix: the same of all other pairs, the least changed first.
fn other_entries(side: &Expr) -> Option<Vec<Expr>> {
    let Node::Call(name, arguments) = &side.node else {
        return None;
    };
    let ([a, b], "atan2") = (&arguments[..], name.as_str()) else {
        return None;
    };
    let entry = |expr: &Expr| {
        let (negative, inner) = match &expr.node {
            Node::Neg(inner) => (true, &inner.node),
            node => (false, node),
        };
        match inner {
            Node::Name(base, index) => {
                meaning::entry_index(index).map(|at| (base.clone(), String::new(), at, negative))
            }
            Node::Entry(base, index, row, column) => {
                Some((base.clone(), index.clone(), (*row, *column), negative))
            }
            _ => None,
        }
    };
    let (first, second) = (entry(a)?, entry(b)?);
    let make = |of: &(String, String, (usize, usize), bool),
                offset: usize,
                (row, column): (usize, usize),
                negative: bool| {
        let node = match of.1.is_empty() && !matches!(a.node, Node::Entry(..)) {
            true => Node::Name(of.0.clone(), format!("{row}{column}")),
            false => Node::Entry(of.0.clone(), of.1.clone(), row, column),
        };
        let entry = Expr { node, offset };
        if negative {
            Expr {
                node: Node::Neg(Box::new(entry)),
                offset,
            }
        } else {
            entry
        }
    };
    let all = || {
        (1..=3).flat_map(|row| {
            (1..=3).flat_map(move |column| [((row, column), false), ((row, column), true)])
        })
    };
    let mut found: Vec<(usize, Expr)> = Vec::new();
    for (at, negative) in all() {
        for (other_at, other_negative) in all().filter(|(other, _)| *other != at) {
            let changes = usize::from(at != first.2)
                + usize::from(negative != first.3)
                + usize::from(other_at != second.2)
                + usize::from(other_negative != second.3);
            let arguments = vec![
                make(&first, a.offset, at, negative),
                make(&second, b.offset, other_at, other_negative),
            ];
            found.push((
                changes,
                Expr {
                    node: Node::Call(name.clone(), arguments),
                    offset: side.offset,
                },
            ));
        }
    }
    found.sort_by_key(|(changes, _)| *changes);
    Some(found.into_iter().map(|(_, expr)| expr).collect())
}
