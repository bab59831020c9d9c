//! Bare constants: exact rationals without a precision, small integers without an allocation.

use std::cmp::Ordering;

use rug::{Rational, ops::NegAssign};

use crate::number::exact::rational_sqrt;

/// An exact rational number. Integers that fit a machine word are always kept as such.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Constant {
    Integer(i64),
    Rational(Rational),
}

use Constant::Integer;

impl From<Rational> for Constant {
    fn from(q: Rational) -> Constant {
        match (q.is_integer(), q.numer().to_i64()) {
            (true, Some(i)) => Integer(i),
            _ => Constant::Rational(q),
        }
    }
}

impl Constant {
    pub fn to_rational(&self) -> Rational {
        match self {
            Integer(i) => Rational::from(*i),
            Constant::Rational(q) => q.clone(),
        }
    }

    pub fn sign(&self) -> Ordering {
        match self {
            Integer(i) => i.cmp(&0),
            Constant::Rational(q) => q.cmp0(),
        }
    }

    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    pub fn add(&mut self, other: &Constant) {
        self.combine(other, i64::checked_add, |a, b| *a += b);
    }

    pub fn sub(&mut self, other: &Constant) {
        self.combine(other, i64::checked_sub, |a, b| *a -= b);
    }

    pub fn mul(&mut self, other: &Constant) {
        self.combine(other, i64::checked_mul, |a, b| *a *= b);
    }

    /// The divisor is not 0.
    pub fn div(&mut self, other: &Constant) {
        let whole = |a: i64, b: i64| (a.checked_rem(b)? == 0).then_some(a / b);
        self.combine(other, whole, |a, b| *a /= b);
    }

    pub fn negate(&mut self) {
        match self {
            Integer(i) if *i != i64::MIN => *i = -*i,
            _ => {
                let mut q = self.to_rational();
                q.neg_assign();
                *self = q.into();
            }
        }
    }

    /// The root where it is rational; the number is not negative.
    pub fn sqrt(&self) -> Option<Constant> {
        rational_sqrt(self.to_rational()).map(Constant::from)
    }

    fn combine(
        &mut self,
        other: &Constant,
        small: impl FnOnce(i64, i64) -> Option<i64>,
        large: impl FnOnce(&mut Rational, &Rational),
    ) {
        if let (Integer(a), Integer(b)) = (&*self, other)
            && let Some(result) = small(*a, *b)
        {
            *self = Integer(result);
            return;
        }
        let mut q = self.to_rational();
        match other {
            Integer(b) => large(&mut q, &Rational::from(*b)),
            Constant::Rational(b) => large(&mut q, b),
        }
        *self = q.into();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn machine_integers_overflow_into_rationals_and_back() {
        let mut c = Integer(i64::MAX);
        c.add(&Integer(1));
        assert_eq!(c.to_rational(), Rational::from(1u64 << 63));
        c.negate();
        assert_eq!(c, Integer(i64::MIN));
        c.div(&Integer(-1));
        assert_eq!(c.to_rational(), Rational::from(1u64 << 63));
        c.div(&Integer(3));
        c.mul(&Integer(3));
        c.sub(&Integer(1));
        assert_eq!(c, Integer(i64::MAX));
    }
}
