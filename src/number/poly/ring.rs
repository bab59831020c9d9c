//! Rings: the variables, and what is known of them.

use std::fmt;
use std::sync::Arc;

use super::monomial::{MAX_VARIABLES, Monomial};
use super::{Fraction, Poly, root};
use crate::number::Number;

/// A variable of a [`Ring`].
#[derive(Debug)]
pub struct Variable {
    name: String,
    positive: bool,
    square: Option<Poly>,
}

impl Variable {
    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether it stands for positive numbers only.
    pub fn is_positive(&self) -> bool {
        self.positive
    }

    /// Its square, a polynomial in earlier variables, where a relation gives it.
    pub fn square(&self) -> Option<&Poly> {
        self.square.as_ref()
    }
}

/// The polynomials with integer coefficients in a list of variables, some of which are square roots
/// of polynomials in earlier ones.
///
/// A ring never changes; extending it by a variable gives a new ring, of which the old one is a
/// prefix. Numbers of both can be combined. Rings that were extended separately, even by variables
/// of the same name, are different, and a combination of their numbers has no value.
///
/// # Normal form
/// Every relation reads y² = p with p in earlier variables. In the lexicographic order with later
/// variables first its leading monomial is the pure power y². These are powers of different
/// variables, hence coprime, and so the relations are a Gröbner basis: every polynomial has one
/// normal form, the one with no exponent above 1 at a variable with a relation. It is zero exactly
/// if the polynomial is a consequence of the relations.
///
/// # No zero divisors
/// A relation y² = p is only accepted if p is no square in the field of fractions of the ring so
/// far (this is decided, see [`Ring::with_root`]). Then y generates a quadratic extension of
/// this field: the ring has no zero divisors, the ideal of the relations is prime, and a number
/// that is not identically zero can be divided by.
#[derive(Clone)]
pub struct Ring(Arc<Contents>);

struct Contents {
    variables: Vec<Arc<Variable>>,
    /// What tells monomials apart that the relations reduce.
    reducible: Monomial,
    /// What tells monomials apart that contain a variable with a relation.
    related: Monomial,
}

impl Ring {
    /// The ring without variables.
    pub fn empty() -> Ring {
        Self::of(Vec::new())
    }

    /// The ring of polynomials in free variables. `None` for more than 32, or a repeated name.
    pub fn free(names: &[&str]) -> Option<Ring> {
        names
            .iter()
            .try_fold(Self::empty(), |ring, name| ring.with_variable(name))
    }

    fn of(variables: Vec<Arc<Variable>>) -> Ring {
        let related = || {
            let all = variables.iter().enumerate();
            all.filter(|(_, variable)| variable.square.is_some())
                .map(|(i, _)| i)
        };
        let (reducible, related) = (
            Monomial::mask_above_one(related()),
            Monomial::mask_above_zero(related()),
        );
        Ring(Arc::new(Contents {
            variables,
            reducible,
            related,
        }))
    }

    /// This ring extended by a free variable. `None` where there are 32 variables already, or one
    /// of this name.
    pub fn with_variable(&self, name: &str) -> Option<Ring> {
        self.extended(name, false, None)
    }

    /// This ring extended by a free variable that stands for positive numbers. `None` as for
    /// [`Ring::with_variable`].
    pub fn with_positive(&self, name: &str) -> Option<Ring> {
        self.extended(name, true, None)
    }

    /// This ring extended by a square root of `square`, known to be positive or not.
    ///
    /// `None` as for [`Ring::with_variable`], where `square` belongs to another ring, and where it
    /// is already a square (also zero) in the field of fractions of this ring, because the root is
    /// then nothing new.
    pub fn with_root(&self, name: &str, positive: bool, square: &Poly) -> Option<Ring> {
        if !square.ring().is_none_or(|ring| ring.is_prefix_of(self)) {
            return None;
        }
        if !root::is_surely_no_square(&Fraction::from(square.clone()), self) {
            return None;
        }
        self.extended(name, positive, Some(square.clone()))
    }

    /// This ring extended by cosine and sine of an angle: a free variable `cosine` and its `sine`
    /// with sine² = 1 − cosine². `None` as for [`Ring::with_variable`].
    pub fn with_angle(&self, cosine: &str, sine: &str) -> Option<Ring> {
        let ring = self.with_variable(cosine)?;
        let cosine = Poly::variable(&ring, self.len())?;
        let square = Poly::from(1).sub(&cosine.mul(&cosine)?)?;
        ring.with_root(sine, false, &square)
    }

    fn extended(&self, name: &str, positive: bool, square: Option<Poly>) -> Option<Ring> {
        if self.len() >= MAX_VARIABLES || self.position(name).is_some() {
            return None;
        }
        let mut variables = self.0.variables.clone();
        variables.push(Arc::new(Variable {
            name: name.to_owned(),
            positive,
            square,
        }));
        Some(Self::of(variables))
    }

    /// The variables in their order.
    pub fn variables(&self) -> impl ExactSizeIterator<Item = &Variable> {
        self.0.variables.iter().map(Arc::as_ref)
    }

    /// How many variables there are.
    pub fn len(&self) -> usize {
        self.0.variables.len()
    }

    /// Whether there are no variables.
    pub fn is_empty(&self) -> bool {
        self.0.variables.is_empty()
    }

    /// The index of the variable of this name.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.variables().position(|variable| variable.name == name)
    }

    /// The variable of this index.
    pub fn variable(&self, index: usize) -> Option<&Variable> {
        self.0.variables.get(index).map(Arc::as_ref)
    }

    /// The first variables as numbers, in their order; no value beyond the last one.
    pub fn numbers<const N: usize>(&self) -> [Number<Fraction>; N] {
        std::array::from_fn(|index| Number::variable(self, index))
    }

    /// Whether this is the other ring or a ring that it was extended from.
    pub fn is_prefix_of(&self, other: &Ring) -> bool {
        // A variable is made once, for the ring that it extends: it stands for all before it.
        match self.0.variables.last() {
            None => true,
            Some(last) => {
                (other.0.variables.get(self.len() - 1)).is_some_and(|same| Arc::ptr_eq(last, same))
            }
        }
    }

    /// The longer of two rings (`None` within is the ring of a constant); `None` where neither is
    /// a prefix of the other.
    pub(super) fn joined<'a>(a: Option<&'a Ring>, b: Option<&'a Ring>) -> Option<Option<&'a Ring>> {
        match (a, b) {
            (None, ring) | (ring, None) => Some(ring),
            (Some(a), Some(b)) if Arc::ptr_eq(&a.0, &b.0) || b.is_prefix_of(a) => Some(Some(a)),
            (Some(a), Some(b)) => a.is_prefix_of(b).then_some(Some(b)),
        }
    }

    /// The variables with a relation, in their order, each with its square.
    pub(super) fn relations(&self) -> impl DoubleEndedIterator<Item = (usize, &Poly)> {
        let all = self.0.variables.iter().enumerate();
        all.filter_map(|(i, variable)| Some((i, variable.square.as_ref()?)))
    }

    pub(super) fn reducible(&self) -> &Monomial {
        &self.0.reducible
    }

    pub(super) fn related(&self) -> &Monomial {
        &self.0.related
    }
}

impl fmt::Debug for Ring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut list = f.debug_list();
        for variable in self.variables() {
            match &variable.square {
                Some(square) => list.entry(&format_args!("{}² = {square}", variable.name)),
                None => list.entry(&format_args!("{}", variable.name)),
            };
        }
        list.finish()
    }
}
