//! Whether fitted angles are those between the lines through the two points of the body.

use rug::Rational;
use serde_json::Value;

use super::geometry::Sheet;
use super::shown::{Shown, decided};
use super::{Defect, require};
use crate::number::{Ball, Number};
use crate::oracle::positions::{Given, point};
use crate::plane::Point;

/// Checks the field `fitted_angles`, which must be missing where nothing is fitted.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let place = "fitted_angles";
    let shown = &answer[place];
    let Given::Points(pairs, true) = given else {
        return require(shown.is_null(), place, "no angle is fitted");
    };
    let listed = shown.as_array().filter(|list| list.len() == pairs.len());
    let listed = listed.ok_or_else(|| Defect::wrong(place, "one for every position"))?;
    let sheet = Sheet::of(answer)?;
    let along = |[p, q]: &[[Rational; 2]; 2]| point::<Ball>(q) - point::<Ball>(p);
    let Some(first) = pairs.first().map(along) else {
        return Ok(());
    };
    for (pair, angle) in pairs.iter().zip(listed) {
        let degrees = decided(answer, &angle["degrees"], "angle")?;
        is_turn(degrees, &(along(pair) * first.conj()), place, &sheet)?;
    }
    Ok(())
}

/// Whether this is the angle of a direction, in degrees, above −180 and at most 180.
pub fn is_turn(
    degrees: &Value,
    direction: &Point<Ball>,
    place: &str,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let degrees = Shown::read(degrees, place)?;
    let sharp = degrees.is_sharp(&Rational::new(), sheet.digits);
    require(sharp, place, "the radius is larger than the digits allow")?;
    let in_range = degrees.value > -180 && degrees.value <= 180;
    require(in_range, place, "above -180 and at most 180 was expected")?;
    let degrees = Number(degrees.ball(sheet.bits).0.with_precision(sheet.bits));
    let radians = degrees * Number::pi(&sheet.bits) / 180;
    let back: Point<Ball> = Number::complex(radians.clone().cos(), -radians.sin());
    let left = direction * back;
    let right = !left.im().is_zero().is_no() && left.re().is_positive().is_yes();
    require(right, place, "it is another angle")
}
