//! Complex numbers over any kind; themselves a kind.

use std::fmt;

use rug::Rational;

use super::{Kind, Number, Truth};

/// `re + i·im`.
#[derive(Clone, Debug)]
pub struct Complex<K> {
    /// Real part.
    pub re: Number<K>,
    /// Imaginary part.
    pub im: Number<K>,
}

impl<K: Kind> Complex<K> {
    /// |z|² = z·z̄.
    pub fn norm(&self) -> Number<K> {
        self.re.square() + self.im.square()
    }
}

impl<K: Kind> Number<Complex<K>> {
    /// `re + i·im`.
    pub fn complex(re: Number<K>, im: Number<K>) -> Self {
        Number(Complex { re, im })
    }

    /// The imaginary unit.
    pub fn i() -> Self {
        Self::complex(Number::zero(), Number::one())
    }

    /// Real part.
    pub fn re(&self) -> &Number<K> {
        &self.0.re
    }

    /// Imaginary part.
    pub fn im(&self) -> &Number<K> {
        &self.0.im
    }

    /// The conjugate z̄ = re − i·im.
    pub fn conj(&self) -> Self {
        Self::complex(self.re().clone(), -self.im())
    }

    /// |z|² = z·z̄.
    pub fn norm(&self) -> Number<K> {
        self.0.norm()
    }

    /// This times a real number.
    pub fn scaled(&self, factor: &Number<K>) -> Self {
        Self::complex(self.re() * factor, self.im() * factor)
    }
}

impl<K: Kind> From<Number<K>> for Number<Complex<K>> {
    fn from(re: Number<K>) -> Self {
        Self::complex(re, Number::zero())
    }
}

impl<K: Kind> Kind for Complex<K> {
    const GENERIC: bool = K::GENERIC;
    const ROUNDS: bool = K::ROUNDS;

    fn constant(q: Rational) -> Self {
        Complex {
            re: q.into(),
            im: Number::zero(),
        }
    }

    fn integer(i: i64) -> Self {
        Complex {
            re: i.into(),
            im: Number::zero(),
        }
    }

    fn add(&mut self, other: &Self) {
        self.re += &other.re;
        self.im += &other.im;
    }

    fn sub(&mut self, other: &Self) {
        self.re -= &other.re;
        self.im -= &other.im;
    }

    fn mul(&mut self, other: &Self) {
        *self = self.times(other);
    }

    fn div(&mut self, other: &Self) {
        let norm = other.norm();
        let re = (&self.re * &other.re + &self.im * &other.im) / &norm;
        self.im = (&self.im * &other.re - &self.re * &other.im) / &norm;
        self.re = re;
    }

    fn plus(&self, other: &Self) -> Self {
        Complex {
            re: &self.re + &other.re,
            im: &self.im + &other.im,
        }
    }

    fn minus(&self, other: &Self) -> Self {
        Complex {
            re: &self.re - &other.re,
            im: &self.im - &other.im,
        }
    }

    fn times(&self, other: &Self) -> Self {
        Complex {
            re: &self.re * &other.re - &self.im * &other.im,
            im: &self.re * &other.im + &self.im * &other.re,
        }
    }

    fn negate(&mut self) {
        self.re.0.negate();
        self.im.0.negate();
    }

    fn is_zero(&self) -> Truth {
        self.re.is_zero() & self.im.is_zero()
    }

    fn has_value(&self) -> bool {
        self.re.has_value() && self.im.has_value()
    }

    fn is_excessive(&self) -> bool {
        self.re.is_excessive() || self.im.is_excessive()
    }
}

impl<K: fmt::Display> fmt::Display for Complex<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}) + ({}) i", self.re, self.im)
    }
}
