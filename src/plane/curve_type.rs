//! The type of a focal cubic, and of what it becomes where the line at infinity is a part of it.

use std::cmp::Ordering;

use super::Point;
use super::circular_cubic::Cubic;
use super::focal_cubic::FocalCubic;
use crate::number::{Number, Real, Truth};

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

/// τ|z|² + Re(κz²) + Re(λ̄z) + j, with the line at infinity: what the coefficients of a conic are.
struct Conic<K> {
    tau: Number<K>,
    kappa: Point<K>,
    lambda: Point<K>,
    constant: Number<K>,
}

fn type_of_conic<K: Real>(cubic: &Cubic<K>) -> Option<CurveType> {
    let [_, _, _, _, e, f, g, h, i, j] = cubic.coefficients();
    let conic = Conic {
        tau: (e + g) / 2,
        kappa: Number::complex((e - g) / 2, -f / 2),
        lambda: Number::complex(h.clone(), i.clone()),
        constant: j.clone(),
    };
    match (conic.tau.is_zero(), conic.kappa.is_zero()) {
        (Truth::Yes, Truth::Yes) => type_of_line(&conic),
        (Truth::No, Truth::Yes) => type_of_circle(&conic),
        (Truth::Yes, Truth::No) => type_of_hyperbola(&conic),
        _ => None,
    }
}

fn type_of_line<K: Real>(conic: &Conic<K>) -> Option<CurveType> {
    match (conic.lambda.is_zero(), conic.constant.is_zero()) {
        (Truth::No, _) => Some(CurveType::ThreeLines),
        (Truth::Yes, Truth::Yes) => Some(CurveType::EveryPoint),
        (Truth::Yes, Truth::No) => Some(CurveType::NoPoint),
        _ => None,
    }
}

/// A circle of radius zero is a pair of conjugate lines.
fn type_of_circle<K: Real>(conic: &Conic<K>) -> Option<CurveType> {
    let squared_radius = conic.lambda.norm() - 4 * &conic.tau * &conic.constant;
    match squared_radius.is_zero() {
        Truth::Yes => Some(CurveType::ThreeLines),
        Truth::No => Some(CurveType::LineAndCircle),
        Truth::Unknown => None,
    }
}

/// The center is −λ̄/(2κ) = c̄; the hyperbola is a pair of lines where it passes through its center.
fn type_of_hyperbola<K: Real>(conic: &Conic<K>) -> Option<CurveType> {
    // Re(κc²) + Re(λ̄c) + j with 2κc = −λ̄, times 4|κ|².
    let at_center = (conic.lambda.conj().square() * conic.kappa.conj())
        .re()
        .clone()
        - 4 * &conic.constant * conic.kappa.norm();
    match at_center.is_zero() {
        Truth::Yes => Some(CurveType::TwoLines),
        Truth::No => Some(CurveType::Hyperbola),
        Truth::Unknown => None,
    }
}
