//! Pictures of answers.

mod canvas;
mod complex;
mod contour;
mod focal_mechanism;
mod hart;

use serde_json::Value;

/// A picture of a solved problem as SVG; `None` for kinds of problem that have none, and for answers
/// with nothing to show.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    match answer.get("problem")?.as_str()? {
        "focal-mechanism" => focal_mechanism::picture(problem, answer),
        "hart" => hart::picture(answer),
        _ => None,
    }
}

/// A number of a problem or answer, in any of its forms.
fn number(value: &Value) -> Option<f64> {
    let text = match value {
        Value::Number(number) => number.to_string(),
        Value::String(text) => text.clone(),
        Value::Object(fields) => match (fields.get("exact"), fields.get("value")) {
            (Some(Value::String(text)), _) | (None, Some(Value::String(text))) => text.clone(),
            _ => return None,
        },
        _ => return None,
    };
    let rational = crate::number::text::parse_rational(&text).ok()?;
    Some(rational.to_f64()).filter(|x| x.is_finite())
}
