//! The conchoidal linkage: a line through O_b = (0, 1) of which the point D keeps to the x-axis, its
//! slides replaced by cranks.
//!
//! A at the distance r from D towards O_b goes on a conchoid; the circle about a point of the y-axis
//! meets it in both positions A, of design and mirrored, and in the middle one. At O_b the line slides,
//! and a crank across it takes its place.

use super::design::Design;
use super::no_design::NoDesign;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Real};
use crate::plane::Angle;
use crate::plane::displacement::Displacement;

/// The parameters (Tesar 1964, chapter V), in units of the distance of O_b from the line.
#[derive(Clone, Debug)]
pub struct Conchoid<K> {
    /// DA.
    pub r: Number<K>,
    /// The angle of DO_b with the y-axis; D is at tan α.
    pub alpha: Angle<K>,
    /// The crank O_bB.
    pub k: Number<K>,
    /// 1 for B above O_b, −1 for B below.
    pub n: i64,
}

impl<K: Real> Conchoid<K> {
    /// The design. O_a is at (0, V₁) with V₁ = −(1 + cos α)(1 − 2r cos α)/(2r cos² α).
    ///
    /// # Errors
    /// α = 90°, r = 0.
    pub fn design(&self) -> Result<Design<K>, NoDesign> {
        let Conchoid { r, alpha, k, n } = self;
        let (c, s) = (alpha.cos(), alpha.sin());
        if c.is_zero().is_yes() {
            return Err(NoDesign::Rays(
                "the line through D and O_b is parallel to D's line",
            ));
        }
        if r.is_zero().is_yes() {
            return Err(NoDesign::PivotAtInfinity("A"));
        }
        let d = Number::complex(&s / &c, Number::zero());
        let a = &d + Number::complex(-(r * &s), r * &c);
        let height = -((1 + &c) * (1 - 2 * r * &c) / (2 * r * c.square()));
        let o_b = Number::i();
        let b = &o_b + Number::complex(*n * k * &c, *n * k * s);
        Design {
            linkage: CouplerPoint {
                pivots: [Number::complex(Number::zero(), height), o_b],
                pins: [a, b],
                point: d,
            },
            direction: Number::one(),
        }
        .checked()
    }

    /// The displacement to the position with D on the other side of the y-axis: a turn about O_b, by
    /// which A comes to its mirror image. `None` where it is this one.
    pub fn to_mirrored(&self) -> Option<Displacement<K>> {
        let turn = self.alpha.times(-2).cis();
        let moves = !(&turn - 1).is_zero().is_yes();
        moves.then(|| Displacement::about(&Number::i(), turn))
    }
}
