//! [`Poly`]: polynomials with integer coefficients, in normal form.

use rug::ops::Pow;
use rug::{Integer, Rational};

use super::coefficient::Coefficient;
use super::monomial::Monomial;
use super::ring::Ring;
use super::terms::{self, Term};
use super::{Fraction, root};

/// A polynomial with integer coefficients in the variables of a [`Ring`], in normal form by its
/// relations; a constant belongs to every ring.
///
/// An operation gives `None` between different rings (see [`Ring`]), where an exponent exceeds 127,
/// and where the result would have more than two million terms.
#[derive(Clone)]
pub struct Poly {
    ring: Option<Ring>,
    terms: Vec<Term>,
}

impl Poly {
    /// Terms that are in normal form already.
    fn new(ring: Option<&Ring>, terms: Vec<Term>) -> Poly {
        let constant = terms.iter().all(|(monomial, _)| *monomial == Monomial::ONE);
        let ring = if constant { None } else { ring.cloned() };
        Poly { ring, terms }
    }

    pub(super) fn of_coefficient(coefficient: Coefficient) -> Poly {
        let terms = if coefficient.is_zero() {
            Vec::new()
        } else {
            vec![(Monomial::ONE, coefficient)]
        };
        Poly { ring: None, terms }
    }

    /// The variable of this index; `None` beyond the last.
    pub fn variable(ring: &Ring, index: usize) -> Option<Poly> {
        ring.variable(index)?;
        Some(Self::new(
            Some(ring),
            vec![(Monomial::power(index, 1)?, Coefficient::ONE)],
        ))
    }

    /// The ring; `None` for a constant.
    pub fn ring(&self) -> Option<&Ring> {
        self.ring.as_ref()
    }

    /// Terms in free variables; `None` where they are in no normal form.
    pub(super) fn of_terms(ring: Option<&Ring>, terms: Vec<Term>) -> Option<Poly> {
        let reducible = |ring: &Ring| terms.iter().any(|(m, _)| m.meets(ring.reducible()));
        (!ring.is_some_and(reducible)).then(|| Self::new(ring, terms))
    }

    pub(super) fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// How many terms there are.
    pub fn number_of_terms(&self) -> usize {
        self.terms.len()
    }

    /// Whether this is identically zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value of a constant; `None` where a variable occurs.
    pub fn constant(&self) -> Option<Integer> {
        self.as_coefficient().map(|c| c.to_integer())
    }

    pub(super) fn as_coefficient(&self) -> Option<Coefficient> {
        match self.terms.as_slice() {
            [] => Some(Coefficient::ZERO),
            [(Monomial::ONE, coefficient)] => Some(coefficient.clone()),
            _ => None,
        }
    }

    /// The sum.
    pub fn add(&self, other: &Poly) -> Option<Poly> {
        let ring = Ring::joined(self.ring(), other.ring())?;
        Some(Self::new(ring, terms::add(&self.terms, &other.terms)?))
    }

    /// The difference.
    pub fn sub(&self, other: &Poly) -> Option<Poly> {
        let ring = Ring::joined(self.ring(), other.ring())?;
        Some(Self::new(ring, terms::sub(&self.terms, &other.terms)?))
    }

    /// The product.
    pub fn mul(&self, other: &Poly) -> Option<Poly> {
        let ring = Ring::joined(self.ring(), other.ring())?;
        Self::reduced(ring, terms::multiply(&self.terms, &other.terms)?)
    }

    /// The polynomial with every coefficient negated.
    pub fn negated(&self) -> Poly {
        self.scaled(&Coefficient::Small(-1))
    }

    pub(super) fn scaled(&self, factor: &Coefficient) -> Poly {
        if factor.is_one() {
            return self.clone();
        }
        Self::new(self.ring(), terms::scale(&self.terms, factor))
    }

    /// selfⁿ.
    pub fn power(&self, n: u32) -> Option<Poly> {
        let mut result = Poly::from(1);
        for _ in 0..n {
            result = result.mul(self)?;
        }
        Some(result)
    }

    /// The normal form of any polynomial: relations are applied from the latest variable to the
    /// earliest, because each brings in earlier variables only.
    fn reduced(ring: Option<&Ring>, mut terms: Vec<Term>) -> Option<Poly> {
        if let Some(ring) = ring {
            for (variable, square) in ring.relations().rev() {
                if !terms
                    .iter()
                    .any(|(monomial, _)| monomial.meets(ring.reducible()))
                {
                    break;
                }
                terms = replace_square(terms, variable, &square.terms)?;
            }
        }
        Some(Self::new(ring, terms))
    }

    /// The quotient where it is a polynomial with integer coefficients; `None` also for a zero
    /// divisor.
    pub fn divide_exactly(&self, divisor: &Poly) -> Option<Poly> {
        let ring = Ring::joined(self.ring(), divisor.ring())?;
        if divisor.latest_related().is_none() {
            // Without related variables in the divisor, the quotient's normal form times the
            // divisor is a normal form: division of free polynomials is complete.
            return Some(Self::new(ring, terms::divide(&self.terms, &divisor.terms)?));
        }
        let conjugate = divisor.conjugate()?;
        self.mul(&conjugate)?
            .divide_exactly(&divisor.mul(&conjugate)?)
    }

    /// The greatest common divisor of the coefficients; 0 for the zero polynomial.
    pub fn content(&self) -> Integer {
        terms::content(&self.terms).to_integer()
    }

    /// The polynomial divided by its content, with positive leading coefficient.
    pub fn primitive_part(&self) -> Poly {
        self.split_content().1
    }

    /// Content with the sign of the leading coefficient, and the primitive part; (0, 0) for zero.
    pub(super) fn split_content(&self) -> (Coefficient, Poly) {
        let Some((_, lead)) = self.terms.first() else {
            return (Coefficient::ZERO, self.clone());
        };
        let mut content = terms::content(&self.terms);
        if lead.sign().is_lt() {
            content = content.negated();
        }
        // The content divides every coefficient, so this is never the fallback.
        let primitive = self
            .divided_by_integer(&content)
            .unwrap_or_else(|| self.clone());
        (content, primitive)
    }

    pub(super) fn divided_by_integer(&self, divisor: &Coefficient) -> Option<Poly> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        let terms = terms::divide(&self.terms, &[(Monomial::ONE, divisor.clone())])?;
        Some(Self::new(self.ring(), terms))
    }

    /// The greatest power product that divides every term, and the quotient.
    pub(super) fn split_monomial(&self) -> (Monomial, Poly) {
        let common = terms::common_monomial(&self.terms);
        if common == Monomial::ONE {
            return (common, self.clone());
        }
        match terms::divide(&self.terms, &[(common, Coefficient::ONE)]) {
            Some(terms) => (common, Self::new(self.ring(), terms)),
            // Unreachable, as the common power product divides; and right in any case.
            None => (Monomial::ONE, self.clone()),
        }
    }

    /// The latest variable with a relation that occurs.
    pub(super) fn latest_related(&self) -> Option<usize> {
        let ring = self.ring()?;
        let latest = self
            .terms
            .iter()
            .map(|(monomial, _)| monomial)
            .find(|m| m.meets(ring.related()));
        latest?;
        let degrees = terms::degrees(&self.terms);
        ring.relations()
            .rev()
            .map(|(i, _)| i)
            .find(|&i| degrees.exponent(i) > 0)
    }

    /// With y → −y for the latest variable with a relation; `None` where there is none. The product
    /// of the two is a polynomial in earlier variables.
    pub(super) fn conjugate(&self) -> Option<Poly> {
        let variable = self.latest_related()?;
        let terms = self
            .terms
            .iter()
            .map(|(monomial, c)| match monomial.exponent(variable) {
                0 => (*monomial, c.clone()),
                _ => (*monomial, c.negated()),
            });
        Some(Self::new(self.ring(), terms.collect()))
    }

    /// The polynomial root with positive leading coefficient, where this is a square modulo the
    /// relations and one root is a polynomial with integer coefficients; `None` otherwise.
    pub fn sqrt(&self) -> Option<Poly> {
        let root = match self.ring() {
            Some(ring) => root::square_root(&Fraction::from(self.clone()), ring)??,
            None => Fraction::from(Self::of_coefficient(self.as_coefficient()?.sqrt()?)),
        };
        let root = root.polynomial()?.clone();
        Some(
            if root.terms.first().is_some_and(|term| term.1.sign().is_lt()) {
                root.negated()
            } else {
                root
            },
        )
    }

    /// The value at rational values of the variables, in their order. `None` where there are fewer
    /// values than variables that occur. That the values satisfy the relations is up to the caller.
    pub fn evaluate(&self, values: &[Rational]) -> Option<Rational> {
        let mut sum = Rational::new();
        for (monomial, coefficient) in &self.terms {
            let mut product = Rational::from(coefficient.to_integer());
            for (variable, exponent) in monomial.powers() {
                product *= Rational::from(values.get(variable)?.pow(u32::from(exponent)));
            }
            sum += product;
        }
        Some(sum)
    }

    /// The largest exponent of the variable of this index (at most 1 where it has a relation).
    pub fn degree_in(&self, variable: usize) -> u8 {
        terms::degrees(&self.terms).exponent(variable)
    }

    /// The coefficient of a power of the variable of this index: a polynomial in the others.
    pub fn coefficient_of(&self, variable: usize, power: u8) -> Poly {
        let terms = self
            .terms
            .iter()
            .filter(|(monomial, _)| monomial.exponent(variable) == power);
        let terms = terms.map(|(monomial, c)| (monomial.without(variable), c.clone()));
        Self::new(self.ring(), terms.collect())
    }

    /// This with a polynomial in the place of a variable. The relations stay as they are: where the
    /// variable occurs in one, the result is that of the normal form.
    pub fn substitute(&self, variable: usize, value: &Poly) -> Option<Poly> {
        let mut result = Poly::from(0);
        for power in (0..=self.degree_in(variable)).rev() {
            result = result
                .mul(value)?
                .add(&self.coefficient_of(variable, power))?;
        }
        Some(result)
    }
}

/// Replaces the square of a variable, wherever it is a factor.
fn replace_square(terms: Vec<Term>, variable: usize, square: &[Term]) -> Option<Vec<Term>> {
    let highest = terms
        .iter()
        .map(|(monomial, _)| monomial.exponent(variable))
        .max()
        .unwrap_or(0);
    if highest < 2 {
        return Some(terms);
    }
    // Grouped by the power of the square; a group stays sorted when that power is taken out.
    let mut groups = vec![Vec::new(); usize::from(highest / 2) + 1];
    for (monomial, coefficient) in terms {
        let exponent = monomial.exponent(variable);
        let left = monomial
            .without(variable)
            .times(&Monomial::power(variable, exponent % 2)?)?;
        let group = groups.get_mut(usize::from(exponent / 2))?;
        group.push((left, coefficient));
    }
    let mut result = Vec::new();
    for group in groups.into_iter().rev() {
        result = terms::add(&terms::multiply(&result, square)?, &group)?;
    }
    Some(result)
}

/// Equal as polynomials; two constants are equal in whatever ring.
impl PartialEq for Poly {
    fn eq(&self, other: &Poly) -> bool {
        self.terms == other.terms && Ring::joined(self.ring(), other.ring()).is_some()
    }
}

impl Eq for Poly {}

impl From<i64> for Poly {
    fn from(i: i64) -> Poly {
        Self::of_coefficient(Coefficient::Small(i))
    }
}

impl From<Integer> for Poly {
    fn from(z: Integer) -> Poly {
        Self::of_coefficient(z.into())
    }
}
