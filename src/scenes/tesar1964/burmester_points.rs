//! Chapter II: three Burmester points on given rays.

use super::pole_frame::{Constants, pair_on_ray, unless_contact, with_burmester_rays};
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/burmester-points",
    "Any motion, by the rays of three of its Burmester points and the direction of its third shift: \
     the conditions of contact of order four with a circle, from the series of the paths, have then one \
     solution.",
    build,
    [
        "alpha_a": "ray of the Burmester point A",
        "alpha_b": "ray of the Burmester point B",
        "alpha": "ray of a third Burmester point",
        "M": "diameter of the circle that osculates the cubic in the pole and touches the pole tangent",
        "N": "the same for the pole normal",
        "R": "radius of curvature of the moving polode",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let angles = [
        free.slope("alpha_a")?,
        free.slope("alpha_b")?,
        free.slope("alpha")?,
    ];
    let third = Number::complex(free.number("a_3/b_3")?, Number::one());
    let rays = angles.each_ref().map(|angle| angle.direction().clone());
    let [a, b, c] = &rays;
    let invariants = with_burmester_rays([a, b, c], &third, false);
    let motion = invariants.motion();
    unless_contact(
        &motion,
        &rays.each_ref().map(|ray| pair_on_ray(&invariants, ray)),
    )?;
    let mut bindings = Bindings::new(free.precision());
    Constants::of(&motion)?.bind(&mut bindings);
    for (name, angle) in ["alpha_a", "alpha_b", "alpha"].into_iter().zip(angles) {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}
