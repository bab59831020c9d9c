//! The values that formulas compute with.

use rug::Rational;

use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point};

/// A value of the language, over number kind `K`.
#[derive(Clone, Debug)]
pub enum Value<K> {
    /// A real number.
    Number(Number<K>),
    /// A complex number, which is also a point of the plane.
    Point(Point<K>),
    /// An angle.
    Angle(Angle<K>),
    /// A rational multiple of π (`pi/2`, `72.5 deg`): an angle as soon as it meets one.
    Turn(Rational),
    /// A line, as the coefficients of A x + B y + C = 0.
    Line([Number<K>; 3]),
    /// Several values in order.
    List(Vec<Value<K>>),
    /// Several values without order: both values of `±`, the roots of an equation.
    Set(Vec<Value<K>>),
}

impl<K: Kind> Value<K> {
    /// What the value is, with an article, for messages.
    pub fn kind_name(&self) -> &'static str {
        match self {
            Value::Number(_) => "a number",
            Value::Point(_) => "a point (complex number)",
            Value::Angle(_) => "an angle",
            Value::Turn(_) => "an angle (multiple of pi)",
            Value::Line(_) => "a line",
            Value::List(_) => "a list",
            Value::Set(_) => "a set",
        }
    }

    /// `false` for the result of an undefined operation.
    pub fn has_value(&self) -> bool {
        match self {
            Value::Number(x) => x.has_value(),
            Value::Point(z) => z.has_value(),
            Value::Angle(angle) => angle.has_value(),
            Value::Turn(_) => true,
            Value::Line(coefficients) => coefficients.iter().all(Number::has_value),
            Value::List(members) | Value::Set(members) => members.iter().all(Value::has_value),
        }
    }

    /// Whether a number in it is too large to go on with.
    pub fn is_excessive(&self) -> bool {
        match self {
            Value::Number(x) => x.is_excessive(),
            Value::Point(z) => z.is_excessive(),
            Value::Angle(angle) => angle.direction().is_excessive(),
            Value::Turn(_) => false,
            Value::Line(coefficients) => coefficients.iter().any(Number::is_excessive),
            // Their members have been looked at.
            Value::List(_) | Value::Set(_) => false,
        }
    }

    /// Whether values of this kind can be added.
    pub fn has_sum(&self) -> bool {
        matches!(
            self,
            Value::Number(_) | Value::Point(_) | Value::Angle(_) | Value::Turn(_)
        )
    }

    /// As a complex number, where it is one.
    pub fn to_point(&self) -> Option<Point<K>> {
        match self {
            Value::Number(x) => Some(x.clone().into()),
            Value::Point(z) => Some(z.clone()),
            _ => None,
        }
    }
}

impl<K: Real> Value<K> {
    /// As an angle, where it is one and the kind holds it.
    pub fn to_angle(&self, precision: &K::Precision) -> Option<Angle<K>> {
        match self {
            Value::Angle(angle) => Some(angle.clone()),
            Value::Turn(turn) => Angle::from_degrees(&Rational::from(turn * 180), precision),
            _ => None,
        }
    }
}

impl<K> From<Number<K>> for Value<K> {
    fn from(number: Number<K>) -> Self {
        Value::Number(number)
    }
}

impl<K> From<Angle<K>> for Value<K> {
    fn from(angle: Angle<K>) -> Self {
        Value::Angle(angle)
    }
}

impl<K> From<Point<K>> for Value<K> {
    fn from(point: Point<K>) -> Self {
        Value::Point(point)
    }
}
