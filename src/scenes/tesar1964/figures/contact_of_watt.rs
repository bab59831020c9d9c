//! How many infinitely near positions a Watt linkage has on its line.

use super::watt::upon;
use crate::curvature::contact::Contact;
use crate::number::{Exact, Number, Truth};
use crate::plane::Angle;
use crate::scenes::Unbuilt;
use crate::scenes::check::{Basis, Check, Report};

pub const CHECK: Check = Check {
    name: "tesar1964/watt-burmester-point",
    summary: "Watt's linkages of figures 57 and 59, with cranks at right angles to the coupler: whether the path of \
              the output point, from the series of the closure, has contact of order four with its tangent in \
              both. The wrong variant has cranks at another angle.",
    run,
};

/// Of the series of the path.
const ORDER: usize = 6;

fn contact(r: (i64, i64), gamma: &Angle<Exact>) -> Result<Contact, Unbuilt> {
    let no_motion = || Unbuilt::NotReal("the linkage is in a change point".to_owned());
    upon(&Number::ratio(r.0, r.1), &Number::one(), gamma)
        .design()
        .map_err(|reason| Unbuilt::NotReal(reason.to_string()))?
        .contact(ORDER)
        .ok_or_else(no_motion)
}

fn run() -> Result<Report, Unbuilt> {
    let right = Angle::from_cos_sin(Number::zero(), Number::one());
    let other = Angle::from_tan_half(&Number::ratio(2, 3));
    let five = |contact: Contact| Truth::from(contact.least >= 4);
    let [mut holds, mut wrong] = [Truth::Yes; 2];
    for r in [(1, 1), (1, 2)] {
        holds = holds & five(contact(r, &right)?);
        wrong = wrong & five(contact(r, &other)?);
    }
    Ok(Report {
        holds,
        wrong_variant: wrong,
        basis: Basis::Exact,
        instances: 2,
        exception: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_cranks_have_one_more() {
        let right = Angle::from_cos_sin(Number::zero(), Number::one());
        for (r, most) in [((1, 1), 4), ((1, 2), 3), ((2, 3), 3)] {
            assert_eq!(contact(r, &right).unwrap().most, Some(most), "{r:?}");
        }
        let report = run().unwrap();
        let found = (report.holds, report.wrong_variant);
        assert_eq!(found, (Truth::No, Truth::No));
    }
}
