//! Integers that are machine words until they must grow.

use std::cmp::Ordering;

use rug::Integer;

/// An integer; `Big` only where it does not fit `Small`, so equality is that of the parts.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Coefficient {
    Small(i64),
    Big(Integer),
}

use Coefficient::{Big, Small};

impl Coefficient {
    pub const ZERO: Self = Small(0);
    pub const ONE: Self = Small(1);

    pub fn to_integer(&self) -> Integer {
        match self {
            Small(i) => Integer::from(*i),
            Big(z) => z.clone(),
        }
    }

    pub fn bits(&self) -> u32 {
        match self {
            Small(_) => i64::BITS,
            Big(z) => z.significant_bits(),
        }
    }

    pub fn sign(&self) -> Ordering {
        match self {
            Small(i) => i.cmp(&0),
            Big(z) => z.cmp0(),
        }
    }

    pub fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }

    pub fn is_one(&self) -> bool {
        *self == Self::ONE
    }

    pub fn add(&self, other: &Self) -> Self {
        if let (Small(a), Small(b)) = (self, other) {
            return (i128::from(*a) + i128::from(*b)).into();
        }
        (self.to_integer() + other.to_integer()).into()
    }

    pub fn mul(&self, other: &Self) -> Self {
        if let (Small(a), Small(b)) = (self, other) {
            return (i128::from(*a) * i128::from(*b)).into();
        }
        (self.to_integer() * other.to_integer()).into()
    }

    /// `self + a·b`, in place.
    pub fn add_product(&mut self, a: &Self, b: &Self) {
        if let (Small(sum), Small(a), Small(b)) = (&*self, a, b) {
            // |a·b| ≤ 2^126, so the sum cannot leave i128.
            *self = (i128::from(*sum) + i128::from(*a) * i128::from(*b)).into();
            return;
        }
        let mut sum = self.take_integer();
        match (a, b) {
            (Big(a), Big(b)) => sum += a * b,
            (Big(big), Small(small)) | (Small(small), Big(big)) => sum += big * *small,
            (Small(a), Small(b)) => sum += i128::from(*a) * i128::from(*b),
        }
        *self = sum.into();
    }

    /// `self − a·b`, in place.
    pub fn sub_product(&mut self, a: &Self, b: &Self) {
        if let (Small(difference), Small(a), Small(b)) = (&*self, a, b) {
            // As above.
            *self = (i128::from(*difference) - i128::from(*a) * i128::from(*b)).into();
            return;
        }
        let mut difference = self.take_integer();
        match (a, b) {
            (Big(a), Big(b)) => difference -= a * b,
            (Big(big), Small(small)) | (Small(small), Big(big)) => difference -= big * *small,
            (Small(a), Small(b)) => difference -= i128::from(*a) * i128::from(*b),
        }
        *self = difference.into();
    }

    /// The value, which another will take the place of.
    fn take_integer(&mut self) -> Integer {
        match std::mem::replace(self, Self::ZERO) {
            Small(i) => i.into(),
            Big(z) => z,
        }
    }

    pub fn negated(&self) -> Self {
        match self {
            Small(i) => (-i128::from(*i)).into(),
            Big(z) => Integer::from(-z).into(),
        }
    }

    pub fn abs(&self) -> Self {
        if self.sign().is_lt() {
            self.negated()
        } else {
            self.clone()
        }
    }

    /// The quotient where it is an integer; `None` also for a zero divisor.
    pub fn divide_exactly(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return None;
        }
        if let (Small(a), Small(b)) = (self, divisor)
            && let (Some(quotient), Some(remainder)) = (a.checked_div(*b), a.checked_rem(*b))
        {
            return (remainder == 0).then_some(Small(quotient));
        }
        let (a, b) = (self.to_integer(), divisor.to_integer());
        a.is_divisible(&b).then(|| a.div_exact(&b).into())
    }

    /// The greatest common divisor, not negative; zero only for two zeros.
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Small(a), Small(b)) = (self, other) {
            let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
            while b != 0 {
                (a, b) = (b, a % b);
            }
            return i128::from(a).into();
        }
        self.to_integer().gcd(&other.to_integer()).into()
    }

    /// The root that is not negative, where it is an integer.
    pub fn sqrt(&self) -> Option<Self> {
        let z = self.to_integer();
        z.is_perfect_square().then(|| z.sqrt().into())
    }

    /// The remainder in `0..modulus`.
    pub fn modulo(&self, modulus: u64) -> u64 {
        match self {
            Small(i) => match i.unsigned_abs() % modulus {
                remainder if *i < 0 && remainder > 0 => modulus - remainder,
                remainder => remainder,
            },
            Big(z) => z.mod_u64(modulus),
        }
    }
}

trait ModuloWord {
    fn mod_u64(&self, modulus: u64) -> u64;
}

impl ModuloWord for Integer {
    fn mod_u64(&self, modulus: u64) -> u64 {
        let (_, remainder) = self.clone().div_rem_euc(Integer::from(modulus));
        remainder.to_u64_wrapping()
    }
}

impl From<i128> for Coefficient {
    fn from(i: i128) -> Self {
        i64::try_from(i).map_or_else(|_| Big(Integer::from(i)), Small)
    }
}

impl From<Integer> for Coefficient {
    fn from(z: Integer) -> Self {
        z.to_i64().map_or(Big(z), Small)
    }
}
