//! `f64` as a number kind: for speed. Its predicates speak of the stored number, not of the true
//! result that it approximates.

use std::cmp::Ordering;

use rug::Rational;

use super::{Elementary, Kind, Real, Truth, degrees};

impl Kind for f64 {
    const ROUNDS: bool = true;

    fn constant(q: Rational) -> Self {
        q.to_f64()
    }

    #[inline]
    fn integer(i: i64) -> Self {
        #[expect(clippy::as_conversions, reason = "the nearest double")]
        {
            i as f64
        }
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        *self += other;
    }

    #[inline]
    fn sub(&mut self, other: &Self) {
        *self -= other;
    }

    #[inline]
    fn mul(&mut self, other: &Self) {
        *self *= other;
    }

    #[inline]
    fn div(&mut self, other: &Self) {
        *self /= other;
    }

    #[inline]
    fn negate(&mut self) {
        *self = -*self;
    }

    fn is_zero(&self) -> Truth {
        Truth::of_sign(self.sign(), Ordering::is_eq)
    }

    fn has_value(&self) -> bool {
        self.is_finite()
    }
}

impl Real for f64 {
    type Precision = ();

    fn rounded(q: &Rational, (): &()) -> Self {
        q.to_f64()
    }

    fn sign(&self) -> Option<Ordering> {
        self.partial_cmp(&0.0).filter(|_| self.is_finite())
    }

    fn sqrt(&mut self) {
        *self = f64::sqrt(*self);
    }

    /// Exact for multiples of 90°.
    fn cos_sin_of_degrees(q: &Rational, (): &()) -> Option<(Self, Self)> {
        if let Some(quarter) = degrees::quarter_turns(q) {
            let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
            return Some((Self::integer(cos), Self::integer(sin)));
        }
        let (sin, cos) = q.to_f64().to_radians().sin_cos();
        Some((cos, sin))
    }
}

impl Elementary for f64 {
    fn pi((): &()) -> Self {
        std::f64::consts::PI
    }

    fn sin(&mut self) {
        *self = f64::sin(*self);
    }

    fn cos(&mut self) {
        *self = f64::cos(*self);
    }

    fn tan(&mut self) {
        *self = f64::tan(*self);
    }

    fn asin(&mut self) {
        *self = f64::asin(*self);
    }

    fn acos(&mut self) {
        *self = f64::acos(*self);
    }

    fn atan(&mut self) {
        *self = f64::atan(*self);
    }

    fn atan2(&mut self, x: &Self) {
        *self = f64::atan2(*self, *x);
    }
}
