//! The front page: counts, what verdicts and proofs mean, and all errata as one list.

use maud::{Markup, html};

use super::{File, address, article, known, layout, numbers, source};
use crate::ledger::{Decided, Judged, Kind, Proof, Verdict};

/// The page.
pub fn page(sources: &[Judged<'_>]) -> File {
    let content = html! {
        h1 { "What five classic sources say about planar linkages, line by line" }
        p.lead {
            "Open a source, find the line, read whether it is right and how that is known. Each formula below was \
             evaluated on a mechanism that is built from first principles, in exact arithmetic or rigorous \
             enclosures; no verdict rests on what is printed."
        }
        section aria-labelledby="sources" {
            h2 #sources { "Sources" }
            (table(sources))
        }
        section aria-labelledby="verdicts" {
            h2 #verdicts { "What the verdicts mean" }
            dl.words {
                @for verdict in Verdict::ALL {
                    dt { (layout::verdict(verdict)) }
                    dd { (verdict.meaning()) }
                }
            }
        }
        section aria-labelledby="proofs" {
            h2 #proofs { "What they rest on" }
            dl.words {
                @for proof in Proof::ALL {
                    dt { strong { (proof) } " " (with_proof(sources, proof)) }
                    dd { (proof.basis()) }
                }
            }
        }
        section aria-labelledby="errata" {
            h2 #errata { "Errata" }
            p {
                "Every wrong line of every source. Cite an erratum by its id, which never changes, as in “burmester, erratum "
                code { "tesar1964/eq/3.25/z1" }
                "”. The same list as text: "
                a href="ERRATA.md" { "ERRATA.md" }
                "."
            }
            @for source in sources { (errata(source)) }
        }
    };
    layout::page("index.html", "Verdicts", &content)
}

fn with_proof(sources: &[Judged<'_>], proof: Proof) -> usize {
    let judgements = sources.iter().flat_map(|source| &source.judgements);
    judgements
        .filter(|judgement| judgement.proof == proof)
        .count()
}

fn table(sources: &[Judged<'_>]) -> Markup {
    let counts: Vec<_> = sources.iter().map(source::counts).collect();
    let verdicts: Vec<Verdict> = Verdict::ALL
        .into_iter()
        .filter(|verdict| counts.iter().any(|counts| counts.contains_key(verdict)))
        .collect();
    html! {
        div.scroll tabindex="0" role="group" aria-label="Counts of verdicts" {
            table.counts {
                caption { "Statements of each source by verdict" }
                thead {
                    tr {
                        th scope="col" { "Source" }
                        th scope="col" { "Statements" }
                        @for verdict in &verdicts { th scope="col" { (layout::verdict(*verdict)) } }
                    }
                }
                tbody {
                    @for (source, counts) in sources.iter().zip(&counts) {
                        tr {
                            th scope="row" {
                                a href=(address::of_source(&source.paper.key)) {
                                    (source::short_title(&source.paper.title))
                                }
                            }
                            td { (source.paper.total) }
                            @for verdict in &verdicts { td { (count(source, *verdict, counts.get(verdict))) } }
                        }
                    }
                }
            }
        }
    }
}

fn count(source: &Judged<'_>, verdict: Verdict, count: Option<&usize>) -> Markup {
    let page = address::of_source(&source.paper.key);
    html! {
        @match count {
            Some(count) => a href={ (page) "?show=" (verdict) } aria-label={ (count) " " (verdict) } { (count) },
            None => "·",
        }
    }
}

fn errata(source: &Judged<'_>) -> Markup {
    let errata: Vec<Decided<'_>> = source
        .decided()
        .filter(|decided| decided.judgement.verdict.is_erratum())
        .collect();
    html! {
        h3 #{ "errata-" (source.paper.key) } { (source.paper.title) ": " (errata.len()) }
        ol.errata { @for decided in errata { (erratum(decided)) } }
    }
}

fn erratum(decided: Decided<'_>) -> Markup {
    let Decided {
        statement,
        judgement,
    } = decided;
    let name = format!("erratum-{}", address::encoded(&statement.id));
    html! {
        li.statement #(name) data-verdict=(judgement.verdict) {
            p {
                a href=(address::of_statement(&statement.id)) { code { (statement.id) } }
                " " (statement.locus)
                @if let Some(cause) = statement.cause { ", wrong: " (cause.in_words()) }
            }
            dl {
                @if statement.kind == Kind::Number { (number(decided)) } @else { (article::both_forms(decided)) }
                dt { "Known" } dd { p { (known::sentences(decided)) } }
            }
        }
    }
}

fn number(
    Decided {
        statement,
        judgement,
    }: Decided<'_>,
) -> Markup {
    let [printed, computed] = numbers::both(statement, judgement.computed.as_ref());
    html! {
        dt { "Printed" } dd.digits { (printed) }
        dt { "Right" } dd.digits { (computed) }
    }
}
