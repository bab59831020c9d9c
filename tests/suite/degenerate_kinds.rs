//! Degenerate positions: the facts that `data/problems/degenerate-five-positions.jsonl` derives for each,
//! against what is computed.
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test that cannot read what it tests has failed"
)]

use std::collections::BTreeSet;
use std::fs;

use burmester::number::text::parse_rational;
use burmester::oracle::{self, Request};
use rug::Rational;
use serde_json::{Value, json};

fn lines() -> Vec<Value> {
    let text = fs::read_to_string("data/problems/degenerate-five-positions.jsonl").unwrap();
    let lines: Vec<Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert!(!lines.is_empty(), "no line at all");
    lines
}

fn number(value: &Value) -> Rational {
    parse_rational(value.as_str().unwrap()).unwrap()
}

fn point(value: &Value) -> [Rational; 2] {
    [0, 1].map(|axis: usize| number(&value[axis]))
}

/// Cosine and sine; of degrees only where they are 0 or ±1.
fn turn(angle: &Value) -> Option<[Rational; 2]> {
    let Some(degrees) = angle["degrees"].as_str() else {
        return Some([number(&angle["cos"]), number(&angle["sin"])]);
    };
    let [cos, sin] = match degrees {
        "0" | "360" => [1, 0],
        "90" => [0, 1],
        "180" => [-1, 0],
        "270" => [0, -1],
        _ => return None,
    };
    Some([cos, sin].map(Rational::from))
}

/// |rz + t − M|², exact.
fn squared_radius(
    position: &Value,
    [x, y]: &[Rational; 2],
    [u, v]: &[Rational; 2],
) -> Option<Rational> {
    let [cos, sin] = turn(&position["angle"])?;
    let across = Rational::from(&cos * x) - Rational::from(&sin * y) + number(&position["x"]) - u;
    let up = Rational::from(&sin * x) + Rational::from(&cos * y) + number(&position["y"]) - v;
    Some(across.square() + up.square())
}

#[test]
fn known_pairs_are_pairs() {
    let mut tried = 0;
    for line in lines() {
        for pair in line["claims"]["pairs"].as_array().unwrap() {
            let (z, center) = (point(&pair["circlepoint"]), point(&pair["center"]));
            let positions = line["positions"].as_array().unwrap();
            let squares: Option<BTreeSet<Rational>> = positions
                .iter()
                .map(|position| squared_radius(position, &z, &center))
                .collect();
            let squares = squares.unwrap();
            assert_eq!(squares.len(), 1, "{}: {pair}: {squares:?}", line["id"]);
            tried += 1;
        }
    }
    assert!(tried > 0, "no pair at all");
}

/// Whether a number that went out holds a value.
fn holds(shown: &Value, value: &Rational) -> bool {
    match shown["exact"].as_str() {
        Some(exact) => parse_rational(exact).unwrap() == *value,
        None => {
            let difference = number(&shown["value"]) - value;
            difference.abs() <= number(&shown["radius"])
        }
    }
}

fn holds_point(shown: &Value, value: &Value) -> bool {
    let value = point(value);
    (0..2).all(|axis| holds(&shown[axis], &value[axis]))
}

/// What differs between the answer and the facts, in words.
fn differences(answer: &Value, expected: &Value) -> Vec<String> {
    let mut list = Vec::new();
    let mut compare = |what: &str, found: Value, fact: &Value| {
        if found != *fact {
            list.push(format!("{what} {found} instead of {fact}"));
        }
    };
    let members = |name: &str| answer[name].as_array().cloned().unwrap_or_default();
    compare("counts", answer["counts"].clone(), &expected["counts"]);
    let kind = answer["family"].get("kind").cloned().unwrap_or_default();
    compare("family", kind, &expected["family"]);
    compare("pairs", json!(members("pairs").len()), &expected["listed"]);
    let mut kinds: Vec<String> = members("at_infinity")
        .iter()
        .map(|pair| pair["kind"].as_str().unwrap_or_default().to_owned())
        .collect();
    kinds.sort();
    compare("at infinity", json!(kinds), &expected["at_infinity"]);
    for known in expected["pairs"].as_array().unwrap() {
        let found = members("pairs").into_iter().filter(|pair| {
            holds_point(&pair["circlepoint"], &known["circlepoint"])
                && holds_point(&pair["center"], &known["center"])
                && pair["multiplicity"] == known["multiplicity"]
        });
        compare("found", json!(found.count()), &json!(1));
    }
    let undecided = answer["undecided"].as_str().unwrap_or_default();
    let of_pairs: Vec<&str> = undecided
        .split(", ")
        .filter(|name| !name.is_empty() && !name.starts_with("linkages"))
        .collect();
    compare("undecided", json!(of_pairs), &json!([]));
    list
}

#[test]
fn facts_are_what_is_computed() {
    for line in lines() {
        let answer = oracle::solve(&line, &Request::default()).unwrap();
        let found = differences(&answer, &line["claims"]);
        assert!(found.is_empty(), "{}: {}", line["id"], found.join("; "));
    }
}

#[test]
fn a_wrong_fact_is_noticed() {
    let line = lines()
        .into_iter()
        .find(|line| line["id"] == "degenerate-five-positions/double")
        .unwrap();
    let answer = oracle::solve(&line, &Request::default()).unwrap();
    for (path, wrong) in [
        ("/counts/real", json!(3)),
        ("/family", json!("plane")),
        ("/listed", json!(4)),
        ("/at_infinity", json!(["center"])),
        ("/pairs/0/multiplicity", json!(1)),
        ("/pairs/0/circlepoint/0", json!("1.000001")),
        ("/pairs/0/center/1", json!("0")),
    ] {
        let mut expected = line["claims"].clone();
        *expected.pointer_mut(path).unwrap() = wrong;
        assert!(!differences(&answer, &expected).is_empty(), "{path}");
    }
}
