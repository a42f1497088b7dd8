//! Names and functions that expressions find without defining them: Python's, of which none touches the outside.

use std::f64::consts;

use super::value::{Outcome, Value};

/// A constant, by its name without `math.`.
pub(super) fn constant(name: &str) -> Option<Value> {
    Some(match name {
        "pi" => Value::Float(consts::PI),
        "e" => Value::Float(consts::E),
        "tau" => Value::Float(consts::TAU),
        "inf" => Value::Float(f64::INFINITY),
        "nan" => Value::Float(f64::NAN),
        "True" => Value::Bool(true),
        "False" => Value::Bool(false),
        "None" => Value::None,
        _ => return None,
    })
}

/// A function of these arguments; `None` if there is no such function.
pub(super) fn call(name: &str, args: &[Value]) -> Option<Outcome<Value>> {
    let result = match (name, args) {
        ("len", [value]) => len(value),
        ("str", [value]) => Value::str(value.text()),
        ("str", []) => Value::str(""),
        ("bool", [value]) => Ok(Value::Bool(value.truth())),
        ("int", [value]) => int(value),
        ("float", [value]) => float(value),
        ("abs", [value]) => match value.integer() {
            Some(int) => int
                .checked_abs()
                .map(Value::Int)
                .ok_or_else(|| "the integer is too large".to_owned()),
            None => value.number().map(|x| Value::Float(x.abs())),
        },
        ("round", [value]) => value.number().and_then(|x| whole(x.round_ties_even())),
        ("round", [value, digits]) => round(value, digits),
        ("min" | "max", _) => extreme(name == "max", args),
        ("sum", [Value::List(list)]) => {
            let mut sum = Ok(Value::Int(0));
            for item in &list.items {
                sum = sum.and_then(|s| super::operator::binary(super::expr::Binary::Add, &s, item));
            }
            sum
        }
        ("list" | "tuple", []) => Value::list(Vec::new()),
        ("list" | "tuple", [value]) => items(value).and_then(Value::list),
        ("sorted", [value]) => items(value).and_then(sorted),
        ("range", _) => range(args),
        ("dict", []) => Value::dict(Vec::new()),
        ("dict", [Value::Dict(dict)]) => Ok(Value::Dict(dict.clone())),
        ("any", [value]) => items(value).map(|v| Value::Bool(v.iter().any(Value::truth))),
        ("all", [value]) => items(value).map(|v| Value::Bool(v.iter().all(Value::truth))),
        _ => return mathematics(name, args),
    };
    Some(result)
}

fn len(value: &Value) -> Outcome<Value> {
    let length = match value {
        Value::Str(text) => text.chars().count(),
        Value::List(list) => list.items.len(),
        Value::Dict(dict) => dict.entries.len(),
        _ => return Err(format!("{} has no length", value.described())),
    };
    i64::try_from(length)
        .map(Value::Int)
        .map_err(|_| "the length is too large".to_owned())
}

fn int(value: &Value) -> Outcome<Value> {
    match value {
        Value::Str(text) => match text.trim().parse() {
            Ok(int) => Ok(Value::Int(int)),
            Err(_) => Err(format!("'{text}' is no integer")),
        },
        _ => match value.integer() {
            Some(int) => Ok(Value::Int(int)),
            None => value.number().and_then(|x| whole(x.trunc())),
        },
    }
}

fn float(value: &Value) -> Outcome<Value> {
    match value {
        Value::Str(text) => match text.trim().parse() {
            Ok(x) => Ok(Value::Float(x)),
            Err(_) => Err(format!("'{text}' is no number")),
        },
        _ => value.number().map(Value::Float),
    }
}

/// A float without a fraction as an integer.
fn whole(x: f64) -> Outcome<Value> {
    if x.abs() < 9.2e18 {
        Ok(Value::Int(x as i64))
    } else {
        Err(format!("{x} is too large for an integer"))
    }
}

/// Rounds the decimal form, as Python does, not the binary one times a power of ten.
fn round(value: &Value, digits: &Value) -> Outcome<Value> {
    let x = value.number()?;
    let digits = digits
        .integer()
        .ok_or_else(|| format!("an integer was expected, not {}", digits.described()))?;
    let rounded = match usize::try_from(digits) {
        Ok(digits) if digits < 400 => format!("{x:.digits$}").parse().unwrap_or(x),
        Ok(_) => x,
        Err(_) => {
            let power = 10f64.powi(i32::try_from(-digits).unwrap_or(400).min(400));
            (x / power).round_ties_even() * power
        }
    };
    match value.integer() {
        Some(_) if rounded.is_finite() => whole(rounded),
        _ => Ok(Value::Float(rounded)),
    }
}

fn items(value: &Value) -> Outcome<Vec<Value>> {
    match value {
        Value::List(list) => Ok(list.items.clone()),
        Value::Dict(dict) => Ok(dict.keys().cloned().collect()),
        Value::Str(text) => text.chars().map(|c| Value::str(c.to_string())).collect(),
        _ => Err(format!("{} has no items", value.described())),
    }
}

fn extreme(largest: bool, args: &[Value]) -> Outcome<Value> {
    let values = match args {
        [value @ (Value::List(_) | Value::Dict(_))] => items(value)?,
        _ => args.to_vec(),
    };
    let mut values = values.into_iter();
    let first = values.next().ok_or("there is no value to choose from")?;
    values.try_fold(first, |best, value| {
        let order = value.order(&best)?;
        let better = order.is_some_and(|o| if largest { o.is_gt() } else { o.is_lt() });
        Ok(if better { value } else { best })
    })
}

fn sorted(mut values: Vec<Value>) -> Outcome<Value> {
    // Only what has a total order may be handed to the library's sort.
    let texts = values.iter().all(|value| matches!(value, Value::Str(_)));
    let numbers = values
        .iter()
        .all(|value| value.number().is_ok_and(|x| !x.is_nan()));
    if !texts && !numbers {
        return Err("only texts alone or numbers alone can be sorted".to_owned());
    }
    values.sort_by(|a, b| match (a, b) {
        (Value::Str(a), Value::Str(b)) => a.cmp(b),
        _ => {
            let number = |value: &Value| value.number().unwrap_or_default();
            number(a).total_cmp(&number(b))
        }
    });
    Value::list(values)
}

fn range(args: &[Value]) -> Outcome<Value> {
    const LONGEST: usize = 10_000;
    let integers: Option<Vec<i64>> = args.iter().map(Value::integer).collect();
    let (start, end, step) = match integers.as_deref() {
        Some([end]) => (0, *end, 1),
        Some([start, end]) => (*start, *end, 1),
        Some([start, end, step]) if *step != 0 => (*start, *end, *step),
        _ => {
            return Err(
                "range(end), range(start, end) or range(start, end, step) was expected".into(),
            );
        }
    };
    let mut values = Vec::new();
    let mut at = start;
    while if step > 0 { at < end } else { at > end } {
        values.push(Value::Int(at));
        if values.len() > LONGEST {
            return Err(format!("the range has more than {LONGEST} values"));
        }
        match at.checked_add(step) {
            Some(next) => at = next,
            None => break,
        }
    }
    Value::list(values)
}

/// Functions of one or two numbers.
fn mathematics(name: &str, args: &[Value]) -> Option<Outcome<Value>> {
    let one: Option<fn(f64) -> f64> = match name {
        "sin" => Some(f64::sin),
        "cos" => Some(f64::cos),
        "tan" => Some(f64::tan),
        "asin" => Some(f64::asin),
        "acos" => Some(f64::acos),
        "atan" => Some(f64::atan),
        "sinh" => Some(f64::sinh),
        "cosh" => Some(f64::cosh),
        "tanh" => Some(f64::tanh),
        "sqrt" => Some(f64::sqrt),
        "exp" => Some(f64::exp),
        "log" => Some(f64::ln),
        "log10" => Some(f64::log10),
        "log2" => Some(f64::log2),
        "fabs" => Some(f64::abs),
        "radians" => Some(f64::to_radians),
        "degrees" => Some(f64::to_degrees),
        _ => None,
    };
    let two: Option<fn(f64, f64) -> f64> = match name {
        "atan2" => Some(f64::atan2),
        "pow" => Some(f64::powf),
        "hypot" => Some(f64::hypot),
        "fmod" => Some(|a, b| a % b),
        "copysign" => Some(f64::copysign),
        "log" => Some(f64::log),
        _ => None,
    };
    let rounding: Option<fn(f64) -> f64> = match name {
        "floor" => Some(f64::floor),
        "ceil" => Some(f64::ceil),
        "trunc" => Some(f64::trunc),
        _ => None,
    };
    let known = one.is_some() || two.is_some() || rounding.is_some();
    match (args, one, two, rounding) {
        ([x], Some(f), _, _) => Some(x.number().and_then(|x| defined(name, &[x], f(x)))),
        ([x, y], _, Some(f), _) => Some(x.number().and_then(|x| {
            let y = y.number()?;
            defined(name, &[x, y], f(x, y))
        })),
        ([x], _, _, Some(f)) => Some(x.number().and_then(|x| whole(f(x)))),
        _ if known || is_function(name) => Some(Err(format!(
            "{name}() does not take {} such argument{}",
            args.len(),
            if args.len() == 1 { "" } else { "s" }
        ))),
        _ => None,
    }
}

/// Functions that [`call`] handles itself; there the arguments did not fit.
fn is_function(name: &str) -> bool {
    const NAMES: [&str; 14] = [
        "len", "str", "bool", "int", "float", "abs", "round", "sum", "list", "tuple", "sorted",
        "dict", "any", "all",
    ];
    NAMES.contains(&name)
}

fn defined(name: &str, args: &[f64], value: f64) -> Outcome<Value> {
    let fails = !value.is_finite() && args.iter().all(|x| x.is_finite());
    if fails {
        let args: Vec<String> = args.iter().map(f64::to_string).collect();
        return Err(format!("{name}({}) is no finite number", args.join(", ")));
    }
    Ok(Value::Float(value))
}

/// A method of a value: those of texts and dictionaries that descriptions use.
pub(super) fn method(value: &Value, name: &str, args: &[Value]) -> Outcome<Value> {
    match (value, name, args) {
        (Value::Dict(dict), "get", [key]) => Ok(dict.get(key).cloned().unwrap_or(Value::None)),
        (Value::Dict(dict), "get", [key, default]) => {
            Ok(dict.get(key).cloned().unwrap_or_else(|| default.clone()))
        }
        (Value::Dict(dict), "keys", []) => Value::list(dict.keys().cloned().collect()),
        (Value::Dict(dict), "values", []) => Value::list(
            dict.entries
                .iter()
                .map(|(_, value)| value.clone())
                .collect(),
        ),
        (Value::Dict(dict), "items", []) => {
            let pairs = dict.entries.iter();
            let pairs = pairs.map(|(key, value)| Value::list(vec![key.clone(), value.clone()]));
            Value::list(pairs.collect::<Outcome<_>>()?)
        }
        (Value::Str(text), "lower", []) => Value::str(text.to_lowercase()),
        (Value::Str(text), "upper", []) => Value::str(text.to_uppercase()),
        (Value::Str(text), "strip", []) => Value::str(text.trim()),
        (Value::Str(text), "startswith", [Value::Str(start)]) => {
            Ok(Value::Bool(text.starts_with(&**start)))
        }
        (Value::Str(text), "endswith", [Value::Str(end)]) => {
            Ok(Value::Bool(text.ends_with(&**end)))
        }
        (Value::Str(text), "split", []) => Value::list(
            text.split_whitespace()
                .map(Value::str)
                .collect::<Outcome<_>>()?,
        ),
        (Value::Str(text), "split", [Value::Str(separator)]) if !separator.is_empty() => {
            Value::list(
                text.split(&**separator)
                    .map(Value::str)
                    .collect::<Outcome<_>>()?,
            )
        }
        (Value::Str(text), "replace", [Value::Str(from), Value::Str(to)]) if !from.is_empty() => {
            let count = text.matches(&**from).count();
            if count.saturating_mul(to.len()) > 1 << 20 {
                return Err("the text becomes too long".to_owned());
            }
            Value::str(text.replace(&**from, to))
        }
        (Value::Str(separator), "join", [list]) => {
            let texts: Vec<String> = items(list)?.iter().map(Value::text).collect();
            let length = texts
                .iter()
                .map(|text| text.len() + separator.len())
                .sum::<usize>();
            if length > 1 << 20 {
                return Err("the text becomes too long".to_owned());
            }
            Value::str(texts.join(separator))
        }
        _ => Err(format!(
            "{} has no method {name}() with such arguments",
            value.kind()
        )),
    }
}
