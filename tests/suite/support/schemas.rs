//! The schemas of `data/schema`.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot read what it tests has failed"
)]

use std::fs;
use std::path::Path;

use jsonschema::{Resource, Validator};
use serde_json::Value;

/// Those that others refer to.
const COMMON: [&str; 4] = [
    "number",
    "geometry",
    "five-positions.answer",
    "straight-line.problem",
];

fn schema(name: &str) -> Value {
    let path = Path::new("data/schema").join(format!("{name}.json"));
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

pub fn validator(name: &str) -> Validator {
    let resource = |name: &str| {
        (
            format!("burmester:{name}"),
            Resource::from_contents(schema(name)).unwrap(),
        )
    };
    jsonschema::options()
        .with_resources(COMMON.map(resource).into_iter())
        .build(&schema(name))
        .unwrap()
}

pub fn assert_valid(validator: &Validator, value: &Value, what: &str) {
    let errors: Vec<String> = validator
        .iter_errors(value)
        .map(|error| format!("{}: {error}", error.instance_path))
        .collect();
    assert!(errors.is_empty(), "{what}: {}", errors.join("; "));
}
