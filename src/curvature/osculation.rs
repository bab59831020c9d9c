//! Circles that have several infinitesimally near points in common with the paths.

use super::contact::Guide;
use super::motion::{Motion, Path, coefficient};
use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::circle::Circle;
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::{Polynomial, determinant};
use crate::plane::projective::ProjectivePoint;

/// The center of the circle through three infinitesimally near points of a path, at infinity where
/// the path has an inflection; [0 : 0 : 0] where it has a cusp.
///
/// With p = p₀ + p₁t + p₂t² + … and Z = p₀ + iλp₁ the distance |p − Z|² has no term in t, and none in
/// t² for 2λ Im(p̄₁p₂) = |p₁|².
pub fn center_of_curvature<K: Kind>(path: &Path<K>) -> ProjectivePoint<K> {
    let [p, first, second] = [0, 1, 2].map(|j| coefficient(path, j));
    let twice = 2 * bend(&first, &second);
    let across = (Number::i() * &first).scaled(&first.norm());
    ProjectivePoint::new(
        p.re() * &twice + across.re(),
        p.im() * &twice + across.im(),
        twice,
    )
}

/// The circle of curvature of a point's path, or its tangent where it has an inflection. `None` where
/// it cannot be told which, and for the pole.
pub fn osculating<K: Kind>(motion: &Motion<K>, point: &Point<K>) -> Option<Guide<K>> {
    let path = motion.path_of(point);
    let center = center_of_curvature(&path);
    let point = point.clone();
    if let Some(center) = center.finite() {
        return Some(Guide::Circle { point, center });
    }
    let normal = Number::i() * coefficient(&path, 1);
    center
        .is_at_infinity()
        .is_yes()
        .then_some(Guide::Line { point, normal })
}

/// Im(p̄₁p₂).
fn bend<K: Kind>(first: &Point<K>, second: &Point<K>) -> Number<K> {
    (first.conj() * second).im().clone()
}

/// The points whose paths have an inflection, Im(p̄₁p₂) = 0. With p₁ = a₁ + u₁z and p₂ = a₂ + u₂z it is
/// a circle, for a motion that starts with a translation a line.
pub fn inflection_circle<K: Kind>(motion: &Motion<K>) -> Circle<K> {
    let [u1, u2] = [1, 2].map(|j| coefficient(&motion.rotation, j));
    let [a1, a2] = [1, 2].map(|j| coefficient(&motion.translation, j));
    // Im(ā₁u₂z) + Im(ū₁a₂z̄) = Im((ā₁u₂ − u₁ā₂)z).
    let mixed = a1.conj() * &u2 - &u1 * a2.conj();
    Circle {
        a: bend(&u1, &u2),
        b: mixed.im().clone(),
        c: mixed.re().clone(),
        d: bend(&a1, &a2),
    }
}

/// The points with four infinitesimally separated positions on a circle or a line: for those, the
/// terms in t, t², t³ of A|p|² + B Re p + C Im p vanish with some A, B, C. The three are linear in the
/// coordinates of the point, so that their determinant is a cubic: the cubic of stationary curvature.
pub fn stationary_cubic<K: Kind>(motion: &Motion<K>) -> Option<Cubic<K>> {
    determinant(&[1, 2, 3].map(|j| row(motion, j))).to_cubic()
}

/// The centers of those circles: the same cubic of the inverse motion.
pub fn cubic_of_centers<K: Kind>(motion: &Motion<K>) -> Option<Cubic<K>> {
    stationary_cubic(&motion.inverse())
}

/// What tʲ is multiplied with in Re p, Im p and |p|² for p = a + uz, where |u| = 1.
fn row<K: Kind>(motion: &Motion<K>, j: usize) -> [Polynomial<K>; 3] {
    let Displacement {
        rotation,
        translation,
    } = motion;
    let u = coefficient(rotation, j);
    let a = coefficient(translation, j);
    let mixed = coefficient(&(rotation * translation.conj()), j);
    [
        Polynomial::linear(u.re().clone(), -u.im(), a.re().clone()),
        Polynomial::linear(u.im().clone(), u.re().clone(), a.im().clone()),
        Polynomial::linear(
            2 * mixed.re(),
            -2 * mixed.im(),
            translation.norm().coefficient(j),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::motion::turning;
    use crate::number::linear::determinant;
    use crate::number::{Exact, Series};

    fn at(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    fn some_motion() -> Motion<Exact> {
        turning(&[at(3, -1), at(2, 5), at(-4, 7), at(1, 6)], 4)
    }

    /// The determinant of the terms in t, t², t³ of Re p, Im p and |p|², by the path itself.
    fn stationarity(motion: &Motion<Exact>, point: &Point<Exact>) -> Number<Exact> {
        let path = motion.path_of(point);
        let terms =
            |of: &Number<Series<Exact>>| (1..=3).map(|j| of.coefficient(j)).collect::<Vec<_>>();
        determinant(&[terms(path.re()), terms(path.im()), terms(&path.norm())])
    }

    #[test]
    fn the_polynomials_are_those_of_the_paths() {
        let motion = some_motion();
        let (circle, cubic) = (
            inflection_circle(&motion),
            stationary_cubic(&motion).unwrap(),
        );
        for point in [at(0, 0), at(1, 0), at(0, 1), at(-3, 4), at(5, 2), at(7, -1)] {
            let path = motion.path_of(&point);
            let bend = bend(&coefficient(&path, 1), &coefficient(&path, 2));
            assert!(circle.at(&point).equals(&bend).is_yes());
            assert!(
                cubic
                    .at(&point)
                    .equals(&stationarity(&motion, &point))
                    .is_yes()
            );
        }
    }

    #[test]
    fn circles_of_curvature_and_tangents_have_contact_of_order_two() {
        let motion = some_motion();
        let circle = inflection_circle(&motion);
        // The pole P is on the circle; a line through it meets the circle once more.
        let pole = Number::i() * coefficient(&motion.translation, 1);
        let toward = at(1, 3);
        let slope = circle.at(&(&pole + &toward)) - &circle.a * toward.norm();
        let inflection = &pole - toward.scaled(&(slope / (&circle.a * toward.norm())));
        for (point, straight) in [(at(2, 9), false), (inflection, true)] {
            let guide = osculating(&motion, &point).unwrap();
            assert_eq!(matches!(guide, Guide::Line { .. }), straight);
            let order = guide.contact(&motion);
            assert_eq!((order.least, order.most), (2, Some(2)));
        }
        assert!(osculating(&motion, &pole).is_none());
    }
}
