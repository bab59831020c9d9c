//! Five positions of which some have come together.

use serde_json::{Value, json};

use super::Problem;
use super::draw::Draw;
use super::pose;

/// How many positions come together in each place.
const PATTERNS: [&[usize]; 6] = [
    &[2, 1, 1, 1],
    &[2, 2, 1],
    &[3, 1, 1],
    &[3, 2],
    &[4, 1],
    &[5],
];

pub fn positions(draw: &mut Draw) -> Vec<Problem> {
    let patterns = PATTERNS.into_iter().cycle();
    patterns
        .take(150)
        .map(|pattern| {
            let positions: Vec<Value> = pattern.iter().map(|size| group(draw, *size)).collect();
            let name = pattern.iter().map(|size| "P".repeat(*size));
            let kind = name.collect::<Vec<_>>().join("-");
            let input = json!({"problem": "mixed-positions", "positions": positions});
            Problem::new(kind, &["positions-together"], input)
        })
        .collect()
}

/// A position with as many derivatives as more positions have come together in it.
#[expect(clippy::indexing_slicing, reason = "a field of an object")]
fn group(draw: &mut Draw, size: usize) -> Value {
    let (x, y) = (draw.number(), draw.number());
    let derivatives = (1..size).map(|order| {
        // The motion turns, and the parameter is not the angle.
        let angle = if order == 1 {
            draw.positive(3)
        } else {
            draw.integer(3)
        };
        let (x, y) = (draw.number(), draw.number());
        json!({"x": x.to_string(), "y": y.to_string(), "angle": angle.to_string()})
    });
    let derivatives: Vec<Value> = derivatives.collect();
    let mut group =
        json!({"x": x.to_string(), "y": y.to_string(), "angle": pose::angle(&draw.turn())});
    if !derivatives.is_empty() {
        group["derivatives"] = json!(derivatives);
    }
    group
}
