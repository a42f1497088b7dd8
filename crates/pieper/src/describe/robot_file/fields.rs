//! Typed access to a TOML document in which every error knows its place.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::describe::expr::{Expr, Values};
use crate::error::{Error, Place, Result};

/// A table of the document.
pub(super) struct Table<'a> {
    pub(super) file: &'a str,
    text: &'a str,
    span: Range<usize>,
    table: &'a DeTable<'a>,
}

/// A key of a table with its value, or an item of a list.
pub(super) struct Field<'a> {
    file: &'a str,
    text: &'a str,
    name: &'a str,
    name_span: Range<usize>,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Table<'a> {
    pub(super) fn root(file: &'a str, text: &'a str, table: &'a DeTable<'a>) -> Self {
        Self {
            file,
            text,
            span: 0..0,
            table,
        }
    }

    /// The fields in the order in which they stand in the file.
    pub(super) fn fields(&self) -> impl Iterator<Item = Field<'a>> + use<'a> {
        let mut fields: Vec<_> = self.table.iter().collect();
        fields.sort_by_key(|(name, _)| name.span().start);
        let (file, text) = (self.file, self.text);
        fields.into_iter().map(move |(name, value)| Field {
            file,
            text,
            name: name.get_ref(),
            name_span: name.span(),
            value,
        })
    }

    pub(super) fn get(&self, name: &str) -> Option<Field<'a>> {
        self.fields().find(|field| field.name == name)
    }

    pub(super) fn require(&self, name: &str, expected: &str) -> Result<Field<'a>> {
        self.get(name)
            .ok_or_else(|| self.error(&format!("`{name} = ` was expected: {expected}")))
    }

    pub(super) fn optional_string(&self, name: &str) -> Result<String> {
        self.get(name).map_or(Ok(String::new()), |field| {
            Ok(field.string()?.trim().to_owned())
        })
    }

    /// An error at the table's head.
    pub(super) fn error(&self, expected: &str) -> Error {
        let subject = self.text.get(self.span.clone()).unwrap_or_default();
        let subject = subject.lines().next().unwrap_or_default().trim().to_owned();
        let place = match subject.is_empty() {
            true => Place {
                file: self.file.to_owned(),
                line: 0,
                column: 0,
            },
            false => Place::of_offset(self.file, self.text, self.span.start),
        };
        Error::parse(place, subject, expected)
    }

    pub(super) fn allow_only(&self, names: &[&str]) -> Result<()> {
        match self.fields().find(|field| !names.contains(&field.name)) {
            None => Ok(()),
            Some(field) => Err(field.name_error(&format!(
                "one of the keys {} was expected",
                names.join(", ")
            ))),
        }
    }

    pub(super) fn table(&self, name: &str) -> Result<Option<Table<'a>>> {
        self.get(name).map(|field| field.table()).transpose()
    }

    /// The tables of an array of tables; empty if there is none.
    pub(super) fn tables(&self, name: &str) -> Result<Vec<Table<'a>>> {
        match self.get(name) {
            None => Ok(Vec::new()),
            Some(field) => field.items()?.iter().map(Field::table).collect(),
        }
    }
}

impl<'a> Field<'a> {
    pub(super) fn name(&self) -> &'a str {
        self.name
    }

    pub(super) fn value(&self) -> &'a DeValue<'a> {
        self.value.get_ref()
    }

    fn written(&self) -> String {
        let text = self.text.get(self.value.span()).unwrap_or_default();
        let line = text.lines().next().unwrap_or_default();
        if line.chars().count() > 60 {
            format!("{}...", line.chars().take(60).collect::<String>())
        } else {
            line.to_owned()
        }
    }

    /// An error at the value.
    pub(super) fn error(&self, expected: &str) -> Error {
        let place = Place::of_offset(self.file, self.text, self.value.span().start);
        Error::parse(
            place,
            format!("{} = {}", self.name, self.written()),
            expected,
        )
    }

    /// An error at the name.
    pub(super) fn name_error(&self, expected: &str) -> Error {
        let place = Place::of_offset(self.file, self.text, self.name_span.start);
        Error::parse(place, self.name, expected)
    }

    pub(super) fn string(&self) -> Result<&'a str> {
        self.value()
            .as_str()
            .ok_or_else(|| self.error("a string in quotes was expected"))
    }

    fn table(&self) -> Result<Table<'a>> {
        let table = self
            .value()
            .as_table()
            .ok_or_else(|| self.error("a table was expected"))?;
        let span = self.value.span();
        Ok(Table {
            file: self.file,
            text: self.text,
            span,
            table,
        })
    }

    /// The items of a list, under the list's name.
    pub(super) fn items(&self) -> Result<Vec<Field<'a>>> {
        let items = self
            .value()
            .as_array()
            .ok_or_else(|| self.error("a list in brackets was expected"))?;
        Ok(items
            .iter()
            .map(|value| Field {
                value,
                name_span: value.span(),
                ..*self
            })
            .collect())
    }

    /// A formula: a number, or a string. With `known`, other symbols are an error that names them.
    pub(super) fn expr(&self, known: Option<&[&str]>) -> Result<Expr> {
        let expr = match self.value() {
            DeValue::String(text) => {
                Expr::parse(text).map_err(|error| self.error(&plain_message(&error)))?
            }
            _ => Expr::number(self.number()?),
        };
        let symbols = expr.symbols();
        let Some(unknown) =
            known.and_then(|known| symbols.into_iter().find(|s| !known.contains(s)))
        else {
            return Ok(expr);
        };
        Err(self.error(&unknown_symbol(unknown, known.unwrap_or_default())))
    }

    pub(super) fn number(&self) -> Result<f64> {
        let number = match self.value() {
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::String(text) => match Expr::parse(text) {
                Ok(expr) => Some(
                    expr.evaluate(&Values::new())
                        .map_err(|e| self.error(&e.to_string()))?,
                ),
                Err(error) => return Err(self.error(&plain_message(&error))),
            },
            _ => None,
        };
        number
            .filter(|number: &f64| number.is_finite())
            .ok_or_else(|| self.error("a finite number was expected"))
    }

    pub(super) fn numbers(&self) -> Result<Vec<f64>> {
        self.items()?.iter().map(Field::number).collect()
    }

    /// A list of exactly `N` formulas.
    pub(super) fn exprs<const N: usize>(&self, known: &[&str]) -> Result<[Expr; N]> {
        let items = self.items()?;
        let exprs: Vec<Expr> = items
            .iter()
            .map(|item| item.expr(Some(known)))
            .collect::<Result<_>>()?;
        let given = exprs.len();
        exprs
            .try_into()
            .map_err(|_| self.error(&format!("{N} entries were expected, {given} were found")))
    }
}

/// A formula's error without the text, which the field's error shows itself.
fn plain_message(error: &Error) -> String {
    let text = error.to_string();
    text.split_once(": ")
        .map_or(text.clone(), |(_, message)| message.to_owned())
}

fn unknown_symbol(name: &str, known: &[&str]) -> String {
    let is_joint = name
        .strip_prefix('q')
        .is_some_and(|n| n.parse::<usize>().is_ok());
    if is_joint {
        return format!("the joint variable {name} cannot stand here");
    }
    match known {
        [] => format!("{name} is unknown: the file has no [parameters]"),
        known => format!(
            "{name} is unknown: one of {} was expected",
            known.join(", ")
        ),
    }
}
