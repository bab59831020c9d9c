//! Where there are infinitely many pairs, any of them may be given.

use super::read::{Member, Part, Stated, Statements};
use crate::number::Number;
use crate::oracle::displacements;
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// The positions of a problem with a family of pairs.
pub struct Positions(Vec<Displacement<f64>>);

impl Positions {
    /// The positions, where the certified answer has a family.
    pub fn of_family(problem: &serde_json::Value, statements: &Statements) -> Option<Self> {
        let family = statements.iter().any(|(place, stated)| {
            let Stated::One { part, .. } = stated else {
                return false;
            };
            place == "family.kind" && *part != Part::Word("none".to_owned())
        });
        family.then(|| displacements(problem).ok().map(Positions))?
    }

    /// Whether the circlepoint keeps its distance from the center, measured by the way it goes.
    pub fn hold(&self, member: &Member, tolerance: f64) -> bool {
        let named = |name: &str| {
            let part = member.parts.iter().find(|(other, _)| *other == name);
            part.and_then(|(_, part)| finite(part))
        };
        let (Some(circlepoint), Some(center)) = (named("circlepoint"), named("center")) else {
            return false;
        };
        let places: Vec<[f64; 2]> = self
            .0
            .iter()
            .map(|position| coordinates(&position.of(&circlepoint)))
            .collect();
        let [x, y] = coordinates(&center);
        let distances = places.iter().map(|[a, b]| (a - x).hypot(b - y));
        let (least, greatest) = distances.fold((f64::INFINITY, 0.0_f64), |(least, greatest), d| {
            (least.min(d), greatest.max(d))
        });
        let way = places.iter().flat_map(|[a, b]| {
            let others = places.iter();
            others.map(move |[c, d]| (a - c).hypot(b - d))
        });
        let way = way.fold(0.0, f64::max);
        greatest - least <= tolerance * way
    }
}

fn finite(part: &Part) -> Option<Point<f64>> {
    match part {
        Part::Numbers(numbers) => match numbers.as_slice() {
            [x, y] => Some(Number::complex(
                Number(x.value.to_f64()),
                Number(y.value.to_f64()),
            )),
            _ => None,
        },
        _ => None,
    }
}

fn coordinates(point: &Point<f64>) -> [f64; 2] {
    [point.re().0, point.im().0]
}
