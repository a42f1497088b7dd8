//! YAML files into values, with the units that xacro adds.

use std::collections::HashMap;

use saphyr_parser::{Event, Parser, ScalarStyle, Tag};

use super::value::{Outcome, Value};

/// The value of a YAML text's first document. `evaluate` is given the expression behind a unit such as `!degrees`.
///
/// The error is line, column and sentence.
pub(super) fn load(
    text: &str,
    evaluate: &mut dyn FnMut(&str) -> Outcome<Value>,
) -> Result<Value, (usize, usize, String)> {
    let mut builder = Builder {
        open: Vec::new(),
        anchors: HashMap::new(),
        done: None,
    };
    for event in Parser::new_from_str(text) {
        let (event, span) = event.map_err(|error| {
            let marker = error.marker();
            (marker.line(), marker.col() + 1, error.info().to_owned())
        })?;
        builder
            .event(event, evaluate)
            .map_err(|text| (span.start.line(), span.start.col() + 1, text))?;
        if builder.done.is_some() {
            break;
        }
    }
    Ok(builder.done.unwrap_or(Value::None))
}

struct Builder {
    open: Vec<Open>,
    anchors: HashMap<usize, Value>,
    done: Option<Value>,
}

/// A collection that has begun.
struct Open {
    anchor: usize,
    items: Vec<Value>,
    is_mapping: bool,
}

/// Collections in collections, to this depth.
const MAX_DEPTH: usize = 40;

impl Builder {
    fn event(
        &mut self,
        event: Event<'_>,
        evaluate: &mut dyn FnMut(&str) -> Outcome<Value>,
    ) -> Outcome<()> {
        match event {
            Event::Scalar(text, style, anchor, tag) => {
                let value = scalar(&text, style, tag.as_deref(), evaluate)?;
                self.add(value, anchor);
            }
            Event::Alias(anchor) => {
                let value = self.anchors.get(&anchor).cloned();
                self.add(value.ok_or("an alias within its own anchor")?, 0);
            }
            Event::SequenceStart(anchor, _) => self.open(anchor, false)?,
            Event::MappingStart(anchor, _) => self.open(anchor, true)?,
            Event::SequenceEnd | Event::MappingEnd => {
                if let Some(Open {
                    anchor,
                    items,
                    is_mapping,
                }) = self.open.pop()
                {
                    let value = if is_mapping {
                        mapping(items)?
                    } else {
                        Value::list(items)?
                    };
                    self.add(value, anchor);
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn open(&mut self, anchor: usize, is_mapping: bool) -> Outcome<()> {
        if self.open.len() >= MAX_DEPTH {
            return Err(format!("it is nested more than {MAX_DEPTH} deep"));
        }
        self.open.push(Open {
            anchor,
            items: Vec::new(),
            is_mapping,
        });
        Ok(())
    }

    fn add(&mut self, value: Value, anchor: usize) {
        if anchor > 0 {
            self.anchors.insert(anchor, value.clone());
        }
        match self.open.last_mut() {
            Some(open) => open.items.push(value),
            None => self.done = Some(value),
        }
    }
}

/// Keys and values by turns; what is merged by `<<` gives way to what is written.
fn mapping(items: Vec<Value>) -> Outcome<Value> {
    let (mut entries, mut merged) = (Vec::new(), Vec::new());
    let mut items = items.into_iter();
    while let (Some(key), Some(value)) = (items.next(), items.next()) {
        match (&key, &value) {
            (Value::Str(text), Value::Dict(dict)) if &**text == "<<" => {
                merged.extend(dict.entries.iter().cloned());
            }
            _ => entries.push((key, value)),
        }
    }
    merged.append(&mut entries);
    Value::dict(merged)
}

fn scalar(
    text: &str,
    style: ScalarStyle,
    tag: Option<&Tag>,
    evaluate: &mut dyn FnMut(&str) -> Outcome<Value>,
) -> Outcome<Value> {
    let unit = tag.filter(|tag| tag.handle == "!").map(|tag| &*tag.suffix);
    let factor = match unit {
        None => return plain(text, style, tag),
        Some("radians" | "meters") => 1.0,
        Some("degrees") => std::f64::consts::PI / 180.0,
        Some("millimeters") => 0.001,
        Some("foot") => 0.3048,
        Some("inches") => 0.0254,
        Some(unit) => {
            return Err(format!(
                "no such unit: !{unit}; there are !radians, !degrees, !meters, !millimeters, !foot and !inches"
            ));
        }
    };
    Ok(Value::Float(evaluate(text)?.number()? * factor))
}

fn plain(text: &str, style: ScalarStyle, tag: Option<&Tag>) -> Outcome<Value> {
    let is_text = tag.is_some_and(|tag| tag.is_yaml_core_schema() && tag.suffix == "str");
    if style != ScalarStyle::Plain || is_text {
        return Value::str(text);
    }
    if let Ok(int) = text.parse() {
        return Ok(Value::Int(int));
    }
    match text {
        "" | "~" | "null" | "Null" | "NULL" => return Ok(Value::None),
        ".inf" | "+.inf" | ".Inf" => return Ok(Value::Float(f64::INFINITY)),
        "-.inf" | "-.Inf" => return Ok(Value::Float(f64::NEG_INFINITY)),
        _ => {}
    }
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" | "on" => return Ok(Value::Bool(true)),
        "false" | "no" | "off" => return Ok(Value::Bool(false)),
        _ => {}
    }
    // `inf` and `nan` without the dot are words.
    let numeric = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        && text.ends_with(|c: char| c.is_ascii_digit() || c == '.');
    match text.parse() {
        Ok(x) if numeric => Ok(Value::Float(x)),
        _ => Value::str(text),
    }
}
