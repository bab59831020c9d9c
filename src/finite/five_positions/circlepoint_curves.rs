//! The Burmester pairs as the meets of two circlepoint curves.
//!
//! Those of the positions 1, 2, 3, 4 and 1, 2, 3, 5 meet in nine points: the two circular points, the
//! three poles of 1, 2, 3 in the moving plane, and four circlepoints of all five positions.

use crate::finite::four_positions::circle_conditions::circlepoint_cubic;
use crate::number::univariate::Polynomial;
use crate::number::{Exact, Number};
use crate::plane::circular_cubic::Cubic;
use crate::plane::displacement::Displacement;
use crate::plane::projective::ProjectivePoint;

type Poly = Polynomial<Exact>;

/// The polynomial of the values ax + by of the finite circlepoints, whether their centers are finite
/// or not. `None` where the curves have a part in common, and where the line ax + by = 0 points
/// towards the point at infinity of one of them.
pub fn circlepoints(positions: &[Displacement<Exact>; 5], direction: [i64; 2]) -> Option<Poly> {
    let [p, q, r, s, t] = positions;
    let with = |last: &Displacement<Exact>| {
        circlepoint_cubic(&[p.clone(), q.clone(), r.clone(), last.clone()])
    };
    let curves = [with(s)?, with(t)?];
    let mut rest = resultant(&curves, direction)?;
    for (first, second) in [(p, q), (p, r), (q, r)] {
        let [x, y, w] = pole_in_moving_plane(first, second).coordinates().clone();
        if !ProjectivePoint::new(x.clone(), y.clone(), w.clone())
            .is_determined()
            .is_yes()
        {
            return None;
        }
        // w u − (a x + b y): of order 0 for a pole at infinity.
        let value = x * direction[0] + y * direction[1];
        let (quotient, remainder) = rest.divide(&Polynomial::new(vec![-value, w]))?;
        if !remainder.is_zero() {
            return None;
        }
        rest = quotient;
    }
    rest.primitive_part()
}

/// The point of the moving plane with the same place in two positions.
fn pole_in_moving_plane(
    first: &Displacement<Exact>,
    second: &Displacement<Exact>,
) -> ProjectivePoint<Exact> {
    // rz + t = sz + u for z = (u − t)/(r − s).
    let turn = &first.rotation - &second.rotation;
    let shift = &second.translation - &first.translation;
    let point = shift * turn.conj();
    if turn.is_zero().is_yes() {
        // Towards where it goes: perpendicular to the shift, seen from the moving plane.
        let shift = &second.translation - &first.translation;
        return ProjectivePoint::from_direction(&(Number::i() * shift / &first.rotation));
    }
    ProjectivePoint::new(point.re().clone(), point.im().clone(), turn.norm())
}

/// The resultant of both along the lines ax + by = u, a polynomial in u of order 7 at most.
fn resultant(curves: &[Cubic<Exact>; 2], [a, b]: [i64; 2]) -> Option<Poly> {
    // Nine meets at most, two of them at infinity.
    let values: Option<Vec<(Number<Exact>, Number<Exact>)>> = (0..8i64)
        .map(|u| {
            let [first, second] = curves.each_ref().map(|curve| on_line(curve, [a, b], u));
            let third_order = |p: &Poly| p.degree() == Some(3);
            let proper = third_order(&first) && third_order(&second);
            proper.then(|| (Number::from(u), first.resultant(&second)))
        })
        .collect();
    let found = Polynomial::interpolated(&values?);
    (!found.is_zero()).then_some(found)
}

/// On the points u (a, b)/(a² + b²) + v (−b, a) of a line.
fn on_line(curve: &Cubic<Exact>, [a, b]: [i64; 2], u: i64) -> Poly {
    let size = Number::from(a * a + b * b);
    let coordinate = |offset: i64, slope: i64| {
        Polynomial::new(vec![Number::from(u * offset) / &size, slope.into()])
    };
    let (x, y) = (coordinate(a, -b), coordinate(b, a));
    let one = Polynomial::constant(Number::one());
    let powers = |p: &Poly| [one.clone(), p.clone(), p.power(2), p.power(3)];
    let (xs, ys) = (powers(&x), powers(&y));
    let exponents = (0..=3usize)
        .rev()
        .flat_map(|n| (0..=n).map(move |k| (n - k, k)));
    let mut sum = Polynomial::zero();
    for (c, (j, k)) in curve.coefficients().iter().zip(exponents) {
        if let (Some(x), Some(y)) = (xs.get(j), ys.get(k)) {
            sum = sum + (x * y).scaled(c);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Point;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = Point<Exact>> {
        (-9_i64..9, -9_i64..9).prop_map(|(x, y)| Point::complex(x.into(), y.into()))
    }

    proptest! {
        /// The image of the pole in both positions is the same, at infinity the direction across the way.
        #[test]
        fn poles_in_the_moving_plane_do_not_move(
            turns in (point(), point()), shifts in (point(), point()), is_parallel: bool,
        ) {
            let rotation = |z: &Point<Exact>| z.square().scaled(&z.norm().inverse());
            let second_turn = if is_parallel { &turns.0 } else { &turns.1 };
            let first = Displacement { rotation: rotation(&turns.0), translation: shifts.0 };
            let second = Displacement { rotation: rotation(second_turn), translation: shifts.1 };
            prop_assume!(first.rotation.has_value() && second.rotation.has_value());
            let [x, y, w] = pole_in_moving_plane(&first, &second).coordinates().clone();
            let pole = Number::complex(x, y);
            if w.is_zero().is_yes() {
                let way = &second.translation - &first.translation;
                let across = &first.rotation * pole * way.conj();
                prop_assert!(across.re().is_zero().is_yes());
            } else {
                let pole = pole.scaled(&w.inverse());
                prop_assert!((first.of(&pole) - second.of(&pole)).is_zero().is_yes());
            }
        }
    }
}
