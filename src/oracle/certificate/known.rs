//! True numbers: sums of square roots where positions are exact, else enclosures.

use crate::number::{Ball, Exact, Number, Real, Surd, Truth};

/// A kind that truths are computed in.
pub trait Known: Real {
    /// An enclosure, of so many bits where the number is exact.
    fn enclosed(number: &Number<Self>, bits: u32) -> Number<Ball>;
}

impl Known for Exact {
    fn enclosed(number: &Number<Self>, _: u32) -> Number<Ball> {
        number.in_kind()
    }
}

impl Known for Surd {
    fn enclosed(number: &Number<Self>, bits: u32) -> Number<Ball> {
        match number.0.rational() {
            Some(q) => Number::from(q.clone()),
            None => number.0.enclosure(bits),
        }
    }
}

impl Known for Ball {
    fn enclosed(number: &Number<Self>, _: u32) -> Number<Ball> {
        number.clone()
    }
}

/// An enclosure of the root of a number that is not negative.
pub fn root<K: Known>(square: &Number<K>, bits: u32) -> Number<Ball> {
    if square.is_zero().is_yes() {
        return Number::zero();
    }
    Number(K::enclosed(square, bits).0.with_precision(bits)).sqrt()
}

/// Whether all are zero.
pub fn vanish<K: Known>(list: &[Number<K>]) -> Truth {
    Truth::all(list.iter().map(Number::is_zero))
}
