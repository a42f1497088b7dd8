//! Polynomials in sines, cosines and symbols, in canonical form.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use pieper::scalar::Scalar;

use crate::names::{Angle, MAX_ANGLES, SLOTS, Var};
use crate::number::{self, Rational};

/// A product of quantities: the exponent of each.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial([u8; SLOTS]);

impl std::fmt::Debug for Monomial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.powers()).finish()
    }
}

impl Monomial {
    /// The empty product.
    pub const ONE: Self = Self([0; SLOTS]);

    /// One quantity.
    pub fn of(var: Var) -> Self {
        let mut exponents = [0; SLOTS];
        exponents[var.slot()] = 1;
        Self(exponents)
    }

    /// The exponent of a quantity.
    pub fn exponent(&self, var: Var) -> u8 {
        self.0[var.slot()]
    }

    /// The quantities with their exponents, those of exponent zero left out.
    pub fn powers(&self) -> impl Iterator<Item = (Var, u8)> + '_ {
        let all = self.0.iter().enumerate();
        all.filter(|(_, exponent)| **exponent > 0)
            .map(|(slot, exponent)| (Var(slot as u8), *exponent))
    }

    /// The sum of the exponents.
    pub fn degree(&self) -> u32 {
        self.0.iter().map(|&exponent| u32::from(exponent)).sum()
    }

    /// The greatest common divisor.
    pub fn common(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|slot| self.0[slot].min(other.0[slot])))
    }

    /// `self / divisor`, if it divides.
    pub fn divided(&self, divisor: &Self) -> Option<Self> {
        let divides = self.0.iter().zip(&divisor.0).all(|(a, b)| a >= b);
        divides.then(|| Self(std::array::from_fn(|slot| self.0[slot] - divisor.0[slot])))
    }

    /// The same product with the exponent of a quantity set.
    #[must_use]
    pub fn with_exponent(mut self, var: Var, exponent: u8) -> Self {
        self.0[var.slot()] = exponent;
        self
    }

    /// The product as it comes, squares of sines and roots included; saturated at exponent 255.
    fn times(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|slot| {
            self.0[slot].saturating_add(other.0[slot])
        }))
    }
}

/// One term of a polynomial.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The product of quantities.
    pub monomial: Monomial,
    /// What scales it; never zero.
    pub coefficient: Rational,
}

/// Terms a polynomial may have: beyond it a formula is of no use to anyone, and an hour would not print it.
pub const MAX_TERMS: usize = 4_000;

/// A polynomial over exact rationals, reduced by `sin^2 = 1 - cos^2` for every angle and by the roots' squares: two
/// polynomials are the same function of independent angles and symbols exactly if they are equal.
///
/// One that has grown past [`MAX_TERMS`] is *swollen*: it has lost its terms, and so has all that is made of it.
///
/// ```
/// use pieper_symbolic::names::{AngleMeaning, Names};
/// use pieper_symbolic::poly::Poly;
/// let mut names = Names::default();
/// let q = names.angle(AngleMeaning::Joint(0)).unwrap();
/// let (s, c) = (Poly::var(q.sin()), Poly::var(q.cos()));
/// assert_eq!(&s * &s + &c * &c, Poly::one());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Poly {
    /// By descending monomial, none twice.
    terms: Vec<Term>,
    swollen: bool,
}

impl Poly {
    /// 0
    pub fn zero() -> Self {
        Self::default()
    }

    /// 1
    pub fn one() -> Self {
        Self::whole(1)
    }

    /// A whole number.
    pub fn whole(value: i64) -> Self {
        Self::number(number::whole(value))
    }

    /// A constant.
    pub fn number(value: Rational) -> Self {
        Self::term(Monomial::ONE, value)
    }

    /// A quantity.
    pub fn var(var: Var) -> Self {
        Self::term(Monomial::of(var), number::whole(1))
    }

    fn term(monomial: Monomial, coefficient: Rational) -> Self {
        if coefficient == Rational::ZERO {
            return Self::zero();
        }
        Self {
            terms: vec![Term {
                monomial,
                coefficient,
            }],
            swollen: false,
        }
    }

    /// A polynomial of reduced terms in any order, some perhaps alike.
    pub fn from_terms(terms: impl IntoIterator<Item = Term>) -> Self {
        let mut terms: Vec<Term> = terms.into_iter().collect();
        terms.sort_unstable_by_key(|term| std::cmp::Reverse(term.monomial));
        let mut merged: Vec<Term> = Vec::with_capacity(terms.len());
        for term in terms {
            match merged.last_mut() {
                Some(last) if last.monomial == term.monomial => {
                    last.coefficient += term.coefficient
                }
                _ => merged.push(term),
            }
        }
        merged.retain(|term| term.coefficient != Rational::ZERO);
        Self {
            terms: merged,
            swollen: false,
        }
        .bounded()
    }

    fn bounded(self) -> Self {
        if self.terms.len() > MAX_TERMS {
            Self::too_large()
        } else {
            self
        }
    }

    /// What a polynomial is after it grew past all use.
    pub(crate) fn too_large() -> Self {
        Self {
            terms: Vec::new(),
            swollen: true,
        }
    }

    /// Whether it outgrew [`MAX_TERMS`].
    pub fn is_swollen(&self) -> bool {
        self.swollen
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty() && !self.swollen
    }

    /// The terms, by descending monomial.
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// The value, if no quantity is in it.
    pub fn constant(&self) -> Option<Rational> {
        match &self.terms[..] {
            [] if !self.swollen => Some(Rational::ZERO),
            [term] if term.monomial == Monomial::ONE => Some(term.coefficient.clone()),
            _ => None,
        }
    }

    /// Whether a quantity occurs.
    pub fn contains(&self, var: Var) -> bool {
        self.terms
            .iter()
            .any(|term| term.monomial.exponent(var) > 0)
    }

    /// Whether the sine or cosine of an angle occurs.
    pub fn contains_angle(&self, angle: Angle) -> bool {
        self.contains(angle.sin()) || self.contains(angle.cos())
    }

    /// Every quantity that occurs, in order.
    pub fn vars(&self) -> Vec<Var> {
        let occurs = |slot: &usize| self.terms.iter().any(|term| term.monomial.0[*slot] > 0);
        (0..SLOTS)
            .filter(occurs)
            .map(|slot| Var(slot as u8))
            .collect()
    }

    /// The greatest monomial that divides every term.
    pub fn common_monomial(&self) -> Monomial {
        let mut monomials = self.terms.iter().map(|term| term.monomial);
        let first = monomials.next().unwrap_or(Monomial::ONE);
        monomials.fold(first, |common, monomial| common.common(&monomial))
    }

    /// The coefficient of `var^exponent`, a polynomial in the other quantities.
    pub fn coefficient_of(&self, var: Var, exponent: u8) -> Self {
        let with = self
            .terms
            .iter()
            .filter(|term| term.monomial.exponent(var) == exponent);
        Self::from_terms(with.map(|term| Term {
            monomial: term.monomial.with_exponent(var, 0),
            coefficient: term.coefficient.clone(),
        }))
    }

    /// The terms for which `keep` holds, and the others.
    pub fn split(&self, keep: impl Fn(&Monomial) -> bool) -> (Self, Self) {
        let (kept, rest) = self
            .terms
            .iter()
            .cloned()
            .partition(|term| keep(&term.monomial));
        (
            Self {
                terms: kept,
                swollen: self.swollen,
            },
            Self {
                terms: rest,
                swollen: self.swollen,
            },
        )
    }

    /// The largest exponent of a quantity.
    pub fn degree_in(&self, var: Var) -> u8 {
        self.terms
            .iter()
            .map(|term| term.monomial.exponent(var))
            .max()
            .unwrap_or(0)
    }

    /// `self * factor`
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        if *factor == Rational::ZERO && !self.swollen {
            return Self::zero();
        }
        let scale = |term: &Term| Term {
            monomial: term.monomial,
            coefficient: &term.coefficient * factor,
        };
        Self {
            terms: self.terms.iter().map(scale).collect(),
            swollen: self.swollen,
        }
    }

    /// `self / monomial`, if it divides every term.
    pub fn divided(&self, monomial: &Monomial) -> Option<Self> {
        let divide = |term: &Term| {
            let monomial = term.monomial.divided(monomial)?;
            Some(Term {
                monomial,
                coefficient: term.coefficient.clone(),
            })
        };
        let terms = self.terms.iter().map(divide).collect::<Option<Vec<_>>>()?;
        Some(Self {
            terms,
            swollen: self.swollen,
        })
    }

    /// `self^exponent`
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::one(), |product, _| &product * self)
    }

    /// The polynomial with each quantity for which `image` has one replaced, all at once.
    pub fn substitute(&self, image: impl Fn(Var) -> Option<Poly>) -> Self {
        let images: Vec<(Var, Poly)> = self
            .vars()
            .into_iter()
            .filter_map(|var| image(var).map(|image| (var, image)))
            .collect();
        if images.is_empty() || self.swollen {
            return self.clone();
        }
        let mut out: Vec<Term> = Vec::new();
        for term in &self.terms {
            let mut rest = term.monomial;
            let mut product = Self::one();
            for (var, image) in &images {
                for _ in 0..rest.exponent(*var) {
                    product = &product * image;
                }
                rest = rest.with_exponent(*var, 0);
            }
            let product = &Self::term(rest, term.coefficient.clone()) * &product;
            out.extend(product.terms);
            if product.swollen || out.len() > 8 * MAX_TERMS {
                return Self::too_large();
            }
        }
        Self::from_terms(out)
    }

    /// The derivative by an angle that the polynomial depends on through its sine and cosine.
    #[must_use]
    pub fn derivative_by_angle(&self, angle: Angle) -> Self {
        let by_sin = &self.derivative(angle.sin()) * &Self::var(angle.cos());
        let by_cos = &self.derivative(angle.cos()) * &Self::var(angle.sin());
        by_sin - by_cos
    }

    /// The derivative by one quantity, the others held.
    #[must_use]
    pub fn derivative(&self, var: Var) -> Self {
        let with = self
            .terms
            .iter()
            .filter(|term| term.monomial.exponent(var) > 0);
        let terms = with.map(|term| {
            let exponent = term.monomial.exponent(var);
            Term {
                monomial: term.monomial.with_exponent(var, exponent - 1),
                coefficient: &term.coefficient * number::whole(i64::from(exponent)),
            }
        });
        Self {
            swollen: self.swollen,
            ..Self::from_terms(terms)
        }
    }

    /// The value on any scalar of the library; `value` gives each quantity's, `like` is any scalar of the kind.
    ///
    /// ```
    /// use pieper_symbolic::names::{AngleMeaning, Names};
    /// use pieper_symbolic::poly::Poly;
    /// let mut names = Names::default();
    /// let q = names.angle(AngleMeaning::Joint(0)).unwrap();
    /// let double_sine = Poly::whole(2) * Poly::var(q.sin()) * Poly::var(q.cos());
    /// let value = double_sine.evaluate(&0.0, |var| if var == q.sin() { 0.6 } else { 0.8 });
    /// assert!((value - 0.96_f64).abs() < 1e-15);
    /// ```
    pub fn evaluate<S: Scalar>(&self, like: &S, value: impl Fn(Var) -> S) -> S {
        let zero = like.constant(if self.swollen { f64::NAN } else { 0.0 });
        self.terms.iter().fold(zero, |sum, term| {
            let start = like.constant(number::to_f64(&term.coefficient));
            let product = term
                .monomial
                .powers()
                .fold(start, |product, (var, exponent)| {
                    (0..exponent).fold(product, |product, _| product * value(var))
                });
            sum + product
        })
    }
}

/// The reduced terms of a product of two monomials: squares of sines become `1 - cos^2`, those of roots numbers.
fn push_product(monomial: Monomial, mut coefficient: Rational, out: &mut Vec<Term>) {
    for (root, square) in [(Var::ROOT2, 2), (Var::ROOT3, 3)] {
        if monomial.exponent(root) > 1 {
            coefficient *= number::whole(square);
            let exponent = monomial.exponent(root) - 2;
            return push_product(monomial.with_exponent(root, exponent), coefficient, out);
        }
    }
    let squared = (0..MAX_ANGLES)
        .map(|index| Angle(index as u8))
        .find(|angle| monomial.exponent(angle.sin()) > 1);
    let Some(angle) = squared else {
        out.push(Term {
            monomial,
            coefficient,
        });
        return;
    };
    let rest = monomial.with_exponent(angle.sin(), monomial.exponent(angle.sin()) - 2);
    let cosines = rest.exponent(angle.cos());
    push_product(rest, coefficient.clone(), out);
    push_product(
        rest.with_exponent(angle.cos(), cosines.saturating_add(2)),
        -coefficient,
        out,
    );
}

impl Mul for &Poly {
    type Output = Poly;

    fn mul(self, other: &Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly::zero();
        }
        // The product of two dense polynomials of a thousand terms each is as much as anyone waits for.
        if self.swollen || other.swollen || self.terms.len() * other.terms.len() > 100 * MAX_TERMS {
            return Poly::too_large();
        }
        let mut out = Vec::with_capacity(self.terms.len() * other.terms.len());
        for a in &self.terms {
            for b in &other.terms {
                push_product(
                    a.monomial.times(&b.monomial),
                    &a.coefficient * &b.coefficient,
                    &mut out,
                );
            }
        }
        Poly::from_terms(out)
    }
}

impl Add for Poly {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.swollen || other.swollen {
            return Self::too_large();
        }
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let (mut left, mut right) = (
            self.terms.into_iter().peekable(),
            other.terms.into_iter().peekable(),
        );
        loop {
            let order = match (left.peek(), right.peek()) {
                (Some(a), Some(b)) => a.monomial.cmp(&b.monomial),
                (Some(_), None) => Ordering::Greater,
                (None, Some(_)) => Ordering::Less,
                (None, None) => break,
            };
            match order {
                Ordering::Greater => terms.extend(left.next()),
                Ordering::Less => terms.extend(right.next()),
                Ordering::Equal => {
                    if let (Some(mut a), Some(b)) = (left.next(), right.next()) {
                        a.coefficient += b.coefficient;
                        terms.extend((a.coefficient != Rational::ZERO).then_some(a));
                    }
                }
            }
        }
        Self {
            terms,
            swollen: false,
        }
        .bounded()
    }
}

impl Neg for Poly {
    type Output = Self;

    fn neg(mut self) -> Self {
        for term in &mut self.terms {
            term.coefficient = -std::mem::take(&mut term.coefficient);
        }
        self
    }
}

impl Sub for Poly {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Poly {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        &self * &other
    }
}

impl Add for &Poly {
    type Output = Poly;

    fn add(self, other: &Poly) -> Poly {
        self.clone() + other.clone()
    }
}

impl Sub for &Poly {
    type Output = Poly;

    fn sub(self, other: &Poly) -> Poly {
        self.clone() - other.clone()
    }
}

/// Runs the library's kernels on formulas.
impl Scalar for Poly {
    /// The decimal that `value` prints as; swollen for what is not finite.
    fn constant(&self, value: f64) -> Self {
        number::of_f64(value).map_or_else(Self::too_large, Self::number)
    }
}
