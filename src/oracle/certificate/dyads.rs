//! The pairs of an answer as what linkages are made of.

use serde_json::Value;

use super::Defect;
use super::geometry::Sheet;
use super::linkages::{Dyad, Joint};
use super::newton::Vector;
use super::shown::{Shown, point};
use crate::number::{Ball, Complex, Exact, Number};
use crate::oracle::positions::Given;
use crate::plane::Point;

/// Real finite pairs with the places of their circlepoints; some are known exactly, circlepoint and
/// center.
pub fn finite<'a>(
    given: &Given,
    pairs: impl Iterator<Item = (&'a Vector, Option<[Point<Exact>; 2]>)>,
    bits: u32,
) -> Vec<Dyad> {
    let positions = given.rounded::<Ball>(&bits);
    let first = given.rational();
    let first = first.and_then(|all| all.displacements().first().cloned());
    let real = |x: &Number<Complex<Ball>>, y: &Number<Complex<Ball>>| {
        Number::complex(x.re().clone(), y.re().clone())
    };
    pairs
        .map(|([x, y, cx, cy], exact)| {
            let z = real(x, y);
            let places = positions.displacements().iter();
            let exact = exact.zip(first.as_ref());
            Dyad {
                center: Joint::At(real(cx, cy)),
                places: places.map(|position| Joint::At(position.of(&z))).collect(),
                exact: exact.map(|([z, center], first)| [center, first.of(&z)]),
            }
        })
        .collect()
}

/// The pairs at infinity, with the directions that are listed.
pub fn infinite(
    given: &Given,
    at_infinity: &[Value],
    sheet: &Sheet<'_>,
) -> Result<Vec<Dyad>, Defect> {
    let positions = given.rounded::<Ball>(&sheet.bits);
    let dyad = |value: &Value| {
        let read = |name: &str| listed(&value[name], sheet);
        let places = positions.displacements().iter();
        let (center, places) = match value["kind"].as_str() {
            Some("center") => {
                let z = read("circlepoint")?;
                let places = places.map(|position| Joint::At(position.of(&z)));
                (Joint::towards(&read("direction")?), places.collect())
            }
            Some("circlepoint") => {
                let z = read("direction")?;
                let places = places.map(|position| Joint::towards(&(&position.rotation * &z)));
                (Joint::At(read("center")?), places.collect())
            }
            // An isotropic one makes no linkage.
            _ => (Joint::At(Number::zero()), Vec::new()),
        };
        Ok(Dyad {
            center,
            places,
            exact: None,
        })
    };
    at_infinity.iter().map(dyad).collect()
}

/// A point or direction; an exact number has no precision, to which a length could be computed.
fn listed(value: &Value, sheet: &Sheet<'_>) -> Result<Point<Ball>, Defect> {
    let [x, y] = point(value, "at_infinity", sheet.digits)?;
    let part = |part: &Shown| Number(part.ball(sheet.bits).0.with_precision(sheet.bits));
    Ok(Number::complex(part(&x.re), part(&y.re)))
}
