//! The motion seen from its pole: the polodes and the instantaneous invariants.
//!
//! The pole is the point without velocity. Seen from it, the moving origin is shifted by
//! a₂θ²/2 + a₃θ³/6 + a₄θ⁴/24 + …, where θ is the angle of the turn. The pole tangent is across a₂, and
//! a₂ leads to the inflection pole. Divided by −ia₂, which turns the pole tangent into the x-axis and
//! makes the diameter of the inflection circle the unit, the shift is
//! iθ²/2 + w₃θ³/6 + w₄θ⁴/24 + … with the instantaneous invariants w₃, w₄, … (O. Bottema, G. R. Veldkamp).

use super::motion::{Motion, Path, coefficient, derivative, turning};
use crate::number::{Kind, Number};
use crate::plane::Point;

/// How the pole, the pole tangent and the inflection circle lie in the fixed plane, and the
/// invariants.
#[derive(Clone, Debug)]
pub struct Canonical<K> {
    /// The pole.
    pub pole: Point<K>,
    /// From the pole to the inflection pole.
    pub diameter: Point<K>,
    /// The motion up to place and size.
    pub invariants: Invariants<K>,
}

/// What the motion is up to place and size, to terms in θ⁴: a₃ + ib₃ and a₄ + ib₄.
#[derive(Clone, Debug)]
pub struct Invariants<K> {
    /// Three times what four infinitesimally separated positions tell.
    pub third: Point<K>,
    /// The same of five.
    pub fourth: Point<K>,
}

impl<K: Kind> Canonical<K> {
    /// Of a motion to terms in t⁴ that starts with a turn, and whose parameter is the angle of the
    /// turn. `None` for a motion that starts with a translation or has another parameter: its pole is
    /// at infinity, and so are the inflection circle and the invariants. Without values where the
    /// inflection circle is a point.
    pub fn of(motion: &Motion<K>) -> Option<Self> {
        let order = motion.rotation.re().order().unwrap_or(0);
        let by_angle = turning::<K>(&[], order).rotation;
        if order < 4 || !motion.rotation.equals(&by_angle).is_yes() {
            return None;
        }
        let shift = |n: usize, factorial: i64| coefficient(&motion.translation, n) * factorial;
        let pole = Number::i() * shift(1, 1);
        // e^{iθ} turns the pole about the origin, which adds iⁿ times it.
        let second = shift(2, 2) - &pole;
        let third = shift(3, 6) - Number::i() * &pole;
        let fourth = shift(4, 24) + &pole;
        let unit = Number::i() / &second;
        Some(Canonical {
            pole,
            invariants: Invariants {
                third: third * &unit,
                fourth: fourth * unit,
            },
            diameter: second,
        })
    }

    /// The inflection pole.
    pub fn inflection_pole(&self) -> Point<K> {
        &self.pole + &self.diameter
    }

    /// A point whose canonical coordinates these are.
    pub fn place(&self, canonical: &Point<K>) -> Point<K> {
        &self.pole - Number::i() * &self.diameter * canonical
    }

    /// The canonical coordinates of a point.
    pub fn coordinates(&self, point: &Point<K>) -> Point<K> {
        Number::i() * (point - &self.pole) / &self.diameter
    }
}

impl<K: Kind> Invariants<K> {
    /// The motion with these invariants to terms in θ⁴, the pole in the origin, the inflection pole in
    /// i.
    pub fn motion(&self) -> Motion<K> {
        let (third, fourth) = (self.third.clone(), self.fourth.clone());
        turning(&[Number::zero(), Number::i(), third, fourth], 4)
    }

    /// The invariants of the inverse motion. It turns by −θ, and its inflection pole is in −i: both are
    /// set right by a half turn of the axes.
    pub fn inverse(&self) -> Self {
        let inverse = self.motion().inverse();
        let shift = |n: usize, factor: i64| coefficient(&inverse.translation, n) * factor;
        Invariants {
            third: shift(3, 6),
            fourth: -shift(4, 24),
        }
    }
}

/// The moving polode: the points that are the pole, one after the other.
pub fn moving_polode<K: Kind>(motion: &Motion<K>) -> Path<K> {
    // a' + u'z = 0.
    -derivative(&motion.translation) / derivative(&motion.rotation)
}

/// The fixed polode: the places of the pole.
pub fn fixed_polode<K: Kind>(motion: &Motion<K>) -> Path<K> {
    motion.of(&moving_polode(motion))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::closure;
    use crate::curvature::contact::Guide;
    use crate::curvature::osculation::{center_of_curvature, inflection_circle};
    use crate::number::Exact;

    fn at(x: i64, y: i64) -> Point<Exact> {
        Number::complex(x.into(), y.into())
    }

    fn four_bar() -> Motion<Exact> {
        let crank = |point: Point<Exact>, center| Guide::Circle { point, center };
        closure::motion(&[crank(at(0, 3), at(-1, 0)), crank(at(4, 5), at(6, -1))], 4).unwrap()
    }

    fn invariants() -> Invariants<Exact> {
        Invariants {
            third: at(2, 5),
            fourth: at(-3, 7),
        }
    }

    #[test]
    fn the_pole_is_where_the_cranks_meet_and_has_no_velocity() {
        let motion = four_bar();
        let canonical = Canonical::of(&motion).unwrap();
        let path = motion.path_of(&canonical.pole);
        assert!(coefficient(&path, 1).is_zero().is_yes());
        for (pin, pivot) in [(at(0, 3), at(-1, 0)), (at(4, 5), at(6, -1))] {
            let ray = (&canonical.pole - &pivot) / (pin - pivot);
            assert!(ray.im().is_zero().is_yes());
        }
        let circle = inflection_circle(&motion);
        assert!(circle.contains(&canonical.pole).is_yes());
        assert!(circle.contains(&canonical.inflection_pole()).is_yes());
        let middle = (&canonical.pole + canonical.inflection_pole()) / 2;
        assert!(circle.center().equals(&middle).is_yes());
    }

    #[test]
    fn a_motion_is_its_invariants_in_its_place() {
        let motion = four_bar();
        let canonical = Canonical::of(&motion).unwrap();
        let again = canonical.invariants.motion();
        for point in [at(3, 1), at(-2, 7)] {
            let path = motion.path_of(&canonical.place(&point));
            let seen = again.path_of(&point);
            for j in 0..=4 {
                let from = if j == 0 {
                    canonical.pole.clone()
                } else {
                    Number::zero()
                };
                let there = coefficient(&path, j) - from;
                let here = -(Point::i() * &canonical.diameter * coefficient(&seen, j));
                assert!(there.equals(&here).is_yes(), "θ^{j}");
            }
            assert!(
                canonical
                    .coordinates(&canonical.place(&point))
                    .equals(&point)
                    .is_yes()
            );
        }
    }

    #[test]
    fn the_inverse_of_the_inverse_is_the_motion() {
        let invariants = invariants();
        let inverse = invariants.inverse();
        assert!(inverse.third.equals(&invariants.third).is_no());
        let back = inverse.inverse();
        assert!(back.third.equals(&invariants.third).is_yes());
        assert!(back.fourth.equals(&invariants.fourth).is_yes());
    }

    /// 1/R of the moving polode is a₃ + 2, of the fixed one a₃ + 1, and their difference 1/PJ.
    #[test]
    fn the_polodes_touch_and_roll() {
        let motion = invariants().motion();
        for (polode, curvature) in [(moving_polode(&motion), 4), (fixed_polode(&motion), 3)] {
            assert!(coefficient(&polode, 0).is_zero().is_yes());
            assert!(coefficient(&polode, 1).im().is_zero().is_yes());
            let center = center_of_curvature(&polode).finite().unwrap();
            assert!(center.equals(&(Point::i() / curvature)).is_yes());
        }
        let [moving, fixed] = [moving_polode(&motion), fixed_polode(&motion)]
            .map(|polode| derivative(&polode).norm());
        assert!(moving.equals(&fixed).is_yes(), "arcs of one length");
    }

    #[test]
    fn a_translation_has_no_pole() {
        let crank = |point: Point<Exact>, center| Guide::Circle { point, center };
        let parallel = [crank(at(0, 2), at(0, 0)), crank(at(5, 3), at(5, 0))];
        let motion = closure::motion(&parallel, 4).unwrap();
        assert!(Canonical::of(&motion).is_none());
        // Its inflection circle is the line across the cranks, as in Watt's mechanism.
        let line = inflection_circle(&motion);
        assert!(line.is_line().is_yes() && line.is_determined().is_yes());
    }
}
