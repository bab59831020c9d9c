//! Complex floats, in which pictures are computed, and points of a drawing.

use super::canvas::Point;
use crate::number::{Complex, Number};

/// A complex float.
pub type Z = Number<Complex<f64>>;

/// x + iy.
pub fn z(x: f64, y: f64) -> Z {
    Number::complex(Number(x), Number(y))
}

/// Where it is drawn.
pub fn point(z: &Z) -> Point {
    [z.re().0, z.im().0]
}
