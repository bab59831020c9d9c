//! The curves in isotropic coordinates: the focal cubic of an opposite-pole quadrilateral.

use crate::finite::positions::Positions;
use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::isotropic::Polynomial;
use crate::plane::projective::ProjectivePoint;

/// The centerpoint curve, in the fixed plane.
///
/// Where opposite sides of the quadrilateral P₁₂ P₂₃ P₃₄ P₁₄ are seen under angles with a sum of 0
/// modulo π,
///
/// ```text
/// (z − P₁₂)(z − P₃₄) (z̄ − P̄₂₃)(z̄ − P̄₁₄)
/// ```
///
/// is real: opposite poles stand together. A pole at infinity in the direction p has the factor −p.
pub fn centerpoint_cubic<K: Kind>(positions: &Positions<K>) -> Option<Cubic<K>> {
    let pole = |i, j| Some(factor(&positions.pole(i, j)?));
    let opposite = pole(0, 1)?.times(&pole(2, 3)?);
    let other = pole(1, 2)?.times(&pole(0, 3)?);
    let product = opposite.times(&other.conj());
    let twice_i_im = product.minus(&product.conj());
    Cubic::from_isotropic(&twice_i_im.times(&Polynomial::constant(-Number::i())))
}

/// The circlepoint curve, in the moving plane: the image poles take the place of the poles.
pub fn circlepoint_cubic<K: Kind>(positions: &Positions<K>) -> Option<Cubic<K>> {
    centerpoint_cubic(&positions.inverse())
}

/// w z − p for the point p/w, finite or not.
fn factor<K: Kind>(point: &ProjectivePoint<K>) -> Polynomial<K> {
    let [x, y, w] = point.coordinates();
    Polynomial::linear(
        Point::from(w.clone()),
        -Number::complex(x.clone(), y.clone()),
    )
}
