//! The proof that a root is near a point.

use rug::Float;

use super::Polynomial;
use super::point::Point;
use crate::number::{Ball, Complex, Number};

/// Bits of quotients and derivatives, of which only the size matters.
pub(super) const FEW_BITS: u32 = 64;

/// An e with n |p/p′| < 2^e at z, for every polynomial in the enclosure: within 2^e of z it has a
/// root.
///
/// If n |p/p′| < |z − ζ| held for all roots ζ, then |p′/p| = |Σ 1/(z − ζ)| would be less than itself.
pub(super) fn root_within(
    p: &Polynomial<Ball>,
    slope: &Polynomial<Ball>,
    z: &Point,
) -> Option<i64> {
    let degree = i64::from(p.degree()?.next_power_of_two().trailing_zeros());
    if z.im.is_zero() {
        let value = p.evaluate(&exactly(&z.re));
        let slope = slope.evaluate(&few(&exactly(&z.re)));
        return Some((few(&value) / slope).0.magnitude()? + degree);
    }
    let point = Number::complex(exactly(&z.re), exactly(&z.im));
    let value = short(&p.evaluate_complex(&point));
    let step = value / slope.evaluate_complex(&short(&point));
    let size = step.re().0.magnitude()?.max(step.im().0.magnitude()?);
    Some(size + 1 + degree)
}

/// Whether Newton's step from x with the slopes of all numbers within 2^reach of it stays among them:
/// then they hold exactly one root.
pub(super) fn holds_one_root(
    p: &Polynomial<Ball>,
    slope: &Polynomial<Ball>,
    x: &Float,
    reach: i64,
) -> bool {
    let around = few(&Number(Ball::around(x.clone(), reach)));
    let step = few(&p.evaluate(&exactly(x))) / slope.evaluate(&around);
    step.0.magnitude().is_some_and(|size| size <= reach)
}

/// A much smaller enclosure of a root within 2^reach of z, by one step of Newton's method:
/// p(z) = (z − ζ) s with a mean s of the derivative between z and ζ.
pub(super) fn sharpened(
    p: &Polynomial<Ball>,
    slope: &Polynomial<Ball>,
    z: &Point,
    reach: i64,
) -> Number<Complex<Ball>> {
    let around = |x: &Float| Number(Ball::around(x.clone(), reach));
    if z.im.is_zero() {
        let slope = slope.evaluate(&around(&z.re));
        let value = p.evaluate(&exactly(&z.re));
        let step = with_bits(&value, z.re.prec()) / slope;
        let bits = value.0.precision().unwrap_or_default();
        return Number::complex(with_bits(&exactly(&z.re), bits) - step, Number::zero());
    }
    let slope = slope.evaluate_complex(&Number::complex(around(&z.re), around(&z.im)));
    let point = Number::complex(exactly(&z.re), exactly(&z.im));
    // Of the short step half of the bits are all that counts.
    let value = p.evaluate_complex(&point);
    let short = |part: &Number<Ball>| with_bits(part, z.re.prec());
    let step = Number::complex(short(value.re()), short(value.im())) / slope;
    let bits = value.re().0.precision().unwrap_or_default();
    let whole = |x: &Number<Ball>| with_bits(x, bits);
    Number::complex(whole(point.re()), whole(point.im())) - step
}

/// Bits of a point from which one step more gives so many.
pub(super) fn half(bits: u32) -> u32 {
    bits / 2 + 24
}

fn exactly(x: &Float) -> Number<Ball> {
    Number(Ball::exactly(x.clone()))
}

fn few(x: &Number<Ball>) -> Number<Ball> {
    with_bits(x, FEW_BITS)
}

fn with_bits(x: &Number<Ball>, bits: u32) -> Number<Ball> {
    Number(x.0.with_precision(bits))
}

fn short(z: &Number<Complex<Ball>>) -> Number<Complex<Ball>> {
    Number::complex(few(z.re()), few(z.im()))
}
