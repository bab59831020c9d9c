//! What a fuzzer does with bytes: `fuzz/` runs these for hours, the ordinary tests for seconds.

#![allow(
    clippy::panic,
    reason = "a panic is what a fuzzer looks for; in `fuzz/` the lint is off"
)]

pub mod bytes;
pub mod schema;

use burmester::formula::{latex, mathml, mutants, normal_form, read};
use burmester::ledger::read_paper;
use burmester::number::text::parse_rational;
use burmester::oracle::certificate::{Defect, check_answer};
use burmester::oracle::{Arithmetic, PROBLEMS, Request, solve};
use serde_json::Value;

use bytes::Bytes;
use schema::Schema;

/// What formulas are made of.
const WORDS: [&str; 64] = [
    "x",
    "y_1",
    "alpha",
    "O_12",
    "k",
    "2",
    "1/2",
    "0.90",
    "i",
    "pi",
    "+",
    "-",
    "*",
    "/",
    "^",
    "=",
    "≠",
    "<",
    "≤",
    "≡",
    "~",
    ":",
    ",",
    ";",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "|",
    "'",
    "±",
    "∓",
    "sqrt",
    "sin",
    "cos",
    "tan",
    "conj",
    "abs",
    "re",
    "im",
    "angle",
    "dist",
    "line",
    "meet",
    "collinear",
    "concyclic",
    "det",
    "minor",
    "coeff",
    "roots",
    "sum",
    "for",
    "in",
    "where",
    "assume",
    "if",
    "iff",
    "and",
    "mod",
    "deg",
    "..",
    "\n",
];

/// Any text as a formula.
pub fn formula_text(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    let Ok(formula) = read(text) else {
        return;
    };
    let shown = formula.to_string();
    let again =
        read(&shown).unwrap_or_else(|error| panic!("{shown:?} does not read back: {error}"));
    assert_eq!(again.to_string(), shown, "read back differently");
    let _ = (latex(&formula), mathml(&formula), normal_form(&formula));
    for mutant in mutants(&formula, &["x", "y_2", "O_13"]).iter().take(40) {
        let shown = mutant.formula.to_string();
        assert!(
            read(&shown).is_ok(),
            "the mutant {shown:?} does not read back"
        );
    }
}

/// Words of the language in any order.
pub fn formula_words(data: &[u8]) {
    let words: Vec<&str> = data
        .iter()
        .filter_map(|byte| WORDS.get(usize::from(*byte) % WORDS.len()).copied())
        .collect();
    formula_text(words.join(" ").as_bytes());
}

/// Any text through every reader of data.
pub fn data_text(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    let _ = parse_rational(text);
    let _ = read_paper("fuzz.toml", text);
    let Ok(value) = serde_json::from_str::<Value>(text) else {
        return;
    };
    let _ = solve(&value, &request(Arithmetic::Certified));
    let _ = check_answer(&value, &value);
    if let Some([problem, answer]) = value.as_array().map(Vec::as_slice) {
        let _ = check_answer(problem, answer);
    }
}

/// A source of which lines are lost, doubled, exchanged or cut.
pub fn damaged_paper(data: &[u8]) {
    let text = include_str!("../../../data/papers/filemon1970.toml");
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut bytes = Bytes::new(data);
    while !bytes.is_empty() {
        let at = (bytes.below(256) * 256 + bytes.below(256)) % lines.len().max(1);
        let other = (bytes.below(256) * 256 + bytes.below(256)) % lines.len().max(1);
        match bytes.below(5) {
            0 => drop(lines.get(at).is_some().then(|| lines.remove(at))),
            1 => lines.swap(at, other),
            2 => {
                let copy = lines.get(other).cloned().unwrap_or_default();
                lines.insert(at, copy);
            }
            3 => {
                let cut = bytes.below(40);
                if let Some(line) = lines.get_mut(at) {
                    *line = line.chars().skip(cut).collect();
                }
            }
            _ => {
                let word = bytes.of(&WORDS).copied().unwrap_or_default();
                if let Some(line) = lines.get_mut(at) {
                    line.push_str(word);
                }
            }
        }
    }
    let _ = read_paper("fuzz.toml", &lines.join("\n"));
}

/// A problem of some kind that its schema describes, solved in both arithmetics; a certified answer has
/// to bear its own check.
pub fn problem(data: &[u8]) {
    let mut bytes = Bytes::new(data);
    let Some(kind) = bytes.of(&PROBLEMS) else {
        return;
    };
    let Some(schema) = Schema::named(&format!("{kind}.problem")) else {
        panic!("no schema of {kind}");
    };
    let problem = schema.draw(&mut bytes);
    let _ = solve(&problem, &request(Arithmetic::Float));
    let Ok(answer) = solve(&problem, &request(Arithmetic::Certified)) else {
        return;
    };
    if let Err(defect @ Defect::Wrong { .. }) = check_answer(&problem, &answer) {
        panic!("{problem}\n{answer}\n{defect}");
    }
}

fn request(arithmetic: Arithmetic) -> Request {
    Request {
        digits: 12,
        arithmetic,
    }
}
