//! The Burmester points of one position: those whose paths have contact of order four with a circle.
//!
//! # From the invariants
//!
//! Seen from the pole with the diameter of the inflection circle as unit, a point re^{iα} has its center
//! Re^{iα} on the same ray. That |p − Z|² has no term in θ², θ³, θ⁴ says, with ρ = 1/r, σ = 1/R,
//! c = cos α, s = sin α, L = a₃c + b₃s,
//!
//! - θ²: ρ − σ = 1/s,
//! - θ³: 3scσ = L,
//! - θ⁴: 3sσ² + 3σ − s − a₄c − b₄s + 4sσ(b₃c − a₃s) − 6s²σ = 0.
//!
//! With σ from the second the third is a form of order four in c and s. On the pole normal, c = 0, the
//! second leaves σ open where b₃ = 0; then the third gives two points there.
//!
//! # From the contact
//!
//! What a pair must fulfil is linear in seven coordinates of the pair, with a coefficient for each
//! position. Its coefficients in a motion are series, and five positions that fall together are their
//! terms in t, t², t³, t⁴: from there on nothing differs from five finitely separated positions.

use super::canonical::Invariants;
use super::mixed::Groups;
use super::motion::Motion;
use crate::finite::five_positions::conics::{Pairs, pairs_of};
use crate::number::univariate::{Polynomial, Quadratic};
use crate::number::{Exact, Kind, Number, Real, Truth};
use crate::plane::projective::ProjectivePoint;

/// A point of the moving plane and its center, both of which may be at infinity.
#[derive(Clone, Debug)]
pub struct Pair<K> {
    /// The point, in canonical coordinates.
    pub point: ProjectivePoint<K>,
    /// Its center.
    pub center: ProjectivePoint<K>,
}

impl<K: Kind> Invariants<K> {
    /// The coefficients of c⁴, c³s, c²s², cs³, s⁴ in the form that vanishes on the rays of the
    /// Burmester points. Four in all, counted with the order of the root; a root s = 0 is the pole.
    pub fn burmester_rays(&self) -> [Number<K>; 5] {
        let (a, b) = (self.third.re(), self.third.im());
        let (a4, b4) = (self.fourth.re(), self.fourth.im());
        [
            a * (a + 3),
            3 * (b * (2 * a + 1) - a4),
            5 * b.square() - 3 * (a * (a + 1) + b4 + 1),
            -b * (2 * a + 3),
            b.square(),
        ]
    }

    /// The point on the ray of direction (c, s) with four positions on a circle, and its center:
    /// r = 3sc/(L + 3c), R = 3sc/L. The ray is no axis.
    pub fn pair_on_ray(&self, c: &Number<K>, s: &Number<K>) -> Pair<K> {
        let l = self.third.re() * c + self.third.im() * s;
        let product = 3 * s * c;
        let norm = c.square() + s.square();
        let at = |w: Number<K>| ProjectivePoint::new(&product * c, &product * s, w * &norm);
        Pair {
            point: at(&l + 3 * c),
            center: at(l),
        }
    }

    /// The point that is at the same time on the inflection circle: Ball's point, tan α = −a₃/b₃. It is
    /// the pole for a₃ = 0 and the inflection pole for b₃ = 0; not determined where both vanish, and the
    /// whole inflection circle has contact of order three with its tangents.
    pub fn ball_point(&self) -> ProjectivePoint<K> {
        let (a, b) = (self.third.re(), self.third.im());
        // sin α e^{iα}, on the ray (b₃, −a₃).
        ProjectivePoint::new(-(a * b), a.square(), a.square() + b.square())
    }

    /// Whether Ball's point is a Burmester point, and so has contact of order four with its tangent:
    /// a₄b₃ = (b₄ + 1)a₃.
    pub fn has_ball_burmester_point(&self) -> Truth {
        let (third, fourth) = (&self.third, &self.fourth);
        let excess = fourth.re() * third.im() - (fourth.im() + 1) * third.re();
        excess.is_zero()
    }
}

impl<K: Real> Invariants<K> {
    /// How often Ball's point counts among the Burmester points with their centers at infinity: the order
    /// of its ray among the rays, on the pole normal that of σ = 0. Thrice for some motions, never more.
    /// `None` where it cannot be told, and where Ball's point is not determined.
    pub fn ball_burmester_multiplicity(&self) -> Option<usize> {
        let (a, b) = (self.third.re(), self.third.im());
        match self.has_ball_burmester_point() {
            Truth::Yes => {}
            Truth::No => return Some(0),
            Truth::Unknown => return None,
        }
        let form = match b.is_zero() {
            Truth::No => Polynomial::new(self.burmester_rays().to_vec()).shifted(&-(a / b)),
            Truth::Yes if a.is_zero().is_no() => {
                let Quadratic { a, b, c } = self.on_pole_normal();
                Polynomial::new(vec![c, b, a])
            }
            _ => return None,
        };
        for (order, coefficient) in form.coefficients().iter().enumerate() {
            match coefficient.is_zero() {
                Truth::Yes => {}
                Truth::No => return Some(order),
                Truth::Unknown => return None,
            }
        }
        None
    }

    /// The curvatures σ of the paths of the two Burmester points on the pole normal, where b₃ = 0: the
    /// roots of 3σ² − (4a₃ + 3)σ − (b₄ + 1) = 0. A center is 1/σ from the pole, its point 1/(σ + 1).
    pub fn on_pole_normal(&self) -> Quadratic<K> {
        let (a, b4) = (self.third.re(), self.fourth.im());
        Quadratic::new(Number::from(3), -(4 * a + 3), -(b4 + 1))
    }
}

/// The Burmester pairs from the contact of order four, with multiplicities, complex ones and those at
/// infinity, of a motion to terms in t⁴ or more, of which the first five positions count.
pub fn by_contact(motion: &Motion<Exact>) -> Option<Pairs> {
    pairs_of(Groups(vec![motion.clone()]).conditions().get(..4)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::contact::Guide;
    use crate::finite::five_positions::conics::Place;
    use crate::number::univariate::isolate;
    use crate::plane::Point;

    fn at(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    fn invariants(third: Point<Exact>, fourth: Point<Exact>) -> Invariants<Exact> {
        Invariants { third, fourth }
    }

    fn isolated(invariants: &Invariants<Exact>) -> crate::finite::five_positions::conics::Isolated {
        match by_contact(&invariants.motion()) {
            Some(Pairs::Isolated(pairs)) => *pairs,
            other => panic!("{other:?}"),
        }
    }

    /// The polynomial in t = tan α.
    fn tangents(invariants: &Invariants<Exact>) -> Polynomial<Exact> {
        Polynomial::new(invariants.burmester_rays().to_vec())
    }

    /// Both routes, by the numbers of real and complex points and by where the real ones are.
    #[test]
    fn the_two_routes_agree() {
        for (third, fourth) in [
            (at(2, 5), at(-3, 7)),
            (at(-1, 4), at(10, -20)),
            (at(1, 1), at(0, 0)),
            (at(-5, 2), at(-40, 3)),
            (at(3, -7), at(11, 60)),
        ] {
            let invariants = invariants(third, fourth);
            let roots = isolate(&tangents(&invariants)).unwrap();
            let pairs = isolated(&invariants);
            let real = pairs.real(300);
            assert_eq!(real.len(), roots.real().len());
            assert_eq!(pairs.complex(300).len(), roots.complex().len());
            for root in roots.real() {
                let t = root.enclosure(300);
                let meets = real.iter().filter(|pair| {
                    let [point, _] = pair.points();
                    (point.im() - point.re() * &t).is_zero().is_no()
                });
                assert_eq!(meets.count(), real.len() - 1);
            }
        }
    }

    /// a₄ and b₄, which the middle coefficients hold, are made to fit two rays.
    fn through([t, u]: [i64; 2], third: Point<Exact>) -> Invariants<Exact> {
        let without = invariants(third.clone(), Number::zero());
        let value = |t: i64| -tangents(&without).evaluate(&t.into()) / (3 * t);
        // −3a₄t − 3b₄t² = −value.
        let (v, w) = (value(t), value(u));
        let b4 = (&v - &w) / (u - t);
        let a4 = -(v + &b4 * t);
        Invariants {
            third,
            fourth: Number::complex(a4, b4),
        }
    }

    #[test]
    fn points_on_rational_rays_have_contact_of_order_four() {
        let invariants = through([2, -3], at(2, 5));
        let motion = invariants.motion();
        for (t, expected) in [(2, 4), (-3, 4), (5, 3)] {
            let pair = invariants.pair_on_ray(&Number::one(), &t.into());
            let guide = Guide::Circle {
                point: pair.point.finite().unwrap(),
                center: pair.center.finite().unwrap(),
            };
            assert_eq!(guide.contact(&motion).least, expected, "tan α = {t}");
        }
    }

    #[test]
    fn two_points_on_the_pole_normal() {
        // 3σ² − (4a₃ + 3)σ − (b₄ + 1) = 3(σ − 2)(σ − 3) for a₃ = 3, b₄ = −19.
        let invariants = invariants(at(3, 0), at(50, -19));
        let motion = invariants.motion();
        let quadratic = invariants.on_pole_normal();
        for sigma in [2, 3] {
            let root = &quadratic.a * sigma * sigma + &quadratic.b * sigma + &quadratic.c;
            assert!(root.is_zero().is_yes());
            let guide = Guide::Circle {
                point: Point::i() / (sigma + 1),
                center: Point::i() / sigma,
            };
            assert_eq!(guide.contact(&motion).least, 4);
        }
        assert_eq!(isolated(&invariants).real(200).len(), 4);
    }

    #[test]
    fn ball_s_point_has_contact_of_order_three_with_its_tangent() {
        let invariants = invariants(at(2, 5), at(-3, 7));
        let motion = invariants.motion();
        let order = ball_guide(&invariants).contact(&motion);
        assert_eq!((order.least, order.most), (3, Some(3)));
        assert!(invariants.has_ball_burmester_point().is_no());
    }

    /// For a₃ = b₃ = 0 the pole itself, whose path has a cusp, is one of the four; its center is on the
    /// pole tangent.
    #[test]
    fn the_pole_may_be_one_of_the_four() {
        let invariants = invariants(at(0, 0), at(6, 2));
        let motion = invariants.motion();
        let center = Point::<Exact>::ratio(3, 6);
        let guide = Guide::Circle {
            point: Number::zero(),
            center,
        };
        assert_eq!(guide.contact(&motion).least, 4);
        let poles = isolated(&invariants).real(200).into_iter().filter(|pair| {
            let [_, x, y, ..] = &pair.coordinates;
            pair.place == Place::Finite && (x.is_zero() & y.is_zero()).is_yes()
        });
        assert_eq!(poles.count(), 1);
    }

    fn ball_guide(invariants: &Invariants<Exact>) -> Guide<Exact> {
        let point = invariants.ball_point().finite().unwrap();
        Guide::Line {
            normal: point.clone(),
            point,
        }
    }

    /// (b₄ + 1)a₃/b₃ for the shift a₄.
    fn with_ball_burmester_point(third: Point<Exact>, b4: Number<Exact>) -> Invariants<Exact> {
        let a4 = (&b4 + 1) * third.re() / third.im();
        Invariants {
            third,
            fourth: Number::complex(a4, b4),
        }
    }

    #[test]
    fn ball_s_point_may_be_a_burmester_point() {
        let invariants = with_ball_burmester_point(at(2, 5), 7.into());
        assert!(invariants.has_ball_burmester_point().is_yes());
        assert_eq!(
            ball_guide(&invariants).contact(&invariants.motion()).least,
            4
        );
        let sliding = isolated(&invariants).real(200);
        let sliding = sliding
            .iter()
            .filter(|pair| pair.place == Place::CenterAtInfinity);
        assert_eq!(sliding.count(), 1);
    }

    /// The form's root in Ball's ray is double where its derivative there, linear in b₄, vanishes.
    #[test]
    fn ball_s_point_may_be_two_burmester_points() {
        let third = at(2, 5);
        let t = -(third.re() / third.im());
        let slope = |b4: i64| {
            let invariants = with_ball_burmester_point(third.clone(), b4.into());
            tangents(&invariants).derivative().evaluate(&t)
        };
        let (zero, one) = (slope(0), slope(1));
        let double = with_ball_burmester_point(third.clone(), &zero / (&zero - one));
        assert_eq!(ball_guide(&double).contact(&double.motion()).least, 4);
        let real = isolated(&double).real(200);
        let sliding: Vec<_> = (real.iter())
            .filter(|pair| pair.place == Place::CenterAtInfinity)
            .map(|pair| pair.multiplicity)
            .collect();
        assert_eq!(sliding, [2]);
    }

    /// By the rays, and by the pairs with centers at infinity that the contact finds.
    #[test]
    fn ball_s_point_counts_as_often_as_it_is_found() {
        for (third, fourth, expected) in [
            (at(2, 5), at(-3, 7), 0),
            (at(2, 5), Number::complex(Number::ratio(16, 5), 7.into()), 1),
            // The pole, with a cusp along the pole tangent.
            (at(0, 5), at(0, 7), 1),
            // The inflection pole.
            (at(3, 0), at(50, -1), 1),
            (
                Number::complex(Number::ratio(-3, 4), 0.into()),
                at(9, -1),
                2,
            ),
            (
                at(-1, 1),
                Number::complex(Number::ratio(-8, 3), Number::ratio(5, 3)),
                3,
            ),
        ] {
            let invariants = invariants(third, fourth);
            assert_eq!(invariants.ball_burmester_multiplicity(), Some(expected));
            let sliding = isolated(&invariants).real(200).into_iter();
            let sliding = sliding.filter(|pair| pair.place == Place::CenterAtInfinity);
            let found: usize = sliding.map(|pair| pair.multiplicity).sum();
            assert_eq!(found, expected, "{invariants:?}");
        }
    }

    #[test]
    fn whether_ball_s_point_counts_may_be_open() {
        use crate::number::Ball;
        let near = |q: (i64, i64)| {
            let width = rug::Rational::from((1, 1_000_000));
            Number(Ball::with_radius(&rug::Rational::from(q), &width, 64))
        };
        let with = |a4: (i64, i64)| Invariants {
            third: Number::complex(near((2, 1)), near((5, 1))),
            fourth: Number::complex(near(a4), near((7, 1))),
        };
        assert_eq!(with((16, 5)).ball_burmester_multiplicity(), None);
        assert_eq!(with((-3, 1)).ball_burmester_multiplicity(), Some(0));
    }

    #[test]
    fn equal_points_count_twice() {
        // 3σ² − (4a₃ + 3)σ − (b₄ + 1) with a₃ = 1, b₄ = −61/12.
        let double = Invariants {
            third: at(1, 0),
            fourth: Number::complex(5.into(), Number::ratio(-61, 12)),
        };
        let discriminant = double.on_pole_normal().discriminant();
        assert!(discriminant.is_zero().is_yes());
        let real = isolated(&double).real(200);
        assert_eq!(real.iter().filter(|pair| pair.multiplicity == 2).count(), 1);
    }

    #[test]
    fn all_four_may_be_complex() {
        let invariants = invariants(at(1, 1), at(0, -40));
        let pairs = isolated(&invariants);
        assert_eq!((pairs.real(200).len(), pairs.complex(200).len()), (0, 2));
    }

    /// L + 3c = 0 on the ray t = −(a₃ + 3)/b₃ of the asymptote.
    #[test]
    fn a_point_may_be_at_infinity() {
        let invariants = through([-1, 4], at(2, 5));
        let pair = invariants.pair_on_ray(&Number::one(), &Number::from(-1));
        assert!(pair.point.is_at_infinity().is_yes());
        let center = pair.center.finite().unwrap();
        let guide = Guide::MovingLine {
            normal: at(1, -1),
            center,
        };
        assert_eq!(guide.contact(&invariants.motion()).least, 4);
        let real = isolated(&invariants).real(200);
        let infinite = real
            .iter()
            .filter(|pair| pair.place == Place::CirclepointAtInfinity);
        assert_eq!(infinite.count(), 1);
    }

    /// A translation to begin with: the pole is at infinity, and the contact alone decides.
    #[test]
    fn parallel_cranks_have_their_burmester_points() {
        use crate::curvature::closure;
        let crank = |point: Point<Exact>, center| Guide::Circle { point, center };
        let guides = [crank(at(0, 2), at(0, 0)), crank(at(5, 3), at(5, 0))];
        let motion = closure::motion(&guides, 4).unwrap();
        let Some(Pairs::Isolated(pairs)) = by_contact(&motion) else {
            panic!("they are isolated");
        };
        let real = pairs.real(200);
        for pin in [at(0, 2), at(5, 3)] {
            let there = real.iter().filter(|pair| {
                let [x, y] = [1, 2].map(|i| {
                    &pair.coordinates[i] - &pair.coordinates[0] * Number::from(pin_part(&pin, i))
                });
                !x.is_zero().is_no() && !y.is_zero().is_no()
            });
            assert_eq!(there.count(), 1, "{pin:?}");
        }
    }

    fn pin_part(pin: &Point<Exact>, i: usize) -> rug::Rational {
        let part = if i == 1 { pin.re() } else { pin.im() };
        part.0.rational().unwrap().clone()
    }
}
