//! [`Fraction`]: quotients of polynomials, a number kind.

use std::cmp::Ordering;
use std::fmt;

use rug::Rational;

use super::coefficient::Coefficient;
use super::denominator::{Denominator, Shared, insert, multiplied};
use super::polynomial::Poly;
use super::ring::Ring;
use super::{root, sign};
use crate::number::kind::{EXCESSIVE_BITS, EXCESSIVE_TERMS};
use crate::number::{Kind, Number, Real, Truth, degrees};

/// A fraction of polynomials with the relations of its [`Ring`]; or no value.
///
/// A fraction is zero exactly if the normal form of its numerator is: since a ring has no zero
/// divisors, `is_zero` is never unknown. It means *identically* zero; a number that is not may
/// still vanish for some values of the variables, and so may a divisor. In the same sense
/// [`sign`](Real::sign) answers for all values for which the number is defined and not zero.
///
/// Denominators are lists of factors free of related variables, kept small by trial division. They
/// are not unique; numerators and denominators may have common factors left.
///
/// No value: after a division by what is identically zero, between different rings, beyond exponent
/// 127 or two million terms, and for roots that the ring does not hold.
#[derive(Clone)]
pub struct Fraction(Option<Value>);

#[derive(Clone)]
pub(super) struct Value {
    pub numerator: Poly,
    pub denominator: Denominator,
}

impl Value {
    fn new(mut numerator: Poly, mut denominator: Denominator) -> Value {
        denominator.cancel(&mut numerator);
        Value {
            numerator,
            denominator,
        }
    }

    /// The longer ring of numerator and denominator, of which one is a prefix of the other.
    pub fn ring(&self) -> Option<&Ring> {
        let rings = [self.numerator.ring(), self.denominator.ring()];
        rings.into_iter().flatten().max_by_key(|ring| ring.len())
    }

    fn combined(
        &self,
        other: &Value,
        sign: impl Fn(&Poly, &Poly) -> Option<Poly>,
    ) -> Option<Value> {
        Ring::joined(self.ring(), other.ring())?;
        let shared = self.denominator.shared(&other.denominator);
        let (a, b) = (&self.denominator.content, &other.denominator.content);
        let common = a.gcd(b);
        let (to_a, to_b) = (b.divide_exactly(&common)?, a.divide_exactly(&common)?);
        // Each numerator by what its denominator lacks.
        let left = multiplied(&self.numerator.scaled(&to_a), &shared, |[own, other]| {
            other.saturating_sub(own)
        })?;
        let right = multiplied(&other.numerator.scaled(&to_b), &shared, |[other, own]| {
            other.saturating_sub(own)
        })?;
        let content = a.mul(&to_a);
        let denominator = Denominator::from_shared(content, shared, |[a, b]| a.max(b));
        Some(Value::new(sign(&left, &right)?, denominator))
    }

    fn product(&self, other: &Value) -> Option<Value> {
        Ring::joined(self.ring(), other.ring())?;
        let mut shared = self.denominator.shared(&other.denominator);
        let (mut left, mut right) = (self.numerator.clone(), other.numerator.clone());
        for Shared {
            factor,
            multiplicity: [in_left, in_right],
        } in &mut shared
        {
            *in_right -= factor.take_out(&mut left, *in_right);
            *in_left -= factor.take_out(&mut right, *in_left);
        }
        let content = self.denominator.content.mul(&other.denominator.content);
        let denominator = Denominator::from_shared(content, shared, |[a, b]| a + b);
        Some(Value::new(left.mul(&right)?, denominator))
    }

    fn quotient(&self, other: &Value) -> Option<Value> {
        Ring::joined(self.ring(), other.ring())?;
        let shared = self.denominator.shared(&other.denominator);
        let mut divisor = Divisor {
            multiplier: Poly::from(1),
            content: Coefficient::ONE,
            shared,
        };
        divisor.split(&other.numerator)?;
        let Divisor {
            multiplier,
            content,
            mut shared,
        } = divisor;
        let mut numerator = self.numerator.scaled(&other.denominator.content);
        if content.sign().is_lt() {
            numerator = numerator.negated();
        }
        // Index 0 counts what divides, index 1 what multiplies.
        for Shared {
            factor,
            multiplicity: [below, above],
        } in &mut shared
        {
            let both = (*below).min(*above);
            *below -= both;
            *above -= both;
            *below -= factor.take_out(&mut numerator, *below);
        }
        numerator = multiplied(&numerator, &shared, |[_, above]| above)?.mul(&multiplier)?;
        let content = self.denominator.content.mul(&content.abs());
        let denominator = Denominator::from_shared(content, shared, |[below, _]| below);
        Some(Value::new(numerator, denominator))
    }
}

/// The reciprocal of a polynomial as it is taken apart: `multiplier / (content · ∏ factors)`, the
/// factors counted at index 0 of a list that also holds others.
struct Divisor {
    multiplier: Poly,
    /// Not zero, of any sign.
    content: Coefficient,
    shared: Vec<Shared>,
}

impl Divisor {
    /// Divides by one more polynomial; `None` for zero.
    fn split(&mut self, divisor: &Poly) -> Option<()> {
        let mut left = divisor.clone();
        loop {
            if left.is_zero() {
                return None;
            }
            left = self.split_known(left)?;
            if left.as_coefficient().is_some() {
                return Some(());
            }
            let Some(conjugate) = left.conjugate() else {
                break;
            };
            self.multiplier = self.multiplier.mul(&conjugate)?;
            left = left.mul(&conjugate)?;
        }
        match left.sqrt_of_free() {
            Some(root) => insert(&mut self.shared, root, [2, 0]),
            None => insert(&mut self.shared, left, [1, 0]),
        }
        Some(())
    }

    /// Splits off content, powers of variables and known factors.
    fn split_known(&mut self, poly: Poly) -> Option<Poly> {
        let (content, left) = poly.split_content();
        self.content = self.content.mul(&content);
        let (monomial, mut left) = left.split_monomial();
        let ring = poly.ring().cloned();
        for (index, exponent) in monomial.powers() {
            let variable = Poly::variable(ring.as_ref()?, index)?;
            match ring.as_ref()?.variable(index)?.square() {
                // 1/y = y/y²; the exponent is 1, as that of a normal form.
                Some(square) => {
                    self.multiplier = self.multiplier.mul(&variable)?;
                    self.split(square)?;
                }
                None => insert(&mut self.shared, variable, [u32::from(exponent), 0]),
            }
        }
        for shared in &mut self.shared {
            shared.multiplicity[0] += shared.factor.take_out(&mut left, u32::MAX);
        }
        // A factor has a positive leading coefficient and is primitive, and so is what is left.
        Some(left)
    }
}

impl Fraction {
    pub(super) fn value(&self) -> Option<&Value> {
        self.0.as_ref()
    }

    pub(super) fn of_value(numerator: Poly, denominator: Denominator) -> Fraction {
        Fraction(Some(Value::new(numerator, denominator)))
    }

    /// The fraction that stands for an undefined operation.
    pub fn no_value() -> Fraction {
        Fraction(None)
    }

    /// The longest ring that is needed to write this; `None` for constants and without a value.
    pub fn ring(&self) -> Option<&Ring> {
        self.0.as_ref()?.ring()
    }

    /// The numerator; `None` without a value.
    pub fn numerator(&self) -> Option<&Poly> {
        self.0.as_ref().map(|value| &value.numerator)
    }

    /// The denominator, multiplied out. `None` without a value and where it is too large.
    pub fn denominator(&self) -> Option<Poly> {
        let denominator = &self.0.as_ref()?.denominator;
        let mut product = Poly::of_coefficient(denominator.content.clone());
        for (factor, multiplicity) in &denominator.factors {
            product = product.mul(&factor.poly().power(*multiplicity)?)?;
        }
        Some(product)
    }

    /// The polynomial that this is; `None` where the denominator is not 1.
    pub fn polynomial(&self) -> Option<&Poly> {
        let value = self.0.as_ref()?;
        let integral = value.denominator.content.is_one() && value.denominator.factors.is_empty();
        integral.then_some(&value.numerator)
    }

    /// How many terms the numerator and all factors of the denominator have together.
    pub fn number_of_terms(&self) -> usize {
        self.0.as_ref().map_or(0, |value| {
            let factors = value.denominator.factors.iter();
            let below = factors.map(|(factor, _)| factor.poly().number_of_terms());
            value.numerator.number_of_terms() + below.sum::<usize>()
        })
    }

    /// The value at rational values of the variables, in their order. `None` without a value, where
    /// the denominator vanishes there, and where there are too few values. That they satisfy the
    /// relations is up to the caller.
    pub fn evaluate(&self, values: &[Rational]) -> Option<Rational> {
        let value = self.0.as_ref()?;
        let mut result = value.numerator.evaluate(values)?;
        result /= value.denominator.content.to_integer();
        for (factor, multiplicity) in &value.denominator.factors {
            let divisor = factor.poly().evaluate(values)?;
            if divisor.is_zero() {
                return None;
            }
            for _ in 0..*multiplicity {
                result /= &divisor;
            }
        }
        Some(result)
    }

    /// A square root of `radicand` as a new number.
    ///
    /// The ring of the radicand is extended by a variable of this name whose square is a polynomial
    /// f, such that radicand = f/g² for a product g of known factors; the result is that variable
    /// divided by g. Where the sign of g can be told, the variable is known to be positive and the
    /// result is the root that is not negative. Where it cannot, the variable carries the sign of
    /// g, and nothing is known of the sign of either.
    ///
    /// Nothing is adjoined for a radicand that is a square already: the result is then the root
    /// that is not negative where its sign can be told, and no value otherwise (both signs of the
    /// root are in the ring, and no choice between them holds for all values). No value also for
    /// a radicand known to be negative, for a name that is taken and for more than 32 variables.
    ///
    /// Two roots that are to meet must be adjoined one after the other: adjoin the second with
    /// [`Fraction::adjoin_root_in`] to the ring of the first.
    pub fn adjoin_root(name: &str, radicand: &Number<Fraction>) -> Number<Fraction> {
        let ring = radicand.0.ring().cloned().unwrap_or_else(Ring::empty);
        Self::adjoin_root_in(&ring, name, radicand)
    }

    /// [`Fraction::adjoin_root`], extending `ring`, in which the radicand must lie.
    pub fn adjoin_root_in(
        ring: &Ring,
        name: &str,
        radicand: &Number<Fraction>,
    ) -> Number<Fraction> {
        Number(root::adjoin(ring, name, &radicand.0).unwrap_or(Fraction(None)))
    }

    fn combine(&mut self, other: &Self, operate: impl FnOnce(&Value, &Value) -> Option<Value>) {
        self.0 = match (&self.0, &other.0) {
            (Some(a), Some(b)) => operate(a, b),
            _ => None,
        };
    }
}

impl Number<Fraction> {
    /// The variable of this index; no value beyond the last.
    pub fn variable(ring: &Ring, index: usize) -> Self {
        Number(Poly::variable(ring, index).map_or(Fraction(None), Fraction::from))
    }

    /// The variable of this name; no value where there is none.
    pub fn named(ring: &Ring, name: &str) -> Self {
        ring.position(name)
            .map_or(Number(Fraction(None)), |index| Self::variable(ring, index))
    }
}

impl From<Poly> for Fraction {
    fn from(numerator: Poly) -> Fraction {
        Fraction(Some(Value {
            numerator,
            denominator: Denominator::one(),
        }))
    }
}

impl From<Poly> for Number<Fraction> {
    fn from(numerator: Poly) -> Self {
        Number(numerator.into())
    }
}

impl Kind for Fraction {
    const GENERIC: bool = true;

    fn constant(q: Rational) -> Self {
        let (numerator, content) = q.into_numer_denom();
        let denominator = Denominator {
            content: content.into(),
            factors: Vec::new(),
        };
        Fraction(Some(Value {
            numerator: numerator.into(),
            denominator,
        }))
    }

    fn integer(i: i64) -> Self {
        Poly::from(i).into()
    }

    fn add(&mut self, other: &Self) {
        self.combine(other, |a, b| a.combined(b, Poly::add));
    }

    fn sub(&mut self, other: &Self) {
        self.combine(other, |a, b| a.combined(b, Poly::sub));
    }

    fn mul(&mut self, other: &Self) {
        self.combine(other, Value::product);
    }

    fn div(&mut self, other: &Self) {
        self.combine(other, Value::quotient);
    }

    fn negate(&mut self) {
        if let Some(value) = &mut self.0 {
            value.numerator = value.numerator.negated();
        }
    }

    /// Whether this is identically zero.
    fn is_zero(&self) -> Truth {
        self.0
            .as_ref()
            .map_or(Truth::Unknown, |value| value.numerator.is_zero().into())
    }

    fn has_value(&self) -> bool {
        self.0.is_some()
    }

    fn is_excessive(&self) -> bool {
        self.number_of_terms() > EXCESSIVE_TERMS
            || self.0.as_ref().is_some_and(|value| {
                let terms = value.numerator.terms().iter();
                let factors = value.denominator.factors.iter();
                let below = factors.flat_map(|(factor, _)| factor.poly().terms());
                let largest = terms
                    .chain(below)
                    .map(|(_, coefficient)| coefficient.bits())
                    .max();
                largest.unwrap_or(0).max(value.denominator.content.bits()) > EXCESSIVE_BITS
            })
    }
}

impl Real for Fraction {
    type Precision = ();

    fn rounded(q: &Rational, (): &()) -> Self {
        Self::constant(q.clone())
    }

    /// Equal where this is identically zero; another sign where inspection shows it for all values
    /// for which this is defined and not zero: from signs of coefficients, even powers, squares and
    /// variables known to be positive. `None` says nothing.
    fn sign(&self) -> Option<Ordering> {
        sign::of_value(self.0.as_ref()?)
    }

    /// No value where this is no square or the sign of the root cannot be told; roots of others are
    /// adjoined by [`Fraction::adjoin_root`].
    fn sqrt(&mut self) {
        *self = root::not_negative(self).unwrap_or(Fraction(None));
    }

    /// Multiples of 90° only.
    fn cos_sin_of_degrees(q: &Rational, (): &()) -> Option<(Self, Self)> {
        let quarter = degrees::quarter_turns(q)?;
        let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
        Some((Self::integer(cos), Self::integer(sin)))
    }
}

impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
