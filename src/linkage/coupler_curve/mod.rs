//! The curve of a point D of the coupler of a four-bar O_aABO_b: the coupler sextic.
//!
//! With the arms m = DA and n = DB in some position of the coupler, D in z, and the coupler turned
//! by θ against that position, A is in z + m e^{iθ} and B in z + n e^{iθ}. The cranks say
//!
//! Re(p e^{iθ}) = −U, p = m (z̄ − ō_a), 2U = |z − o_a|² + |m|² − R²,
//! Re(q e^{iθ}) = −V, q = n (z̄ − ō_b), 2V = |z − o_b|² + |n|² − T²:
//!
//! two linear equations for cos θ and sin θ. With cos² + sin² = 1 they leave
//! |Uq − Vp|² = (Im p̄q)².

mod double_points;

pub use double_points::Crossing;

use super::cognates::CouplerPoint;
use crate::number::{Kind, Number, array};
use crate::plane::circle::Circle;
use crate::plane::polynomial::Polynomial;
use crate::plane::{Point, relation};

/// What a coupler curve depends on.
#[derive(Clone, Debug)]
pub struct CouplerCurve<K> {
    /// O_a and O_b.
    pub pivots: [Point<K>; 2],
    /// DA and DB, in any one position of the coupler.
    pub arms: [Point<K>; 2],
    /// R² = O_aA² and T² = O_bB².
    pub cranks: [Number<K>; 2],
}

/// The bars of a four-bar with its coupler triangle, in no position.
#[derive(Clone, Debug)]
pub struct Bars<K> {
    /// O_a and O_b.
    pub pivots: [Point<K>; 2],
    /// Q = O_aO_b, R = O_aA, S = AB, T = O_bB, M = AD, N = BD, squared.
    pub squares: [(&'static str, Number<K>); 6],
    /// A number with the angle ε from AB to AD as argument; zero for D in A.
    pub epsilon: Point<K>,
}

impl<K: Kind> From<&CouplerPoint<K>> for CouplerCurve<K> {
    fn from(linkage: &CouplerPoint<K>) -> Self {
        CouplerCurve {
            pivots: linkage.pivots.clone(),
            arms: linkage.pins.each_ref().map(|pin| pin - &linkage.point),
            cranks: array::pairs(&linkage.pins, &linkage.pivots)
                .map(|(pin, pivot)| relation::distance_squared(pin, pivot)),
        }
    }
}

impl<K: Kind> CouplerCurve<K> {
    /// 4 |Uq − Vp|² − 4 (Im p̄q)², of order 6; the curve is where it vanishes.
    pub fn sextic(&self) -> Polynomial<K> {
        let [u, v] = [0, 1].map(|side| self.reach(side));
        let [[p, p_i], [q, q_i]] = [0, 1].map(|side| self.lever(side));
        let across = |p: &Polynomial<K>, q: &Polynomial<K>| u.times(q).minus(&v.times(p));
        let square = |of: &Polynomial<K>| of.times(of);
        let turned = p.times(&q_i).minus(&p_i.times(&q));
        let sum = square(&across(&p, &q)).plus(&square(&across(&p_i, &q_i)));
        sum.minus(&square(&turned).scaled(&Number::from(4)))
    }

    /// 2U or 2V.
    #[expect(clippy::indexing_slicing, reason = "the side is 0 or 1")]
    fn reach(&self, side: usize) -> Polynomial<K> {
        let (pivot, arm) = (&self.pivots[side], &self.arms[side]);
        let [x, y] = [pivot.re(), pivot.im()];
        let constant = pivot.norm() + arm.norm() - &self.cranks[side];
        Polynomial::circle(Number::one(), -2 * x, -2 * y, constant)
    }

    /// Real and imaginary part of p or q.
    #[expect(clippy::indexing_slicing, reason = "the side is 0 or 1")]
    fn lever(&self, side: usize) -> [Polynomial<K>; 2] {
        let arm = &self.arms[side];
        let at_origin = arm * self.pivots[side].conj();
        let [x, y] = [arm.re(), arm.im()].map(Number::clone);
        [
            Polynomial::linear(x.clone(), y.clone(), -at_origin.re()),
            Polynomial::linear(y, -x, -at_origin.im()),
        ]
    }

    /// λ = AD : AB, as a complex number. No value where A and B coincide.
    pub fn shape(&self) -> Point<K> {
        let [m, n] = &self.arms;
        -m / (n - m)
    }

    /// The three singular foci O_a, O_b, O_c: the pivots of the four-bar and of its cognates,
    /// O_c = O_a + λ(O_b − O_a). The coefficient of z̄³ in the sextic is, up to a factor,
    /// (z − o_a)(z − o_b)(z − o_c).
    pub fn foci(&self) -> [Point<K>; 3] {
        let [a, b] = &self.pivots;
        let c = a + self.shape() * (b - a);
        [a.clone(), b.clone(), c]
    }

    /// The circle through the foci, Im p̄q = 0: from its points the base is seen under the angle of
    /// the coupler at D. A line where D is on AB.
    pub fn circle(&self) -> Circle<K> {
        // Im(w (z̄ − ō_b)(z − o_a)) with w = m̄n = w_r + i w_i.
        let [a, b] = &self.pivots;
        let [m, n] = &self.arms;
        let w = m.conj() * n;
        let [x, y] = [w.re(), w.im()];
        let constant = (&w * a * b.conj()).im().clone();
        let sum = a + b;
        let difference = a - b;
        Circle {
            a: y.clone(),
            b: -(x * difference.im()) - y * sum.re(),
            c: x * difference.re() - y * sum.im(),
            d: constant,
        }
    }

    /// The bars.
    pub fn bars(&self) -> Bars<K> {
        let [a, b] = &self.pivots;
        let [m, n] = &self.arms;
        let [r, t] = self.cranks.clone();
        let coupler = n - m;
        Bars {
            squares: named([
                relation::distance_squared(a, b),
                r,
                coupler.norm(),
                t,
                m.norm(),
                n.norm(),
            ]),
            pivots: self.pivots.clone(),
            epsilon: -m * coupler.conj(),
        }
    }

    /// The bars of both cognates, on O_a and O_c and on O_b and O_c: those of
    /// [`CouplerPoint::cognates`] without any position.
    pub fn cognate_bars(&self) -> [Bars<K>; 2] {
        let [a, b, c] = self.foci();
        let [m, n] = &self.arms;
        let [r, t] = &self.cranks;
        let lambda = self.shape();
        let base = relation::distance_squared(&a, &b);
        // A parallelogram on the crank and one arm, and a triangle similar to the coupler on the
        // other side of that crank.
        let cognate = |pivot: Point<K>, lambda: &Point<K>, arm: &Point<K>, kept, other| {
            let scale = lambda.norm();
            let rest: Point<K> = 1 - lambda;
            Bars {
                pivots: [pivot, c.clone()],
                squares: named([
                    &scale * &base,
                    arm.norm(),
                    &scale * kept,
                    &scale * other,
                    Number::clone(kept),
                    rest.norm() * kept,
                ]),
                epsilon: lambda.conj(),
            }
        };
        [
            cognate(a, &lambda, m, r, t),
            cognate(b, &(1 - &lambda), n, t, r),
        ]
    }

    /// The same in another kind.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> CouplerCurve<L> {
        let point = |z: &Point<K>| Number::complex(convert(z.re()), convert(z.im()));
        CouplerCurve {
            pivots: self.pivots.each_ref().map(point),
            arms: self.arms.each_ref().map(point),
            cranks: self.cranks.each_ref().map(&convert),
        }
    }
}

fn named<K>([q, r, s, t, m, n]: [Number<K>; 6]) -> [(&'static str, Number<K>); 6] {
    [("Q", q), ("R", r), ("S", s), ("T", t), ("M", m), ("N", n)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Complex, Exact, Fraction, Ring, Truth};

    /// With the base from 0 to 1, which a similarity makes it, and free A, AB and λ.
    fn free() -> CouplerPoint<Fraction> {
        let ring = Ring::free(&["a", "b", "c", "d", "e", "f"]).unwrap();
        let [a, b, c, d, e, f] = ring.numbers();
        let pin = Number::complex(a, b);
        let coupler = Number::complex(c, d);
        CouplerPoint {
            pivots: [Point::zero(), Point::one()],
            point: &pin + Number::complex(e, f) * &coupler,
            pins: [pin.clone(), pin + coupler],
        }
    }

    /// In z and z̄, for x and y.
    fn isotropic<K: Kind>(sextic: &Polynomial<K>) -> Polynomial<Complex<K>> {
        type P<K> = Polynomial<Complex<K>>;
        let [half, quarter_turn] = [Number::ratio(1, 2), Number::i() / 2];
        let x: P<K> = Polynomial::linear(half.clone(), half, Number::zero());
        let y: P<K> = Polynomial::linear(-&quarter_turn, quarter_turn, Number::zero());
        let one = || P::<K>::monomials(0).remove(0);
        let power = |of: &P<K>, n: usize| (0..n).fold(one(), |product, _| product.times(of));
        let mut sum = P::<K>::zero(6);
        for (j, k, coefficient) in sextic.terms() {
            let term = power(&x, j).times(&power(&y, k));
            sum = sum.plus(&term.scaled(&coefficient.clone().into()));
        }
        sum
    }

    #[test]
    fn it_vanishes_in_the_point_for_free_symbols() {
        let linkage = free();
        let sextic = CouplerCurve::from(&linkage).sextic();
        assert!(!sextic.is_zero());
        assert!(
            sextic
                .at(linkage.point.re(), linkage.point.im())
                .is_zero()
                .is_yes()
        );
    }

    /// So it vanishes in all of the positions.
    #[test]
    fn it_is_one_in_all_positions_of_the_coupler() {
        let ring = Ring::free(&["a", "b", "c", "d", "r", "t"]).unwrap();
        let ring = ring.with_angle("cos", "sin").unwrap();
        let [a, b, c, d, r, t, cos, sin] = ring.numbers();
        let curve = CouplerCurve {
            pivots: [Point::zero(), Point::one()],
            arms: [Number::complex(a, b), Number::complex(c, d)],
            cranks: [r, t],
        };
        let turn = Number::complex(cos, sin);
        let mut turned = curve.clone();
        turned.arms = curve.arms.each_ref().map(|arm| arm * &turn);
        assert!(curve.sextic().minus(&turned.sextic()).is_zero());
    }

    #[test]
    fn the_cognates_have_the_same_up_to_a_factor() {
        let linkage = free();
        let sextic = CouplerCurve::from(&linkage).sextic();
        for cognate in linkage.cognates() {
            let other = CouplerCurve::from(&cognate).sextic();
            let [here, there] = [&sextic, &other].map(|of| of.coefficients()[0].clone());
            assert!(here.is_zero().is_no());
            let difference = sextic.scaled(&there).minus(&other.scaled(&here));
            assert!(difference.is_zero());
        }
    }

    /// Both circular points are threefold: no power of z or z̄ above the third. And the tangents
    /// there, the coefficient of z̄³, meet the plane in the foci.
    #[test]
    fn it_is_tricircular_with_the_pivots_as_foci() {
        let curve = CouplerCurve::from(&free());
        let sextic = isotropic(&curve.sextic());
        let [a, b, c] = curve.foci();
        let leading = |j: usize, k: usize| {
            let found = sextic
                .terms()
                .find(|(of_z, of_conj, _)| (*of_z, *of_conj) == (j, k));
            found.unwrap().2.clone()
        };
        for (j, k, coefficient) in sextic.terms() {
            assert!(
                (j <= 3 && k <= 3) || coefficient.is_zero().is_yes(),
                "{j}, {k}"
            );
        }
        let top = leading(3, 3);
        assert!(top.is_zero().is_no());
        let sums = [
            -(&a + &b + &c),
            &a * &b + &b * &c + &c * &a,
            -(&a * &b * &c),
        ];
        for (power, sum) in [2, 1, 0].into_iter().zip(sums) {
            assert!(leading(power, 3).equals(&(&top * sum)).is_yes(), "{power}");
        }
    }

    #[test]
    fn the_circle_goes_through_the_foci() {
        let curve = CouplerCurve::from(&free());
        let circle = curve.circle();
        let on = curve.foci().map(|focus| circle.contains(&focus));
        assert!(Truth::all(on).is_yes());
        assert!(circle.is_determined().is_yes());
    }

    #[test]
    fn bars_of_the_cognates_need_no_position() {
        let linkage = free();
        let curve = CouplerCurve::from(&linkage);
        for (found, cognate) in curve.cognate_bars().iter().zip(linkage.cognates()) {
            let bars = CouplerCurve::from(&cognate).bars();
            for ((name, one), (_, other)) in found.squares.iter().zip(&bars.squares) {
                assert!(one.equals(other).is_yes(), "{name}");
            }
            for (one, other) in found.pivots.iter().zip(&bars.pivots) {
                assert!(one.equals(other).is_yes());
            }
            let turn = &found.epsilon * bars.epsilon.conj();
            assert!(turn.im().is_zero().is_yes());
        }
    }

    /// The angle itself, and not that beyond 180°.
    #[test]
    fn angles_of_the_cognates_have_the_right_direction() {
        let at = |x: i64, y: i64| -> Point<Exact> { Number::complex(x.into(), y.into()) };
        for point in [at(2, 8), at(-4, -1), at(9, 4), at(4, 4)] {
            let linkage = CouplerPoint {
                pivots: [at(0, 0), at(7, 1)],
                pins: [at(1, 3), at(6, 5)],
                point,
            };
            let curve = CouplerCurve::from(&linkage);
            for (found, cognate) in curve.cognate_bars().iter().zip(linkage.cognates()) {
                let bars = CouplerCurve::from(&cognate).bars();
                let turn = &found.epsilon * bars.epsilon.conj();
                assert!(turn.re().is_positive().is_yes());
            }
        }
    }
}
