//! [`Polynomial`]: dense coefficients over any kind.

use std::fmt;

use rug::Rational;

use crate::number::{Complex, Kind, Number};

/// A polynomial in one variable, with numbers of kind `K` as coefficients.
///
/// Leading coefficients that are surely zero are dropped. One that merely may be zero (a ball that
/// holds it) stays, so that over such kinds the degree is an upper bound.
#[derive(Clone, Debug)]
pub struct Polynomial<K> {
    /// By ascending power; the last one, if any, is not surely zero.
    coefficients: Vec<Number<K>>,
}

impl<K: Kind> Polynomial<K> {
    /// The polynomial with these coefficients, the constant one first.
    pub fn new(mut coefficients: Vec<Number<K>>) -> Self {
        while coefficients
            .last()
            .is_some_and(|leading| leading.is_zero().is_yes())
        {
            coefficients.pop();
        }
        Polynomial { coefficients }
    }

    /// The polynomial with these integers as coefficients, the constant one first.
    pub fn from_integers(coefficients: &[i64]) -> Self {
        Self::new(coefficients.iter().map(|&i| i.into()).collect())
    }

    /// The polynomial with these rational numbers as coefficients, the constant one first.
    pub fn from_rationals(coefficients: impl IntoIterator<Item = Rational>) -> Self {
        Self::new(coefficients.into_iter().map(Number::from).collect())
    }

    /// 0.
    pub fn zero() -> Self {
        Polynomial {
            coefficients: Vec::new(),
        }
    }

    /// A polynomial of degree 0.
    pub fn constant(value: Number<K>) -> Self {
        Self::new(vec![value])
    }

    /// The variable itself.
    pub fn variable() -> Self {
        Self::from_integers(&[0, 1])
    }

    /// x − root.
    pub fn linear(root: &Number<K>) -> Self {
        Self::new(vec![-root, Number::one()])
    }

    /// The coefficients by ascending power; none for the zero polynomial.
    pub fn coefficients(&self) -> &[Number<K>] {
        &self.coefficients
    }

    /// The coefficient of a power; zero beyond the degree.
    pub fn coefficient(&self, power: usize) -> Number<K> {
        self.coefficients
            .get(power)
            .cloned()
            .unwrap_or_else(Number::zero)
    }

    /// The degree, an upper bound of it where it cannot be told whether the leading coefficient
    /// vanishes; `None` for the zero polynomial.
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// The leading coefficient; `None` for the zero polynomial.
    pub fn leading(&self) -> Option<&Number<K>> {
        self.coefficients.last()
    }

    /// Whether this is the zero polynomial for sure.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at x, by Horner's rule.
    pub fn evaluate(&self, x: &Number<K>) -> Number<K> {
        let mut coefficients = self.coefficients.iter().rev();
        let Some(leading) = coefficients.next() else {
            return Number::zero();
        };
        coefficients.fold(leading.clone(), |value, coefficient| {
            value * x + coefficient
        })
    }

    /// The value at a complex number, by Horner's rule.
    pub fn evaluate_complex(&self, z: &Number<Complex<K>>) -> Number<Complex<K>> {
        let mut coefficients = self.coefficients.iter().rev();
        let Some(leading) = coefficients.next() else {
            return Number::zero();
        };
        let start = Number::complex(leading.clone(), Number::zero());
        coefficients.fold(start, |value, coefficient| {
            let mut next = value * z;
            next.0.re += coefficient;
            next
        })
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let powers = (0i64..).zip(&self.coefficients).skip(1);
        Self::new(powers.map(|(power, c)| c * power).collect())
    }

    /// p(x + by), by repeated Horner steps.
    #[expect(clippy::indexing_slicing, reason = "every place has one above it")]
    pub fn shifted(&self, by: &Number<K>) -> Self {
        let mut coefficients = self.coefficients.clone();
        let length = coefficients.len();
        for first in 0..length {
            for place in (first..length.saturating_sub(1)).rev() {
                let above = &coefficients[place + 1] * by;
                coefficients[place] += above;
            }
        }
        Self::new(coefficients)
    }

    /// p(factor · x).
    pub fn stretched(&self, factor: &Number<K>) -> Self {
        let mut power = Number::one();
        let mut coefficients = Vec::with_capacity(self.coefficients.len());
        for coefficient in &self.coefficients {
            coefficients.push(coefficient * &power);
            power *= factor;
        }
        Self::new(coefficients)
    }

    /// factor · p(x).
    pub fn scaled(&self, factor: &Number<K>) -> Self {
        Self::new(self.coefficients.iter().map(|c| c * factor).collect())
    }

    /// xⁿ p(1/x) for the degree n: the same coefficients in reverse order.
    pub fn reversed(&self) -> Self {
        Self::new(self.coefficients.iter().rev().cloned().collect())
    }

    /// The n-th power; 1 for n = 0.
    pub fn power(&self, n: u32) -> Self {
        (0..n).fold(Self::from_integers(&[1]), |power, _| &power * self)
    }

    /// The same polynomial over another kind, each coefficient converted.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Polynomial<L> {
        Polynomial::new(self.coefficients.iter().map(convert).collect())
    }
}

impl<K: fmt::Display> fmt::Display for Polynomial<K> {
    /// `(c0) + (c1) x + (c2) x^2 …`, and `0`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.coefficients.is_empty() {
            return f.write_str("0");
        }
        for (power, coefficient) in self.coefficients.iter().enumerate() {
            match power {
                0 => write!(f, "({coefficient})")?,
                1 => write!(f, " + ({coefficient}) x")?,
                _ => write!(f, " + ({coefficient}) x^{power}")?,
            }
        }
        Ok(())
    }
}
