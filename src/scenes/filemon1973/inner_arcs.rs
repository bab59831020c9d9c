//! The arcs of the centerpoint curve inside a convex pole quadrilateral.

use super::quadrilateral::PoleQuadrilateral;
use super::sample::quadrilaterals;
use super::side_order::Sides;
use crate::number::{Exact, Number, Truth};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::quadrilateral::{Shape, shape};
use crate::plane::tangents::Pencil;
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const CHECK: Check = Check {
    name: "arcs-inside-the-quadrilateral",
    summary: "Convex quadrilaterals with U > Z and U < Z. A line of a side meets the curve in two poles and \
              in O1 or O2 outside, so that arcs inside begin and end in poles. In every pole one begins, \
              for the tangent there and the diagonal lie alike to the sides. The sum of the angles under \
              which c and h are seen is harmonic inside, greater than pi at c and h and less at r and \
              R: there are two arcs, over c and h where every line through O1 that crosses the \
              quadrilateral meets them, else over r and R, when two such lines are tangents. They are \
              over the two sides with the smaller sum, so that for U > Z the longest side has none. The \
              wrong variant says that it has one.",
    run,
};

const INSTANCES: usize = 40;

fn run() -> Result<Report, Unbuilt> {
    let mut holds = Truth::Yes;
    let mut wrong_variant = Truth::Yes;
    let mut instances = 0;
    for quadrilateral in quadrilaterals() {
        let quadrilateral = quadrilateral?;
        let sides = Sides::of(&quadrilateral)?;
        let order = sides.u.compare(&sides.z);
        let poles = quadrilateral.poles();
        if order.is_none_or(|order| order.is_eq()) || shape(&poles) != Some(Shape::Convex) {
            continue;
        }
        let curve = quadrilateral.curve()?;
        let over_r = are_over_r_and_long(&quadrilateral, &curve);
        let PoleQuadrilateral { r, h, long, c, .. } = &quadrilateral;
        let smaller = (c + h - r - long).is_positive();
        holds = holds
            & arcs_begin_in_poles(&curve, &poles)
            & over_r.map_or(Truth::No, |over_r| smaller.iff(over_r.into()));
        if order.is_some_and(|order| order.is_gt()) {
            let longest_has_one = over_r == Some(sides.longest == 2);
            holds = holds & Truth::from(!longest_has_one);
            wrong_variant = wrong_variant & Truth::from(longest_has_one);
        }
        instances += 1;
        if instances == INSTANCES {
            break;
        }
    }
    Ok(Report {
        holds,
        wrong_variant,
        basis: Basis::Instances,
        instances,
        exception: None,
    })
}

/// In each pole the tangent makes the same angle with one side as the diagonal with the other, hence
/// it goes inside.
fn arcs_begin_in_poles(curve: &Cubic<Exact>, poles: &[Point<Exact>; 4]) -> Truth {
    Truth::all((0..4).map(|i| {
        let mut round = poles.each_ref();
        round.rotate_left(i);
        let [here, next, opposite, last] = round;
        let tangent = Number::i() * curve.gradient(here);
        let ratio = (next - here) * (last - here) * (tangent * (opposite - here)).conj();
        !curve.gradient(here).is_zero() & ratio.im().is_zero()
    }))
}

/// Whether the arcs lie over r and R (or over c and h): by the tangents among the lines through O₁
/// that cross c and h, and through O₂ that cross r and R. `None` if neither is the case.
fn are_over_r_and_long(
    quadrilateral: &PoleQuadrilateral<Exact>,
    curve: &Cubic<Exact>,
) -> Option<bool> {
    let from_o1 = Crossing::of(&quadrilateral.pencil_of_o1(curve))?;
    let from_o2 = Crossing::of(&quadrilateral.pencil_of_o2(curve))?;
    match (from_o1, from_o2) {
        (
            Crossing { tangents: 2, .. },
            Crossing {
                tangents: 0,
                meet: true,
            },
        ) => Some(true),
        (
            Crossing {
                tangents: 0,
                meet: true,
            },
            Crossing { tangents: 2, .. },
        ) => Some(false),
        _ => None,
    }
}

/// The lines of a pencil with positive slope, which are those that cross a convex quadrilateral.
struct Crossing {
    tangents: usize,
    /// Whether the line of slope 1 meets the curve in two more points.
    meet: bool,
}

impl Crossing {
    fn of(pencil: &Pencil<Exact>) -> Option<Self> {
        let quartic = pencil.discriminant();
        Some(Crossing {
            tangents: quartic.sturm_sequence()?.count_above(&rug::Rational::new()),
            meet: quartic.evaluate(&Number::one()).is_positive().is_yes(),
        })
    }
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
        assert_eq!(report.instances, INSTANCES);
    }
}
