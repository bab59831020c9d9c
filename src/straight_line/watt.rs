//! Watt's linkage: two cranks that are parallel in the design position.
//!
//! The coupler starts with a translation, and the pole is at infinity in the direction of the cranks.
//! With the second derivatives of the paths of A and B across the motion, −1/R and n/T, the point at
//! rAB on the coupler has none if r = T/(T + nR); all points on its parallel to the cranks share that.

use super::design::Design;
use super::no_design::NoDesign;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point};

/// The parameters (Tesar 1964, chapter V), in units of the coupler S.
#[derive(Clone, Debug)]
pub struct Watt<K> {
    /// The crank O_aA.
    pub r: Number<K>,
    /// The crank O_bB.
    pub t: Number<K>,
    /// From the cranks to the coupler AB, clockwise.
    pub gamma: Angle<K>,
    /// 1 for cranks to opposite sides of the coupler (crossed), −1 for cranks to one side (open).
    pub n: i64,
    /// CD, from the point C of the coupler, along the cranks.
    pub k: Number<K>,
}

impl<K: Real> Watt<K> {
    /// The design, with C as origin and the line along the x-axis.
    ///
    /// # Errors
    /// Open cranks of one length: a parallelogram, all of whose points go on circles.
    pub fn design(&self) -> Result<Design<K>, NoDesign> {
        let Watt { r, t, gamma, n, k } = self;
        let sum = t + *n * r;
        if sum.is_zero().is_yes() {
            return Err(NoDesign::NotReal(
                "the point C of open cranks with R = T, a parallelogram,",
            ));
        }
        let up = |length: Number<K>| -> Point<K> { Number::complex(Number::zero(), length) };
        let coupler = Number::complex(gamma.sin(), gamma.cos());
        let a = -coupler.scaled(&(t / sum));
        let b = &a + &coupler;
        Design {
            linkage: CouplerPoint {
                pivots: [&a - up(r.clone()), &b + up(*n * t)],
                pins: [a, b],
                point: up(k.clone()),
            },
            direction: Number::one(),
        }
        .checked()
    }
}
