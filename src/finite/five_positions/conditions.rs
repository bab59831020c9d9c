//! The conditions of a Burmester pair.
//!
//! |rⱼz + tⱼ − M|² has one value for all positions. With w = z M̄ this is linear in z, M and w:
//!
//! ```text
//! ½|tⱼ|² + Re(t̄ⱼrⱼz) − Re(t̄ⱼM) − Re(rⱼw) = const.
//! ```
//!
//! A pair at infinity belongs to it as well: with the factor 1 of the first term replaced by h, the
//! solutions with h = 0 have z = 0 or M = 0, and are the pairs whose other point is at infinity.

use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Coordinates of a pair, up to a common factor: h, x, y, X, Y, p, q with w = p + iq, so that
/// hp = xX + yY and hq = yX − xY.
pub type Coordinates<K> = [Number<K>; 7];

/// One row of coefficients for each position after the first.
pub fn rows<K: Kind>(positions: &[Displacement<K>]) -> Vec<Vec<Number<K>>> {
    let Some((first, rest)) = positions.split_first() else {
        return Vec::new();
    };
    let base = row(first);
    rest.iter()
        .map(|position| {
            let row = row(position);
            row.iter().zip(&base).map(|(a, b)| a - b).collect()
        })
        .collect()
}

fn row<K: Kind>(position: &Displacement<K>) -> Coordinates<K> {
    let (r, t) = (&position.rotation, &position.translation);
    let mixed = t.conj() * r;
    [
        t.norm() / 2,
        mixed.re().clone(),
        -mixed.im(),
        -t.re(),
        -t.im(),
        -r.re(),
        r.im().clone(),
    ]
}

/// hp − xX − yY and hq − yX + xY as bilinear forms, twice: zero for a pair with itself.
pub fn products<K: Kind>(left: &Coordinates<K>, right: &Coordinates<K>) -> [Number<K>; 2] {
    let [h, x, y, cx, cy, p, q] = left;
    let [h1, x1, y1, cx1, cy1, p1, q1] = right;
    [
        mixed([(h, p1), (h1, p)]) - mixed([(x, cx1), (x1, cx), (y, cy1), (y1, cy)]),
        mixed([(h, q1), (h1, q), (x, cy1), (x1, cy)]) - mixed([(y, cx1), (y1, cx)]),
    ]
}

/// A sum of products, most of which vanish in coordinates that were solved for: they are not computed.
fn mixed<K: Kind, const N: usize>(factors: [(&Number<K>, &Number<K>); N]) -> Number<K> {
    let vanishes = |x: &Number<K>| x.is_zero().is_yes();
    let factors = factors.into_iter();
    let terms = factors.filter(|(a, b)| !vanishes(a) && !vanishes(b));
    terms.map(|(a, b)| a * b).sum()
}

/// The coordinates of a circlepoint in the moving plane and its center in the fixed one.
pub fn of_pair<K: Kind>(circlepoint: &Point<K>, center: &Point<K>) -> Coordinates<K> {
    let [_, _, _, cx, cy, p, q] = of_slide(circlepoint, center);
    let (x, y) = (circlepoint.re().clone(), circlepoint.im().clone());
    [Number::one(), x, y, cx, cy, p, q]
}

/// The coordinates of a circlepoint whose center is at infinity in a direction.
pub fn of_slide<K: Kind>(circlepoint: &Point<K>, towards: &Point<K>) -> Coordinates<K> {
    let product = circlepoint * towards.conj();
    let none = Number::zero;
    let [cx, cy, p, q] = [towards.re(), towards.im(), product.re(), product.im()].map(Clone::clone);
    [none(), none(), none(), cx, cy, p, q]
}

/// A circlepoint in the moving plane and its center in the fixed one, of coordinates with h ≠ 0.
pub fn finite_pair<K: Kind>(coordinates: &Coordinates<K>) -> [Point<K>; 2] {
    let [h, x, y, cx, cy, ..] = coordinates;
    let inverse = h.inverse();
    let [x, y, cx, cy] = [x, y, cx, cy].map(|part| part * &inverse);
    [Number::complex(x, y), Number::complex(cx, cy)]
}
