//! The common part of two curves.
//!
//! Curves f and g with a common part c, f = bc and g = ac, fulfil a f = b g with a and b of lower
//! order than g and f; the lowest such b gives c = f/b. All of it is linear algebra.

use super::polynomial::Polynomial;
use crate::number::linear::kernel;
use crate::number::{Exact, Number};

type Curve = Polynomial<Exact>;

/// The curve of highest order that is part of both, the line at infinity included; a constant where
/// there is none. A polynomial that vanishes everywhere stands for the whole plane. `None` where a
/// coefficient has no value.
pub fn common_part(f: &Curve, g: &Curve) -> Option<Curve> {
    if f.is_zero() {
        return Some(g.clone());
    }
    if g.is_zero() {
        return Some(f.clone());
    }
    for order in (0..=f.order().min(g.order())).rev() {
        if let Some(cofactor) = cofactor(f, g, order)? {
            return quotient(f, &cofactor, order);
        }
    }
    None
}

/// The b of a f = b g, for a common part of this order.
fn cofactor(f: &Curve, g: &Curve, order: usize) -> Option<Option<Curve>> {
    let (a, b) = (
        Curve::monomials(g.order() - order),
        Curve::monomials(f.order() - order),
    );
    let left = a.iter().map(|term| term.times(f));
    let right = b.iter().map(|term| term.times(g));
    let columns: Vec<Curve> = left.chain(right).collect();
    let found = relations(&columns)?;
    let weights = found.first().and_then(|vector| vector.get(a.len()..));
    Some(weights.map(|weights| combination(&b, weights)))
}

/// The c of b c = f.
fn quotient(f: &Curve, b: &Curve, order: usize) -> Option<Curve> {
    let terms = Curve::monomials(order);
    let products = terms.iter().map(|term| term.times(b));
    let columns: Vec<Curve> = products.chain([f.clone()]).collect();
    let found = relations(&columns)?;
    let weights = found.first()?.get(..terms.len())?;
    Some(combination(&terms, weights))
}

/// The weights with which the sum of these curves of one order vanishes.
fn relations(columns: &[Curve]) -> Option<Vec<Vec<Number<Exact>>>> {
    let length = columns.first()?.coefficients().len();
    let row = |place: usize| -> Vec<Number<Exact>> {
        let entries = columns.iter().map(|curve| curve.coefficients().get(place));
        entries.flatten().cloned().collect()
    };
    let rows: Vec<_> = (0..length).map(row).collect();
    kernel(&rows, columns.len())
}

fn combination(terms: &[Curve], weights: &[Number<Exact>]) -> Curve {
    let order = terms.first().map_or(0, Curve::order);
    let scaled = terms
        .iter()
        .zip(weights)
        .map(|(term, weight)| term.scaled(weight));
    scaled.fold(Curve::zero(order), |sum, term| sum.plus(&term))
}
