//! A midpoint with a radius, and its four operations and root.

use std::cmp::Ordering;

use rug::float::Round;
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, NegAssign, SubAssignRound};
use rug::{Float, Rational};

use super::constant::Constant;
use super::radius::Radius;

/// Bits that endpoints carry beyond a ball's own, so that going over them costs no accuracy.
const GUARD_BITS: u32 = 32;
/// Exponents above this are surely not at MPFR's lower end, where rounding errors exceed half a
/// unit in the last place.
const CLEARLY_NORMAL: i32 = -(1 << 29);

/// All real numbers within `radius` of `mid`. The midpoint is finite; an infinite radius means the
/// whole line.
#[derive(Clone, Debug)]
pub(super) struct Enclosure {
    pub mid: Float,
    pub radius: Radius,
}

/// A precision that MPFR accepts and that leaves room for guard bits.
pub(super) fn sane_precision(bits: u32) -> u32 {
    bits.clamp(2, 1 << 30)
}

impl Enclosure {
    pub fn whole_line(precision: u32) -> Enclosure {
        Enclosure {
            mid: Float::new(precision),
            radius: Radius::INFINITY,
        }
    }

    /// [−1, 1].
    pub fn unit_interval(precision: u32) -> Enclosure {
        Enclosure {
            mid: Float::new(precision),
            radius: Radius::ONE,
        }
    }

    /// What MPFR rounded to nearest, with the error.
    pub fn from_rounded((mid, rounding): (Float, Ordering)) -> Enclosure {
        let mut result = Enclosure {
            mid,
            radius: Radius::ZERO,
        };
        result.absorb(rounding);
        result
    }

    pub fn from_rational(q: &Rational, precision: u32) -> Enclosure {
        if q.is_integer() {
            return Enclosure::from_rounded(Float::with_val_round(
                precision,
                q.numer(),
                Round::Nearest,
            ));
        }
        if let Some(divisor) = q.denom().to_u32()
            && q.numer().significant_bits() <= precision
        {
            // The numerator is exact, so that one rounding is all there is.
            let mut quotient = Float::with_val(precision, q.numer());
            let rounding = quotient.div_assign_round(divisor, Round::Nearest);
            return Enclosure::from_rounded((quotient, rounding));
        }
        Enclosure::from_rounded(Float::with_val_round(precision, q, Round::Nearest))
    }

    pub fn from_constant(constant: &Constant, precision: u32) -> Enclosure {
        match constant {
            Constant::Integer(i) => {
                Enclosure::from_rounded(Float::with_val_round(precision, *i, Round::Nearest))
            }
            Constant::Rational(q) => Enclosure::from_rational(q, precision),
        }
    }

    /// A constant as an operand of so many bits: an integer with no more bits than it has, for short
    /// factors are quick.
    pub fn operand(constant: &Constant, precision: u32) -> Enclosure {
        if let Constant::Rational(q) = constant
            && q.is_integer()
            && q.numer().significant_bits() < precision
        {
            return Enclosure::from_rational(q, q.numer().significant_bits().max(2));
        }
        Enclosure::from_constant(constant, precision)
    }

    /// A ball around the numbers from `low` to `high`.
    pub fn hull(low: &Float, high: &Float, precision: u32) -> Enclosure {
        if !low.is_finite() || !high.is_finite() {
            return Enclosure::whole_line(precision);
        }
        let mut mid = Float::with_val(precision, low + high);
        // However the half is rounded, the radius is measured from what comes out.
        mid >>= 1;
        if !mid.is_finite() {
            return Enclosure::whole_line(precision);
        }
        let (above, _) = Float::with_val_round(32, high - &mid, Round::AwayZero);
        let (below, _) = Float::with_val_round(32, &mid - low, Round::AwayZero);
        let radius = Radius::above(&above).max(Radius::above(&below));
        Enclosure { mid, radius }
    }

    #[inline]
    pub fn precision(&self) -> u32 {
        self.mid.prec()
    }

    pub fn is_exactly_zero(&self) -> bool {
        self.radius.is_zero() && self.mid.is_zero()
    }

    /// The sign that all numbers of the ball have.
    #[inline]
    pub fn sign(&self) -> Option<Ordering> {
        if self.radius.is_zero() {
            return self.mid.cmp0();
        }
        self.radius
            .compare_magnitude(&self.mid)
            .is_gt()
            .then(|| self.mid.cmp0())
            .flatten()
    }

    /// Both ends, rounded outwards; infinite where the radius is.
    pub fn ends(&self) -> (Float, Float) {
        let precision = self.precision() + GUARD_BITS;
        let radius = self.radius.to_float();
        let (low, _) = Float::with_val_round(precision, &self.mid - &radius, Round::Down);
        let (high, _) = Float::with_val_round(precision, &self.mid + &radius, Round::Up);
        (low, high)
    }

    /// The same ball with another precision; a shorter midpoint costs radius.
    pub fn set_precision(&mut self, precision: u32) {
        if self.precision() != precision {
            let rounding = self.mid.set_prec_round(precision, Round::Nearest);
            self.absorb(rounding);
        }
    }

    #[inline]
    fn extend_to(&mut self, precision: u32) {
        if precision > self.precision() {
            self.mid.set_prec(precision);
        }
    }

    /// Takes the error of the operation that made the midpoint, rounded to nearest, into the
    /// radius.
    #[inline]
    pub fn absorb(&mut self, rounding: Ordering) {
        if rounding.is_ne() {
            let error = self.rounding_error();
            self.radius = self.radius.plus(error);
            if self.radius.is_infinite() {
                self.mid = Float::new(self.precision());
            }
        }
    }

    /// A bound for the error of an inexact midpoint: half a unit in its last place, except where it
    /// overflowed or where MPFR had no smaller number.
    #[inline]
    fn rounding_error(&self) -> Radius {
        match self.mid.get_exp() {
            Some(exponent) if exponent > CLEARLY_NORMAL => {
                Radius::power_of_two(i64::from(exponent) - i64::from(self.precision()) - 1)
            }
            _ => self.rounding_error_at_the_end(),
        }
    }

    #[cold]
    fn rounding_error_at_the_end(&self) -> Radius {
        let least = i64::from(rug::float::exp_min());
        match self.mid.get_exp().map(i64::from) {
            Some(exponent) if exponent > least => {
                Radius::power_of_two(exponent - i64::from(self.precision()) - 1)
            }
            Some(_) => Radius::power_of_two(least),
            None if self.mid.is_zero() => Radius::power_of_two(least),
            None => Radius::INFINITY,
        }
    }

    #[inline]
    pub fn add(&mut self, other: &Enclosure) {
        self.extend_to(other.precision());
        let rounding = self.mid.add_assign_round(&other.mid, Round::Nearest);
        self.radius = self.radius.plus(other.radius);
        self.absorb(rounding);
    }

    /// What MPFR rounded to nearest of numbers that are within `radius` of what they stand for.
    #[inline]
    fn with_error((mid, rounding): (Float, Ordering), radius: Radius) -> Enclosure {
        let mut result = Enclosure { mid, radius };
        result.absorb(rounding);
        result
    }

    #[inline]
    pub fn sum(&self, other: &Enclosure) -> Enclosure {
        let precision = self.precision().max(other.precision());
        let sum = Float::with_val_round(precision, &self.mid + &other.mid, Round::Nearest);
        Enclosure::with_error(sum, self.radius.plus(other.radius))
    }

    #[inline]
    pub fn difference(&self, other: &Enclosure) -> Enclosure {
        let precision = self.precision().max(other.precision());
        let difference = Float::with_val_round(precision, &self.mid - &other.mid, Round::Nearest);
        Enclosure::with_error(difference, self.radius.plus(other.radius))
    }

    #[inline]
    pub fn product(&self, other: &Enclosure) -> Enclosure {
        let precision = self.precision().max(other.precision());
        let product = Float::with_val_round(precision, &self.mid * &other.mid, Round::Nearest);
        Enclosure::with_error(product, self.error_of_product(other))
    }

    #[inline]
    pub fn sub(&mut self, other: &Enclosure) {
        self.extend_to(other.precision());
        let rounding = self.mid.sub_assign_round(&other.mid, Round::Nearest);
        self.radius = self.radius.plus(other.radius);
        self.absorb(rounding);
    }

    #[inline]
    pub fn mul(&mut self, other: &Enclosure) {
        self.radius = self.error_of_product(other);
        self.extend_to(other.precision());
        let rounding = self.mid.mul_assign_round(&other.mid, Round::Nearest);
        self.absorb(rounding);
    }

    /// The error of the product of x ± r and y ± s is at most |x| s + (|y| + s) r.
    #[inline]
    fn error_of_product(&self, other: &Enclosure) -> Radius {
        Radius::of_product([&self.mid, &other.mid], [self.radius, other.radius])
    }

    /// The divisor is not exactly zero. With q = x/y the error of the quotient of x ± r and y ± s
    /// is at most (r + |q| s)/(|y| − s).
    #[inline]
    pub fn div(&mut self, other: &Enclosure) {
        self.extend_to(other.precision());
        let divisor = other.distance_from_zero();
        if divisor.is_zero() {
            *self = Enclosure::whole_line(self.precision());
            return;
        }
        let radius = std::mem::replace(&mut self.radius, Radius::ZERO);
        let rounding = self.mid.div_assign_round(&other.mid, Round::Nearest);
        self.absorb(rounding);
        let from_other = self.farthest().times(other.radius);
        let spread = radius.plus(from_other).over(divisor);
        self.radius = self.radius.plus(spread);
    }

    /// An integer by a ball that is not exactly zero.
    pub fn inverse_times(i: i64, divisor: &Enclosure) -> Enclosure {
        let precision = divisor.precision();
        let distance = divisor.distance_from_zero();
        if distance.is_zero() {
            return Enclosure::whole_line(precision);
        }
        let quotient = Float::with_val_round(precision, i / &divisor.mid, Round::Nearest);
        let mut result = Enclosure::from_rounded(quotient);
        let spread = result.farthest().times(divisor.radius).over(distance);
        result.radius = result.radius.plus(spread);
        result
    }

    #[inline]
    pub fn negate(&mut self) {
        self.mid.neg_assign();
    }

    pub fn add_integer(&mut self, i: i64) {
        if i == 0 {
            return;
        }
        let rounding = self.mid.add_assign_round(i, Round::Nearest);
        self.absorb(rounding);
    }

    pub fn sub_integer(&mut self, i: i64) {
        if i == 0 {
            return;
        }
        let rounding = self.mid.sub_assign_round(i, Round::Nearest);
        self.absorb(rounding);
    }

    pub fn mul_integer(&mut self, i: i64) {
        if i < 0 && i != i64::MIN {
            self.negate();
            return self.mul_integer(-i);
        }
        if self.shifted_exactly(i, i64::from(i.trailing_zeros())) {
            return;
        }
        let rounding = self.mid.mul_assign_round(i, Round::Nearest);
        self.radius = self.radius.times(Radius::above_integer(i));
        self.absorb(rounding);
    }

    /// The divisor is not 0.
    pub fn div_integer(&mut self, i: i64) {
        if i < 0 && i != i64::MIN {
            self.negate();
            return self.div_integer(-i);
        }
        if self.shifted_exactly(i, -i64::from(i.trailing_zeros())) {
            return;
        }
        let rounding = self.mid.div_assign_round(i, Round::Nearest);
        self.radius = self.radius.over(Radius::below_integer(i));
        self.absorb(rounding);
    }

    /// Times 2^places if the integer is a power of two and nothing can overflow.
    #[inline]
    fn shifted_exactly(&mut self, i: i64, places: i64) -> bool {
        if !i.unsigned_abs().is_power_of_two() || i < 0 {
            return false;
        }
        if places == 0 {
            return true;
        }
        let safe = self.mid.get_exp().is_none_or(|e| e.abs() < -CLEARLY_NORMAL);
        if !safe {
            return false;
        }
        // At most 62 places, within the range of exponents: exact.
        self.mid <<= i32::try_from(places).unwrap_or(0);
        self.radius = self.radius.scaled(places);
        true
    }

    /// The root of the numbers that are not negative; there is one.
    pub fn sqrt(&mut self) {
        if self.radius.is_infinite() {
            return;
        }
        let distance = self.mid.get_exp().map_or(i64::MIN, |exponent| {
            i64::from(exponent).saturating_sub(self.radius.exponent())
        });
        if self.mid.is_zero() || distance < 8 {
            self.sqrt_by_ends();
        } else {
            self.sqrt_of_narrow(distance);
        }
    }

    /// For radius r ≤ 2^(1 − distance) mid the roots differ from √mid by at most h(1 + r/mid) with
    /// h = r/(2√mid).
    fn sqrt_of_narrow(&mut self, distance: i64) {
        let radius = std::mem::replace(&mut self.radius, Radius::ZERO);
        let rounding = self.mid.sqrt_round(Round::Nearest);
        self.absorb(rounding);
        if !radius.is_zero() {
            let half = radius.over(self.distance_from_zero()).scaled(-1);
            let spread = half.plus(half.scaled(1 - distance));
            self.radius = self.radius.plus(spread);
        }
    }

    fn sqrt_by_ends(&mut self) {
        if self.is_exactly_zero() {
            return;
        }
        let (mut low, mut high) = self.ends();
        if low < 0 {
            low = Float::new(2);
        }
        low.sqrt_round(Round::Down);
        high.sqrt_round(Round::Up);
        *self = Enclosure::hull(&low, &high, self.precision());
    }

    /// An upper bound of |x| over the ball.
    #[inline]
    pub fn farthest(&self) -> Radius {
        Radius::above(&self.mid).plus(self.radius)
    }

    /// A lower bound of |x| over the ball; 0 only if the ball holds 0.
    #[inline]
    fn distance_from_zero(&self) -> Radius {
        let distance = Radius::below(&self.mid).minus_below(self.radius);
        if distance.is_zero() {
            self.small_distance_from_zero()
        } else {
            distance
        }
    }

    /// The same where 32 bits are too few to tell.
    #[cold]
    fn small_distance_from_zero(&self) -> Radius {
        if self.sign().is_none_or(Ordering::is_eq) {
            return Radius::ZERO;
        }
        let (distance, _) = Float::with_val_round(64, self.mid.abs_ref(), Round::Zero);
        let mut least = distance;
        least.sub_assign_round(&self.radius.to_float(), Round::Down);
        if least > 0 {
            return Radius::below(&least);
        }
        // 64 bits are too few as well: the exact difference.
        let magnitude = Float::with_val(self.precision(), self.mid.abs_ref());
        let (exact, _) =
            Float::with_val_round(64, &magnitude - &self.radius.to_float(), Round::Down);
        Radius::below(&exact)
    }
}
