//! A square-free factor over ℤ, as the roots see it: signs, values in balls, Newton steps.

use std::cmp::Ordering;

use rug::Rational;

use super::Polynomial;
use super::integer::IntegerPolynomial;
use super::polish::Approximate;
use crate::number::{Ball, Complex, Number};

/// Bits with which a sign is tried before it is computed exactly.
const SIGN_BITS: [u32; 3] = [128, 512, 2048];

#[derive(Debug)]
pub(super) struct Factor {
    polynomial: IntegerPolynomial,
    derivative: IntegerPolynomial,
    approximate: Approximate,
}

/// What interval Newton finds.
pub(super) struct NewtonStep {
    /// m − p(m)/p′(X), which holds every root that X holds; `None` where p′(X) may hold 0.
    pub ball: Option<Ball>,
    /// Whether rounding errors hide the sign at m: more precision may help.
    pub is_noise: bool,
}

impl Factor {
    pub fn new(polynomial: IntegerPolynomial) -> Self {
        let derivative = polynomial.derivative();
        Factor {
            approximate: Approximate::of_integers(&polynomial),
            polynomial,
            derivative,
        }
    }

    pub fn polynomial(&self) -> &IntegerPolynomial {
        &self.polynomial
    }

    /// For proposals.
    pub fn approximate(&self) -> &Approximate {
        &self.approximate
    }

    pub fn degree(&self) -> usize {
        self.polynomial.degree()
    }

    /// The sign at a rational number, in balls where those can tell.
    pub fn sign_at(&self, x: &Rational) -> Ordering {
        SIGN_BITS
            .into_iter()
            .find_map(|bits| {
                let point = Number::<Ball>::rounded(x, &bits);
                in_balls(&self.polynomial, bits).evaluate(&point).sign()
            })
            .unwrap_or_else(|| self.polynomial.sign_at(x))
    }

    /// One step of interval Newton from a point m of an interval X.
    pub fn newton(&self, middle: &Rational, around: &Number<Ball>, bits: u32) -> NewtonStep {
        let derivative = in_balls(&self.derivative, bits);
        let middle = Number::<Ball>::rounded(middle, &bits);
        let slope = derivative.evaluate(around);
        if !slope.is_zero().is_no() {
            return NewtonStep {
                ball: None,
                is_noise: derivative.evaluate(&middle).sign().is_none(),
            };
        }
        let value = in_balls(&self.polynomial, bits).evaluate(&middle);
        NewtonStep {
            is_noise: value.sign().is_none(),
            ball: Some((middle - value / slope).0),
        }
    }

    /// p(z).
    pub fn value(&self, z: &Number<Complex<Ball>>, bits: u32) -> Number<Complex<Ball>> {
        in_balls(&self.polynomial, bits).evaluate_complex(z)
    }

    /// p′(z).
    pub fn slope(&self, z: &Number<Complex<Ball>>, bits: u32) -> Number<Complex<Ball>> {
        in_balls(&self.derivative, bits).evaluate_complex(z)
    }

    /// The polynomial in balls of so many bits.
    pub fn in_balls(&self, bits: u32) -> Polynomial<Ball> {
        in_balls(&self.polynomial, bits)
    }

    /// The derivative in balls of so many bits.
    pub fn slope_in_balls(&self, bits: u32) -> Polynomial<Ball> {
        in_balls(&self.derivative, bits)
    }
}

fn in_balls(p: &IntegerPolynomial, bits: u32) -> Polynomial<Ball> {
    let coefficients = p.coefficients().iter();
    Polynomial::new(
        coefficients
            .map(|c| Number(Ball::of_integer(c, bits)))
            .collect(),
    )
}

/// A lower bound of log₂ q for q > 0, at most 2 too small; the least number for q = 0.
pub(super) fn log2_below(q: &Rational) -> i64 {
    if q.is_zero() {
        return i64::MIN / 4;
    }
    let bits = |i: &rug::Integer| i64::from(i.significant_bits());
    bits(q.numer()) - bits(q.denom()) - 1
}

/// An upper bound of log₂ q for q > 0, at most 2 too large.
pub(super) fn log2_above(q: &Rational) -> i64 {
    log2_below(q) + 2
}
