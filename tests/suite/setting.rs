//! How formulas are set: every example of the grammar and every function, as LaTeX and as MathML, in
//! `setting.txt`, which people have read. `BURMESTER_WRITE=1` writes it anew.
#![allow(
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::fmt::Write;

use burmester::formula::{Function, difference, latex, mathml, normal_form, read};

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
        let arguments = ARGUMENTS[..count.expect("at most four")].join(", ");
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
    for example in examples().map(str::to_owned).chain(calls()) {
        text.push_str(&shown(&example));
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
