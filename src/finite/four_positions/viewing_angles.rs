//! The curves from the poles: opposite sides of an opposite-pole quadrilateral are seen under equal
//! angles.

use crate::finite::positions::Positions;
use crate::number::{Kind, Number};
use crate::plane::circular_cubic::Cubic;
use crate::plane::polynomial::Polynomial;
use crate::plane::projective::ProjectivePoint;

/// The centerpoint curve, in the fixed plane.
///
/// From the center the two places of a circlepoint are symmetric about the line to their pole, so that
/// the angle from P₁₃ to P₁₄ is half of the crank's turn from position 3 to position 4, modulo π; and
/// so is that from P₂₃ to P₂₄. With the tangents of both as quotients of a linear and a quadratic
/// polynomial,
///
/// ```text
/// [P₁₃, P₁₄] (P₂₃ · P₂₄) = [P₂₃, P₂₄] (P₁₃ · P₁₄),
/// ```
///
/// where [A, B] is the product of the lengths of MA and MB and the sine of the angle between them, and
/// (A · B) the same with the cosine. A pole at infinity has a direction and needs no distance. Where
/// two positions are equal all terms cancel.
pub fn centerpoint_cubic<K: Kind>(positions: &Positions<K>) -> Option<Cubic<K>> {
    let mut poles = positions.pairs().filter_map(|(i, j)| positions.pole(i, j));
    if poles.any(|pole| pole.is_determined().is_no()) {
        return Some(Cubic::new(std::array::from_fn(|_| Number::zero())));
    }
    let sides = [(0, 2), (0, 3), (1, 2), (1, 3)].map(|(i, j)| positions.pole(i, j));
    let [Some(a), Some(b), Some(c), Some(d)] = sides else {
        return None;
    };
    // With w = 1 or 0 what is known exactly of poles at infinity is not lost among factors that are
    // enclosures.
    let [a, b, c, d] = [a, b, c, d].map(ProjectivePoint::normalized);
    let (first, second) = (seen(&a, &b), seen(&c, &d));
    first
        .sine
        .times(&second.cosine)
        .minus(&second.sine.times(&first.cosine))
        .to_cubic()
}

/// The circlepoint curve, in the moving plane: the image poles take the place of the poles.
pub fn circlepoint_cubic<K: Kind>(positions: &Positions<K>) -> Option<Cubic<K>> {
    centerpoint_cubic(&positions.inverse())
}

/// The angle under which a segment is seen, by multiples of its sine and cosine.
struct Seen<K> {
    sine: Polynomial<K>,
    cosine: Polynomial<K>,
}

/// From M to A = [x : y : w] it is (x, y) − wM, to a common factor.
fn seen<K: Kind>(from: &ProjectivePoint<K>, to: &ProjectivePoint<K>) -> Seen<K> {
    let ([x, y, w], [x1, y1, w1]) = (from.coordinates(), to.coordinates());
    Seen {
        // The terms of order 2, w w₁ (xy − yx), cancel.
        sine: Polynomial::linear(y * w1 - y1 * w, x1 * w - x * w1, x * y1 - y * x1),
        cosine: Polynomial::circle(
            w * w1,
            -(x * w1 + x1 * w),
            -(y * w1 + y1 * w),
            x * x1 + y * y1,
        ),
    }
}
