//! Whether an answer to five positions lists all pairs and nothing else, and what linkages they make.

use serde_json::Value;

use super::alternates::{self, Known, Listed};
use super::geometry::Sheet;
use super::pairs::{Pair, Pairs};
use super::rest::Rest;
use super::{Defect, all_pairs, dyads};
use crate::oracle::positions::Given;

/// Checks everything but estimates and what is said of wishes.
pub fn check(given: &Given, known: &[Known], answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    let pairs = Pairs::of(given, &sheet)?;
    let mut rest = Rest::default();
    rest.after(dyads::linkages(given, &pairs, &sheet))?;
    let finite: Vec<Listed<'_>> = pairs.finite.iter().map(Pair::listed).collect();
    let left = &answer["alternates"];
    rest.after(alternates::check(
        known,
        &finite,
        pairs.at_infinity,
        left,
        sheet.digits,
    ))?;
    rest.after(all_pairs::check(given, &pairs, &sheet))?;
    rest.finish()
}
