//! Every statement of the data has the verdict that the data expect.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::sync::OnceLock;

use burmester::ledger::{self, Judged, Options, Paper};
use burmester::report::errata;

/// All sources, judged once for all tests.
fn judged() -> &'static [Judged<'static>] {
    static PAPERS: OnceLock<Vec<Paper>> = OnceLock::new();
    static JUDGED: OnceLock<Vec<Judged<'static>>> = OnceLock::new();
    JUDGED.get_or_init(|| {
        let papers = PAPERS.get_or_init(|| ledger::built_in().unwrap());
        let options = Options {
            digits: 30,
            mutants: false,
        };
        Judged::all(papers, options, || ()).unwrap()
    })
}

#[test]
fn every_statement_has_its_expected_verdict() {
    let mut count = 0;
    for paper in judged() {
        assert_eq!(paper.judgements.len(), paper.paper.total);
        count += paper.judgements.len();
        for one in paper.decided() {
            let (statement, judgement) = (one.statement, one.judgement);
            assert_eq!(
                judgement.verdict, statement.expected,
                "{}: {judgement:?}",
                statement.id
            );
        }
    }
    assert_eq!(count, 1061);
}

#[test]
fn the_list_of_errata_is_up_to_date() {
    let computed = errata::markdown(judged());
    assert!(
        computed == include_str!("../ERRATA.md"),
        "ERRATA.md differs from what is computed; `burmester report -o site` writes site/ERRATA.md, copy it"
    );
}
