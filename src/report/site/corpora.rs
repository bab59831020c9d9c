//! The pages of the corpora: what problems there are, and what it means to fail them.

use std::collections::{BTreeMap, BTreeSet};

use maud::{Markup, html};
use serde_json::Value;

use super::{File, inline, layout};
use crate::oracle::vectors::{CORPORA, Corpus};
use crate::oracle::{Request, solve};
use crate::report::picture;

/// How many problems are tried until one has a picture.
const TRIED: usize = 5;

/// The list of all corpora.
pub fn overview() -> File {
    let content = html! {
        h1 { "Problems with certified answers" }
        p {
            "Programs are tested with these: " code { "burmester score" } " asks all of them, "
            code { "burmester vectors show ID" } " explains one."
        }
        div.scroll tabindex="0" role="group" aria-label="Corpora" {
            table {
                caption { "Corpora" }
                thead { tr { th scope="col" { "Name" } th scope="col" { "Problems" } th scope="col" { "What they are" } } }
                tbody {
                    @for corpus in &CORPORA {
                        tr {
                            th scope="row" { a href=(path(corpus)) { (corpus.name) } }
                            td { (corpus.lines().len()) }
                            td { (corpus.description) }
                        }
                    }
                }
            }
        }
    };
    layout::page("corpora.html", "Problems with certified answers", &content)
}

fn path(corpus: &Corpus) -> String {
    format!("corpus/{}.html", corpus.name)
}

/// The page of one.
pub fn page(corpus: &Corpus) -> File {
    let lines = corpus.lines();
    let problems: Vec<Value> = lines
        .iter()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect();
    let content = html! {
        h1 { (corpus.name) }
        p.lead { (problems.len()) " problems: " (corpus.description) "." }
        p {
            @match corpus.seed() {
                Some(seed) => { "Drawn from the seed " (seed) ", the same on every machine. " }
                None => "Built one by one. ",
            }
            "Ask your program all of them: "
            code { "burmester score --problems " (corpus.name) " -- COMMAND" }
        }
        (example(&problems))
        h2 { "Kinds" }
        (kinds(&problems))
        (flags(&problems))
        h2 { "All problems" }
        (list(&problems))
    };
    layout::page(&path(corpus), corpus.name, &content)
}

fn word<'a>(problem: &'a Value, field: &str) -> &'a str {
    problem
        .get(field)
        .and_then(Value::as_str)
        .unwrap_or_default()
}

fn flags_of(problem: &Value) -> Vec<&str> {
    let list = problem.get("flags").and_then(Value::as_array);
    list.into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect()
}

/// The first problem that has a picture, solved.
fn example(problems: &[Value]) -> Markup {
    let drawn = problems.iter().take(TRIED).find_map(|problem| {
        let answer = solve(problem, &Request::default()).ok()?;
        Some((word(problem, "id"), picture(problem, &answer)?))
    });
    html! {
        @if let Some((id, svg)) = drawn {
            (inline::figure(&svg, "example", id, "The problem with its certified answer.", false))
        }
    }
}

fn kinds(problems: &[Value]) -> Markup {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for problem in problems {
        *counts.entry(word(problem, "kind")).or_default() += 1;
    }
    html! {
        ul.kinds { @for (kind, count) in counts { li { (kind) " · " (count) } } }
    }
}

/// What it means to fail a problem with a flag that occurs here.
fn flags(problems: &[Value]) -> Markup {
    let used: BTreeSet<&str> = problems.iter().flat_map(flags_of).collect();
    let meanings: Value =
        serde_json::from_str(include_str!("../../../data/problems/flags.json")).unwrap_or_default();
    html! {
        @if !used.is_empty() {
            h2 { "Flags" }
            dl.words {
                @for flag in used {
                    dt { code { (flag) } }
                    dd { (word(&meanings, flag)) }
                }
            }
        }
    }
}

fn list(problems: &[Value]) -> Markup {
    html! {
        div.scroll tabindex="0" role="group" aria-label="All problems" {
            table {
                caption { "All problems" }
                thead { tr { th scope="col" { "Id" } th scope="col" { "Kind" } th scope="col" { "Flags and reasoning" } } }
                tbody {
                    @for problem in problems {
                        tr {
                            th scope="row" { code { (word(problem, "id")) } }
                            td { (word(problem, "kind")) }
                            td { (flags_of(problem).join(", ")) " " (word(problem, "note")) }
                        }
                    }
                }
            }
        }
    }
}
