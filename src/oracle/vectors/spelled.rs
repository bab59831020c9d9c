//! Positions that are not given by rational cosines and sines.

use serde_json::{Value, json};

use super::Problem;
use super::draw::Draw;
use super::pose;
use crate::number::{Exact, Number, count};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// The same problems with another spelling of the positions.
fn problem(draw: &mut Draw, positions: &[Value], kind: &str, flag: &'static str) -> Problem {
    let input = match positions.len() {
        3 => json!({
            "problem": "three-positions",
            "positions": positions,
            "circlepoints": [pose::point(&draw.point()), pose::point(&draw.point())],
            "centers": [pose::point(&draw.point())],
        }),
        4 => json!({"problem": "centerpoint-curve", "positions": positions}),
        _ => json!({"problem": "five-positions", "positions": positions}),
    };
    Problem::new(kind, &[flag], input)
}

pub fn in_degrees(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    let kinds = ["degrees", "tenths of degrees", "radians"];
    for kind in kinds.into_iter().cycle().take(42) {
        for count in [3, 4, 5] {
            let positions: Vec<Value> = (0..count)
                .map(|_| {
                    let angle = match kind {
                        "degrees" => json!({"degrees": draw.integer(179).to_string()}),
                        "radians" => json!({"radians": decimal(draw.integer(310), 2)}),
                        _ => json!({"degrees": decimal(draw.integer(1799), 1)}),
                    };
                    json!({
                        "x": draw.number().to_string(),
                        "y": draw.number().to_string(),
                        "angle": angle,
                    })
                })
                .collect();
            problems.push(problem(draw, &positions, kind, "irrational-input"));
        }
    }
    for round in 0..12 {
        let count = 3 + round % 3;
        let positions: Vec<Value> = (0..count)
            .map(|_| {
                let step = draw.integer(11) * 15;
                json!({
                    "x": draw.integer(9).to_string(),
                    "y": draw.integer(9).to_string(),
                    "angle": {"degrees": step.to_string()},
                })
            })
            .collect();
        let kind = "multiples of 15 degrees";
        problems.push(problem(draw, &positions, kind, "irrational-input"));
    }
    problems
}

/// An integer with its last digits behind the point.
fn decimal(integer: i64, digits: u32) -> String {
    let unit = 10_i64.pow(digits);
    let sign = if integer < 0 { "-" } else { "" };
    let (whole, rest) = (integer.abs() / unit, integer.abs() % unit);
    format!(
        "{sign}{whole}.{rest:0width$}",
        width = count::from_u32(digits)
    )
}

pub fn by_two_points(draw: &mut Draw) -> Vec<Problem> {
    let mut problems = Vec::new();
    for round in 0..34 {
        for count in [3, 4, 5] {
            let (p, along) = (draw.point(), draw.direction());
            let ends = [p.clone(), p + along];
            let positions: Vec<Value> = (0..count)
                .map(|place| {
                    let position = Displacement {
                        rotation: if place == 0 {
                            Number::one()
                        } else {
                            draw.turn()
                        },
                        translation: if place == 0 {
                            Number::zero()
                        } else {
                            draw.point()
                        },
                    };
                    let ends = ends.each_ref().map(|end| position.of(end));
                    given(draw, &ends, round % 4 == 3)
                })
                .collect();
            let kind = if round % 4 == 3 {
                "two points, fitted"
            } else {
                "two points"
            };
            problems.push(problem(draw, &positions, kind, "two-points"));
        }
    }
    problems
}

/// Two points; to be fitted, rounded to thousandths, as measured ones are.
fn given(draw: &mut Draw, ends: &[Point<Exact>; 2], fitted: bool) -> Value {
    if !fitted {
        return json!({"points": ends.each_ref().map(pose::point)});
    }
    let mut measured = |x: &Number<Exact>| {
        let thousandths = (x * 1000).0.rational().cloned().unwrap_or_default();
        let (_, rounded) = thousandths.fract_round(rug::Integer::new());
        let rounded = rounded + draw.integer(2);
        decimal(rounded.to_i64().unwrap_or_default(), 3)
    };
    let points = ends
        .each_ref()
        .map(|end| [measured(end.re()), measured(end.im())]);
    json!({"points": points, "fit": true})
}
