//! Denominators: a positive integer times a list of factors.
//!
//! A factor is a primitive polynomial without related variables, not constant, with positive
//! leading coefficient, and no factor of a list divides another. They need not be irreducible.

use std::sync::Arc;

use super::coefficient::Coefficient;
use super::polynomial::Poly;
use super::ring::Ring;
use super::terms;

/// A factor, with what tells quickly that it does not divide.
#[derive(Debug)]
pub(super) struct Factor {
    poly: Poly,
    /// |value at fixed integers|, where it fits and says anything: it divides the value of every
    /// multiple.
    image: Option<u64>,
}

impl Factor {
    fn new(poly: Poly) -> Arc<Factor> {
        let image = terms::value_at_integers(poly.terms(), 0).abs().to_u64();
        Arc::new(Factor {
            poly,
            image: image.filter(|&value| value > 1),
        })
    }

    pub fn poly(&self) -> &Poly {
        &self.poly
    }

    /// The quotient of a polynomial by this factor where it is one.
    pub fn divide(&self, dividend: &Poly) -> Option<Poly> {
        if let Some(image) = self.image
            && terms::value_modulo(dividend.terms(), image) != 0
        {
            return None;
        }
        dividend.divide_exactly(&self.poly)
    }

    /// Takes the factor out of a polynomial up to `most` times; how often it was.
    pub fn take_out(&self, poly: &mut Poly, most: u32) -> u32 {
        let mut times = 0;
        while times < most && !poly.is_zero() {
            let Some(quotient) = self.divide(poly) else {
                break;
            };
            *poly = quotient;
            times += 1;
        }
        times
    }
}

/// A factor with its multiplicities in two denominators.
#[derive(Clone, Debug)]
pub(super) struct Shared {
    pub factor: Arc<Factor>,
    pub multiplicity: [u32; 2],
}

/// Adds a primitive polynomial with positive leading coefficient to a list of factors, splitting
/// both as far as one divides another.
pub(super) fn insert(list: &mut Vec<Shared>, mut poly: Poly, multiplicity: [u32; 2]) {
    let plus = |a: [u32; 2], b: [u32; 2], times: u32| [a[0] + b[0] * times, a[1] + b[1] * times];
    if let Some(same) = list.iter_mut().find(|shared| shared.factor.poly == poly) {
        same.multiplicity = plus(same.multiplicity, multiplicity, 1);
        return;
    }
    for shared in list.iter_mut() {
        let times = shared.factor.take_out(&mut poly, u32::MAX);
        shared.multiplicity = plus(shared.multiplicity, multiplicity, times);
    }
    if poly.as_coefficient().is_some() {
        return;
    }
    let factor = Factor::new(poly);
    let divisible = list
        .iter()
        .position(|shared| factor.divide(&shared.factor.poly).is_some());
    let Some(place) = divisible else {
        return list.push(Shared {
            factor,
            multiplicity,
        });
    };
    // A known factor is a multiple of the new one: its quotient takes its place.
    let known = list.swap_remove(place);
    let mut rest = known.factor.poly.clone();
    let times = factor.take_out(&mut rest, u32::MAX);
    insert(
        list,
        factor.poly.clone(),
        plus(multiplicity, known.multiplicity, times),
    );
    if rest.as_coefficient().is_none() {
        insert(list, rest, known.multiplicity);
    }
}

/// `content · ∏ factor^multiplicity`, never zero.
#[derive(Clone, Debug)]
pub(super) struct Denominator {
    /// Positive.
    pub content: Coefficient,
    pub factors: Vec<(Arc<Factor>, u32)>,
}

impl Denominator {
    pub fn one() -> Self {
        Denominator {
            content: Coefficient::ONE,
            factors: Vec::new(),
        }
    }

    /// The longest ring of the factors.
    pub fn ring(&self) -> Option<&Ring> {
        let rings = self
            .factors
            .iter()
            .filter_map(|(factor, _)| factor.poly.ring());
        rings.max_by_key(|ring| ring.len())
    }

    /// The factors of two denominators in one list.
    pub fn shared(&self, other: &Denominator) -> Vec<Shared> {
        let mut list: Vec<Shared> = (self.factors.iter())
            .map(|(factor, e)| Shared {
                factor: factor.clone(),
                multiplicity: [*e, 0],
            })
            .collect();
        for (factor, e) in &other.factors {
            let same = |shared: &&mut Shared| Arc::ptr_eq(&shared.factor, factor);
            match list.iter_mut().find(same) {
                Some(shared) => shared.multiplicity[1] += e,
                None => insert(&mut list, factor.poly.clone(), [0, *e]),
            }
        }
        list
    }

    /// A denominator of the shared factors with new multiplicities.
    pub fn from_shared(
        content: Coefficient,
        list: Vec<Shared>,
        multiplicity: impl Fn([u32; 2]) -> u32,
    ) -> Self {
        let factors = list
            .into_iter()
            .map(|shared| (shared.factor, multiplicity(shared.multiplicity)));
        Denominator {
            content,
            factors: factors.filter(|&(_, e)| e > 0).collect(),
        }
    }

    /// Cancels common factors with a numerator.
    pub fn cancel(&mut self, numerator: &mut Poly) {
        if numerator.is_zero() {
            *self = Self::one();
            return;
        }
        for (factor, multiplicity) in &mut self.factors {
            *multiplicity -= factor.take_out(numerator, *multiplicity);
        }
        self.factors.retain(|&(_, multiplicity)| multiplicity > 0);
        self.cancel_content(numerator);
    }

    fn cancel_content(&mut self, numerator: &mut Poly) {
        if self.content.is_one() {
            return;
        }
        let common = terms::content(numerator.terms()).gcd(&self.content);
        // The common divisor divides both.
        let quotients = (
            numerator.divided_by_integer(&common),
            self.content.divide_exactly(&common),
        );
        if let (Some(reduced), Some(content)) = quotients {
            *numerator = reduced;
            self.content = content;
        }
    }
}

/// `poly · ∏ factor^multiplicity`.
pub(super) fn multiplied(
    poly: &Poly,
    factors: &[Shared],
    multiplicity: impl Fn([u32; 2]) -> u32,
) -> Option<Poly> {
    let mut product = poly.clone();
    for shared in factors {
        for _ in 0..multiplicity(shared.multiplicity) {
            product = product.mul(&shared.factor.poly)?;
        }
    }
    Some(product)
}
