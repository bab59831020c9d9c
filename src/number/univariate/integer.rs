//! Polynomials with integer coefficients, on which everything exact is decided.

use std::cmp::Ordering;

use rug::ops::NegAssign;
use rug::{Integer, Rational};

use super::Polynomial;
use crate::number::Exact;

/// Integer coefficients by ascending power; the last one is not zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct IntegerPolynomial(Vec<Integer>);

impl IntegerPolynomial {
    pub fn new(mut coefficients: Vec<Integer>) -> Self {
        while coefficients.last().is_some_and(Integer::is_zero) {
            coefficients.pop();
        }
        IntegerPolynomial(coefficients)
    }

    pub fn one() -> Self {
        IntegerPolynomial(vec![Integer::from(1)])
    }

    /// The rational content and the primitive part with a positive leading coefficient, of which
    /// the polynomial is the product; content 0 for the zero polynomial. `None` where a
    /// coefficient has no value.
    pub fn from_exact(polynomial: &Polynomial<Exact>) -> Option<(Rational, Self)> {
        let rationals: Vec<&Rational> = polynomial
            .coefficients()
            .iter()
            .map(|c| c.0.rational())
            .collect::<Option<_>>()?;
        if rationals.iter().all(|q| q.is_integer()) {
            let integers = rationals.iter().map(|q| q.numer().clone());
            let mut result = IntegerPolynomial::new(integers.collect());
            let content = result.make_primitive();
            return Some((content.into(), result));
        }
        let denominator = rationals
            .iter()
            .fold(Integer::from(1), |lcm, q| lcm.lcm(q.denom()));
        let integers = rationals
            .iter()
            .map(|q| Integer::from(&denominator / q.denom()) * q.numer())
            .collect();
        let mut result = IntegerPolynomial::new(integers);
        let content = result.make_primitive();
        Some((Rational::from((content, denominator)), result))
    }

    pub fn to_exact(&self) -> Polynomial<Exact> {
        Polynomial::from_rationals(self.0.iter().map(Rational::from))
    }

    pub fn coefficients(&self) -> &[Integer] {
        &self.0
    }

    pub fn into_coefficients(self) -> Vec<Integer> {
        self.0
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The degree; 0 for the zero polynomial too.
    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The leading coefficient; 0 for the zero polynomial.
    pub fn leading(&self) -> Integer {
        self.0.last().cloned().unwrap_or_default()
    }

    pub fn derivative(&self) -> Self {
        let powers = (0u32..).zip(&self.0).skip(1);
        Self::new(powers.map(|(power, c)| Integer::from(c * power)).collect())
    }

    pub fn negated(mut self) -> Self {
        self.0.iter_mut().for_each(Integer::neg_assign);
        self
    }

    pub fn minus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let mut difference = self.0.clone();
        difference.resize(length, Integer::new());
        for (place, c) in difference.iter_mut().zip(&other.0) {
            *place -= c;
        }
        Self::new(difference)
    }

    /// p(−x).
    pub fn mirrored(&self) -> Self {
        let mut result = self.clone();
        result
            .0
            .iter_mut()
            .skip(1)
            .step_by(2)
            .for_each(Integer::neg_assign);
        result
    }

    /// The greatest common divisor of the coefficients; 0 for the zero polynomial.
    fn content(&self) -> Integer {
        let mut content = Integer::new();
        for c in &self.0 {
            content.gcd_mut(c);
            if content == 1 {
                break;
            }
        }
        content
    }

    /// Divides by the content, taken with the sign of the leading coefficient, and returns it.
    pub fn make_primitive(&mut self) -> Integer {
        let mut content = self.content();
        if self.leading().cmp0().is_lt() {
            content.neg_assign();
        }
        self.divide_exactly_by(&content);
        content
    }

    /// Divides by the positive content, so that signs stay.
    pub fn without_content(mut self) -> Self {
        let content = self.content();
        self.divide_exactly_by(&content);
        self
    }

    /// Divides every coefficient by an integer that divides it; a divisor 0 changes nothing.
    pub fn divide_exactly_by(&mut self, divisor: &Integer) {
        if *divisor != 1 && !divisor.is_zero() {
            for c in &mut self.0 {
                c.div_exact_mut(divisor);
            }
        }
    }

    /// The remainder of lc(divisor)^(m − n + 1) · self by the divisor, for degrees m ≥ n and a
    /// divisor that is not zero.
    pub fn pseudo_remainder(&self, divisor: &Self) -> Self {
        let Some((leading, lower)) = divisor.0.split_last() else {
            return self.clone();
        };
        let mut rest = self.0.clone();
        while rest.len() > lower.len() {
            let Some(factor) = rest.pop() else { break };
            for c in &mut rest {
                *c *= leading;
            }
            for (place, c) in rest.iter_mut().rev().zip(lower.iter().rev()) {
                *place -= &factor * c;
            }
        }
        Self::new(rest)
    }

    /// The quotient by a divisor that is primitive and divides this.
    pub fn quotient(&self, divisor: &Self) -> Self {
        let Some((leading, lower)) = divisor.0.split_last() else {
            return self.clone();
        };
        let mut rest = self.0.clone();
        let mut quotient = Vec::new();
        while rest.len() > lower.len() {
            let Some(mut factor) = rest.pop() else { break };
            factor.div_exact_mut(leading);
            for (place, c) in rest.iter_mut().rev().zip(lower.iter().rev()) {
                *place -= &factor * c;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Self::new(quotient)
    }

    /// The sign of the value at a rational number.
    pub fn sign_at(&self, x: &Rational) -> Ordering {
        let (numerator, denominator) = (x.numer(), x.denom());
        let mut power = Integer::from(1);
        let mut value = Integer::new();
        for c in self.0.iter().rev() {
            value *= numerator;
            value += c * &power;
            power *= denominator;
        }
        value.cmp0()
    }

    /// The sign for x → ∞.
    pub fn sign_at_infinity(&self) -> Ordering {
        self.leading().cmp0()
    }
}
