//! Real roots of a square-free polynomial, isolated by Descartes' rule of signs and bisection.
//!
//! The sign variations of (1 + x)ⁿ p(1/(1 + x)) bound the number of roots in (0, 1) and have its
//! parity: 0 and 1 decide. Halves of an interval are tried until each is decided, which the
//! theorem of two circles guarantees for simple roots (G. E. Collins, A. G. Akritas 1976).

use std::cmp::Ordering;

use rug::{Integer, Rational};

use super::integer::IntegerPolynomial;
use super::sturm::variations;
use crate::number::count;

/// Numbers between two ends; one number where they are equal, else that is a closed interval with
/// one simple root inside.
#[derive(Clone, Debug)]
pub(super) struct Interval {
    pub low: Rational,
    pub high: Rational,
}

impl Interval {
    fn point(x: Rational) -> Interval {
        Interval {
            low: x.clone(),
            high: x,
        }
    }

    /// From a center and a bound for the distance of the only root near it: twice as wide, so that
    /// neither end is a root.
    pub fn around(center: &Rational, radius: &Rational) -> Interval {
        let margin = Rational::from(radius << 1);
        Interval {
            low: Rational::from(center - &margin),
            high: Rational::from(center + &margin),
        }
    }

    fn mirrored(self) -> Interval {
        Interval {
            low: -self.high,
            high: -self.low,
        }
    }

    pub fn is_point(&self) -> bool {
        self.low == self.high
    }

    pub fn middle(&self) -> Rational {
        Rational::from(&self.low + &self.high) >> 1
    }

    pub fn width(&self) -> Rational {
        Rational::from(&self.high - &self.low)
    }
}

/// One interval for each real root of a square-free polynomial of positive degree. No end of a
/// proper interval is a root; two intervals may share an end.
pub(super) fn isolate_real(p: &IntegerPolynomial) -> Vec<Interval> {
    let mut found = Vec::new();
    let mut coefficients = p.clone().into_coefficients();
    if coefficients.first().is_some_and(Integer::is_zero) {
        coefficients.remove(0);
        found.push(Interval::point(Rational::new()));
    }
    let rest = IntegerPolynomial::new(coefficients);
    let negative = positive_roots(&rest.mirrored()).into_iter();
    found.extend(negative.map(Interval::mirrored));
    found.extend(positive_roots(&rest));
    for interval in &mut found {
        leave_roots_at_ends(p, interval);
    }
    found
}

/// Part of the search: the roots of a polynomial in (0, 1) stand for those of the given one in
/// 2^scale · (place, place + 1)/2^depth.
struct Piece {
    coefficients: Vec<Integer>,
    place: Integer,
    depth: i64,
}

impl Piece {
    fn end(&self, scale: i64, offset: u32) -> Rational {
        times_power_of_two(
            Rational::from(Integer::from(&self.place + offset)),
            scale - self.depth,
        )
    }

    /// Both halves; the upper one comes second.
    fn halves(self) -> [Piece; 2] {
        let degree = self.coefficients.len() - 1;
        let mut lower = self.coefficients;
        for (power, c) in lower.iter_mut().enumerate() {
            *c <<= count::to_u32(degree - power);
        }
        drop_common_twos(&mut lower);
        let mut upper = lower.clone();
        shift_by_one(&mut upper);
        let place = self.place << 1u32;
        let depth = self.depth + 1;
        [
            Piece {
                coefficients: lower,
                place: place.clone(),
                depth,
            },
            Piece {
                coefficients: upper,
                place: place + 1u32,
                depth,
            },
        ]
    }
}

fn positive_roots(p: &IntegerPolynomial) -> Vec<Interval> {
    let mut found = Vec::new();
    if p.degree() == 0 {
        return found;
    }
    let scale = root_bound(p);
    let mut pieces = vec![Piece {
        coefficients: stretched(p, scale),
        place: Integer::new(),
        depth: 0,
    }];
    while let Some(piece) = pieces.pop() {
        match variations_in_unit_interval(&piece.coefficients) {
            0 => {}
            1 => found.push(Interval {
                low: piece.end(scale, 0),
                high: piece.end(scale, 1),
            }),
            _ => {
                let [lower, upper] = piece.halves();
                if upper.coefficients.first().is_some_and(Integer::is_zero) {
                    found.push(Interval::point(upper.end(scale, 0)));
                }
                pieces.push(lower);
                pieces.push(upper);
            }
        }
    }
    found
}

/// An exponent such that all roots are of smaller magnitude than that power of two: Fujiwara's
/// bound 2 max |aₙ₋ₖ/aₙ|^(1/k).
fn root_bound(p: &IntegerPolynomial) -> i64 {
    let bits = |c: &Integer| i64::from(c.significant_bits());
    let leading = bits(&p.leading());
    let below = p.coefficients().iter().rev().skip(1);
    let bound = (1i64..)
        .zip(below)
        .filter(|(_, c)| !c.is_zero())
        .map(|(k, c)| (bits(c) - leading + 1).div_euclid(k) + 1)
        .max();
    1 + bound.unwrap_or(0)
}

/// p(2^scale · x) up to a factor.
fn stretched(p: &IntegerPolynomial, scale: i64) -> Vec<Integer> {
    let degree = count::to_i64(p.degree());
    let mut coefficients = p.coefficients().to_vec();
    for (power, c) in (0i64..).zip(&mut coefficients) {
        let twos = if scale >= 0 {
            scale * power
        } else {
            -scale * (degree - power)
        };
        *c <<= u32::try_from(twos).unwrap_or(u32::MAX);
    }
    drop_common_twos(&mut coefficients);
    coefficients
}

fn drop_common_twos(coefficients: &mut [Integer]) {
    let twos = coefficients.iter().filter_map(|c| c.find_one(0)).min();
    if let Some(twos @ 1..) = twos {
        for c in coefficients {
            *c >>= twos;
        }
    }
}

/// p(x + 1).
fn shift_by_one(coefficients: &mut [Integer]) {
    for first in 0..coefficients.len() {
        for place in (first..coefficients.len() - 1).rev() {
            let (below, above) = coefficients.split_at_mut(place + 1);
            if let (Some(below), Some(above)) = (below.last_mut(), above.first()) {
                *below += above;
            }
        }
    }
}

fn variations_in_unit_interval(coefficients: &[Integer]) -> usize {
    let signs = |c: &[Integer]| variations(c.iter().map(Integer::cmp0));
    // Positive roots include those in (0, 1).
    let quick = signs(coefficients);
    if quick == 0 {
        return 0;
    }
    let mut reversed: Vec<Integer> = coefficients.iter().rev().cloned().collect();
    shift_by_one(&mut reversed);
    signs(&reversed)
}

/// Bisects until neither end is a root: such an end is a neighbouring root, already found.
fn leave_roots_at_ends(p: &IntegerPolynomial, interval: &mut Interval) {
    if interval.is_point() {
        return;
    }
    let mut after_low = p.sign_at(&interval.low);
    let mut at_high = p.sign_at(&interval.high);
    if after_low.is_eq() {
        // A simple root: just above it the sign is that of the derivative.
        after_low = p.derivative().sign_at(&interval.low);
    } else if at_high.is_ne() {
        return;
    }
    while at_high.is_eq() || p.sign_at(&interval.low).is_eq() {
        let middle = interval.middle();
        match p.sign_at(&middle) {
            Ordering::Equal => {
                *interval = Interval::point(middle);
                return;
            }
            sign if sign == after_low => interval.low = middle,
            sign => {
                interval.high = middle;
                at_high = sign;
            }
        }
    }
}

pub(super) fn times_power_of_two(q: Rational, exponent: i64) -> Rational {
    let bits = u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX);
    if exponent >= 0 { q << bits } else { q >> bits }
}
