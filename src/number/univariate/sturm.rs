//! Sturm sequences: how many different real roots an interval holds.

use std::cmp::Ordering;

use rug::Rational;

use super::integer::IntegerPolynomial;

/// The Sturm sequence of a polynomial over ℚ.
///
/// It is that of the square-free part, so that an end of an interval may be a multiple root; each
/// member is known up to a positive factor.
#[derive(Clone, Debug)]
pub struct SturmSequence {
    members: Vec<IntegerPolynomial>,
}

impl SturmSequence {
    /// Of a square-free polynomial that is not zero.
    pub(super) fn new(p: &IntegerPolynomial) -> Self {
        let mut members = vec![p.clone()];
        let mut next = p.derivative().without_content();
        while !next.is_zero() {
            let remainder = members
                .last()
                .map(|last| negative_remainder(last, &next))
                .unwrap_or_else(|| IntegerPolynomial::new(Vec::new()));
            members.push(next);
            next = remainder;
        }
        SturmSequence { members }
    }

    /// The number of different real roots.
    pub fn count(&self) -> usize {
        let below = variations(self.members.iter().map(|p| p.mirrored().sign_at_infinity()));
        below - variations(self.members.iter().map(IntegerPolynomial::sign_at_infinity))
    }

    /// The number of different real roots in (low, high], 0 unless low < high. Multiple roots count
    /// once, also where an end is one.
    pub fn count_between(&self, low: &Rational, high: &Rational) -> usize {
        self.count_above(low).saturating_sub(self.count_above(high))
    }

    /// The number of different real roots greater than `low`.
    pub fn count_above(&self, low: &Rational) -> usize {
        let at_infinity = variations(self.members.iter().map(IntegerPolynomial::sign_at_infinity));
        self.variations_at(low) - at_infinity
    }

    fn variations_at(&self, x: &Rational) -> usize {
        variations(self.members.iter().map(|p| p.sign_at(x)))
    }
}

/// −(a mod b) up to a positive factor, for deg a ≥ deg b.
fn negative_remainder(a: &IntegerPolynomial, b: &IntegerPolynomial) -> IntegerPolynomial {
    let remainder = a.pseudo_remainder(b).without_content();
    let power_is_odd = (a.degree() - b.degree()).is_multiple_of(2);
    if power_is_odd && b.leading().cmp0().is_lt() {
        remainder
    } else {
        remainder.negated()
    }
}

/// How often the sign changes, zeros left out.
pub(super) fn variations(signs: impl Iterator<Item = Ordering>) -> usize {
    let mut last = Ordering::Equal;
    let mut changes = 0;
    for sign in signs.filter(|sign| sign.is_ne()) {
        if last == sign.reverse() {
            changes += 1;
        }
        last = sign;
    }
    changes
}
