//! Points, lines, curves and turns as they go out.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use rug::Rational;
use serde_json::{Value, json};

use super::numeral::{Numeral, Shown, together};
use super::output;
use super::sharpen::Attempt;
use crate::number::exact::primitive;
use crate::number::{Ball, Number, Surd, Truth};
use crate::plane::projective::{Line, ProjectivePoint};
use crate::plane::{Angle, Point};

impl Attempt {
    /// A number.
    pub fn numeral(&mut self, name: &str, number: &Numeral) -> Value {
        let value = number.shown(self.digits, self.bits);
        self.decided(name, value)
    }

    /// A finite point by its coordinates.
    pub fn coordinates(&mut self, name: &str, point: &[Numeral; 2]) -> Value {
        let value = together(point, self.digits, self.bits);
        self.decided(name, value.map(Value::from))
    }

    /// A finite point.
    pub fn finite_point<K: Shown>(&mut self, name: &str, point: &Point<K>) -> Value {
        self.coordinates(name, &[K::numeral(point.re()), K::numeral(point.im())])
    }

    /// A point, finite or not.
    pub fn point<K: Shown>(&mut self, name: &str, point: &ProjectivePoint<K>) -> Value {
        if point.is_determined().is_no() {
            return json!({"undetermined": true});
        }
        if let Some(finite) = point.finite() {
            return self.finite_point(name, &finite);
        }
        if !point.is_at_infinity().is_yes() {
            return self.decided(name, None);
        }
        let [x, y, _] = point.coordinates();
        match self.direction(&[x.clone(), y.clone()]) {
            Some(numbers) => json!({"at_infinity": numbers}),
            None => self.decided(name, None),
        }
    }

    /// A direction up to a factor.
    pub fn direction<K: Shown>(&mut self, parts: &[Number<K>; 2]) -> Option<Value> {
        let direction = self.normalized(&parts.each_ref().map(K::numeral))?;
        Some(direction.into_iter().map(as_number).collect())
    }

    /// A line, or the coefficients of a curve: up to a common factor.
    pub fn coefficients<K: Shown>(&mut self, name: &str, list: &[Number<K>]) -> Value {
        let numerals: Vec<Numeral> = list.iter().map(K::numeral).collect();
        match self.normalized(&numerals) {
            Some(list) => Value::from(list),
            None => self.decided(name, None),
        }
    }

    /// A line.
    pub fn line<K: Shown>(&mut self, name: &str, line: &Line<K>) -> Value {
        self.coefficients(name, line.coefficients())
    }

    /// Numbers up to a common factor: rational ones as primitive integers, the first that is not zero
    /// positive; others scaled so that the largest is 1.
    fn normalized(&mut self, list: &[Numeral]) -> Option<Vec<Value>> {
        if let Some(rationals) = all(list, Numeral::rational) {
            let integers = primitive(&rationals);
            return Some(integers.iter().map(|i| json!(i.to_string())).collect());
        }
        let scaled = match all(list, exact) {
            Some(surds) => divided_by_largest(&surds, |x| {
                Numeral::Exact(x.clone()).ball(64).0.midpoint_rational()
            })?
            .iter()
            .map(|x| Numeral::Exact(x.clone()))
            .collect(),
            None => self.divided(list)?,
        };
        together(&scaled, self.digits, self.bits)
    }

    /// Enclosures or floats, divided by the largest.
    fn divided(&self, list: &[Numeral]) -> Option<Vec<Numeral>> {
        let floats = all(list, |number| match number {
            Numeral::Float(x) => Some(Number(*x)),
            _ => None,
        });
        if let Some(floats) = floats {
            let scaled = divided_by_largest(&floats, |x| Rational::from_f64(x.0))?;
            return Some(scaled.iter().map(|x| Numeral::Float(x.0)).collect());
        }
        let balls: Vec<Number<Ball>> = list.iter().map(|number| number.ball(self.bits)).collect();
        let scaled = divided_by_largest(&balls, |x| x.0.midpoint_rational())?;
        Some(scaled.into_iter().map(Numeral::Enclosed).collect())
    }

    /// A turn in degrees, above −180 and at most 180.
    pub fn turn<K: Shown>(&mut self, name: &str, turn: &Point<K>) -> Value {
        let degrees = exact_degrees(turn).map(|q| output::exact(&q)).or_else(|| {
            let [x, y] = [turn.re(), turn.im()].map(K::numeral);
            if let (Numeral::Float(x), Numeral::Float(y)) = (&x, &y) {
                return Some(output::float(y.atan2(*x).to_degrees()));
            }
            let [x, y] =
                [x, y].map(|part| Number(part.ball(self.bits).0.with_precision(self.bits)));
            let scale = 180 / Number::pi(&self.bits);
            let degrees = y.clone().atan2(&x) * &scale;
            output::enclosure(&degrees, self.digits).or_else(|| {
                // Next to 0° or to the cut at 180° the digits are those of a degree.
                let degrees = if x.sign() == Some(Ordering::Less) {
                    180 + (-y).atan2(&-x) * scale
                } else {
                    degrees
                };
                output::enclosure_beside(&degrees, &Rational::from(1), self.digits)
            })
        });
        let degrees = self.decided(name, degrees);
        json!({"degrees": degrees})
    }
}

fn all<T>(list: &[Numeral], convert: impl Fn(&Numeral) -> Option<T>) -> Option<Vec<T>> {
    list.iter().map(convert).collect()
}

fn exact(number: &Numeral) -> Option<Number<Surd>> {
    match number {
        Numeral::Exact(surd) => Some(surd.clone()),
        _ => None,
    }
}

/// An integer of a normal form as a number.
fn as_number(value: Value) -> Value {
    match value {
        Value::String(integer) => json!({"exact": integer}),
        other => other,
    }
}

/// All divided by the largest; where all are zero, themselves.
fn divided_by_largest<K: Shown>(
    list: &[Number<K>],
    size: impl Fn(&Number<K>) -> Option<Rational>,
) -> Option<Vec<Number<K>>> {
    let sizes: Option<Vec<Rational>> = list.iter().map(|x| Some(size(x)?.abs())).collect();
    let sizes = sizes?;
    let mut largest = 0;
    for (place, size) in sizes.iter().enumerate() {
        if sizes.get(largest).is_some_and(|most| size > most) {
            largest = place;
        }
    }
    let divisor = list.get(largest)?;
    if divisor.is_zero().is_yes() {
        return Some(list.to_vec());
    }
    let scaled = list.iter().enumerate().map(|(place, x)| {
        if place == largest {
            Number::one()
        } else {
            x / divisor
        }
    });
    Some(scaled.collect())
}

/// The degrees of an exact turn that is a multiple of 15°.
fn exact_degrees<K: Shown>(turn: &Point<K>) -> Option<Rational> {
    let part = |number: &Number<K>| {
        let numeral = K::numeral(number);
        exact(&numeral).or_else(|| Some(numeral.rational()?.into()))
    };
    let [x, y] = [part(turn.re())?, part(turn.im())?];
    let turn = Angle::of(Number::complex(x, y));
    multiple_of_15_degrees(-11..=12, |angle| angle.equals(&turn))
}

/// The multiple of 15° among these steps that an exact angle is.
pub fn multiple_of_15_degrees(
    mut steps: RangeInclusive<i32>,
    is: impl Fn(&Angle<Surd>) -> Truth,
) -> Option<Rational> {
    steps.find_map(|step| {
        let degrees = Rational::from(15 * step);
        let angle = Angle::from_degrees(&degrees, &())?;
        is(&angle).is_yes().then_some(degrees)
    })
}
