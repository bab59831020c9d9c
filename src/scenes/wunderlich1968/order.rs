//! The order of the curve of admissible points F, for all quadrilaterals.

use crate::number::Number;
use crate::number::poly::Fraction;
use crate::plane::{Point, quadrilateral};
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::scenes::free::Symbols;
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "order-of-the-focal-curve",
    summary: "With M, A, B, N free, the polynomial of the curve has no term of order 4, and of order 3 \
              only z z' (k z - k' z'), where k is the conjugate of (B - A) - (N - M): the order is 3 \
              unless MABN is a parallelogram, and then it is 2. The wrong variant takes \
              (B - A) + (N - M).",
    run,
};

fn run() -> Result<Report, Unbuilt> {
    let mut free = Symbols::default();
    let mut point = |name: &str| -> Result<Point<Fraction>, Unbuilt> {
        Ok(Number::complex(
            free.number(&format!("x of {name}"))?,
            free.number(&format!("y of {name}"))?,
        ))
    };
    let [m, a, b, n] = [point("M")?, point("A")?, point("B")?, point("N")?];
    let curve = quadrilateral::focal_curve(&[m.clone(), a.clone(), b.clone(), n.clone()]);
    let leading = |k: &Point<Fraction>| {
        let [z3, z2, z1, z0] = [3, 2, 1, 0].map(|j| curve.coefficient(j, 3 - j));
        z3.is_zero() & z0.is_zero() & z2.equals(&k.conj()) & z1.equals(&-k)
    };
    let excess = (&b - &a) - (&n - &m);
    let fourth = &n + (&a - &m);
    let of_parallelogram = quadrilateral::focal_curve(&[m.clone(), a.clone(), fourth, n.clone()]);
    let order_two = of_parallelogram.has_no_term_of_order(4)
        & of_parallelogram.has_no_term_of_order(3)
        & !of_parallelogram.has_no_term_of_order(2);
    Ok(Report {
        holds: curve.has_no_term_of_order(4) & leading(&excess) & order_two,
        wrong_variant: curve.has_no_term_of_order(4) & leading(&(&b - &a + (&n - &m))),
        basis: Basis::Identity,
        instances: 0,
        exception: Some(Exception {
            condition: "MABN is no parallelogram",
            counterexample: "every parallelogram MABN: the curve has order 2",
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Truth;

    #[test]
    fn the_order_is_decided_and_the_wrong_variant_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
