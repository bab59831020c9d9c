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

/// An e with |x − ζ| < 2^e for the only root ζ in an interval X around x, if Newton's step from there
/// with the slopes of all of X stays within it.
pub(super) fn newton_within(
    p: &Polynomial<Ball>,
    slope: &Polynomial<Ball>,
    x: &Float,
    reach: i64,
) -> Option<i64> {
    let around = few(&Number(Ball::around(x.clone(), reach)));
    let step = few(&p.evaluate(&exactly(x))) / slope.evaluate(&around);
    step.0.magnitude().filter(|size| *size <= reach)
}

fn exactly(x: &Float) -> Number<Ball> {
    Number(Ball::exactly(x.clone()))
}

fn few(x: &Number<Ball>) -> Number<Ball> {
    Number(x.0.with_precision(FEW_BITS))
}

fn short(z: &Number<Complex<Ball>>) -> Number<Complex<Ball>> {
    Number::complex(few(z.re()), few(z.im()))
}
