//! The positions of the moving plane, as small frames.

use serde_json::Value;

use super::canvas::{Canvas, Joint, Point, Stroke};
use super::complex::{Z, point, z};
use crate::oracle::displacements;
use crate::plane::displacement::Displacement;

/// The positions of a problem in floats.
pub fn positions(problem: &Value) -> Option<Vec<Displacement<f64>>> {
    displacements(problem).ok()
}

/// The largest distance between two of the points; 1 for fewer than two different ones.
pub fn extent(points: &[Point]) -> f64 {
    let mut most = 0.0f64;
    for (i, [x, y]) in points.iter().enumerate() {
        for [u, v] in points.iter().skip(i + 1) {
            most = most.max((x - u).hypot(y - v));
        }
    }
    if most > 0.0 { most } else { 1.0 }
}

/// Draws the frame of each position: its x-axis with a head, its y-axis shorter.
pub fn draw(canvas: &mut Canvas, positions: &[Displacement<f64>], size: f64) {
    for (place, position) in positions.iter().enumerate() {
        let at = |x: f64, y: f64| -> Z { position.of(&z(x * size, y * size)) };
        let origin = point(&at(0.0, 0.0));
        canvas.line([origin, point(&at(1.0, 0.0))], Stroke::Bar);
        canvas.line([origin, point(&at(0.0, 0.6))], Stroke::Bar);
        canvas.joint(origin, Joint::Mark, &format!("{}", place + 1));
    }
}
