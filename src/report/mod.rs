//! Pictures of answers.

mod canvas;
mod centerpoint_curve;
mod chart;
mod complex;
mod contour;
mod curvature;
mod deviation;
pub mod errata;
mod five_positions;
mod focal_mechanism;
mod four_bar;
mod frames;
pub mod gallery;
mod growth;
mod hart;
mod labels;
mod linkage_panels;
mod mixed_positions;
mod moving;
mod plot;
mod poles;
#[cfg(feature = "command")]
pub mod site;
mod skeleton;
mod slider_crank;
mod straight_line;
mod stretches;
mod three_positions;

pub use canvas::Point;
pub use chart::picture as chart;
pub use deviation::{Points, picture_with as deviation_with_points};

use serde_json::Value;

/// A picture of a solved problem as SVG; `None` for kinds of problem that have none, and for answers
/// with nothing to show.
pub fn picture(problem: &Value, answer: &Value) -> Option<String> {
    match answer.get("problem")?.as_str()? {
        "centerpoint-curve" => centerpoint_curve::picture(problem, answer),
        "curvature" => curvature::picture(problem, answer),
        "deviation" => deviation::picture(answer),
        "five-positions" => five_positions::picture(problem, answer),
        "focal-mechanism" => focal_mechanism::picture(problem, answer),
        "four-bar" => four_bar::picture(answer),
        "hart" => hart::picture(answer),
        "mixed-positions" => mixed_positions::picture(problem, answer),
        "poles" => poles::picture(problem, answer),
        "slider-crank-alternates" => slider_crank::picture(problem, answer),
        "straight-line" => straight_line::picture(answer),
        "three-positions" => three_positions::picture(problem, answer),
        _ => None,
    }
}

/// The same with a mechanism that moves when it is told to; `None` for kinds of problem without one.
fn moving_picture(problem: &Value, answer: &Value) -> Option<String> {
    match answer.get("problem")?.as_str()? {
        "focal-mechanism" => focal_mechanism::moving_picture(problem, answer),
        "hart" => hart::moving_picture(answer),
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

/// A finite point of an answer.
fn finite_point(value: &Value) -> Option<canvas::Point> {
    match value.as_array()?.as_slice() {
        [x, y] => Some([number(x)?, number(y)?]),
        _ => None,
    }
}

/// So many numbers.
fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let list: Option<Vec<f64>> = value.as_array()?.iter().map(number).collect();
    list?.try_into().ok()
}
