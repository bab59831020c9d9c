//! Floats against certified values; the tolerance is a few times what was measured.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use approx::assert_relative_eq;
use burmester::oracle::{self, Arithmetic, Request};
use serde_json::{Value, json};

/// All numbers of an answer, by their path.
fn numbers(path: &str, value: &Value, found: &mut Vec<(String, f64)>) {
    match value {
        Value::Number(number) => found.push((path.to_owned(), number.as_f64().unwrap())),
        Value::Object(fields) => {
            for name in ["value", "exact"] {
                if let Some(Value::String(text)) = fields.get(name) {
                    let q = burmester::number::text::parse_rational(text).unwrap();
                    found.push((path.to_owned(), q.to_f64()));
                    return;
                }
            }
            for (name, value) in fields {
                numbers(&format!("{path}.{name}"), value, found);
            }
        }
        Value::Array(members) => {
            for (place, member) in members.iter().enumerate() {
                numbers(&format!("{path}[{place}]"), member, found);
            }
        }
        _ => {}
    }
}

fn assert_agree(problem: &Value) {
    let answer = |arithmetic| {
        let request = Request {
            digits: 20,
            arithmetic,
        };
        let mut found = Vec::new();
        let answer = oracle::solve(problem, &request).unwrap();
        numbers("", &answer, &mut found);
        found
    };
    let (certified, floats) = (answer(Arithmetic::Certified), answer(Arithmetic::Float));
    assert_eq!(certified.len(), floats.len(), "{problem}");
    for ((path, right), (other, float)) in certified.iter().zip(&floats) {
        assert_eq!(path, other);
        assert_relative_eq!(*right, *float, max_relative = 1e-12, epsilon = 1e-12);
    }
}

#[test]
fn slider_cranks() {
    for (k, a, d) in [
        ("0.9", "72.5", "45"),
        ("2", "60", "100"),
        ("-3", "20", "130"),
    ] {
        assert_agree(&json!({
            "problem": "slider-crank-alternates", "k": k,
            "alpha_a": {"degrees": a}, "alpha_d": {"degrees": d},
        }));
    }
}

#[test]
fn focal_mechanisms() {
    for (sides, rho) in [
        ([5, 5, 2, 4], "1"),
        ([6, 5, 2, 4], "-1/2"),
        ([9, 7, 3, 8], "3"),
    ] {
        let [a, b, c, d] = sides.map(|side| side.to_string());
        assert_agree(&json!({
            "problem": "focal-mechanism", "a": a, "b": b, "c": c, "d": d, "rho": rho,
        }));
    }
}

/// Half a revolution is no translation, also where rounding leaves a cosine beside −1.
#[test]
fn poles_of_half_revolutions() {
    assert_agree(&json!({"problem": "poles", "positions": [
        {"x": "3", "y": "-5", "angle": {"tan_half": "-1/3"}},
        {"x": "13/7", "y": "-6", "angle": {"cos": "-4/5", "sin": "3/5"}},
        {"x": "1", "y": "2", "angle": {"tan_half": "4"}},
        {"x": "-2", "y": "5", "angle": {"cos": "15/17", "sin": "-8/17"}},
    ]}));
}
