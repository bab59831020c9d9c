//! The three four-bars that draw one coupler curve (Roberts).

use crate::number::Kind;
use crate::plane::Point;

/// A four-bar A₀ABB₀ in one position with a point of its coupler.
#[derive(Clone, Debug)]
pub struct CouplerPoint<K> {
    /// A₀ and B₀.
    pub pivots: [Point<K>; 2],
    /// A and B.
    pub pins: [Point<K>; 2],
    /// The point of the coupler.
    pub point: Point<K>,
}

impl<K: Kind> CouplerPoint<K> {
    /// The two other four-bars with the same point, in the same position: with
    /// λ = (D − A)/(B − A) the third pivot is C₀ = A₀ + λ(B₀ − A₀), and
    ///
    /// - on A₀ and C₀: the pins A₀ + D − A, and that plus λ(A − A₀),
    /// - on B₀ and C₀: the pins B₀ + D − B, and that plus (1 − λ)(B − B₀).
    ///
    /// No value where A and B coincide.
    pub fn cognates(&self) -> [CouplerPoint<K>; 2] {
        let [a0, b0] = &self.pivots;
        let [a, b] = &self.pins;
        let d = &self.point;
        let ratio = (d - a) / (b - a);
        let third = a0 + &ratio * (b0 - a0);
        let cognate = |pivot: &Point<K>, pin: &Point<K>, ratio: &Point<K>| {
            let first = pivot + (d - pin);
            let second = &first + ratio * (pin - pivot);
            CouplerPoint {
                pivots: [pivot.clone(), third.clone()],
                pins: [first, second],
                point: d.clone(),
            }
        };
        [cognate(a0, a, &ratio), cognate(b0, b, &(1 - &ratio))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Complex, Fraction, Number, Ring};

    /// With free symbols: pivots and coupler triangle, and the directions of the three bars in
    /// another position, which closes by the choice of B₀.
    #[test]
    fn in_every_position_the_three_points_are_one() {
        let ring = Ring::free(&["a", "b", "c", "d", "e", "f", "s", "t", "u"]).unwrap();
        let [a, b, c, d, e, f, s, t, u] = ring.numbers();
        let turn = |t: &Number<Fraction>| -> Number<Complex<Fraction>> {
            let i_t = Number::i() * Point::from(t.clone());
            (1 + &i_t) / (1 - i_t)
        };
        let at = |x: Number<Fraction>, y: Number<Fraction>| Number::complex(x, y);
        let (pivot, crank, coupler) = (at(a, b), at(c, d.clone()), at(e.clone(), f));
        let shape = at(e, d);
        let here =
            |crank: &Point<Fraction>, coupler: &Point<Fraction>, rocker: &Point<Fraction>| {
                let pin = &pivot + crank;
                let other = &pin + coupler;
                CouplerPoint {
                    point: &pin + &shape * coupler,
                    pivots: [pivot.clone(), &other - rocker],
                    pins: [pin, other],
                }
            };
        let rocker = at(Number::from(3), Number::from(-2));
        let first = here(&crank, &coupler, &rocker);
        let turned = [s, t, u].map(|t| turn(&t));
        let second = here(
            &(&crank * &turned[0]),
            &(&coupler * &turned[1]),
            &(&rocker * &turned[2]),
        );
        for (here, there) in first.cognates().iter().zip(second.cognates()) {
            for side in 0..2 {
                let bar = |of: &CouplerPoint<Fraction>| (&of.pins[side] - &of.pivots[side]).norm();
                assert!(bar(here).equals(&bar(&there)).is_yes());
            }
            let triangle = |of: &CouplerPoint<Fraction>| {
                let [p, q] = &of.pins;
                [
                    (q - p).norm(),
                    (&of.point - p).norm(),
                    (&of.point - q).norm(),
                ]
            };
            for (x, y) in triangle(here).iter().zip(&triangle(&there)) {
                assert!(x.equals(y).is_yes());
            }
        }
    }

    /// The third pivot does not move: it depends on the fixed points and the coupler's shape alone.
    #[test]
    fn the_cognates_of_a_cognate_are_the_others() {
        use crate::number::Exact;
        let at = |x: i64, y: i64| -> Point<Exact> { Number::complex(x.into(), y.into()) };
        let first = CouplerPoint {
            pivots: [at(0, 0), at(7, 1)],
            pins: [at(1, 3), at(6, 5)],
            point: at(2, 8),
        };
        let [left, right] = first.cognates();
        let [of_left, third] = left.cognates();
        for (found, expected) in [(of_left, &first), (third, &right)] {
            let mut points = [found.pivots, found.pins].concat();
            let expected = [expected.pivots.clone(), expected.pins.clone()].concat();
            for point in &expected {
                let place = points.iter().position(|other| other.equals(point).is_yes());
                points.remove(place.unwrap());
            }
            assert!(points.is_empty());
        }
    }
}
