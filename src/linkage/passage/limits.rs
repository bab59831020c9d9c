//! Where the verdicts on a four-bar may change while its links do: functions whose zeros bound each
//! verdict. Between the zeros the signs that decide stay as they are.

use super::joint::twice_area;
use super::{Joint, Passage};
use crate::number::{Kind, Number};
use crate::plane::relation;

impl<K: Kind> Passage<K> {
    /// For the type, and for what a gate allows: ∏ (a ± b ± c ± d) over all signs, for the lengths of the
    /// links. `None` where a joint is at infinity.
    pub fn limit_of_type(&self) -> Option<Number<K>> {
        let [p, q] = &self.pivots;
        let [a, b] = self.joints.first()?;
        let square =
            |x: &Joint<K>, y: &Joint<K>| Some(relation::distance_squared(x.point()?, y.point()?));
        let [a, b, c, d] = [square(p, a)?, square(a, b)?, square(b, q)?, square(p, q)?];
        // Of the squares: (√a ± √b)² − (√c ± √d)² = e ± 2√ab ± 2√cd.
        let e = &a + &b - &c - &d;
        let product = a * b;
        Some((e.square() + 4 * &product - 4 * c * d).square() - 16 * e.square() * product)
    }

    /// For the sides on which the joints are, beside the type: in circuit, branch, and order. In one of
    /// the positions three joints lie on a line.
    pub fn limits_of_sides(&self) -> Vec<Number<K>> {
        let [p, q] = &self.pivots;
        let joints = self.joints.iter();
        joints
            .flat_map(|[a, b]| [[a, b, q], [p, a, b], [p, q, a], [p, q, b]])
            .map(|[x, y, z]| twice_area(x, y, z))
            .collect()
    }
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
        // Lengths 5, 4, 13, 12.
        let passage = four_bar((3, 4), (7, 4), 12);
        let squares: Vec<i64> = vec![25, 16, 41, 144];
        let [a, b, c, d] = [5.0, 4.0, 41f64.sqrt(), 12.0];
        assert_eq!(squares[2], 5 * 5 + 4 * 4);
        let mut product = 1.0;
        for signs in 0..8 {
            let sign = |place: u32| if signs >> place & 1 == 0 { 1.0 } else { -1.0 };
            product *= a + sign(0) * b + sign(1) * c + sign(2) * d;
        }
        let found = passage.limit_of_type().and_then(|limit| {
            let limit = limit.0.rational()?.to_f64();
            Some((limit - product).abs() < 1e-9 * product.abs())
        });
        assert_eq!(found, Some(true));
    }

    #[test]
    fn a_change_point_is_on_the_limit() {
        // A kite with the sides 5, 10, 10, 5 and a parallelogram.
        for passage in [four_bar((3, 4), (9, 12), 5), four_bar((3, 4), (10, 4), 7)] {
            let limit = passage.limit_of_type();
            assert!(limit.is_some_and(|limit| limit.is_zero().is_yes()));
        }
    }

    #[test]
    fn a_dead_centre_is_on_a_limit() {
        let sides = |passage: Passage<Exact>| {
            let zeros = passage.limits_of_sides();
            zeros
                .iter()
                .filter(|limit| limit.is_zero().is_yes())
                .count()
        };
        // A, B, and B₀ on a line.
        assert_eq!(sides(four_bar((2, 3), (4, 2), 8)), 1);
        assert_eq!(sides(four_bar((2, 3), (4, 3), 8)), 0);
    }
}
