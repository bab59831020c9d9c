//! A printed number: a string, and the interval that it stands for.

use rug::Rational;
use thiserror::Error;

use crate::number::text::parse_rational;

/// A decimal as printed: its value and the unit of its last digit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed {
    /// The number that the digits say.
    pub value: Rational,
    /// One unit of the last digit.
    pub unit: Rational,
    /// How many digits stand after the point.
    pub decimals: u32,
}

/// A string that is no decimal.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("`{0}` is no decimal number")]
pub struct NoDecimal(String);

impl Printed {
    /// Reads a decimal with digits after its point (`0.8404`, `-.5711`); an integer is no
    /// measurement but means equality, and is not read here.
    pub fn read(text: &str) -> Result<Self, NoDecimal> {
        let no_decimal = || NoDecimal(text.to_owned());
        let (_, fraction) = text.split_once('.').ok_or_else(no_decimal)?;
        if fraction.is_empty() || !fraction.bytes().all(|byte| byte.is_ascii_digit()) {
            return Err(no_decimal());
        }
        let decimals = u32::try_from(fraction.len()).map_err(|_| no_decimal())?;
        let padded = match text.strip_prefix('-') {
            Some(rest) if rest.starts_with('.') => format!("-0{rest}"),
            None if text.starts_with('.') => format!("0{text}"),
            _ => text.to_owned(),
        };
        let value = parse_rational(&padded).map_err(|_| no_decimal())?;
        let unit = parse_rational(&format!("1e-{decimals}")).map_err(|_| no_decimal())?;
        Ok(Printed {
            value,
            unit,
            decimals,
        })
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
