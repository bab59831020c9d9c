//! Whether the pairs of an answer are all that there are.
//!
//! Two conics have four pairs in common, counted as often as each counts, with those that are not real
//! or at infinity. Four simple finite ones are all; others must be those that two eliminations find.

use rug::Rational;
use serde_json::Value;

use super::conditions::{Conditions, Five, Form};
use super::geometry::Sheet;
use super::pairs::Pairs;
use super::roots::{self, Listed};
use super::shown::{Coordinate, Shown, point};
use super::{Defect, eliminant, family, require};
use crate::number::exact::primitive;
use crate::number::{Ball, Complex, Exact, Number};

type Entry = Number<Complex<Ball>>;
type Forms = [Form<Exact>; 4];

/// Checks number and multiplicity of the pairs, those at infinity, the eliminant and the family.
pub fn check(five: &impl Five, pairs: &Pairs<'_>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let answer = sheet.answer;
    let undecided = answer["undecided"].as_str().unwrap_or_default();
    if undecided.split(", ").any(|name| name == "family") {
        return Err(Defect::unchecked("the answer leaves the family undecided"));
    }
    let forms = Conditions::exact(five).and_then(|conditions| conditions.forms());
    if !answer["family"].is_null() {
        require(
            answer["eliminant"].is_null(),
            "eliminant",
            "families have none",
        )?;
        let forms = forms.ok_or_else(|| Defect::unchecked("a family of enclosed positions"))?;
        family::check(&forms, &answer["family"])?;
        return if pairs.is_empty() {
            Ok(())
        } else {
            Err(Defect::unchecked(
                "that no pair beside the family is missing",
            ))
        };
    }
    match forms {
        Some(forms) => of_rational(&forms, pairs, sheet),
        None => of_enclosed(answer, pairs),
    }
}

/// Four simple finite pairs are all that two conics can have in common.
fn of_enclosed(answer: &Value, pairs: &Pairs<'_>) -> Result<(), Defect> {
    require(
        answer["eliminant"].is_null(),
        "eliminant",
        "there is none for input that is not rational",
    )?;
    let is_multiple = pairs.finite.iter().any(|pair| pair.multiplicity > 1);
    if !pairs.at_infinity.is_empty() || is_multiple {
        return Err(Defect::unchecked(
            "multiple pairs and pairs at infinity of enclosed positions",
        ));
    }
    require(
        pairs.finite.len() == 4,
        "pairs",
        "there are four pairs, counted with those that are not real",
    )
}

fn of_rational(forms: &Forms, pairs: &Pairs<'_>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    if pairs.is_empty() && family::has_no_pair(forms) {
        return Ok(());
    }
    let [_, all] = pairs.totals();
    require(
        all == 4,
        "counts",
        "there are four pairs, counted with those that are not real or at infinity",
    )?;
    if pairs.finite.len() < 4 {
        by_elimination(forms, pairs, sheet)?;
    }
    is_eliminant(forms, pairs, sheet)
}

/// Both points of all pairs, by two eliminations, and the pairs at infinity.
#[expect(
    clippy::indexing_slicing,
    reason = "two coordinates of the circlepoint and two of the center"
)]
fn by_elimination(forms: &Forms, pairs: &Pairs<'_>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let Sheet { digits, bits, .. } = *sheet;
    let exchanged = forms.each_ref().map(Form::exchanged);
    let listed = |offset: usize| {
        pairs.finite.iter().map(move |pair| Listed {
            point: [
                pair.enclosure[offset].clone(),
                pair.enclosure[offset + 1].clone(),
            ],
            multiplicity: pair.multiplicity,
        })
    };
    let mut circlepoints: Vec<Listed> = listed(0).collect();
    let mut centers: Vec<Listed> = listed(2).collect();
    for value in pairs.at_infinity {
        match value["kind"].as_str() {
            Some("center") => {
                let point = point(&value["circlepoint"], "at_infinity", digits)?;
                along_a_line(forms, &point, &value["direction"], bits)?;
                circlepoints.push(Listed::single(&point, bits));
            }
            Some("circlepoint") => {
                let point = point(&value["center"], "at_infinity", digits)?;
                along_a_line(&exchanged, &point, &value["direction"], bits)?;
                centers.push(Listed::single(&point, bits));
            }
            Some("isotropic") => {}
            _ => return Err(Defect::wrong("at_infinity", "an unknown kind")),
        }
    }
    roots::check(forms, &circlepoints, "circlepoints", bits)?;
    roots::check(&exchanged, &centers, "centers", bits)
}

impl Listed {
    fn single(point: &[Coordinate; 2], bits: u32) -> Self {
        Listed {
            point: point.each_ref().map(|part| part.ball(bits)),
            multiplicity: 1,
        }
    }
}

/// Whether the places of a point lie along a line, across the direction: a center far away there fulfils
/// the conditions.
fn along_a_line(
    forms: &Forms,
    point: &[Coordinate; 2],
    direction: &Value,
    bits: u32,
) -> Result<(), Defect> {
    let place = "at_infinity";
    let [x, y] = [&direction[0], &direction[1]].map(|part| Shown::read(part, place));
    let (x, y) = (x?, y?);
    let first = if x.value.is_zero() { &y } else { &x };
    require(
        !first.is_exact() || first.value.cmp0().is_gt(),
        place,
        "the first part of a primitive direction is positive",
    )?;
    let towards = [x.ball(bits), y.ball(bits)];
    let point = point.each_ref().map(|part| part.re.ball(bits));
    let fits = forms.iter().all(|form| {
        let [by_x, by_y, _] = form.by_center().map(|[one, x, y]| {
            enclosed(&one) + enclosed(&x) * &point[0] + enclosed(&y) * &point[1]
        });
        let along = by_x * &towards[0] + by_y * &towards[1];
        along.0.contains(&Rational::new())
    });
    require(
        fits,
        place,
        "the point does not move along a line across the direction",
    )
}

fn enclosed(x: &Number<Exact>) -> Number<Ball> {
    Number::from(x.0.rational().cloned().unwrap_or_default())
}

/// The product of z + x over all finite pairs, as primitive integers.
fn is_eliminant(forms: &Forms, pairs: &Pairs<'_>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let place = "eliminant";
    let shown = &sheet.answer[place];
    let integers = eliminant::integers(shown, place)?;
    let [finite, _] = pairs.totals();
    require(
        integers.len() == finite + 1,
        place,
        "its degree is not the number of finite pairs",
    )?;
    let slides = (pairs.at_infinity.iter()).any(|value| value["kind"] == "center");
    if !slides && let Some(polynomial) = roots::eliminant(forms, [-1, 0]) {
        let coefficients = polynomial.coefficients().iter().rev();
        let own: Option<Vec<Rational>> = coefficients.map(|c| c.0.rational().cloned()).collect();
        let same = own.is_some_and(|own| primitive(&own) == integers);
        return require(same, place, "an independent elimination gives another one");
    }
    let own: Vec<(&Entry, usize)> = (pairs.finite.iter())
        .map(|pair| (&pair.enclosure[0], pair.multiplicity))
        .collect();
    eliminant::is_of_roots(shown, place, &own)
}
