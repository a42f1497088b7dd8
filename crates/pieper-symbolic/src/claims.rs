//! Claims: formulas as printed, checked against an arm.
//!
//! A file of claims holds equations in plain notation (`t32 = s23*c5 - c23*c4*s5`) or in LaTeX as papers write it. On
//! either side may stand entries of the tool's pose (`t11`, `x_c`, `n_x`), of matrices (`A5[1, 2]`, `R36[1, 3]`), whole
//! matrices, joint variables, named lengths, numbers, and functions of these. `c23` is the cosine of the sum of the
//! parallel axes 2 and 3 with the signs of the table. A line `map NAME = FORMULA` (in LaTeX `% map ...`) says what a
//! name stands for; a claim may end in `when q5 = 0`.

mod ast;
mod latex;
mod meaning;
mod parse;
mod plain;
mod repair;
mod token;

use pieper::error::{Error, Place, Result};

use crate::arm::Arm;
use crate::basis;
use crate::form;
use crate::poly::Poly;
use crate::print;
use ast::{Equation, Expr, Node};
use meaning::{Fraction, Held, Meaning, Sample};
use repair::{agree, angle_difference, values};

/// A file of claims larger than this is refused.
const MAX_BYTES: usize = 1 << 20;

/// Joint vectors at which what is no polynomial is compared.
const SAMPLES: usize = 64;

/// What became of one claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The claim's first side, as written.
    pub name: String,
    /// The line it stands in, from 1.
    pub line: usize,
    /// Whether it holds.
    pub outcome: Outcome,
}

/// Whether a claim holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Identically: proved by canonical form.
    Holds,
    /// At so many random joint vectors; it is no polynomial identity, so this is no proof.
    HoldsAtSamples(usize),
    /// It does not.
    Fails(Box<Failure>),
}

/// How a claim fails.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// Row and column of the matrix entry that is wrong, from 1; more may be.
    pub entry: Option<(usize, usize)>,
    /// First side minus what it is said to be, as a formula; `None` where it is no polynomial.
    pub difference: Option<String>,
    /// A joint vector that shows it: radians and metres.
    pub q: Vec<f64>,
    /// Values of the symbols there.
    pub parameters: Vec<(String, f64)>,
    /// The value of the first side there, and of what it is said to be.
    pub values: (f64, f64),
    /// The smallest repair found.
    pub repair: Option<Repair>,
    /// The right formula, where the first side is a polynomial.
    pub right: Option<String>,
}

/// A change that makes a claim true.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// What kind of slip it is, in words.
    pub what: String,
    /// The part that is wrong, as it stands.
    pub before: String,
    /// The same part, right.
    pub after: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

/// Checks every claim of a file. `latex` says which notation it is in.
///
/// # Errors
/// A parse error with line, column and what was expected; unknown names with the nearest known ones.
///
/// ```
/// use pieper_symbolic::{Arm, Lengths, claims};
/// let robot = pieper_robots::find("ar3").unwrap().robot();
/// let arm = Arm::new(&robot, Lengths::Symbols)?;
/// let verdicts = claims::check(&arm, "claims.txt", "t32 = s23*c5 - c23*c4*c5", false)?;
/// let claims::Outcome::Fails(failure) = &verdicts[0].outcome else { panic!("it is wrong") };
/// assert_eq!(failure.repair.as_ref().unwrap().what, "s5 for c5");
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn check(arm: &Arm, file: &str, text: &str, latex: bool) -> Result<Vec<Verdict>> {
    if text.len() > MAX_BYTES {
        return Err(Error::input(
            file,
            format!("a file of at most {} KiB was expected", MAX_BYTES >> 10),
        ));
    }
    let cut = |text: &str| {
        if latex {
            latex::tokens(file, text)
        } else {
            plain::tokens(file, text)
        }
    };
    // Maps are read for themselves; in the claims their lines are blank, so that places stay right.
    let (maps, claims_text) = take_maps(text);
    let tokens = token::resolve_lines(cut(&claims_text)?);
    let equations = parse::equations(file, text, &tokens)?;
    let mut meaning = Meaning {
        arm,
        file,
        text,
        shorthand: !(latex && writes_functions(&tokens)),
        maps: Vec::new(),
        pose: arm.tool_pose()?,
    };
    for (offset, name, formula) in maps {
        let mut formula_tokens = cut(formula)?;
        let start = formula.as_ptr() as usize - text.as_ptr() as usize;
        formula_tokens
            .iter_mut()
            .for_each(|token| token.offset += start);
        formula_tokens.retain(|token| !matches!(token.kind, token::Kind::End | token::Kind::Line));
        let image = parse::formula(file, text, &formula_tokens)?;
        let token::Kind::Name(base, index) = plain::name(name) else {
            continue;
        };
        if base.is_empty() {
            return Err(Error::parse(
                Place::of_offset(file, text, offset),
                "map",
                "a name was expected behind it",
            ));
        }
        meaning.maps.push(((base, index), image));
    }
    equations
        .iter()
        .map(|equation| verdict(&meaning, equation))
        .collect()
}

/// Lines `map NAME = FORMULA`, with their offsets, and the text without them.
fn take_maps(text: &str) -> (Vec<(usize, &str, &str)>, String) {
    let (mut maps, mut rest, mut offset) = (Vec::new(), String::with_capacity(text.len()), 0);
    for line in text.split_inclusive('\n') {
        let content = line.trim().trim_start_matches('%').trim();
        let map = content
            .strip_prefix("map ")
            .and_then(|map| map.split_once('='));
        match map {
            Some((name, formula))
                if name.trim().chars().all(|c| c.is_alphanumeric() || c == '_') =>
            {
                maps.push((offset, name.trim(), formula.trim()));
                rest.extend(line.chars().map(|c| if c == '\n' { c } else { ' ' }));
                // As many bytes as before, so that places stay right.
                rest.push_str(&" ".repeat(line.len() - line.chars().count()));
            }
            _ => rest.push_str(line),
        }
        offset += line.len();
    }
    (maps, rest)
}

/// Whether sines and cosines are written in full: then `s_1` is a name, not the sine of q1.
fn writes_functions(tokens: &[token::Token]) -> bool {
    let is_function = |token: &token::Token| matches!(&token.kind, token::Kind::Name(base, index) if index.is_empty() && matches!(base.as_str(), "sin" | "cos"));
    tokens.iter().any(is_function)
}

fn verdict(meaning: &Meaning<'_>, equation: &Equation) -> Result<Verdict> {
    let line = Place::of_offset(meaning.file, meaning.text, equation.offset).line;
    let held = equation
        .conditions
        .iter()
        .map(|(left, right)| meaning.held(left, right));
    let held = held.collect::<Result<Vec<_>>>()?;
    let mut outcome = Outcome::Holds;
    let (first, others) = equation
        .sides
        .split_first()
        .ok_or_else(|| Error::input(meaning.file, "an empty claim"))?;
    for side in others {
        let claim = Claim {
            meaning,
            held: &held,
        };
        match claim.compare(first, side)? {
            Outcome::Holds => {}
            Outcome::HoldsAtSamples(count) => outcome = Outcome::HoldsAtSamples(count),
            failed @ Outcome::Fails(_) => {
                outcome = failed;
                break;
            }
        }
    }
    Ok(Verdict {
        name: first.text(),
        line,
        outcome,
    })
}

/// Two sides of a claim, under its conditions.
struct Claim<'a> {
    meaning: &'a Meaning<'a>,
    held: &'a [Held],
}

impl Claim<'_> {
    fn compare(&self, first: &Expr, side: &Expr) -> Result<Outcome> {
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
