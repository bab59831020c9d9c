//! The type of the centerpoint curve and the lengths of the sides.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::count::tangents_from;
use super::quadrilateral::PoleQuadrilateral;
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::poly::Fraction;
use crate::number::{Number, Truth};
use crate::plane::quadrilateral::{product_of_sums, shape};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Symbols;

pub const CHECK: Check = Check {
    name: "discriminant-of-the-tangents",
    summary: "For every quadrilateral, with the directions of its sides and two of them free, the equation \
              q(p) = 0 of order four for the tangents from O1 reads the same backwards, f_1 - f_2 is \
              4 c h/(r R), and (f_1^2 - 4)(f_2^2 - 4) = q(1) q(-1)/q_4^2 is (r R)^-4 times the product of \
              the eight numbers c ± h ± r ± R. As no side is longer than the other three, and with c < h \
              and r < R, this is a positive multiple of (c + h - r - R)(c + R - h - r), and that one of \
              Z - U, whichever sides are the shortest and the longest. Hence two of the four tangents are \
              real for U > Z, four or none for U < Z, and two coincide for U = Z. Exact convex, concave \
              and crossed quadrilaterals confirm this by the tangents from O12. The wrong variant has the \
              other sign.",
    run,
};

/// Of each shape and each of U > Z, U = Z, U < Z.
const INSTANCES: usize = 2;

fn run() -> Result<Report, Unbuilt> {
    let quadrilateral = PoleQuadrilateral::<Fraction>::free(&mut Symbols::default())?;
    let curve = quadrilateral.curve()?;
    let quartic = quadrilateral.pencil_of_o1(&curve).discriminant();
    let [q0, q1, q2, q3, q4] = [0, 1, 2, 3, 4].map(|power| quartic.coefficient(power));
    let palindromic = q0.equals(&q4) & q1.equals(&q3);
    let PoleQuadrilateral { r, h, long, c, .. } = &quadrilateral;
    let unit = r * long;
    let difference = (4 * c * h * &q4).square();
    let of_f = q3.square() - 4 * &q4 * (q2 - 2 * &q4);
    let apart = (of_f * unit.square()).equals(&difference);
    let [one, minus_one] = [1, -1].map(|p| quartic.evaluate(&Number::from(p)));
    let found = one * minus_one * unit.power(4);
    let expected = q4.square() * product_of_sums(&[c, h, r, long].map(Number::square));
    let (confirmed, instances) = tangents_from_a_pole()?;
    Ok(Report {
        holds: palindromic & apart & found.equals(&expected) & confirmed,
        wrong_variant: palindromic & apart & found.equals(&-expected),
        basis: Basis::Identity,
        instances,
        exception: None,
    })
}

/// The tangents from O₁₂ against U and Z, and on how many quadrilaterals.
fn tangents_from_a_pole() -> Result<(Truth, usize), Unbuilt> {
    let mut left = BTreeMap::new();
    let mut all = Truth::Yes;
    for quadrilateral in quadrilaterals() {
        let quadrilateral = quadrilateral?;
        let sides = Sides::of(&quadrilateral)?;
        let order = sides.u.compare(&sides.z);
        let poles = quadrilateral.poles();
        let left_of_class = left.entry((shape(&poles), order)).or_insert(INSTANCES);
        if *left_of_class > 0 {
            *left_of_class -= 1;
            let count = tangents_from(&quadrilateral.curve()?, &poles[0])?;
            let expected = match order {
                Some(Ordering::Greater) => (count.real, count.double) == (2, 0),
                Some(Ordering::Less) => [0, 4].contains(&count.real) && count.double == 0,
                _ => count.double == 1,
            };
            all = all & Truth::from(expected);
        }
        if left.len() == 9 && left.values().all(|left| *left == 0) {
            return Ok((all, 9 * INSTANCES));
        }
    }
    Err(Unbuilt::NotHeld("quadrilaterals of every shape".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
