//! Formulas as real mathematics, set from the very formula that is checked.

use maud::{Markup, PreEscaped, html};

use crate::formula::tree::Span;
use crate::formula::{Formula, definition_mathml, difference, tree_mathml};

/// A formula, line by line, with these parts marked.
fn lines(formula: &Formula, marked: &[Span]) -> Markup {
    html! {
        @for claim in &formula.claims {
            div.formula { (PreEscaped(tree_mathml(claim, marked))) }
        }
        @for (name, value) in &formula.definitions {
            div.formula { span.word { "where" } (PreEscaped(definition_mathml(name, value, marked))) }
        }
        @for assumption in &formula.assumptions {
            div.formula { span.word { "assuming" } (PreEscaped(tree_mathml(assumption, marked))) }
        }
    }
}

/// A formula.
pub fn set(formula: &Formula) -> Markup {
    lines(formula, &[])
}

/// A formula within a line of text.
pub fn in_line(formula: &Formula) -> Markup {
    let math: Vec<String> = formula
        .claims
        .iter()
        .map(|claim| tree_mathml(claim, &[]))
        .collect();
    PreEscaped(
        math.join(", ")
            .replace("display=\"block\"", "display=\"inline\""),
    )
}

/// Marks say something where not all is marked.
fn partly<'a>(formula: &Formula, marked: &'a [Span]) -> &'a [Span] {
    let all = formula
        .claims
        .iter()
        .all(|claim| marked.contains(&claim.span));
    if all { &[] } else { marked }
}

/// Two formulas with what differs marked in each.
pub fn side_by_side(printed: &Formula, right: &Formula) -> [Markup; 2] {
    let found = difference(printed, right);
    [
        lines(printed, partly(printed, &found.left)),
        lines(right, partly(right, &found.right)),
    ]
}
