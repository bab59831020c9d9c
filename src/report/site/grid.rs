//! A printed table whose cells are no numbers, as it stands in print.

use std::collections::BTreeSet;

use maud::{Markup, html};

use super::{address, article, layout};
use crate::ledger::{Content, Decided, PrintedTable};

/// The cells of one table; each leads to what was found of it.
pub fn grid(heading: &str, table: &PrintedTable, cells: &[Decided<'_>]) -> Markup {
    html! {
        div.scroll tabindex="0" role="group" aria-label=(heading) {
            table.grid aria-label=(heading) {
                thead {
                    tr {
                        th scope="col" { "Row" }
                        @for column in &table.columns { th scope="col" { (column) } }
                    }
                }
                tbody {
                    @for row in &table.rows {
                        tr {
                            th scope="row" { (row.name) }
                            @for column in &table.columns {
                                @match found(cells, &row.name, column) {
                                    Some(decided) => (cell(decided)),
                                    None => td {},
                                }
                            }
                        }
                    }
                }
            }
        }
        @if let Some(first) = cells.first() { (known_of(table, cells, *first)) }
    }
}

/// How all cells are known, and what is said of them.
fn known_of(table: &PrintedTable, cells: &[Decided<'_>], first: Decided<'_>) -> Markup {
    let notes = cells
        .iter()
        .filter_map(|cell| cell.statement.note.as_deref());
    let notes: BTreeSet<&str> = notes.collect();
    html! {
        dl {
            dt { "How it is known" }
            dd { p { "Each cell is computed. " (table.code.summary) } (article::proof(first)) }
            @if !notes.is_empty() {
                dt { "Notes" }
                dd { @for note in notes { p { (note) } } }
            }
        }
        (article::sources(first.statement))
    }
}

fn found<'a>(cells: &[Decided<'a>], row: &str, column: &str) -> Option<Decided<'a>> {
    let is_there = |decided: &&Decided<'a>| match &decided.statement.content {
        Content::Cell {
            row: r, column: c, ..
        } => r == row && c == column,
        _ => false,
    };
    cells.iter().find(is_there).copied()
}

fn cell(
    Decided {
        statement,
        judgement,
    }: Decided<'_>,
) -> Markup {
    let fragment = address::fragment(&statement.id);
    html! {
        td class={ "statement " (layout::class(judgement.verdict)) } #(fragment) data-verdict=(judgement.verdict)
            title=(statement.id) {
            a href={ "#" (fragment) } { (statement.printed) }
            @if let (true, Some(right)) = (judgement.verdict.is_erratum(), &judgement.corrected) {
                span.right-is { "right: " (right) }
            }
            @if judgement.verdict.is_erratum() { (layout::verdict(judgement.verdict)) }
        }
    }
}
