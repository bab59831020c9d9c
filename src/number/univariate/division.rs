//! Division with remainder, in a field and without dividing coefficients.

use super::Polynomial;
use crate::number::{Kind, Number};

/// What [`Polynomial::pseudo_divide`] finds: multiplier · dividend = quotient · divisor +
/// remainder.
#[derive(Clone, Debug)]
pub struct PseudoQuotient<K> {
    /// A power of the divisor's leading coefficient.
    pub multiplier: Number<K>,
    /// The quotient.
    pub quotient: Polynomial<K>,
    /// The remainder, of lower degree than the divisor.
    pub remainder: Polynomial<K>,
}

impl<K: Kind> Polynomial<K> {
    /// Quotient and remainder, the remainder of lower degree than the divisor. `None` unless the
    /// divisor's leading coefficient is surely not zero.
    pub fn divide(&self, divisor: &Self) -> Option<(Self, Self)> {
        let (leading, lower) = divisor.coefficients().split_last()?;
        leading.is_zero().is_no().then_some(())?;
        let mut rest = self.coefficients().to_vec();
        let mut quotient = Vec::new();
        while rest.len() > lower.len() {
            let Some(highest) = rest.pop() else { break };
            let factor = highest / leading;
            for (place, coefficient) in rest.iter_mut().rev().zip(lower.iter().rev()) {
                *place -= &factor * coefficient;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Some((Polynomial::new(quotient), Polynomial::new(rest)))
    }

    /// Division of a multiple, so that no coefficient is divided: the multiplier is the divisor's
    /// leading coefficient to the power m − n + 1 for degrees m ≥ n, and 1 for m < n. `None` for
    /// the zero divisor.
    pub fn pseudo_divide(&self, divisor: &Self) -> Option<PseudoQuotient<K>> {
        let (leading, lower) = divisor.coefficients().split_last()?;
        let mut multiplier = Number::one();
        let mut rest = self.coefficients().to_vec();
        let mut quotient: Vec<Number<K>> = Vec::new();
        while rest.len() > lower.len() {
            let Some(factor) = rest.pop() else { break };
            for coefficient in rest.iter_mut().chain(&mut quotient) {
                *coefficient *= leading;
            }
            for (place, coefficient) in rest.iter_mut().rev().zip(lower.iter().rev()) {
                *place -= &factor * coefficient;
            }
            quotient.push(factor);
            multiplier *= leading;
        }
        quotient.reverse();
        Some(PseudoQuotient {
            multiplier,
            quotient: Polynomial::new(quotient),
            remainder: Polynomial::new(rest),
        })
    }
}
