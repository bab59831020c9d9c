//! Focus and point pairs: what the focus divides.

use std::cmp::Ordering;

use super::count::tangents_from;
use super::quadrilateral::PoleQuadrilateral;
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::{Exact, Truth};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Exception, Report};

pub const CHECK: Check = Check {
    name: "focus-divides-the-curve",
    summary: "The finite curve without its focus F has two parts, and each of the pairs O12 O34, O14 O23 and \
              O1 O2 has one point on either. For U < Z the parts are the branches, F being on the one \
              without tangents. For U > Z they are arcs: along a line parallel to the middle line the \
              curve has two points at most, told apart by the sign of the derivative; F and the point \
              at infinity lie on different sheets, and both sheets end where the tangent is parallel to \
              the middle line. The wrong variant says that both points of a pair lie on one part.",
    run,
};

const INSTANCES: usize = 40;

fn run() -> Result<Report, Unbuilt> {
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    for quadrilateral in quadrilaterals().take(INSTANCES) {
        let quadrilateral = quadrilateral?;
        let curve = quadrilateral.curve()?;
        let sides = Sides::of(&quadrilateral)?;
        let split = match sides.u.compare(&sides.z) {
            Some(Ordering::Less) => split_by_branches(&quadrilateral, &curve)?,
            Some(Ordering::Greater) => split_by_arcs(&quadrilateral, &curve),
            // F is on the loop, which hangs together with the rest in the double point.
            Some(Ordering::Equal) => {
                let count = tangents_from(&curve, &curve.singular_focus())?;
                holds = holds & Truth::from((count.double, count.real) == (1, 0));
                continue;
            }
            None => return Err(Unbuilt::NotHeld("the order of U and Z".to_owned())),
        };
        holds = holds & Truth::all(split);
        wrong_variant = wrong_variant & !Truth::any(split);
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances: INSTANCES,
        exception: Some(Exception {
            condition: "U ≠ Z",
            counterexample: "every curve with a double point H: F lies on the loop, and without F both \
                             ends of the loop still meet the rest of the curve in H",
        }),
    })
}

type Pair = [Point<Exact>; 2];

fn pairs(quadrilateral: &PoleQuadrilateral<Exact>) -> [Pair; 3] {
    let [o12, o23, o34, o14] = quadrilateral.poles();
    [
        [o12, o34],
        [o14, o23],
        [Point::<Exact>::zero(), quadrilateral.o2()],
    ]
}

/// The branch without tangents, on which F lies, has one point of each pair.
fn split_by_branches(
    quadrilateral: &PoleQuadrilateral<Exact>,
    curve: &Cubic<Exact>,
) -> Result<[Truth; 3], Unbuilt> {
    let is_with_focus = |point: &Point<Exact>| -> Result<bool, Unbuilt> {
        Ok(tangents_from(curve, point)?.real == 0)
    };
    let focus = is_with_focus(&curve.singular_focus())?;
    let mut split = [Truth::No; 3];
    for (truth, [x, y]) in split.iter_mut().zip(pairs(quadrilateral)) {
        *truth = Truth::from(focus && is_with_focus(&x)? != is_with_focus(&y)?);
    }
    Ok(split)
}

/// The arcs into which F and the point at infinity cut a single branch.
fn split_by_arcs(quadrilateral: &PoleQuadrilateral<Exact>, curve: &Cubic<Exact>) -> [Truth; 3] {
    let pairs = pairs(quadrilateral);
    let [m_1, m_2] = [&pairs[0], &pairs[1]].map(|[x, y]| (x + y) / 2);
    let along = m_2 - &m_1;
    let focus = curve.singular_focus();
    let height = |point: &Point<Exact>| ((point - &focus) * along.conj()).im().clone();
    let sheet = |point: &Point<Exact>| (curve.gradient(point) * along.conj()).re().sign();
    // The asymptote lies as far beyond the middle line as F on this side of it.
    let asymptote = 2 * height(&m_1);
    let of_focus = sheet(&focus);
    let arc = |point: &Point<Exact>| {
        let height = height(point);
        if sheet(point) == of_focus {
            height.sign()
        } else {
            height.compare(&asymptote)
        }
    };
    pairs.map(|[x, y]| match (arc(&x), arc(&y)) {
        (Some(x), Some(y)) => Truth::from(x.is_ne() && x == y.reverse()),
        _ => Truth::Unknown,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_but_for_an_exception_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
        assert!(report.exception.is_some());
    }
}
