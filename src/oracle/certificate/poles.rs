//! Whether an answer has the poles, image poles and turns: by the defining equations.

use serde_json::Value;

use super::fitted::is_turn;
use super::geometry::Sheet;
use super::known::Known;
use super::rest::Rest;
use super::shown::decided;
use super::{Defect, require};
use crate::finite::positions::Positions;
use crate::number::{Ball, Number};
use crate::oracle::positions::Given;
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// [x : y : w].
type Homogeneous<K> = [Number<K>; 3];

/// Checks everything.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    let mut rest = Rest::default();
    rest.after(match given.exact() {
        Some(positions) => poles(given, &positions, &sheet),
        None => poles(given, &given.rounded::<Ball>(&sheet.bits), &sheet),
    })?;
    rest.after(turns(&given.rounded(&sheet.bits), &sheet))?;
    rest.finish()
}

/// The points with one place in both positions, in the moving plane and in the fixed one.
pub fn poles<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let mut rest = Rest::default();
    for name in ["poles", "image_poles"] {
        let listed = sheet.answer[name].as_object().map(serde_json::Map::len);
        let count = positions.pairs().count();
        require(listed == Some(count), name, "one for every two positions")?;
    }
    for (i, j) in positions.pairs() {
        let Some([image, pole]) = both(given, positions, i, j) else {
            continue;
        };
        for (name, truth) in [("poles", pole), ("image_poles", image)] {
            let shown = &sheet.answer[name];
            rest.after(sheet.point(&shown[&label(i, j)], name, &truth))?;
        }
    }
    rest.finish()
}

/// The image pole and the pole of two positions.
fn both<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    i: usize,
    j: usize,
) -> Option<[Homogeneous<K>; 2]> {
    let list = positions.displacements();
    Some(pole(list.get(i)?, list.get(j)?, given.turn_alike(i, j)))
}

/// The pole of two positions as [x : y : w].
pub fn pole_of<K: Known>(
    given: &Given,
    positions: &Positions<K>,
    i: usize,
    j: usize,
) -> Option<Homogeneous<K>> {
    both(given, positions, i, j).map(|[_, pole]| pole)
}

fn label(i: usize, j: usize) -> String {
    format!("{}{}", i + 1, j + 1)
}

/// [x : y : w] of the point of the moving plane with r z + t = s z + u, and of its place r z + t; where
/// nothing turns, both are at infinity across the translation.
fn pole<K: Known>(
    a: &Displacement<K>,
    b: &Displacement<K>,
    is_translation: bool,
) -> [Homogeneous<K>; 2] {
    let shift = &b.translation - &a.translation;
    let turn = &a.rotation - &b.rotation;
    let homogeneous = |z: Point<K>, w: &Number<K>| [z.re().clone(), z.im().clone(), w.clone()];
    if is_translation || turn.is_zero().is_yes() {
        let across = Number::i() * shift;
        let seen = &across * a.rotation.conj();
        let zero = Number::zero();
        return [homogeneous(seen, &zero), homogeneous(across, &zero)];
    }
    let w = turn.norm();
    let z = shift * turn.conj();
    let place = &a.rotation * &z + a.translation.scaled(&w);
    [homogeneous(z, &w), homogeneous(place, &w)]
}

/// The directed angles between the positions.
fn turns(positions: &Positions<Ball>, sheet: &Sheet<'_>) -> Result<(), Defect> {
    let place = "turns";
    let list = positions.displacements();
    let listed = sheet.answer[place].as_object().map(serde_json::Map::len);
    let count = positions.pairs().count();
    require(listed == Some(count), place, "one for every two positions")?;
    for (i, j) in positions.pairs() {
        let (Some(a), Some(b)) = (list.get(i), list.get(j)) else {
            continue;
        };
        let turn = &b.rotation * a.rotation.conj();
        let shown = &sheet.answer[place];
        let shown = &shown[&label(i, j)];
        let degrees = decided(sheet.answer, &shown["degrees"], place)?;
        is_turn(degrees, &turn, place, sheet)?;
    }
    Ok(())
}
