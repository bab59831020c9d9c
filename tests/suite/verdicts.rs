//! Every statement of the data has the verdict that the data expect, and the list of errata and the site say
//! what was found.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    missing_docs,
    reason = "a test stops where something is wrong"
)]

use std::collections::{HashMap, HashSet};
use std::sync::OnceLock;

use burmester::ledger::{self, Decided, Judged, Options, Paper};
use burmester::report::errata;
use burmester::report::site::site;

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

/// All that is found of a statement beside its verdict, on one line.
fn known(one: Decided<'_>) -> String {
    let found = one.judgement;
    let mut line = format!("{}: {}", one.statement.id, found.proof);
    let mut add = |name: &str, value: Option<String>| {
        if let Some(value) = value {
            line.push_str(&format!("; {name} {value}"));
        }
    };
    add("instances", found.instances.map(|count| count.to_string()));
    add("samples", found.samples.map(|count| count.to_string()));
    add(
        "computed",
        found.computed.as_ref().map(|value| format!("{value:?}")),
    );
    add(
        "certified",
        found.certified.as_ref().map(|value| format!("{value:?}")),
    );
    add("corrected", found.corrected.clone());
    for (name, value) in &found.counterexample {
        add(name, Some(value.clone()));
    }
    add("evidence", Some(found.evidence.join(", ")));
    for finding in &found.findings {
        add("-", Some(finding.clone()));
    }
    line + "\n"
}

/// How every verdict is known, with all computed values, in `known.txt`, which people have read.
/// `BURMESTER_WRITE=1` writes it anew.
#[test]
fn what_is_known_of_every_statement_stays() {
    const FILE: &str = "tests/suite/known.txt";
    let lines: Vec<String> = judged()
        .iter()
        .flat_map(|paper| paper.decided().map(known).collect::<Vec<_>>())
        .collect();
    if std::env::var("BURMESTER_WRITE").is_ok() {
        std::fs::write(FILE, lines.concat()).unwrap();
    }
    let before = std::fs::read_to_string(FILE).unwrap();
    for (found, expected) in lines.iter().zip(before.lines()) {
        assert_eq!(found.trim_end(), expected);
    }
    assert_eq!(lines.len(), before.lines().count());
}

#[test]
fn the_list_of_errata_is_up_to_date() {
    let computed = errata::markdown(judged());
    assert!(
        computed == include_str!("../../ERRATA.md"),
        "ERRATA.md differs from what is computed; `burmester report -o site` writes site/ERRATA.md, copy it"
    );
}

/// What stands in an attribute, wherever it occurs in a page.
fn attributes<'a>(page: &'a str, name: &str) -> Vec<&'a str> {
    let start = format!(" {name}=\"");
    page.split(start.as_str())
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect()
}

#[test]
fn the_site_shows_every_statement_and_its_links_lead_somewhere() {
    let files = site(judged(), || ()).unwrap();
    let mut ids: HashMap<&str, HashSet<&str>> = HashMap::new();
    for file in files.iter().filter(|file| file.path.ends_with(".html")) {
        let of_page = attributes(&file.text, "id");
        let once: HashSet<&str> = of_page.iter().copied().collect();
        assert_eq!(
            of_page.len(),
            once.len(),
            "an id of {} stands twice",
            file.path
        );
        ids.insert(&file.path, once);
    }
    let paths: HashSet<&str> = files.iter().map(|file| file.path.as_str()).collect();
    let mut count = 0;
    for file in files.iter().filter(|file| file.path.ends_with(".html")) {
        for link in attributes(&file.text, "href") {
            if link.contains(':') {
                continue;
            }
            let (target, place) = link.split_once('#').unwrap_or((link, ""));
            let target = target.split('?').next().unwrap_or(target);
            let target = match target {
                "" => file.path.clone(),
                _ if file.path.contains('/') && target.starts_with("../") => {
                    target.replace("../", "")
                }
                _ => target.to_owned(),
            };
            assert!(
                paths.contains(target.as_str()),
                "{} leads to {link}",
                file.path
            );
            let known = place.is_empty()
                || ids
                    .get(target.as_str())
                    .is_some_and(|ids| ids.contains(place));
            assert!(
                known,
                "{} leads to {link}, and there is no such place",
                file.path
            );
            count += 1;
        }
    }
    // Each statement has one to itself and one to its scene, or its source to it.
    let statements: usize = judged().iter().map(|paper| paper.judgements.len()).sum();
    assert!(count > 2 * statements, "{count} links");
    for paper in judged() {
        let page = &ids[format!("{}.html", paper.paper.key).as_str()];
        for one in paper.decided() {
            let (_, rest) = one.statement.id.split_once('/').unwrap();
            let plain = rest
                .chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "/-_.".contains(c));
            let place = rest.replace('/', "~");
            assert!(
                !plain || page.contains(place.as_str()),
                "{} is not shown",
                one.statement.id
            );
        }
    }
}
