//! Positions of small fractions.

use serde_json::{Value, json};

use super::Problem;
use super::draw::Draw;
use super::pose;

/// A position by x, y and an angle, by the tangent of its half or by cosine and sine.
fn position(draw: &mut Draw) -> Value {
    let (x, y) = (draw.number(), draw.number());
    let angle = if draw.below(2) == 0 {
        json!({"tan_half": draw.half().to_string()})
    } else {
        pose::angle(&draw.turn())
    };
    json!({"x": x.to_string(), "y": y.to_string(), "angle": angle})
}

fn list(draw: &mut Draw, count: usize) -> Vec<Value> {
    (0..count).map(|_| position(draw)).collect()
}

fn points(draw: &mut Draw, count: u32) -> Vec<Value> {
    (0..count).map(|_| pose::point(&draw.point())).collect()
}

#[expect(
    clippy::indexing_slicing,
    reason = "at least two positions; a field of an object"
)]
pub fn poles(draw: &mut Draw) -> Vec<Problem> {
    let problem = |place: usize, draw: &mut Draw| {
        let count = 2 + place % 8;
        let mut positions = list(draw, count);
        let kind = match (place / 8) % 5 {
            3 => {
                // The first angle for the last position as well.
                let angle = positions[0]["angle"].clone();
                positions[count - 1]["angle"] = angle;
                "two parallel positions"
            }
            4 => {
                positions[count - 1] = positions[0].clone();
                "two equal positions"
            }
            _ => "any positions",
        };
        let flags: &[&str] = match kind {
            "two parallel positions" => &["parallel-positions"],
            "two equal positions" => &["equal-positions"],
            _ => &[],
        };
        let input = json!({"problem": "poles", "positions": positions});
        Problem::new(kind, flags, input)
    };
    (0..160).map(|place| problem(place, draw)).collect()
}

pub fn three_positions(draw: &mut Draw) -> Vec<Problem> {
    let problem = |draw: &mut Draw| {
        let positions = list(draw, 3);
        let (circlepoints, centers) = (1 + draw.below(3), draw.below(3));
        let input = json!({
            "problem": "three-positions",
            "positions": positions,
            "circlepoints": points(draw, circlepoints),
            "centers": points(draw, centers),
        });
        Problem::new("any positions", &[], input)
    };
    (0..200).map(|_| problem(draw)).collect()
}

pub fn four_positions(draw: &mut Draw) -> Vec<Problem> {
    let problem = |draw: &mut Draw| {
        let input = json!({"problem": "centerpoint-curve", "positions": list(draw, 4)});
        Problem::new("any positions", &[], input)
    };
    (0..250).map(|_| problem(draw)).collect()
}

pub fn five_positions(draw: &mut Draw) -> Vec<Problem> {
    let problem = |draw: &mut Draw| {
        let input = json!({"problem": "five-positions", "positions": list(draw, 5)});
        Problem::new("any positions", &[], input)
    };
    (0..400).map(|_| problem(draw)).collect()
}
