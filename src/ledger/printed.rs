//! A printed number: a string, and the interval that it stands for.

use rug::{Integer, Rational};
use thiserror::Error;

use crate::number::text::{parse_rational, round_to_decimals};

/// A decimal as printed: its value and the unit of its last digit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed {
    /// The number that the digits say.
    pub value: Rational,
    /// One unit of the last digit.
    pub unit: Rational,
    /// How many digits stand after the point.
    decimals: u32,
    /// The power of ten that stands after a comma, as in `.39753037, 00`.
    power: Option<i32>,
}

/// A string that is no decimal.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("`{0}` is no decimal number")]
pub struct NoDecimal(String);

impl Printed {
    /// Reads a decimal with digits after its point (`0.8404`, `-.5711`, `+32.000`), with or without a
    /// power of ten after a comma (`.39753037, 00`, `-.34803430,-02`); an integer is no measurement but
    /// means equality, and is not read here.
    pub fn read(text: &str) -> Result<Self, NoDecimal> {
        Self::parts(text).ok_or_else(|| NoDecimal(text.to_owned()))
    }

    fn parts(text: &str) -> Option<Self> {
        let (mantissa, power) = match text.split_once(',') {
            Some((mantissa, power)) => (mantissa, Some(read_power(power)?)),
            None => (text, None),
        };
        let mantissa = mantissa.replacen("- ", "-", 1);
        let (whole, fraction) = mantissa.split_once('.')?;
        let is_digits = |digits: &str| digits.bytes().all(|byte| byte.is_ascii_digit());
        let magnitude = whole.strip_prefix(['-', '+']).unwrap_or(whole);
        if fraction.is_empty() || !is_digits(fraction) || !is_digits(magnitude) {
            return None;
        }
        let sign = if whole.starts_with('-') { "-" } else { "" };
        let decimals = u32::try_from(fraction.len()).ok()?;
        let power_text = power.unwrap_or(0);
        let value = parse_rational(&format!("{sign}0{magnitude}.{fraction}e{power_text}")).ok()?;
        let unit = parse_rational(&format!("1e-{decimals}")).ok()?;
        let unit = unit * parse_rational(&format!("1e{power_text}")).ok()?;
        Some(Printed {
            value,
            unit,
            decimals,
            power,
        })
    }

    /// Another number in the same notation, with as many digits.
    pub fn like(&self, q: &Rational) -> String {
        if self.power.is_none() {
            return round_to_decimals(q, self.decimals);
        }
        // The mantissa has its first digit behind the point.
        let size = |power| Rational::from(scaled(q, power).abs_ref());
        let fits = |power: &i32| size(*power) < 1 && size(power - 1) >= 1;
        let power = (-MOST_POWER..MOST_POWER).find(fits).unwrap_or(0);
        let mantissa = scaled(q, power);
        let digits = round_to_decimals(&mantissa, self.decimals).replacen("0.", ".", 1);
        let sign = if power < 0 { "-" } else { "" };
        format!("{digits}, {sign}{:02}", power.unsigned_abs())
    }

    /// Whether every number from `low` to `high` would round to this print.
    pub fn covers(&self, low: &Rational, high: &Rational) -> bool {
        let half = Rational::from(&self.unit / 2);
        Rational::from(&self.value - &half) <= *low && *high <= Rational::from(&self.value + &half)
    }

    /// Whether no number from `low` to `high` would round to this print.
    pub fn excludes(&self, low: &Rational, high: &Rational) -> bool {
        let half = Rational::from(&self.unit / 2);
        *high < Rational::from(&self.value - &half) || Rational::from(&self.value + &half) < *low
    }

    /// Whether some number from `low` to `high` is rounded or cut to this print.
    pub fn is_within(&self, low: &Rational, high: &Rational) -> bool {
        let half = Rational::from(&self.unit / 2);
        let [outwards, inwards] = if self.value.cmp0().is_lt() {
            [-self.unit.clone(), half]
        } else {
            [self.unit.clone(), -half]
        };
        let [outer, inner] = [outwards, inwards].map(|end| &self.value + end);
        let (least, greatest) = if outer < inner {
            (outer, inner)
        } else {
            (inner, outer)
        };
        *low <= greatest && least <= *high
    }

    /// Whether every number from `low` to `high` gives this print when its further digits are cut.
    pub fn is_cut_of(&self, low: &Rational, high: &Rational) -> bool {
        let size = |q: &Rational| Rational::from(q.abs_ref());
        let (near, far) = if size(low) <= size(high) {
            (size(low), size(high))
        } else {
            (size(high), size(low))
        };
        let same_side = low.cmp0() == high.cmp0() && low.cmp0() == self.value.cmp0();
        let printed = size(&self.value);
        same_side && printed <= near && far < Rational::from(&printed + &self.unit)
    }
}

/// Beyond it nothing is printed.
const MOST_POWER: i32 = 100;

/// `00`, ` 01`, `-02`; and `.02`, as a spot before the digits was read.
fn read_power(text: &str) -> Option<i32> {
    let text = text.trim();
    text.strip_prefix('.').unwrap_or(text).parse().ok()
}

/// q/10ᵖ.
fn scaled(q: &Rational, power: i32) -> Rational {
    let ten = Rational::from(Integer::u_pow_u(10, power.unsigned_abs()));
    if power < 0 { q * ten } else { q / ten }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Rational {
        Printed::read(text).unwrap().value
    }

    #[test]
    fn notations_of_the_sources_are_read() {
        assert_eq!(value("+32.000"), 32);
        assert_eq!(value("-.5711"), Rational::from((-5711, 10_000)));
        assert_eq!(value("- .01280350"), Rational::from((-128_035, 10_000_000)));
        assert_eq!(
            value(".39753037, 00"),
            Rational::from((39_753_037, 100_000_000))
        );
        assert_eq!(
            value("-.34803430,-02"),
            Rational::from((-34_803_430, 10_000_000_000_i64))
        );
        assert_eq!(
            value("-.14204014,.02"),
            Rational::from((-14_204_014, 1_000_000))
        );
        for no_decimal in ["62", "1.", "a.5", "--.5", ".5, x", "1 .5", ""] {
            assert!(Printed::read(no_decimal).is_err(), "{no_decimal}");
        }
    }

    #[test]
    fn other_numbers_are_written_alike() {
        let like = |text: &str, n: i64, d: i64| Printed::read(text).unwrap().like(&(n, d).into());
        assert_eq!(like("+32.000", -32, 1), "-32.000");
        assert_eq!(like(".39753037, 00", 1, 3), ".33333333, 00");
        assert_eq!(like(".39753037, 00", -25, 1), "-.25000000, 02");
        assert_eq!(like(".11262542, -03", 1, 300), ".33333333, -02");
    }

    #[test]
    fn a_cut_needs_all_numbers_to_give_the_print() {
        let thousandths = |x: i64| Rational::from((x, 1000));
        for (low, high, is_cut) in [
            (1231, 1239, true),
            (1230, 1230, true),
            (1231, 1241, false),
            (1229, 1239, false),
            (-1239, -1231, false),
        ] {
            let found = |text: &str, sign: i64| {
                let mut ends = [sign * low, sign * high];
                ends.sort_unstable();
                let [low, high] = ends.map(thousandths);
                Printed::read(text).unwrap().is_cut_of(&low, &high)
            };
            assert_eq!(found("1.23", 1), is_cut, "{low} to {high}");
            assert_eq!(found("-1.23", -1), is_cut, "-{high} to -{low}");
        }
    }
}
