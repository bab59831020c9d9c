//! Chapter I: what an error in the length of a crank does to a straight line.

use rug::Rational;

use crate::linkage::cognates::CouplerPoint;
use crate::linkage::four_bar::third_corners;
use crate::number::{Ball, Number, Truth};
use crate::plane::{Angle, Point, relation};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::straight_line::ball_burmester::{Alternate, double};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::arc::Arcs;
use crate::straight_line::deviation::driven::Driven;

pub const COMPENSATION: Check = Check {
    name: "tesar1964/compensation-of-errors",
    summary: "A crank of length 5 of the Ball-double-Burmester linkage with the rays 15 deg and 95 deg is made longer by \
              0.025. On the way on which D kept within 1e-6 of its line it now keeps within 5e-6 of a line, \
              by enclosures over the whole way. The wrong variant leaves the line where it was.",
    run,
};

const BITS: u32 = 160;

/// In lengths of the crank, which is 5 in: the error, the accuracy without and with it.
fn sizes() -> [Rational; 3] {
    [(25, 5_000), (1, 5_000_000), (5, 5_000_000)].map(Rational::from)
}

fn undecided() -> Unbuilt {
    Unbuilt::NotHeld("the arc of a linkage".to_owned())
}

fn angle(degrees: (i32, i32)) -> Result<Angle<Ball>, Unbuilt> {
    Angle::from_degrees(&degrees.into(), &BITS).ok_or_else(undecided)
}

/// Where the linkage comes with O_aA made longer and turned.
fn with_error(
    linkage: &CouplerPoint<Ball>,
    error: &Rational,
    degrees: (i32, i32),
) -> Result<CouplerPoint<Ball>, Unbuilt> {
    let CouplerPoint {
        pivots: [o_a, o_b],
        pins: [a, b],
        point,
    } = linkage;
    let factor = 1 + Number::rounded(error, &BITS);
    let longer = o_a + ((a - o_a) * angle(degrees)?.cis()).scaled(&factor);
    let squares = [
        relation::distance_squared(a, b),
        relation::distance_squared(b, o_b),
    ];
    let [left, right] =
        third_corners(&longer, o_b, &squares[0], &squares[1]).ok_or_else(undecided)?;
    let was_left = relation::twice_area(a, o_b, b).is_positive();
    let pin = if was_left.is_yes() { left } else { right };
    let shape = (point - a) / (b - a);
    Ok(CouplerPoint {
        pivots: linkage.pivots.clone(),
        point: &longer + shape * (&pin - &longer),
        pins: [longer, pin],
    })
}

/// The ends of the way on which D keeps within so many crank lengths of the line, along a direction.
fn way(
    design: &Design<Ball>,
    accuracy: &Rational,
    along: &Point<Ball>,
) -> Option<[Number<Ball>; 2]> {
    let [_, r, ..] = design.squared_lengths();
    let bound = r.1.sqrt() * Number::rounded(accuracy, &BITS);
    let arcs = Arcs::new(Driven::new(design)?, BITS);
    let ends = arcs
        .within(&bound)?
        .each_ref()
        .map(|limit| arcs.position(limit));
    let [from, to] = ends;
    let place = |point: &Point<Ball>| (point * along.conj()).re().clone();
    let [from, to] = [place(&from?.point), place(&to?.point)];
    Some(if (&to - &from).is_positive().is_yes() {
        [from, to]
    } else {
        [to, from]
    })
}

fn covers(outer: &[Number<Ball>; 2], inner: &[Number<Ball>; 2]) -> Truth {
    let [from, to] = [&inner[0] - &outer[0], &outer[1] - &inner[1]];
    from.is_positive() & to.is_positive()
}

fn run() -> Result<Report, Unbuilt> {
    let (a, b) = (angle((15, 1))?, angle((95, 1))?);
    let design = double(&a, &b)
        .and_then(|cranks| cranks.design(Alternate::First))
        .map_err(|why| Unbuilt::NotReal(why.to_string()))?;
    let [error, accuracy, reduced] = sizes();
    let along = design.direction.clone();
    let before = way(&design, &accuracy, &along).ok_or_else(undecided)?;
    // A line through two points of the new path, one on each side.
    let [start, end] = [(-1, 1), (3, 2)].map(|at| with_error(&design.linkage, &error, at));
    let (start, end) = (start?, end?);
    let direction = &end.point - &start.point;
    let after = Design {
        linkage: start,
        direction,
    };
    let after = way(&after, &reduced, &along).ok_or_else(undecided)?;
    let left = Design {
        linkage: with_error(&design.linkage, &error, (0, 1))?,
        direction: along.clone(),
    };
    let left = way(&left, &reduced, &along).ok_or_else(undecided)?;
    Ok(Report {
        holds: covers(&after, &before),
        wrong_variant: covers(&left, &before),
        basis: Basis::Certified,
        instances: 1,
        exception: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_is_kept_if_it_may_move() {
        let report = run().unwrap();
        assert_eq!(report.holds, Truth::Yes);
        assert_eq!(report.wrong_variant, Truth::No);
    }

    #[test]
    fn an_interval_covers_what_lies_within() {
        let interval = |low: i64, high: i64| [low, high].map(Number::<Ball>::from);
        assert!(covers(&interval(-5, 7), &interval(-4, 6)).is_yes());
        assert!(covers(&interval(-5, 7), &interval(-6, 6)).is_no());
        assert!(covers(&interval(-5, 7), &interval(-4, 8)).is_no());
    }
}
