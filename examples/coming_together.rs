//! Five positions come together: their Burmester pairs become those of one position of the motion.
//!
//! A motion with x(t), y(t) and the angle θ(t) is taken at t = 0, h, 2h, 3h, 4h for smaller and smaller
//! h, then at t = 0 alone with its first four derivatives.

use burmester::number::text::parse_rational;
use burmester::oracle::{ProblemError, Request, solve};
use serde_json::{Value, json};

/// Prints a table.
///
/// # Errors
/// None for this motion.
pub fn main() -> Result<(), ProblemError> {
    println!("{:<8}  farthest from the limit", "h");
    for (h, distance) in distances()? {
        println!("{h:<8}  {distance:.3e}");
    }
    Ok(())
}

/// Coefficients of t, t², t³, t⁴ over n!: the derivatives in t = 0.
const X: [i64; 4] = [2, -1, 3, 1];
const Y: [i64; 4] = [0, 4, 2, -5];
const ANGLE: [i64; 4] = [1, 1, -2, 2];

/// For each h, how far a point of a pair is from the one that it comes to, at most.
///
/// # Errors
/// None for this motion.
pub fn distances() -> Result<Vec<(String, f64)>, ProblemError> {
    let terms = X.iter().zip(Y).zip(ANGLE);
    let derivatives: Vec<Value> = terms
        .map(|((x, y), angle)| json!({"x": x, "y": y, "angle": angle}))
        .collect();
    let limit = pairs(&json!({"problem": "mixed-positions", "positions": [
        {"x": 0, "y": 0, "angle": {"radians": 0}, "derivatives": derivatives},
    ]}))?;
    let mut rows = Vec::new();
    for zeros in [2, 4, 6, 8] {
        let positions: Vec<Value> = (0..5)
            .map(|step| {
                let at = |derivatives: [i64; 4]| taylor(derivatives, step, zeros);
                json!({"x": at(X), "y": at(Y), "angle": {"radians": at(ANGLE)}})
            })
            .collect();
        let found = pairs(&json!({"problem": "five-positions", "positions": positions}))?;
        let distance = |pair: &[f64; 4]| {
            let to = |other: &[f64; 4]| {
                let parts = pair.iter().zip(other).map(|(a, b)| (a - b).abs());
                parts.fold(0.0, f64::max)
            };
            found.iter().map(to).fold(f64::INFINITY, f64::min)
        };
        let farthest = limit.iter().map(distance).fold(0.0, f64::max);
        rows.push((format!("1e-{zeros}"), farthest));
    }
    Ok(rows)
}

/// Σ dₙ tⁿ/n! for t = step · 10^−zeros, as a fraction.
fn taylor(derivatives: [i64; 4], step: i64, zeros: u32) -> String {
    // Over 24 · 10^(4 zeros).
    let [a, b, c, d] = derivatives.map(i128::from);
    let (step, ten) = (i128::from(step), |power: u32| 10i128.pow(power * zeros));
    let sum = 24 * a * step * ten(3)
        + 12 * b * step.pow(2) * ten(2)
        + 4 * c * step.pow(3) * ten(1)
        + d * step.pow(4);
    format!("{sum}/{}", 24 * ten(4))
}

/// Real pairs, by x, y, X, Y.
fn pairs(problem: &Value) -> Result<Vec<[f64; 4]>, ProblemError> {
    let answer = solve(problem, &Request::default())?;
    let float = |value: &Value| {
        let text = value.get("exact").or_else(|| value.get("value"));
        let number = text
            .and_then(Value::as_str)
            .and_then(|text| parse_rational(text).ok());
        number.map_or(f64::NAN, |number| number.to_f64())
    };
    let list = answer.get("pairs").and_then(Value::as_array);
    let list = list.into_iter().flatten();
    let coordinates = list.map(|pair| {
        let (z, m) = (&pair["circlepoint"], &pair["center"]);
        [&z[0], &z[1], &m[0], &m[1]].map(float)
    });
    Ok(coordinates.collect())
}
