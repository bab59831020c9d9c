//! Circlepoints and centers: in three positions every point of the moving plane has a center, in
//! more those of a curve or some.

use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::circle::Circle;
use crate::plane::displacement::Displacement;
use crate::plane::projective::{Line, ProjectivePoint};

/// The center of a circlepoint: where the perpendicular bisectors of its places meet, at infinity where
/// the places lie on a line. Not determined where the places, or the bisectors, are the same, and
/// where the bisectors are known not to meet in one point.
pub fn center<K: Kind>(positions: &[Displacement<K>], point: &Point<K>) -> ProjectivePoint<K> {
    let mut places: Vec<Point<K>> = Vec::new();
    for place in positions.iter().map(|position| position.of(point)) {
        // A place that is taken twice gives no other line than once.
        if !places.iter().any(|other| other.equals(&place).is_yes()) {
            places.push(place);
        }
    }
    let mut bisectors: Vec<Line<K>> = Vec::new();
    for (i, a) in places.iter().enumerate() {
        for b in places.iter().skip(i + 1) {
            bisectors.push(bisector(a, b));
        }
    }
    common_point(&bisectors)
}

/// The circlepoint of a center: the center of the inverse motion.
pub fn circlepoint<K: Kind>(
    positions: &[Displacement<K>],
    center_: &Point<K>,
) -> ProjectivePoint<K> {
    let inverse: Vec<Displacement<K>> = positions.iter().map(Displacement::inverse).collect();
    center(&inverse, center_)
}

/// The points equally far from two: 2 Re (B − A)‾z = |B|² − |A|².
fn bisector<K: Kind>(a: &Point<K>, b: &Point<K>) -> Line<K> {
    let across = b - a;
    Line::new(2 * across.re(), 2 * across.im(), a.norm() - b.norm())
}

/// Where lines meet that are known to have a point in common: of the pairs, the first that is known to
/// be two lines.
fn common_point<K: Kind>(lines: &[Line<K>]) -> ProjectivePoint<K> {
    let pairs = (lines.iter().enumerate()).flat_map(|(i, a)| {
        let others = lines.iter().skip(i + 1);
        others.map(move |b| a.meet(b))
    });
    let mut undecided = None;
    for meet in pairs {
        if meet.is_determined().is_yes() {
            return meet;
        }
        if undecided.is_none() && !meet.is_determined().is_no() {
            undecided = Some(meet);
        }
    }
    undecided
        .unwrap_or_else(|| ProjectivePoint::new(Number::zero(), Number::zero(), Number::zero()))
}

/// The circle of the centers whose circlepoint is at infinity: it goes through the three poles. A
/// line of the moving plane then passes through the center in all three positions.
///
/// The three places of the center in the moving plane, the images of one point in the inverse
/// displacements, must lie on a line: twice their area is a circle in the coordinates of the center.
pub fn centers_of_lines<K: Kind>([a, b, c]: &[Displacement<K>; 3]) -> Circle<K> {
    let [a, b, c] = [a, b, c].map(Displacement::inverse);
    circle_of_collinear_places(&[a, b, c])
}

/// The circle of the circlepoints whose places lie on a line: it goes through the three image poles.
pub fn points_on_lines<K: Kind>(positions: &[Displacement<K>; 3]) -> Circle<K> {
    circle_of_collinear_places(positions)
}

/// Im (uz + s)‾(vz + t) = 0 with u, v the differences of the turns and s, t those of the shifts.
fn circle_of_collinear_places<K: Kind>([a, b, c]: &[Displacement<K>; 3]) -> Circle<K> {
    let (u, v) = (&b.rotation - &a.rotation, &c.rotation - &a.rotation);
    let (s, t) = (
        &b.translation - &a.translation,
        &c.translation - &a.translation,
    );
    // Im (ū v)|z|² + Im (ū t z̄) + Im (s̄ v z) + Im (s̄ t).
    let (left, right) = (u.conj() * &t, s.conj() * &v);
    Circle {
        a: (u.conj() * v).im().clone(),
        b: left.im() + right.im(),
        c: right.re() - left.re(),
        d: (s.conj() * t).im().clone(),
    }
}
