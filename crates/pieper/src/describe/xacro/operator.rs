//! Operators on values.

use std::cmp::Ordering;

use super::expr::{Binary, Compare};
use super::value::{Outcome, Value};

pub(super) fn binary(operator: Binary, a: &Value, b: &Value) -> Outcome<Value> {
    match (operator, a, b) {
        (Binary::Add, Value::Str(a), Value::Str(b)) => Value::str(format!("{a}{b}")),
        (Binary::Add, Value::List(a), Value::List(b)) => {
            Value::list([a.items.as_slice(), b.items.as_slice()].concat())
        }
        (Binary::Multiply, Value::Str(text), count)
        | (Binary::Multiply, count, Value::Str(text)) => repeat(text, count),
        _ => match (a.integer(), b.integer()) {
            (Some(a), Some(b)) => integers(operator, a, b),
            _ => match (a.number(), b.number()) {
                (Ok(a), Ok(b)) => numbers(operator, a, b).map(Value::Float),
                _ => Err(format!(
                    "{} {} {} has no meaning",
                    a.described(),
                    sign(operator),
                    b.described()
                )),
            },
        },
    }
}

fn sign(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Divide => "/",
        Binary::FloorDivide => "//",
        Binary::Modulo => "%",
        Binary::Power => "**",
    }
}

fn repeat(text: &str, count: &Value) -> Outcome<Value> {
    let count = count
        .integer()
        .ok_or_else(|| format!("a text cannot be multiplied by {}", count.described()))?;
    let count = usize::try_from(count).unwrap_or(0);
    match text.len().checked_mul(count) {
        Some(length) if length <= 1 << 20 => Value::str(text.repeat(count)),
        _ => Err("the text becomes too long".to_owned()),
    }
}

fn integers(operator: Binary, a: i64, b: i64) -> Outcome<Value> {
    if b == 0
        && matches!(
            operator,
            Binary::Divide | Binary::FloorDivide | Binary::Modulo
        )
    {
        return Err("division by zero".to_owned());
    }
    let result = match operator {
        Binary::Add => a.checked_add(b),
        Binary::Subtract => a.checked_sub(b),
        Binary::Multiply => a.checked_mul(b),
        Binary::Divide => return Ok(Value::Float(a as f64 / b as f64)),
        Binary::FloorDivide => a.checked_div_euclid(b).map(|quotient| {
            // Euclid's quotient rounds towards the divisor's sign; the floor differs for negative divisors.
            let exact = a.checked_rem_euclid(b) == Some(0);
            if b < 0 && !exact {
                quotient - 1
            } else {
                quotient
            }
        }),
        Binary::Modulo => a.checked_rem(b).map(|rest| {
            if rest != 0 && (rest < 0) != (b < 0) {
                rest + b
            } else {
                rest
            }
        }),
        Binary::Power => match u32::try_from(b) {
            Ok(exponent) => a.checked_pow(exponent),
            Err(_) => return numbers(operator, a as f64, b as f64).map(Value::Float),
        },
    };
    let text = || format!("{a} {} {b} is too large for an integer", sign(operator));
    result.map(Value::Int).ok_or_else(text)
}

fn numbers(operator: Binary, a: f64, b: f64) -> Outcome<f64> {
    if b == 0.0
        && matches!(
            operator,
            Binary::Divide | Binary::FloorDivide | Binary::Modulo
        )
    {
        return Err("division by zero".to_owned());
    }
    let result = match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::FloorDivide => (a / b).floor(),
        Binary::Modulo => {
            let rest = a % b;
            if rest != 0.0 && (rest < 0.0) != (b < 0.0) {
                rest + b
            } else {
                rest
            }
        }
        Binary::Power => a.powf(b),
    };
    if result.is_nan() && !a.is_nan() && !b.is_nan() {
        return Err(format!("{a} {} {b} is no number", sign(operator)));
    }
    Ok(result)
}

pub(super) fn compare(operator: Compare, a: &Value, b: &Value) -> Outcome<bool> {
    let order = || a.order(b);
    Ok(match operator {
        Compare::Equal => a.equals(b),
        Compare::NotEqual => !a.equals(b),
        Compare::Less => order()? == Some(Ordering::Less),
        Compare::LessEqual => order()?.is_some_and(Ordering::is_le),
        Compare::Greater => order()? == Some(Ordering::Greater),
        Compare::GreaterEqual => order()?.is_some_and(Ordering::is_ge),
        Compare::In => contains(b, a)?,
        Compare::NotIn => !contains(b, a)?,
    })
}

fn contains(whole: &Value, part: &Value) -> Outcome<bool> {
    match (whole, part) {
        (Value::Str(whole), Value::Str(part)) => Ok(whole.contains(&**part)),
        (Value::List(list), _) => Ok(list.items.iter().any(|item| item.equals(part))),
        (Value::Dict(dict), _) => Ok(dict.get(part).is_some()),
        _ => Err(format!(
            "{} cannot contain {}",
            whole.described(),
            part.described()
        )),
    }
}

pub(super) fn negative(value: &Value) -> Outcome<Value> {
    match value.integer() {
        Some(int) => int
            .checked_neg()
            .map(Value::Int)
            .ok_or_else(|| format!("-({int}) is too large for an integer")),
        None => value.number().map(|x| Value::Float(-x)),
    }
}

pub(super) fn positive(value: Value) -> Outcome<Value> {
    match value.integer() {
        Some(int) => Ok(Value::Int(int)),
        None => value.number().map(Value::Float),
    }
}

/// `value[index]`.
pub(super) fn index(value: &Value, index: &Value) -> Outcome<Value> {
    match value {
        Value::Dict(dict) => dict.get(index).cloned().ok_or_else(|| {
            let keys: Vec<String> = dict.keys().map(Value::text).collect();
            format!(
                "there is no key {}; the keys are {}",
                index.text(),
                keys.join(", ")
            )
        }),
        Value::List(list) => {
            let at = position(index, list.items.len())?;
            Ok(list.items[at].clone())
        }
        Value::Str(text) => {
            let at = position(index, text.chars().count())?;
            Value::str(text.chars().skip(at).take(1).collect::<String>())
        }
        _ => Err(format!("{} has no parts", value.described())),
    }
}

fn position(index: &Value, length: usize) -> Outcome<usize> {
    let int = index.integer().ok_or_else(|| {
        format!(
            "an integer was expected as index, not {}",
            index.described()
        )
    })?;
    let from_end = i64::try_from(length)
        .ok()
        .and_then(|length| int.checked_add(length));
    let at = if int < 0 { from_end.unwrap_or(-1) } else { int };
    match usize::try_from(at) {
        Ok(at) if at < length => Ok(at),
        _ => Err(format!(
            "index {int} is out of range: there are {length} items"
        )),
    }
}

/// `value[start:end]`.
pub(super) fn slice(value: &Value, start: Option<&Value>, end: Option<&Value>) -> Outcome<Value> {
    let bound = |bound: Option<&Value>, default: usize, length: usize| match bound {
        None => Ok(default),
        Some(value) => {
            let int = value.integer().ok_or_else(|| {
                format!(
                    "an integer was expected as index, not {}",
                    value.described()
                )
            })?;
            let magnitude = usize::try_from(int.unsigned_abs()).unwrap_or(usize::MAX);
            Ok::<_, String>(if int < 0 {
                length.saturating_sub(magnitude)
            } else {
                magnitude.min(length)
            })
        }
    };
    match value {
        Value::List(list) => {
            let length = list.items.len();
            let (start, end) = (bound(start, 0, length)?, bound(end, length, length)?);
            Value::list(list.items.get(start..end).unwrap_or_default().to_vec())
        }
        Value::Str(text) => {
            let length = text.chars().count();
            let (start, end) = (bound(start, 0, length)?, bound(end, length, length)?);
            let part = text.chars().skip(start).take(end.saturating_sub(start));
            Value::str(part.collect::<String>())
        }
        _ => Err(format!("{} has no parts", value.described())),
    }
}
