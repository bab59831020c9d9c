//! Numbers of an answer, as the sets that they claim to be.

use rug::{Integer, Rational};
use serde_json::Value;

use super::{Defect, require};
use crate::number::text::parse_rational;
use crate::number::{Ball, Complex, Exact, Number};

/// More bits are not checked with.
const MOST_BITS: u32 = 1 << 20;

/// All numbers within a radius, 0 for an exact one.
#[derive(Clone, Debug)]
pub struct Shown {
    pub value: Rational,
    pub radius: Rational,
}

impl Shown {
    pub fn read(value: &Value, place: &str) -> Result<Self, Defect> {
        let no_number = || Defect::wrong(place, format!("{value} is no number of an answer"));
        let number = |name: &str| {
            let text = value.get(name).and_then(Value::as_str);
            text.and_then(|text| parse_rational(text).ok())
        };
        if let Some(value) = number("exact") {
            return Ok(Shown {
                value,
                radius: Rational::new(),
            });
        }
        let (value, radius) = number("value")
            .zip(number("radius"))
            .ok_or_else(no_number)?;
        if radius.cmp0().is_le() {
            return Err(Defect::wrong(place, "an enclosure needs a positive radius"));
        }
        Ok(Shown { value, radius })
    }

    pub fn is_exact(&self) -> bool {
        self.radius.is_zero()
    }

    /// The set as a ball.
    pub fn ball(&self, bits: u32) -> Number<Ball> {
        if self.is_exact() {
            return Number::from(self.value.clone());
        }
        Number(Ball::with_radius(&self.value, &self.radius, bits))
    }

    /// Whether all of an enclosure lies within; an exact number must lie in the enclosure.
    pub fn holds(&self, truth: &Number<Ball>) -> bool {
        if self.is_exact() {
            return !truth.0.is_whole_line() && truth.0.contains(&self.value);
        }
        let (Some(low), Some(high)) = (truth.0.lower(), truth.0.upper()) else {
            return false;
        };
        low >= Rational::from(&self.value - &self.radius)
            && high <= Rational::from(&self.value + &self.radius)
    }

    /// Whether the radius is at most 10^−digits of the value or of a size that belongs to it.
    pub fn is_sharp(&self, size: &Rational, digits: u32) -> bool {
        let unit = Rational::from((1, Integer::from(Integer::u_pow_u(10, digits))));
        let size = self.value.clone().abs().max(size.clone());
        self.radius <= size * unit
    }
}

/// The largest of several numbers in absolute value.
pub fn size<'a>(numbers: impl IntoIterator<Item = &'a Shown>) -> Rational {
    numbers
        .into_iter()
        .map(|number| number.value.clone().abs())
        .fold(Rational::new(), Rational::max)
}

/// A coordinate of a pair that may be complex: real and imaginary part.
#[derive(Clone, Debug)]
pub struct Coordinate {
    pub re: Shown,
    pub im: Shown,
}

impl Coordinate {
    pub fn read(value: &Value, place: &str) -> Result<Self, Defect> {
        let zero = Shown {
            value: Rational::new(),
            radius: Rational::new(),
        };
        match value.get("re") {
            Some(re) => Ok(Coordinate {
                re: Shown::read(re, place)?,
                im: Shown::read(&value["im"], place)?,
            }),
            None => Ok(Coordinate {
                re: Shown::read(value, place)?,
                im: zero,
            }),
        }
    }

    pub fn ball(&self, bits: u32) -> Number<Complex<Ball>> {
        Number::complex(self.re.ball(bits), self.im.ball(bits))
    }

    /// Whether an enclosure has anything in common with it.
    pub fn meets(&self, truth: &Number<Complex<Ball>>, bits: u32) -> bool {
        let own = self.ball(bits);
        own.re().0.overlaps(&truth.re().0) && own.im().0.overlaps(&truth.im().0)
    }

    pub fn holds(&self, truth: &Number<Complex<Ball>>) -> bool {
        self.re.holds(truth.re()) && self.im.holds(truth.im())
    }
}

/// Two coordinates, with so many digits.
pub fn point(value: &Value, place: &str, digits: u32) -> Result<[Coordinate; 2], Defect> {
    let [x, y] = [&value[0], &value[1]].map(|part| Coordinate::read(part, place));
    let point = [x?, y?];
    let parts = || point.iter().flat_map(|c| [&c.re, &c.im]);
    let size = size(parts());
    if parts().all(|part| part.is_sharp(&size, digits)) {
        Ok(point)
    } else {
        Err(Defect::wrong(
            place,
            "the radius is larger than the digits allow",
        ))
    }
}

/// Passes where a number holds what it stands for, and is as sharp as the digits ask.
pub fn holds(value: &Value, place: &str, truth: &Number<Ball>, digits: u32) -> Result<(), Defect> {
    let shown = Shown::read(value, place)?;
    let sharp = shown.is_sharp(&Rational::new(), digits);
    require(sharp, place, "the radius is larger than the digits allow")?;
    if truth.0.is_whole_line() {
        return Err(Defect::unchecked(format!("{place} is not known sharply")));
    }
    require(shown.holds(truth), place, "the digits do not hold it")
}

/// A rational number of the answer.
pub fn exact(answer: &Value, name: &str) -> Result<Number<Exact>, Defect> {
    let shown = Shown::read(&answer[name], name)?;
    require(shown.is_exact(), name, "an exact number was expected")?;
    Ok(Number::from(shown.value))
}

/// A field that is not null; one that is must be named as undecided.
pub fn decided<'a>(answer: &Value, value: &'a Value, name: &str) -> Result<&'a Value, Defect> {
    if !value.is_null() {
        return Ok(value);
    }
    let undecided = answer["undecided"].as_str().unwrap_or_default();
    require(
        undecided.split(", ").any(|one| one == name),
        name,
        "a value is missing",
    )?;
    Err(Defect::unchecked(format!(
        "the answer leaves {name} undecided"
    )))
}

/// How many digits the answer says that it has.
pub fn digits(answer: &Value) -> Result<u32, Defect> {
    let digits = answer["digits"].as_u64();
    let digits = digits.and_then(|digits| u32::try_from(digits).ok());
    digits
        .filter(|digits| (1..=100_000).contains(digits))
        .ok_or_else(|| Defect::wrong("digits", "a number of digits was expected"))
}

/// Bits to check an answer with: for its digits, and for its smallest radius.
pub fn bits(answer: &Value) -> Result<u32, Defect> {
    let asked = digits(answer)?.saturating_mul(8).saturating_add(256);
    Ok(asked.max(finest(answer).saturating_add(512)).min(MOST_BITS))
}

/// Bits of the smallest radius.
fn finest(value: &Value) -> u32 {
    match value {
        Value::Object(fields) => {
            let radius = fields.get("radius").and_then(Value::as_str);
            let radius = radius.and_then(|text| parse_rational(text).ok());
            let own = radius.map_or(0, |radius| {
                let (above, below) = (radius.numer(), radius.denom());
                below
                    .significant_bits()
                    .saturating_sub(above.significant_bits())
            });
            fields.values().map(finest).fold(own, u32::max)
        }
        Value::Array(members) => members.iter().map(finest).fold(0, u32::max),
        _ => 0,
    }
}

/// A list of the answer.
pub fn list<'a>(answer: &'a Value, name: &str) -> Result<&'a [Value], Defect> {
    match &answer[name] {
        Value::Array(list) => Ok(list),
        Value::Null => Err(Defect::unchecked(format!(
            "the answer leaves {name} undecided"
        ))),
        _ => Err(Defect::wrong(name, "a list was expected")),
    }
}
