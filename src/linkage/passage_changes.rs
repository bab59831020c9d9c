//! Where the verdicts on a four-bar in given positions can change while the linkage changes.
//!
//! Each verdict of [`Passage`] rests on signs. They can change only where one of these functions of the
//! joints vanishes; where one does, none need change.

use super::passage::Passage;
use crate::number::{Kind, Number};
use crate::plane::relation;

/// The squares of the lengths A₀A, AB, BB₀, A₀B₀.
fn squared_lengths<K: Kind>(passage: &Passage<K>) -> Option<[Number<K>; 4]> {
    let [p, q] = &passage.pivots;
    let [a, b] = passage.joints.first()?;
    Some([[p, a], [a, b], [b, q], [p, q]].map(|[x, y]| relation::distance_squared(x, y)))
}

/// For the type, and for which link turns fully: two lengths are equal, or two are together as long as
/// the others, or three as long as the fourth.
pub fn of_type<K: Kind>(passage: &Passage<K>) -> Vec<Number<K>> {
    let Some([a, b, c, d]) = squared_lengths(passage) else {
        return Vec::new();
    };
    // ∏ (√a ± √b ± √c ± √d) over all signs, with ((√a ± √b)² − (√c ± √d)²) = e ± 2√ab ± 2√cd.
    let e = &a + &b - &c - &d;
    let product = &a * &b;
    let sums = (e.square() + 4 * &product - 4 * &c * &d).square() - 16 * e.square() * product;
    vec![sums, &a - &b, &a - &c, &a - &d, &b - &c, &b - &d, c - d]
}

/// For circuits, dead centres, and the order in which a link that rocks passes the positions: in one of
/// them three joints lie on a line.
pub fn of_sides<K: Kind>(passage: &Passage<K>) -> Vec<Number<K>> {
    let [p, q] = &passage.pivots;
    let joints = passage.joints.iter();
    joints
        .flat_map(|[a, b]| [[a, b, q], [a, b, p], [p, q, a], [p, q, b]])
        .map(|[x, y, z]| relation::twice_area(x, y, z))
        .collect()
}
