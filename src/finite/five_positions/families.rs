//! What there is where the pairs are infinitely many, or none.
//!
//! A point whose places are on one circle in every four of the five positions is on one circle in
//! all. So the circlepoints of a family are the common part of the five circlepoint curves, and their
//! centers that of the five centerpoint curves.

use std::cmp::Ordering;

use crate::finite::four_positions::circle_conditions;
use crate::number::{Exact, Number, Truth};
use crate::plane::circle::Circle;
use crate::plane::circular_cubic::Cubic;
use crate::plane::common_part::common_part;
use crate::plane::conic::Conic;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::Polynomial;
use crate::plane::projective::ProjectivePoint;
use crate::plane::{Point, relation};

type Five = [Displacement<Exact>; 5];
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

/// The family of positions that do not have four isolated pairs; `None` where it is none of those that
/// are known here.
pub fn family(positions: &Five) -> Option<Family> {
    if are_translations(positions).is_yes() {
        return of_translations(positions);
    }
    let curve = common_circlepoints(positions)?;
    if curve.is_zero() {
        return Some(Family::Plane);
    }
    if is_imaginary(&curve) {
        return None;
    }
    if curve.order() > 0 {
        let center = common_center(positions, &curve);
        return Some(Family::Circlepoints(curve, center));
    }
    let centers = common_circlepoints(&positions.each_ref().map(Displacement::inverse))?;
    if centers.is_zero() {
        return None;
    }
    if centers.order() == 0 {
        // What there is of solutions has neither circlepoints nor centers that vary.
        return Some(Family::Empty);
    }
    Some(match resting_point(positions) {
        Some(point) => Family::PointWithAnyCenter(point, centers),
        None => Family::Centers(centers),
    })
}

/// The common part of the five circlepoint curves, without the line at infinity.
fn common_circlepoints(positions: &Five) -> Option<Curve> {
    let mut common = Curve::zero(3);
    for left_out in 0..positions.len() {
        let kept = positions.iter().enumerate();
        let kept = kept.filter(|(place, _)| *place != left_out);
        let four: Vec<Displacement<Exact>> = kept.map(|(_, one)| one.clone()).collect();
        let cubic: Cubic<Exact> = circle_conditions::circlepoint_cubic(four.first_chunk()?)?;
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
fn common_center(positions: &Five, curve: &Curve) -> Option<ProjectivePoint<Exact>> {
    let [a, b, c] = curve.coefficients() else {
        return None;
    };
    let normal = Number::complex(a.clone(), b.clone());
    let foot = normal.scaled(&(-c / normal.norm()));
    let along = Number::i() * &normal;
    // A point of the line may be a pole and have fewer than three places.
    let points = (0..6i64).map(|step| &foot + along.scaled(&step.into()));
    let mut centers = points.filter_map(|point| center(positions, &point));
    let first = centers.next()?;
    let second = centers.next()?;
    first.equals(&second).is_yes().then_some(first)
}

/// The center of a circlepoint with three different places.
fn center(positions: &Five, point: &Point<Exact>) -> Option<ProjectivePoint<Exact>> {
    let places = positions.each_ref().map(|position| position.of(point));
    let mut different: Vec<Point<Exact>> = Vec::new();
    for place in places {
        if different.iter().all(|other| other.equals(&place).is_no()) {
            different.push(place);
        }
    }
    let [p, q, r, ..] = different.as_slice() else {
        return None;
    };
    let circle = Circle::through(p, q, r);
    if circle.is_line().is_yes() {
        return Some(ProjectivePoint::from_direction(&(Number::i() * (q - p))));
    }
    Some(ProjectivePoint::from_finite(&circle.center()))
}

fn are_translations(positions: &Five) -> Truth {
    let [first, rest @ ..] = positions;
    Truth::all(
        rest.iter()
            .map(|position| position.rotation.equals(&first.rotation)),
    )
}

fn of_translations(positions: &Five) -> Option<Family> {
    let places = positions
        .each_ref()
        .map(|position| position.translation.clone());
    let [first, rest @ ..] = &places;
    let shifts = rest.iter().map(|place| place - first);
    let Some(along) = shifts.into_iter().find(|shift| shift.is_zero().is_no()) else {
        return Some(Family::Plane);
    };
    if relation::collinear(&places).is_yes() {
        return Some(Family::PlaneOfLines(Number::i() * along));
    }
    Some(if relation::concyclic(&places).is_yes() {
        Family::Plane
    } else {
        Family::Empty
    })
}

/// A point of the moving plane that has only two places in all five positions.
fn resting_point(positions: &Five) -> Option<Point<Exact>> {
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
