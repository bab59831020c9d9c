//! Newton's method without proof: from an isolated root to as many bits as wanted. What it finds is
//! a proposal, proven where it is used.

use rug::ops::NegAssign;
use rug::{Assign, Float};

use super::integer::IntegerPolynomial;
use super::point::Point;

/// Bits beyond those that are wanted.
const GUARD_BITS: u32 = 64;

/// A polynomial and its derivative by approximate coefficients, the constant one first.
#[derive(Debug)]
pub(super) struct Approximate {
    value: Vec<Float>,
    slope: Vec<Float>,
}

impl Approximate {
    pub fn new(value: Vec<Float>) -> Self {
        let powers = (0u32..).zip(&value).skip(1);
        let slope = powers.map(|(power, c)| Float::with_val(c.prec() + 8, c * power));
        Approximate {
            slope: slope.collect(),
            value,
        }
    }

    pub fn of_integers(p: &IntegerPolynomial) -> Self {
        let exactly = |c| Float::with_val(rug::Integer::significant_bits(c).max(2), c);
        Self::new(p.coefficients().iter().map(exactly).collect())
    }

    /// The coefficients of the polynomial itself.
    pub fn coefficients(&self) -> &[Float] {
        &self.value
    }

    /// A root from one that is known to so many bits.
    pub fn root(&self, near: Point, from: u32, to: u32) -> Point {
        if near.im.is_zero() {
            let re = self.real(near.re, from, to);
            return Point {
                im: Float::new(2),
                re,
            };
        }
        self.complex(near, from, to)
    }

    fn real(&self, mut x: Float, from: u32, to: u32) -> Float {
        let mut before = from;
        for bits in ladder(from, to).into_iter().map(|bits| bits + GUARD_BITS) {
            x.set_prec(bits);
            let mut value = horner(&self.value, &x);
            let short = before + GUARD_BITS;
            let slope = horner(&self.slope, &Float::with_val(short, &x));
            value.set_prec(short);
            value /= slope;
            x -= value;
            before = bits;
        }
        x
    }

    fn complex(&self, mut z: Point, from: u32, to: u32) -> Point {
        let mut before = from;
        for bits in ladder(from, to).into_iter().map(|bits| bits + GUARD_BITS) {
            z = z.with_bits(bits);
            let value = complex_horner(&self.value, &z);
            let short = before + GUARD_BITS;
            let slope = complex_horner(&self.slope, &z.clone().with_bits(short));
            let step = value.with_bits(short).times(&slope.inverse(short), short);
            z.re -= step.re;
            z.im -= step.im;
            before = bits;
        }
        z
    }
}

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

fn horner(coefficients: &[Float], x: &Float) -> Float {
    let mut value = Float::new(x.prec());
    let mut descending = coefficients.iter().rev();
    if let Some(leading) = descending.next() {
        value.assign(leading);
    }
    for c in descending {
        value *= x;
        value += c;
    }
    value
}

/// Without an allocation in the loop.
fn complex_horner(coefficients: &[Float], z: &Point) -> Point {
    let bits = z.re.prec();
    let mut value = Point::zero(bits);
    let [mut across, mut along] = [Float::new(bits), Float::new(bits)];
    let mut descending = coefficients.iter().rev();
    if let Some(leading) = descending.next() {
        value.re.assign(leading);
    }
    for c in descending {
        across.assign(&value.re * &z.im);
        along.assign(&value.im * &z.im);
        value.im *= &z.re;
        value.im += &across;
        value.re *= &z.re;
        along.neg_assign();
        value.re += &along;
        value.re += c;
    }
    value
}
