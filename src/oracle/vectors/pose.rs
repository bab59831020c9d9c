//! Positions on their way into a problem.

use rug::Rational;
use serde_json::{Value, json};

use crate::number::{Exact, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

pub type Position = Displacement<Exact>;

/// The rational number as it is written in a problem.
pub fn text(number: &Number<Exact>) -> String {
    number.to_string()
}

pub fn point(z: &Point<Exact>) -> Value {
    json!([text(z.re()), text(z.im())])
}

pub fn angle(turn: &Point<Exact>) -> Value {
    json!({"cos": text(turn.re()), "sin": text(turn.im())})
}

/// By x, y, cosine and sine.
pub fn position(position: &Position) -> Value {
    let Displacement {
        rotation,
        translation,
    } = position;
    json!({"x": text(translation.re()), "y": text(translation.im()), "angle": angle(rotation)})
}

pub fn positions(list: &[Position]) -> Value {
    list.iter().map(position).collect()
}

/// A problem that has nothing but positions.
pub fn problem(name: &str, list: &[Position]) -> Value {
    json!({"problem": name, "positions": positions(list)})
}

/// Integers as a point.
pub fn at(x: i64, y: i64) -> Point<Exact> {
    Number::complex(x.into(), y.into())
}

/// The position with this turn in which a point of the moving plane has this place.
pub fn with_point_at(turn: &Point<Exact>, point: &Point<Exact>, place: &Point<Exact>) -> Position {
    Displacement {
        translation: place - turn * point,
        rotation: turn.clone(),
    }
}

/// 10^−digits.
pub fn tenth(digits: u32) -> Rational {
    Rational::from((1, rug::Integer::from(rug::Integer::u_pow_u(10, digits))))
}
