//! All roots of whatever polynomial lies in an enclosure.

use rug::{Float, Rational};

use super::Polynomial;
use super::aberth::Approximations;
use super::integer::IntegerPolynomial;
use super::point::Point;
use super::polish;
use crate::number::{Ball, Complex, Exact, Number, count};

/// Bits of the first proposals.
const FIRST_BITS: u32 = 72;
/// Bits of the derivative, of which only the size matters.
const SLOPE_BITS: u32 = 64;

/// Simple roots, all of them, each in an enclosure of its own; no two have a number in common.
#[derive(Clone, Debug)]
pub struct EnclosedRoots {
    /// The real roots.
    pub real: Vec<Number<Ball>>,
    /// The roots above the real axis, each for itself and its conjugate.
    pub complex: Vec<Number<Complex<Ball>>>,
}

/// The roots of every polynomial whose coefficients lie in these balls; `None` where they cannot be
/// told apart with so many bits.
///
/// Around a point z with n |p/p′| ≤ ρ there is a root within ρ. As many disjoint discs as roots hold
/// one each; where the center is real, so is the root, for its conjugate lies in the same disc.
pub fn enclose(polynomial: &Polynomial<Ball>, bits: u32) -> Option<EnclosedRoots> {
    let degree = polynomial.degree()?;
    if !polynomial.leading()?.is_zero().is_no() {
        return None;
    }
    let derivative = polynomial.derivative().map(|c| shortened(c, SLOPE_BITS));
    let middle = middle(polynomial)?;
    let mut roots = EnclosedRoots {
        real: Vec::new(),
        complex: Vec::new(),
    };
    let mut discs: Vec<[Rational; 3]> = Vec::with_capacity(degree);
    let proposals = Approximations::from_floats(&middle, FIRST_BITS).points;
    for point in proposals.into_iter().filter(|point| point.im >= 0) {
        let (re, im) = polished(&middle, point, bits)?;
        let radius = radius(polynomial, &derivative, [&re, &im], bits)?;
        let ball = |mid: &Rational| Number(Ball::with_radius(mid, &radius, bits));
        if im.is_zero() {
            roots.real.push(ball(&re));
        } else {
            roots.complex.push(Number::complex(ball(&re), ball(&im)));
            discs.push([re.clone(), Rational::from(-&im), radius.clone()]);
        }
        discs.push([re, im, radius]);
    }
    (discs.len() == degree && are_apart(&discs)).then_some(roots)
}

fn shortened(x: &Number<Ball>, bits: u32) -> Number<Ball> {
    Number(x.0.with_precision(bits))
}

/// The polynomial of the midpoints, up to a factor.
fn middle(polynomial: &Polynomial<Ball>) -> Option<IntegerPolynomial> {
    let coefficients = polynomial.coefficients().iter();
    let middles: Option<Vec<Number<Exact>>> = coefficients
        .map(|c| Some(Number::from(c.0.midpoint_rational()?)))
        .collect();
    Some(IntegerPolynomial::from_exact(&Polynomial::new(middles?))?.1)
}

fn polished(p: &IntegerPolynomial, point: Point, bits: u32) -> Option<(Rational, Rational)> {
    let known = 40;
    if point.im.is_zero() {
        let x: Float = polish::real(p, &point.re, known, bits);
        return Some((x.to_rational()?, Rational::new()));
    }
    let z = polish::complex(p, point, known, bits);
    Some((z.re.to_rational()?, z.im.to_rational()?))
}

/// An upper bound of n |p/p′|.
fn radius(
    polynomial: &Polynomial<Ball>,
    derivative: &Polynomial<Ball>,
    [re, im]: [&Rational; 2],
    bits: u32,
) -> Option<Rational> {
    let at = |x: &Rational, bits: u32| Number::<Ball>::rounded(x, &bits);
    let step = if im.is_zero() {
        let slope = derivative.evaluate(&at(re, SLOPE_BITS));
        Number::complex(polynomial.evaluate(&at(re, bits)) / slope, Number::zero())
    } else {
        let z = |bits: u32| Number::complex(at(re, bits), at(im, bits));
        polynomial.evaluate_complex(&z(bits)) / derivative.evaluate_complex(&z(SLOPE_BITS))
    };
    let size = |part: &Number<Ball>| Some(part.0.lower()?.abs().max(part.0.upper()?.abs()));
    let sum = size(step.re())? + size(step.im())?;
    Some(sum * count::to_u64(polynomial.degree()?))
}

/// Whether the squares around the discs are disjoint.
fn are_apart(discs: &[[Rational; 3]]) -> bool {
    discs.iter().enumerate().all(|(place, [x, y, radius])| {
        discs.iter().skip(place + 1).all(|[u, v, other]| {
            let reach = Rational::from(radius + other);
            let apart = |a: &Rational, b: &Rational| Rational::from(a - b).abs() > reach;
            apart(x, u) || apart(y, v)
        })
    })
}
