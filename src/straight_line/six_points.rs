//! Six positions of D on one line: four infinitely near, in Ball's point, and two more.
//!
//! The slider-crank is the guide: its slider keeps D on the line in all positions. A crank about the
//! center of a coupler point can replace the slider where the point is on one circle in all of them.
//! With five positions the two free points depend on the fifth through η alone (see
//! [`slider_crank`](crate::curvature::slider_crank)). So a sixth position has both of them if it has
//! the same η: its pole lies on the same circle that touches the pole tangent in the pole. That is
//! one equation for α_d, and wherever it holds all three alternates have six points on the line.

use super::no_design::NoDesign;
use super::slider_crank::{Assembly, Joints, joints};
use crate::curvature::slider_crank::{SliderCrank, eta};
use crate::number::{Number, Real};
use crate::plane::Point;

/// The two positions beside four that are infinitely near.
#[derive(Clone, Debug)]
pub enum Sixth<T> {
    /// D displaced by two distances: two intersections.
    Intersections([(T, Assembly); 2]),
    /// Two infinitely near ones after one displacement: a tangent.
    Tangent(T, Assembly),
    /// A fifth that is infinitely near and one apart: a Ball-Burmester point and an intersection.
    BallBurmester(T, Assembly),
}

impl<T> Sixth<T> {
    /// The same with other numbers.
    pub fn map<U>(&self, convert: impl Fn(&T) -> U) -> Sixth<U> {
        match self {
            Sixth::Intersections(both) => {
                Sixth::Intersections(both.each_ref().map(|(s, side)| (convert(s), *side)))
            }
            Sixth::Tangent(s, side) => Sixth::Tangent(convert(s), *side),
            Sixth::BallBurmester(s, side) => Sixth::BallBurmester(convert(s), *side),
        }
    }
}

/// What vanishes where the fifth and the sixth position have one η.
///
/// # Errors
/// The slider does not come so far.
pub fn equation<K: Real>(
    linkage: &SliderCrank<K>,
    sixth: &Sixth<Number<K>>,
) -> Result<Number<K>, NoDesign> {
    let joints = joints(linkage);
    let eta_at = |s: &Number<K>, side: Assembly| -> Result<Number<K>, NoDesign> {
        Ok(eta(&joints.displaced(s, side)?.displacement))
    };
    match sixth {
        Sixth::Intersections([(s, side), (other, other_side)]) => {
            Ok(eta_at(s, *side)? - eta_at(other, *other_side)?)
        }
        Sixth::Tangent(s, side) => rate_of_eta(&joints, s, *side),
        Sixth::BallBurmester(s, side) => {
            let (ca, sd) = (linkage.alpha_a.cos(), linkage.alpha_d.sin());
            if ca.is_zero().is_yes() {
                // Without the factor k cos α_d, that vanishes by itself.
                return Ok(1 - eta_at(s, *side)?);
            }
            let k_sin = &linkage.k * (&linkage.alpha_a - &linkage.alpha_d).sin();
            Ok(k_sin * (1 - eta_at(s, *side)?) - 2 * sd * ca)
        }
    }
}

/// |f|⁴ times the rate of η = Im((e^{iθ} − 1) f̄)/|f|² for f = D₂ − e^{iθ} D.
fn rate_of_eta<K: Real>(
    joints: &Joints<K>,
    s: &Number<K>,
    side: Assembly,
) -> Result<Number<K>, NoDesign> {
    let displaced = joints.displaced(s, side)?;
    let (slide, turn) = joints.rates(&displaced);
    let (e, f) = (
        &displaced.displacement.rotation,
        &displaced.displacement.translation,
    );
    let turning: Point<K> = (Number::i() * e).scaled(&turn);
    let shifting = joints.direction.scaled(&slide) - &turning * &joints.d;
    let product = turning * f.conj() + (e - 1) * shifting.conj();
    let squared = 2 * (f.conj() * shifting).re();
    Ok(product.im() * f.norm() - ((e - 1) * f.conj()).im() * squared)
}
