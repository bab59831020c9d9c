//! Numbers on their way out, whatever they were computed with.

use rug::Rational;
use serde_json::Value;

use super::output;
use crate::number::{Ball, Exact, Kind, Number, Real, Surd};

/// A number that can be shown.
#[derive(Clone, Debug)]
pub enum Numeral {
    /// Known exactly.
    Exact(Number<Surd>),
    /// Known within a radius.
    Enclosed(Number<Ball>),
    /// Not certified.
    Float(f64),
}

/// The kinds that answers are computed in.
pub trait Shown: Real {
    /// The number as it will be shown.
    fn numeral(number: &Number<Self>) -> Numeral;
}

impl Shown for Exact {
    fn numeral(number: &Number<Self>) -> Numeral {
        let no_value = || Number::zero().inverse();
        Numeral::Exact(
            number
                .0
                .rational()
                .map_or_else(no_value, |q| q.clone().into()),
        )
    }
}

impl Shown for Surd {
    fn numeral(number: &Number<Self>) -> Numeral {
        Numeral::Exact(number.clone())
    }
}

impl Shown for Ball {
    fn numeral(number: &Number<Self>) -> Numeral {
        Numeral::Enclosed(number.clone())
    }
}

impl Shown for f64 {
    fn numeral(number: &Number<Self>) -> Numeral {
        Numeral::Float(number.0)
    }
}

impl Numeral {
    /// An enclosure; of a float, the float itself.
    pub fn ball(&self, bits: u32) -> Number<Ball> {
        match self {
            Numeral::Exact(surd) => match surd.0.rational() {
                Some(q) => Number::rounded(q, &bits),
                None => surd.0.enclosure(bits),
            },
            Numeral::Enclosed(ball) => ball.clone(),
            Numeral::Float(x) => Number(f64_to_ball(*x)),
        }
    }

    /// The square root, exact where sums of square roots hold it.
    pub fn sqrt(&self, bits: u32) -> Numeral {
        match self {
            Numeral::Float(x) => Numeral::Float(x.sqrt()),
            Numeral::Exact(surd) => {
                let root = surd.clone().sqrt();
                if root.has_value() {
                    Numeral::Exact(root)
                } else {
                    Numeral::Enclosed(self.ball(bits).sqrt())
                }
            }
            Numeral::Enclosed(ball) => {
                let root = ball.clone().sqrt();
                if root.0.is_whole_line() {
                    // A constant whose root is irrational.
                    Numeral::Enclosed(Number(ball.0.with_precision(bits)).sqrt())
                } else {
                    Numeral::Enclosed(root)
                }
            }
        }
    }

    /// `self` + `factor` · `root`.
    pub fn plus_product(&self, factor: &Numeral, root: &Numeral, bits: u32) -> Numeral {
        match (self, factor, root) {
            (Numeral::Exact(a), Numeral::Exact(b), Numeral::Exact(c)) => Numeral::Exact(a + b * c),
            (Numeral::Float(a), Numeral::Float(b), Numeral::Float(c)) => Numeral::Float(a + b * c),
            _ => Numeral::Enclosed(self.ball(bits) + factor.ball(bits) * root.ball(bits)),
        }
    }

    /// The rational number, where it is known to be one.
    pub fn rational(&self) -> Option<Rational> {
        match self {
            Numeral::Exact(surd) => surd.0.rational().cloned(),
            Numeral::Enclosed(ball) if ball.0.radius_rational()?.is_zero() => {
                ball.0.midpoint_rational()
            }
            Numeral::Enclosed(_) | Numeral::Float(_) => None,
        }
    }

    /// As it goes out by itself; `None` while it is not that sharp.
    pub fn shown(&self, digits: u32, bits: u32) -> Option<Value> {
        match self {
            Numeral::Exact(surd) => output::surd(surd, digits, bits),
            Numeral::Enclosed(ball) => output::enclosure(ball, digits),
            Numeral::Float(x) => Some(output::float(*x)),
        }
    }
}

/// A float as the number that it is; no value for none.
fn f64_to_ball(x: f64) -> Ball {
    Rational::from_f64(x).map_or_else(
        || (Number::<Ball>::one() / Number::zero()).0,
        Ball::constant,
    )
}

/// Several numbers that belong together, like the coordinates of a point: the digits are those of the
/// largest. `None` while one of them is not that sharp.
pub fn together(numbers: &[Numeral], digits: u32, bits: u32) -> Option<Vec<Value>> {
    let balls: Vec<_> = numbers.iter().map(|number| number.ball(bits)).collect();
    let scale = output::least_size(&balls);
    numbers
        .iter()
        .map(|number| match number {
            Numeral::Enclosed(ball) => output::enclosure_beside(ball, &scale, digits),
            other => other.shown(digits, bits),
        })
        .collect()
}
