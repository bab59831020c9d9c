//! The linkages with a double Burmester point whose rays are multiples of five degrees.

use std::cmp::Ordering;

use super::drawn::{undecided, with_double_point};
use crate::linkage::four_bar::FourBar;
use crate::linkage::passage::Drive;
use crate::number::{Ball, Number, Truth};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Exception, Report};
use crate::straight_line::design::Design;

pub const PROPORTION: Check = Check {
    name: "tesar1964/linkages-removed-by-proportion",
    summary: "All pairs of rays that are multiples of 5 deg, 0 ≤ alpha_a ≤ 90 deg, alpha_a < alpha_b ≤ 180 deg, for the \
              pins of linkages with a double Burmester point. Their number is to that of the linkages whose \
              longest link is not longer than five times the shortest one as a number that is nearest to 5; \
              pairs for which links vanish are removed too. The wrong variant allows for a ratio of four.",
    run: run_proportion,
};

pub const DIVIDING_CURVE: Check = Check {
    name: "tesar1964/dividing-curve",
    summary: "The same linkages with links up to the ratio of five. For every alpha_b those with a crank that turns \
              fully come first as alpha_a grows, those without one come after them. The wrong variant has \
              them the other way round. A linkage between the rays of five degrees is on the wrong side.",
    run: run_dividing_curve,
};

/// A linkage of which the links are in proportion, between those of the grid.
const BETWEEN: [i64; 2] = [5, 171];

const STEP: i64 = 5;

/// All pairs of rays; for each α_b those of α_a together.
fn grid() -> impl Iterator<Item = Vec<[i64; 2]>> {
    (1..=180 / STEP).map(|b| {
        let last = b.min(90 / STEP + 1);
        (0..last).map(|a| [a * STEP, b * STEP]).collect()
    })
}

fn lengths(design: &Design<Ball>) -> [Number<Ball>; 6] {
    design.squared_lengths().map(|(_, square)| square.sqrt())
}

/// Whether no link is longer than so many times the shortest one, as lines 90 to 92 of the listing have
/// it: with the mean of M and N as the longest, with their sum as the shortest one.
fn in_proportion(design: &Design<Ball>, ratio: i64) -> Option<bool> {
    let [q, r, s, t, m, n] = lengths(design);
    let sides = &m + &n;
    let longest = [&q, &r, &s, &t, &(&sides / 2)];
    let shortest = [&q, &r, &s, &t, &sides];
    // One pair out of proportion is enough, even where other links vanish.
    let mut excess = longest.iter().flat_map(|long| {
        let of = |short: &&Number<Ball>| long.compare(&(ratio * *short));
        shortest.iter().map(of)
    });
    if excess.clone().any(|order| order == Some(Ordering::Greater)) {
        return Some(false);
    }
    excess.all(|order| order.is_some()).then_some(true)
}

/// The linkage of these rays; `None` where one of them is the pole tangent, where D is the pole, and
/// where a pivot is at infinity.
fn linkage([a, b]: [i64; 2]) -> Option<Design<Ball>> {
    if a == 0 || b == 180 || a + b == 180 {
        return None;
    }
    let design = with_double_point([a, b]).ok()?;
    let is_finite = |length: &Number<Ball>| length.0.lower().is_some();
    lengths(&design).iter().all(is_finite).then_some(design)
}

fn run_proportion() -> Result<Report, Unbuilt> {
    let (mut all, mut of_five, mut of_four) = (0_i64, 0_i64, 0_i64);
    for rays in grid().flatten() {
        all += 1;
        if let Some(design) = linkage(rays) {
            of_five += i64::from(in_proportion(&design, 5).ok_or_else(undecided)?);
            of_four += i64::from(in_proportion(&design, 4).ok_or_else(undecided)?);
        }
    }
    let is_about_five = |kept: i64| Truth::from(9 * kept < 2 * all && 2 * all < 11 * kept);
    Ok(Report {
        holds: is_about_five(of_five),
        wrong_variant: is_about_five(of_four),
        basis: Basis::Certified,
        instances: usize::try_from(all).unwrap_or_default(),
        exception: None,
    })
}

fn has_crank(design: &Design<Ball>) -> Option<bool> {
    let [q, r, s, t, ..] = lengths(design);
    let four_bar = FourBar {
        a: r,
        b: t,
        c: s,
        d: q,
    };
    Some(four_bar.turns_fully(Drive::First)? || four_bar.turns_fully(Drive::Second)?)
}

fn run_dividing_curve() -> Result<Report, Unbuilt> {
    let (mut cranks_first, mut cranks_last, mut instances) = (true, true, 0);
    for row in grid() {
        let mut last = None;
        for rays in row {
            let Some(design) = linkage(rays) else {
                continue;
            };
            if !in_proportion(&design, 5).ok_or_else(undecided)? {
                continue;
            }
            let crank = has_crank(&design).ok_or_else(undecided)?;
            cranks_first &= last != Some(false) || !crank;
            cranks_last &= last != Some(true) || crank;
            last = Some(crank);
            instances += 1;
        }
    }
    let between = with_double_point(BETWEEN)?;
    let is_beside = in_proportion(&between, 5).ok_or_else(undecided)?
        && !has_crank(&between).ok_or_else(undecided)?;
    Ok(Report {
        holds: Truth::from(cranks_first && is_beside),
        wrong_variant: Truth::from(cranks_last),
        basis: Basis::Certified,
        instances,
        exception: Some(Exception {
            condition: "the rays are multiples of 5 deg",
            counterexample: "alpha_a = 5 deg, alpha_b = 171 deg: no crank turns fully, among linkages with \
                             one on both sides",
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_proportion, run_dividing_curve] {
            let report = run().unwrap();
            let found = (report.holds, report.wrong_variant);
            assert_eq!(found, (Truth::Yes, Truth::No));
        }
    }
}
