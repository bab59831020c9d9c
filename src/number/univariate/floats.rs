//! The method of Ehrlich and Aberth in machine floats: most polynomials need no more than this
//! before their roots can be proven.

use rug::Float;

use super::Polynomial;
use super::aberth::starting_points;
use super::point::Point;
use crate::number::{Complex as ComplexNumber, Number, count};

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

/// Points near all roots of a polynomial with coefficients of any size, the constant one first.
/// `None` where floats do not find them.
pub(super) fn proposed(coefficients: &[Float]) -> Option<Vec<Point>> {
    let parts: Vec<(f64, i64)> = coefficients
        .iter()
        .map(|c| {
            let (mantissa, exponent) = c.to_f64_exp();
            (mantissa, i64::from(exponent))
        })
        .collect();
    let size = |(mantissa, exponent): &(f64, i64)| {
        let exponent = i32::try_from(*exponent).ok()?;
        (*mantissa != 0.0).then(|| mantissa.abs().log2() + f64::from(exponent))
    };
    let sizes: Vec<Option<f64>> = parts.iter().map(size).collect();
    let start = starting_points(&sizes);
    // The polygon starts at the first coefficient that is not zero: below it are roots 0.
    let lowest = sizes.iter().take_while(|size| size.is_none()).count();
    let zeros = (0..lowest).map(|_| Point::zero(53));
    if start.is_empty() {
        return Some(zeros.collect());
    }
    let mean =
        start.iter().map(|(size, _)| size).sum::<f64>() / f64::from(count::to_u32(start.len()));
    let scale = Float::with_val(53, mean.round()).to_integer()?.to_i32()?;
    let scaled = (0i64..).zip(&parts);
    let scaled = scaled.map(|(power, (c, e))| (*c, e + power * i64::from(scale)));
    let scaled: Vec<(f64, i64)> = scaled.collect();
    let largest = scaled
        .iter()
        .filter(|(c, _)| *c != 0.0)
        .map(|(_, e)| *e)
        .max()?;
    let shifted = |(c, e): (f64, i64)| {
        let by = i32::try_from((e - largest).clamp(-2000, 0)).unwrap_or(0);
        c * 2f64.powi(by)
    };
    let scaled: Vec<f64> = scaled.into_iter().skip(lowest).map(shifted).collect();
    let around = start.iter().map(|(size, angle)| {
        let radius = (size - f64::from(scale)).exp2();
        [radius * angle.cos(), radius * angle.sin()]
    });
    let back = |part: f64| Float::with_val(53, part) << scale;
    let points = iterated(&scaled, around.collect())?
        .into_iter()
        .map(onto_axis);
    let points = points.map(|[re, im]| Point {
        re: back(re),
        im: back(im),
    });
    Some(zeros.chain(points).collect())
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
