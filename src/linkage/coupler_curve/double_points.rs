//! The three double points of a coupler curve that do not come from a change point.
//!
//! Where Uq = Vp and Im p̄q = 0 the sextic vanishes with its derivatives. The second condition is the
//! circle through the foci; with q = κp, κ real, it is z = (n̄o_b − κm̄o_a)/(n̄ − κm̄), on which the
//! first one is V = κU: with d² = |o_b − o_a|² and N = |n − κm|² the cubic
//!
//! (κ(|m|² − R²) − (|n|² − T²)) N + κd²(|n|² − κ|m|²) = 0.
//!
//! Where D is on AB the circle is the line O_aO_b. For D in A or in B there is no such thing: D moves on
//! a circle.

use std::cmp::Ordering;

use super::CouplerCurve;
use crate::number::univariate::Polynomial;
use crate::number::{Exact, Kind, Number, Real, Truth};
use crate::plane::{Point, relation};

/// What a real double point looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Crossing {
    /// D passes it twice.
    Crossing,
    /// D stops in it and turns back.
    Cusp,
    /// All bars are on one line there.
    ChangePoint,
    /// The linkage does not reach it.
    Isolated,
}

impl<K: Kind> CouplerCurve<K> {
    /// Whether D is apart from A and from B.
    pub fn has_double_points(&self) -> Truth {
        let apart = |arm: &Point<K>| !arm.is_zero();
        let [m, n] = &self.arms;
        apart(m) & apart(n)
    }

    /// The cubic for κ. Its degree falls by one for each double point in O_a, κ = ∞.
    pub fn cubic_of_double_points(&self) -> Polynomial<K> {
        let Terms {
            m,
            n,
            base,
            first,
            second,
        } = self.terms();
        let both = self.mixed();
        Polynomial::new(vec![
            -(&second * &n),
            &first * &n + 2 * &second * &both + &base * &n,
            -(2 * &first * both + second * &m + base * &m),
            first * m,
        ])
    }

    /// The double point of a κ, in coordinates that are complex where κ is.
    pub fn double_point(&self, kappa: &Number<K>) -> Point<K> {
        let [a, b] = &self.pivots;
        let [m, n] = &self.arms;
        let numerator = n.conj() * b - (m.conj() * a).scaled(kappa);
        let divisor = n - m.scaled(kappa);
        (numerator * &divisor).scaled(&divisor.norm().inverse())
    }

    /// 4 N² (|p|² − U²) as a polynomial in κ: its sign tells how the double point looks.
    pub fn discriminant(&self) -> Polynomial<K> {
        let Terms {
            m, n, base, first, ..
        } = self.terms();
        let norm = Polynomial::new(vec![n.clone(), -2 * self.mixed(), m.clone()]);
        let distance = &n * &base;
        let reach = Polynomial::constant(distance.clone()) + norm.scaled(&first);
        norm.scaled(&(4 * m * distance)) - &reach * &reach
    }

    /// The same, up to a positive factor, for a double point in O_a: |q|² − V².
    pub fn discriminant_in_first_pivot(&self) -> Number<K> {
        let Terms {
            n, base, second, ..
        } = self.terms();
        4 * n * &base - (base + second).square()
    }

    /// Re(m̄n).
    fn mixed(&self) -> Number<K> {
        let [m, n] = &self.arms;
        (m.conj() * n).re().clone()
    }

    fn terms(&self) -> Terms<K> {
        let [a, b] = &self.pivots;
        let [m, n] = self.arms.each_ref().map(Number::norm);
        let [r, t] = &self.cranks;
        Terms {
            base: relation::distance_squared(a, b),
            first: &m - r,
            second: &n - t,
            m,
            n,
        }
    }
}

/// What the cubic is made of.
struct Terms<K> {
    /// |m|²
    m: Number<K>,
    /// |n|²
    n: Number<K>,
    /// d²
    base: Number<K>,
    /// |m|² − R²
    first: Number<K>,
    /// |n|² − T²
    second: Number<K>,
}

impl CouplerCurve<Exact> {
    /// The greatest common divisor of the cubic and of the discriminant: it vanishes for cusps.
    pub fn cubic_of_cusps(&self) -> Option<Polynomial<Exact>> {
        self.cubic_of_double_points().gcd(&self.discriminant())
    }
}

impl<K: Real> CouplerCurve<K> {
    /// How a real double point looks by the sign of its [discriminant](Self::discriminant): whether
    /// Re(p e^{iθ}) = −U has two solutions, one, or none. With one solution A is on the line O_aD and B on
    /// the line O_bD: D is the pole, unless all are on one line, which they are if D is on AB. `None`
    /// where that cannot be told.
    pub fn crossing(&self, sign: Ordering) -> Option<Crossing> {
        match (sign, self.is_point_of_line()) {
            (Ordering::Greater, _) => Some(Crossing::Crossing),
            (Ordering::Less, _) => Some(Crossing::Isolated),
            (Ordering::Equal, Truth::Yes) => Some(Crossing::ChangePoint),
            (Ordering::Equal, Truth::No) => Some(Crossing::Cusp),
            (Ordering::Equal, Truth::Unknown) => None,
        }
    }

    /// Whether D is on the line AB.
    fn is_point_of_line(&self) -> Truth {
        let [m, n] = &self.arms;
        (m.conj() * n).im().is_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Fraction, Ring};
    use proptest::prelude::*;

    fn n(x: i64) -> Number<Exact> {
        x.into()
    }

    fn number() -> impl Strategy<Value = Number<Exact>> {
        (-20i64..=20, 1i64..=6).prop_map(|(p, q)| Number::ratio(p, q))
    }

    fn point() -> impl Strategy<Value = Point<Exact>> {
        (number(), number()).prop_map(|(x, y)| Number::complex(x, y))
    }

    /// The curve that has a double point at κ, by the choice of T²: the cubic is linear in it.
    fn with_double_point<K: Kind>(
        pivots: [Point<K>; 2],
        arms: [Point<K>; 2],
        first: Number<K>,
        kappa: &Number<K>,
    ) -> CouplerCurve<K> {
        let mut curve = CouplerCurve {
            pivots,
            arms,
            cranks: [first, Number::zero()],
        };
        let norm = (&curve.arms[1] - curve.arms[0].scaled(kappa)).norm();
        let rest = curve.cubic_of_double_points().evaluate(kappa);
        curve.cranks[1] = -rest / norm;
        curve
    }

    /// No bar is missing: without a crank the curve would be a circle, twice.
    fn is_whole(curve: &CouplerCurve<Exact>) -> bool {
        let [a, b] = &curve.pivots;
        let base = relation::distance_squared(a, b);
        let bars = curve.cranks.iter().chain([&base]);
        bars.map(|square| !square.is_zero()).all(Truth::is_yes)
            && curve.has_double_points().is_yes()
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, cases: 32, ..ProptestConfig::default() })]

        /// Random exact curves: with free symbols the derivatives have too many terms.
        #[test]
        fn sextic_and_derivatives_vanish_there(
            a in point(), b in point(), m in point(), n in point(), r in number(), kappa in number(),
        ) {
            let curve = with_double_point([a, b], [m, n], r, &kappa);
            let at = curve.double_point(&kappa);
            prop_assume!(at.has_value() && is_whole(&curve));
            prop_assert!(curve.cubic_of_double_points().evaluate(&kappa).is_zero().is_yes());
            prop_assert!(curve.circle().contains(&at).is_yes());
            let sextic = curve.sextic();
            let [x, y] = sextic.gradient();
            for of in [&sextic, &x, &y] {
                prop_assert!(of.at(at.re(), at.im()).is_zero().is_yes());
            }
            // Beside it one of them does not vanish.
            let other = &kappa + 1;
            let beside = curve.double_point(&other);
            prop_assume!(curve.cubic_of_double_points().evaluate(&other).is_zero().is_no());
            prop_assume!(beside.has_value());
            let regular = [&sextic, &x, &y].map(|of| of.at(beside.re(), beside.im()).is_zero());
            prop_assert!(!Truth::all(regular).is_yes());
        }

        /// The second derivatives tell the same as the sign: real tangents where D passes twice.
        #[test]
        fn real_tangents_belong_to_crossings(
            a in point(), b in point(), m in point(), n in point(), r in number(), kappa in number(),
        ) {
            let curve = with_double_point([a, b], [m, n], r, &kappa);
            let at = curve.double_point(&kappa);
            prop_assume!(at.has_value() && is_whole(&curve));
            let [x, y] = curve.sextic().gradient();
            let [[xx, xy], [_, yy]] = [x, y]
                .map(|of| of.gradient().map(|of| of.at(at.re(), at.im())));
            let tangents = (xy.square() - xx * yy).sign();
            prop_assert_eq!(curve.discriminant().evaluate(&kappa).sign(), tangents);
        }
    }

    #[test]
    fn double_points_are_on_the_circle_for_free_symbols() {
        let ring = Ring::free(&["a", "b", "c", "d", "k"]).unwrap();
        let [a, b, c, d, kappa]: [Number<Fraction>; 5] = ring.numbers();
        let curve = CouplerCurve {
            pivots: [Point::zero(), Point::one()],
            arms: [Number::complex(a, b), Number::complex(c, d)],
            cranks: [Number::zero(), Number::zero()],
        };
        assert!(
            curve
                .circle()
                .contains(&curve.double_point(&kappa))
                .is_yes()
        );
    }

    #[test]
    fn a_double_point_in_a_pivot_lowers_the_degree() {
        // AD = R: D comes into O_a.
        let at = |x: i64, y: i64| -> Point<Exact> { Number::complex(n(x), n(y)) };
        let curve = CouplerCurve {
            pivots: [at(0, 0), at(9, 1)],
            arms: [at(3, 4), at(1, 2)],
            cranks: [n(25), n(36)],
        };
        assert_eq!(curve.cubic_of_double_points().degree(), Some(2));
        let sextic = curve.sextic();
        let [x, y] = sextic.gradient();
        for of in [&sextic, &x, &y] {
            assert!(of.at(&n(0), &n(0)).is_zero().is_yes());
        }
        let [[xx, xy], [_, yy]] = [x, y].map(|of| of.gradient().map(|of| of.at(&n(0), &n(0))));
        let sign = curve.discriminant_in_first_pivot().sign();
        assert_eq!(sign, (xy.square() - xx * yy).sign());
    }

    /// Where it would cross and does not: a cusp, or a change point of a linkage in one line.
    #[test]
    fn a_point_of_the_line_of_the_pins_has_no_cusp() {
        let at = |x: i64, y: i64| Point::<Exact>::complex(n(x), n(y));
        let curve = |arms: [Point<Exact>; 2]| CouplerCurve {
            pivots: [at(0, 0), at(4, 0)],
            arms,
            cranks: [n(1), n(4)],
        };
        for (arms, expected) in [
            ([at(1, 2), at(2, 4)], Crossing::ChangePoint),
            ([at(1, 2), at(-3, -6)], Crossing::ChangePoint),
            ([at(1, 2), at(2, -4)], Crossing::Cusp),
            ([at(3, 0), at(0, 1)], Crossing::Cusp),
        ] {
            assert_eq!(curve(arms).crossing(Ordering::Equal), Some(expected));
        }
    }
}
