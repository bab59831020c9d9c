//! Numbers as they go out.

use rug::{Integer, Rational};
use serde_json::{Value, json};

use crate::number::text::parse_rational;
use crate::number::{Ball, Number, Surd, count};

/// An exact rational number.
pub fn exact(q: &Rational) -> Value {
    json!({"exact": q.to_string()})
}

/// An enclosure of so many digits: its radius is at most 10^−digits of the value. `None` while the
/// ball is not that sharp.
pub fn enclosure(number: &Number<Ball>, digits: u32) -> Option<Value> {
    enclosure_beside(number, &Rational::new(), digits)
}

/// An enclosure whose radius is at most 10^−digits of the value, or of a size that is given: that of
/// the largest number that belongs to it. `None` while the ball is not that sharp.
pub fn enclosure_beside(number: &Number<Ball>, size: &Rational, digits: u32) -> Option<Value> {
    let mid = number.0.midpoint_rational()?;
    if number.0.radius_rational()?.is_zero() {
        return Some(exact(&mid));
    }
    let text = number.0.to_decimal(count::from_u32(digits) + 2)?;
    let (value, radius) = (
        parse_rational(&text.value).ok()?,
        parse_rational(&text.radius).ok()?,
    );
    let unit = Rational::from((1, Integer::from(Integer::u_pow_u(10, digits))));
    let size = value.abs().max(size.clone());
    (radius <= size * unit).then(|| json!({"value": text.value, "radius": text.radius}))
}

/// What the largest of these numbers surely reaches in absolute value.
pub fn least_size(numbers: &[Number<Ball>]) -> Rational {
    let least = |number: &Number<Ball>| -> Option<Rational> {
        Some(number.0.midpoint_rational()?.abs() - number.0.radius_rational()?)
    };
    numbers
        .iter()
        .filter_map(least)
        .fold(Rational::new(), Rational::max)
}

/// An exact number: itself where it is rational, else an enclosure.
pub fn surd(number: &Number<Surd>, digits: u32, bits: u32) -> Option<Value> {
    match number.0.rational() {
        Some(q) => Some(exact(q)),
        None => enclosure(&number.0.enclosure(bits), digits),
    }
}

/// A float; null where it is none.
pub fn float(x: f64) -> Value {
    json!(x)
}

/// All certified numbers become plain floats.
pub fn into_floats(value: &mut Value) {
    if let Some(number) = as_float(value) {
        *value = float(number);
        return;
    }
    match value {
        Value::Array(members) => members.iter_mut().for_each(into_floats),
        Value::Object(fields) => fields.values_mut().for_each(into_floats),
        _ => {}
    }
}

/// The float next to a number that went out; `None` for anything else.
pub fn as_float(value: &Value) -> Option<f64> {
    let fields = value.as_object()?;
    let text = fields
        .get("exact")
        .or_else(|| fields.get("value"))?
        .as_str()?;
    Some(parse_rational(text).ok()?.to_f64())
}
