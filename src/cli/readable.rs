//! Answers for a person.

use serde_json::{Map, Value};

use super::designer;

/// An answer, a line for each field, with what belongs to it below.
pub fn answer(answer: &Value) -> String {
    match answer {
        Value::Object(fields) => block(fields, 0),
        other => format!("{other}\n"),
    }
}

/// The fields of an object, their values in one column.
fn block(fields: &Map<String, Value>, depth: usize) -> String {
    let short = |value: &Value| in_words(value).is_some();
    let width = fields
        .iter()
        .filter(|(_, value)| short(value))
        .map(|(name, _)| name.chars().count())
        .max()
        .unwrap_or(0);
    fields
        .iter()
        .map(|(name, value)| {
            let for_designer = match name.as_str() {
                "linkages" => designer::linkages(fields, depth),
                "ranked" => designer::ranked(value, depth),
                _ => None,
            };
            for_designer.unwrap_or_else(|| field(name, value, width, depth))
        })
        .collect()
}

fn field(name: &str, value: &Value, width: usize, depth: usize) -> String {
    let indent = "  ".repeat(depth);
    if let Some(words) = in_words(value) {
        return format!("{indent}{name:<width$}  {words}\n");
    }
    match value {
        Value::Object(fields) => format!("{indent}{name}\n{}", block(fields, depth + 1)),
        Value::Array(members) => members
            .iter()
            .enumerate()
            .map(|(place, member)| field(&format!("{name} {}", place + 1), member, 0, depth))
            .collect(),
        other => format!("{indent}{name}  {other}\n"),
    }
}

/// What fits onto one line: numbers, angles, points, lines, words and lists of them.
fn in_words(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some("—".to_owned()),
        Value::Bool(flag) => Some(if *flag { "yes" } else { "no" }.to_owned()),
        Value::Number(number) => Some(number.to_string()),
        Value::String(text) => Some(text.clone()),
        Value::Array(members) => list(members),
        Value::Object(fields) => object(fields),
    }
}

/// Two numbers are a point; more are a row.
fn list(members: &[Value]) -> Option<String> {
    let words: Option<Vec<String>> = members.iter().map(in_words).collect();
    let words = words?;
    let is_number = |value: &Value| value.is_number() || numeral(value).is_some();
    match words.as_slice() {
        [] => Some("none".to_owned()),
        [x, y] if members.iter().all(is_number) => Some(format!("({x}, {y})")),
        words => Some(words.join(", ")),
    }
}

fn object(fields: &Map<String, Value>) -> Option<String> {
    let names: Vec<&str> = fields.keys().map(String::as_str).collect();
    let part = |name: &str| fields.get(name).and_then(in_words);
    match names.as_slice() {
        ["exact"] | ["value", "radius"] => numeral_of(fields),
        ["degrees"] => Some(format!("{} degrees", part("degrees")?)),
        ["re", "im"] => Some(format!("{}  +  i · {}", part("re")?, part("im")?)),
        ["infinite"] => Some("infinite".to_owned()),
        ["undetermined"] => Some("undetermined".to_owned()),
        ["at_infinity"] => Some(format!(
            "at infinity in the direction {}",
            part("at_infinity")?
        )),
        _ => None,
    }
}

fn numeral(value: &Value) -> Option<String> {
    numeral_of(value.as_object()?)
}

fn numeral_of(fields: &Map<String, Value>) -> Option<String> {
    let text = |name: &str| fields.get(name).and_then(Value::as_str);
    match (text("exact"), text("value"), text("radius")) {
        (Some(exact), ..) => Some(exact.to_owned()),
        (None, Some(value), Some(radius)) => Some(format!("{value} ± {radius}")),
        _ => None,
    }
}
