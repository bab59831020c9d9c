//! Polynomials by their values.

use super::Polynomial;
use crate::number::{Kind, Number};

impl<K: Kind> Polynomial<K> {
    /// The polynomial of least degree with these values at different places, by Newton's divided
    /// differences.
    pub fn interpolated<'a>(points: impl IntoIterator<Item = &'a (Number<K>, Number<K>)>) -> Self
    where
        K: 'a,
    {
        let mut sum = Self::zero();
        let mut basis = Self::constant(Number::one());
        for (x, value) in points {
            let missing = (value - sum.evaluate(x)) / basis.evaluate(x);
            sum = sum + basis.scaled(&missing);
            basis = basis * Self::linear(x);
        }
        sum
    }
}
