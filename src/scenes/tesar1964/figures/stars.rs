//! Which cranks turn fully.

use super::drawn::{all, undecided};
use crate::linkage::four_bar::FourBar;
use crate::linkage::passage::Drive;
use crate::number::{Ball, Truth};
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};
use crate::straight_line::design::Design;

pub const CHECK: Check = Check {
    name: "tesar1964/stars-in-the-figures",
    summary: "The twelve designed linkages of figures 37 to 72. R of figures 37 and 69 and T of figure 72 turn \
              fully, and no other crank does. The wrong variant gives T the stars of R.",
    run,
};

/// A figure with a star, at the first or the second crank.
const STARS: [(u32, usize); 3] = [(37, 0), (69, 0), (72, 1)];

fn turn(design: &Design<Ball>) -> Option<[bool; 2]> {
    let [q, r, s, t, ..] = design.squared_lengths().map(|(_, square)| square.sqrt());
    let four_bar = FourBar {
        a: r,
        b: t,
        c: s,
        d: q,
    };
    let [first, second] = [Drive::First, Drive::Second].map(|drive| four_bar.turns_fully(drive));
    Some([first?, second?])
}

fn run() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong) = (Truth::Yes, Truth::Yes);
    let linkages = all()?;
    for (figure, design) in &linkages {
        let turning = turn(design).ok_or_else(undecided)?;
        let starred = [0, 1].map(|crank| STARS.contains(&(*figure, crank)));
        let [first, second] = starred;
        holds = holds & Truth::from(turning == starred);
        wrong = wrong & Truth::from(turning == [second, first]);
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Certified,
        instances: linkages.len(),
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
