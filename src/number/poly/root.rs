//! Square roots in the field of fractions of a ring, and new ones.
//!
//! Whether an element is a square is decided from the last relation to the first: in a quadratic
//! extension K(y), y² = p, the element A + B·y with B ≠ 0 is a square exactly if A² − p·B² = d² in
//! K and one of (A ± d)/2 is a square a² in K (then the root is a + B/(2a)·y); and A alone exactly
//! if A or A/p is a square in K. Fractions of free polynomials n/d are squares exactly if n·d is,
//! because free polynomials have unique factors.

use std::cmp::Ordering;

use super::coefficient::Coefficient;
use super::denominator::Denominator;
use super::polynomial::Poly;
use super::ring::Ring;
use super::{Fraction, sign, terms};
use crate::number::Number;

/// A square root of a fraction, of either sign. The outer `None`: not decided, because a step had
/// no value; the inner one: there is none in the field of fractions.
pub(super) fn square_root(radicand: &Fraction, ring: &Ring) -> Option<Option<Fraction>> {
    radicand.value()?;
    let relations: Vec<(usize, &Poly)> = ring.relations().collect();
    let root = search(&Number(radicand.clone()), ring, &relations)?;
    Some(root.map(|root| root.0))
}

pub(super) fn is_surely_no_square(radicand: &Fraction, ring: &Ring) -> bool {
    matches!(square_root(radicand, ring), Some(None))
}

type Found = Option<Option<Number<Fraction>>>;

fn search(radicand: &Number<Fraction>, ring: &Ring, relations: &[(usize, &Poly)]) -> Found {
    let Some((&(index, square), earlier)) = relations.split_last() else {
        return search_free(radicand);
    };
    let value = radicand.0.value()?;
    let part = |power| {
        Number(Fraction::of_value(
            value.numerator.coefficient_of(index, power),
            value.denominator.clone(),
        ))
    };
    let (a, b) = (part(0), part(1));
    let y = Number::variable(ring, index);
    let p = Number::from(square.clone());
    if b.is_zero().is_yes() {
        if let Some(root) = search(&a, ring, earlier)? {
            return Some(Some(root));
        }
        if cannot_pair(square, &a.0, earlier) {
            return Some(None);
        }
        return Some(search(&(a / p), ring, earlier)?.map(|root| root * y));
    }
    let Some(d) = search(&(a.square() - p * b.square()), ring, earlier)? else {
        return Some(None);
    };
    for candidate in [(&a + &d) / 2, (&a - &d) / 2] {
        if let Some(first) = search(&candidate, ring, earlier)? {
            // Not zero: a zero candidate would mean p·B² = 0.
            let second = b / (2 * &first);
            return Some(Some(first + second * y));
        }
    }
    Some(None)
}

/// Whether it is plain that a/p is no square: a variable x occurs in p only, not in a nor in what
/// the earlier relations adjoin, and p, as a polynomial in x over all that, is linear or quadratic
/// without a double root. Then p is no square times a constant, but a/p would make it one. Without
/// this test, independent angles would double the search one by one.
fn cannot_pair(p: &Poly, a: &Fraction, earlier: &[(usize, &Poly)]) -> bool {
    let Some(value) = a.value() else { return false };
    let factors = value
        .denominator
        .factors
        .iter()
        .map(|(factor, _)| factor.poly());
    let squares = earlier.iter().map(|(_, square)| *square);
    let others: Vec<&Poly> = factors.chain(squares).chain([&value.numerator]).collect();
    let related = |variable| earlier.iter().any(|&(index, _)| index == variable);
    let candidates = terms::degrees(p.terms())
        .powers()
        .filter(|&(x, _)| !related(x) && others.iter().all(|other| other.degree_in(x) == 0));
    candidates.into_iter().any(|(x, degree)| match degree {
        1 => true,
        2 => discriminant(p, x).is_some_and(|discriminant| !discriminant.is_zero()),
        _ => false,
    })
}

/// β² − 4αγ of α·x² + β·x + γ.
fn discriminant(quadratic: &Poly, x: usize) -> Option<Poly> {
    let [gamma, beta, alpha] = [0, 1, 2].map(|power| quadratic.coefficient_of(x, power));
    beta.mul(&beta)?
        .sub(&alpha.mul(&gamma)?.scaled(&Coefficient::Small(4)))
}

/// Without related variables.
fn search_free(radicand: &Number<Fraction>) -> Found {
    let value = radicand.0.value()?;
    let (square, denominator) = over_square(value.numerator.clone(), &value.denominator)?;
    Some(
        square
            .sqrt_of_free()
            .map(|root| Number(Fraction::of_value(root, denominator))),
    )
}

/// n/d as f/g²: f, and g as a denominator.
fn over_square(numerator: Poly, denominator: &Denominator) -> Option<(Poly, Denominator)> {
    let mut square = numerator.scaled(&denominator.content);
    let mut root = Denominator {
        content: denominator.content.clone(),
        factors: Vec::new(),
    };
    for (factor, multiplicity) in &denominator.factors {
        if multiplicity % 2 == 1 {
            square = square.mul(factor.poly())?;
        }
        root.factors
            .push((factor.clone(), multiplicity.div_ceil(2)));
    }
    Some((square, root))
}

impl Poly {
    /// The root of a polynomial without related variables, where it is a square; the leading
    /// coefficient is positive.
    pub(super) fn sqrt_of_free(&self) -> Option<Poly> {
        Poly::of_terms(self.ring(), terms::square_root(self.terms())?)
    }
}

/// The root that is not negative, where there is a root and its sign can be told.
pub(super) fn not_negative(radicand: &Fraction) -> Option<Fraction> {
    let empty = Ring::empty();
    let root = square_root(radicand, radicand.ring().unwrap_or(&empty))??;
    with_sign(Number(root))
}

fn with_sign(root: Number<Fraction>) -> Option<Fraction> {
    match root.sign()? {
        Ordering::Less => Some((-root).0),
        _ => Some(root.0),
    }
}

/// See [`Fraction::adjoin_root`].
pub(super) fn adjoin(ring: &Ring, name: &str, radicand: &Fraction) -> Option<Fraction> {
    if radicand.ring().is_some_and(|own| !own.is_prefix_of(ring)) {
        return None;
    }
    if let Some(root) = square_root(radicand, ring)? {
        return with_sign(Number(root));
    }
    let value = radicand.value()?;
    if sign::of_value(value) == Some(Ordering::Less) {
        return None;
    }
    let (square, denominator) = over_square(value.numerator.clone(), &value.denominator)?;
    let (square, outside) = without_square_content(square);
    let below = Fraction::of_value(Poly::from(1), denominator);
    let side = sign::of_value(below.value()?);
    let extended = ring.with_root(name, side.is_some(), &square)?;
    let root = Number::variable(&extended, ring.len())
        * Number(below)
        * Number(Poly::of_coefficient(outside).into());
    Some(if side == Some(Ordering::Less) {
        (-root).0
    } else {
        root.0
    })
}

/// Takes squares of small primes out of the content, so that the relation is written in small
/// numbers; it would be right without.
fn without_square_content(mut poly: Poly) -> (Poly, Coefficient) {
    let mut outside = Coefficient::ONE;
    for prime in [2, 3, 5, 7, 11, 13] {
        while let Some(quotient) = poly.divided_by_integer(&Coefficient::Small(prime * prime)) {
            poly = quotient;
            outside = outside.mul(&Coefficient::Small(prime));
        }
    }
    (poly, outside)
}
