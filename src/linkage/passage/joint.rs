//! Joints, finite or at infinity.

use crate::number::{Kind, Number, Real};
use crate::plane::{Point, relation};

/// Where two links are joined.
#[derive(Clone, Debug)]
pub enum Joint<K> {
    /// They turn against each other about this point.
    At(Point<K>),
    /// They slide along each other, at right angles to this direction: about a point at infinity.
    Towards(Point<K>),
}

impl<K> Joint<K> {
    /// The point of a finite joint.
    pub fn point(&self) -> Option<&Point<K>> {
        match self {
            Joint::At(point) => Some(point),
            Joint::Towards(_) => None,
        }
    }
}

/// The determinant of two vectors: positive where the second is to the left of the first.
pub(super) fn cross<K: Kind>(u: &Point<K>, v: &Point<K>) -> Number<K> {
    (u.conj() * v).im().clone()
}

/// The scalar product of two vectors.
pub(super) fn dot<K: Kind>(u: &Point<K>, v: &Point<K>) -> Number<K> {
    (u.conj() * v).re().clone()
}

/// The unit vector of a direction; no value where the kind does not hold the root.
pub(super) fn unit<K: Real>(direction: &Point<K>) -> Point<K> {
    direction.scaled(&direction.norm().sqrt().inverse())
}

/// Twice the area of a triangle, or, up to a positive factor, what becomes of it where corners are at
/// infinity: it vanishes where the three are on a line.
pub(super) fn twice_area<K: Kind>(a: &Joint<K>, b: &Joint<K>, c: &Joint<K>) -> Number<K> {
    use Joint::{At, Towards};
    match (a, b, c) {
        (At(a), At(b), At(c)) => relation::twice_area(a, b, c),
        (At(a), At(b), Towards(c)) => cross(&(b - a), c),
        (At(a), Towards(b), At(c)) => cross(b, &(c - a)),
        (Towards(a), At(b), At(c)) => cross(a, &(b - c)),
        (Towards(a), Towards(b), At(_)) => cross(a, b),
        (Towards(a), At(_), Towards(c)) => cross(c, a),
        (At(_), Towards(b), Towards(c)) => cross(b, c),
        (Towards(_), Towards(_), Towards(_)) => Number::zero(),
    }
}
