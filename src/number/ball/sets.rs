//! Balls as sets of real numbers: bounds, membership, intersection.

use rug::float::Round;
use rug::{Float, Integer, Rational};

use super::enclosure::Enclosure;
use super::radius::Radius;
use super::{Ball, Content, sane_precision};

impl Ball {
    /// The ball of all numbers within |radius| of `mid`, with midpoints of so many bits; larger by
    /// what rounding costs.
    pub fn with_radius(mid: &Rational, radius: &Rational, bits: u32) -> Ball {
        let mut result = Enclosure::from_rational(mid, sane_precision(bits));
        result.radius = result.radius.plus(Radius::above_rational(radius));
        Ball::from(result)
    }

    /// A finite float, exactly.
    pub(in crate::number) fn exactly(mid: Float) -> Ball {
        Ball::from(Enclosure {
            mid,
            radius: Radius::ZERO,
        })
    }

    /// All numbers within 2^reach of an integer times 2^power.
    pub(crate) fn scaled(integer: &Integer, power: i64, reach: i64) -> Ball {
        let mut mid = Float::with_val(integer.significant_bits().max(2), integer);
        match i32::try_from(power) {
            Ok(power) => mid <<= power,
            Err(_) => return Ball::nothing_known(),
        }
        // Beyond the exponents of floats.
        if !mid.is_finite() || mid.is_zero() != integer.is_zero() {
            return Ball::nothing_known();
        }
        Ball::around(mid, reach)
    }

    /// An integer, rounded to so many bits.
    pub(in crate::number) fn of_integer(integer: &Integer, bits: u32) -> Ball {
        let rounded = Float::with_val_round(sane_precision(bits), integer, Round::Nearest);
        Ball::from(Enclosure::from_rounded(rounded))
    }

    /// All numbers within 2^power of a finite float.
    pub(in crate::number) fn around(mid: Float, power: i64) -> Ball {
        Ball::from(Enclosure {
            mid,
            radius: Radius::power_of_two(power),
        })
    }

    /// The midpoint; of a constant that it is to so many bits. `None` where there is no value or
    /// nothing is known.
    pub(in crate::number) fn middle(&self, bits: u32) -> Option<Float> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(c) => Some(Enclosure::from_constant(c, sane_precision(bits)).mid),
            Content::Enclosure(ball) if ball.radius.is_infinite() => None,
            Content::Enclosure(ball) => Some(ball.mid.clone()),
        }
    }

    /// An e with |x| < 2^e for all numbers of the ball; `None` where nothing is known.
    pub(in crate::number) fn magnitude(&self) -> Option<i64> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(c) => Some(Radius::above_rational(&c.to_rational()).exponent()),
            Content::Enclosure(ball) if ball.radius.is_infinite() => None,
            Content::Enclosure(ball) => Some(Radius::above(&ball.mid).plus(ball.radius).exponent()),
        }
    }

    /// An e with a radius < 2^e; the least number for a radius 0. `None` where nothing is known.
    pub(in crate::number) fn spread(&self) -> Option<i64> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(_) => Some(i64::MIN),
            Content::Enclosure(ball) if ball.radius.is_infinite() => None,
            Content::Enclosure(ball) => Some(ball.radius.exponent()),
        }
    }

    /// The midpoint; of a constant the constant. `None` where there is no value or nothing is
    /// known. Memory grows with the magnitude of the exponent.
    pub fn midpoint_rational(&self) -> Option<Rational> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(c) => Some(c.to_rational()),
            Content::Enclosure(ball) if ball.radius.is_infinite() => None,
            Content::Enclosure(ball) => ball.mid.to_rational(),
        }
    }

    /// The radius, 0 for a constant. `None` where there is no value or nothing is known.
    pub fn radius_rational(&self) -> Option<Rational> {
        match &self.0 {
            Content::NoValue => None,
            Content::Constant(_) => Some(Rational::new()),
            Content::Enclosure(ball) => ball.radius.to_rational(),
        }
    }

    /// The least number of the ball. `None` where there is no value or nothing is known.
    pub fn lower(&self) -> Option<Rational> {
        Some(self.midpoint_rational()? - self.radius_rational()?)
    }

    /// The greatest number of the ball. `None` where there is no value or nothing is known.
    pub fn upper(&self) -> Option<Rational> {
        Some(self.midpoint_rational()? + self.radius_rational()?)
    }

    /// Machine floats of which none of its numbers is less, and none greater; `None` where there is no
    /// value or nothing is known.
    pub(in crate::number) fn float_ends(&self) -> Option<[f64; 2]> {
        let ball = match &self.0 {
            Content::NoValue => return None,
            Content::Constant(c) => &Enclosure::from_constant(c, 64),
            Content::Enclosure(ball) => ball,
        };
        if ball.radius.is_infinite() {
            return None;
        }
        let radius = ball.radius.to_float();
        let (low, _) = Float::with_val_round(53, &ball.mid - &radius, Round::Down);
        let (high, _) = Float::with_val_round(53, &ball.mid + &radius, Round::Up);
        Some([low.to_f64_round(Round::Down), high.to_f64_round(Round::Up)])
    }

    /// Whether nothing is known: the ball is the whole line.
    pub fn is_whole_line(&self) -> bool {
        matches!(&self.0, Content::Enclosure(ball) if ball.radius.is_infinite())
    }

    /// Whether `q` is in the ball. The whole line holds every number, no value none.
    pub fn contains(&self, q: &Rational) -> bool {
        self.is_whole_line()
            || match (self.midpoint_rational(), self.radius_rational()) {
                (Some(mid), Some(radius)) => (mid - q).cmp_abs(&radius).is_le(),
                _ => false,
            }
    }

    /// Whether the two balls share a number, decided exactly. What has no value shares none.
    pub fn overlaps(&self, other: &Ball) -> bool {
        if !self.value_exists() || !other.value_exists() {
            return false;
        }
        let ends = (self.lower(), self.upper(), other.lower(), other.upper());
        match ends {
            (Some(low), Some(high), Some(other_low), Some(other_high)) => {
                low <= other_high && other_low <= high
            }
            _ => true,
        }
    }

    /// A ball that holds what the two share, not larger than either; `None` where they share
    /// nothing. Of two enclosures of one number both hold it, so that their intersection does.
    pub fn intersect(&self, other: &Ball) -> Option<Ball> {
        if !self.overlaps(other) {
            return None;
        }
        Some(match (&self.0, &other.0) {
            (Content::Enclosure(a), Content::Enclosure(b)) => intersection(a, b).into(),
            (Content::Constant(_), _) => self.clone(),
            _ => other.clone(),
        })
    }

    /// Bits of the midpoint; `None` for a constant, which has no precision, and for no value.
    pub fn precision(&self) -> Option<u32> {
        match &self.0 {
            Content::Enclosure(ball) => Some(ball.precision()),
            _ => None,
        }
    }

    /// The same number with another precision; a constant becomes an enclosure.
    pub fn with_precision(&self, bits: u32) -> Ball {
        let bits = sane_precision(bits);
        match &self.0 {
            Content::NoValue => Ball::NO_VALUE,
            Content::Constant(c) => Enclosure::from_constant(c, bits).into(),
            Content::Enclosure(ball) => {
                let mut result = ball.clone();
                result.set_precision(bits);
                result.into()
            }
        }
    }

    /// How many leading bits of the midpoint are certain, about log₂(|midpoint|/radius): `i64::MAX`
    /// for an exact number, zero or less where the ball holds 0 or nearly so, `i64::MIN` where
    /// nothing is known. `None` for no value.
    pub fn accuracy_bits(&self) -> Option<i64> {
        let ball = match &self.0 {
            Content::NoValue => return None,
            Content::Constant(_) => return Some(i64::MAX),
            Content::Enclosure(ball) => ball,
        };
        if ball.radius.is_zero() {
            return Some(i64::MAX);
        }
        let of_mid = ball.mid.get_exp().map_or(i64::MIN, i64::from);
        let bits = of_mid.saturating_sub(ball.radius.exponent());
        Some(if ball.radius.is_infinite() {
            i64::MIN
        } else {
            bits.saturating_sub(1)
        })
    }
}

/// The hull of what two balls share, or the smaller of the two where rounding makes that smaller.
fn intersection(a: &Enclosure, b: &Enclosure) -> Enclosure {
    let (low_a, high_a) = a.ends();
    let (low_b, high_b) = b.ends();
    let later = |x: Float, y: Float| if x < y { y } else { x };
    let earlier = |x: Float, y: Float| if y < x { y } else { x };
    let precision = a.precision().max(b.precision());
    let shared = Enclosure::hull(&later(low_a, low_b), &earlier(high_a, high_b), precision);
    let smaller = if b.radius < a.radius { b } else { a };
    if shared.radius < smaller.radius {
        shared
    } else {
        smaller.clone()
    }
}
