//! The curves from the circle conditions: a circlepoint is equally far from its center in all four
//! positions.

use crate::number::Kind;
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::{Polynomial, determinant};

/// The circlepoint curve, in the moving plane.
///
/// With Xⱼ = rⱼz + tⱼ the condition |Xⱼ − M|² = |X₁ − M|² is 2 Re (Xⱼ − X₁)‾M = |Xⱼ|² − |X₁|². Three
/// such lines meet in a center M, finite or not, where the determinant of
///
/// ```text
/// Re(Xⱼ − X₁),   Im(Xⱼ − X₁),   |Xⱼ|² − |X₁|²
/// ```
///
/// vanishes, each of which is linear in the coordinates of z.
pub fn circlepoint_cubic<K: Kind>(positions: &[Displacement<K>; 4]) -> Option<Cubic<K>> {
    let [first, rest @ ..] = positions;
    determinant(&rest.each_ref().map(|position| row(first, position))).to_cubic()
}

/// The centerpoint curve: the circlepoint curve of the inverse motion.
pub fn centerpoint_cubic<K: Kind>(positions: &[Displacement<K>; 4]) -> Option<Cubic<K>> {
    circlepoint_cubic(&positions.each_ref().map(Displacement::inverse))
}

fn row<K: Kind>(first: &Displacement<K>, other: &Displacement<K>) -> [Polynomial<K>; 3] {
    let turn = &other.rotation - &first.rotation;
    let shift = &other.translation - &first.translation;
    // |rz + t|² = |z|² + 2 Re (r t̄ z) + |t|².
    let product = |d: &Displacement<K>| &d.rotation * d.translation.conj();
    let mixed = product(other) - product(first);
    [
        Polynomial::linear(turn.re().clone(), -turn.im(), shift.re().clone()),
        Polynomial::linear(turn.im().clone(), turn.re().clone(), shift.im().clone()),
        Polynomial::linear(
            2 * mixed.re(),
            -2 * mixed.im(),
            other.translation.norm() - first.translation.norm(),
        ),
    ]
}
