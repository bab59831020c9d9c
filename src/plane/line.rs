//! Lines through two points.

use super::{Point, relation};
use crate::number::Kind;

/// Where the line through A and B meets the line through C and D; no value for parallel lines.
pub fn meet<K: Kind>(a: &Point<K>, b: &Point<K>, c: &Point<K>, d: &Point<K>) -> Point<K> {
    // The distances of A and B from CD, up to a common factor.
    let (from_a, from_b) = (relation::twice_area(c, d, a), relation::twice_area(c, d, b));
    let share = &from_a / (&from_a - from_b);
    a + (b - a).scaled(&share)
}

/// The mirror image of a point in the line through A and B; no value for A = B.
pub fn mirror<K: Kind>(point: &Point<K>, a: &Point<K>, b: &Point<K>) -> Point<K> {
    let direction = b - a;
    ((point - a) / &direction).conj() * direction + a
}
