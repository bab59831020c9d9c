//! A statement that is no number: what is printed, what is right, and how that is known.

use maud::{Markup, html};

use super::{address, code, known, layout, mathematics};
use crate::ledger::{Content, Decided, Statement};
use crate::scenes::find_check;

/// A statement under a heading that says where it stands.
pub fn article(decided: Decided<'_>, place: &str) -> Markup {
    let Decided {
        statement,
        judgement,
    } = decided;
    let fragment = address::fragment(&statement.id);
    html! {
        article.statement #(fragment) data-verdict=(judgement.verdict) {
            h3 {
                a href={ "#" (fragment) } { (place) }
                " " (layout::verdict(judgement.verdict))
            }
            dl {
                (both_forms(decided))
                dt { "How it is known" }
                dd { p { (known::sentences(decided)) } (proof(decided)) }
                (remarks(decided))
            }
            (sources(statement))
        }
    }
}

/// What is printed and, where that is wrong, what is right.
pub fn both_forms(decided: Decided<'_>) -> Markup {
    let Decided {
        statement,
        judgement,
    } = decided;
    let right = statement.correct.as_ref();
    let right = right.filter(|_| judgement.verdict.is_erratum());
    match (&statement.content, right) {
        (Content::Formula(printed), Some(right)) => {
            let [printed, right] = mathematics::side_by_side(&printed.formula, &right.formula);
            html! {
                dt { "Printed" } dd { (printed) }
                dt { "Right" } dd { (right) }
            }
        }
        (Content::Formula(printed), None) => html! {
            dt { "Printed" } dd { (mathematics::set(&printed.formula)) }
            (corrected(judgement.corrected.as_deref()))
            @if let Some(condition) = &statement.condition {
                dt { "Only if" } dd { (mathematics::set(&condition.text.formula)) }
            }
        },
        (Content::Check, right) => html! {
            dt { "Says" } dd { p { (statement.printed) } }
            @if let Some(right) = right {
                dt { "Right" } dd { (mathematics::set(&right.formula)) }
            } @else { (corrected(judgement.corrected.as_deref())) }
        },
        (_, right) => html! {
            dt { "Printed" } dd { p { code { (statement.printed) } } }
            @if let Some(right) = right {
                dt { "Right" } dd { (mathematics::set(&right.formula)) }
            } @else { (corrected(judgement.corrected.as_deref())) }
            @if let Some(computed) = &judgement.computed {
                dt { "Computed" } dd { p { code { (computed) } } }
            }
        },
    }
}

fn corrected(text: Option<&str>) -> Markup {
    html! {
        @if let Some(text) = text {
            dt { "Right" } dd { p { code { (text) } } }
        }
    }
}

/// The kind of proof, and what the line's checks do.
pub fn proof(
    Decided {
        statement,
        judgement,
    }: Decided<'_>,
) -> Markup {
    html! {
        p.proof {
            "Proof: " strong { (judgement.proof) } " (" (judgement.basis()) ")"
            @if let Some(cause) = statement.cause.filter(|_| judgement.verdict.is_erratum()) {
                ". Wrong: " (cause.in_words())
                @if let Some(id) = &statement.inherited_from {
                    ", from " a href=(address::of_statement(id)) { code { (id) } }
                }
            }
            "."
        }
        @for check in statement.checks.iter().filter_map(|name| find_check(name)) {
            p { a href=(code::of_check(check.name)) { (check.name) } ": " (check.summary) }
        }
    }
}

/// What a reader should know beside.
pub fn remarks(
    Decided {
        statement,
        judgement,
    }: Decided<'_>,
) -> Markup {
    html! {
        @if let Some(convention) = &statement.convention {
            dt { "Convention" } dd { p { (convention) } }
        }
        @if !judgement.findings.is_empty() {
            dt { "Found" }
            dd { @for finding in &judgement.findings { p { (finding) } } }
        }
        @if let Some(note) = &statement.note {
            dt { "Note" } dd { p { (note) } }
        }
    }
}

/// Where the statement's scene is, and its id.
pub fn sources(statement: &Statement) -> Markup {
    html! {
        p.sources {
            code.id { (statement.id) }
            " · " (statement.kind) " · scene "
            a href=(code::of_scene(statement.scene)) { (statement.scene.name) }
        }
    }
}
