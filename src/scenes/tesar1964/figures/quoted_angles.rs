//! The transmission angles that the figures list.

use std::cmp::Ordering;

use super::drawn::{BITS, all, undecided};
use super::results::{COARSE, FINE};
use crate::number::{Ball, Number, Truth};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::deviation::rows::Rows;
use crate::straight_line::deviation::stepped::{Met, Rule, records};

pub const CHECK: Check = Check {
    name: "tesar1964/transmission-angles-in-the-figures",
    summary: "The designed linkages of figures 37 to 72 but those of 61 and 63. In all whole degrees of R between \
              both recorded ends of a level the listed angle, that at A in figures 49 and 72 and that at B \
              in the others, is not less than at one of the ends. The wrong variant has the other angle.",
    run,
};

/// Of these the results are not reproduced.
const SYMMETRIC: [u32; 2] = [61, 63];
/// Of these the angle at A is listed.
const AT_A: [u32; 2] = [49, 72];
/// Of these the program sees no reversal.
const WATT: [u32; 2] = [57, 59];
/// These have the finer levels.
const CURVATURE: [u32; 5] = [37, 39, 41, 49, 72];

/// Whether no angle between the ends is less than at the ends, at A and at B.
fn least_at_ends(figure: u32, design: &Design<Ball>) -> Option<[bool; 2]> {
    let rule = if WATT.contains(&figure) {
        Rule::Closure
    } else {
        Rule::Reversal
    };
    let levels = if CURVATURE.contains(&figure) {
        FINE
    } else {
        COARSE
    };
    let bounds = levels.map(|(numerator, denominator)| Number::ratio(numerator, denominator));
    let driven = Driven::new(design)?;
    let unit = design.unit();
    let rows = Rows::new(&driven, &unit, &BITS)?;
    let side = |side| records(|degrees| rows.met(degrees), &bounds, side, rule);
    let (from, to) = (side(-1)?, side(1)?);
    let mut found = [true; 2];
    for (from, to) in from.into_iter().zip(to) {
        let (from, to) = (from?, to?);
        for degrees in from.degrees..=to.degrees {
            let Met::Row(row) = rows.met(degrees)? else {
                return None;
            };
            for (i, holds) in found.iter_mut().enumerate() {
                let angle = row.gamma.get(i)?;
                let ends = [&from, &to].map(|end| end.row.gamma.get(i));
                let is_less = |end: &Number<Ball>| angle.compare(end) == Some(Ordering::Less);
                *holds &= !ends.into_iter().flatten().all(is_less);
            }
        }
    }
    Some(found)
}

fn run() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong, mut instances) = (Truth::Yes, Truth::Yes, 0);
    for (figure, design) in all()? {
        if SYMMETRIC.contains(&figure) {
            continue;
        }
        let [at_a, at_b] = least_at_ends(figure, &design).ok_or_else(undecided)?;
        let (listed, other) = if AT_A.contains(&figure) {
            (at_a, at_b)
        } else {
            (at_b, at_a)
        };
        instances += 1;
        holds = holds & Truth::from(listed);
        wrong = wrong & Truth::from(other);
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Certified,
        instances,
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
