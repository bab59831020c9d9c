//! The subresultant chain: greatest common divisor and resultant without fractions.
//!
//! Reference: H. Cohen, A Course in Computational Algebraic Number Theory, algorithms 3.3.1 and
//! 3.3.7. The divisions by g h^δ are exact, so coefficients grow no faster than the minors that
//! they are.

use rug::Integer;
use rug::ops::{NegAssign, Pow};

use super::integer::IntegerPolynomial;
use super::modular;
use crate::number::count;

/// What the chain of two polynomials ends in.
struct End {
    /// The last polynomial that is not zero, proportional to the greatest common divisor.
    last: IntegerPolynomial,
    resultant: Integer,
}

/// The greatest common divisor of two polynomials, primitive with positive leading coefficient;
/// zero for two zeros.
pub(super) fn gcd(a: &IntegerPolynomial, b: &IntegerPolynomial) -> IntegerPolynomial {
    let mut result = if a.is_zero() {
        b.clone()
    } else if b.is_zero() {
        a.clone()
    } else if modular::surely_coprime(a, b) {
        IntegerPolynomial::one()
    } else {
        let [a, b] = [a, b].map(|p| p.clone().without_content());
        end(a, b).last
    };
    result.make_primitive();
    result
}

/// The resultant of two polynomials that are not zero.
pub(super) fn resultant(a: &IntegerPolynomial, b: &IntegerPolynomial) -> Integer {
    end(a.clone(), b.clone()).resultant
}

fn end(mut a: IntegerPolynomial, mut b: IntegerPolynomial) -> End {
    let mut negative = false;
    let mut turn = |a: &IntegerPolynomial, b: &IntegerPolynomial| {
        negative ^= a.degree() % 2 == 1 && b.degree() % 2 == 1;
    };
    if a.degree() < b.degree() {
        turn(&a, &b);
        std::mem::swap(&mut a, &mut b);
    }
    let (mut g, mut h) = (Integer::from(1), Integer::from(1));
    while b.degree() > 0 {
        let drop = a.degree() - b.degree();
        turn(&a, &b);
        let mut remainder = a.pseudo_remainder(&b);
        if remainder.is_zero() {
            return End {
                last: b,
                resultant: Integer::new(),
            };
        }
        remainder.divide_exactly_by(&(g * power(&h, drop)));
        a = std::mem::replace(&mut b, remainder);
        g = a.leading();
        h = next_height(&g, &h, drop);
    }
    let mut resultant = next_height(&b.leading(), &h, a.degree());
    if negative {
        resultant.neg_assign();
    }
    End { last: b, resultant }
}

/// g^δ h^(1 − δ), an integer.
fn next_height(g: &Integer, h: &Integer, drop: usize) -> Integer {
    match drop {
        0 => h.clone(),
        1 => g.clone(),
        _ => power(g, drop).div_exact(&power(h, drop - 1)),
    }
}

fn power(base: &Integer, exponent: usize) -> Integer {
    Integer::from(base.pow(count::to_u32(exponent)))
}
