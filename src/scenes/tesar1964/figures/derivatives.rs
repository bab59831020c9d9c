//! The derivatives of the deviation over the travel.

use super::drawn::{alternates, undecided};
use crate::number::{Exact, Kind, Number, Real, Truth, count};
use crate::plane::Angle;
use crate::scenes::check::{Basis, Check, Report};
use crate::scenes::free::Random;
use crate::scenes::{Free, Unbuilt};
use crate::straight_line::ball_burmester::{Alternate, of_rays};
use crate::straight_line::design::Design;

pub const FOURTH_ORDER: Check = Check {
    name: "tesar1964/derivatives-of-fourth-order-contact",
    summary: "Four-bars with a Burmester point D on the inflection circle, from random exact rays. In the design position \
              the derivatives of v over u vanish up to the fourth, and the fifth does not: so the curve of the \
              second one has an inflection there, with a tangent along u. The wrong variant has another point \
              of the inflection circle instead of D.",
    run: run_fourth_order,
};

pub const ALIKE: Check = Check {
    name: "tesar1964/second-derivative-curves-alike",
    summary: "The three alternates of figures 39 to 44. The fifth derivatives of v over u have the same sign where \
              u runs in the same direction: near the design position all second derivatives go from one side of \
              zero to the other in the same sense. The wrong variant mirrors one of them.",
    run: run_alike,
};

const INSTANCES: u64 = 4;

/// d²v/du², …, d⁵v/du⁵ in the design position; `None` in a change point.
pub(super) fn derivatives<K: Real>(design: &Design<K>) -> Option<[Number<K>; 4]> {
    let path = design.deviation(6)?;
    let rate = path.u.derivative();
    let mut curve = path.v.derivative() / &rate;
    Some([(); 4].map(|()| {
        curve = curve.derivative() / &rate;
        curve.coefficient(0)
    }))
}

/// Whether the first three vanish and the last one does not.
fn has_inflection<K: Kind>([second, third, fourth, fifth]: &[Number<K>; 4]) -> Truth {
    second.is_zero() & third.is_zero() & fourth.is_zero() & !fifth.is_zero()
}

fn run_fourth_order() -> Result<Report, Unbuilt> {
    let (mut holds, mut wrong, mut instances) = (Truth::Yes, Truth::No, 0);
    let mut seed = 0;
    while instances < count::from_u64(INSTANCES) && seed < 100 * INSTANCES {
        let mut random = Random::new(seed);
        seed += 1;
        let mut ray = || -> Result<Angle<Exact>, Unbuilt> { random.angle("a ray") };
        let [a, b, d, other] = [ray()?, ray()?, ray()?, ray()?];
        let Ok(cranks) = of_rays(&a, &b, &d) else {
            continue;
        };
        let Ok(design) = cranks.design(Alternate::First) else {
            continue;
        };
        let mut elsewhere = design.clone();
        elsewhere.linkage.point = other.cis().scaled(&other.sin());
        elsewhere.direction = Number::i() * other.cis();
        let found = derivatives(&design).zip(derivatives(&elsewhere));
        let (of_d, of_other) = found.ok_or_else(undecided)?;
        holds = holds & has_inflection(&of_d);
        wrong = wrong | has_inflection(&of_other);
        instances += 1;
    }
    Ok(Report {
        holds: holds & Truth::from(instances > 0),
        wrong_variant: wrong,
        basis: Basis::Instances,
        instances,
        exception: None,
    })
}

/// Whether the fifth derivatives have one sign.
fn alike(fifths: &[Number<impl Real>; 3]) -> Truth {
    let [first, second, third] = fifths;
    (first * second).is_positive() & (first * third).is_positive()
}

fn run_alike() -> Result<Report, Unbuilt> {
    let fifth = |design| derivatives(&design).map(|[.., fifth]| fifth);
    let [first, second, third] = alternates()?.map(fifth);
    let fifths = [first, second, third].map(|fifth| fifth.ok_or_else(undecided));
    let [first, second, third] = fifths;
    let (first, second, third) = (first?, second?, third?);
    Ok(Report {
        holds: alike(&[first.clone(), second.clone(), third.clone()]),
        wrong_variant: alike(&[first, second, -third]),
        basis: Basis::Certified,
        instances: 1,
        exception: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_hold_and_the_wrong_variants_are_rejected() {
        for run in [run_fourth_order, run_alike] {
            let report = run().unwrap();
            let found = (report.holds, report.wrong_variant);
            assert_eq!(found, (Truth::Yes, Truth::No));
        }
    }
}
