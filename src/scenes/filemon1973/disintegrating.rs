//! Figure 12: the double point as a pair of points that part.

use super::count::tangents_from;
use super::quadrilateral::centerpoint_curve;
use crate::number::poly::Fraction;
use crate::number::{Exact, Kind, Number, Real, Truth};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Random, Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const CHECK: Check = Check {
    name: "disintegrating-point",
    summary: "H in the origin, the pair Q14, Q23 free. The curve M_h of H Q14 H Q23 has a double point in H. \
              With H + t d and H - t d in the place of H, for any d, the coefficients of the curve differ \
              from those of M_h by t^2 times numbers that do not depend on t, and those of order 3 not at \
              all: for t = 0 the curves are M_h. On 20 exact instances with t = 1/1000, one of the \
              curves with d along the middle line and across it has one branch, the other two. The wrong \
              variant has t in the place of t^2.",
    run,
};

const INSTANCES: usize = 20;

fn run() -> Result<Report, Unbuilt> {
    let mut free = Symbols::default();
    let [q14, q23, d] = ["Q_14", "Q_23", "d"].map(|name| point::<Fraction>(&mut free, name));
    let (q14, q23, d) = (q14?, q23?, d?);
    let t = free.number("t")?;
    let node = curve_of(&Number::zero(), &q14, &q23)?;
    let (whole, part) = (
        curve_of(&d, &q14, &q23)?,
        curve_of(&d.scaled(&t), &q14, &q23)?,
    );
    let differ_by = |factor: &Number<Fraction>| {
        let (of_node, of_whole, of_part) = (
            node.coefficients(),
            whole.coefficients(),
            part.coefficients(),
        );
        Truth::all(
            of_node
                .iter()
                .zip(of_whole)
                .zip(of_part)
                .map(|((node, whole), part)| (part - node).equals(&((whole - node) * factor))),
        )
    };
    let order_three = node.coefficients().iter().zip(whole.coefficients()).take(4);
    let order_three = Truth::all(order_three.map(|(node, whole)| node.equals(whole)));
    Ok(Report {
        holds: node.gradient(&Number::zero()).is_zero()
            & differ_by(&t.square())
            & order_three
            & both_types()?,
        wrong_variant: differ_by(&t),
        basis: Basis::Identity,
        instances: INSTANCES,
        exception: None,
    })
}

/// The curve of the quadrilateral H + d, Q₁₄, H − d, Q₂₃ for H = 0.
fn curve_of<K: Kind>(d: &Point<K>, q14: &Point<K>, q23: &Point<K>) -> Result<Cubic<K>, Unbuilt> {
    centerpoint_curve(&[d.clone(), q14.clone(), -d, q23.clone()])
}

fn both_types() -> Result<Truth, Unbuilt> {
    let mut free = Random::new(1973);
    let mut all = Truth::Yes;
    for _ in 0..INSTANCES {
        let q14: Point<Exact> = point(&mut free, "Q_14")?;
        let q23 = point(&mut free, "Q_23")?;
        let small = (&q14 + &q23).scaled(&Number::ratio(1, 1000));
        let along = branches(&small, &q14, &q23)?;
        let across = branches(&(&small * Number::i()), &q14, &q23)?;
        all = all & Truth::from([along, across] == [1, 2] || [along, across] == [2, 1]);
    }
    Ok(all)
}

/// By the real tangents from Q₁₄; 0 for a curve with a double point.
fn branches<K: Real>(d: &Point<K>, q14: &Point<K>, q23: &Point<K>) -> Result<usize, Unbuilt> {
    let count = tangents_from(&curve_of(d, q14, q23)?, q14)?;
    Ok(match (count.double, count.real) {
        (0, 2) => 1,
        (0, _) => 2,
        _ => 0,
    })
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

    #[test]
    fn a_pair_in_one_point_has_a_double_point() {
        let [q14, q23] = [(3, 1), (-1, 2)]
            .map(|(x, y)| Point::<Exact>::complex(Number::from(x), Number::from(y)));
        assert_eq!(branches(&Number::zero(), &q14, &q23).unwrap(), 0);
    }
}
