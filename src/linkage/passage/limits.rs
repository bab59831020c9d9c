//! Where the verdicts on a four-bar may change while its links do: functions whose zeros bound each
//! verdict. Between the zeros the signs that decide stay as they are.

use super::joint::twice_area;
use super::{Drive, Joint, Passage};
use crate::number::{Kind, Number};
use crate::plane::relation;

impl<K: Kind> Passage<K> {
    /// For the type, and for what a gate allows: ∏ (a ± b ± c ± d) over all signs, for the lengths of the
    /// links. `None` where a joint is at infinity.
    pub fn limit_of_type(&self) -> Option<Number<K>> {
        let [a, b, c, d] = self.squares()?;
        // (√a ± √b)² − (√c ± √d)² = e ± 2√ab ± 2√cd.
        let e = &a + &b - &c - &d;
        let product = a * b;
        Some((e.square() + 4 * &product - 4 * c * d).square() - 16 * e.square() * product)
    }

    /// For |cos γ| ≤ √C, beside all others: in one of the positions, or in a gate, it is √C. With the
    /// diagonal f from the driving link to the other pivot, which in a gate is |d ± a|,
    /// cos γ = (b² + c² − f²)/2bc. `None` where a joint is at infinity.
    pub fn limits_of_transmission(
        &self,
        drive: Drive,
        square_of_cosine: &Number<K>,
    ) -> Option<Vec<Number<K>>> {
        let passage = self.seen_from(drive);
        let [a, b, c, d] = passage.squares()?;
        let bound = 4 * square_of_cosine * &b * &c;
        // (e − 2√ad)² − bound times the same with the other sign.
        let e = &b + &c - &a - &d;
        let product = a * d;
        let sum = e.square() + 4 * &product - &bound;
        let mut limits = vec![sum.square() - 16 * e.square() * product];
        for [driving, _] in &passage.joints {
            let f = square_of_distance(driving, &passage.pivots[1])?;
            limits.push((&b + &c - f).square() - &bound);
        }
        Some(limits)
    }

    /// a², b², c², d² of the links A₀A, AB, BB₀ and the base A₀B₀; `None` where a joint is at infinity.
    fn squares(&self) -> Option<[Number<K>; 4]> {
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        let square = square_of_distance;
        Some([square(p, a)?, square(a, b)?, square(b, q)?, square(p, q)?])
    }

    /// For the sides on which the joints are: beside the type all that branch and order depend on, but
    /// for positions in which the driving link is in one place. In one of the positions coupler and driven
    /// link are on a line, or the driving link and the base.
    pub fn limits_of_sides(&self, drive: Drive) -> Vec<Number<K>> {
        let [p, q] = &self.pivots;
        let joints = self.joints.iter();
        joints
            .flat_map(|[a, b]| match drive {
                Drive::First => [[a, b, q], [p, q, a]],
                Drive::Second => [[p, a, b], [p, q, b]],
            })
            .map(|[x, y, z]| twice_area(x, y, z))
            .collect()
    }
}

fn square_of_distance<K: Kind>(x: &Joint<K>, y: &Joint<K>) -> Option<Number<K>> {
    Some(relation::distance_squared(x.point()?, y.point()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    fn at(x: i64, y: i64) -> Joint<Exact> {
        Joint::At(Number::complex(x.into(), y.into()))
    }

    fn four_bar(a: (i64, i64), b: (i64, i64), base: i64) -> Passage<Exact> {
        Passage {
            pivots: [at(0, 0), at(base, 0)],
            joints: vec![[at(a.0, a.1), at(b.0, b.1)]],
        }
    }

    #[test]
    fn the_limit_of_the_type_is_the_product_of_the_sums() {
        let limit = four_bar((3, 4), (7, 4), 12).limit_of_type();
        let [a, b, c, d] = [5.0, 4.0, 41f64.sqrt(), 12.0];
        let mut product = 1.0;
        for sb in [1.0, -1.0] {
            for sc in [1.0, -1.0] {
                for sd in [1.0, -1.0] {
                    product *= a + sb * b + sc * c + sd * d;
                }
            }
        }
        let found = limit.and_then(|limit| Some(limit.0.rational()?.to_f64()));
        assert!(
            found.is_some_and(|found| (found - product).abs() < 1e-9 * product.abs()),
            "{found:?}, not {product}"
        );
    }

    #[test]
    fn a_change_point_is_on_the_limit() {
        // A kite and a parallelogram.
        for passage in [four_bar((3, 4), (16, 8), 5), four_bar((3, 4), (10, 4), 7)] {
            let limit = passage.limit_of_type();
            assert!(limit.is_some_and(|limit| limit.is_zero().is_yes()));
        }
    }

    #[test]
    fn a_dead_centre_is_on_a_limit_of_its_drive() {
        let vanish = |passage: Passage<Exact>| {
            Drive::ALL.map(|drive| {
                let limits = passage.limits_of_sides(drive);
                limits.iter().any(|limit| limit.is_zero().is_yes())
            })
        };
        // A, B, and B₀ on a line; A₀, A, and B; none.
        assert_eq!(vanish(four_bar((2, 3), (4, 2), 8)), [true, false]);
        assert_eq!(vanish(four_bar((2, 3), (4, 6), 9)), [false, true]);
        assert_eq!(vanish(four_bar((2, 3), (4, 3), 8)), [false, false]);
    }
    #[test]
    fn a_transmission_angle_at_its_least_is_on_a_limit() {
        // γ at B between AB and BB₀, driven at A₀.
        let at_limit = |passage: Passage<Exact>, square: Number<Exact>| {
            let limits = passage.limits_of_transmission(Drive::First, &square);
            limits.is_some_and(|limits| limits.iter().any(|limit| limit.is_zero().is_yes()))
        };
        // 45° in the position.
        let passage = || four_bar((0, 2), (3, 5), 3);
        assert!(at_limit(passage(), Number::ratio(1, 2)));
        assert!(!at_limit(passage(), Number::ratio(1, 3)));
        // a : b : c : d = 15 : 24 : 7 : 20, 90° in the position, cos γ = ±25/14 for f = 20 ± 15.
        let passage = || four_bar((0, 1875), (2808, 819), 2500);
        assert!(at_limit(passage(), Number::zero()));
        assert!(at_limit(passage(), Number::ratio(625, 196)));
    }
}
