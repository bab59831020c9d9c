//! Polynomials modulo a prime: a quick proof that two have no common factor.

use super::integer::IntegerPolynomial;

/// The largest prime below 2³².
const PRIME: u64 = 4_294_967_291;

/// `true` only if the two, neither of them zero, have no common factor of positive degree.
///
/// Where the prime divides no leading coefficient, a common factor stays one modulo the prime.
pub(super) fn surely_coprime(a: &IntegerPolynomial, b: &IntegerPolynomial) -> bool {
    let (mut a, mut b) = (reduced(a), reduced(b));
    if a.last() == Some(&0) || b.last() == Some(&0) {
        return false;
    }
    while b.len() > 1 {
        let remainder = remainder(a, &b);
        a = b;
        b = remainder;
    }
    b.len() == 1
}

/// Small primes, for which all residues can be tried.
const SMALL_PRIMES: [u32; 16] = [
    19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83,
];

/// `true` only if the polynomial, not zero, has no rational root.
///
/// Where the prime does not divide the leading coefficient, a rational root stays one modulo the
/// prime.
pub(super) fn has_surely_no_rational_root(p: &IntegerPolynomial) -> bool {
    SMALL_PRIMES.into_iter().any(|prime| {
        let residues: Vec<u32> = p.coefficients().iter().map(|c| c.mod_u(prime)).collect();
        let value = |x: u32| {
            residues
                .iter()
                .rev()
                .fold(0, |value, c| (value * x + c) % prime)
        };
        residues.last() != Some(&0) && (0..prime).all(|x| value(x) != 0)
    })
}

#[expect(clippy::as_conversions, reason = "the prime has 32 bits")]
fn reduced(p: &IntegerPolynomial) -> Vec<u64> {
    p.coefficients()
        .iter()
        .map(|c| u64::from(c.mod_u(PRIME as u32)))
        .collect()
}

/// The remainder without leading zeros; the divisor's leading coefficient is not zero.
fn remainder(mut rest: Vec<u64>, divisor: &[u64]) -> Vec<u64> {
    let Some((&leading, lower)) = divisor.split_last() else {
        return rest;
    };
    let inverse = power(leading, PRIME - 2);
    while rest.len() > lower.len() {
        let Some(highest) = rest.pop() else { break };
        let factor = PRIME - highest * inverse % PRIME;
        for (place, c) in rest.iter_mut().rev().zip(lower.iter().rev()) {
            *place = (*place + factor * c % PRIME) % PRIME;
        }
    }
    while rest.last() == Some(&0) {
        rest.pop();
    }
    rest
}

fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = result * base % PRIME;
        }
        base = base * base % PRIME;
        exponent >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use rug::Integer;

    fn polynomial(coefficients: &[i32]) -> IntegerPolynomial {
        IntegerPolynomial::new(coefficients.iter().copied().map(Integer::from).collect())
    }

    #[test]
    fn rational_roots_are_never_denied_and_mostly_told() {
        // 19·23·…·83 as the leading coefficient: no prime tells.
        let all: i128 = SMALL_PRIMES.iter().map(|p| i128::from(*p)).product();
        let deaf = IntegerPolynomial::new(vec![1.into(), 0.into(), Integer::from(all)]);
        assert!(!has_surely_no_rational_root(&deaf));
        for root in [-83, -3, 0, 1, 19, 1000] {
            // (x − root)(x² + 1)
            assert!(!has_surely_no_rational_root(&polynomial(&[
                -root, 1, -root, 1
            ])));
        }
        for rootless in [&[1, 0, 1][..], &[-2, 0, 1], &[3, 1, 0, 0, 0, 5]] {
            assert!(has_surely_no_rational_root(&polynomial(rootless)));
        }
    }

    #[test]
    fn common_factors_are_never_denied_and_their_lack_mostly_told() {
        // (x − 2)(x + 3) and (x − 2)(x − 5)
        let [a, b] = [&[-6, 1, 1][..], &[10, -7, 1]].map(polynomial);
        assert!(!surely_coprime(&a, &b) && !surely_coprime(&b, &a));
        assert!(surely_coprime(&a, &polynomial(&[-10, 3, 7])));
        assert!(surely_coprime(&a, &polynomial(&[4])));
    }
}
