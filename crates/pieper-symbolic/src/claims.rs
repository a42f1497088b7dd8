//! Claims: formulas as printed, checked against an arm.
//!
//! A file of claims holds equations in plain notation (`t32 = s23*c5 - c23*c4*s5`) or in LaTeX as papers write it. On
//! either side may stand entries of the tool's pose (`t11`, `x_c`, `n_x`), of matrices (`A5[1, 2]`, `R36[1, 3]`), whole
//! matrices, joint variables, named lengths, numbers, and functions of these. `c23` is the cosine of the sum of the
//! parallel axes 2 and 3 with the signs of the table. A line `map NAME = FORMULA` (in LaTeX `% map ...`) says what a
//! name stands for; a claim may end in `when q5 = 0`.

mod ast;
mod compare;
mod latex;
mod meaning;
mod naming;
mod parse;
mod plain;
mod repair;
mod token;

use pieper::error::{Error, Place, Result};

use crate::arm::Arm;
use ast::Equation;
use compare::Claim;
use meaning::Meaning;

/// A file of claims larger than this is refused.
const MAX_BYTES: usize = 1 << 20;

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
