//! The square-free decomposition, by Yun's algorithm.

use super::chain::gcd;
use super::integer::IntegerPolynomial;

/// The polynomial as a product of powers of square-free polynomials of positive degree that have
/// no common roots, up to a constant factor; by ascending multiplicity.
pub(super) fn decompose(p: &IntegerPolynomial) -> Vec<(IntegerPolynomial, usize)> {
    let derivative = p.derivative();
    let repeated = gcd(p, &derivative);
    // With p = ∏ aₖᵏ: simple = ∏ aₖ over the multiplicities left, and excess vanishes exactly at
    // the roots of the current aₖ among them.
    let mut simple = p.quotient(&repeated);
    let mut excess = derivative.quotient(&repeated).minus(&simple.derivative());
    let mut factors = Vec::new();
    let mut multiplicity = 1;
    while simple.degree() > 0 {
        let mut factor = gcd(&simple, &excess);
        simple = simple.quotient(&factor);
        excess = excess.quotient(&factor).minus(&simple.derivative());
        if factor.degree() > 0 {
            factor.make_primitive();
            factors.push((factor, multiplicity));
        }
        multiplicity += 1;
    }
    factors
}
