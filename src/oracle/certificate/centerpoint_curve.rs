//! Whether an answer to four positions is right: the poles, both curves by the loop closure, what is
//! said of a curve by its own equation, and the quadrilaterals.

use serde_json::Value;

use super::Defect;
use super::curve::Curve;
use super::geometry::Sheet;
use super::known::Known;
use super::poles::poles;
use super::quadrilateral;
use super::rest::Rest;
use crate::finite::four_positions::loop_closure::centerpoint_cubic;
use crate::finite::positions::Positions;
use crate::number::Ball;
use crate::oracle::positions::Given;

/// Checks everything.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    match given.exact() {
        Some(positions) => check_in(given, &positions, &sheet),
        None => check_in(given, &given.rounded::<Ball>(&sheet.bits), &sheet),
    }
}

fn check_in<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let mut rest = Rest::default();
    rest.after(poles(given, positions, sheet))?;
    let curves = [
        ("centerpoint", positions.clone()),
        ("circlepoint", positions.inverse()),
    ];
    for (name, positions) in curves {
        rest.after(curve(name, &positions, sheet))?;
    }
    rest.after(quadrilateral::check(given, positions, sheet))?;
    rest.finish()
}

fn curve<K: Known>(name: &str, positions: &Positions<K>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let own = positions.first_four().and_then(centerpoint_cubic);
    let own = own.ok_or_else(|| Defect::unchecked("no second route to the curve"))?;
    let at = |part: &str| format!("{name}.{part}");
    let shown = &sheet.answer[name];
    let mut rest = Rest::default();
    let coefficients = sheet.up_to_factor(
        &shown["coefficients"],
        &at("coefficients"),
        own.coefficients(),
    );
    rest.after(coefficients)?;
    rest.after(Curve(own.coefficients()).check(name, shown, sheet))?;
    rest.finish()
}
