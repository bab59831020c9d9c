//! The method of Ehrlich and Aberth in machine floats: most polynomials need no more than this
//! before their roots can be proven.

use rug::Float;

use super::Polynomial;
use super::aberth::starting_points;
use super::integer::IntegerPolynomial;
use super::point::Point;
use crate::number::{Complex as ComplexNumber, Number};

/// Rounds after which points that still move are left as they are.
const ROUNDS: usize = 50;
/// Below this share of its size a correction is the last one: each triples the number of digits.
const SETTLED: f64 = 1e-10;

type Complex = [f64; 2];

/// The roots of a polynomial in machine floats, nothing certified; those with an imaginary part that
/// is nothing but rounding are real. `None` for a constant and beyond the range of floats.
pub fn approximate_roots(polynomial: &Polynomial<f64>) -> Option<Vec<Number<ComplexNumber<f64>>>> {
    let coefficients: Vec<f64> = polynomial.coefficients().iter().map(|c| c.0).collect();
    let size = |c: &f64| (*c != 0.0).then(|| c.abs().log2());
    let sizes: Vec<Option<f64>> = coefficients.iter().map(size).collect();
    let start = starting_points(&sizes);
    let start = start.into_iter().map(|(log_radius, angle)| {
        let radius = log_radius.exp2();
        [radius * angle.cos(), radius * angle.sin()]
    });
    let points = iterated(&coefficients, start.collect())?;
    let roots = points.into_iter().map(onto_axis);
    Some(
        roots
            .map(|[re, im]| Number::complex(Number(re), Number(im)))
            .collect(),
    )
}

/// Points near the roots, from points somewhere around them. `None` where that leaves the range of
/// floats.
pub(super) fn improved(p: &IntegerPolynomial, start: &[Point]) -> Option<Vec<Point>> {
    let scale = middle_exponent(start);
    let coefficients = scaled(p, scale);
    let points = start
        .iter()
        .map(|z| [&z.re, &z.im].map(|part| Float::with_val(53, part >> scale).to_f64()))
        .collect();
    let points = iterated(&coefficients, points)?;
    let bits = start.first()?.re.prec();
    let back = |part: f64| Float::with_val(bits, part) << scale;
    let points = points.into_iter().map(onto_axis);
    let points = points.map(|[re, im]| Point {
        re: back(re),
        im: back(im),
    });
    Some(points.collect())
}

fn iterated(coefficients: &[f64], mut points: Vec<Complex>) -> Option<Vec<Complex>> {
    for _ in 0..ROUNDS {
        let mut settled = true;
        for place in 0..points.len() {
            let correction = correction(coefficients, &points, place)?;
            let z = points.get_mut(place)?;
            *z = minus(*z, correction);
            settled &= size(correction) <= SETTLED * size(*z);
        }
        if settled {
            break;
        }
    }
    let is_finite = |z: &Complex| z[0].is_finite() && z[1].is_finite();
    (!points.is_empty() && points.iter().all(is_finite)).then_some(points)
}

/// The exponent of the points' sizes, on average.
fn middle_exponent(points: &[Point]) -> i32 {
    let exponents = points.iter().filter_map(|z| z.size().get_exp());
    let (count, sum) = exponents.fold((0, 0), |(count, sum), e| (count + 1, sum + i64::from(e)));
    let mean = if count == 0 { 0 } else { sum / count };
    i32::try_from(mean).unwrap_or(0)
}

/// The coefficients of p(2^scale x), up to a factor that makes the largest about one.
fn scaled(p: &IntegerPolynomial, scale: i32) -> Vec<f64> {
    let terms = (0i64..).zip(p.coefficients());
    let terms: Vec<(Float, i64)> = terms
        .map(|(power, c)| (Float::with_val(53, c), power * i64::from(scale)))
        .collect();
    let exponent = |(c, twos): &(Float, i64)| c.get_exp().map(|e| i64::from(e) + twos);
    let largest = terms.iter().filter_map(exponent).max().unwrap_or(0);
    let shifted = |(c, twos): (Float, i64)| {
        let by = (twos - largest).clamp(i64::from(i32::MIN) / 2, i64::from(i32::MAX) / 2);
        // Within the clamp.
        (c << i32::try_from(by).unwrap_or(0)).to_f64()
    };
    terms.into_iter().map(shifted).collect()
}

/// p/(p′ − p Σ 1/(z − zⱼ)).
fn correction(coefficients: &[f64], points: &[Complex], place: usize) -> Option<Complex> {
    let z = *points.get(place)?;
    let (mut value, mut slope) = ([0.0; 2], [0.0; 2]);
    for c in coefficients.iter().rev() {
        slope = plus(times(slope, z), value);
        value = times(value, z);
        value[0] += c;
    }
    let mut sum = [0.0; 2];
    for (other, at) in points.iter().enumerate() {
        if other != place && *at != z {
            sum = plus(sum, inverse(minus(z, *at)));
        }
    }
    Some(times(value, inverse(minus(slope, times(value, sum)))))
}

/// A point that rounding alone keeps off the real axis.
fn onto_axis([re, im]: Complex) -> Complex {
    if im.abs() <= re.abs() * 1e-9 {
        [re, 0.0]
    } else {
        [re, im]
    }
}

fn plus([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a + c, b + d]
}

fn minus([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a - c, b - d]
}

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

/// Scaled first: imaginary parts that vanish have squares that are no floats.
fn inverse([a, b]: Complex) -> Complex {
    let scale = a.abs().max(b.abs());
    let (a, b) = (a / scale, b / scale);
    let norm = (a * a + b * b) * scale;
    [a / norm, -b / norm]
}

fn size([a, b]: Complex) -> f64 {
    a.abs() + b.abs()
}
