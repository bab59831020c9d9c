//! The proof that a root is near a point.

use rug::Float;

use super::Polynomial;
use super::point::Point;
use crate::number::{Ball, Complex, Number};

/// Bits of quotients and derivatives, of which only the size matters.
pub(super) const FEW_BITS: u32 = 64;

/// A derivative in few bits, and in about half of those that the root is wanted with.
pub(super) type Slopes = [Polynomial<Ball>; 2];

/// An enclosure of a root near z, for every polynomial in the enclosure, real where z is; `None` where
/// the precision proves none.
///
/// In a box Z around z, p(ζ) = p(z) + (ζ − z) s with a mean s of the derivative in Z, so that the roots
/// in Z are the fixed points of z − p(z)/s. Where Newton's step from z with the slopes of all numbers in Z
/// stays in Z, there is one (L. E. J. Brouwer), and it is where the step leads.
pub(super) fn root_near(
    p: &Polynomial<Ball>,
    [few, half]: &Slopes,
    z: &Point,
) -> Option<Number<Complex<Ball>>> {
    let short = z.re.prec();
    let around = |x: &Float, reach| Number(Ball::around(x.clone(), reach));
    if z.im.is_zero() {
        let x = exactly(&z.re);
        let value = p.evaluate(&x);
        let bits = value.0.precision().unwrap_or(short);
        let value = with_bits(&value, short);
        let size = (with_bits(&value, FEW_BITS) / few.evaluate(&with_bits(&x, FEW_BITS))).0;
        let reach = size.magnitude()?.saturating_add(ROOM);
        let step = value / half.evaluate(&around(&z.re, reach));
        let stays = step.0.magnitude()? <= reach;
        return stays.then(|| Number::complex(with_bits(&x, bits) - step, Number::zero()));
    }
    let point = Number::complex(exactly(&z.re), exactly(&z.im));
    let in_bits = |z: &Number<Complex<Ball>>, bits| {
        Number::complex(with_bits(z.re(), bits), with_bits(z.im(), bits))
    };
    let value = p.evaluate_complex(&point);
    let bits = value.re().0.precision().unwrap_or(short);
    let value = in_bits(&value, short);
    let size = in_bits(&value, FEW_BITS) / few.evaluate_complex(&in_bits(&point, FEW_BITS));
    let larger = |z: &Number<Complex<Ball>>| {
        let [re, im] = [z.re(), z.im()].map(|part| part.0.magnitude());
        Some(re?.max(im?))
    };
    let reach = larger(&size)?.saturating_add(ROOM);
    let box_around = Number::complex(around(&z.re, reach), around(&z.im, reach));
    let step = value / half.evaluate_complex(&box_around);
    (larger(&step)? <= reach).then(|| in_bits(&point, bits) - step)
}

/// The box is larger than the step by this power of two.
const ROOM: i64 = 2;

/// Bits of a point from which one step more gives so many.
pub(super) fn half(bits: u32) -> u32 {
    bits / 2 + 24
}

fn exactly(x: &Float) -> Number<Ball> {
    Number(Ball::exactly(x.clone()))
}

fn with_bits(x: &Number<Ball>, bits: u32) -> Number<Ball> {
    Number(x.0.with_precision(bits))
}
