//! Printed and computed digits side by side, with marks where they differ.

use maud::{Markup, html};

use crate::ledger::{Computed, Printed};
use crate::number::text::parse_rational;

/// A computed number as it would stand in print; `None` where the print is no decimal.
pub fn as_printed(printed: &str, computed: &Computed) -> Option<String> {
    let value = match computed {
        Computed::Exact { exact } => exact,
        Computed::Enclosure { value, .. } => value,
        Computed::Unknown | Computed::Text(_) => return None,
    };
    let value = parse_rational(value).ok()?;
    match Printed::read(printed) {
        Ok(decimal) => Some(decimal.like(&value)),
        Err(_) if value.is_integer() => Some(value.to_string()),
        Err(_) => None,
    }
}

/// A text with the signs marked that do not stand in the same place of another, both held by their
/// points.
pub fn marked(text: &str, other: &str) -> Markup {
    html! {
        @for (part, differs) in pieces(text, other) {
            @if differs { mark { (part) } } @else { (part) }
        }
    }
}

/// Runs of signs that do or do not stand in the other text.
fn pieces(text: &str, other: &str) -> Vec<(String, bool)> {
    let [text, other] = [text, other].map(aligned);
    let mut pieces: Vec<(String, bool)> = Vec::new();
    for (place, sign) in &text {
        let differs = !other.contains(&(*place, *sign));
        match pieces.last_mut() {
            Some((part, same)) if *same == differs => part.push(*sign),
            _ => pieces.push((sign.to_string(), differs)),
        }
    }
    pieces
}

/// The signs by their distance from the point, or from the end where there is none.
fn aligned(text: &str) -> Vec<(isize, char)> {
    let signs: Vec<char> = text.chars().filter(|sign| *sign != ' ').collect();
    let point = signs
        .iter()
        .position(|sign| *sign == '.')
        .unwrap_or(signs.len());
    let from_point = |place: usize| place.cast_signed() - point.cast_signed();
    let signs = signs.into_iter().enumerate();
    signs
        .map(|(place, sign)| (from_point(place), sign))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_that_differ_are_marked() {
        let marked = |text: &str, other: &str| marked(text, other).into_string();
        assert_eq!(marked("1.020", "1.010"), "1.0<mark>2</mark>0");
        assert_eq!(marked("+32.000", "-32.000"), "<mark>+</mark>32.000");
        assert_eq!(marked("62", "162"), "62");
        assert_eq!(marked("162", "62"), "<mark>1</mark>62");
        assert_eq!(
            marked(".39753037, 00", ".39753038, 00"),
            ".3975303<mark>7</mark>,00"
        );
    }

    #[test]
    fn numbers_are_shown_as_they_would_be_printed() {
        let computed = Computed::Enclosure {
            value: "0.333333333333".to_owned(),
            radius: "1e-12".to_owned(),
        };
        assert_eq!(
            as_printed(".39753037, 00", &computed).unwrap(),
            ".33333333, 00"
        );
        assert_eq!(as_printed("1.02", &computed).unwrap(), "0.33");
        assert_eq!(as_printed("4", &computed), None);
    }
}
