//! Regions of the plane, with their boundaries, and what lies in them.

use std::cmp::Ordering;

use super::{Point, relation};
use crate::number::{Exact, Kind, Number, Real, Truth};

/// A closed region.
#[derive(Clone, Debug)]
pub enum Region<K> {
    /// A rectangle along the axes, by two opposite corners.
    Box([Point<K>; 2]),
    /// A disk.
    Circle {
        /// Its center.
        center: Point<K>,
        /// Its radius, not negative.
        radius: Number<K>,
    },
    /// The inside of a polygon that does not meet itself, by its vertices in order.
    Polygon(Vec<Point<K>>),
}

impl Region<Exact> {
    /// The same region in another kind that holds its numbers exactly.
    pub fn in_kind<K: Kind>(&self) -> Region<K> {
        match self {
            Region::Box(corners) => Region::Box(corners.each_ref().map(Point::<Exact>::in_kind)),
            Region::Circle { center, radius } => Region::Circle {
                center: center.in_kind(),
                radius: radius.in_kind(),
            },
            Region::Polygon(vertices) => {
                Region::Polygon(vertices.iter().map(Point::<Exact>::in_kind).collect())
            }
        }
    }
}

impl<K: Real> Region<K> {
    /// Whether a point lies in the region or on its boundary.
    pub fn contains(&self, point: &Point<K>) -> Truth {
        match self {
            Region::Box([p, q]) => {
                // Between two numbers: the product of the differences is not positive.
                let between = |x: &Number<K>, a: &Number<K>, b: &Number<K>| {
                    let (from_a, from_b) = (x.compare(a), x.compare(b));
                    at_most_zero(from_a) & !less_than_zero(from_b)
                        | at_most_zero(from_b) & !less_than_zero(from_a)
                };
                between(point.re(), p.re(), q.re()) & between(point.im(), p.im(), q.im())
            }
            Region::Circle { center, radius } => {
                let power = relation::distance_squared(point, center) - radius.square();
                at_most_zero(power.sign())
            }
            Region::Polygon(vertices) => in_polygon(vertices, point),
        }
    }
}

fn at_most_zero(sign: Option<Ordering>) -> Truth {
    Truth::of_sign(sign, Ordering::is_le)
}

fn less_than_zero(sign: Option<Ordering>) -> Truth {
    Truth::of_sign(sign, Ordering::is_lt)
}

/// From each vertex to the next.
pub(super) fn edges<K>(vertices: &[Point<K>]) -> impl Iterator<Item = (&Point<K>, &Point<K>)> {
    vertices.iter().zip(vertices.iter().cycle().skip(1))
}

/// Whether a point lies on a segment, its ends included.
fn on_segment<K: Real>(a: &Point<K>, b: &Point<K>, point: &Point<K>) -> Truth {
    let product = (a - point).conj() * (b - point);
    product.im().is_zero() & at_most_zero(product.re().sign())
}

/// Slopes of the rays along which crossings are counted: another one where a ray may meet a vertex.
const SLOPES: [(i64, i64); 6] = [(0, 1), (1, 7), (-3, 11), (5, 3), (-2, 1), (17, 5)];

fn in_polygon<K: Real>(vertices: &[Point<K>], point: &Point<K>) -> Truth {
    match Truth::any(edges(vertices).map(|(a, b)| on_segment(a, b, point))) {
        Truth::No => SLOPES
            .iter()
            .find_map(|(n, d)| crossed_oddly(vertices, point, &Number::ratio(*n, *d)))
            .map_or(Truth::Unknown, Truth::from),
        boundary => boundary,
    }
}

/// Whether a ray from the point crosses an odd number of edges; `None` where that cannot be told.
fn crossed_oddly<K: Real>(
    vertices: &[Point<K>],
    point: &Point<K>,
    slope: &Number<K>,
) -> Option<bool> {
    // A vertex on the ray counts as below it.
    let above = |vertex: &Point<K>| -> Option<bool> {
        let from = vertex - point;
        Some((from.im() - slope * from.re()).sign()?.is_gt())
    };
    let mut odd = false;
    for (a, b) in edges(vertices) {
        let side = match (above(a)?, above(b)?) {
            (false, true) => relation::twice_area(a, b, point),
            (true, false) => relation::twice_area(b, a, point),
            _ => continue,
        };
        odd ^= side.sign()?.is_gt();
    }
    Some(odd)
}

/// Whether a closed polygon does not meet itself, but for the common ends of neighbours.
pub fn is_simple<K: Real>(vertices: &[Point<K>]) -> Truth {
    let edges: Vec<_> = edges(vertices).collect();
    let last = edges.len().saturating_sub(1);
    let mut truth = Truth::from(vertices.len() >= 3);
    for (i, (a, b)) in edges.iter().enumerate() {
        truth = truth & !a.equals(b);
        for (j, (c, d)) in edges.iter().enumerate().skip(i + 1) {
            let apart = if j == i + 1 {
                !on_segment(a, b, d) & !on_segment(c, d, a)
            } else if i == 0 && j == last {
                !on_segment(a, b, c) & !on_segment(c, d, b)
            } else {
                !meet(a, b, c, d)
            };
            truth = truth & apart;
            if truth.is_no() {
                return truth;
            }
        }
    }
    truth
}

/// Whether two segments have a point in common.
fn meet<K: Real>(a: &Point<K>, b: &Point<K>, c: &Point<K>, d: &Point<K>) -> Truth {
    let ends = [
        on_segment(a, b, c),
        on_segment(a, b, d),
        on_segment(c, d, a),
        on_segment(c, d, b),
    ];
    let parted = |a: &Point<K>, b: &Point<K>, c: &Point<K>, d: &Point<K>| {
        let sides = relation::twice_area(a, b, c) * relation::twice_area(a, b, d);
        less_than_zero(sides.sign())
    };
    Truth::any(ends) | (parted(a, b, c, d) & parted(c, d, a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    fn polygon(list: &[(i64, i64)]) -> Vec<Point<Exact>> {
        list.iter().map(|(x, y)| point(*x, *y)).collect()
    }

    #[test]
    fn a_box_by_any_two_corners() {
        for corners in [[(0, 0), (4, 2)], [(4, 0), (0, 2)], [(4, 2), (0, 0)]] {
            let region = Region::Box(corners.map(|(x, y)| point(x, y)));
            for (x, y, inside) in [
                (1, 1, true),
                (0, 0, true),
                (4, 1, true),
                (5, 1, false),
                (1, 3, false),
                (-1, 1, false),
            ] {
                assert_eq!(region.contains(&point(x, y)), inside.into(), "{x}, {y}");
            }
        }
    }

    #[test]
    fn a_circle_with_its_boundary() {
        let region = Region::Circle {
            center: point(1, 0),
            radius: 5.into(),
        };
        for (x, y, inside) in [(4, 4, true), (1, 1, true), (5, 4, false), (-4, 0, true)] {
            assert_eq!(region.contains(&point(x, y)), inside.into(), "{x}, {y}");
        }
    }

    /// A comb: rays pass through vertices and along edges.
    #[test]
    fn a_polygon_with_its_boundary() {
        let comb = polygon(&[
            (0, 0),
            (9, 0),
            (9, 4),
            (7, 4),
            (7, 2),
            (5, 2),
            (5, 4),
            (3, 4),
            (3, 2),
            (2, 2),
            (0, 4),
        ]);
        assert!(is_simple(&comb).is_yes());
        let mut turned = comb.clone();
        turned.reverse();
        for vertices in [comb, turned] {
            let region = Region::Polygon(vertices);
            for (x, y, inside) in [
                (1, 2, true),
                (4, 2, true),
                (6, 2, true),
                (6, 3, false),
                (4, 3, true),
                (2, 3, false),
                (8, 3, true),
                (-1, 2, false),
                (10, 2, false),
                (6, 4, false),
                (8, 4, true),
                (0, 4, true),
                (1, 4, false),
                (10, 0, false),
                (-1, 4, false),
                (1, 3, true),
            ] {
                assert_eq!(region.contains(&point(x, y)), inside.into(), "{x}, {y}");
            }
        }
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
                let half = point(x, y).scaled(&Number::ratio(1, 2));
                assert_eq!(
                    region.contains(&half),
                    inside.into(),
                    "({x}, {y})/2 in {corners:?}"
                );
            }
        }
    }

    #[test]
    fn polygons_that_meet_themselves() {
        for list in [
            vec![(0, 0), (2, 2), (2, 0), (0, 2)],
            vec![(0, 0), (4, 0), (2, 0)],
            vec![(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],
            vec![(0, 0), (0, 0), (1, 1)],
            vec![(0, 0), (1, 1)],
        ] {
            assert!(is_simple(&polygon(&list)).is_no(), "{list:?}");
        }
        for list in [
            vec![(0, 0), (4, 0), (1, 1)],
            vec![(0, 0), (2, 0), (2, 2), (0, 2)],
        ] {
            assert!(is_simple(&polygon(&list)).is_yes(), "{list:?}");
        }
    }
}
