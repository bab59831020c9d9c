//! Every statement of the data has the verdict that the data expect.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use burmester::ledger::{self, Options};

#[test]
fn every_statement_has_its_expected_verdict() {
    let papers = ledger::built_in().unwrap();
    let options = Options {
        digits: 30,
        mutants: false,
    };
    let mut done = 0;
    let judgements = ledger::judge_all(&papers, options, || done += 1);
    let judgements: Vec<_> = judgements.into_iter().flatten().collect();
    let statements: Vec<_> = papers.iter().flat_map(|paper| &paper.statements).collect();
    assert_eq!([done, judgements.len()], [statements.len(); 2]);
    let mut wrong = Vec::new();
    for (statement, judgement) in statements.iter().zip(judgements) {
        match judgement {
            Ok(judgement) if judgement.verdict == statement.expected => {}
            Ok(judgement) => wrong.push(format!(
                "{}: expected {}, found {} ({:?})",
                statement.id, statement.expected, judgement.verdict, judgement
            )),
            Err(error) => wrong.push(format!("{}: {error}", statement.id)),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
