//! `five-positions`: all Burmester pairs, with proof, and the linkages that they make.

pub mod curvature;
mod found;
mod known;
pub mod mixed;
mod writer;

use rug::Rational;
use serde_json::{Map, Value};

use super::input::Fields;
use super::output::into_floats;
use super::positions::Given;
use super::sharpen::{Attempt, sharpen};
use super::wishes::Wishes;
use super::{Arithmetic, ProblemError, Request};
use crate::finite::five_positions::conditions::rows;
use crate::finite::five_positions::{conics, floats};
use crate::finite::positions::Positions;
use crate::number::{Ball, Exact, Number};
use crate::plane::displacement::Displacement;
use found::Found;
use known::Known;
use writer::Writer;

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions", "known", "wishes"])?;
    let given = Given::read(fields, 5, 5)?;
    let wishes = Wishes::read(fields)?;
    let rational = given.rational().and_then(|positions| five(&positions));
    let known = known::read(fields, rational.as_ref())?;
    let mut answer = match request.arithmetic {
        Arithmetic::Float => of_floats(&given, wishes.as_ref(), request),
        Arithmetic::Certified => {
            // Translations have families only, of which no circlepoint is told.
            let exact = rational.or_else(|| five(&given.translations()?));
            let exact = exact.map(|five| {
                let pairs = conics::pairs(&five);
                (five, pairs)
            });
            certified(
                &given,
                exact.as_ref(),
                &known,
                wishes.as_ref(),
                request.digits,
            )
        }
    };
    if let Some(angles) = given.fitted(request) {
        answer.insert("fitted_angles".into(), angles);
    }
    Ok(answer)
}

type Five<K> = [Displacement<K>; 5];

fn certified(
    given: &Given,
    exact: Option<&(Five<Exact>, Option<conics::Pairs>)>,
    known: &Known,
    wishes: Option<&Wishes>,
    digits: u32,
) -> Map<String, Value> {
    sharpen(digits, |attempt| {
        let bits = attempt.bits;
        let positions = five(&given.rounded::<Ball>(&bits));
        let found = match (exact, &positions) {
            (Some((five, pairs)), _) => {
                let found = Found::exact(&rows(five), pairs.as_ref(), known, bits);
                match pairs {
                    // What enclosures leave open, exact numbers may decide.
                    Some(pairs) if attempt.is_repeated() => {
                        found.map(|found| found.with_surds(pairs))
                    }
                    _ => found,
                }
            }
            (None, Some(positions)) => Found::enclosed(&rows(positions), bits),
            (None, None) => None,
        };
        match (found, positions) {
            (Some(found), Some(positions)) if !found.is_undecided() => {
                let writer = Writer {
                    attempt,
                    positions: positions.to_vec(),
                    conditions: positions,
                    exact: exact.map(|(five, _)| five.to_vec()),
                    wishes,
                };
                writer.answer(&found)
            }
            _ => undecided(attempt),
        }
    })
}

/// Without any certificate; where floats find no four pairs, as in families, they are taken for the
/// rational numbers that they are.
fn of_floats(given: &Given, wishes: Option<&Wishes>, request: &Request) -> Map<String, Value> {
    let mut attempt = Attempt::new(request.digits.min(15), 192);
    let rounded = given.rounded::<f64>(&());
    let exact =
        |x: &Number<f64>| Number::<Exact>::from(Rational::from_f64(x.0).unwrap_or_default());
    let displacements = rounded.displacements().iter().map(|d| d.map(exact));
    let displacements: Vec<Displacement<Exact>> = displacements.collect();
    let Ok(five) = <Five<Exact>>::try_from(displacements) else {
        return undecided(&mut attempt);
    };
    let quick = rounded
        .displacements()
        .first_chunk()
        .and_then(floats::pairs);
    let positions = five.each_ref().map(Displacement::in_kind);
    let found = quick.map(|pairs| Found::floats(&pairs)).or_else(|| {
        let pairs = conics::pairs(&five);
        Found::exact(&rows(&five), pairs.as_ref(), &Known::new(), attempt.bits)
    });
    let Some(found) = found else {
        return undecided(&mut attempt);
    };
    let mut answer = Writer {
        attempt: &mut attempt,
        positions: positions.to_vec(),
        conditions: positions,
        exact: Some(five.to_vec()),
        wishes,
    }
    .answer(&found);
    answer.remove("certificate");
    answer.values_mut().for_each(into_floats);
    answer
}

fn undecided(attempt: &mut Attempt) -> Map<String, Value> {
    let names = [
        "pairs",
        "complex_pairs",
        "at_infinity",
        "family",
        "eliminant",
        "counts",
        "linkages",
    ];
    let mut answer = Map::new();
    for name in names {
        let optional = name == "family" || name == "eliminant";
        let value = if optional {
            Value::Null
        } else {
            attempt.decided(name, None)
        };
        answer.insert(name.into(), value);
    }
    answer.insert("certificate".into(), Value::Null);
    answer
}

fn five<K: crate::number::Kind>(positions: &Positions<K>) -> Option<Five<K>> {
    positions.displacements().first_chunk().cloned()
}
