//! The joint variable of a row: `offset + q` or `offset - q`.

use super::{Expr, Operator, Unit};

/// A formula split at a symbol: `offset + sign * symbol`.
#[derive(Clone, Debug, PartialEq)]
pub struct Linear {
    /// +1 or -1.
    pub sign: f64,
    /// What is left; the number 0 if nothing is.
    pub offset: Expr,
}

impl Expr {
    /// The formula as `offset + q` or `offset - q` for the symbol `q`; `None` if it does not have that form.
    ///
    /// ```
    /// use pieper::describe::expr::Expr;
    /// let linear = Expr::parse("pi/2 - q3")?.split_at("q3").unwrap();
    /// assert_eq!((linear.sign, linear.offset.to_string().as_str()), (-1.0, "pi/2"));
    /// assert!(Expr::parse("2*q3")?.split_at("q3").is_none());
    /// # Ok::<(), pieper::Error>(())
    /// ```
    pub fn split_at(&self, symbol: &str) -> Option<Linear> {
        let mut terms = Vec::new();
        collect(self, false, &mut terms);
        let is_symbol = |expr: &Expr| matches!(expr, Expr::Symbol(name) if name == symbol);
        let position = terms.iter().position(|(_, term)| is_symbol(term))?;
        let (negative, _) = terms.remove(position);
        if terms
            .iter()
            .any(|(_, term)| term.symbols().contains(&symbol))
        {
            return None;
        }
        let offset = terms
            .into_iter()
            .fold(None, |sum: Option<Expr>, (negative, term)| {
                Some(match (sum, negative) {
                    (None, false) => term.clone(),
                    (None, true) => Expr::Neg(Box::new(term.clone())),
                    (Some(sum), _) => {
                        let operator = if negative {
                            Operator::Sub
                        } else {
                            Operator::Add
                        };
                        Expr::Binary(operator, Box::new(sum), Box::new(term.clone()))
                    }
                })
            });
        // A zero of any unit is nothing: it is not written, and must read as what is not there.
        let offset = offset.filter(|offset| !offset.is_zero());
        let offset = offset.unwrap_or(Expr::Number(0.0, Unit::None));
        Some(Linear {
            sign: if negative { -1.0 } else { 1.0 },
            offset,
        })
    }
}

/// `offset + symbol` or `offset - symbol`: what [`Expr::split_at`] takes apart.
pub(in crate::describe) fn with_variable(offset: &Expr, symbol: &str, sign: f64) -> Expr {
    let symbol = Box::new(Expr::Symbol(symbol.to_owned()));
    match (offset.is_zero(), sign < 0.0) {
        (true, false) => *symbol,
        (true, true) => Expr::Neg(symbol),
        (false, negative) => {
            let operator = if negative {
                Operator::Sub
            } else {
                Operator::Add
            };
            Expr::Binary(operator, Box::new(offset.clone()), symbol)
        }
    }
}

/// The signed terms of a sum.
fn collect<'a>(expr: &'a Expr, negative: bool, terms: &mut Vec<(bool, &'a Expr)>) {
    match expr {
        Expr::Neg(inner) => collect(inner, !negative, terms),
        Expr::Binary(Operator::Add, left, right) => {
            collect(left, negative, terms);
            collect(right, negative, terms);
        }
        Expr::Binary(Operator::Sub, left, right) => {
            collect(left, negative, terms);
            collect(right, !negative, terms);
        }
        term => terms.push((negative, term)),
    }
}
