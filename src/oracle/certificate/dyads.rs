//! The pairs of an answer as what linkages are made of.

use serde_json::{Value, json};

use super::conditions::{Five, apart};
use super::geometry::Sheet;
use super::linkages::{self, Dyad, Joint};
use super::pairs::{Pair, Pairs};
use super::rest::Rest;
use super::shown::{Shown, list, point};
use super::{Defect, require};
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Every two pairs once, in order, finite ones before those at infinity; and what is said of them in the
/// positions that are apart.
pub fn linkages(five: &impl Five, pairs: &Pairs<'_>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let linkages = list(sheet.answer, "linkages")?;
    let mut names: Vec<Value> = (0..pairs.real().count()).map(Value::from).collect();
    for (place, pair) in pairs.at_infinity.iter().enumerate() {
        let before = place.checked_sub(1);
        let before = before.and_then(|before| pairs.at_infinity.get(before));
        let is_new = before != Some(pair);
        if is_new && pair["kind"] != "isotropic" {
            names.push(json!({"at_infinity": place}));
        }
    }
    let every = names.iter().enumerate().flat_map(|(place, one)| {
        let others = names.iter().skip(place + 1);
        others.map(move |other| json!([one, other]))
    });
    let listed = linkages.iter().map(|linkage| linkage["pairs"].clone());
    require(
        listed.eq(every),
        "linkages",
        "not every two pairs, once each",
    )?;
    let positions = apart(&five.enclosed(sheet.bits));
    let exact = five.exact().map(|groups| apart(&groups));
    let first = exact.as_ref().and_then(|positions| positions.first());
    let finite: Vec<Dyad> = pairs
        .real()
        .map(|pair| finite(pair, &positions, first))
        .collect();
    let infinite = infinite(&positions, pairs.at_infinity, sheet)?;
    let named = |name: &Value| {
        let (list, place) = match name.as_u64() {
            Some(place) => (&finite, Some(place)),
            None => (&infinite, name["at_infinity"].as_u64()),
        };
        list.get(usize::try_from(place?).ok()?)
    };
    let mut rest = Rest::default();
    for linkage in linkages {
        let shown = &linkage["pairs"];
        if let [Some(first), Some(second)] = [0, 1].map(|side: usize| named(&shown[side])) {
            rest.after(linkages::check([first, second], linkage, sheet))?;
        }
    }
    rest.finish()
}

/// A real finite pair with the places of its circlepoint; `exact` is the first position.
fn finite(
    pair: &Pair,
    positions: &[Displacement<Ball>],
    exact: Option<&Displacement<Exact>>,
) -> Dyad {
    let real = |x: &Number<Complex<Ball>>, y: &Number<Complex<Ball>>| {
        Number::complex(x.re().clone(), y.re().clone())
    };
    let [x, y, cx, cy] = &pair.enclosure;
    let z = real(x, y);
    let places = positions.iter();
    let exact = pair.exactly().zip(exact);
    Dyad {
        center: Joint::At(real(cx, cy)),
        places: places.map(|position| Joint::At(position.of(&z))).collect(),
        exact: exact.map(|([z, center], first)| [center, first.of(&z)]),
    }
}

/// The pairs at infinity, with the directions that are listed.
fn infinite(
    positions: &[Displacement<Ball>],
    at_infinity: &[Value],
    sheet: &Sheet<'_>,
) -> Result<Vec<Dyad>, Defect> {
    let dyad = |value: &Value| {
        let read = |name: &str| listed(&value[name], sheet);
        let places = positions.iter();
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
