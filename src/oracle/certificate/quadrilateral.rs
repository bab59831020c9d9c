//! Whether what is said of the opposite-pole quadrilaterals is so: by lengths and by which sides and
//! diagonals cross.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::geometry::Sheet;
use super::known::{Known, root};
use super::poles::pole_of;
use super::rest::Rest;
use super::shown::{decided, list};
use super::{Defect, require};
use crate::finite::positions::Positions;
use crate::number::{Ball, Number, array};
use crate::oracle::positions::Given;
use crate::plane::{Point, relation};

/// The poles in order, positions counted from 1.
const VERTICES: [[&str; 4]; 3] = [
    ["12", "23", "34", "14"],
    ["12", "24", "34", "13"],
    ["14", "24", "23", "13"],
];

/// A pole: finite, not, or unknown.
type Vertex<K> = Option<Option<Point<K>>>;

/// Checks everything.
pub fn check<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let listed = list(sheet.answer, "quadrilaterals")?;
    require(listed.len() == 3, "quadrilaterals", "there are three")?;
    let mut rest = Rest::default();
    for (labels, shown) in VERTICES.iter().zip(listed) {
        let named = shown["vertices"] == json!(labels);
        require(
            named,
            "quadrilaterals.vertices",
            "other poles were expected",
        )?;
        let vertices = labels.map(|label| vertex(given, positions, label));
        let ends = array::sides(&vertices);
        for (side, (from, to)) in list(shown, "sides")?.iter().zip(ends.iter().cycle()) {
            rest.after(is_side(side, [from, to], sheet))?;
        }
        let count = list(shown, "sides")?.len();
        require(count == 4, "quadrilaterals.sides", "there are four")?;
        let finite = vertices.map(|vertex| vertex.map(|point| point.ok_or(())));
        rest.after(match finite {
            [Some(Ok(a)), Some(Ok(b)), Some(Ok(c)), Some(Ok(d))] => {
                described(&[a, b, c, d], shown, sheet)
            }
            [Some(_), Some(_), Some(_), Some(_)] => without_four_vertices(shown),
            _ => Err(Defect::unchecked("whether all poles are finite")),
        })?;
    }
    rest.finish()
}

/// The pole with this label.
fn vertex<K: Known>(given: &Given, positions: &Positions<K>, label: &str) -> Vertex<K> {
    let mut places = label.bytes().map(|digit| usize::from(digit - b'1'));
    let [x, y, w] = pole_of(given, positions, places.next()?, places.next()?)?;
    if w.is_zero().is_unknown() {
        return None;
    }
    let is_finite = w.is_zero().is_no();
    Some(is_finite.then(|| Number::complex(x / &w, y / w)))
}

fn is_side<K: Known>(
    shown: &Value,
    ends: [&Vertex<K>; 2],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let place = "quadrilaterals.sides";
    match ends {
        [Some(Some(from)), Some(Some(to))] => {
            sheet.root(shown, place, &relation::distance_squared(from, to))
        }
        [Some(_), Some(_)] => require(shown.is_null(), place, "an end is not finite"),
        _ => Err(Defect::unchecked("whether a side has a length")),
    }
}

/// Only the shape has a meaning, and it is degenerate.
fn without_four_vertices(shown: &Value) -> Result<(), Defect> {
    let right = shown["shape"] == "degenerate"
        && shown["u_vs_z"].is_null()
        && shown["shortest_and_longest"].is_null();
    require(right, "quadrilaterals", "a vertex is not finite")
}

fn described<K: Known>(
    vertices: &[Point<K>; 4],
    shown: &Value,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let squares = array::sides(vertices).map(|(from, to)| relation::distance_squared(from, to));
    let own = [
        ("shape", shape(vertices)),
        ("u_vs_z", u_vs_z(&squares, sheet.bits)),
        ("shortest_and_longest", extremes(&squares)),
    ];
    let mut rest = Rest::default();
    for (name, own) in own {
        let place = format!("quadrilaterals.{name}");
        rest.after(match own {
            Some(word) => {
                let said = decided(sheet.answer, &shown[name], &place)?;
                require(*said == word, &place, "another word was expected")
            }
            None => Err(Defect::unchecked(place)),
        })?;
    }
    rest.finish()
}

/// Convex where the diagonals cross, crossed where two opposite sides do, else concave.
fn shape<K: Known>([a, b, c, d]: &[Point<K>; 4]) -> Option<&'static str> {
    let side = |p, q, r| relation::twice_area(p, q, r).sign();
    let corners = [
        side(a, b, c)?,
        side(b, c, d)?,
        side(c, d, a)?,
        side(d, a, b)?,
    ];
    if corners.contains(&Ordering::Equal) {
        return Some("degenerate");
    }
    let cross = |p, q, r, s| -> Option<bool> {
        let apart = side(p, q, r)? != side(p, q, s)? && side(r, s, p)? != side(r, s, q)?;
        Some(apart)
    };
    Some(if cross(a, c, b, d)? {
        "convex"
    } else if cross(a, b, c, d)? || cross(b, c, d, a)? {
        "crossed"
    } else {
        "concave"
    })
}

/// The shortest and the longest side together against the two others.
fn u_vs_z<K: Known>(squares: &[Number<K>; 4], bits: u32) -> Option<&'static str> {
    let mut lengths: Vec<Number<Ball>> = squares.iter().map(|square| root(square, bits)).collect();
    lengths.sort_by(|a, b| a.compare(b).unwrap_or(Ordering::Equal));
    let [shortest, one, other, longest] = lengths.as_slice() else {
        return None;
    };
    match (shortest + longest - one - other).sign() {
        Some(Ordering::Less) => Some("<"),
        Some(Ordering::Equal) => Some("="),
        Some(Ordering::Greater) => Some(">"),
        None => some_sums_agree(squares).then_some("="),
    }
}

/// Whether two of the sides are together as long as the two others: (k² + 4uv − 4xy)² = 16k²uv for
/// k = u + v − x − y, from the squares.
fn some_sums_agree<K: Known>([u, v, x, y]: &[Number<K>; 4]) -> bool {
    let k = u + v - x - y;
    let sum = k.square() + 4 * u * v - 4 * x * y;
    let left = sum.square() - 16 * k.square() * u * v;
    left.is_zero().is_yes()
}

/// Whether a shortest and a longest side are neighbours.
fn extremes<K: Known>(squares: &[Number<K>; 4]) -> Option<&'static str> {
    let reached_by = |wanted: Ordering| -> Option<Vec<usize>> {
        let mut places = Vec::new();
        for (place, one) in squares.iter().enumerate() {
            let mut is_extreme = true;
            for other in squares {
                let order = one.compare(other);
                // A side and itself, also where it is an enclosure.
                let same = std::ptr::eq(one, other);
                is_extreme &= same || order? == wanted || order?.is_eq();
            }
            if is_extreme {
                places.push(place);
            }
        }
        Some(places)
    };
    let (least, most) = (reached_by(Ordering::Less)?, reached_by(Ordering::Greater)?);
    let has = |distance: usize| {
        let of = |i: &usize| most.iter().any(|j| i.abs_diff(*j) % 4 == distance);
        least.iter().any(of)
    };
    match (has(1) || has(3), has(2)) {
        (true, true) => Some("both"),
        (true, false) => Some("adjacent"),
        (false, true) => Some("opposite"),
        (false, false) => None,
    }
}
