//! The trait family that every arithmetic implements.
//!
//! A kind works in place on plain values; the wrapper [`Number`](super::Number) carries the
//! operators, so that a theory function reads like mathematics and kinds nest.

use std::cmp::Ordering;
use std::fmt::Debug;

use rug::Rational;

use super::Truth;

/// Numbers of more bits are excessive.
pub const EXCESSIVE_BITS: u32 = 1 << 16;

/// Polynomials of more terms are excessive.
pub const EXCESSIVE_TERMS: usize = 1 << 13;

/// An arithmetic: a commutative ring in which one can also divide.
///
/// Every operation is total. A quotient by zero, and whatever is computed from it, *has no value*;
/// a predicate on it answers [`Truth::Unknown`]. A result that merely cannot be told apart from
/// such a case (an enclosure that holds zero as divisor) is no such thing: it has a value, of which
/// nothing is known.
pub trait Kind: Clone + Debug + 'static {
    /// Whether a number stands for many, one for each choice of its symbols. A predicate that
    /// answers yes is then true for all of them, but one that answers no says only that it is not
    /// true for all.
    const GENERIC: bool = false;

    /// Whether results are rounded without a bound on the error, so that a predicate speaks of the
    /// stored number and not of the true one.
    const ROUNDS: bool = false;

    /// The rational number `q` itself. A kind of limited precision rounds it only when it meets a
    /// number that has a precision.
    fn constant(q: Rational) -> Self;

    /// The integer `i` itself.
    fn integer(i: i64) -> Self {
        Self::constant(Rational::from(i))
    }

    /// `self + other`, in place.
    fn add(&mut self, other: &Self);
    /// `self − other`, in place.
    fn sub(&mut self, other: &Self);
    /// `self · other`, in place.
    fn mul(&mut self, other: &Self);
    /// `self / other`, in place; no value where `other` is zero.
    fn div(&mut self, other: &Self);
    /// `−self`, in place.
    fn negate(&mut self);

    /// `self + other`. Kinds with room of their own for each number need not copy an operand first;
    /// so for the difference and the product.
    #[inline]
    fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add(other);
        sum
    }
    /// `self − other`.
    #[inline]
    fn minus(&self, other: &Self) -> Self {
        let mut difference = self.clone();
        difference.sub(other);
        difference
    }
    /// `self · other`.
    #[inline]
    fn times(&self, other: &Self) -> Self {
        let mut product = self.clone();
        product.mul(other);
        product
    }
    /// `self / other`; no value where `other` is zero.
    #[inline]
    fn over(&self, other: &Self) -> Self {
        let mut quotient = self.clone();
        quotient.div(other);
        quotient
    }

    /// A number, not zero, that makes all of a list integers where it multiplies them, if that makes sums
    /// and products quicker; `None` where there is nothing to gain.
    fn common_denominator<'a>(_numbers: impl Iterator<Item = &'a Self>) -> Option<Self> {
        None
    }

    /// Whether this is zero.
    fn is_zero(&self) -> Truth;

    /// `false` for the result of an operation that is not defined.
    fn has_value(&self) -> bool;

    /// Whether the number is so large (more than [`EXCESSIVE_BITS`] or [`EXCESSIVE_TERMS`]) that a
    /// few more products of its like would exhaust time or memory; never in a kind of limited
    /// precision.
    fn is_excessive(&self) -> bool {
        false
    }
}

/// A kind whose numbers are real: they have a sign and, where not negative, a square root.
pub trait Real: Kind {
    /// What a rounded number is rounded to: bits for balls, nothing for exact kinds.
    type Precision: Clone + Debug + 'static;

    /// The rational number `q` as a number of this precision.
    fn rounded(q: &Rational, precision: &Self::Precision) -> Self;

    /// The sign, `None` where it cannot be told (or where there is no value).
    fn sign(&self) -> Option<Ordering>;

    /// The square root that is not negative, in place; no value where the number is negative or
    /// where this arithmetic does not hold the root.
    fn sqrt(&mut self);

    /// Cosine and sine of an angle in degrees; `None` where this arithmetic does not hold them.
    fn cos_sin_of_degrees(q: &Rational, precision: &Self::Precision) -> Option<(Self, Self)>;
}

/// A real kind with the elementary functions; angles are in radians.
pub trait Elementary: Real {
    /// π to this precision.
    fn pi(precision: &Self::Precision) -> Self;
    /// sin, in place.
    fn sin(&mut self);
    /// cos, in place.
    fn cos(&mut self);
    /// tan, in place; no value at a pole.
    fn tan(&mut self);
    /// arcsin in [−π/2, π/2], in place; no value outside [−1, 1].
    fn asin(&mut self);
    /// arccos in [0, π], in place; no value outside [−1, 1].
    fn acos(&mut self);
    /// arctan in (−π/2, π/2), in place.
    fn atan(&mut self);
    /// The angle of the direction (x, y) in (−π, π], where `self` is y; no value for (0, 0).
    fn atan2(&mut self, x: &Self);
}
