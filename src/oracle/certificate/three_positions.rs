//! Whether an answer to three positions is right: circles by the points whose places are on a line,
//! centers by the distances from three places.

use rug::Rational;
use serde_json::Value;

use super::geometry::Sheet;
use super::known::{Known, vanish};
use super::poles::poles;
use super::rest::Rest;
use super::shown::list;
use super::{Defect, require};
use crate::finite::positions::Positions;
use crate::number::{Ball, Number, Truth};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;
use crate::oracle::positions;
use crate::plane::displacement::Displacement;
use crate::plane::{Point, relation};

/// The problem.
pub struct Given {
    positions: positions::Given,
    circlepoints: Vec<[Rational; 2]>,
    centers: Vec<[Rational; 2]>,
}

impl Given {
    /// Reads it.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        Ok(Given {
            positions: positions::Given::read(fields, 3, 3)?,
            circlepoints: fields.optional_points("circlepoints")?,
            centers: fields.optional_points("centers")?,
        })
    }
}

/// Checks everything.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    match given.positions.exact() {
        Some(positions) => check_in(given, &positions, &sheet),
        None => check_in(given, &given.positions.rounded::<Ball>(&sheet.bits), &sheet),
    }
}

fn check_in<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let mut rest = Rest::default();
    rest.after(poles(&given.positions, positions, sheet))?;
    let inverse = positions.inverse();
    let both = [positions, &inverse].map(|one| one.displacements().first_chunk::<3>());
    let [Some(moved), Some(fixed)] = both else {
        return Err(Defect::unchecked("three positions were expected"));
    };
    rest.after(circle("centers_of_lines", fixed, sheet))?;
    rest.after(circle("points_on_lines", moved, sheet))?;
    let sides = [
        ("circlepoint", "center", &given.circlepoints, moved),
        ("center", "circlepoint", &given.centers, fixed),
    ];
    let mut listed = list(sheet.answer, "pairs")?.iter();
    for (known, sought, points, positions) in sides {
        for given in points {
            let pair = listed
                .next()
                .ok_or_else(|| Defect::wrong("pairs", "a pair is missing"))?;
            let given = positions::point(given);
            rest.after(pair_of(pair, [known, sought], &given, positions, sheet))?;
        }
    }
    require(
        listed.next().is_none(),
        "pairs",
        "nobody asked for one more",
    )?;
    rest.finish()
}

/// Whether a circle is that of the points whose three places are on a line. The area of their triangle
/// is a (x² + y²) + b x + c y + d, which four points tell.
fn circle<K: Known>(
    name: &str,
    positions: &[Displacement<K>; 3],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let area = |x: i64, y: i64| {
        let z = Number::complex(x.into(), y.into());
        let [p, q, r] = positions.each_ref().map(|position| position.of(&z));
        relation::twice_area(&p, &q, &r)
    };
    let d = area(0, 0);
    let (right, left) = (area(1, 0) - &d, area(-1, 0) - &d);
    let a = (&right + &left) / 2;
    let b = (right - left) / 2;
    let c = area(0, 1) - &d - &a;
    let shown = &sheet.answer[name];
    match vanish(&[a.clone(), b.clone(), c.clone(), d.clone()]) {
        Truth::Yes => return require(shown.is_null(), name, "every point is on it"),
        Truth::Unknown => return Err(Defect::unchecked(format!("whether {name} is a circle"))),
        Truth::No => {}
    }
    let all = [a.clone(), b.clone(), c.clone(), d.clone()];
    let of = |part: &str| format!("{name}.{part}");
    sheet.up_to_factor(&shown["coefficients"], &of("coefficients"), &all)?;
    if a.is_zero().is_yes() {
        let line = shown["center"].is_null() && shown["radius"].is_null();
        return require(line, name, "a line has no center");
    }
    let center = [&b / (-2 * &a), &c / (-2 * &a)];
    let [x, y] = &center;
    let square = x.square() + y.square() - d / a;
    sheet.finite_point(&shown["center"], &of("center"), &center)?;
    sheet.root(&shown["radius"], &of("radius"), &square)
}

/// Whether a pair has the given point, and the one that its three places are equally far from.
fn pair_of<K: Known>(
    pair: &Value,
    [known, sought]: [&str; 2],
    given: &Point<K>,
    positions: &[Displacement<K>; 3],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let of = |part: &str| format!("pairs.{part}");
    let own = [given.re().clone(), given.im().clone()];
    sheet.finite_point(&pair[known], &of(known), &own)?;
    let places = positions.each_ref().map(|position| position.of(given));
    let [x, y, w] = equally_far(&places);
    sheet.point(
        &pair[sought],
        &of(sought),
        &[x.clone(), y.clone(), w.clone()],
    )?;
    if w.is_zero().is_yes() {
        let none = pair["radius"].is_null();
        return require(none, "pairs.radius", "there is no radius");
    }
    let center = Number::complex(x / &w, y / w);
    let square = relation::distance_squared(&places[0], &center);
    sheet.root(&pair["radius"], "pairs.radius", &square)
}

/// [x : y : w] of the center of the circle through three points: at infinity where they are on a line,
/// not determined where two coincide.
fn equally_far<K: Known>([p, q, r]: &[Point<K>; 3]) -> [Number<K>; 3] {
    let (u, v) = (q - p, r - p);
    let w = 2 * relation::twice_area(p, q, r);
    let across = v.scaled(&u.norm()) - u.scaled(&v.norm());
    let from_p = -(Number::i() * across);
    let center = from_p + p.scaled(&w);
    [center.re().clone(), center.im().clone(), w]
}
