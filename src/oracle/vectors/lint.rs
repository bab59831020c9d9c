//! The form of a line of a corpus.

use serde_json::{Map, Value};

use super::Entry;

/// What is wrong with the form of a problem and its answer, in words.
pub fn defects_of_form(corpus: &str, entry: &Entry, flags: &Map<String, Value>) -> Vec<String> {
    let Entry { problem, answer } = entry;
    let mut defects = Vec::new();
    let id = problem["id"].as_str().unwrap_or_default();
    if id
        .strip_prefix(corpus)
        .is_none_or(|rest| !rest.starts_with('/'))
    {
        defects.push(format!("the id does not begin with {corpus}/"));
    }
    if problem["kind"].as_str().is_none_or(str::is_empty) {
        defects.push("the kind is missing".to_owned());
    }
    if !problem["claims"].is_object() {
        defects.push("the claims are missing".to_owned());
    }
    match problem["flags"].as_array() {
        None => defects.push("the flags are missing".to_owned()),
        Some(list) => {
            for flag in list {
                let flag = flag.as_str().unwrap_or_default();
                if !flags.contains_key(flag) {
                    defects.push(format!("the flag `{flag}` is not explained in flags.json"));
                }
            }
        }
    }
    let condition = &answer["condition"];
    if !condition.is_null() && condition.as_f64().is_none_or(|value| value <= 0.0) {
        defects.push("the condition is neither null nor a positive number".to_owned());
    }
    let own = &answer["answer"];
    for (name, expected) in [("id", &problem["id"]), ("problem", &problem["problem"])] {
        if own[name] != *expected {
            defects.push(format!("the answer's field `{name}` is not the problem's"));
        }
    }
    defects
}
