//! Numbers as they go out.

use rug::{Integer, Rational};
use serde_json::{Value, json};

use crate::number::text::parse_rational;
use crate::number::{Ball, Number, Surd};

/// An exact rational number.
pub fn exact(q: &Rational) -> Value {
    json!({"exact": q.to_string()})
}

/// An enclosure of so many digits: its radius is at most 10^−digits of the value. `None` while the
/// ball is not that sharp.
pub fn enclosure(number: &Number<Ball>, digits: u32) -> Option<Value> {
    let mid = number.0.midpoint_rational()?;
    if mid.is_zero() && number.0.radius_rational()?.is_zero() {
        return Some(json!({"exact": "0"}));
    }
    let text = number.0.to_decimal(digits as usize + 2)?;
    let (value, radius) = (
        parse_rational(&text.value).ok()?,
        parse_rational(&text.radius).ok()?,
    );
    let unit = Rational::from((1, Integer::from(Integer::u_pow_u(10, digits))));
    (radius <= value.abs() * unit).then(|| json!({"value": text.value, "radius": text.radius}))
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
