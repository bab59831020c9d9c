//! Printed numbers in a table: printed and computed side by side.

use maud::{Markup, html};

use super::{address, article, digits, known, layout, mathematics};
use crate::formula::Formula;
use crate::ledger::{Computed, Content, Decided, Statement};

/// A row of numbers: each with the place where it stands, below the place of all of them.
pub fn table(heading: &str, rows: &[(String, Decided<'_>)]) -> Markup {
    html! {
        div.scroll tabindex="0" role="group" aria-label={ "Numbers of " (heading) } {
            table.numbers aria-label=(heading) {
                thead {
                    tr {
                        th scope="col" { "Number" }
                        th scope="col" { "Printed" }
                        th scope="col" { "Computed" }
                        th scope="col" { "Verdict" }
                        th scope="col" { "How it is known" }
                    }
                }
                tbody { @for (place, decided) in rows { (row(place, *decided)) } }
            }
        }
    }
}

fn row(place: &str, decided: Decided<'_>) -> Markup {
    let Decided {
        statement,
        judgement,
    } = decided;
    let fragment = address::fragment(&statement.id);
    let [printed, computed] = both(statement, judgement.computed.as_ref());
    html! {
        tr.statement #(fragment) data-verdict=(judgement.verdict) {
            th scope="row" {
                a href={ "#" (fragment) } { (place) }
                @if let Some(quantity) = quantity_beside(statement, place) {
                    " " (mathematics::in_line(quantity))
                }
            }
            td.digits { (printed) }
            td.digits { (computed) }
            td { (layout::verdict(judgement.verdict)) }
            td {
                details {
                    summary { (judgement.basis()) }
                    p { (known::sentences(decided)) }
                    dl {
                        @if let Some(computed) = &judgement.computed {
                            dt { "Computed" } dd { p { code { (computed) } } }
                        }
                        @if let Some(certified) = &judgement.certified {
                            dt { "True value" } dd { p { code { (certified) } } }
                        }
                        (article::remarks(decided))
                    }
                    (article::proof(decided))
                    (article::sources(statement))
                }
            }
        }
    }
}

/// The quantity that is printed, where the place does not name it already.
fn quantity_beside<'a>(statement: &'a Statement, place: &str) -> Option<&'a Formula> {
    match &statement.content {
        Content::Value { quantity, .. } if quantity.text != place => Some(&quantity.formula),
        _ => None,
    }
}

/// What is printed and what was computed, in one notation, with marks where they differ.
pub fn both(statement: &Statement, computed: Option<&Computed>) -> [Markup; 2] {
    let printed = statement.printed.as_str();
    let right = computed.and_then(|computed| digits::as_printed(printed, computed));
    match (right, computed) {
        (Some(right), _) => [
            digits::marked(printed, &right),
            digits::marked(&right, printed),
        ],
        (None, Some(computed)) => [html! { (printed) }, html! { (short(computed)) }],
        (None, None) => [html! { (printed) }, html! { "–" }],
    }
}

/// The first digits of a computed number.
fn short(computed: &Computed) -> String {
    const DIGITS: usize = 10;
    let text = match computed {
        Computed::Enclosure { value, .. } => value.clone(),
        other => other.to_string(),
    };
    match text.char_indices().nth(DIGITS) {
        Some((end, _)) if matches!(computed, Computed::Enclosure { .. }) => {
            format!("{}…", text.get(..end).unwrap_or(&text))
        }
        _ => text,
    }
}
