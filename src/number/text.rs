//! Decimal text of exact rationals: reading and writing.

use std::cmp::Ordering;

use rug::ops::Pow;
use rug::{Integer, Rational};
use thiserror::Error;

use super::{Kind, count};

/// Digits that a number may have at most, all its parts together.
pub const MOST_DIGITS: usize = 100_000;
/// What the exponent of a decimal may be at most, in magnitude.
pub const LARGEST_EXPONENT: u32 = 100_000;

/// Why a text is no number. Places count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NumberError {
    /// Something that has no place in a number.
    #[error("unexpected '{found}' at character {place}")]
    Unexpected {
        /// The character.
        found: char,
        /// Where it stands.
        place: usize,
    },
    /// A digit was due.
    #[error("a digit is missing at character {place}")]
    MissingDigit {
        /// Where it was due.
        place: usize,
    },
    /// A fraction with denominator 0.
    #[error("the denominator at character {place} is zero")]
    ZeroDenominator {
        /// Where the denominator begins.
        place: usize,
    },
    /// More digits than [`MOST_DIGITS`].
    #[error("the number has more than {MOST_DIGITS} digits")]
    TooManyDigits,
    /// An exponent beyond [`LARGEST_EXPONENT`].
    #[error("the exponent at character {place} is beyond ±{LARGEST_EXPONENT}")]
    ExponentTooLarge {
        /// Where the exponent begins.
        place: usize,
    },
}

/// Reads an integer `3`, a fraction `-5/13` or a decimal `0.125`, `2.5e-7`, exactly.
///
/// A sign may stand in front and in an exponent; nothing else, not even blanks, may surround the
/// number.
///
/// ```
/// use burmester::number::text::parse_rational;
/// use rug::Rational;
/// assert_eq!(parse_rational("-0.125")?, Rational::from((-1, 8)));
/// assert!(parse_rational("1e999999999").is_err());
/// # Ok::<(), burmester::number::text::NumberError>(())
/// ```
///
/// # Errors
/// A [`NumberError`] that names the first fault and its place.
pub fn parse_rational(text: &str) -> Result<Rational, NumberError> {
    let mut reader = Reader { text, position: 0 };
    let negative = reader.sign();
    let mut digits = reader.digits()?.to_owned();
    let denominator = reader.denominator(&mut digits)?;
    let exponent = match denominator {
        None => reader.decimal_tail(&mut digits)?,
        Some(_) => 0,
    };
    reader.end()?;
    let magnitude = match denominator {
        Some(denominator) => Rational::from((integer(&digits), denominator)),
        None => Rational::from(integer(&digits)) * power_of_ten(exponent),
    };
    Ok(if negative { -magnitude } else { magnitude })
}

/// A text of ASCII digits as an integer; 0 for an empty one.
fn integer(digits: &str) -> Integer {
    Integer::parse(digits)
        .map(Integer::from)
        .unwrap_or_default()
}

struct Reader<'a> {
    text: &'a str,
    /// In bytes; the characters before it are ASCII, so that it counts them as well.
    position: usize,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        self.text.get(self.position..).unwrap_or_default()
    }

    fn place(&self) -> usize {
        self.position + 1
    }

    /// Steps over one of the characters, if it is next.
    fn take(&mut self, characters: &[char]) -> Option<char> {
        let next = self.rest().chars().next()?;
        characters.contains(&next).then(|| {
            self.position += next.len_utf8();
            next
        })
    }

    /// Whether a minus sign was read.
    fn sign(&mut self) -> bool {
        self.take(&['+', '-']) == Some('-')
    }

    /// One digit or more.
    fn digits(&mut self) -> Result<&'a str, NumberError> {
        let rest = self.rest();
        let count = rest.bytes().take_while(u8::is_ascii_digit).count();
        if count == 0 {
            return Err(self.missing_digit());
        }
        if count > MOST_DIGITS {
            return Err(NumberError::TooManyDigits);
        }
        self.position += count;
        Ok(rest.get(..count).unwrap_or_default())
    }

    fn missing_digit(&self) -> NumberError {
        let place = self.place();
        match self.rest().chars().next() {
            Some(found) => NumberError::Unexpected { found, place },
            None => NumberError::MissingDigit { place },
        }
    }

    /// The denominator of a fraction with this numerator, if it is one.
    fn denominator(&mut self, numerator: &mut str) -> Result<Option<Integer>, NumberError> {
        if self.take(&['/']).is_none() {
            return Ok(None);
        }
        let place = self.place();
        let digits = self.digits()?;
        if numerator.len() + digits.len() > MOST_DIGITS {
            return Err(NumberError::TooManyDigits);
        }
        let denominator = integer(digits);
        if denominator.cmp0() == Ordering::Equal {
            return Err(NumberError::ZeroDenominator { place });
        }
        Ok(Some(denominator))
    }

    /// Appends the decimals to the digits and returns the power of ten to multiply them with.
    fn decimal_tail(&mut self, digits: &mut String) -> Result<i64, NumberError> {
        let mut decimals = 0;
        if self.take(&['.']).is_some() {
            let fraction = self.digits()?;
            if digits.len() + fraction.len() > MOST_DIGITS {
                return Err(NumberError::TooManyDigits);
            }
            digits.push_str(fraction);
            decimals = count::to_i64(fraction.len());
        }
        Ok(self.exponent()? - decimals)
    }

    fn exponent(&mut self) -> Result<i64, NumberError> {
        if self.take(&['e', 'E']).is_none() {
            return Ok(0);
        }
        let place = self.place();
        let negative = self.sign();
        let magnitude = self.digits()?.parse::<u32>().ok();
        match magnitude.filter(|&magnitude| magnitude <= LARGEST_EXPONENT) {
            Some(magnitude) if negative => Ok(-i64::from(magnitude)),
            Some(magnitude) => Ok(i64::from(magnitude)),
            None => Err(NumberError::ExponentTooLarge { place }),
        }
    }

    fn end(&self) -> Result<(), NumberError> {
        let place = self.place();
        match self.rest().chars().next() {
            Some(found) => Err(NumberError::Unexpected { found, place }),
            None => Ok(()),
        }
    }
}

/// The number rounded to so many decimals, half away from zero, as plain text: `-0.67`. What rounds
/// to zero has no sign.
///
/// ```
/// use burmester::number::text::round_to_decimals;
/// assert_eq!(round_to_decimals(&(-2, 3).into(), 2), "-0.67");
/// assert_eq!(round_to_decimals(&(5, 2).into(), 0), "3");
/// ```
pub fn round_to_decimals(q: &Rational, decimals: u32) -> String {
    let scaled = Rational::from(q * ten_to(decimals)).round();
    with_point(scaled.numer(), count::from_u32(decimals))
}

/// `integer · 10^(−decimals)` with a decimal point.
fn with_point(integer: &Integer, decimals: usize) -> String {
    let magnitude = Integer::from(integer.abs_ref()).to_string();
    let digits = format!("{magnitude:0>width$}", width = decimals + 1);
    let (whole, fraction) = digits.split_at(digits.len() - decimals);
    let sign = if integer.is_negative() { "-" } else { "" };
    let point = if decimals > 0 { "." } else { "" };
    format!("{sign}{whole}{point}{fraction}")
}

fn ten_to(power: u32) -> Integer {
    Integer::from(10).pow(power)
}

/// 10^exponent.
pub(super) fn power_of_ten(exponent: i64) -> Rational {
    // No number that fits a memory has a decimal exponent beyond u32.
    let power = ten_to(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
    if exponent < 0 {
        Rational::from((1, power))
    } else {
        Rational::from(power)
    }
}

/// `q`, which is not 0, rounded to so many significant digits: mantissa m and exponent e with
/// q ≈ m·10^e, half away from zero.
pub(super) fn leading_digits(q: &Rational, digits: usize) -> (Integer, i64) {
    let bits = i64::from(q.numer().significant_bits()) - i64::from(q.denom().significant_bits());
    // |q| is between 2^(bits − 1) and 2^(bits + 1): the estimate of its decimal order is never too
    // high and at most one or two too low.
    #[expect(clippy::as_conversions, reason = "a whole number less than the bits")]
    let estimate = (f64::integer(bits - 1) * std::f64::consts::LOG10_2).floor() as i64;
    let digits = count::to_i64(digits);
    let mut exponent = estimate + 1 - digits;
    loop {
        let mantissa = scaled_integer(q, -exponent);
        let length = count::to_i64(mantissa.to_string().trim_start_matches('-').len());
        if length == digits {
            return (mantissa, exponent);
        }
        if length == digits + 1 && mantissa.clone().abs() == power_of_ten(digits) {
            // Rounded up to the next power of ten.
            return (mantissa / 10, exponent + 1);
        }
        exponent += (length - digits).signum();
    }
}

fn scaled_integer(q: &Rational, power: i64) -> Integer {
    (q * power_of_ten(power)).round().into_numer_denom().0
}

/// `mantissa · 10^exponent` as text: plain where that is short, else with an exponent.
pub(super) fn decimal_text(mantissa: &Integer, exponent: i64) -> String {
    let digits = Integer::from(mantissa.abs_ref()).to_string();
    let shortened = digits.trim_end_matches('0');
    if shortened.is_empty() {
        return "0".to_owned();
    }
    let dropped = count::to_i64(digits.len() - shortened.len());
    let sign = if mantissa.is_negative() { "-" } else { "" };
    // The exponent of the first digit.
    let order = exponent + count::to_i64(digits.len()) - 1;
    if (-4..0).contains(&order) {
        let zeros = "0".repeat(count::from_u64(order.unsigned_abs() - 1));
        return format!("{sign}0.{zeros}{shortened}");
    }
    if let Ok(order) = usize::try_from(order)
        && exponent <= 0
        && order < 40.max(digits.len())
    {
        let (whole, _) = digits.split_at(order + 1);
        return if exponent + dropped >= 0 {
            format!("{sign}{whole}")
        } else {
            let (_, fraction) = shortened.split_at(order + 1);
            format!("{sign}{whole}.{fraction}")
        };
    }
    let (first, others) = shortened.split_at(1);
    let point = if others.is_empty() { "" } else { "." };
    format!("{sign}{first}{point}{others}e{order}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q(numerator: i64, denominator: i64) -> Rational {
        Rational::from((numerator, denominator))
    }

    #[test]
    fn numbers_are_read_exactly() {
        for (text, numerator, denominator) in [
            ("3", 3, 1),
            ("+3", 3, 1),
            ("-5/13", -5, 13),
            ("0.125", 1, 8),
            ("2.5e-7", 1, 4_000_000),
            ("-1E2", -100, 1),
            ("007", 7, 1),
            ("-0", 0, 1),
        ] {
            assert_eq!(
                parse_rational(text),
                Ok(q(numerator, denominator)),
                "{text}"
            );
        }
        assert!(parse_rational("1e100000").is_ok());
        assert!(parse_rational(&"9".repeat(MOST_DIGITS)).is_ok());
    }

    #[test]
    fn faults_are_named_with_their_place() {
        let unexpected = |found, place| NumberError::Unexpected { found, place };
        for (text, error) in [
            ("", NumberError::MissingDigit { place: 1 }),
            ("-", NumberError::MissingDigit { place: 2 }),
            ("1.", NumberError::MissingDigit { place: 3 }),
            ("1/", NumberError::MissingDigit { place: 3 }),
            ("1e", NumberError::MissingDigit { place: 3 }),
            (" 1", unexpected(' ', 1)),
            ("1.2.3", unexpected('.', 4)),
            ("1/2.5", unexpected('.', 4)),
            ("3·5", unexpected('·', 2)),
            ("--1", unexpected('-', 2)),
            ("1/-2", unexpected('-', 3)),
            ("1/00", NumberError::ZeroDenominator { place: 3 }),
            ("1e100001", NumberError::ExponentTooLarge { place: 3 }),
            ("1e-99999999999", NumberError::ExponentTooLarge { place: 3 }),
        ] {
            assert_eq!(parse_rational(text), Err(error), "{text}");
        }
        let long = "1".repeat(MOST_DIGITS);
        for text in [format!("{long}1"), format!("{long}.1"), format!("{long}/1")] {
            assert_eq!(parse_rational(&text), Err(NumberError::TooManyDigits));
        }
    }

    #[test]
    fn rounding_is_half_away_from_zero() {
        for (numerator, denominator, decimals, text) in [
            (1, 8, 2, "0.13"),
            (-1, 8, 2, "-0.13"),
            (1, 8, 5, "0.12500"),
            (-1, 1000, 2, "0.00"),
            (12345, 100, 0, "123"),
            (1999, 1000, 2, "2.00"),
            (0, 1, 3, "0.000"),
        ] {
            assert_eq!(
                round_to_decimals(&q(numerator, denominator), decimals),
                text
            );
        }
    }

    #[test]
    fn written_mantissas_read_back() {
        for mantissa in [0, 1, -1, 10, 123, -4500, 99_999, 100_000] {
            for exponent in [-60, -9, -6, -5, -4, -3, -1, 0, 1, 2, 60] {
                let mantissa = Integer::from(mantissa);
                let value = Rational::from(&mantissa) * power_of_ten(exponent);
                let text = decimal_text(&mantissa, exponent);
                assert_eq!(parse_rational(&text), Ok(value), "{text}");
            }
        }
    }

    #[test]
    fn leading_digits_round_into_the_next_power() {
        assert_eq!(leading_digits(&q(9996, 10), 3), (Integer::from(100), 1));
        assert_eq!(leading_digits(&q(-1, 3), 3), (Integer::from(-333), -3));
        for power in -30..30 {
            let ten = power_of_ten(power);
            assert_eq!(leading_digits(&ten, 2), (Integer::from(10), power - 1));
        }
    }

    #[test]
    fn leading_digits_are_as_many_as_asked_for() {
        let half = q(1, 2);
        for numerator in 1..2000 {
            for (denominator, digits) in [(1, 1), (7, 2), (20, 3), (1024, 5)] {
                let number = q(-numerator, denominator);
                let (mantissa, exponent) = leading_digits(&number, digits);
                assert_eq!(mantissa.to_string().len(), digits + 1);
                let error = number * power_of_ten(-exponent) - &mantissa;
                assert!(error.cmp_abs(&half).is_le() || mantissa.is_divisible_u(10));
            }
        }
    }
}
