//! Symmetric linkages in their central position: those of Roberts and Chebyshev among them.

use super::design::Design;
use super::no_design::NoDesign;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Number, Real};

/// The parameters (Tesar 1964, chapter V), in units of half of the coupler.
#[derive(Clone, Debug)]
pub struct Symmetric<K> {
    /// The pivots are at −a and a; for a negative a the cranks are crossed.
    pub a: Number<K>,
    /// The altitude of the coupler triangle below the coupler AB.
    pub c: Number<K>,
    /// The height of the coupler above the base.
    pub d: Number<K>,
}

impl<K: Real> Symmetric<K> {
    /// The design, with the middle of the base as origin.
    ///
    /// # Errors
    /// Cranks without length.
    pub fn design(&self) -> Result<Design<K>, NoDesign> {
        let Symmetric { a, c, d } = self;
        let at = |x: Number<K>, y: &Number<K>| Number::complex(x, y.clone());
        let zero = Number::zero();
        Design {
            linkage: CouplerPoint {
                pivots: [at(-a, &zero), at(a.clone(), &zero)],
                pins: [at(Number::from(-1), d), at(Number::one(), d)],
                point: Number::complex(zero, d - c),
            },
            direction: Number::one(),
        }
        .checked()
    }
}
