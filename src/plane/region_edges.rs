//! Regions of the plane by their boundary: inside of a circle or of a polygon.

use std::cmp::Ordering;

use rug::Rational;

use super::{Point, relation};
use crate::number::{Exact, Kind, Number, Real, Truth};

/// A closed region: its boundary belongs to it.
#[derive(Clone, Debug)]
pub enum Region {
    /// Within a circle of positive radius.
    Circle {
        /// Its center.
        center: Point<Exact>,
        /// Its radius.
        radius: Number<Exact>,
    },
    /// Within a polygon whose sides meet in its corners only, by these.
    Polygon(Vec<Point<Exact>>),
}

/// A rational point in another kind, where it is exact.
fn constant<K: Kind>(point: &Point<Exact>) -> Point<K> {
    let part = |x: &Number<Exact>| {
        let q: Option<&Rational> = x.0.rational();
        q.map_or_else(|| Number::zero().inverse(), |q| Number::from(q.clone()))
    };
    Number::complex(part(point.re()), part(point.im()))
}

impl Region {
    /// Functions of a point one of which at least vanishes on the boundary: the power with respect to
    /// the circle, the distances from the lines through the sides.
    pub fn edges<K: Kind>(&self, point: &Point<K>) -> Vec<Number<K>> {
        match self {
            Region::Circle { center, radius } => {
                let square: Number<K> = constant::<K>(&radius.square().into()).re().clone();
                vec![relation::distance_squared(point, &constant(center)) - square]
            }
            Region::Polygon(corners) => sides(corners)
                .map(|[a, b]| relation::twice_area(&constant(a), &constant(b), point))
                .collect(),
        }
    }

    /// Whether a point is inside or on the boundary.
    pub fn contains<K: Real>(&self, point: &Point<K>) -> Truth {
        match self {
            Region::Circle { .. } => {
                let power = self.edges(point).pop();
                Truth::of_sign(power.and_then(|power| power.sign()), Ordering::is_le)
            }
            Region::Polygon(corners) => {
                let around = winding(corners, point);
                around.map_or(Truth::Unknown, |number| (number != 0).into())
            }
        }
    }
}

/// The sides of a polygon.
pub fn sides<T>(corners: &[T]) -> impl Iterator<Item = [&T; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| [a, b])
}

/// How often a polygon goes round a point, 1 for a point on it; `None` where it cannot be told.
///
/// Upward sides that have the point to their left count, and downward ones that have it to their
/// right, each with its lower end and without its upper one; corners are looked at for themselves.
fn winding<K: Real>(corners: &[Point<Exact>], point: &Point<K>) -> Option<i32> {
    let mut number = 0;
    for [a, b] in sides(corners) {
        let [a, b] = [constant::<K>(a), constant::<K>(b)];
        if a.equals(point).is_yes() {
            return Some(1);
        }
        let above = |corner: &Point<K>| Some(corner.im().compare(point.im())?.is_gt());
        let (from_above, to_above) = (above(&a)?, above(&b)?);
        let within =
            |x: &Number<K>, y: &Number<K>, z: &Number<K>| Some(((x - y) * (z - y)).sign()?.is_le());
        if from_above == to_above {
            // Only a level side can hold the point.
            let is_level = a.im().equals(b.im()).is_yes() && a.im().equals(point.im()).is_yes();
            if is_level && within(a.re(), point.re(), b.re())? {
                return Some(1);
            }
            continue;
        }
        match relation::twice_area(&a, &b, point).sign()? {
            Ordering::Equal => return Some(1),
            Ordering::Greater if to_above => number += 1,
            Ordering::Less if from_above => number -= 1,
            _ => {}
        }
    }
    Some(number)
}

/// Whether two sides of a closed row of corners meet elsewhere than in a corner that they share, or
/// one has no length.
pub fn crosses_itself(corners: &[Point<Exact>]) -> bool {
    let list: Vec<[&Point<Exact>; 2]> = sides(corners).collect();
    let count = list.len();
    let meets = |i: usize, j: usize| {
        let ([a, b], [c, d]) = (list[i], list[j]);
        if j == i + 1 || (i == 0 && j + 1 == count) {
            // Neighbours: the far end of each must not lie on the other.
            let (before, corner, after) = if j == i + 1 { (a, b, d) } else { (c, d, b) };
            let back = (before - corner).conj() * (after - corner);
            return back.im().is_zero().is_yes() && back.re().is_positive().is_yes();
        }
        let side = |p, q, r| {
            relation::twice_area(p, q, r)
                .sign()
                .unwrap_or(Ordering::Equal)
        };
        let (s, t, u, v) = (side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b));
        let on = |p: &Point<Exact>, q: &Point<Exact>, r: &Point<Exact>| {
            let between = ((p - r).conj() * (q - r)).re().sign();
            between.is_some_and(Ordering::is_le)
        };
        let touches = |sign: Ordering, p, q, r| sign.is_eq() && on(p, q, r);
        (s.is_ne() && s == t.reverse() && u.is_ne() && u == v.reverse())
            || touches(s, a, b, c)
            || touches(t, a, b, d)
            || touches(u, c, d, a)
            || touches(v, c, d, b)
    };
    let empty = list.iter().any(|[a, b]| a.equals(b).is_yes());
    empty || (0..count).any(|i| (i + 1..count).any(|j| meets(i, j)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(corners: &[(i64, i64)]) -> Vec<Point<Exact>> {
        let point = |&(x, y): &(i64, i64)| Number::complex(x.into(), y.into());
        corners.iter().map(point).collect()
    }

    fn at(x: i64, y: i64) -> Point<Exact> {
        Number::complex(Number::ratio(x, 2), Number::ratio(y, 2))
    }

    #[test]
    fn a_polygon_with_a_notch_holds_its_boundary() {
        for corners in [
            [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)],
            [(0, 4), (2, 1), (4, 4), (4, 0), (0, 0)],
        ] {
            let region = Region::Polygon(polygon(&corners));
            for (x, y, inside) in [
                (2, 2, true),
                (4, 4, false),
                (4, 2, true),
                (0, 8, true),
                (8, 3, true),
                (3, 0, true),
                (9, 0, false),
                (-1, 0, false),
                (-1, 8, false),
                (1, 7, false),
                (1, 5, true),
            ] {
                let found = region.contains(&at(x, y));
                assert_eq!(found, inside.into(), "({x}, {y})/2 in {corners:?}");
            }
        }
    }

    #[test]
    fn crossing_sides_are_seen() {
        let square = [(0, 0), (2, 0), (2, 2), (0, 2)];
        let crossed = [(0, 0), (2, 2), (2, 0), (0, 2)];
        let folded = [(0, 0), (2, 0), (1, 0)];
        let touching = [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)];
        assert!(!crosses_itself(&polygon(&square)));
        for wrong in [&crossed[..], &folded, &touching] {
            assert!(crosses_itself(&polygon(wrong)), "{wrong:?}");
        }
    }
}
