//! Values of expressions, as Python has them.

use std::cmp::Ordering;
use std::fmt::Write;
use std::rc::Rc;

/// A result whose error is a sentence; where it happened is known further up.
pub(super) type Outcome<T> = Result<T, String>;

/// Strings and, counted with their contents, lists and dictionaries may not become larger: doubling something forty
/// times takes forty short lines.
const MAX_WEIGHT: usize = 1 << 20;

/// Lists in lists, to this depth: functions over values recurse.
const MAX_DEPTH: usize = 40;

#[derive(Clone, Debug)]
pub(super) enum Value {
    None,
    Bool(bool),
    Int(i64),
    Float(f64),
    Str(Rc<str>),
    List(Rc<List>),
    Dict(Rc<Dict>),
}

/// A list or tuple.
#[derive(Debug)]
pub(super) struct List {
    pub(super) items: Vec<Value>,
    size: Size,
}

/// A dictionary, in the order of insertion.
#[derive(Debug)]
pub(super) struct Dict {
    pub(super) entries: Vec<(Value, Value)>,
    size: Size,
}

#[derive(Clone, Copy, Debug)]
struct Size {
    weight: usize,
    depth: usize,
}

impl Size {
    fn around<'a>(contents: impl Iterator<Item = &'a Value>) -> Outcome<Self> {
        let mut size = Self {
            weight: 1,
            depth: 1,
        };
        for value in contents {
            let depth = match value {
                Value::List(list) => list.size.depth,
                Value::Dict(dict) => dict.size.depth,
                _ => 0,
            };
            size.weight += value.weight();
            size.depth = size.depth.max(depth + 1);
            if size.weight > MAX_WEIGHT {
                return Err(too_large());
            }
        }
        if size.depth > MAX_DEPTH {
            return Err(format!("lists are nested more than {MAX_DEPTH} deep"));
        }
        Ok(size)
    }
}

fn too_large() -> String {
    format!("the value becomes larger than {MAX_WEIGHT} characters or items")
}

impl Dict {
    pub(super) fn get(&self, key: &Value) -> Option<&Value> {
        let mut entries = self.entries.iter();
        entries.find(|(k, _)| k.equals(key)).map(|(_, value)| value)
    }

    pub(super) fn keys(&self) -> impl Iterator<Item = &Value> {
        self.entries.iter().map(|(key, _)| key)
    }
}

impl Value {
    pub(super) fn str(text: impl Into<Rc<str>>) -> Outcome<Self> {
        let text = text.into();
        if text.len() > MAX_WEIGHT {
            return Err(too_large());
        }
        Ok(Self::Str(text))
    }

    pub(super) fn list(items: Vec<Self>) -> Outcome<Self> {
        let size = Size::around(items.iter())?;
        Ok(Self::List(Rc::new(List { items, size })))
    }

    /// A dictionary; of equal keys the last counts.
    pub(super) fn dict(entries: Vec<(Self, Self)>) -> Outcome<Self> {
        let mut unique: Vec<(Self, Self)> = Vec::with_capacity(entries.len());
        // Quadratic, and short: the longest in use have some dozens of keys.
        if entries.len() > 10_000 {
            return Err("a dictionary has more than 10000 entries".to_owned());
        }
        for (key, value) in entries {
            if matches!(key, Self::List(_) | Self::Dict(_)) {
                return Err("a list or dictionary cannot be a key".to_owned());
            }
            match unique.iter_mut().find(|(k, _)| k.equals(&key)) {
                Some(slot) => slot.1 = value,
                None => unique.push((key, value)),
            }
        }
        let size = Size::around(unique.iter().flat_map(|(k, v)| [k, v]))?;
        Ok(Self::Dict(Rc::new(Dict {
            entries: unique,
            size,
        })))
    }

    /// What a literal in a property or parameter stands for: a number, a truth value, or the text itself, without
    /// the single quotes that mark it as text.
    pub(super) fn literal(text: &str) -> Outcome<Self> {
        let quoted = text.strip_prefix('\'').and_then(|t| t.strip_suffix('\''));
        if let Some(inner) = quoted {
            return Self::str(inner);
        }
        let trimmed = text.trim();
        if let Ok(int) = trimmed.parse() {
            return Ok(Self::Int(int));
        }
        if let Ok(float) = trimmed.parse() {
            return Ok(Self::Float(float));
        }
        match text {
            "true" | "True" => Ok(Self::Bool(true)),
            "false" | "False" => Ok(Self::Bool(false)),
            _ => Self::str(text),
        }
    }

    /// How much there is of the value: what copying or comparing it costs.
    pub(super) fn weight(&self) -> usize {
        match self {
            Self::Str(text) => 1 + text.len(),
            Self::List(list) => list.size.weight,
            Self::Dict(dict) => dict.size.weight,
            _ => 1,
        }
    }

    pub(super) fn kind(&self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Bool(_) => "a truth value",
            Self::Int(_) => "an integer",
            Self::Float(_) => "a number",
            Self::Str(_) => "a text",
            Self::List(_) => "a list",
            Self::Dict(_) => "a dictionary",
        }
    }

    /// Whether the value counts as true.
    pub(super) fn truth(&self) -> bool {
        match self {
            Self::None => false,
            Self::Bool(b) => *b,
            Self::Int(i) => *i != 0,
            Self::Float(x) => *x != 0.0,
            Self::Str(text) => !text.is_empty(),
            Self::List(list) => !list.items.is_empty(),
            Self::Dict(dict) => !dict.entries.is_empty(),
        }
    }

    /// The value as a number; truth values count as 0 and 1.
    pub(super) fn number(&self) -> Outcome<f64> {
        match self {
            Self::Bool(b) => Ok(f64::from(u8::from(*b))),
            Self::Int(i) => Ok(*i as f64),
            Self::Float(x) => Ok(*x),
            _ => Err(format!("a number was expected, not {}", self.described())),
        }
    }

    /// The value as an integer, if it is one by kind.
    pub(super) fn integer(&self) -> Option<i64> {
        match self {
            Self::Bool(b) => Some(i64::from(*b)),
            Self::Int(i) => Some(*i),
            _ => None,
        }
    }

    pub(super) fn equals(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::None, Self::None) => true,
            (Self::Str(a), Self::Str(b)) => a == b,
            (Self::List(a), Self::List(b)) => {
                let pairs = a.items.iter().zip(&b.items);
                a.items.len() == b.items.len() && pairs.into_iter().all(|(a, b)| a.equals(b))
            }
            (Self::Dict(a), Self::Dict(b)) => {
                a.entries.len() == b.entries.len()
                    && a.entries
                        .iter()
                        .all(|(key, value)| b.get(key).is_some_and(|v| v.equals(value)))
            }
            _ => match (self.integer(), other.integer()) {
                (Some(a), Some(b)) => a == b,
                _ => self.number().is_ok_and(|a| other.number() == Ok(a)),
            },
        }
    }

    /// Which comes first: numbers by size, texts by letters, lists by their first difference; `None` for what is not a
    /// number.
    pub(super) fn order(&self, other: &Self) -> Outcome<Option<Ordering>> {
        match (self, other) {
            (Self::Str(a), Self::Str(b)) => Ok(Some(a.cmp(b))),
            (Self::List(a), Self::List(b)) => {
                for (a, b) in a.items.iter().zip(&b.items) {
                    if !a.equals(b) {
                        return a.order(b);
                    }
                }
                Ok(Some(a.items.len().cmp(&b.items.len())))
            }
            _ => match (self.integer(), other.integer()) {
                (Some(a), Some(b)) => Ok(Some(a.cmp(&b))),
                _ => match (self.number(), other.number()) {
                    (Ok(a), Ok(b)) => Ok(a.partial_cmp(&b)),
                    _ => Err(format!(
                        "{} and {} cannot be compared",
                        self.kind(),
                        other.kind()
                    )),
                },
            },
        }
    }

    /// The value as text, as Python prints it.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Str(text) => text.to_string(),
            _ => {
                let mut out = String::new();
                self.write(&mut out);
                out
            }
        }
    }

    /// The value for an error message.
    pub(super) fn described(&self) -> String {
        match self {
            Self::Str(text) => format!("the text '{text}'"),
            Self::None => "None".to_owned(),
            _ => format!("{} {}", self.kind(), self.text()),
        }
    }

    fn write(&self, out: &mut String) {
        let comma = |index: usize| if index > 0 { ", " } else { "" };
        match self {
            Self::None => out.push_str("None"),
            Self::Bool(true) => out.push_str("True"),
            Self::Bool(false) => out.push_str("False"),
            // Writing to a string does not fail.
            Self::Int(i) => drop(write!(out, "{i}")),
            Self::Float(x) => out.push_str(&float_text(*x)),
            Self::Str(text) => {
                let quote = if text.contains('\'') && !text.contains('"') {
                    '"'
                } else {
                    '\''
                };
                out.push(quote);
                for c in text.chars() {
                    if c == quote || c == '\\' {
                        out.push('\\');
                    }
                    out.push(c);
                }
                out.push(quote);
            }
            Self::List(list) => {
                out.push('[');
                for (index, item) in list.items.iter().enumerate() {
                    out.push_str(comma(index));
                    item.write(out);
                }
                out.push(']');
            }
            Self::Dict(dict) => {
                out.push('{');
                for (index, (key, value)) in dict.entries.iter().enumerate() {
                    out.push_str(comma(index));
                    key.write(out);
                    out.push_str(": ");
                    value.write(out);
                }
                out.push('}');
            }
        }
    }
}

/// The shortest form that reads back as the same number, with Python's choice between the plain and the scientific one.
fn float_text(x: f64) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "inf" } else { "-inf" }.to_owned();
    }
    let scientific = format!("{x:e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or_default();
    if (-4..16).contains(&exponent) {
        return format!("{x:?}");
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{digits}e{sign}{:02}", exponent.abs())
}
