//! Approximate roots by the method of Ehrlich and Aberth. Nothing here is certified: what it finds
//! is a proposal that discs then prove.

use std::f64::consts::TAU;

use rug::Float;

use super::integer::IntegerPolynomial;
use super::point::Point;
use crate::number::{array, count};

/// Rounds of one precision beside those that clusters need.
const ROUNDS: u32 = 60;

/// Approximations of all roots, improved in place.
pub(super) struct Approximations {
    pub points: Vec<Point>,
    /// Whether a point is as good as the precision allows.
    settled: Vec<bool>,
}

impl Approximations {
    /// Points on circles that the Newton polygon of the coefficients suggests (D. A. Bini 1996).
    pub fn start(p: &IntegerPolynomial, bits: u32) -> Self {
        let sizes: Vec<Option<f64>> = p.coefficients().iter().map(log2).collect();
        let points = starting_points(&sizes)
            .into_iter()
            .map(|(log_radius, angle)| {
                let radius = Float::with_val(bits, log_radius).exp2();
                Point {
                    re: Float::with_val(bits, &radius * angle.cos()),
                    im: Float::with_val(bits, &radius * angle.sin()),
                }
            });
        // The polygon starts at the first coefficient that is not zero: below it are roots 0.
        let zeros = sizes.iter().take_while(|size| size.is_none()).count();
        let zeros = (0..zeros).map(|_| Point::zero(bits));
        let points: Vec<Point> = zeros.chain(points).collect();
        let settled = vec![false; points.len()];
        Approximations { points, settled }
    }

    /// Iterates with so many bits until no point gets better.
    #[expect(clippy::indexing_slicing, reason = "there is a mark for every point")]
    pub fn improve(&mut self, p: &IntegerPolynomial, bits: u32) {
        let coefficients: Vec<Float> = p
            .coefficients()
            .iter()
            .map(|c| Float::with_val(bits, c))
            .collect();
        for point in &mut self.points {
            point.re.set_prec(bits);
            point.im.set_prec(bits);
        }
        self.settled.fill(false);
        // Far from m close roots the distance shrinks by (m − 1)/(m + 1) a round, and rounding
        // hides the roots from 2^(−bits/m) on: about 0.35 bits rounds.
        for _ in 0..ROUNDS + bits / 2 {
            for index in 0..self.points.len() {
                if !self.settled[index] {
                    self.settled[index] = self.step(&coefficients, index, bits);
                }
            }
            if self.settled.iter().all(|&settled| settled) {
                return;
            }
        }
    }

    /// One correction of one point; whether it is the last one.
    #[expect(
        clippy::indexing_slicing,
        reason = "the index is that of one of the points"
    )]
    fn step(&mut self, coefficients: &[Float], index: usize, bits: u32) -> bool {
        let z = &self.points[index];
        let values = evaluate(coefficients, z, bits);
        if values.is_noise(coefficients.len(), bits) {
            return true;
        }
        // 1/(p′/p − Σ 1/(z − zⱼ)).
        let mut sum = values.slope.times(&values.value.inverse(bits), bits);
        for (other, at) in self.points.iter().enumerate() {
            if other != index {
                let repulsion = z.minus(at, bits).inverse(bits);
                if repulsion.is_finite() {
                    sum = sum.minus(&repulsion, bits);
                }
            }
        }
        let correction = sum.inverse(bits);
        if !correction.is_finite() {
            return false;
        }
        let small = correction.size() <= z.size() >> (bits - 4);
        self.points[index] = z.minus(&correction, bits);
        small
    }
}

/// Value and derivative at a point, and a bound of the terms' sizes.
struct Values {
    value: Point,
    slope: Point,
    terms: Float,
}

impl Values {
    /// Whether the value may be nothing but rounding errors.
    fn is_noise(&self, length: usize, bits: u32) -> bool {
        let errors = Float::with_val(32, &self.terms * count::to_u64(4 * length)) >> bits;
        self.value.size() <= errors
    }
}

fn evaluate(coefficients: &[Float], z: &Point, bits: u32) -> Values {
    let size = z.size();
    let mut value = Point::zero(bits);
    let mut slope = Point::zero(bits);
    let mut terms = Float::new(32);
    for c in coefficients.iter().rev() {
        slope = slope.times(z, bits);
        slope.add(&value);
        value = value.times(z, bits);
        value.re += c;
        terms *= &size;
        terms += Float::with_val(32, c.abs_ref());
    }
    Values {
        value,
        slope,
        terms,
    }
}

/// log₂ of the distance from 0, and the angle, of points from which the roots that are not 0 are
/// found, from log₂ of the coefficients; nothing for one that vanishes.
pub(super) fn starting_points(sizes: &[Option<f64>]) -> Vec<(f64, f64)> {
    let corners = newton_polygon(sizes);
    let mut points = Vec::with_capacity(sizes.len());
    let sides = array::neighbours(&corners);
    for (ring, ((first, high), (last, low))) in sides.enumerate() {
        let number = count::to_f64(last - first);
        let log_radius = (high - low) / number;
        let turned = 0.31 * count::to_f64(ring);
        for j in 0..last - first {
            let angle = TAU * (count::to_f64(j) / number) + 0.7 + turned;
            points.push((log_radius, angle));
        }
    }
    points
}

/// The corners of the upper hull of the points (power, log₂ |coefficient|).
fn newton_polygon(sizes: &[Option<f64>]) -> Vec<(usize, f64)> {
    let mut hull: Vec<(usize, f64)> = Vec::new();
    for (power, size) in sizes.iter().enumerate() {
        let Some(size) = size else { continue };
        let next = (power, *size);
        while let [.., a, b] = hull.as_slice() {
            let slope = |from: &(usize, f64), to: &(usize, f64)| {
                (to.1 - from.1) / count::to_f64(to.0 - from.0)
            };
            if slope(a, b) > slope(a, &next) {
                break;
            }
            hull.pop();
        }
        hull.push(next);
    }
    hull
}

fn log2(c: &rug::Integer) -> Option<f64> {
    let exponent = c.significant_bits();
    let mantissa = Float::with_val(53, c) >> exponent;
    (!c.is_zero()).then(|| mantissa.to_f64().abs().log2() + f64::from(exponent))
}
