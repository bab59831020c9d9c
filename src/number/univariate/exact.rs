//! What is decided exactly of polynomials over ℚ.

use std::cmp::Ordering;

use rug::Rational;

use super::integer::IntegerPolynomial;
use super::{Polynomial, SturmSequence, chain, square_free, sturm};
use crate::number::{Exact, Number, count};

/// Where a coefficient has no value, these have none either.
impl Polynomial<Exact> {
    /// The rational number with the sign of the leading coefficient by which this must be divided
    /// to become primitive; 0 for the zero polynomial.
    pub fn content(&self) -> Option<Rational> {
        IntegerPolynomial::from_exact(self).map(|(content, _)| content)
    }

    /// The multiple of this with integer coefficients that have no common divisor, the leading one
    /// positive; the zero polynomial is its own.
    pub fn primitive_part(&self) -> Option<Self> {
        IntegerPolynomial::from_exact(self).map(|(_, primitive)| primitive.to_exact())
    }

    /// The greatest common divisor, primitive; of two zero polynomials zero.
    pub fn gcd(&self, other: &Self) -> Option<Self> {
        let (_, a) = IntegerPolynomial::from_exact(self)?;
        let (_, b) = IntegerPolynomial::from_exact(other)?;
        Some(chain::gcd(&a, &b).to_exact())
    }

    /// Primitive square-free polynomials of positive degree without common roots, each with the
    /// multiplicity that its roots have in this; by ascending multiplicity. None for a constant;
    /// `None` for the zero polynomial.
    pub fn square_free_factors(&self) -> Option<Vec<(Self, usize)>> {
        let (_, primitive) = self.not_zero()?;
        let factors = square_free::decompose(&primitive).into_iter();
        Some(
            factors
                .map(|(factor, multiplicity)| (factor.to_exact(), multiplicity))
                .collect(),
        )
    }

    /// The primitive polynomial with the same roots, all of them simple. `None` for the zero
    /// polynomial.
    pub fn square_free_part(&self) -> Option<Self> {
        let (_, primitive) = self.not_zero()?;
        let repeated = chain::gcd(&primitive, &primitive.derivative());
        Some(primitive.quotient(&repeated).to_exact())
    }

    /// The resultant: lc(p)ⁿ lc(q)ᵐ times the product of the differences of the roots of p and of
    /// q, of degrees m and n. With a zero polynomial it is 0, except for a constant partner, where
    /// there is no value.
    pub fn resultant(&self, other: &Self) -> Number<Exact> {
        self.resultant_if_defined(other)
            .map_or_else(no_value, Number::from)
    }

    fn resultant_if_defined(&self, other: &Self) -> Option<Rational> {
        let (content_a, a) = IntegerPolynomial::from_exact(self)?;
        let (content_b, b) = IntegerPolynomial::from_exact(other)?;
        if a.is_zero() || b.is_zero() {
            return (a.degree() + b.degree() > 0).then(Rational::new);
        }
        let outside = power(&content_a, b.degree()) * power(&content_b, a.degree());
        Some(outside * chain::resultant(&a, &b))
    }

    /// The discriminant: lc(p)²ⁿ⁻² times the product of the squared differences of the n roots. No
    /// value for constants.
    pub fn discriminant(&self) -> Number<Exact> {
        let (Some(degree @ 1..), Some(leading)) = (self.degree(), self.leading()) else {
            return no_value();
        };
        let result = if degree == 1 {
            Number::one()
        } else {
            self.resultant(&self.derivative()) / leading
        };
        if degree % 4 > 1 { -result } else { result }
    }

    /// The Sturm sequence. `None` for the zero polynomial.
    pub fn sturm_sequence(&self) -> Option<SturmSequence> {
        // Of the square-free part, so that ends of intervals may be multiple roots.
        let (_, square_free) = self.square_free_part()?.not_zero()?;
        Some(SturmSequence::new(&square_free))
    }

    /// The sign variations of the coefficients: by Descartes' rule the number of positive roots
    /// with their multiplicities, or greater than that by an even number. `None` for the zero
    /// polynomial.
    pub fn descartes_count(&self) -> Option<usize> {
        let (_, primitive) = self.not_zero()?;
        let signs = primitive.coefficients().iter().map(|c| c.cmp0());
        Some(sturm::variations(signs))
    }

    /// The sign at a rational number.
    pub fn sign_at(&self, x: &Rational) -> Option<Ordering> {
        let (content, primitive) = IntegerPolynomial::from_exact(self)?;
        let sign = primitive.sign_at(x);
        Some(if content.cmp0().is_lt() {
            sign.reverse()
        } else {
            sign
        })
    }

    fn not_zero(&self) -> Option<(Rational, IntegerPolynomial)> {
        IntegerPolynomial::from_exact(self).filter(|(_, primitive)| !primitive.is_zero())
    }
}

fn no_value() -> Number<Exact> {
    Number::zero().inverse()
}

fn power(q: &Rational, n: usize) -> Rational {
    use rug::ops::Pow;
    Rational::from(q.pow(count::to_u32(n)))
}
