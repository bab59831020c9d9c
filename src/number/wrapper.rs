//! [`Number`]: any kind with operators, written once.

use std::cmp::Ordering;
use std::fmt;
use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use rug::Rational;

use super::{Elementary, Kind, Real, Truth};

/// A number of kind `K`, with the operators `+ − * /` between owned and borrowed numbers and
/// integers on either side.
///
/// ```
/// use burmester::number::{Exact, Kind, Number};
/// fn allievi<K: Kind>(t: &Number<K>, sum: &Number<K>, product: &Number<K>) -> Number<K> {
///     t * t - sum * t + product
/// }
/// let [t, s, p] = [2, 5, 6].map(Number::<Exact>::from);
/// assert!(allievi(&t, &s, &p).is_zero().is_yes());
/// ```
#[derive(Clone)]
pub struct Number<K>(pub K);

impl<K: Kind> Number<K> {
    /// 0.
    pub fn zero() -> Self {
        Number(K::integer(0))
    }

    /// 1.
    pub fn one() -> Self {
        Number(K::integer(1))
    }

    /// The rational number `numerator / denominator`; no value for a zero denominator.
    pub fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::from(numerator) / denominator
    }

    /// Whether this is zero.
    pub fn is_zero(&self) -> Truth {
        self.0.is_zero()
    }

    /// Whether the two are equal.
    pub fn equals(&self, other: &Self) -> Truth {
        (self - other).is_zero()
    }

    /// `false` for the result of an operation that is not defined.
    pub fn has_value(&self) -> bool {
        self.0.has_value()
    }

    /// x².
    pub fn square(&self) -> Self {
        self * self
    }

    /// Whether the number is so large that a few more products would exhaust time or memory.
    pub fn is_excessive(&self) -> bool {
        self.0.is_excessive()
    }

    /// 1/x; no value for zero.
    pub fn inverse(&self) -> Self {
        1 / self
    }

    /// xⁿ by repeated squaring; 1 for n = 0, no value for 0 with a negative n and where the squares on
    /// the way become [excessive](Kind::is_excessive).
    pub fn power(&self, n: i32) -> Self {
        let mut base = if n < 0 { self.inverse() } else { self.clone() };
        let mut result = Self::one();
        let mut left = n.unsigned_abs();
        while left > 0 {
            if left & 1 == 1 {
                result *= &base;
            }
            left >>= 1;
            if left > 0 {
                if base.is_excessive() {
                    return Self::one() / Self::zero();
                }
                base = base.square();
            }
        }
        result
    }
}

impl<K: Real> Number<K> {
    /// The rational number `q` as a number of this precision.
    pub fn rounded(q: &Rational, precision: &K::Precision) -> Self {
        Number(K::rounded(q, precision))
    }

    /// The sign, `None` where it cannot be told.
    pub fn sign(&self) -> Option<Ordering> {
        self.0.sign()
    }

    /// Whether this is greater than zero.
    pub fn is_positive(&self) -> Truth {
        Truth::of_sign(self.sign(), Ordering::is_gt)
    }

    /// The order of the two, `None` where it cannot be told.
    pub fn compare(&self, other: &Self) -> Option<Ordering> {
        (self - other).sign()
    }

    /// The square root that is not negative; no value for a negative number.
    pub fn sqrt(mut self) -> Self {
        self.0.sqrt();
        self
    }

    /// |x|; where the sign cannot be told, √x².
    pub fn abs(&self) -> Self {
        match self.sign() {
            Some(Ordering::Less) => -self,
            Some(_) => self.clone(),
            None => self.square().sqrt(),
        }
    }
}

/// Names the elementary functions on numbers after those on kinds.
macro_rules! elementary {
    ($($name:ident: $doc:literal),* $(,)?) => {
        impl<K: Elementary> Number<K> {
            /// π to this precision.
            pub fn pi(precision: &K::Precision) -> Self {
                Number(K::pi(precision))
            }
            $(#[doc = $doc] pub fn $name(mut self) -> Self {
                self.0.$name();
                self
            })*
            /// The angle of the direction (x, y) in (−π, π], where `self` is y.
            pub fn atan2(mut self, x: &Self) -> Self {
                self.0.atan2(&x.0);
                self
            }
        }
    };
}

elementary! {
    sin: "sin of an angle in radians.",
    cos: "cos of an angle in radians.",
    tan: "tan of an angle in radians; no value at a pole.",
    asin: "arcsin in [−π/2, π/2].",
    acos: "arccos in [0, π].",
    atan: "arctan in (−π/2, π/2).",
}

impl<K: Kind> From<i64> for Number<K> {
    fn from(i: i64) -> Self {
        Number(K::integer(i))
    }
}

impl<K: Kind> From<Rational> for Number<K> {
    fn from(q: Rational) -> Self {
        Number(K::constant(q))
    }
}

impl<K: fmt::Debug> fmt::Debug for Number<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<K: fmt::Display> fmt::Display for Number<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// All forms of one operator. `$fresh` computes `a ∘ b` into a new number, `$reversed` into an owned `b`.
macro_rules! operator {
    ($op:ident, $method:ident, $assign_op:ident, $assign:ident, $fresh:ident, $reversed:expr) => {
        impl<K: Kind> $assign_op<&Number<K>> for Number<K> {
            #[inline]
            fn $assign(&mut self, other: &Number<K>) {
                self.0.$method(&other.0);
            }
        }
        impl<K: Kind> $assign_op for Number<K> {
            #[inline]
            fn $assign(&mut self, other: Number<K>) {
                self.0.$method(&other.0);
            }
        }
        impl<K: Kind> $op<&Number<K>> for Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(mut self, other: &Number<K>) -> Number<K> {
                self.0.$method(&other.0);
                self
            }
        }
        impl<K: Kind> $op for Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(mut self, other: Number<K>) -> Number<K> {
                self.0.$method(&other.0);
                self
            }
        }
        impl<K: Kind> $op<&Number<K>> for &Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(self, other: &Number<K>) -> Number<K> {
                Number(self.0.$fresh(&other.0))
            }
        }
        impl<K: Kind> $op<Number<K>> for &Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(self, other: Number<K>) -> Number<K> {
                let reversed: fn(&K, K) -> K = $reversed;
                Number(reversed(&self.0, other.0))
            }
        }
        impl<K: Kind> $op<i64> for Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(mut self, other: i64) -> Number<K> {
                self.0.$method(&K::integer(other));
                self
            }
        }
        impl<K: Kind> $op<i64> for &Number<K> {
            type Output = Number<K>;
            #[inline]
            fn $method(self, other: i64) -> Number<K> {
                Number(self.0.$fresh(&K::integer(other)))
            }
        }
        impl<K: Kind> $op<Number<K>> for i64 {
            type Output = Number<K>;
            #[inline]
            fn $method(self, other: Number<K>) -> Number<K> {
                $op::$method(&Number(K::integer(self)), other)
            }
        }
        impl<K: Kind> $op<&Number<K>> for i64 {
            type Output = Number<K>;
            #[inline]
            fn $method(self, other: &Number<K>) -> Number<K> {
                Number(K::integer(self).$fresh(&other.0))
            }
        }
    };
}

operator!(Add, add, AddAssign, add_assign, plus, |a, mut b| {
    b.add(a);
    b
});
operator!(Sub, sub, SubAssign, sub_assign, minus, |a, mut b| {
    b.sub(a);
    b.negate();
    b
});
operator!(Mul, mul, MulAssign, mul_assign, times, |a, mut b| {
    b.mul(a);
    b
});
operator!(Div, div, DivAssign, div_assign, over, |a, b| a.over(&b));

impl<K: Kind> Neg for Number<K> {
    type Output = Number<K>;
    #[inline]
    fn neg(mut self) -> Number<K> {
        self.0.negate();
        self
    }
}

impl<K: Kind> Neg for &Number<K> {
    type Output = Number<K>;
    #[inline]
    fn neg(self) -> Number<K> {
        -self.clone()
    }
}

impl<K: Kind> Sum for Number<K> {
    fn sum<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers
            .reduce(|sum, number| sum + number)
            .unwrap_or_else(Self::zero)
    }
}

impl<K: Kind> Product for Number<K> {
    fn product<I: Iterator<Item = Self>>(numbers: I) -> Self {
        numbers
            .reduce(|product, number| product * number)
            .unwrap_or_else(Self::one)
    }
}
