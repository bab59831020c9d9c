//! Intervals of machine floats: rigorous, and quick where a few digits are enough.

use std::cmp::Ordering;

use rug::Rational;

use super::{Ball, Kind, Number, Real, Truth, degrees};

/// All real numbers from `low` to `high`; every operation encloses all of its results. With infinite
/// ends nothing is known; no value where the ends are no numbers.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    const WHOLE_LINE: Interval = Interval {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };
    const NO_VALUE: Interval = Interval {
        low: f64::NAN,
        high: f64::NAN,
    };

    /// [−1, 1].
    pub const UNIT: Interval = Interval {
        low: -1.0,
        high: 1.0,
    };

    /// The numbers from one float to another.
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high {
            Interval { low, high }
        } else {
            Interval::NO_VALUE
        }
    }

    /// The least number; no number where there is no value.
    pub fn low(&self) -> f64 {
        self.low
    }

    /// The greatest number; no number where there is no value.
    pub fn high(&self) -> f64 {
        self.high
    }

    /// The greatest magnitude; no number where there is no value.
    pub fn magnitude(&self) -> f64 {
        self.high.max(-self.low)
    }

    /// With what is negative of it moved to 0.
    pub fn not_negative(&self) -> Self {
        if !self.has_value() {
            return *self;
        }
        Interval {
            low: self.low.max(0.0),
            high: self.high.max(0.0),
        }
    }

    /// What encloses both.
    pub fn hull(&self, other: &Self) -> Self {
        if !(self.has_value() && other.has_value()) {
            return Interval::NO_VALUE;
        }
        Interval {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// All numbers within a distance of it.
    pub fn widened(&self, distance: f64) -> Self {
        Interval::outward(self.low - distance, self.high + distance)
    }

    /// Of results rounded to nearest.
    #[inline]
    fn outward(low: f64, high: f64) -> Self {
        Interval {
            low: low.next_down(),
            high: high.next_up(),
        }
    }

    fn is_bounded(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// The least and the greatest of four results; the whole line where an operand has no bound.
    #[inline]
    fn of_corners(&mut self, other: &Self, operate: impl Fn(f64, f64) -> f64) {
        if !(self.is_bounded() && other.is_bounded()) {
            let exists = self.has_value() && other.has_value();
            *self = if exists {
                Interval::WHOLE_LINE
            } else {
                Interval::NO_VALUE
            };
            return;
        }
        let [a, b] = [other.low, other.high].map(|end| operate(self.low, end));
        let [c, d] = [other.low, other.high].map(|end| operate(self.high, end));
        *self = Interval::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
    }
}

impl From<&Ball> for Interval {
    fn from(ball: &Ball) -> Self {
        match ball.float_ends() {
            Some([low, high]) => Interval { low, high },
            None if ball.has_value() => Interval::WHOLE_LINE,
            None => Interval::NO_VALUE,
        }
    }
}

impl From<&Number<Ball>> for Number<Interval> {
    fn from(ball: &Number<Ball>) -> Self {
        Number(Interval::from(&ball.0))
    }
}

/// From one rational to another.
fn enclosing(low: &Rational, high: &Rational) -> Interval {
    let ends = [low.to_f64(), high.to_f64()];
    // A rational is turned into a float by leaving out bits.
    let low = if ends[0] == *low {
        ends[0]
    } else {
        ends[0].next_down()
    };
    let high = if ends[1] == *high {
        ends[1]
    } else {
        ends[1].next_up()
    };
    Interval { low, high }
}

impl Kind for Interval {
    fn constant(q: Rational) -> Self {
        enclosing(&q, &q)
    }

    #[inline]
    fn integer(i: i64) -> Self {
        let float = f64::integer(i);
        if i.unsigned_abs() < 1 << 53 {
            Interval {
                low: float,
                high: float,
            }
        } else {
            Interval::outward(float, float)
        }
    }

    #[inline]
    fn add(&mut self, other: &Self) {
        *self = Interval::outward(self.low + other.low, self.high + other.high);
    }

    #[inline]
    fn sub(&mut self, other: &Self) {
        *self = Interval::outward(self.low - other.high, self.high - other.low);
    }

    #[inline]
    fn mul(&mut self, other: &Self) {
        self.of_corners(other, |a, b| a * b);
    }

    #[inline]
    fn div(&mut self, other: &Self) {
        if other.low == 0.0 && other.high == 0.0 {
            *self = Interval::NO_VALUE;
        } else if other.low <= 0.0 && other.high >= 0.0 && self.has_value() {
            *self = Interval::WHOLE_LINE;
        } else {
            self.of_corners(other, |a, b| a / b);
        }
    }

    #[inline]
    fn negate(&mut self) {
        *self = Interval {
            low: -self.high,
            high: -self.low,
        };
    }

    fn is_zero(&self) -> Truth {
        if self.low == 0.0 && self.high == 0.0 {
            Truth::Yes
        } else if self.sign().is_some() {
            Truth::No
        } else {
            Truth::Unknown
        }
    }

    #[inline]
    fn has_value(&self) -> bool {
        !self.low.is_nan()
    }
}

impl Real for Interval {
    type Precision = ();

    fn rounded(q: &Rational, (): &()) -> Self {
        enclosing(q, q)
    }

    #[inline]
    fn sign(&self) -> Option<Ordering> {
        if self.low > 0.0 {
            Some(Ordering::Greater)
        } else if self.high < 0.0 {
            Some(Ordering::Less)
        } else {
            (self.low == 0.0 && self.high == 0.0).then_some(Ordering::Equal)
        }
    }

    /// The roots of what is not negative; no value where all is negative.
    fn sqrt(&mut self) {
        if !self.has_value() || self.high < 0.0 {
            *self = Interval::NO_VALUE;
            return;
        }
        let Interval { low, high } = self.not_negative();
        *self = Interval::outward(low.sqrt(), high.sqrt()).not_negative();
    }

    fn cos_sin_of_degrees(q: &Rational, (): &()) -> Option<(Self, Self)> {
        if let Some(quarter) = degrees::quarter_turns(q) {
            let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
            return Some((Interval::integer(cos), Interval::integer(sin)));
        }
        let (cos, sin) = Ball::cos_sin_of_degrees(q, &64)?;
        Some((Interval::from(&cos), Interval::from(&sin)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    type I = Number<Interval>;

    fn holds(interval: &I, exact: &Number<Exact>) -> bool {
        let q = exact.0.rational().cloned().unwrap_or_default();
        interval.0.low <= q && interval.0.high >= q
    }

    #[test]
    fn every_operation_encloses() {
        let samples = [(1, 3), (-2, 7), (5, 1), (-1, 10), (22, 7), (0, 1)];
        for (p, q) in samples {
            for (r, s) in samples {
                let (x, y) = (Number::<Exact>::ratio(p, q), Number::<Exact>::ratio(r, s));
                let (a, b) = (I::ratio(p, q), I::ratio(r, s));
                assert!(holds(&(&a + &b), &(&x + &y)));
                assert!(holds(&(&a - &b), &(&x - &y)));
                assert!(holds(&(&a * &b), &(&x * &y)));
                if r != 0 {
                    assert!(holds(&(&a / &b), &(&x / &y)));
                    let wide = (&a / &b).0;
                    assert!(wide.high - wide.low < 1e-14 * (1.0 + wide.high.abs()));
                }
            }
        }
    }

    #[test]
    fn roots_and_signs() {
        let two: I = 2.into();
        let root = two.clone().sqrt();
        assert!((root.square() - &two).sign().is_none());
        assert!(!(-&two).sqrt().has_value());
        let around = Number(Interval::new(-1.0, 4.0));
        assert_eq!(around.clone().sqrt().0.low(), 0.0);
        assert!(around.clone().sqrt().0.high() >= 2.0);
        assert!(!around.is_zero().is_no() && (&two / &around).has_value());
        assert!(!(two / I::zero()).has_value());
    }

    #[test]
    fn nothing_known_stays_so() {
        let unknown = I::one() / Number(Interval::new(-1.0, 1.0));
        for of_it in [
            &unknown * I::zero(),
            &unknown - &unknown,
            I::one() / &unknown,
        ] {
            assert!(of_it.has_value() && of_it.sign().is_none(), "{of_it:?}");
        }
    }

    #[test]
    fn balls_are_enclosed() {
        let third = Number::<Ball>::rounded(&Rational::from((1, 3)), &100);
        assert!(holds(&I::from(&third), &Number::ratio(1, 3)));
    }
}
