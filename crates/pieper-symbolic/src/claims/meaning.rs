//! What the names in a claim stand for on an arm: exactly, as polynomials, and in numbers at a sample.

use pieper::error::{Error, Place, Result};
use pieper::kinematics::kernel::Turn;

use super::ast::{Expr, Node};
use super::parse::shown;
use crate::angle;
use crate::arm::Arm;
use crate::names::{Angle, AngleMeaning};
use crate::number::{self, Rational};
use crate::poly::Poly;
use crate::transform::Transform;

/// A quotient of polynomials.
#[derive(Clone, Debug)]
pub(crate) struct Fraction {
    pub(crate) above: Poly,
    pub(crate) below: Poly,
}

impl Fraction {
    fn of(above: Poly) -> Self {
        Self {
            above,
            below: Poly::one(),
        }
    }

    /// `self - other`, over a common denominator that is left out: zero exactly where they are equal.
    pub(crate) fn difference(&self, other: &Self) -> Poly {
        &self.above * &other.below - &other.above * &self.below
    }
}

/// An angle: `pi * half_turns + sum of count * angle`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Linear {
    pub(super) half_turns: Rational,
    pub(super) terms: Vec<(Angle, Rational)>,
}

impl Linear {
    fn add(mut self, other: Self, factor: &Rational) -> Self {
        self.half_turns += other.half_turns * factor;
        for (angle, count) in other.terms {
            match self.terms.iter_mut().find(|(known, _)| *known == angle) {
                Some((_, total)) => *total += count * factor,
                None => self.terms.push((angle, count * factor)),
            }
        }
        self
    }

    /// Whether an angle of the arm is in it.
    pub(crate) fn is_variable(&self) -> bool {
        !self.terms.is_empty()
    }

    /// The turn; `None` for parts of angles, or constants off the multiples of 15 degrees.
    pub(crate) fn turn(&self) -> Option<Turn<Poly>> {
        let whole = |value: &Rational| {
            let value = value
                .is_int()
                .then(|| i64::try_from(value.numerator().clone()).ok())
                .flatten()?;
            Some(value).filter(|value| value.abs() <= 24 * 12)
        };
        let steps = whole(&(self.half_turns.clone() * number::whole(12)))?;
        self.terms
            .iter()
            .try_fold(angle::fifteen_degrees(steps), |total, (angle, count)| {
                let count = whole(count).filter(|count| count.abs() <= 12)?;
                let one = angle::turn(*angle);
                let one = if count < 0 {
                    angle::opposite(&one)
                } else {
                    one
                };
                Some((0..count.unsigned_abs()).fold(total, |total, _| angle::sum(&total, &one)))
            })
    }
}

/// What a name stands for.
pub(crate) enum Leaf {
    Poly(Poly),
    Angle(Linear),
    Matrix(Box<Transform>),
}

/// A joint that a condition holds still.
pub(crate) struct Held {
    joint: usize,
    turn: Option<Turn<Poly>>,
    slide: Option<Poly>,
    pub(crate) value: f64,
}

/// Joint values and values for the symbols.
#[derive(Clone, Debug)]
pub(crate) struct Sample {
    pub(crate) q: Vec<f64>,
    pub(crate) parameters: Vec<(String, f64)>,
}

impl Sample {
    /// The value of a polynomial of the arm.
    pub(crate) fn value(&self, arm: &Arm, poly: &Poly) -> f64 {
        let parameter = |name: &str| {
            let known = self.parameters.iter().find(|(known, _)| known == name);
            known.map_or_else(|| arm.parameter(name), |(_, value)| *value)
        };
        poly.evaluate(&0.0, |var| arm.value_at(var, &self.q, &parameter))
    }
}

/// The names of one arm in one file of claims.
pub(crate) struct Meaning<'a> {
    pub(crate) arm: &'a Arm,
    pub(crate) file: &'a str,
    pub(crate) text: &'a str,
    /// `s1`, `c23` are sines and cosines; otherwise they are names.
    pub(crate) shorthand: bool,
    pub(crate) maps: Vec<((String, String), Expr)>,
    pub(crate) pose: Transform,
}

impl Meaning<'_> {
    pub(crate) fn error(&self, expr: &Expr, expected: &str) -> Error {
        let place = Place::of_offset(self.file, self.text, expr.offset);
        Error::parse(place, format!("{:?}", shown(expr)), expected)
    }

    /// The formula as a quotient of polynomials; `Ok(None)` if it is none (a root, an inverse function).
    pub(crate) fn fraction(&self, expr: &Expr) -> Result<Option<Fraction>> {
        let both = |a: &Expr, b: &Expr| -> Result<Option<(Fraction, Fraction)>> {
            Ok(self.fraction(a)?.zip(self.fraction(b)?))
        };
        Ok(match &expr.node {
            Node::Number(value) => Some(Fraction::of(Poly::number(value.clone()))),
            Node::Name(base, index) => match self.leaf(expr, base, index)? {
                Leaf::Poly(poly) => Some(Fraction::of(poly)),
                Leaf::Matrix(_) => {
                    return Err(self.error(expr, "a number was expected, this is a matrix"));
                }
                Leaf::Angle(_) => None,
            },
            Node::Entry(base, index, row, column) => Some(Fraction::of(
                self.matrix_entry(expr, base, index, *row, *column)?,
            )),
            Node::Neg(a) => self.fraction(a)?.map(|a| Fraction {
                above: -a.above,
                below: a.below,
            }),
            Node::Add(a, b) => both(a, b)?.map(|(a, b)| Fraction {
                above: &a.above * &b.below + &b.above * &a.below,
                below: a.below * b.below,
            }),
            Node::Sub(a, b) => both(a, b)?.map(|(a, b)| Fraction {
                above: a.difference(&b),
                below: a.below * b.below,
            }),
            Node::Mul(a, b) => both(a, b)?.map(|(a, b)| Fraction {
                above: a.above * b.above,
                below: a.below * b.below,
            }),
            Node::Div(a, b) => match both(a, b)? {
                Some((_, b)) if b.above.is_zero() => {
                    return Err(self.error(expr, "this divides by zero"));
                }
                both => both.map(|(a, b)| Fraction {
                    above: a.above * b.below,
                    below: a.below * b.above,
                }),
            },
            Node::Power(a, exponent) => self.fraction(a)?.map(|a| Fraction {
                above: a.above.power(*exponent),
                below: a.below.power(*exponent),
            }),
            Node::Call(name, arguments) => self.call(expr, name, arguments)?,
            Node::Matrix(_) => {
                return Err(self.error(expr, "a number was expected, this is a matrix"));
            }
        })
    }

    fn call(&self, expr: &Expr, name: &str, arguments: &[Expr]) -> Result<Option<Fraction>> {
        if let [a, b] = arguments
            && name == "cos"
        {
            return self
                .direction_cosine(expr, a, b)
                .map(|poly| Some(Fraction::of(poly)));
        }
        if let (
            "sqrt",
            [
                Expr {
                    node: Node::Number(value),
                    ..
                },
            ],
        ) = (name, arguments)
            && let Some(root) = exact_root(value)
        {
            return Ok(Some(Fraction::of(root)));
        }
        let turn = match (name, arguments) {
            ("sin" | "cos" | "tan", [argument]) => match self.linear(argument)? {
                Some(linear) => linear.turn(),
                None => None,
            },
            _ => return Ok(None),
        };
        let Some(turn) = turn else {
            return Err(self.error(expr, "an angle made of joint variables, named angles and multiples of pi/12 was expected"));
        };
        Ok(Some(match name {
            "sin" => Fraction::of(turn.sin),
            "cos" => Fraction::of(turn.cos),
            _ => Fraction {
                above: turn.sin,
                below: turn.cos,
            },
        }))
    }

    /// The formula as an angle; `Ok(None)` if it is none.
    pub(crate) fn linear(&self, expr: &Expr) -> Result<Option<Linear>> {
        let one = number::whole(1);
        Ok(match &expr.node {
            Node::Number(value) => (*value == Rational::ZERO).then(Linear::default),
            Node::Name(base, index) => match self.leaf(expr, base, index)? {
                Leaf::Angle(linear) => Some(linear),
                Leaf::Poly(_) | Leaf::Matrix(_) => None,
            },
            Node::Neg(a) => self.linear(a)?.map(|a| Linear::default().add(a, &-one)),
            Node::Add(a, b) => self
                .linear(a)?
                .zip(self.linear(b)?)
                .map(|(a, b)| a.add(b, &one)),
            Node::Sub(a, b) => self
                .linear(a)?
                .zip(self.linear(b)?)
                .map(|(a, b)| a.add(b, &-one)),
            Node::Mul(a, b) => match (&a.node, &b.node) {
                (Node::Number(value), _) => {
                    self.linear(b)?.map(|b| Linear::default().add(b, value))
                }
                (_, Node::Number(value)) => {
                    self.linear(a)?.map(|a| Linear::default().add(a, value))
                }
                _ => None,
            },
            Node::Div(a, b) => match &b.node {
                Node::Number(value) if *value != Rational::ZERO => self
                    .linear(a)?
                    .map(|a| Linear::default().add(a, &(one / value))),
                _ => None,
            },
            _ => None,
        })
    }

    /// A named or written matrix, by rows of polynomials; `Ok(None)` if the formula is none.
    pub(crate) fn matrix(&self, expr: &Expr) -> Result<Option<Vec<Vec<Poly>>>> {
        let rows_of = |transform: &Transform| {
            (0..4)
                .map(|row| (0..4).map(|column| transform.entry(row, column)).collect())
                .collect()
        };
        match &expr.node {
            Node::Name(base, index) => match self.leaf(expr, base, index)? {
                Leaf::Matrix(transform) => Ok(Some(rows_of(&transform))),
                _ => Ok(None),
            },
            _ => Ok(None),
        }
    }

    /// Which joint and value a condition holds still.
    pub(crate) fn held(&self, left: &Expr, right: &Expr) -> Result<Held> {
        let words = "a joint variable was expected, as in: when q5 = 0";
        if let Some(linear) = self.linear(left)?
            && let [(angle, count)] = &linear.terms[..]
            && *count == number::whole(1)
            && linear.half_turns == Rational::ZERO
            && let AngleMeaning::Joint(joint) = self.arm.names.meaning(*angle)
        {
            let value = self.linear(right)?.filter(|value| !value.is_variable());
            let turn = value.as_ref().and_then(Linear::turn);
            let Some((value, turn)) = value.zip(turn) else {
                return Err(self.error(right, "a multiple of pi/12 was expected"));
            };
            let value = number::to_f64(&value.half_turns) * std::f64::consts::PI;
            return Ok(Held {
                joint: *joint,
                turn: Some(turn),
                slide: None,
                value,
            });
        }
        let slide = match &left.node {
            Node::Name(base, index) => match self.leaf(left, base, index)? {
                Leaf::Poly(poly) => poly.vars().first().copied(),
                _ => None,
            },
            _ => None,
        };
        let joint = slide.and_then(|var| self.arm.names.joint_of(var));
        let value = self
            .fraction(right)?
            .and_then(|value| value.above.constant());
        match (joint, value) {
            (Some(joint), Some(value)) => {
                let number = number::to_f64(&value);
                Ok(Held {
                    joint,
                    turn: None,
                    slide: Some(Poly::number(value)),
                    value: number,
                })
            }
            _ => Err(self.error(left, words)),
        }
    }

    /// The polynomial while conditions hold.
    pub(crate) fn under(&self, held: &[Held], poly: &Poly) -> Poly {
        poly.substitute(|var| {
            let joint = self.arm.names.joint_of(var)?;
            let held = held.iter().find(|held| held.joint == joint)?;
            match (&held.turn, &held.slide) {
                (Some(turn), _) if var.angle().is_some_and(|angle| angle.sin() == var) => {
                    Some(turn.sin.clone())
                }
                (Some(turn), _) => Some(turn.cos.clone()),
                (None, slide) => slide.clone(),
            }
        })
    }

    pub(crate) fn hold(&self, held: &[Held], sample: &mut Sample) {
        held.iter()
            .for_each(|held| sample.q[held.joint] = held.value);
    }

    pub(super) fn matrix_entry(
        &self,
        expr: &Expr,
        base: &str,
        index: &str,
        row: usize,
        column: usize,
    ) -> Result<Poly> {
        if base == "J" && index.is_empty() {
            return self.jacobian_entry(expr, row, column);
        }
        match self.leaf(expr, base, index)? {
            Leaf::Matrix(transform) if (1..=4).contains(&row) && (1..=4).contains(&column) => {
                Ok(transform.entry(row - 1, column - 1))
            }
            Leaf::Matrix(_) => {
                Err(self.error(expr, "a row and a column from 1 to 4 were expected"))
            }
            _ => Err(self.error(expr, "a matrix was expected: A1, A2, ..., T6, R36, J")),
        }
    }

    fn jacobian_entry(&self, expr: &Expr, row: usize, column: usize) -> Result<Poly> {
        if !((1..=6).contains(&row) && (1..=self.arm.dof()).contains(&column)) {
            let text = format!(
                "a row from 1 to 6 and a column from 1 to {} were expected",
                self.arm.dof()
            );
            return Err(self.error(expr, &text));
        }
        Ok(crate::jacobian::in_base(self.arm).0[row - 1][column - 1].clone())
    }

    /// `cos(i_n, k_0)`: the cosine of the angle between an axis of the tool and one of the base.
    fn direction_cosine(&self, expr: &Expr, a: &Expr, b: &Expr) -> Result<Poly> {
        let axis = |expr: &Expr| match &expr.node {
            Node::Name(base, index) => {
                let axis = ["i", "j", "k"].iter().position(|known| known == base)?;
                Some((axis, index != "0"))
            }
            _ => None,
        };
        match (axis(a), axis(b)) {
            (Some((tool, true)), Some((base, false))) | (Some((base, false)), Some((tool, true))) => {
                Ok(self.pose.entry(base, tool))
            }
            _ => Err(self.error(expr, "an axis of the tool (i_n, j_n, k_n) and one of the base (i_0, j_0, k_0) were expected")),
        }
    }

    /// The value at a sample, of any formula.
    pub(crate) fn value(&self, expr: &Expr, sample: &Sample) -> Result<f64> {
        let value = |part: &Expr| self.value(part, sample);
        Ok(match &expr.node {
            Node::Number(number) => number::to_f64(number),
            Node::Neg(a) => -value(a)?,
            Node::Add(a, b) => value(a)? + value(b)?,
            Node::Sub(a, b) => value(a)? - value(b)?,
            Node::Mul(a, b) => value(a)? * value(b)?,
            Node::Div(a, b) => value(a)? / value(b)?,
            Node::Power(a, exponent) => value(a)?.powi(*exponent as i32),
            Node::Call(name, arguments) => match (name.as_str(), &arguments[..]) {
                ("cos", [a, b]) => sample.value(self.arm, &self.direction_cosine(expr, a, b)?),
                ("sin", [a]) => value(a)?.sin(),
                ("cos", [a]) => value(a)?.cos(),
                ("tan", [a]) => value(a)?.tan(),
                ("asin", [a]) => value(a)?.asin(),
                ("acos", [a]) => value(a)?.acos(),
                ("atan", [a]) => value(a)?.atan(),
                ("atan2", [a, b]) => value(a)?.atan2(value(b)?),
                ("sqrt", [a]) => value(a)?.sqrt(),
                ("abs", [a]) => value(a)?.abs(),
                _ => return Err(self.error(expr, "a function of numbers was expected")),
            },
            Node::Name(base, index) => match self.leaf(expr, base, index)? {
                Leaf::Poly(poly) => sample.value(self.arm, &poly),
                Leaf::Angle(linear) => self.angle_value(&linear, sample),
                Leaf::Matrix(_) => {
                    return Err(self.error(expr, "a number was expected, this is a matrix"));
                }
            },
            Node::Entry(base, index, row, column) => sample.value(
                self.arm,
                &self.matrix_entry(expr, base, index, *row, *column)?,
            ),
            Node::Matrix(_) => {
                return Err(self.error(expr, "a number was expected, this is a matrix"));
            }
        })
    }

    pub(crate) fn angle_value(&self, linear: &Linear, sample: &Sample) -> f64 {
        let one = |angle: Angle| match self.arm.names.meaning(angle) {
            AngleMeaning::Joint(joint) => sample.q[*joint],
            _ => {
                let (sin, cos) = (Poly::var(angle.sin()), Poly::var(angle.cos()));
                sample
                    .value(self.arm, &sin)
                    .atan2(sample.value(self.arm, &cos))
            }
        };
        let constant = number::to_f64(&linear.half_turns) * std::f64::consts::PI;
        linear.terms.iter().fold(constant, |sum, (angle, count)| {
            sum + number::to_f64(count) * one(*angle)
        })
    }
}

/// The roots that sines of multiples of 15 degrees are made of.
fn exact_root(value: &Rational) -> Option<Poly> {
    let (two, three) = (
        Poly::var(crate::names::Var::ROOT2),
        Poly::var(crate::names::Var::ROOT3),
    );
    [(2, two.clone()), (3, three.clone()), (6, two * three)]
        .into_iter()
        .find_map(|(square, root)| (*value == number::whole(square)).then_some(root))
}

/// Row and column of an index of two digits from 1 to 4.
pub(crate) fn entry_index(index: &str) -> Option<(usize, usize)> {
    match index.as_bytes() {
        [row @ b'1'..=b'4', column @ b'1'..=b'4'] => {
            Some((usize::from(row - b'0'), usize::from(column - b'0')))
        }
        _ => None,
    }
}
