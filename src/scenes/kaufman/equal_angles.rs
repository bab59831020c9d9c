//! Where opposite sides of an opposite-pole quadrilateral are seen under equal angles, there is a
//! centerpoint, and only there; with image poles, a circlepoint.

use crate::number::poly::Fraction;
use crate::number::{Number, Truth};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::{Symbols, point};
use crate::scenes::{Free, Unbuilt};

pub const CENTERPOINTS: Check = Check {
    name: "equal-angles-make-centerpoints",
    summary: "For four positions, all of them free, a fixed point M has four places M_j in the moving plane; \
              it is a centerpoint where these are on a circle. Im (M_1 - M_3)(M_2 - M_4) / (M_2 - \
              M_3)(M_1 - M_4) is a real multiple, which does not vanish, of Im (M - P_13)(M - P_24) / (M - \
              P_23)(M - P_14), so that either both vanish or none, and likewise for the two other \
              quadrilaterals. The wrong variant takes two opposite sides as the diagonals.",
    run: run_centerpoints,
};

pub const CIRCLEPOINTS: Check = Check {
    name: "equal-angles-make-circlepoints",
    summary: "The same for a point of the moving plane, its four places in the fixed one, and the image \
              poles. The wrong variant takes the poles themselves.",
    run: run_circlepoints,
};

type Position = Displacement<Fraction>;
type P = Point<Fraction>;

/// Position 1 does not turn. The origin is the point in question, of the fixed or of the moving
/// plane, so that no other point need be free.
fn positions() -> Result<[Position; 4], Unbuilt> {
    let mut free = Symbols::default();
    let first = Displacement {
        rotation: Number::one(),
        translation: point(&mut free, "T_1")?,
    };
    let mut position = |j: usize| -> Result<Position, Unbuilt> {
        Ok(Displacement {
            rotation: free.angle(&format!("theta_{j}"))?.cis(),
            translation: point(&mut free, &format!("T_{j}"))?,
        })
    };
    Ok([first, position(2)?, position(3)?, position(4)?])
}

/// The orders of the positions that lead to the three quadrilaterals.
const ORDERS: [[usize; 4]; 3] = [[0, 1, 2, 3], [0, 2, 1, 3], [0, 1, 3, 2]];

fn run_centerpoints() -> Result<Report, Unbuilt> {
    let inverse = positions()?.each_ref().map(Displacement::inverse);
    // Of the inverse motion, the image poles are the poles.
    let pole = |one: &Position, other: &Position| image_pole(one, other);
    Ok(Report {
        holds: for_all_quadrilaterals(&inverse, pole, [(0, 2), (1, 3), (1, 2), (0, 3)]),
        wrong_variant: for_all_quadrilaterals(&inverse, pole, [(0, 2), (1, 2), (1, 3), (0, 3)]),
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

fn run_circlepoints() -> Result<Report, Unbuilt> {
    let positions = positions()?;
    let order = [(0, 2), (1, 3), (1, 2), (0, 3)];
    Ok(Report {
        holds: for_all_quadrilaterals(&positions, image_pole, order),
        wrong_variant: for_all_quadrilaterals(&positions, Displacement::pole, order),
        basis: Basis::Identity,
        instances: 0,
        exception: None,
    })
}

/// The point of the moving plane that lies at one place in both positions.
fn image_pole(one: &Position, other: &Position) -> P {
    one.inverse().of(&one.pole(other))
}

/// Im ab/cd up to a positive factor.
fn im_of_ratio([a, b, c, d]: [P; 4]) -> Number<Fraction> {
    ((a * b) * (c * d).conj()).im().clone()
}

/// Whether the places Tⱼ of the origin are on a circle exactly where it sees opposite sides under equal
/// angles. `corners` are two opposite corners over the two others.
#[expect(
    clippy::indexing_slicing,
    reason = "the orders and the corners are places among the four positions"
)]
fn for_all_quadrilaterals(
    positions: &[Position; 4],
    pole: impl Fn(&Position, &Position) -> P,
    corners: [(usize, usize); 4],
) -> Truth {
    let on_a_circle = [(0, 2), (1, 3), (1, 2), (0, 3)];
    Truth::all(ORDERS.map(|order| {
        let at = |j: usize| &positions[order[j]];
        let places = on_a_circle.map(|(i, j)| &at(i).translation - &at(j).translation);
        let sight = corners.map(|(i, j)| -pole(at(i), at(j)));
        let turns = on_a_circle.map(|(i, j)| &at(i).rotation - &at(j).rotation);
        let factor = {
            let [a, b, c, d] = turns;
            (a * b) * (c * d).conj()
        };
        let same = im_of_ratio(places).equals(&(factor.re() * im_of_ratio(sight)));
        factor.im().is_zero() & !factor.is_zero() & same
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_and_the_wrong_variant_is_rejected() {
        for run in [run_centerpoints, run_circlepoints] {
            let report = run().unwrap();
            assert_eq!(
                (report.holds, report.wrong_variant),
                (Truth::Yes, Truth::No)
            );
        }
    }
}
