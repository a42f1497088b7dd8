//! Syntax trees into values.

use super::expander::{Expander, Site};
use super::expr::{Access, Binary, Compare, Expr};
use super::function;
use super::operator;
use super::scope::{Entry, GLOBAL};
use super::value::{Outcome, Value};
use super::yaml;
use crate::error::{Error, Place, Result};

impl Expander<'_> {
    fn name(&mut self, name: &str, site: &Site<'_>) -> Result<Value> {
        if let Some(value) = self.property(name, site)? {
            return Ok(value);
        }
        function::constant(name)
            .ok_or_else(|| site.error(format!("there is no property or constant {name} here")))
    }

    /// The value of an expression.
    pub(super) fn eval(&mut self, expr: &Expr, site: &Site<'_>) -> Result<Value> {
        self.enter(&site.spot)?;
        self.charge(10, &site.spot)?;
        let value = self.eval_inner(expr, site)?;
        self.leave();
        Ok(value)
    }

    fn eval_inner(&mut self, expr: &Expr, site: &Site<'_>) -> Result<Value> {
        // Every arm that needs room has a function of its own: this one is on the stack many times over.
        match expr {
            Expr::Int(value) => Ok(Value::Int(*value)),
            Expr::Float(value) => Ok(Value::Float(*value)),
            Expr::Str(text) => Value::str(text.as_str()).map_err(|message| site.error(message)),
            Expr::Name(name) => self.name(name, site),
            Expr::List(items) => {
                let items = self.eval_all(items, site)?;
                Value::list(items).map_err(|message| site.error(message))
            }
            Expr::Dict(entries) => self.dict(entries, site),
            Expr::Chain(first, rest) => self.chain(first, rest, site),
            Expr::Compare(first, rest) => self.comparison(first, rest, site),
            Expr::And(items) => self.first_with_truth(items, false, site),
            Expr::Or(items) => self.first_with_truth(items, true, site),
            Expr::Not(operand) | Expr::Negative(operand) | Expr::Positive(operand) => {
                let value = self.eval(operand, site)?;
                let outcome = match expr {
                    Expr::Not(_) => Ok(Value::Bool(!value.truth())),
                    Expr::Negative(_) => operator::negative(&value),
                    _ => operator::positive(value),
                };
                outcome.map_err(|message| site.error(message))
            }
            Expr::If {
                then,
                condition,
                otherwise,
            } => {
                let holds = self.eval(condition, site)?.truth();
                self.eval(if holds { then } else { otherwise }, site)
            }
            Expr::Access(operand, rest) => self.access(operand, rest, site),
        }
    }

    fn dict(&mut self, entries: &[(Expr, Expr)], site: &Site<'_>) -> Result<Value> {
        let mut values = Vec::with_capacity(entries.len());
        for (key, value) in entries {
            values.push((self.eval(key, site)?, self.eval(value, site)?));
        }
        Value::dict(values).map_err(|message| site.error(message))
    }

    fn chain(&mut self, first: &Expr, rest: &[(Binary, Expr)], site: &Site<'_>) -> Result<Value> {
        let mut value = self.eval(first, site)?;
        for (operator, operand) in rest {
            let operand = self.eval(operand, site)?;
            self.charge_values(&[&value, &operand], &site.spot)?;
            value = operator::binary(*operator, &value, &operand)
                .map_err(|message| site.error(message))?;
        }
        Ok(value)
    }

    fn eval_all(&mut self, items: &[Expr], site: &Site<'_>) -> Result<Vec<Value>> {
        items.iter().map(|item| self.eval(item, site)).collect()
    }

    fn comparison(
        &mut self,
        first: &Expr,
        rest: &[(Compare, Expr)],
        site: &Site<'_>,
    ) -> Result<Value> {
        let mut left = self.eval(first, site)?;
        for (operator, right) in rest {
            let right = self.eval(right, site)?;
            self.charge_values(&[&left, &right], &site.spot)?;
            let holds = operator::compare(*operator, &left, &right).map_err(|m| site.error(m))?;
            if !holds {
                return Ok(Value::Bool(false));
            }
            left = right;
        }
        Ok(Value::Bool(true))
    }

    /// The first item that counts as `truth`, or else the last.
    fn first_with_truth(&mut self, items: &[Expr], truth: bool, site: &Site<'_>) -> Result<Value> {
        let mut value = Value::Bool(!truth);
        for item in items {
            value = self.eval(item, site)?;
            if value.truth() == truth {
                break;
            }
        }
        Ok(value)
    }

    /// `operand.name(argument)[index]` and so on.
    fn access(&mut self, operand: &Expr, rest: &[Access], site: &Site<'_>) -> Result<Value> {
        let (mut value, mut rest) = self.operand(operand, rest, site)?;
        loop {
            let outcome;
            (outcome, rest) = match rest {
                [] => return Ok(value),
                [
                    Access::Attribute(name),
                    Access::Call(plain, named),
                    after @ ..,
                ] => (self.method(&value, name, plain, named, site)?, after),
                [access, after @ ..] => (self.part(&value, access, site)?, after),
            };
            value = outcome.map_err(|message| site.error(message))?;
        }
    }

    fn method(
        &mut self,
        value: &Value,
        name: &str,
        plain: &[Expr],
        named: &[(String, Expr)],
        site: &Site<'_>,
    ) -> Result<Outcome<Value>> {
        if let Some((word, _)) = named.first() {
            return Err(site.error(format!("the argument {word}= of {name}() is not known")));
        }
        let args = self.eval_all(plain, site)?;
        let weights: Vec<&Value> = std::iter::once(value).chain(&args).collect();
        self.charge_values(&weights, &site.spot)?;
        Ok(function::method(value, name, &args))
    }

    fn part(&mut self, value: &Value, access: &Access, site: &Site<'_>) -> Result<Outcome<Value>> {
        self.charge_values(&[value], &site.spot)?;
        Ok(match access {
            Access::Attribute(name) => match value {
                Value::Dict(_) => {
                    Value::str(name.as_str()).and_then(|key| operator::index(value, &key))
                }
                _ => Err(format!("{} has no part {name}", value.described())),
            },
            Access::Index(index) => operator::index(value, &self.eval(index, site)?),
            Access::Slice(start, end) => {
                let mut bound = |bound: &Option<Expr>| {
                    bound
                        .as_ref()
                        .map(|bound| self.eval(bound, site))
                        .transpose()
                };
                let (start, end) = (bound(start)?, bound(end)?);
                operator::slice(value, start.as_ref(), end.as_ref())
            }
            Access::Call(..) => Err(format!("{} is no function", value.described())),
        })
    }

    /// The value that an access begins with, which for a function or namespace takes more than the operand, and what is
    /// left to do.
    fn operand<'e>(
        &mut self,
        operand: &Expr,
        rest: &'e [Access],
        site: &Site<'_>,
    ) -> Result<(Value, &'e [Access])> {
        let Expr::Name(name) = operand else {
            return Ok((self.eval(operand, site)?, rest));
        };
        match (self.scopes.find(site.scope, name), rest) {
            (Some((_, &Entry::Namespace(inner))), [Access::Attribute(name), rest @ ..]) => {
                let inner = Site {
                    spot: site.spot.clone(),
                    text: site.text,
                    scope: inner,
                };
                Ok((self.name(name, &inner)?, rest))
            }
            (Some(_), _) => Ok((self.name(name, site)?, rest)),
            (None, [Access::Attribute(inner), after @ ..]) if is_module(name) => match after {
                [Access::Call(plain, named), after @ ..] => {
                    Ok((self.call(inner, plain, named, site)?, after))
                }
                _ => match function::constant(inner) {
                    Some(value) => Ok((value, after)),
                    None => Err(site.error(format!("there is no constant {name}.{inner}"))),
                },
            },
            (None, [Access::Call(plain, named), after @ ..]) => {
                Ok((self.call(name, plain, named, site)?, after))
            }
            (None, _) => Ok((self.name(name, site)?, rest)),
        }
    }

    fn call(
        &mut self,
        name: &str,
        plain: &[Expr],
        named: &[(String, Expr)],
        site: &Site<'_>,
    ) -> Result<Value> {
        let args = self.eval_all(plain, site)?;
        let weights: Vec<&Value> = args.iter().collect();
        self.charge_values(&weights, &site.spot)?;
        if let (Some((word, _)), false) = (named.first(), name == "dict") {
            return Err(site.error(format!("the argument {word}= of {name}() is not known")));
        }
        let outcome = match (name, args.as_slice()) {
            ("dict", _) if !named.is_empty() => {
                let mut entries = match args.first() {
                    Some(Value::Dict(dict)) => dict.entries.clone(),
                    _ => Vec::new(),
                };
                for (key, value) in named {
                    let key = Value::str(key.as_str()).map_err(|m| site.error(m))?;
                    entries.push((key, self.eval(value, site)?));
                }
                Value::dict(entries)
            }
            ("load_yaml", [Value::Str(path)]) => return self.load_yaml(path, site),
            ("arg", [Value::Str(name)]) => Value::str(self.argument(name, site)?),
            ("abs_filename", [Value::Str(path)]) => Value::str(self.path(path)),
            ("dotify", [value]) => Ok(value.clone()),
            ("tokenize", [Value::Str(text)]) => text
                .split([',', ';', ' '])
                .filter(|word| !word.is_empty())
                .map(Value::str)
                .collect::<Outcome<_>>()
                .and_then(Value::list),
            ("message" | "warning" | "error" | "print_location", _) => Value::str(""),
            ("fatal", _) => {
                let words: Vec<String> = args.iter().map(Value::text).collect();
                Err(format!("the description gives up: {}", words.join(" ")))
            }
            _ => function::call(name, &args)
                .unwrap_or_else(|| Err(format!("there is no function {name}()"))),
        };
        outcome.map_err(|message| site.error(message))
    }

    fn load_yaml(&mut self, path: &str, site: &Site<'_>) -> Result<Value> {
        let path = self.path(path);
        let text = self.read(&path, &site.spot)?;
        let outside = Site {
            spot: site.spot.clone(),
            text: site.text,
            scope: GLOBAL,
        };
        let mut evaluate = |text: &str| {
            self.source(text, &outside)
                .map_err(|error| error.to_string())
        };
        yaml::load(&text, &mut evaluate).map_err(|(line, column, message)| {
            let place = Place {
                file: path.clone(),
                line,
                column,
            };
            Error::parse(place, "YAML", message)
        })
    }
}

fn is_module(name: &str) -> bool {
    ["math", "xacro", "python"].contains(&name)
}
