//! Signs that inspection shows.

use std::cmp::Ordering;

use super::fraction::Value;
use super::monomial::Monomial;
use super::polynomial::Poly;
use super::ring::Ring;
use super::terms;

/// The sign of a fraction wherever it is defined and not zero; `None` where that cannot be seen.
pub(super) fn of_value(value: &Value) -> Option<Ordering> {
    let mut sign = of_poly(&value.numerator)?;
    for (factor, multiplicity) in &value.denominator.factors {
        if multiplicity % 2 == 1 && of_poly(factor.poly())?.is_lt() {
            sign = sign.reverse();
        }
    }
    Some(sign)
}

/// The sign of a polynomial wherever it is not zero.
pub(super) fn of_poly(poly: &Poly) -> Option<Ordering> {
    if poly.is_zero() {
        return Some(Ordering::Equal);
    }
    inspected(poly)
        .or_else(|| of_square(poly))
        .or_else(|| without_relation(poly))
        .or_else(|| by_conjugate(poly))
        .or_else(|| of_quadratic(poly))
}

/// All terms of one sign, every variable positive or in an even power.
fn inspected(poly: &Poly) -> Option<Ordering> {
    let mut signs = poly.terms().iter().map(|(monomial, coefficient)| {
        of_monomial(monomial, poly.ring()).then(|| coefficient.sign())
    });
    let first = signs.next()??;
    signs.all(|sign| sign == Some(first)).then_some(first)
}

/// Whether a power product is never negative.
fn of_monomial(monomial: &Monomial, ring: Option<&Ring>) -> bool {
    monomial.powers().all(|(index, exponent)| {
        let variable = ring.and_then(|ring| ring.variable(index));
        exponent % 2 == 0 || variable.is_some_and(|variable| variable.is_positive())
    })
}

/// The content's sign, if the rest is a square.
fn of_square(poly: &Poly) -> Option<Ordering> {
    let (content, primitive) = poly.split_content();
    terms::square_root(primitive.terms()).map(|_| content.sign())
}

/// The sign of a quotient by a polynomial that is the square of a variable.
fn without_relation(poly: &Poly) -> Option<Ordering> {
    for (_, square) in poly.ring()?.relations() {
        if square.as_coefficient().is_none()
            && let Some(quotient) = poly.divide_exactly(square)
        {
            return of_poly(&quotient);
        }
    }
    None
}

/// The sign of the norm times that of the conjugate, where the latter is zero nowhere: r − m is
/// positive for r² = m² + x², because r + m is.
fn by_conjugate(poly: &Poly) -> Option<Ordering> {
    let conjugate = poly.conjugate()?;
    let sign = inspected(&conjugate).filter(|_| vanishes_nowhere(&conjugate))?;
    let norm = of_poly(&poly.mul(&conjugate)?)?;
    Some(if sign.is_lt() { norm.reverse() } else { norm })
}

/// Whether a polynomial whose terms are all of one sign has one that is not zero for any values.
fn vanishes_nowhere(poly: &Poly) -> bool {
    poly.terms().iter().any(|(monomial, _)| {
        monomial.powers().all(|(index, _)| {
            let variable = poly.ring().and_then(|ring| ring.variable(index));
            variable.is_some_and(|variable| variable.is_positive())
        })
    })
}

/// Beyond so many terms no discriminant is tried.
const MOST_TERMS_OF_QUADRATIC: usize = 2000;

/// A product of variables that is not negative may be a factor. The sign of the leading coefficient
/// of the rest, where the discriminant in one of the variables is nowhere
/// positive: so (x + y)² + z² is known not to be negative when it is multiplied out.
///
/// Leading coefficient and discriminant are known where they are not zero, which is everywhere but
/// on a thin set; on that set the polynomial is a limit of what it is elsewhere. This needs
/// variables that move freely, hence none with a relation.
fn of_quadratic(poly: &Poly) -> Option<Ordering> {
    if poly.latest_related().is_some() || poly.number_of_terms() > MOST_TERMS_OF_QUADRATIC {
        return None;
    }
    let ring = poly.ring()?;
    let (monomial, rest) = poly.split_monomial();
    if !of_monomial(&monomial, Some(ring)) {
        return None;
    }
    (0..ring.len())
        .filter(|&variable| rest.degree_in(variable) == 2)
        .find_map(|variable| {
            let [c, b, a] = [0, 1, 2].map(|power| rest.coefficient_of(variable, power));
            let four_times = a.mul(&c)?.mul(&Poly::from(4))?;
            let discriminant = b.mul(&b)?.sub(&four_times)?;
            let sign = of_poly(&a)?;
            of_poly(&discriminant)
                .filter(|sign| sign.is_le())
                .map(|_| sign)
        })
}
