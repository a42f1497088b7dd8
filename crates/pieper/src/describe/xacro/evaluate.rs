//! Texts, properties and `$(...)` into values.

use super::expander::{Expander, Site};
use super::scope::Entry;
use super::syntax;
use super::text::{self, Piece};
use super::value::Value;
use crate::describe::urdf::xml::{Attribute, Spot};
use crate::error::{Error, Result};

impl Expander<'_> {
    /// The value of an attribute.
    pub(super) fn attribute(&mut self, attribute: &Attribute, scope: usize) -> Result<Value> {
        self.text(&attribute.value, &attribute.spot, scope)
    }

    /// The value of a text: of a single expression its value, else text.
    pub(super) fn text(&mut self, text: &str, spot: &Spot, scope: usize) -> Result<Value> {
        self.charge(text.len(), spot)?;
        let pieces = text::pieces(text).map_err(|at| {
            let close = if text[at..].starts_with("${") {
                '}'
            } else {
                ')'
            };
            spot.plus(at)
                .error(text, format!("the closing {close} is missing"))
        })?;
        let mut values = Vec::with_capacity(pieces.len());
        for piece in pieces {
            values.push(match piece {
                Piece::Plain(plain) => Value::str(plain).map_err(|m| spot.error(text, m))?,
                Piece::Expression(inner, at) => self.expression(inner, &spot.plus(at), scope)?,
                Piece::Command(inner, at) => self.command(inner, &spot.plus(at), scope)?,
            });
        }
        if values.len() == 1 {
            return Ok(values.swap_remove(0));
        }
        let joined: String = values.iter().map(Value::text).collect();
        self.charge(joined.len(), spot)?;
        Value::str(joined).map_err(|message| spot.error(text, message))
    }

    /// `${text}`.
    fn expression(&mut self, text: &str, spot: &Spot, scope: usize) -> Result<Value> {
        self.enter(spot)?;
        let inner = if text.contains('$') {
            self.text(text, spot, scope)?.text()
        } else {
            text.to_owned()
        };
        let subject = format!("${{{text}}}");
        let site = Site {
            spot: spot.clone(),
            text: &subject,
            scope,
        };
        let value = self.source(&inner, &site)?;
        self.leave();
        Ok(value)
    }

    /// The value of an expression's text.
    pub(super) fn source(&mut self, text: &str, site: &Site<'_>) -> Result<Value> {
        self.charge(10 * text.len(), &site.spot)?;
        let expr = syntax::parse(text).map_err(|message| site.error(message))?;
        self.eval(&expr, site)
    }

    /// `$(text)`.
    fn command(&mut self, text: &str, spot: &Spot, scope: usize) -> Result<Value> {
        self.enter(spot)?;
        let subject = format!("$({text})");
        let inner = self.text(text, spot, scope)?.text();
        let site = Site {
            spot: spot.clone(),
            text: &subject,
            scope,
        };
        let words: Vec<&str> = inner.split_whitespace().collect();
        let value = match words[..] {
            ["arg", name] => self.argument(name, &site)?,
            ["find", name] => self.package(name, &site)?,
            ["env", name] => self.resources.environment(name).ok_or_else(|| {
                let text = "there is no environment variable of this name";
                Error::resource(&subject, text).at(spot.place())
            })?,
            ["optenv", name, ref default @ ..] => {
                let value = self.resources.environment(name);
                value.unwrap_or_else(|| default.join(" "))
            }
            ["dirname"] => self.folder().unwrap_or(".").to_owned(),
            ["eval", ..] => {
                let source = inner.trim_start().trim_start_matches("eval");
                let value = self.source(source, &site)?;
                self.leave();
                return Ok(value);
            }
            _ => {
                let text = "$(arg name), $(find package), $(env name), $(optenv name default), \
                            $(dirname) or $(eval expression) was expected";
                return Err(site.error(text));
            }
        };
        self.leave();
        Value::str(value).map_err(|message| site.error(message))
    }

    /// The value of `$(arg name)`.
    pub(super) fn argument(&mut self, name: &str, site: &Site<'_>) -> Result<String> {
        self.known.insert(name.to_owned());
        self.arguments.get(name).cloned().ok_or_else(|| {
            site.error(format!(
                "the argument {name} has no value here: it was not given, and no <xacro:arg> before gives a default"
            ))
        })
    }

    /// The value of a property, if there is one of this name.
    pub(super) fn property(&mut self, name: &str, site: &Site<'_>) -> Result<Option<Value>> {
        let Some((home, entry)) = self.scopes.find(site.scope, name) else {
            return Ok(None);
        };
        match entry.clone() {
            Entry::Value(value) => Ok(Some(value)),
            Entry::Namespace(_) => Err(site.error(format!("{name} is a namespace, not a value"))),
            Entry::Busy => Err(site.error(format!("the property {name} is defined by itself"))),
            Entry::Lazy(text, spot) => {
                self.enter(&spot)?;
                self.scopes.set(home, name, Entry::Busy);
                let value = self.text(&text, &spot, home)?;
                let value = literal(value, &spot)?;
                self.scopes.set(home, name, Entry::Value(value.clone()));
                self.leave();
                Ok(Some(value))
            }
        }
    }
}

/// A text that looks like a number or truth value, as that.
pub(super) fn literal(value: Value, spot: &Spot) -> Result<Value> {
    match value {
        Value::Str(text) => Value::literal(&text).map_err(|message| spot.error(&*text, message)),
        value => Ok(value),
    }
}
