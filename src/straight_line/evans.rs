//! Evans's linkage: a trammel with both slides replaced by cranks.
//!
//! A circle of radius 1 rolls in one of radius 2 about the origin. Its points go on diameters, those
//! off it on ellipses. B goes on the x-axis, D on the diameter at α, A on an ellipse with the axes at β
//! and across it. B's slide becomes a crank about a point k above the middle of its way, A's ellipse a
//! crank about the point of the axis at β that the normal of the ellipse meets.

use super::design::Design;
use super::no_design::NoDesign;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Real};
use crate::plane::Angle;
use crate::plane::displacement::Displacement;

/// The parameters (Tesar 1964, chapter V), in units of the rolling circle's radius.
#[derive(Clone, Debug)]
pub struct Evans<K> {
    /// The diameter on which D goes.
    pub alpha: Angle<K>,
    /// The axis of A's ellipse.
    pub beta: Angle<K>,
    /// The design position: the center of the rolling circle is at this angle.
    pub omega: Angle<K>,
    /// A's distance from the center of the rolling circle.
    pub rho: Number<K>,
    /// Height of B's pivot above B's line.
    pub k: Number<K>,
}

impl<K: Real> Evans<K> {
    /// The design. In the frame of A's ellipse, with δ = ω − β, A is at ((1 + ρ) cos δ, (1 − ρ) sin δ),
    /// its normal goes through 2e^{iδ} and meets the axis in 4ρ cos δ/(1 + ρ).
    ///
    /// # Errors
    /// ρ = −1: A goes on a line across the axis.
    pub fn design(&self) -> Result<Design<K>, NoDesign> {
        let Evans {
            alpha,
            beta,
            omega,
            rho,
            k,
        } = self;
        let turned = omega - beta;
        let sum = 1 + rho;
        if sum.is_zero().is_yes() {
            return Err(NoDesign::PivotAtInfinity("A"));
        }
        let axis = beta.cis();
        let a = &axis * Number::complex(turned.cos() * &sum, turned.sin() * (1 - rho));
        let o_a = axis.scaled(&(4 * rho * turned.cos() / sum));
        let b = Number::complex(2 * omega.cos(), Number::zero());
        let o_b = Number::complex(1 + omega.cos(), k.clone());
        let ray = alpha.cis();
        let travel = 2 * (alpha - omega).cos();
        Design {
            linkage: CouplerPoint {
                pivots: [o_a, o_b],
                pins: [a, b],
                point: ray.scaled(&travel),
            },
            direction: ray,
        }
        .checked()
    }

    /// The displacement to the position with A mirrored in B's line, if that is the axis of A's
    /// ellipse: a turn about B. `None` for another axis, and where A is on it.
    pub fn to_mirrored(&self) -> Option<Displacement<K>> {
        if !self.beta.sin().is_zero().is_yes() || self.omega.sin().is_zero().is_yes() {
            return None;
        }
        let design = self.design().ok()?;
        let [a, b] = &design.linkage.pins;
        let turn = (a.conj() - b) / (a - b);
        Some(Displacement::about(b, turn))
    }
}
