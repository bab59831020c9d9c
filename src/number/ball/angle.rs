//! Cosine and sine of an angle given exactly, in degrees.

use rug::{Integer, Rational};

use super::constant::Constant;
use super::enclosure::Enclosure;
use crate::number::degrees;

/// Bits lost in the product of π and the angle, and some more.
const EXTRA_BITS: u32 = 24;

/// Cosine and sine; exact where they are rational.
pub(super) fn cos_sin(q: &Rational, precision: u32) -> (Enclosure, Enclosure) {
    if let Some(quarter) = degrees::quarter_turns(q) {
        let (cos, sin) = degrees::cos_sin_of_quarter_turns(quarter);
        return (exact(cos, precision), exact(sin, precision));
    }
    let (mut cos, mut sin) = from_pi(q, precision);
    // A step of 60° is here no multiple of 180°, and an odd step of 30° no multiple of 90°.
    if let Some(step) = degrees::whole_steps(q, 60, 6) {
        cos = half(matches!(step, 1 | 5), precision);
    } else if let Some(step) = degrees::whole_steps(q, 30, 12) {
        sin = half(step < 6, precision);
    }
    (cos, sin)
}

/// By the angle's distance from the nearest quarter turn, taken exactly, so that small values keep
/// their relative accuracy.
fn from_pi(q: &Rational, precision: u32) -> (Enclosure, Enclosure) {
    let turns = Integer::from(Rational::from(q / 90u32).round().numer());
    let rest = q - Rational::from(&turns * 90u32);
    let mut angle = Enclosure::pi(precision + EXTRA_BITS);
    angle.mul(&Enclosure::from_rational(
        &(rest / 180u32),
        precision + EXTRA_BITS,
    ));
    let (mut cos, mut sin) = (angle.clone(), angle);
    cos.cos();
    sin.sin();
    cos.set_precision(precision);
    sin.set_precision(precision);
    rotate(cos, sin, turns.mod_u(4))
}

/// Turns the direction by a number of quarter turns.
fn rotate(mut cos: Enclosure, mut sin: Enclosure, quarter: u32) -> (Enclosure, Enclosure) {
    if quarter >= 2 {
        cos.negate();
        sin.negate();
    }
    if quarter % 2 == 1 {
        sin.negate();
        (sin, cos)
    } else {
        (cos, sin)
    }
}

fn exact(i: i64, precision: u32) -> Enclosure {
    Enclosure::from_constant(&Constant::Integer(i), precision)
}

/// ±1/2.
fn half(positive: bool, precision: u32) -> Enclosure {
    let mut result = exact(if positive { 1 } else { -1 }, precision);
    result.div_integer(2);
    result
}
