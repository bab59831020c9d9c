//! Polynomials and fractions as readable text.

use std::cmp::Reverse;
use std::fmt::{self, Display, Formatter};

use super::coefficient::Coefficient;
use super::monomial::Monomial;
use super::{Fraction, Poly, Ring};

/// `x^2 y`, or nothing for 1.
fn power_product(monomial: &Monomial, ring: Option<&Ring>) -> String {
    let powers = monomial.powers().map(|(index, exponent)| {
        let name = ring
            .and_then(|ring| ring.variable(index))
            .map_or("?", |variable| variable.name());
        if exponent == 1 {
            name.to_owned()
        } else {
            format!("{name}^{exponent}")
        }
    });
    powers.collect::<Vec<_>>().join(" ")
}

impl Display for Poly {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        // By degree, then the earlier variables first: as one would write it.
        let mut terms: Vec<_> = self.terms().iter().collect();
        terms.sort_by_cached_key(|(monomial, _)| {
            let degree: u32 = monomial.powers().map(|(_, e)| u32::from(e)).sum();
            let powers: Vec<_> = monomial.powers().map(|(v, e)| (v, Reverse(e))).collect();
            (Reverse(degree), powers)
        });
        for (i, (monomial, coefficient)) in terms.into_iter().enumerate() {
            f.write_str(match (i, coefficient.sign().is_lt()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let magnitude = coefficient.abs();
            let product = power_product(monomial, self.ring());
            match (magnitude.is_one(), product.is_empty()) {
                (_, true) => magnitude.fmt(f)?,
                (true, false) => f.write_str(&product)?,
                (false, false) => write!(f, "{magnitude} {product}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Debug for Poly {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(self, f)
    }
}

impl Display for Coefficient {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Coefficient::Small(i) => i.fmt(f),
            Coefficient::Big(z) => z.fmt(f),
        }
    }
}

/// In parentheses if it is a sum.
fn as_factor(poly: &Poly) -> String {
    if poly.number_of_terms() > 1 {
        format!("({poly})")
    } else {
        poly.to_string()
    }
}

/// In parentheses unless it is one number, one name or one sum.
fn as_divisor(factors: &[String]) -> String {
    match factors {
        [one] if !one.contains(['^', ' ']) || one.ends_with(')') => one.clone(),
        _ => format!("({})", factors.join(" ")),
    }
}

impl Display for Fraction {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Some(value) = self.value() else {
            return f.write_str("no value");
        };
        let content = &value.denominator.content;
        let mut below = Vec::new();
        if !content.is_one() {
            below.push(content.to_string());
        }
        for (factor, multiplicity) in &value.denominator.factors {
            let base = as_factor(factor.poly());
            below.push(if *multiplicity == 1 {
                base
            } else {
                format!("{base}^{multiplicity}")
            });
        }
        if below.is_empty() {
            return value.numerator.fmt(f);
        }
        write!(f, "{}/{}", as_factor(&value.numerator), as_divisor(&below))
    }
}
