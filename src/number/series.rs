//! Truncated power series over any kind; themselves a kind.

use std::cmp::Ordering;
use std::fmt;

use rug::Rational;

use super::{Kind, Number, Real, Truth};

/// a₀ + a₁ t + … + aₙ tⁿ, known up to terms in tⁿ⁺¹ and higher. A constant is known to every order; a
/// result is known to the lower order of its operands.
///
/// ```
/// use burmester::number::{Exact, Number, Series};
/// let t: Number<Series<Exact>> = Number::parameter(3);
/// let geometric = 1 / (1 - &t);
/// assert!(geometric.coefficient(3).equals(&1.into()).is_yes());
/// assert!((geometric * (1 - t)).equals(&1.into()).is_yes());
/// ```
#[derive(Clone, Debug)]
pub struct Series<K> {
    /// From a₀ on; what is left out is zero.
    coefficients: Vec<Number<K>>,
    /// n; `None` for a constant.
    order: Option<usize>,
}

impl<K: Kind> Number<Series<K>> {
    /// t, to terms in tⁿ.
    pub fn parameter(order: usize) -> Self {
        Self::from_coefficients([Number::zero(), Number::one()], order)
    }

    /// The series of these coefficients, from a₀ on, to terms in tⁿ.
    pub fn from_coefficients(
        coefficients: impl IntoIterator<Item = Number<K>>,
        order: usize,
    ) -> Self {
        Number(Series {
            coefficients: coefficients.into_iter().take(order + 1).collect(),
            order: Some(order),
        })
    }

    /// Coefficient of tʲ; zero beyond the order.
    pub fn coefficient(&self, j: usize) -> Number<K> {
        self.0.coefficient(j)
    }

    /// The series of other coefficients, each made from its own.
    pub fn map<L: Kind>(&self, convert: impl Fn(&Number<K>) -> Number<L>) -> Number<Series<L>> {
        Number(Series {
            coefficients: self.0.coefficients.iter().map(convert).collect(),
            order: self.0.order,
        })
    }

    /// n where terms in tⁿ are the last that are known; `None` for a constant.
    pub fn order(&self) -> Option<usize> {
        self.0.order
    }

    /// The derivative with respect to t; its order is less by one.
    pub fn derivative(&self) -> Self {
        let terms = (0_i64..).zip(&self.0.coefficients).skip(1);
        Number(Series {
            coefficients: terms.map(|(j, a)| j * a).collect(),
            order: self.0.order.map(|order| order.saturating_sub(1)),
        })
    }
}

impl<K: Kind> From<Number<K>> for Number<Series<K>> {
    fn from(constant: Number<K>) -> Self {
        Number(Series {
            coefficients: vec![constant],
            order: None,
        })
    }
}

impl<K: Kind> Series<K> {
    fn coefficient(&self, j: usize) -> Number<K> {
        self.coefficients
            .get(j)
            .cloned()
            .unwrap_or_else(Number::zero)
    }

    /// How many coefficients a result of this and another series has.
    fn meet(&mut self, other: &Self) {
        self.order = match (self.order, other.order) {
            (Some(order), Some(other)) => Some(order.min(other)),
            (order, other) => order.or(other),
        };
        self.coefficients.truncate(self.length());
    }

    fn length(&self) -> usize {
        self.order.map_or(1, |order| order + 1)
    }

    /// The coefficients of a result, each from its place and those before it.
    fn by_recursion(
        length: usize,
        next: impl Fn(usize, &[Number<K>]) -> Number<K>,
    ) -> Vec<Number<K>> {
        let mut coefficients = Vec::with_capacity(length);
        for j in 0..length {
            let coefficient = next(j, &coefficients);
            coefficients.push(coefficient);
        }
        coefficients
    }

    fn combine(&mut self, other: &Self, operate: impl Fn(&mut Number<K>, &Number<K>)) {
        self.meet(other);
        let length = self.length().min(other.coefficients.len());
        if self.coefficients.len() < length {
            self.coefficients.resize(length, Number::zero());
        }
        for (a, b) in self.coefficients.iter_mut().zip(&other.coefficients) {
            operate(a, b);
        }
    }
}

impl<K: Kind> Kind for Series<K> {
    const GENERIC: bool = K::GENERIC;
    const ROUNDS: bool = K::ROUNDS;

    fn constant(q: Rational) -> Self {
        Number::from(Number::<K>::from(q)).0
    }

    fn integer(i: i64) -> Self {
        Number::from(Number::<K>::from(i)).0
    }

    fn add(&mut self, other: &Self) {
        self.combine(other, |a, b| *a += b);
    }

    fn sub(&mut self, other: &Self) {
        self.combine(other, |a, b| *a -= b);
    }

    fn mul(&mut self, other: &Self) {
        let left = self.coefficients.clone();
        self.meet(other);
        let highest = (left.len() + other.coefficients.len()).saturating_sub(1);
        self.coefficients = (0..highest.min(self.length()))
            .map(|n| {
                let left = left.iter().take(n + 1).enumerate();
                left.filter_map(|(j, a)| Some(a * other.coefficients.get(n - j)?))
                    .sum()
            })
            .collect();
    }

    /// No value for a divisor without a constant term.
    fn div(&mut self, other: &Self) {
        let dividend = self.clone();
        self.meet(other);
        let divisor = other.coefficient(0);
        self.coefficients = Self::by_recursion(self.length(), |n, quotient| {
            let known = quotient.iter().enumerate();
            let known: Number<K> = known.map(|(j, q)| q * other.coefficient(n - j)).sum();
            (dividend.coefficient(n) - known) / &divisor
        });
    }

    fn negate(&mut self) {
        for a in &mut self.coefficients {
            a.0.negate();
        }
    }

    /// Whether all terms that are known vanish.
    fn is_zero(&self) -> Truth {
        Truth::all(self.coefficients.iter().map(Number::is_zero))
    }

    fn has_value(&self) -> bool {
        self.coefficients.iter().all(Number::has_value)
    }

    fn is_excessive(&self) -> bool {
        self.coefficients.iter().any(Number::is_excessive)
    }
}

/// Near t = 0: a series without a constant term has no sign that is the same on both sides.
impl<K: Real> Real for Series<K> {
    type Precision = K::Precision;

    fn rounded(q: &Rational, precision: &Self::Precision) -> Self {
        Number::from(Number::<K>::rounded(q, precision)).0
    }

    fn sign(&self) -> Option<Ordering> {
        match self.coefficient(0).sign()? {
            Ordering::Equal if !self.is_zero().is_yes() => None,
            sign => Some(sign),
        }
    }

    /// No value for a series that is not zero and has no constant term.
    fn sqrt(&mut self) {
        if self.is_zero().is_yes() {
            return;
        }
        let first = self.coefficient(0).sqrt();
        let radicand = self.clone();
        self.coefficients = Self::by_recursion(self.length(), |n, root| {
            if n == 0 {
                return first.clone();
            }
            let inner = (1..n).filter_map(|j| Some(root.get(j)? * root.get(n - j)?));
            (radicand.coefficient(n) - inner.sum::<Number<K>>()) / (2 * &first)
        });
    }

    fn cos_sin_of_degrees(q: &Rational, precision: &Self::Precision) -> Option<(Self, Self)> {
        let (cos, sin) = K::cos_sin_of_degrees(q, precision)?;
        Some((Number::from(Number(cos)).0, Number::from(Number(sin)).0))
    }
}

impl<K: fmt::Display> fmt::Display for Series<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (j, a) in self.coefficients.iter().enumerate() {
            match j {
                0 => write!(f, "({a})")?,
                _ => write!(f, " + ({a}) t^{j}")?,
            }
        }
        match self.order {
            Some(order) => write!(f, " + O(t^{})", order + 1),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{Complex, Exact};

    type S = Number<Series<Exact>>;

    fn series(coefficients: &[i64], order: usize) -> S {
        Number::from_coefficients(coefficients.iter().map(|&a| Number::from(a)), order)
    }

    fn is(found: &S, coefficients: &[i64]) -> bool {
        let expected = series(coefficients, coefficients.len() - 1);
        found.order() == expected.order() && found.equals(&expected).is_yes()
    }

    #[test]
    fn a_product_is_cut_at_the_lower_order() {
        let product = series(&[1, 2, 3, 4], 3) * series(&[1, -1, 5], 2);
        assert!(is(&product, &[1, 1, 6]));
        assert!(is(
            &(series(&[1, 2], 4) + series(&[0, 0, 7], 2)),
            &[1, 2, 7]
        ));
    }

    #[test]
    fn constants_are_known_to_every_order() {
        let t: S = Number::parameter(2);
        assert!(is(&(3 + &t), &[3, 1, 0]));
        assert!(is(&(2 * &t), &[0, 2, 0]));
        assert!(is(&(1 - S::from(5) * &t), &[1, -5, 0]));
        assert_eq!((S::from(5) / 3).order(), None);
    }

    #[test]
    fn a_quotient_needs_a_constant_term_below() {
        assert!(is(&(1 / (1 - S::parameter(4))), &[1, 1, 1, 1, 1]));
        assert!(!(S::one() / S::parameter(4)).has_value());
        assert!(!(S::parameter(3) / S::parameter(4)).has_value());
    }

    #[test]
    fn a_root_needs_a_positive_constant_term() {
        let root = (1 - 4 * S::parameter(4)).sqrt();
        // 1 − 2 Σ Cₙ tⁿ⁺¹ with the numbers of Catalan.
        assert!(is(&root, &[1, -2, -2, -4, -10]));
        assert!(!(S::parameter(3) - 1).sqrt().has_value());
        assert!(!S::parameter(3).sqrt().has_value());
        assert!(S::zero().sqrt().is_zero().is_yes());
    }

    #[test]
    fn the_sign_is_that_on_both_sides() {
        let t = S::parameter(2);
        assert_eq!((1 + &t).sign(), Some(Ordering::Greater));
        assert_eq!((&t - 1).sign(), Some(Ordering::Less));
        assert_eq!(t.sign(), None);
        assert_eq!((&t - &t).sign(), Some(Ordering::Equal));
        assert!(t.is_zero().is_no());
        assert!(t.power(3).is_zero().is_yes());
    }

    #[test]
    fn the_derivative_of_a_quotient() {
        let (f, g) = (series(&[2, 5, 1, 3], 3), series(&[3, 0, 7, -1], 3));
        let quotient = (&f / &g).derivative();
        let rule = (f.derivative() * &g - &f * g.derivative()) / g.square();
        assert!(quotient.equals(&rule).is_yes() && quotient.order() == Some(2));
    }

    #[test]
    fn they_nest_with_complex_numbers() {
        let t: Number<Complex<Series<Exact>>> = Number::<Series<Exact>>::parameter(4).into();
        let turn = (1 + Number::i() * &t) / (1 - Number::i() * &t);
        assert!(turn.norm().equals(&1.into()).is_yes());
    }
}
