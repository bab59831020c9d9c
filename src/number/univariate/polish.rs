//! Newton's method without proof: from an isolated root to as many bits as wanted. What it finds is
//! a proposal, proven where it is used.

use rug::{Float, Integer};

use super::integer::IntegerPolynomial;
use super::point::Point;

/// Bits beyond those that are wanted.
const GUARD_BITS: u32 = 64;

/// Precisions that double, the last one as wanted.
fn ladder(from: u32, to: u32) -> Vec<u32> {
    let mut steps = Vec::new();
    let mut bits = to;
    while bits > from.max(16) {
        steps.push(bits);
        bits = bits / 2 + 4;
    }
    steps.reverse();
    steps
}

/// A real root from one that is known to so many bits.
pub(super) fn real(p: &IntegerPolynomial, near: &Float, from: u32, to: u32) -> Float {
    let mut x = near.clone();
    let mut before = from;
    for bits in ladder(from, to).into_iter().map(|bits| bits + GUARD_BITS) {
        x.set_prec(bits);
        let mut value = Float::new(bits);
        for c in p.coefficients().iter().rev() {
            value *= &x;
            value += c;
        }
        let short = before + GUARD_BITS;
        let slope = slope(p, &Float::with_val(short, &x));
        value.set_prec(short);
        x -= value / slope;
        before = bits;
    }
    x
}

fn slope(p: &IntegerPolynomial, x: &Float) -> Float {
    let mut slope = Float::new(x.prec());
    for (power, c) in descending(p) {
        slope *= x;
        slope += Integer::from(c * power);
    }
    slope
}

fn descending(p: &IntegerPolynomial) -> impl Iterator<Item = (u32, &Integer)> {
    let last = p.degree();
    let powers = p.coefficients().iter().enumerate().skip(1).rev();
    powers.map(move |(power, c)| (u32::try_from(power.min(last)).unwrap_or(u32::MAX), c))
}

/// A complex root from one that is known to so many bits.
pub(super) fn complex(p: &IntegerPolynomial, near: Point, from: u32, to: u32) -> Point {
    let mut z = near;
    let mut before = from;
    for bits in ladder(from, to).into_iter().map(|bits| bits + GUARD_BITS) {
        z = z.with_bits(bits);
        let mut value = Point::zero(bits);
        for c in p.coefficients().iter().rev() {
            value = value.times(&z, bits);
            value.re += c;
        }
        let short = before + GUARD_BITS;
        let at = z.clone().with_bits(short);
        let mut slope = Point::zero(short);
        for (power, c) in descending(p) {
            slope = slope.times(&at, short);
            slope.re += Integer::from(c * power);
        }
        let step = value.with_bits(short).times(&slope.inverse(short), short);
        z = z.minus(&step, bits);
        before = bits;
    }
    z
}
