//! What the reader says of a text that is no formula.

use super::tree::Span;

/// A text that is no formula: what was found, what was expected, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ReadError {
    /// What was found and what was expected, or how to write what was probably meant.
    pub message: String,
    /// The place in the text, in bytes.
    pub span: Span,
}

impl ReadError {
    /// An error at a place.
    pub(super) fn new(message: impl Into<String>, span: Span) -> ReadError {
        ReadError {
            message: message.into(),
            span,
        }
    }

    /// The message below the line of the text that it is about, the place marked by carets.
    pub fn render(&self, text: &str) -> String {
        let start = boundary_before(text, self.span.start);
        let end = boundary_before(text, self.span.end).max(start);
        let (before, after) = text.split_at(start);
        let number = before.matches('\n').count() + 1;
        let before = before.rsplit('\n').next().unwrap_or_default();
        let after = after.split('\n').next().unwrap_or_default();
        let column = width(before);
        let carets = width(after.get(..end - start).unwrap_or(after)).max(1);
        let margin = format!("{number} | ");
        format!(
            "{margin}{before}{after}\n{}{}\n{}",
            " ".repeat(margin.len() + column),
            "^".repeat(carets),
            self.message
        )
    }
}

/// The last place at or before `at` where a character begins: a span from elsewhere must not panic.
fn boundary_before(text: &str, at: usize) -> usize {
    let mut place = at.min(text.len());
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    place
}

/// Columns that a text takes: combining marks take none.
fn width(text: &str) -> usize {
    text.chars()
        .filter(|character| !('\u{300}'..='\u{36f}').contains(character))
        .count()
}
