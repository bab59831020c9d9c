//! Balls as decimal text.

use std::fmt;

use rug::{Integer, Rational};

use super::Ball;
use crate::number::count;
use crate::number::text::{decimal_text, leading_digits, power_of_ten};

/// Digits that [`Display`](fmt::Display) shows at most.
const DISPLAYED_DIGITS: usize = 20;

/// Decimal text of a ball: the ball lies within `[value − radius, value + radius]`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct BallText {
    /// The midpoint, rounded; `"0.125"`, `"-2.5e-40"`.
    pub value: String,
    /// The radius, with the rounding error of the value, rounded up to two digits; `"3e-51"`.
    pub radius: String,
}

impl Ball {
    /// The ball as decimal text with at most so many significant digits of the value (at least
    /// one), fewer where the radius leaves them without meaning. `None` where there is no value and
    /// where nothing is known of it: no decimal says either.
    ///
    /// Time and memory grow with the magnitude of the ball's exponent.
    ///
    /// ```
    /// use burmester::number::{Ball, Elementary};
    /// let pi = Ball::pi(&200).to_decimal(20).ok_or("no value")?;
    /// assert_eq!(pi.value, "3.1415926535897932385");
    /// assert_eq!(pi.radius, "3.8e-20");
    /// # Ok::<(), &str>(())
    /// ```
    pub fn to_decimal(&self, digits: usize) -> Option<BallText> {
        let mid = self.midpoint_rational()?;
        let radius = self.radius_rational()?;
        let (mantissa, exponent) = rounded_value(&mid, &radius, digits.max(1));
        let value = Rational::from(&mantissa) * power_of_ten(exponent);
        let error = Rational::from(&mid - &value).abs() + radius;
        Some(BallText {
            value: decimal_text(&mantissa, exponent),
            radius: rounded_up(&error),
        })
    }
}

/// Mantissa and decimal exponent of the value; 0 where the radius is larger than it.
fn rounded_value(mid: &Rational, radius: &Rational, digits: usize) -> (Integer, i64) {
    let zero = (Integer::new(), 0);
    if mid.cmp0().is_eq() || mid.cmp_abs(radius).is_lt() {
        return zero;
    }
    let mut allowed = count::to_i64(digits);
    if !radius.cmp0().is_eq() {
        // One digit beyond the two that the radius shows.
        let meaningful = leading_digits(mid, 1).1 - leading_digits(radius, 1).1 + 3;
        allowed = allowed.min(meaningful);
    }
    match usize::try_from(allowed) {
        Ok(allowed) if allowed > 0 => leading_digits(mid, allowed),
        _ => zero,
    }
}

/// At most two significant digits, not below `error`.
fn rounded_up(error: &Rational) -> String {
    if error.cmp0().is_eq() {
        return "0".to_owned();
    }
    let (mut mantissa, exponent) = leading_digits(error, 2);
    if Rational::from(&mantissa) * power_of_ten(exponent) < *error {
        mantissa += 1;
    }
    decimal_text(&mantissa, exponent)
}

impl fmt::Display for Ball {
    /// `value ± radius` with up to 20 digits, or so many as the formatter's precision says.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.value_exists() {
            return f.write_str("no value");
        }
        match self.to_decimal(f.precision().unwrap_or(DISPLAYED_DIGITS)) {
            Some(text) => write!(f, "{} ± {}", text.value, text.radius),
            None => f.write_str("nothing known"),
        }
    }
}
