//! Numbers of answers, certified and given, without any rounding.

use rug::Rational;
use serde_json::Value;

use super::read::Misread;
use crate::number::text::parse_rational;

/// A number known within a radius; a candidate's number is taken exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// The middle.
    pub value: Rational,
    /// How far the true number may be away.
    pub radius: Rational,
}

impl Known {
    /// A JSON number, a text, or a NUMBER as `solve` writes it.
    pub fn read(value: &Value, place: &str) -> Result<Known, Misread> {
        match value {
            Value::Object(fields) => {
                let middle = fields.get("exact").or_else(|| fields.get("value"));
                let middle = middle.ok_or_else(|| Misread::expected("a number", value, place))?;
                let radius = fields.get("radius");
                Ok(Known {
                    value: plain(middle, place)?,
                    radius: radius.map_or(Ok(Rational::new()), |radius| plain(radius, place))?,
                })
            }
            _ => Ok(Known {
                value: plain(value, place)?,
                radius: Rational::new(),
            }),
        }
    }
}

fn plain(value: &Value, place: &str) -> Result<Rational, Misread> {
    let text = match value {
        Value::Number(number) => number.to_string(),
        Value::String(text) => text.clone(),
        _ => return Err(Misread::expected("a number", value, place)),
    };
    parse_rational(&text).map_err(|error| Misread(format!("{place}: {error}")))
}
