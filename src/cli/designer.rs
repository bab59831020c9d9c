//! Linkages for a designer: what each of them does, a line for each drive.

use serde_json::{Map, Value};

/// The linkages of an answer; `None` where it has no such list.
pub fn linkages(answer: &Map<String, Value>, depth: usize) -> Option<String> {
    let list = answer.get("linkages")?.as_array()?;
    let infinite = answer.get("at_infinity").unwrap_or(&Value::Null);
    let indent = "  ".repeat(depth);
    if list.is_empty() {
        return Some(format!("{indent}linkages  none\n"));
    }
    let linkages: Option<Vec<String>> = list
        .iter()
        .enumerate()
        .map(|(place, value)| linkage(place, value, infinite, &indent))
        .collect();
    Some(linkages?.concat())
}

/// The places of linkages that fulfil all wishes.
pub fn ranked(list: &Value, depth: usize) -> Option<String> {
    let places: Option<Vec<String>> = list
        .as_array()?
        .iter()
        .map(|place| Some(format!("linkage {}", place.as_u64()? + 1)))
        .collect();
    let places = places?;
    let words = if places.is_empty() {
        "no linkage fulfils all wishes".to_owned()
    } else {
        format!(
            "all wishes are fulfilled, best first, by {}",
            places.join(", ")
        )
    };
    Some(format!("{}{words}\n", "  ".repeat(depth)))
}

fn linkage(place: usize, value: &Value, infinite: &Value, indent: &str) -> Option<String> {
    let pairs = value.get("pairs")?.as_array()?.iter();
    let names: Option<Vec<String>> = pairs.map(|pair| name(pair, infinite)).collect();
    let names = names?;
    let kind = value.get("type")?.as_str().unwrap_or("type undecided");
    let mut text = format!(
        "{indent}linkage {}  {kind} of {}\n",
        place + 1,
        names.join(" and ")
    );
    let defects: Vec<&str> = words(value.get("defects")).collect();
    for (drive, name) in ["first", "second"].iter().zip(&names) {
        let part = |field: &str| value.get(field).and_then(|both| both.get(drive));
        let turns = match part("crank") {
            Some(Value::Bool(true)) => " (turns fully)",
            Some(Value::Bool(false)) if !name.starts_with("slide") => " (rocks)",
            _ => "",
        };
        let words = match part("branch") {
            Some(Value::Bool(false)) => defects
                .iter()
                .find_map(|defect| of_drive(defect, drive))
                .unwrap_or("does not reach all positions")
                .to_owned(),
            _ => passage(part("order"), part("transmission")),
        };
        text += &format!("{indent}  driven at {name}{turns}: {words}\n");
    }
    for defect in &defects {
        let said = ["first", "second"].map(|drive| of_drive(defect, drive));
        if said == [None, None] {
            text += &format!("{indent}  defect: {defect}\n");
        }
    }
    match value.get("fulfils") {
        Some(Value::Bool(true)) => text += &format!("{indent}  all wishes fulfilled\n"),
        Some(_) => {
            for miss in words(value.get("misses")) {
                text += &format!("{indent}  wish not fulfilled: {miss}\n");
            }
        }
        None => {}
    }
    Some(text)
}

/// As the lists of pairs name them, counted from 1.
fn name(pair: &Value, infinite: &Value) -> Option<String> {
    let Some(place) = pair.get("at_infinity") else {
        return Some(format!("pair {}", pair.as_u64()? + 1));
    };
    let place = usize::try_from(place.as_u64()?).ok()?;
    let kind = match infinite.get(place)?.get("kind")?.as_str()? {
        "center" => "slide",
        _ => "turning block",
    };
    Some(format!("{kind} at_infinity {}", place + 1))
}

/// What a defect says of one drive.
fn of_drive<'a>(defect: &'a str, drive: &str) -> Option<&'a str> {
    defect.strip_prefix(&format!("driven at the {drive} pair, "))
}

fn passage(order: Option<&Value>, transmission: Option<&Value>) -> String {
    let numbers: Vec<String> = order
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
        .map(Value::to_string)
        .collect();
    let mut parts = Vec::new();
    if !numbers.is_empty() {
        parts.push(format!("positions in order {}", numbers.join(", ")));
    }
    let angle = |end: &str| degrees(transmission?.get(end)?);
    if let (Some(least), Some(greatest)) = (angle("least"), angle("greatest")) {
        parts.push(format!("transmission angle from {least}° to {greatest}°"));
    }
    if parts.is_empty() {
        "nothing can be said".to_owned()
    } else {
        parts.join("; ")
    }
}

/// A number to a tenth.
fn degrees(number: &Value) -> Option<String> {
    let text = number
        .get("exact")
        .or_else(|| number.get("value"))
        .unwrap_or(number);
    let float: f64 = match text {
        Value::String(text) => text.parse().ok()?,
        Value::Number(number) => number.as_f64()?,
        _ => return None,
    };
    Some(format!("{float:.1}"))
}

fn words(list: Option<&Value>) -> impl Iterator<Item = &str> {
    let list = list.and_then(Value::as_array).into_iter().flatten();
    list.filter_map(Value::as_str)
}
