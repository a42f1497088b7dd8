//! A table's entries as exact formulas.

use pieper::describe::expr::{Expr, Operator, Unit};
use pieper::describe::robot::Parameter;
use pieper::kinematics::kernel::Turn;
use pieper::{Error, Result};

use crate::angle;
use crate::arm::Lengths;
use crate::names::{AngleMeaning, Names, SymbolMeaning};
use crate::number::{self, Rational};
use crate::poly::Poly;

/// Reads entries of one table, naming what they need.
pub(crate) struct Entries<'a> {
    pub(crate) names: &'a mut Names,
    pub(crate) parameters: &'a [Parameter],
    pub(crate) lengths: Lengths,
}

/// An angle as `pi * turns + radians + sum of count * parameter`.
#[derive(Default)]
struct AngleSum {
    half_turns: Rational,
    radians: f64,
    parameters: Vec<(String, i64)>,
}

/// A constant angle this near a multiple of 15 degrees is one: a few roundings of values up to 2 pi.
const SAME_ANGLE: f64 = 4e-15;

/// Multiples of a named angle beyond this are a mistake.
const MAX_MULTIPLE: i64 = 12;

impl Entries<'_> {
    fn too_many(what: &str) -> Error {
        Error::model(
            "table",
            format!("it has more {what} than formulas have room for"),
        )
    }

    /// The value a parameter is replaced by, if it is.
    fn value_of(&self, name: &str) -> Option<Expr> {
        let known = self
            .parameters
            .iter()
            .find(|parameter| parameter.name == name);
        let value = known.and_then(|parameter| parameter.value.clone());
        value.filter(|_| self.lengths == Lengths::Numbers)
    }

    /// A length.
    pub(crate) fn length(&mut self, expr: &Expr) -> Result<Poly> {
        match self.polynomial(expr, 0)? {
            Some(poly) => Ok(poly),
            None => self.named_formula(expr),
        }
    }

    /// A formula that is no polynomial gets a name of its own.
    fn named_formula(&mut self, expr: &Expr) -> Result<Poly> {
        let text = expr.to_string();
        let known = self.names.symbols().find_map(|(var, _, meaning)| {
            (*meaning == SymbolMeaning::Formula(text.clone())).then_some(var)
        });
        let count = self
            .names
            .symbols()
            .filter(|(.., m)| matches!(m, SymbolMeaning::Formula(_)))
            .count();
        let var = match known {
            Some(var) => Some(var),
            None => self
                .names
                .symbol(&format!("k{}", count + 1), SymbolMeaning::Formula(text)),
        };
        var.map(Poly::var).ok_or_else(|| Self::too_many("symbols"))
    }

    /// The entry as a polynomial in numbers and parameters; `None` if it is none.
    fn polynomial(&mut self, expr: &Expr, depth: usize) -> Result<Option<Poly>> {
        if depth > MAX_DEPTH {
            return Err(Error::model(
                format!("\"{expr}\""),
                "its parameters lead in a circle",
            ));
        }
        Ok(match expr {
            Expr::Number(value, unit) => {
                let scale = match unit {
                    Unit::Centimetre => number::ratio(1, 100),
                    Unit::Millimetre => number::ratio(1, 1000),
                    Unit::None | Unit::Metre => number::whole(1),
                    Unit::Radian | Unit::Degree => return Ok(None),
                };
                number::of_f64(*value).map(|value| Poly::number(value * scale))
            }
            Expr::Pi | Expr::Call(..) => None,
            Expr::Symbol(name) => match self.value_of(name) {
                Some(value) => return self.polynomial(&value, depth + 1),
                None => {
                    let var = self.names.symbol(name, SymbolMeaning::Parameter);
                    Some(Poly::var(var.ok_or_else(|| Self::too_many("symbols"))?))
                }
            },
            Expr::Neg(inner) => self.polynomial(inner, depth + 1)?.map(|poly| -poly),
            Expr::Binary(operator, left, right) => {
                let left = self.polynomial(left, depth + 1)?;
                let right = self.polynomial(right, depth + 1)?;
                let (Some(left), Some(right)) = (left, right) else {
                    return Ok(None);
                };
                combine(*operator, &left, &right)
            }
        })
    }

    /// The turn by an angle of the table.
    pub(crate) fn angle(&mut self, expr: &Expr) -> Result<Turn<Poly>> {
        let mut sum = AngleSum::default();
        if !self.collect(expr, &number::whole(1), &mut sum, 0)? {
            return self.opaque_angle(expr);
        }
        let constant = self.constant_angle(&sum)?;
        let mut total = constant;
        for (name, count) in sum.parameters.iter().filter(|(_, count)| *count != 0) {
            let angle = self.names.angle(AngleMeaning::Parameter(name.clone()));
            let mut one = angle::turn(angle.ok_or_else(|| Self::too_many("angles"))?);
            if *count < 0 {
                one = angle::opposite(&one);
            }
            for _ in 0..count.unsigned_abs() {
                total = angle::sum(&total, &one);
            }
        }
        Ok(total)
    }

    fn constant_angle(&mut self, sum: &AngleSum) -> Result<Turn<Poly>> {
        let steps = sum.half_turns.clone() * number::whole(12);
        if sum.radians == 0.0
            && steps.is_int()
            && let Ok(steps) = i64::try_from(steps.numerator().clone())
        {
            return Ok(angle::fifteen_degrees(steps));
        }
        let value = number::to_f64(&sum.half_turns) * std::f64::consts::PI + sum.radians;
        let step = std::f64::consts::PI / 12.0;
        let steps = (value / step).round();
        if (value - steps * step).abs() <= SAME_ANGLE * value.abs().max(1.0) {
            return Ok(angle::fifteen_degrees(steps as i64));
        }
        let text = match sum.radians == 0.0 {
            true => format!("{}*pi", number::text(&number::magnitude(&sum.half_turns))),
            false => format!("{}", value.abs()),
        };
        self.named_constant(text, value)
    }

    fn named_constant(&mut self, text: String, value: f64) -> Result<Turn<Poly>> {
        let angle = self.names.angle(AngleMeaning::Constant(text, value.abs()));
        let turn = angle::turn(angle.ok_or_else(|| Self::too_many("angles"))?);
        Ok(if value < 0.0 {
            angle::opposite(&turn)
        } else {
            turn
        })
    }

    /// An angle that is no sum of multiples of pi, numbers and named angles: a constant of its value.
    fn opaque_angle(&mut self, expr: &Expr) -> Result<Turn<Poly>> {
        let mut values = pieper::describe::expr::Values::new();
        for parameter in self.parameters {
            if let Some(Ok(value)) = parameter
                .value
                .as_ref()
                .map(|value| value.evaluate(&values))
            {
                values.insert(parameter.name.clone(), value);
            }
        }
        let value = expr.evaluate(&values)?;
        self.named_constant(expr.to_string(), value)
    }

    /// Adds `factor * expr` to the sum; false if it does not fit into one.
    fn collect(
        &self,
        expr: &Expr,
        factor: &Rational,
        sum: &mut AngleSum,
        depth: usize,
    ) -> Result<bool> {
        if depth > MAX_DEPTH {
            return Err(Error::model(
                format!("\"{expr}\""),
                "its parameters lead in a circle",
            ));
        }
        match expr {
            Expr::Number(value, Unit::Degree) => {
                let Some(degrees) = number::of_f64(*value) else {
                    return Ok(false);
                };
                sum.half_turns += degrees * factor * number::ratio(1, 180);
            }
            Expr::Number(value, Unit::None | Unit::Radian) => {
                sum.radians += value * number::to_f64(factor)
            }
            Expr::Number(..) | Expr::Call(..) => return Ok(false),
            Expr::Pi => sum.half_turns += factor,
            Expr::Symbol(name) => match self.value_of(name) {
                Some(value) => return self.collect(&value, factor, sum, depth + 1),
                None => {
                    let count = factor.clone();
                    let Some(count) = count
                        .is_int()
                        .then(|| i64::try_from(count.numerator().clone()).ok())
                        .flatten()
                    else {
                        return Ok(false);
                    };
                    if count.abs() > MAX_MULTIPLE {
                        return Ok(false);
                    }
                    match sum.parameters.iter_mut().find(|(known, _)| known == name) {
                        Some((_, total)) => *total += count,
                        None => sum.parameters.push((name.clone(), count)),
                    }
                }
            },
            Expr::Neg(inner) => return self.collect(inner, &-factor.clone(), sum, depth + 1),
            Expr::Binary(Operator::Add, left, right) => {
                return Ok(self.collect(left, factor, sum, depth + 1)?
                    && self.collect(right, factor, sum, depth + 1)?);
            }
            Expr::Binary(Operator::Sub, left, right) => {
                return Ok(self.collect(left, factor, sum, depth + 1)?
                    && self.collect(right, &-factor.clone(), sum, depth + 1)?);
            }
            Expr::Binary(Operator::Mul, left, right) => match (pure(left), pure(right)) {
                (Some(number), _) => {
                    return self.collect(right, &(number * factor), sum, depth + 1);
                }
                (_, Some(number)) => return self.collect(left, &(number * factor), sum, depth + 1),
                _ => return Ok(false),
            },
            Expr::Binary(Operator::Div, left, right) => {
                match pure(right).filter(|n| *n != Rational::ZERO) {
                    Some(number) => return self.collect(left, &(factor / number), sum, depth + 1),
                    None => return Ok(false),
                }
            }
            Expr::Binary(Operator::Pow, ..) => return Ok(false),
        }
        Ok(true)
    }
}

/// Parameters refer to one another at most this deep.
const MAX_DEPTH: usize = 100;

/// A pure number.
fn pure(expr: &Expr) -> Option<Rational> {
    match expr {
        Expr::Number(value, Unit::None) => number::of_f64(*value),
        Expr::Neg(inner) => pure(inner).map(|value| -value),
        _ => None,
    }
}

fn combine(operator: Operator, left: &Poly, right: &Poly) -> Option<Poly> {
    Some(match operator {
        Operator::Add => left + right,
        Operator::Sub => left - right,
        Operator::Mul => left * right,
        Operator::Div => {
            let divisor = right.constant().filter(|value| *value != Rational::ZERO)?;
            left.scaled(&(number::whole(1) / divisor))
        }
        Operator::Pow => {
            let exponent = right.constant().filter(Rational::is_int)?;
            let exponent = u32::try_from(exponent.numerator().clone())
                .ok()
                .filter(|e| *e <= 8)?;
            left.power(exponent)
        }
    })
}
