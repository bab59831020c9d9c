//! What becomes of the mutants of some lines, in full: those that are left open are few and known.
#![allow(
    clippy::expect_used,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::ledger::{Judge, Options, built_in};

/// Tried, rejected, proved to hold as well, undecided.
const LINES: [(&str, [usize; 4]); 8] = [
    ("wunderlich1968/eq/1.1", [40, 39, 1, 0]),
    ("wunderlich1968/eq/1.7", [33, 30, 3, 0]),
    ("wunderlich1968/claim/hart-line", [7, 5, 2, 0]),
    ("filemon1973/eq/7a", [24, 22, 2, 0]),
    ("filemon1973/claim/conclusion-1", [51, 36, 6, 9]),
    ("tesar1964/eq/4.13", [15, 9, 6, 0]),
    ("tesar1964/eq/4.14", [41, 39, 0, 2]),
    ("tesar1964/claim/watt-burmester-point", [31, 26, 5, 0]),
];

#[test]
fn counts_are_those_that_are_known() {
    let papers = built_in().expect("the papers read");
    let mut judge = Judge::new(Options {
        digits: 10,
        mutants: true,
    });
    for (id, expected) in LINES {
        let mut statements = papers.iter().flat_map(|paper| &paper.statements);
        let statement = statements.find(|statement| statement.id == id);
        let judgement = judge
            .judge(statement.expect("it is there"))
            .expect("it is judged");
        let counts = judgement.mutants.expect("there are mutants");
        let found = [
            counts.tried,
            counts.rejected,
            counts.equivalent,
            counts.undecided,
        ];
        assert_eq!(found, expected, "{id}");
        assert_eq!(counts.survivors.len(), counts.undecided, "{id}");
    }
}
