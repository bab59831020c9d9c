//! The paths of points of a motion: their centers of curvature and orders of contact.

use serde_json::{Value, json};

use super::conditions::Group;
use super::geometry::Sheet;
use super::rest::Rest;
use super::shown::list;
use super::{Defect, require};
use crate::number::{Exact, Number};

type Point = crate::plane::Point<Exact>;

/// What tⁿ is multiplied with in the path of a point.
pub fn term(motion: &Group<Exact>, n: usize, z: &Point) -> Point {
    motion
        .get(n)
        .map_or_else(Number::zero, |displacement| displacement.of(z))
}

pub fn cross(left: &Point, right: &Point) -> Number<Exact> {
    (left.conj() * right).im().clone()
}

pub fn dot(left: &Point, right: &Point) -> Number<Exact> {
    (left.conj() * right).re().clone()
}

pub fn parts(z: &Point) -> [Number<Exact>; 2] {
    [z.re().clone(), z.im().clone()]
}

/// The paths of the points that were asked for.
pub fn check(motion: &Group<Exact>, points: &[Point], sheet: &Sheet<'_>) -> Result<(), Defect> {
    if points.is_empty() {
        let none = sheet.answer["points"].is_null();
        return require(none, "points", "no point was asked for");
    }
    let shown = list(sheet.answer, "points")?;
    let all = shown.len() == points.len();
    require(all, "points", "one for each point was expected")?;
    let mut rest = Rest::default();
    for (shown, z) in shown.iter().zip(points) {
        rest.after(sheet.finite_point(&shown["point"], "points", &parts(z)))?;
        let path: Vec<Point> = (0..motion.len()).map(|n| term(motion, n, z)).collect();
        rest.after(path_is_shown(&path, shown, sheet))?;
    }
    rest.finish()
}

/// Center of curvature, and how far the path keeps to its tangent and its circle.
fn path_is_shown(path: &[Point], shown: &Value, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let [place, v, a, ..] = path else {
        return Ok(());
    };
    // The lines of the points as far from the path in t and in t².
    let (near, far) = (dot(v, place), dot(a, place) + v.norm() / 2);
    let center = [
        &near * a.im() - &far * v.im(),
        v.re() * &far - a.re() * near,
        cross(v, a),
    ];
    let mut rest = Rest::default();
    rest.after(sheet.point(&shown["center"], "points", &center))?;
    let tangent = v.is_zero().is_no().then(|| {
        let across = path.iter().map(|term| cross(v, term));
        contact(across)
    });
    let [x, y, w] = &center;
    let circle = w.is_zero().is_no().then(|| {
        let center = Number::complex(x / w, y / w);
        let mut links = path.to_vec();
        if let Some(start) = links.first_mut() {
            *start = &*start - center;
        }
        let square = |n: usize| {
            let pairs = links.iter().take(n + 1).zip(links.iter().take(n + 1).rev());
            pairs.map(|(one, other)| dot(one, other)).sum()
        };
        contact((0..links.len()).map(square))
    });
    let shown = &shown["contact"];
    for (name, own) in [("tangent", tangent), ("circle", circle)] {
        let right = own.unwrap_or(Value::Null);
        let said = &shown[name];
        require(*said == right, "points.contact", "it is of another order")?;
    }
    rest.finish()
}

/// The number of the last term that vanishes with all before it, from that in t on; or that all do.
fn contact(terms: impl Iterator<Item = Number<Exact>>) -> Value {
    let terms: Vec<Number<Exact>> = terms.skip(1).collect();
    match terms.iter().position(|term| term.is_zero().is_no()) {
        Some(order) => json!(order),
        None => json!({"at_least": terms.len()}),
    }
}
