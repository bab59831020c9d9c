//! What there is where the pairs are infinitely many, or none.
//!
//! Each condition is linear in the center, A X + B Y + C = 0 with A, B and C linear in the circlepoint. A
//! point for which every three of the four have a center in common has one for all. So the circlepoints
//! of a family are the common part of four cubics, det(A, B, C) = 0, and their centers that of those with
//! the names exchanged. For positions that are apart these are circlepoint curves; but nothing depends on
//! where the conditions come from, so that some of the positions may have come together.

use std::cmp::Ordering;

use super::conditions::Coordinates;
use crate::number::linear::{kernel, rank};
use crate::number::{Exact, Number, Truth, array};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::common_part::common_part;
use crate::plane::conic::Conic;
use crate::plane::polynomial::{Polynomial, determinant};
use crate::plane::projective::ProjectivePoint;

/// What h, x, y, X, Y, p, q are multiplied with.
type Row = Coordinates<Exact>;
type Curve = Polynomial<Exact>;

/// What the pairs of a family are.
#[derive(Clone, Debug)]
pub enum Family {
    /// There is no real pair with a finite point.
    Empty,
    /// All points of the moving plane.
    Plane,
    /// All points of the moving plane, each along a line; the centers are at infinity in this
    /// direction.
    PlaneOfLines(Point<Exact>),
    /// The circlepoints of a curve; with their center, finite or not, where all have the same.
    Circlepoints(Curve, Option<ProjectivePoint<Exact>>),
    /// One point of the moving plane that has its place in common in so many positions that a line
    /// of centers is left.
    PointWithAnyCenter(Point<Exact>, Curve),
    /// The centers of a curve, each in another direction of the moving plane: the lines there that
    /// pass through one fixed point each.
    Centers(Curve),
}

/// The family of conditions that do not have four isolated pairs; `None` where it is none of those that
/// are known here.
pub fn family(conditions: &[Vec<Number<Exact>>]) -> Option<Family> {
    let rows = conditions.iter().map(|row| row.clone().try_into().ok());
    let rows: Vec<Row> = rows.collect::<Option<_>>()?;
    let rows: [Row; 4] = rows.try_into().ok()?;
    if are_translations(&rows).is_yes() {
        return of_translations(&rows);
    }
    let curve = common_circlepoints(&rows)?;
    if curve.is_zero() {
        return Some(Family::Plane);
    }
    if is_imaginary(&curve) {
        return None;
    }
    if curve.order() > 0 {
        let center = common_center(&rows, &curve);
        return Some(Family::Circlepoints(curve, center));
    }
    let centers = common_circlepoints(&rows.each_ref().map(exchanged))?;
    if centers.is_zero() {
        return None;
    }
    if centers.order() == 0 {
        // What there is of solutions has neither circlepoints nor centers that vary.
        return Some(Family::Empty);
    }
    Some(match resting_point(&rows) {
        Some(point) => Family::PointWithAnyCenter(point, centers),
        None => Family::Centers(centers),
    })
}

/// The condition with circlepoint and center in each other's place.
fn exchanged([h, x, y, cx, cy, p, q]: &Row) -> Row {
    let [h, x, y, cx, cy, p, q] = [h, x, y, cx, cy, p, &-q].map(Clone::clone);
    [h, cx, cy, x, y, p, q]
}

/// A, B and C.
fn by_center([h, x, y, cx, cy, p, q]: &Row) -> [Curve; 3] {
    let linear = |a: &Number<Exact>, b: &Number<Exact>, c: &Number<Exact>| {
        Polynomial::linear(a.clone(), b.clone(), c.clone())
    };
    [linear(p, q, cx), linear(&-q, p, cy), linear(x, y, h)]
}

/// The common part of the curves of every three conditions, without the line at infinity.
fn common_circlepoints(rows: &[Row; 4]) -> Option<Curve> {
    let [a, b, c, d] = &rows.each_ref().map(by_center);
    let mut common = Curve::zero(3);
    for triple in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
        let cubic: Cubic<Exact> = determinant(&triple.map(Clone::clone)).to_cubic()?;
        common = common_part(&common, &Curve::from(&cubic))?;
    }
    Some(common.finite_part())
}

/// Whether a conic has at most one real point.
fn is_imaginary(curve: &Curve) -> bool {
    let conic: Option<[Number<Exact>; 6]> = curve.coefficients().to_vec().try_into().ok();
    conic.is_some_and(|coefficients| {
        let conic = Conic::new(coefficients);
        conic.discriminant().sign() == Some(Ordering::Less) && !conic.is_ellipse().is_yes()
    })
}

/// The center that all points of a line have in common.
fn common_center(rows: &[Row; 4], curve: &Curve) -> Option<ProjectivePoint<Exact>> {
    let [a, b, c] = curve.coefficients() else {
        return None;
    };
    let normal = Number::complex(a.clone(), b.clone());
    let foot = normal.scaled(&(-c / normal.norm()));
    let along = Number::i() * &normal;
    // Of some points of the line any center may do.
    let points = (0..6i64).map(|step| &foot + along.scaled(&step.into()));
    let mut centers = points.filter_map(|point| center(rows, &point));
    let first = centers.next()?;
    let second = centers.next()?;
    first.equals(&second).is_yes().then_some(first)
}

/// The center of a circlepoint that has one only.
fn center(rows: &[Row; 4], point: &Point<Exact>) -> Option<ProjectivePoint<Exact>> {
    let centers = kernel(&at(rows, point), 3)?;
    let [center] = centers.as_slice() else {
        return None;
    };
    let [x, y, w] = <[Number<Exact>; 3]>::try_from(center.clone()).ok()?;
    Some(ProjectivePoint::new(x, y, w))
}

/// A, B and C of all conditions in a point.
fn at(rows: &[Row; 4], point: &Point<Exact>) -> Vec<Vec<Number<Exact>>> {
    let value = |[h, x, y, cx, cy, p, q]: &Row| {
        let (a, b) = (point.re(), point.im());
        vec![p * a + q * b + cx, p * b - q * a + cy, x * a + y * b + h]
    };
    rows.iter().map(value).collect()
}

/// Whether no product of circlepoint and center stands in any condition.
fn are_translations(rows: &[Row; 4]) -> Truth {
    let zero = |[.., p, q]: &Row| p.is_zero() & q.is_zero();
    Truth::all(rows.iter().map(zero))
}

fn of_translations(rows: &[Row; 4]) -> Option<Family> {
    let part = |from: fn(&Row) -> Vec<Number<Exact>>| rows.iter().map(from).collect::<Vec<_>>();
    let shifts = part(|[_, _, _, cx, cy, ..]| vec![cx.clone(), cy.clone()]);
    let circles = part(|[h, _, _, cx, cy, ..]| vec![h.clone(), cx.clone(), cy.clone()]);
    let along = shifts.iter().find_map(|shift| match shift.as_slice() {
        [x, y] if (x.is_zero() & y.is_zero()).is_no() => {
            Some(Number::complex(x.clone(), y.clone()))
        }
        _ => None,
    });
    let Some(along) = along else {
        return Some(Family::Plane);
    };
    Some(match (rank(&shifts, 2)?, rank(&circles, 3)?) {
        // On no circle, but along a line.
        (1, 2) => Family::PlaneOfLines(Number::i() * along),
        (2, 3) => Family::Empty,
        _ => Family::Plane,
    })
}

/// A point of the moving plane for which the conditions are one: a line of centers is left to it. Two of
/// its places coincide, or it has no velocity, so that one condition, or the difference of two, says
/// nothing of it.
fn resting_point(rows: &[Row; 4]) -> Option<Point<Exact>> {
    let differences = rows.iter().enumerate().flat_map(|(place, row)| {
        let others = rows.iter().skip(place + 1);
        others.map(move |other| array::pairs(row, other).map(|(one, other)| one - other))
    });
    let mut candidates = rows.iter().cloned().chain(differences);
    candidates.find_map(|row: Row| {
        let point = without_center(&row)?;
        (rank(&at(rows, &point), 3)? < 2).then_some(point)
    })
}

/// Where A = B = 0: (p − iq) z = −(X + iY).
fn without_center([_, _, _, cx, cy, p, q]: &Row) -> Option<Point<Exact>> {
    let factor = Number::complex(p.clone(), -q);
    let point = -Number::complex(cx.clone(), cy.clone()) / factor;
    point.has_value().then_some(point)
}
