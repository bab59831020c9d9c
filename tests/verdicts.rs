//! Every statement of the data has the verdict that the data expect.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::ledger::{self, Judge, Options};

#[test]
fn every_statement_has_its_expected_verdict() {
    let mut judge = Judge::new(Options {
        digits: 30,
        mutants: false,
    });
    let mut wrong = Vec::new();
    for paper in ledger::built_in().unwrap() {
        for statement in &paper.statements {
            match judge.judge(statement) {
                Ok(judgement) if judgement.verdict == statement.expected => {}
                Ok(judgement) => wrong.push(format!(
                    "{}: expected {}, found {} ({:?})",
                    statement.id, statement.expected, judgement.verdict, judgement
                )),
                Err(error) => wrong.push(format!("{}: {error}", statement.id)),
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
