//! Pairs that are not four isolated ones: families of them, or none.

use crate::finite::four_positions::circle_conditions;
use crate::number::{Exact, Number, Truth};
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::plane::{Point, relation};

/// What the circlepoints of a family are.
#[derive(Clone, Debug)]
pub enum Family {
    /// There is no pair at all: translations on no circle and no line.
    Empty,
    /// All points of the moving plane.
    Plane,
    /// All points of the moving plane, each along a line; the centers are at infinity in this
    /// direction.
    PlaneOfLines(Point<Exact>),
    /// The points of a cubic.
    CirclepointCubic(Box<Cubic<Exact>>),
    /// One point that has its place in common in so many positions that a line of centers is left.
    PointWithAnyCenter(Point<Exact>),
}

/// The family of positions that do not have four isolated pairs; `None` where it is none of those that
/// are known here.
pub fn family(positions: &[Displacement<Exact>; 5]) -> Option<Family> {
    let different = different(positions);
    if let Ok(four) = <[_; 4]>::try_from(different.clone()) {
        let cubic = circle_conditions::circlepoint_cubic(&four)?;
        let vanishes = cubic.coefficients().iter().all(|c| c.is_zero().is_yes());
        return Some(if vanishes {
            Family::Plane
        } else {
            Family::CirclepointCubic(Box::new(cubic))
        });
    }
    if different.len() < 4 {
        return Some(Family::Plane);
    }
    if are_translations(positions).is_yes() {
        return of_translations(positions);
    }
    if has_common_pole(positions).is_yes() {
        return Some(Family::Plane);
    }
    resting_point(positions).map(Family::PointWithAnyCenter)
}

fn different(positions: &[Displacement<Exact>; 5]) -> Vec<Displacement<Exact>> {
    let mut different: Vec<Displacement<Exact>> = Vec::new();
    for position in positions {
        let is_new = different
            .iter()
            .all(|other| !equal(other, position).is_yes());
        if is_new {
            different.push(position.clone());
        }
    }
    different
}

fn equal(a: &Displacement<Exact>, b: &Displacement<Exact>) -> Truth {
    a.rotation.equals(&b.rotation) & a.translation.equals(&b.translation)
}

fn are_translations(positions: &[Displacement<Exact>; 5]) -> Truth {
    let [first, rest @ ..] = positions;
    Truth::all(
        rest.iter()
            .map(|position| position.rotation.equals(&first.rotation)),
    )
}

fn of_translations(positions: &[Displacement<Exact>; 5]) -> Option<Family> {
    let places = positions
        .each_ref()
        .map(|position| position.translation.clone());
    if relation::collinear(&places).is_yes() {
        let [first, rest @ ..] = &places;
        let along = rest
            .iter()
            .map(|place| place - first)
            .find(|shift| shift.is_zero().is_no())?;
        return Some(Family::PlaneOfLines(Number::i() * along));
    }
    relation::concyclic(&places)
        .is_yes()
        .then_some(Family::Plane)
}

/// Whether one point of the moving plane stays where it is in all positions.
fn has_common_pole(positions: &[Displacement<Exact>; 5]) -> Truth {
    let [first, rest @ ..] = positions;
    let turned = rest
        .iter()
        .find(|position| position.rotation.equals(&first.rotation).is_no());
    let Some(other) = turned else {
        return Truth::No;
    };
    let pole = first.pole(other);
    let point = first.inverse().of(&pole);
    Truth::all(
        rest.iter()
            .map(|position| position.of(&point).equals(&pole)),
    )
}

/// A point of the moving plane that has only two places in all five positions.
fn resting_point(positions: &[Displacement<Exact>; 5]) -> Option<Point<Exact>> {
    for (i, a) in positions.iter().enumerate() {
        for b in positions.iter().skip(i + 1) {
            let point = a.inverse().of(&a.pole(b));
            if !point.has_value() {
                continue;
            }
            let mut places: Vec<Point<Exact>> = Vec::new();
            for place in positions.iter().map(|position| position.of(&point)) {
                if !places.iter().any(|other| other.equals(&place).is_yes()) {
                    places.push(place);
                }
            }
            if places.len() <= 2 {
                return Some(point);
            }
        }
    }
    None
}
