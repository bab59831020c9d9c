//! Quadrilaterals by their vertices in order, crossed ones included.

use std::cmp::Ordering;

use super::isotropic::Polynomial;
use super::{Point, relation};
use crate::number::{Kind, Number, Real, Truth};

/// How often the closed polygon goes round a point, counterclockwise; `None` where the point lies on
/// a side, or where this cannot be told.
pub fn winding_number<K: Real>(vertices: &[Point<K>], point: &Point<K>) -> Option<i64> {
    let next = vertices.iter().cycle().skip(1);
    let mut number = 0;
    for (from, to) in vertices.iter().zip(next) {
        number += turn_of_side(&(from - point), &(to - point))?;
    }
    Some(number)
}

/// What a side adds to the winding number about the origin: it counts where it crosses the ray to
/// the right.
fn turn_of_side<K: Real>(from: &Point<K>, to: &Point<K>) -> Option<i64> {
    let rises = (from.im().sign()?.is_le(), to.im().sign()?.is_le());
    match (
        rises,
        relation::twice_area(&Number::zero(), from, to).sign()?,
    ) {
        ((true, false), Ordering::Greater) => Some(1),
        ((false, true), Ordering::Less) => Some(-1),
        ((true, false) | (false, true), Ordering::Equal) => None,
        ((true, true), Ordering::Equal) => {
            // Through the origin, if it has an end on either side of it.
            let ends_apart = (from.conj() * to).re().sign()?.is_le();
            if ends_apart { None } else { Some(0) }
        }
        _ => Some(0),
    }
}

/// Whether a quadrilateral is convex, no three vertices on a line: it turns to the same side at all
/// four vertices.
pub fn is_convex<K: Real>(vertices: &[Point<K>; 4]) -> Truth {
    let turn = |i: usize| {
        let corner = [i, i + 1, i + 2].map(|j| &vertices[j % 4]);
        relation::twice_area(corner[0], corner[1], corner[2])
    };
    let left = Truth::all((0..4).map(|i| turn(i).is_positive()));
    let right = Truth::all((0..4).map(|i| (-turn(i)).is_positive()));
    left | right
}

/// The curve of the points from which the sides MA and BN of the quadrilateral M, A, B, N are seen
/// under directed angles AFM and NFB with a sum of 0 modulo π: (F − M)(F − B) : (F − A)(F − N) is
/// real.
pub fn focal_curve<K: Kind>([m, a, b, n]: &[Point<K>; 4]) -> Polynomial<K> {
    let diagonal = Polynomial::z_minus(m).times(&Polynomial::z_minus(b));
    let other = Polynomial::z_minus(a).times(&Polynomial::z_minus(n));
    let product = diagonal.times(&other.conj());
    product.minus(&product.conj())
}
