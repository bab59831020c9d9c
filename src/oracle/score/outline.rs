//! Solutions in intervals of machine floats. Most of what is compared lies far apart, and these prove it;
//! exact numbers decide the rest.

use rug::Rational;

use super::number::Known;
use super::read::{Member, Part};
use crate::number::{Interval, Number};

/// The numbers of a solution, each within an interval.
pub struct Outline(Vec<(&'static str, Vec<Number<Interval>>)>);

impl Outline {
    /// Of its points and numbers; what else it has is left to [`member_error`](super::compare::member_error).
    pub fn of(member: &Member) -> Self {
        let parts = member.parts.iter();
        let numbers = parts.filter_map(|(name, part)| match part {
            Part::Numbers(numbers) => Some((*name, numbers.iter().map(value).collect())),
            _ => None,
        });
        Outline(numbers.collect())
    }

    /// Whether the relative error of what is given is surely more than is allowed, by one number of it.
    pub fn is_far_from(&self, given: &Outline, scale: &Rational, allowed: &Rational) -> bool {
        let allowed = interval(allowed);
        self.0.iter().any(|(name, numbers)| {
            let other = given.0.iter().find(|(other, _)| other == name);
            other.is_some_and(|(_, other)| {
                let most = (&allowed * size(numbers, scale)).0.high();
                let distances = numbers.iter().zip(other).map(|(x, y)| (x - y).abs());
                distances
                    .into_iter()
                    .any(|distance| distance.0.low() > most)
            })
        })
    }
}

/// What errors of these numbers are measured by, or more.
fn size(numbers: &[Number<Interval>], scale: &Rational) -> Number<Interval> {
    let largest = numbers.iter().map(|x| x.0.magnitude());
    let largest = largest.fold(0.0, f64::max);
    let may_be_zero = numbers.iter().all(|x| !x.is_zero().is_no());
    let least = if may_be_zero {
        interval(scale).0.high()
    } else {
        0.0
    };
    Number(Interval::new(0.0, largest.max(least)))
}

fn value(known: &Known) -> Number<Interval> {
    interval(&known.value)
}

fn interval(q: &Rational) -> Number<Interval> {
    Number::rounded(q, &())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::score::compare::member_error;
    use proptest::prelude::*;

    fn member(numbers: &[Rational]) -> Member {
        let known = |value: &Rational| Known {
            value: value.clone(),
            radius: Rational::new(),
        };
        let part = Part::Numbers(numbers.iter().map(known).collect());
        Member {
            parts: vec![("center", part)],
            multiplicity: 1,
        }
    }

    fn numbers() -> impl Strategy<Value = Vec<Rational>> {
        let number = (-50_i32..50, 1_i32..60).prop_map(Rational::from);
        proptest::collection::vec(number, 2)
    }

    proptest! {
        /// And what is farther by a little is seen to be so.
        #[test]
        fn what_is_far_has_an_error_beyond_what_is_allowed(
            certified in numbers(),
            shift in numbers(),
            shrunk in 0_u32..60,
            sized in -2000_i32..2000,
            allowed in 1_i32..100,
        ) {
            let scaled = |q: Rational| if sized < 0 { q >> sized.unsigned_abs() } else { q << sized.unsigned_abs() };
            let given = certified.iter().zip(shift).map(|(x, y)| scaled(x + (y >> shrunk))).collect::<Vec<_>>();
            let certified = certified.into_iter().map(scaled).collect::<Vec<_>>();
            let (certified, given) = (member(&certified), member(&given));
            let scale = Rational::from(1);
            let allowed = Rational::from((allowed, 100)) >> shrunk;
            let far = Outline::of(&certified).is_far_from(&Outline::of(&given), &scale, &allowed);
            let error = member_error(&certified, &given, &scale);
            prop_assert!(!far || error.as_ref().is_none_or(|error| *error > allowed));
            let is_ordinary = sized.abs() < 900 && shrunk < 40;
            let more = allowed * Rational::from((1001, 1000));
            let is_farther = error.is_some_and(|error| error > more);
            prop_assert!(!is_ordinary || far || !is_farther, "{certified:?} {given:?}");
        }
    }
}
