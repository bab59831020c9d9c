//! A slider-crank in one position, seen from its pole, in units of the diameter of the inflection
//! circle.

use super::pole_frame::{Pair, inflection_point, pair_on_ray, unless_true};
use crate::curvature::canonical::Invariants;
use crate::curvature::closure;
use crate::curvature::motion::{Motion, coefficient, turning};
use crate::curvature::osculation::center_of_curvature;
use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::scenes::Unbuilt;

/// The crank with its pivot, and the slider's pin, whose center is at infinity on its ray.
pub(super) struct CrankAndSlider<K> {
    pub crank: Pair<K>,
    pub slider: Pair<K>,
    /// Of the coupler, to terms in θ³.
    pub motion: Motion<K>,
}

impl<K: Kind> CrankAndSlider<K> {
    /// By k = PO_a / sin α_a and directions of the two rays, of any length.
    pub fn new(k: &Number<K>, ray_a: &Point<K>, ray_d: &Point<K>) -> Result<Self, Unbuilt> {
        let crank = crank(k, ray_a);
        let slider = inflection_point(ray_d);
        let motion = closure::motion(&[crank.guide(), slider.guide()], 3)
            .ok_or_else(|| Unbuilt::NotReal("the linkage is in a change point".to_owned()))?;
        let placed = || {
            let half = Number::i() / 2;
            coefficient(&motion.translation, 1).is_zero()
                & coefficient(&motion.translation, 2).equals(&half)
        };
        unless_true::<K>(placed, "the pole is the origin, the inflection pole is i")?;
        Ok(CrankAndSlider {
            crank,
            slider,
            motion,
        })
    }

    /// The point of a ray with four infinitesimally separated positions on a circle.
    pub fn pair_on_ray(&self, ray: &Point<K>) -> Pair<K> {
        let invariants = Invariants {
            third: coefficient(&self.motion.translation, 3) * 6,
            fourth: Number::zero(),
        };
        pair_on_ray(&invariants, ray)
    }
}

/// The crank of this k whose pin is on a ray.
pub(super) fn crank<K: Kind>(k: &Number<K>, ray: &Point<K>) -> Pair<K> {
    let pivot = inflection_point(ray).point.scaled(k);
    Pair {
        ray: ray.clone(),
        point: point_of_center(&pivot),
        center: Some(pivot),
    }
}

/// The point whose path has its center of curvature in a given point: seen from the moving plane that
/// is the center of the path of the given point.
fn point_of_center<K: Kind>(center: &Point<K>) -> Point<K> {
    let seen = turning(&[Number::zero(), Number::i()], 2).inverse();
    let [x, y, w] = center_of_curvature(&seen.path_of(center))
        .coordinates()
        .clone();
    Number::complex(x / &w, y / w)
}
