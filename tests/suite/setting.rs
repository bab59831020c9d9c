//! How formulas are set, every example of the grammar and every function as LaTeX and as MathML, in what
//! two differ, and what is changed in mutants: all in `setting.txt`, which people have read.
//! `BURMESTER_WRITE=1` writes it anew.
#![allow(
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::fmt::Write;

use burmester::formula::{Function, difference, latex, mathml, mutants, normal_form, read};

const FILE: &str = "tests/suite/setting.txt";

/// The left sides of the examples of the grammar.
fn examples() -> impl Iterator<Item = &'static str> {
    let lines = include_str!("../../src/formula/grammar.md").lines();
    lines.filter_map(|line| Some(line.split_once(" ⟶ ")?.0))
}

/// A call of every function.
fn calls() -> impl Iterator<Item = String> {
    const ARGUMENTS: [&str; 4] = ["A", "B", "C", "D"];
    Function::ALL.into_iter().map(|function| {
        let count = (1..=ARGUMENTS.len()).find(|count| function.arity().admits(*count));
        let arguments = ARGUMENTS
            .get(..count.expect("at most four"))
            .expect("as many");
        let arguments = arguments.join(", ");
        let call = match function {
            Function::Det => "det([[A, B], [C, D]])".to_owned(),
            Function::Similar => "similar([A, B, C], [D, E, F])".to_owned(),
            _ => format!("{}({arguments})", function.name()),
        };
        if function.is_predicate() {
            call
        } else {
            format!("{call}^2 = 1/2 x_{{1}}'")
        }
    })
}

/// What the examples lack: functions beside functions, and powers of e.
const MORE: [&str; 11] = [
    "y = sin(alpha) sqrt(x)",
    "y = sin(alpha sqrt(x))",
    "y = sin(2 alpha) |x| conj(z)",
    "y = sin(2 |x| alpha) cos(beta)^2",
    "y = cos(sin(alpha) x) e^(2 i x)",
    "z = e^(i x/2) e^(1/2 i x) e^(-i (x + y))",
    "z = e^(i 2 x) + e^(i (2/3) x)",
    "x = a^(b + 1) (a + b)^-2 (a/b)^(1/2)",
    "x = 1.5e12 a_1'' + 2/3 b_{12} - (-c)",
    "-a : b = c : -d",
    "x = a^(-b) a^(-2 b) a^(-(b + c))",
];

/// Every change of one place.
const MUTATED: [&str; 10] = [
    "x = -a b + 2 sin(x + a)^2",
    "a : b = -x : (x + 1)",
    "x = sum(k a for k in [1, 2]) - a/b",
    "x = sum(a_k for k in [1, 2])",
    "x ≥ a if a > 0 and b < 1",
    "x = 0 iff not a ≠ b",
    "alpha ≡ beta mod pi",
    "x^2 = a_k for k in {1, 2}",
    "det([[a, b], [x, 1]]) = min(a, b) + dist(A, B)",
    "x = e^(i a) conj(b) ± sqrt(3) where a = b/2 assume b > 0",
];

fn mutated(text: &str) -> String {
    let formula = read(text).expect("it reads");
    let names = ["A", "B", "a", "a_1", "a_2", "alpha", "b", "beta", "x"];
    let lines = mutants(&formula, &names)
        .into_iter()
        .map(|mutant| format!("  {}: {}\n", mutant.what, mutant.formula));
    format!("{text}\n{}\n", lines.collect::<String>())
}

fn shown(text: &str) -> String {
    let formula = read(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    let normal =
        normal_form(&formula).map_or_else(|none| none.to_string(), |form| form.to_string());
    format!(
        "{text}\n  latex   {}\n  mathml  {}\n  normal  {normal}\n\n",
        latex(&formula),
        mathml(&formula),
    )
}

/// Two formulas and the parts in which they differ, in brackets.
fn compared(left: &str, right: &str) -> String {
    let [of_left, of_right] = [left, right].map(|text| read(text).expect("it reads"));
    let found = difference(&of_left, &of_right);
    let mark = |text: &str, places: &[std::ops::Range<usize>]| {
        let mut places = places.to_vec();
        places.sort_by_key(|place| std::cmp::Reverse((place.start, place.end)));
        let mut marked = text.to_owned();
        for place in places {
            marked.insert(place.end, ']');
            marked.insert(place.start, '[');
        }
        marked
    };
    format!(
        "{}\n{}\n\n",
        mark(left, &found.left),
        mark(right, &found.right)
    )
}

const COMPARED: [(&str, &str); 10] = [
    ("x = a + b - c", "x = a - b - c"),
    ("x = 2 a b/c", "x = 3 a b/d"),
    ("x = a b; y = c", "x = a; y = c"),
    ("x = sin(a + b)", "x = cos(a + b)"),
    ("x = sqrt(a^2 + b^2)", "x = sqrt(a^2 - b^2)"),
    ("x = y where y = a b", "x = y where y = a c"),
    ("x = y assume a > 0", "x = y assume a > 1"),
    ("x > 0 iff y > 0", "x > 0 iff y < 0"),
    ("x = -a (b + c)", "x = a (b + c)"),
    ("x = {1, 2, 3}", "x = {1, 3}"),
];

#[test]
fn formulas_are_set_as_before() {
    let mut text = String::new();
    let more = MORE.map(str::to_owned);
    for example in examples().map(str::to_owned).chain(more).chain(calls()) {
        text.push_str(&shown(&example));
    }
    for example in MUTATED {
        text.push_str(&mutated(example));
    }
    for (left, right) in COMPARED {
        let _ = write!(text, "{}", compared(left, right));
    }
    if std::env::var("BURMESTER_WRITE").is_ok() {
        std::fs::write(FILE, &text).expect("the file can be written");
    }
    let known = std::fs::read_to_string(FILE).expect("the file is there");
    for (found, expected) in text.split("\n\n").zip(known.split("\n\n")) {
        assert_eq!(found, expected);
    }
    assert_eq!(text.len(), known.len());
}
