//! What belongs to one position of a motion: pole, inflection circle, Ball's point, invariants.
//!
//! With v, a, j for the terms in t, t², t³ of a path, v = 0 in the pole, and a path has an inflection for
//! v × a = 0. Ball's point moves straight to the third order; it is the foot of the perpendicular from
//! the inflection pole to the line v × j = 0 through the pole. The polodes have in the pole the
//! curvatures a₃ + 1 (fixed) and a₃ + 2 (moving), divided by the diameter of the inflection circle.

use serde_json::Value;

use super::conditions::Group;
use super::geometry::Sheet;
use super::paths::{cross, parts, term};
use super::rest::Rest;
use super::{Defect, require};
use crate::number::{Exact, Number};

type Point = crate::plane::Point<Exact>;

/// Checks what belongs to the motion itself.
pub fn check(motion: &Group<Exact>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let answer = sheet.answer;
    let mut rest = Rest::default();
    // v vanishes in the pole.
    let velocity = term(motion, 1, &Number::zero());
    let spin = sine(motion, 1);
    let pole = [-velocity.im(), velocity.re().clone(), spin.clone()];
    rest.after(sheet.point(&answer["pole"], "pole", &pole))?;
    let circle = circle(|z| cross(&term(motion, 1, z), &term(motion, 2, z)));
    rest.after(sheet.up_to_factor(&answer["inflection_circle"], "inflection_circle", &circle))?;
    if spin.is_zero().is_yes() {
        let none = ["inflection_pole", "invariants", "ball_point"];
        rest.after(are_missing(&none, answer))?;
        return rest.finish();
    }
    let [x, y, w] = &pole;
    let pole = Number::complex(x / w, y / w);
    // The pole and the inflection pole are opposite on the circle.
    let [a, b, c, _] = &circle;
    let inflection_pole = Number::complex(-(b / a), -(c / a)) - &pole;
    let name = "inflection_pole";
    rest.after(sheet.finite_point(&answer[name], name, &parts(&inflection_pole)))?;
    let diameter = &inflection_pole - &pole;
    if diameter.is_zero().is_yes() {
        rest.after(are_missing(&["invariants", "ball_point"], answer))?;
        return rest.finish();
    }
    let line = circle_without_square(|z| cross(&term(motion, 1, z), &term(motion, 3, z)));
    let line = line.ok_or_else(|| Defect::unchecked("ball_point"))?;
    let ball_point = foot(&line, &inflection_pole);
    rest.after(sheet.point(&answer["ball_point"], "ball_point", &ball_point))?;
    rest.after(seen_from_pole(motion, [&pole, &diameter], sheet))?;
    rest.finish()
}

/// Whether there are none of these, and no curvatures of the polodes, where the pole is at infinity or
/// the inflection circle a point.
fn are_missing(names: &[&str], answer: &Value) -> Result<(), Defect> {
    for name in names {
        require(answer[*name].is_null(), name, "there is none here")?;
    }
    let polodes = &answer["polodes"];
    let polodes = ["fixed", "moving"].map(|name| &polodes[name]);
    let none = polodes.into_iter().all(Value::is_null);
    require(none, "polodes", "the polodes have no curvature here")
}

/// The invariants, and the curvatures of the polodes that they give. For the sine t + s₃t³ the turn is
/// t + (s₃ + 1/6)t³.
fn seen_from_pole(
    motion: &Group<Exact>,
    [pole, diameter]: [&Point; 2],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let seen = |n: usize| Number::i() * term(motion, n, pole) / diameter;
    let bent = sine(motion, 3) + Number::ratio(1, 6);
    let third = seen(3) * 6;
    let fourth = (seen(4) - Number::i() * Point::from(bent)) * 24;
    let mut rest = Rest::default();
    let [invariants, polodes] = ["invariants", "polodes"].map(|name| &sheet.answer[name]);
    for (name, own) in [("third", &third), ("fourth", &fourth)] {
        rest.after(sheet.finite_point(&invariants[name], "invariants", &parts(own)))?;
    }
    for (name, curvature) in [("fixed", third.re() + 1), ("moving", third.re() + 2)] {
        let [x, y] = parts(&(pole.scaled(&curvature) + diameter));
        rest.after(sheet.point(&polodes[name], "polodes", &[x, y, curvature]))?;
    }
    rest.finish()
}

/// What tⁿ is multiplied with in the sine of the turn.
fn sine(motion: &Group<Exact>, n: usize) -> Number<Exact> {
    motion
        .get(n)
        .map_or_else(Number::zero, |term| term.rotation.im().clone())
}

/// a (x² + y²) + b x + c y + d, from values in four points.
fn circle(value: impl Fn(&Point) -> Number<Exact>) -> [Number<Exact>; 4] {
    let at = |x: i64, y: i64| value(&Number::complex(x.into(), y.into()));
    let (origin, right, left, up) = (at(0, 0), at(1, 0), at(-1, 0), at(0, 1));
    let a = (&right + &left) / 2 - &origin;
    let b = (right - left) / 2;
    let c = up - &a - &origin;
    [a, b, c, origin]
}

/// The same where it is known to be a line.
fn circle_without_square(value: impl Fn(&Point) -> Number<Exact>) -> Option<[Number<Exact>; 3]> {
    let [a, b, c, d] = circle(value);
    a.is_zero().is_yes().then_some([b, c, d])
}

/// The foot of the perpendicular from a point to a line; not determined where all of the line vanishes.
fn foot([a, b, c]: &[Number<Exact>; 3], from: &Point) -> [Number<Exact>; 3] {
    let size = a.square() + b.square();
    let height = a * from.re() + b * from.im() + c;
    [
        from.re() * &size - a * &height,
        from.im() * &size - b * height,
        size,
    ]
}
