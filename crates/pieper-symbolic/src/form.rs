//! Formulas as a person writes them: common factors pulled out, like things grouped.

use std::cmp::Reverse;

use crate::basis;
use crate::names::{AngleMeaning, Names, Var, VarKind};
use crate::number::{self, Rational};
use crate::poly::{Monomial, Poly, Term};

/// A formula to be printed.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A number that is not negative.
    Number(Rational),
    /// A quantity.
    Var(Var),
    /// The variable of a joint, counted from 0.
    Joint(usize),
    /// A name: letters, perhaps an index behind an underscore.
    Name(String),
    /// A name with row and column, counted from 1.
    Entry(String, usize, usize),
    /// `-x`
    Neg(Box<Form>),
    /// A sum; terms to be subtracted are [`Form::Neg`].
    Sum(Vec<Form>),
    /// A product.
    Product(Vec<Form>),
    /// `x^n`
    Power(Box<Form>, u32),
    /// A fraction.
    Quotient(Box<Form>, Box<Form>),
    /// The inverse of a matrix.
    Inverse(Box<Form>),
    /// The square root.
    Root(Box<Form>),
    /// A function by name.
    Call(&'static str, Vec<Form>),
    /// Plus or minus.
    PlusMinus(Box<Form>, Box<Form>),
}

impl Form {
    /// The constant.
    pub fn number(value: &Rational) -> Self {
        signed(
            number::is_negative(value),
            Self::Number(number::magnitude(value)),
        )
    }

    /// A whole number.
    pub fn whole(value: i64) -> Self {
        Self::number(&number::whole(value))
    }

    /// A name.
    pub fn name(name: impl Into<String>) -> Self {
        Self::Name(name.into())
    }

    /// `a / b`
    #[must_use]
    pub fn over(self, divisor: Self) -> Self {
        Self::Quotient(Box::new(self), Box::new(divisor))
    }

    /// `a +- b`
    #[must_use]
    pub fn plus_minus(self, other: Self) -> Self {
        Self::PlusMinus(Box::new(self), Box::new(other))
    }

    /// A sum of joint variables with their signs.
    pub fn joints(sum: &[(usize, i8)]) -> Self {
        let terms: Vec<Self> = sum
            .iter()
            .map(|(joint, sign)| signed(*sign < 0, Self::Joint(*joint)))
            .collect();
        one_or(terms, Self::Sum)
    }

    /// The square root; of a square of a name it stays as it is, signs matter.
    #[must_use]
    pub fn root(self) -> Self {
        Self::Root(Box::new(self))
    }
}

pub(crate) fn signed(negative: bool, form: Form) -> Form {
    match (negative, form) {
        (false, form) => form,
        (true, Form::Neg(inner)) => *inner,
        (true, form) => Form::Neg(Box::new(form)),
    }
}

fn one_or(mut forms: Vec<Form>, many: fn(Vec<Form>) -> Form) -> Form {
    match forms.len() {
        1 => forms.swap_remove(0),
        _ => many(forms),
    }
}

/// The polynomial as a person would write it.
///
/// ```
/// use pieper_symbolic::{Arm, Lengths, basis, form, print};
/// let robot = pieper_robots::find("ar3").unwrap().robot();
/// let arm = Arm::new(&robot, Lengths::Symbols)?;
/// let t32 = &arm.tool_pose()?.0[2][1];
/// let short = basis::cumulative(&arm).rewrite(t32);
/// assert_eq!(print::text(&form::of(&arm.names, &short), &arm.names), "s23*c5 - c23*c4*s5");
/// # Ok::<(), pieper::Error>(())
/// ```
pub fn of(names: &Names, poly: &Poly) -> Form {
    if poly.is_swollen() {
        return Form::name("(too long)");
    }
    let mut terms = poly.terms().to_vec();
    terms.sort_by_key(|term| reading_order(names, &term.monomial));
    group(names, &terms)
}

/// Where a term stands in a sum: by degree in lengths, then by its factors.
fn reading_order(names: &Names, monomial: &Monomial) -> Vec<(usize, bool)> {
    let trig = monomial.powers().filter(|(var, _)| var.angle().is_some());
    let mut keys: Vec<(usize, bool)> = trig
        .map(|(var, _)| (place(names, var), matches!(var.kind(), VarKind::Sin(_))))
        .collect();
    keys.sort_unstable();
    keys
}

/// Where a quantity stands in a product: numbers, roots, symbols, then angles by joint.
fn place(names: &Names, var: Var) -> usize {
    match var.kind() {
        VarKind::Root(_) => 0,
        VarKind::Symbol(index) => 1 + index,
        VarKind::Sin(angle) | VarKind::Cos(angle) => match names.meaning(angle) {
            AngleMeaning::Parameter(_) | AngleMeaning::Constant(..) => 60 + angle.0 as usize,
            AngleMeaning::Joint(joint) => 100 + 10 * joint,
            AngleMeaning::Sum(sum) => 100 + 10 * sum[0].0 + sum.len(),
        },
    }
}

fn product(names: &Names, coefficient: &Rational, monomial: &Monomial, rest: Option<Form>) -> Form {
    let mut powers: Vec<(Var, u8)> = monomial.powers().collect();
    powers.sort_by_key(|(var, _)| (place(names, *var), *var));
    let mut factors: Vec<Form> = Vec::new();
    let magnitude = number::magnitude(coefficient);
    let empty = powers.is_empty() && rest.is_none();
    if magnitude != number::whole(1) || empty {
        factors.push(Form::Number(magnitude));
    }
    for (var, exponent) in powers {
        let base = Form::Var(var);
        factors.push(if exponent == 1 {
            base
        } else {
            Form::Power(Box::new(base), u32::from(exponent))
        });
    }
    factors.extend(rest);
    signed(
        number::is_negative(coefficient),
        one_or(factors, Form::Product),
    )
}

/// Terms beyond which only single quantities are tried as common factors: pairs of terms would take too long.
const MANY_TERMS: usize = 80;

fn group(names: &Names, terms: &[Term]) -> Form {
    let Some(first) = terms.first() else {
        return Form::whole(0);
    };
    if terms.len() == 1 {
        return product(names, &first.coefficient, &first.monomial, None);
    }
    let common = terms
        .iter()
        .fold(first.monomial, |common, term| common.common(&term.monomial));
    let magnitude = number::magnitude(&first.coefficient);
    let alike = terms
        .iter()
        .all(|term| number::magnitude(&term.coefficient) == magnitude);
    if common != Monomial::ONE || (alike && magnitude != number::whole(1)) {
        let factor = if alike {
            first.coefficient.clone()
        } else {
            sign_of(&first.coefficient)
        };
        return product(
            names,
            &factor,
            &common,
            Some(group(names, &divided(terms, &common, &factor))),
        );
    }
    let mut left: Vec<(usize, Term)> = terms.iter().cloned().enumerate().collect();
    let mut parts: Vec<(usize, Form)> = Vec::new();
    while let Some(factor) = best_factor(names, &left) {
        let (with, without) = left
            .into_iter()
            .partition(|(_, term)| term.monomial.divided(&factor).is_some());
        left = without;
        let with: Vec<(usize, Term)> = with;
        let Some(&(index, ref leading)) = with.first() else {
            break;
        };
        let sign = sign_of(&leading.coefficient);
        let inner: Vec<Term> = with.into_iter().map(|(_, term)| term).collect();
        let inner = group(names, &divided(&inner, &factor, &sign));
        parts.push((index, product(names, &sign, &factor, Some(inner))));
    }
    let single = |(index, term): (usize, Term)| {
        (
            index,
            product(names, &term.coefficient, &term.monomial, None),
        )
    };
    parts.extend(left.into_iter().map(single));
    parts.sort_by_key(|(index, _)| *index);
    // A sum starts with a positive term where it has one: nobody writes -a + b.
    let start = parts
        .iter()
        .position(|(_, form)| !matches!(form, Form::Neg(_)))
        .unwrap_or(0);
    let leading = parts.remove(start);
    parts.insert(0, leading);
    Form::Sum(parts.into_iter().map(|(_, form)| form).collect())
}

fn sign_of(value: &Rational) -> Rational {
    number::whole(if number::is_negative(value) { -1 } else { 1 })
}

fn divided(terms: &[Term], monomial: &Monomial, factor: &Rational) -> Vec<Term> {
    let divide = |term: &Term| {
        Some(Term {
            monomial: term.monomial.divided(monomial)?,
            coefficient: &term.coefficient / factor,
        })
    };
    terms.iter().filter_map(divide).collect()
}

/// The factor whose pulling out saves most multiplications; `None` if nothing saves any.
fn best_factor(names: &Names, terms: &[(usize, Term)]) -> Option<Monomial> {
    let monomials: Vec<Monomial> = terms.iter().map(|(_, term)| term.monomial).collect();
    let mut candidates: Vec<Monomial> = Vec::new();
    if monomials.len() > MANY_TERMS {
        candidates.extend(monomials.iter().flat_map(|m| {
            m.powers()
                .map(|(var, _)| Monomial::of(var))
                .collect::<Vec<_>>()
        }));
    } else {
        for (index, a) in monomials.iter().enumerate() {
            candidates.extend(
                monomials[..index]
                    .iter()
                    .map(|b| a.common(b))
                    .filter(|m| *m != Monomial::ONE),
            );
        }
    }
    candidates.sort_unstable();
    candidates.dedup();
    let score = |candidate: &Monomial| {
        let count = monomials
            .iter()
            .filter(|monomial| monomial.divided(candidate).is_some())
            .count() as u32;
        // Among equals the angles nearest the base: brackets then hold the wrist, as papers print it.
        let nearest = candidate
            .powers()
            .map(|(var, _)| Reverse(place(names, var)))
            .max();
        (count.saturating_sub(1) * candidate.degree(), count, nearest)
    };
    let scored = candidates
        .into_iter()
        .map(|candidate| (score(&candidate), candidate));
    scored
        .filter(|((saved, ..), _)| *saved > 0)
        .max()
        .map(|(_, candidate)| candidate)
}

/// The sums of angles that a formula names, each once.
pub fn sums_in(names: &Names, polys: &[&Poly]) -> Vec<Vec<(usize, i8)>> {
    let mut found = Vec::new();
    let vars = polys.iter().flat_map(|poly| poly.vars());
    for var in vars.filter(|var| basis::is_sum(names, *var)) {
        if let Some(AngleMeaning::Sum(sum)) = var.angle().map(|angle| names.meaning(angle))
            && !found.contains(sum)
        {
            found.push(sum.clone());
        }
    }
    found
}
