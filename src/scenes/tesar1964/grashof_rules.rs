//! Chapter VI: Grashof's rules for small whole lengths.

use super::grashof::{Links, untold};
use crate::number::{Exact, Number, Truth};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use std::cmp::Ordering;

pub const CHECK: Check = Check {
    name: "grashof-rules",
    summary: "All four-bars with links of 1 to 6 units: where a + b > c + d, a > b, and c > d, the shortest link \
              alone turns fully against the three others if a - b < c - d, and no link against another \
              one if a - b > c - d. The wrong variant gives the names a, b to the pair with the smaller \
              sum.",
    run,
};

/// The longest link.
const LONGEST: i64 = 6;

fn run() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong, mut instances) = (Truth::Yes, Truth::Yes, 0);
    for code in 0..LONGEST.pow(4) {
        let side = |place: u32| Number::from(code / LONGEST.pow(place) % LONGEST + 1);
        let links: Links<Exact> = Links([side(0), side(1), side(2), side(3)]);
        if links.four_bar().moves().is_no() {
            continue;
        }
        let in_order = links.in_order().ok_or_else(untold)?;
        let [a, b, c, d] = in_order.map(|place| links.at(place));
        if (a + b - c - d).is_positive().is_yes() {
            instances += 1;
            holds = holds & follow(&links, &(a - b), &(c - d)).ok_or_else(untold)?;
            wrong = wrong & follow(&links, &(c - d), &(a - b)).ok_or_else(untold)?;
        }
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Instances,
        instances,
        exception: None,
    })
}

/// Whether the links turn as the differences of the longer and the shorter one in the first and in the
/// second pair ask for.
fn follow(links: &Links<Exact>, first: &Number<Exact>, second: &Number<Exact>) -> Option<Truth> {
    let all = links.count_of_all()?;
    Some(match first.compare(second)? {
        Ordering::Less => Truth::from(all == 3 && links.count_of_shortest()? == 3),
        Ordering::Equal => Truth::Yes,
        Ordering::Greater => Truth::from(all == 0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_and_the_wrong_variant_is_rejected() {
        let report = run().unwrap();
        assert_eq!(
            (report.holds, report.wrong_variant),
            (Truth::Yes, Truth::No)
        );
    }
}
