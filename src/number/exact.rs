//! Exact rational numbers.

use std::cmp::Ordering;
use std::fmt;

use rug::ops::NegAssign;
use rug::{Integer, Rational};

use super::kind::EXCESSIVE_BITS;
use super::{Complex, Kind, Number, Real, Truth, degrees};

/// A rational number of any size: for decisions and for random exact instances.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exact(Option<Rational>);

impl Exact {
    /// The rational number, `None` after an undefined operation.
    pub fn rational(&self) -> Option<&Rational> {
        self.0.as_ref()
    }

    fn combine(&mut self, other: &Self, operate: impl FnOnce(&mut Rational, &Rational)) {
        match (&mut self.0, &other.0) {
            (Some(a), Some(b)) => operate(a, b),
            _ => self.0 = None,
        }
    }

    /// The same with a quicker way for two integers.
    fn combine_in_ring(
        &mut self,
        other: &Self,
        integers: impl FnOnce(&mut Integer, &Integer),
        operate: impl FnOnce(&mut Rational, &Rational),
    ) {
        self.combine(other, |a, b| {
            if a.is_integer() && b.is_integer() {
                #[expect(
                    unsafe_code,
                    reason = "with the denominator 1 any numerator is in lowest terms"
                )]
                let numerator = unsafe { a.as_mut_numer_denom_no_canonicalization().0 };
                integers(numerator, b.numer());
            } else {
                operate(a, b);
            }
        });
    }
}

impl Number<Exact> {
    /// The same number in another kind that holds it exactly.
    pub fn in_kind<K: Kind>(&self) -> Number<K> {
        let q = self.0.rational();
        q.map_or_else(|| Number::zero().inverse(), |q| Number::from(q.clone()))
    }
}

impl Number<Complex<Exact>> {
    /// The same number in another kind that holds it exactly.
    pub fn in_kind<K: Kind>(&self) -> Number<Complex<K>> {
        Number::complex(self.re().in_kind(), self.im().in_kind())
    }
}

impl Kind for Exact {
    fn constant(q: Rational) -> Self {
        Exact(Some(q))
    }

    fn add(&mut self, other: &Self) {
        self.combine_in_ring(other, |a, b| *a += b, |a, b| *a += b);
    }

    fn sub(&mut self, other: &Self) {
        self.combine_in_ring(other, |a, b| *a -= b, |a, b| *a -= b);
    }

    fn mul(&mut self, other: &Self) {
        self.combine_in_ring(other, |a, b| *a *= b, |a, b| *a *= b);
    }

    fn div(&mut self, other: &Self) {
        if other.is_zero().is_yes() {
            self.0 = None;
        } else {
            self.combine(other, |a, b| *a /= b);
        }
    }

    fn negate(&mut self) {
        if let Some(q) = &mut self.0 {
            q.neg_assign();
        }
    }

    fn times(&self, other: &Self) -> Self {
        Exact(match (&self.0, &other.0) {
            (Some(a), Some(b)) if a.is_integer() && b.is_integer() => {
                Some(Rational::from(Integer::from(a.numer() * b.numer())))
            }
            (Some(a), Some(b)) => Some(Rational::from(a * b)),
            _ => None,
        })
    }

    fn common_denominator<'a>(numbers: impl Iterator<Item = &'a Self>) -> Option<Self> {
        let mut common = Integer::from(1);
        for Exact(number) in numbers {
            common.lcm_mut(number.as_ref()?.denom());
        }
        (common != 1).then(|| Exact(Some(common.into())))
    }

    fn is_zero(&self) -> Truth {
        Truth::of_sign(self.sign(), Ordering::is_eq)
    }

    fn has_value(&self) -> bool {
        self.0.is_some()
    }

    fn is_excessive(&self) -> bool {
        self.0.as_ref().is_some_and(|q| bits(q) > EXCESSIVE_BITS)
    }
}

/// Bits of numerator and denominator together.
pub(in crate::number) fn bits(q: &Rational) -> u32 {
    q.numer()
        .significant_bits()
        .saturating_add(q.denom().significant_bits())
}

impl Real for Exact {
    type Precision = ();

    fn rounded(q: &Rational, (): &()) -> Self {
        Exact(Some(q.clone()))
    }

    fn sign(&self) -> Option<Ordering> {
        self.0.as_ref().map(Rational::cmp0)
    }

    /// No value where the root is irrational.
    fn sqrt(&mut self) {
        self.0 = self.0.take().and_then(rational_sqrt);
    }

    /// Multiples of 90° only.
    fn cos_sin_of_degrees(q: &Rational, (): &()) -> Option<(Self, Self)> {
        let quarter = degrees::quarter_turns(q)?;
        let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
        Some((Self::integer(cos), Self::integer(sin)))
    }
}

/// √q where it is rational.
pub fn rational_sqrt(q: Rational) -> Option<Rational> {
    let (numerator, denominator) = q.into_numer_denom();
    (numerator.is_perfect_square() && denominator.is_perfect_square())
        .then(|| Rational::from((numerator.sqrt(), denominator.sqrt())))
}

/// The primitive integers in the same ratio, the first that is not zero positive.
pub fn primitive(list: &[Rational]) -> Vec<Integer> {
    let denominator = list
        .iter()
        .fold(Integer::from(1), |lcm, q| lcm.lcm(q.denom()));
    let integers: Vec<Integer> = list
        .iter()
        .map(|q| q.numer() * Integer::from(&denominator / q.denom()))
        .collect();
    primitive_integers(integers)
}

/// The same of integers.
pub fn primitive_integers(mut integers: Vec<Integer>) -> Vec<Integer> {
    divide_by_content(&mut integers);
    let first = integers.iter().find(|integer| !integer.is_zero());
    if first.is_some_and(|integer| integer.cmp0().is_lt()) {
        integers.iter_mut().for_each(NegAssign::neg_assign);
    }
    integers
}

/// Each by the greatest common divisor of all.
pub fn divide_by_content(integers: &mut [Integer]) {
    let content = content(integers);
    if content > 1 {
        for integer in integers {
            integer.div_exact_mut(&content);
        }
    }
}

/// The greatest common divisor; 0 of zeros.
fn content(integers: &[Integer]) -> Integer {
    let Some(first) = integers.iter().find(|integer| !integer.is_zero()) else {
        return Integer::new();
    };
    // That of one of them and a mixture of all is a multiple of it, and as a rule it.
    let mut mixture = Integer::new();
    for (factor, integer) in (1u32..).step_by(2).zip(integers) {
        mixture += integer * factor;
    }
    let mixed = mixture.gcd(first);
    if integers.iter().all(|integer| integer.is_divisible(&mixed)) {
        return mixed;
    }
    (integers.iter()).fold(mixed, |gcd, integer| gcd.gcd(integer))
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Some(q) => q.fmt(f),
            None => f.write_str("no value"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contents_are_divided_out() {
        let lists = [
            vec![0, 0],
            vec![0, -6, 9],
            vec![12, 18, -30],
            // 1·3 + 3·1 is a multiple of 3, and 1 is none.
            vec![3, 1],
            vec![7],
        ];
        let primitive = [
            vec![0, 0],
            vec![0, 2, -3],
            vec![2, 3, -5],
            vec![3, 1],
            vec![1],
        ];
        for (list, primitive) in lists.into_iter().zip(primitive) {
            let list: Vec<Integer> = list.into_iter().map(Integer::from).collect();
            assert_eq!(primitive_integers(list.clone()), primitive, "{list:?}");
        }
    }
}
