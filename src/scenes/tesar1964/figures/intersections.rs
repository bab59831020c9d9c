//! How often D comes to the line of an Evans linkage.

use std::cmp::Ordering;

use rug::Rational;

use super::drawn::{BITS, evans, undecided};
use crate::linkage::cognates::CouplerPoint;
use crate::number::zeros::zeros;
use crate::number::{Ball, Kind, Number, Series, Truth, array};
use crate::plane::{Point, relation};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::straight_line::design::Design;

pub const CHECK: Check = Check {
    name: "tesar1964/evans-intersections",
    summary: "Evans' linkages of figures 65, 67 and 69: the places of D on its line at which the linkage closes, all real \
              zeros of a polynomial of degree six in the place, told apart by the assembly. In that of the \
              figures there are five for the first and four for each of the two others. The wrong variant \
              expects four of the first.",
    run,
};

/// With D at the place u on its line, A and B are D + w(A₀ − D₀), D + w(B₀ − D₀) with |w| = 1, and the
/// lengths of the cranks give two linear equations for w.
struct Closure<K> {
    /// The determinant.
    weight: Number<K>,
    /// w times it.
    turn: Point<K>,
}

fn closure<K: Kind>(design: &Design<K>, u: &Number<K>) -> Closure<K> {
    let linkage = &design.linkage;
    let d = &linkage.point + design.direction.scaled(u);
    let equation = |(pivot, pin): (&Point<K>, &Point<K>)| {
        let (from_pivot, arm) = (&d - pivot, pin - &linkage.point);
        let product = from_pivot.conj() * &arm;
        let rest = (pin - pivot).norm() - from_pivot.norm() - arm.norm();
        // 2 (c Re − s Im) of the product is the rest, for w = c + is.
        [2 * product.re(), -2 * product.im(), rest]
    };
    let [[a, b, e], [c, d, f]] = array::pairs(&linkage.pivots, &linkage.pins).map(equation);
    Closure {
        turn: Number::complex(&e * &d - &b * &f, &a * &f - &e * &c),
        weight: a * d - b * c,
    }
}

/// Farther D does not come: twice the sum of R and M is less.
const FARTHEST: i32 = 30;

/// How many places there are in the assembly of the design.
fn count(design: &Design<Ball>) -> Option<usize> {
    let series = |z: &Point<Ball>| {
        let part = |x: &Number<Ball>| Number::<Series<Ball>>::from(x.clone());
        Number::complex(part(z.re()), part(z.im()))
    };
    let linkage = &design.linkage;
    let moving = Design {
        linkage: CouplerPoint {
            pivots: linkage.pivots.each_ref().map(series),
            pins: linkage.pins.each_ref().map(series),
            point: series(&linkage.point),
        },
        direction: series(&design.direction),
    };
    let condition = |u: &Number<Series<Ball>>| {
        let Closure { weight, turn } = closure(&moving, u);
        turn.norm() - weight.square()
    };
    let ends = [-FARTHEST, FARTHEST + 1].map(Rational::from);
    let found = zeros(&condition, 2, &ends[0], &ends[1]);
    let side = |a: &Point<Ball>, b: &Point<Ball>| -> Option<Ordering> {
        relation::twice_area(a, &linkage.pivots[1], b).sign()
    };
    let own = side(&linkage.pins[0], &linkage.pins[1])?;
    let sides = found.isolated.iter().map(|zero| {
        let u = Number(zero.ball(&condition, BITS));
        let Closure { weight, turn } = closure(design, &u);
        let w = turn.scaled(&weight.inverse());
        let d = &linkage.point + design.direction.scaled(&u);
        let [a, b] = linkage
            .pins
            .each_ref()
            .map(|pin| &d + &w * (pin - &linkage.point));
        side(&a, &b)
    });
    let sides: Option<Vec<Ordering>> = sides.collect();
    found.unresolved.is_empty().then_some(())?;
    Some(sides?.into_iter().filter(|side| *side == own).count())
}

fn run() -> Result<Report, Unbuilt> {
    let [first, second, third] = evans()?.map(|(_, design)| count(&design));
    let first = first.ok_or_else(undecided)?;
    let others = [second, third].map(|count| count.ok_or_else(undecided));
    let [second, third] = others;
    let four = second? == 4 && third? == 4;
    Ok(Report {
        holds: Truth::from(four && first == 5),
        wrong_variant: Truth::from(four && first == 4),
        basis: Basis::Certified,
        instances: 3,
        exception: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        let found = (report.holds, report.wrong_variant);
        assert_eq!(found, (Truth::Yes, Truth::No));
    }
}
