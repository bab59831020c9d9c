//! e^{iφ} for an angle in degrees.

use crate::curvature::motion::{Path, turn};
use crate::number::{Ball, Number, Series};
use crate::plane::Point;

/// e^{iφ}.
pub fn cis(degrees: &Number<Ball>, bits: u32) -> Point<Ball> {
    let radians = Number(degrees.0.with_precision(bits)) * Number::pi(&bits) / 180;
    Number::complex(radians.clone().cos(), radians.sin())
}

/// e^{iφ} for an angle that is a series.
pub fn path(degrees: &Number<Series<Ball>>, bits: u32) -> Path<Ball> {
    let start = degrees.coefficient(0);
    let scale: Number<Ball> = Number::pi(&bits) / 180;
    let scale = Number::<Series<Ball>>::from(scale);
    let rest = (degrees - Number::from(start.clone())) * scale;
    let start = cis(&start, bits);
    Number::complex(start.re().clone().into(), start.im().clone().into()) * turn(&rest)
}
