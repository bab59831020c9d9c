//! The corpora of problems and answers: their form, and what they say, as far as a sample tells.
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test that cannot read what it tests has failed"
)]

use crate::support::seed;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::support::schemas::{assert_valid, validator};
use burmester::number::text::parse_rational;
use burmester::oracle::vectors::{
    CORPORA, Corpus, Entry, Folder, answer_line, defects_of_form, sha256,
};
use jsonschema::Validator;
use rug::Rational;
use serde_json::{Value, json};

/// The sample: every so manyth problem; all where BURMESTER_LONG is 1.
fn step() -> usize {
    if seed::rounds(1) > 1 { 1 } else { 40 }
}

fn folder() -> Folder {
    Folder::at(Path::new("data"))
}

fn entries(corpus: &Corpus) -> Vec<Entry> {
    folder().entries(corpus.name).unwrap()
}

#[test]
fn every_file_belongs_to_a_corpus() {
    let names: BTreeSet<String> = CORPORA
        .iter()
        .map(|corpus| corpus.name.to_owned())
        .collect();
    for kind in ["problems", "answers"] {
        let files: BTreeSet<String> = fs::read_dir(Path::new("data").join(kind))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .filter_map(|name| name.strip_suffix(".jsonl").map(str::to_owned))
            .collect();
        assert_eq!(files, names, "{kind}");
    }
    let total: usize = CORPORA.iter().map(|corpus| entries(corpus).len()).sum();
    assert!(total >= 2000, "{total} problems");
}

#[test]
fn lines_have_their_form() {
    let line = validator("corpus-line");
    let answer_line = validator("answer-line");
    let mut of_kind: BTreeMap<String, [Validator; 2]> = BTreeMap::new();
    let flags = folder().flags().unwrap();
    let mut ids = BTreeSet::new();
    let mut used = BTreeSet::new();
    for corpus in &CORPORA {
        for entry in entries(corpus) {
            let Entry { problem, answer } = &entry;
            let id = problem["id"].as_str().unwrap();
            assert!(ids.insert(id.to_owned()), "{id} twice");
            assert_valid(&line, problem, id);
            assert_valid(&answer_line, answer, id);
            let kind = problem["problem"].as_str().unwrap();
            let validators = of_kind.entry(kind.to_owned()).or_insert_with(|| {
                ["problem", "answer"].map(|side| validator(&format!("{kind}.{side}")))
            });
            assert_valid(&validators[0], problem, id);
            assert_valid(&validators[1], &answer["answer"], id);
            let defects = defects_of_form(corpus.name, &entry, &flags);
            assert!(defects.is_empty(), "{id}: {defects:?}");
            let words = problem["flags"].as_array().unwrap();
            used.extend(words.iter().map(|flag| flag.as_str().unwrap().to_owned()));
        }
    }
    let explained: BTreeSet<String> = flags.keys().cloned().collect();
    assert_eq!(
        used, explained,
        "flags that are used, and that are explained"
    );
}

#[test]
fn files_are_those_that_are_recorded() {
    let recorded = folder().recorded().unwrap();
    assert_valid(&validator("corpora"), &json!(recorded), "corpora.json");
    assert_eq!(recorded.len(), CORPORA.len());
    for corpus in &CORPORA {
        assert_eq!(
            recorded.get(corpus.name),
            Some(&folder().record(corpus).unwrap()),
            "{}",
            corpus.name
        );
    }
    // The hash of nothing, as everybody knows it.
    assert!(sha256(b"").starts_with("e3b0c44298fc1c14"));
}

#[test]
fn problems_are_what_their_generator_makes() {
    for corpus in &CORPORA {
        let path = Path::new("data/problems").join(format!("{}.jsonl", corpus.name));
        let text = fs::read_to_string(path).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines == corpus.lines(), "{}", corpus.name);
    }
}

#[test]
fn answers_are_what_is_computed() {
    for corpus in &CORPORA {
        for entry in entries(corpus).iter().step_by(step()) {
            let anew = answer_line(&entry.problem).unwrap();
            assert!(anew == entry.answer, "{}", entry.problem["id"]);
        }
    }
}

fn number(value: &Value) -> Rational {
    parse_rational(value.as_str().unwrap()).unwrap()
}

/// Whether a number that went out holds a value.
fn holds(shown: &Value, value: &Rational) -> bool {
    match shown["exact"].as_str() {
        Some(exact) => parse_rational(exact).unwrap() == *value,
        None => (number(&shown["value"]) - value).abs() <= number(&shown["radius"]),
    }
}

fn holds_point(shown: &Value, value: &Value) -> bool {
    shown.is_array() && (0..2).all(|axis| holds(&shown[axis], &number(&value[axis])))
}

/// Whether two directions are the same up to a factor.
fn same_direction(shown: &Value, value: &Value) -> bool {
    let part = |axis: usize| parse_rational(shown[axis]["exact"].as_str().unwrap()).unwrap();
    part(0) * number(&value[1]) == part(1) * number(&value[0])
}

/// Claims that the answer does not bear out.
fn refuted(problem: &Value, answer: &Value) -> Vec<String> {
    let mut refuted = Vec::new();
    let members = |name: &str| answer[name].as_array().cloned().unwrap_or_default();
    for (name, claim) in problem["claims"].as_object().unwrap() {
        let all = |found: &dyn Fn(&Value) -> bool| claim.as_array().unwrap().iter().all(found);
        let poles = |kind: &str| {
            let poles = answer["poles"].as_object().unwrap().values();
            json!(poles.filter(|pole| pole.get(kind).is_some()).count())
        };
        let right = match name.as_str() {
            "known_pairs" | "pairs" => all(&|claim| {
                members("pairs").iter().any(|pair| {
                    holds_point(&pair["circlepoint"], &claim["circlepoint"])
                        && holds_point(&pair["center"], &claim["center"])
                })
            }),
            "slides" => all(&|claim| {
                members("at_infinity").iter().any(|pair| {
                    pair["kind"] == "center"
                        && holds_point(&pair["circlepoint"], &claim["circlepoint"])
                        && same_direction(&pair["direction"], &claim["direction"])
                })
            }),
            "turning_blocks" => all(&|claim| {
                members("at_infinity").iter().any(|pair| {
                    pair["kind"] == "circlepoint"
                        && holds_point(&pair["center"], &claim["center"])
                        && same_direction(&pair["direction"], &claim["direction"])
                })
            }),
            "counts" => answer["counts"] == *claim,
            "family" => answer["family"].get("kind").unwrap_or(&Value::Null) == claim,
            "listed" => json!(members("pairs").len()) == *claim,
            "at_infinity" => {
                let list = members("at_infinity").into_iter();
                let mut kinds: Vec<Value> = list.map(|pair| pair["kind"].clone()).collect();
                kinds.sort_by_key(Value::to_string);
                json!(kinds) == *claim
            }
            "poles_at_infinity" => poles("at_infinity") == *claim,
            "undetermined_poles" => poles("undetermined") == *claim,
            "type" => answer["centerpoint"]["type"] == *claim,
            _ => false,
        };
        if !right {
            refuted.push(format!("{name}: {claim}"));
        }
    }
    refuted
}

#[test]
fn claims_are_borne_out() {
    let mut tried = 0;
    for corpus in &CORPORA {
        for Entry { problem, answer } in entries(corpus) {
            let refuted = refuted(&problem, &answer["answer"]);
            assert!(refuted.is_empty(), "{}: {refuted:?}", problem["id"]);
            tried += problem["claims"].as_object().unwrap().len();
        }
    }
    assert!(tried > 500, "only {tried} claims");
}

#[test]
fn a_wrong_claim_is_noticed() {
    for (corpus, name, wrong) in [
        (
            "five-positions-of-linkages",
            "known_pairs",
            json!([{"circlepoint": ["1/97", "2"], "center": ["3", "4"]}]),
        ),
        (
            "sliders",
            "slides",
            json!([{"circlepoint": ["1/97", "2"], "direction": ["3", "4"]}]),
        ),
        (
            "sliders",
            "turning_blocks",
            json!([{"center": ["1/97", "2"], "direction": ["3", "4"]}]),
        ),
        ("degenerate-four-positions", "poles_at_infinity", json!(6)),
        ("degenerate-four-positions", "undetermined_poles", json!(5)),
        (
            "degenerate-four-positions",
            "type",
            json!("hyperbola-of-hyperbolas"),
        ),
        ("random-five-positions", "counts", json!({"real": 5})),
        ("random-five-positions", "unheard-of", json!(1)),
    ] {
        let entry = &entries(Corpus::named(corpus).unwrap())[0];
        let mut problem = entry.problem.clone();
        problem["claims"] = json!({name: wrong});
        assert!(
            !refuted(&problem, &entry.answer["answer"]).is_empty(),
            "{name}"
        );
    }
}
