//! The type of a focal cubic, and of what it becomes where the line at infinity is a part of it.

use std::cmp::Ordering;

use super::circular_cubic::Cubic;
use super::conic::Conic;
use super::focal_cubic::FocalCubic;
use crate::number::{Real, Truth};

/// What a curve consists of. Cubics with an isolated point or a cusp are not among focal cubics: the
/// discriminant m − 2 Re(ᾱν̄e²) of the lines through the focus is positive on both sides of a zero of
/// its smallest value, unless α or ν vanishes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CurveType {
    /// No double point; connected, with both ends at infinity.
    OneBranch,
    /// No double point; a closed branch and one with both ends at infinity.
    TwoBranches,
    /// A double point with two real tangents.
    Nodal,
    /// A line and a circle; the line may be that at infinity, the circle may be without real points.
    LineAndCircle,
    /// A line and two more, of which both may be at infinity or one conjugate of the other.
    ThreeLines,
    /// A rectangular hyperbola, and the line at infinity.
    Hyperbola,
    /// Two lines at right angles, and the line at infinity.
    TwoLines,
    /// All of the plane: the polynomial is zero.
    EveryPoint,
    /// No finite point: the polynomial is a constant.
    NoPoint,
}

/// The type; `None` where it cannot be told, and for a cubic that is no focal cubic.
pub fn curve_type<K: Real>(cubic: &Cubic<K>) -> Option<CurveType> {
    match cubic.contains_line_at_infinity() {
        Truth::Unknown => None,
        Truth::Yes => type_of_conic(cubic),
        Truth::No => type_of_focal_cubic(&FocalCubic::of(cubic)?),
    }
}

fn type_of_focal_cubic<K: Real>(curve: &FocalCubic<K>) -> Option<CurveType> {
    match curve.discriminant().sign() {
        Some(Ordering::Less) => return Some(CurveType::OneBranch),
        Some(Ordering::Greater) if curve.nu.is_zero().is_no() => {
            return Some(CurveType::TwoBranches);
        }
        _ => {}
    }
    match (curve.nu.is_zero(), curve.is_line_and_circle()) {
        (Truth::Yes, _) => Some(CurveType::ThreeLines),
        (Truth::No, Truth::Yes) => Some(CurveType::LineAndCircle),
        (Truth::No, Truth::No) if curve.discriminant().is_zero().is_yes() => Some(CurveType::Nodal),
        _ => None,
    }
}

/// The type where the line at infinity is a part of the curve, from the conic that is left.
fn type_of_conic<K: Real>(cubic: &Cubic<K>) -> Option<CurveType> {
    let conic = cubic.beside_line_at_infinity();
    let [a, b, c, ..] = conic.coefficients();
    let is_circle = a.equals(c) & b.is_zero();
    let is_rectangular = (a + c).is_zero();
    let [lines, curve] = match (is_circle, is_rectangular) {
        (Truth::Yes, Truth::Yes) => return type_of_line(&conic),
        // A circle of radius zero is a pair of conjugate lines.
        (Truth::Yes, Truth::No) => [CurveType::ThreeLines, CurveType::LineAndCircle],
        (Truth::No, Truth::Yes) => [CurveType::TwoLines, CurveType::Hyperbola],
        _ => return None,
    };
    match conic.is_degenerate() {
        Truth::Yes => Some(lines),
        Truth::No => Some(curve),
        Truth::Unknown => None,
    }
}

fn type_of_line<K: Real>(conic: &Conic<K>) -> Option<CurveType> {
    let [.., d, e, f] = conic.coefficients();
    match (d.is_zero() & e.is_zero(), f.is_zero()) {
        (Truth::No, _) => Some(CurveType::ThreeLines),
        (Truth::Yes, Truth::Yes) => Some(CurveType::EveryPoint),
        (Truth::Yes, Truth::No) => Some(CurveType::NoPoint),
        _ => None,
    }
}
