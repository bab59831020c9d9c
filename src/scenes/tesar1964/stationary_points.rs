//! Chapter IV: points of a slider-crank's coupler with stationary curvature, and their centers.

use super::crank_and_slider::{CrankAndSlider, crank};
use super::pole_frame::Constants;
use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/stationary-points",
    "Any slider-crank in any position, in units of the diameter of the inflection circle. Its coupler's \
     motion is expanded from the closure; on any ray it has one point with four infinitesimally separated \
     positions on a circle.",
    build,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "alpha_d": "ray of the slider's pin D",
        "PA": "from the pole to A, along its ray",
        "PO_a": "from the pole to the pivot of the crank, along the ray of A",
        "PD": "from the pole to D, along its ray",
        "M": "diameter of the circle that osculates the cubic in the pole and touches the pole tangent",
        "N": "the same for the pole normal",
        "alpha": "any ray",
        "r": "from the pole to the point of the cubic of stationary curvature on that ray",
        "p": "from the pole to the center of the path of that point",
    ]
);

pub const CRANK: Scene = scene!(
    "tesar1964/crank",
    "The crank of any slider-crank, in units of the diameter of the inflection circle.",
    build_crank, not symbolic: "the sign of a length",
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "PA": "from the pole to A, along its ray",
        "PO_a": "from the pole to the pivot of the crank, along the ray of A",
        "R": "length of the crank",
    ]
);

fn build_crank<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (k, alpha_a) = (free.number("k")?, free.angle("alpha_a")?);
    let crank = crank(&k, alpha_a.direction());
    let (pa, po_a) = (crank.to_point(&alpha_a), crank.to_center(&alpha_a));
    let away = alpha_a.cis().scaled(&po_a) - crank.point;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("R", free.root("R", &away.norm())?);
    bindings.bind("PA", pa);
    bindings.bind("PO_a", po_a);
    bindings.bind("k", k);
    bindings.bind("alpha_a", alpha_a);
    Ok(bindings)
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let k = free.number("k")?;
    let (alpha_a, alpha_d) = (free.slope("alpha_a")?, free.slope("alpha_d")?);
    let alpha = free.slope("alpha")?;
    let linkage = CrankAndSlider::new(&k, alpha_a.direction(), alpha_d.direction())?;
    let pair = linkage.pair_on_ray(alpha.direction());
    let Constants { m, n, .. } = Constants::of(&linkage.motion)?;
    let mut bindings = Bindings::new(free.precision());
    for (name, value) in [
        ("k", k),
        ("PA", linkage.crank.to_point(&alpha_a)),
        ("PO_a", linkage.crank.to_center(&alpha_a)),
        ("PD", linkage.slider.to_point(&alpha_d)),
        ("M", m),
        ("N", n),
        ("r", pair.to_point(&alpha)),
        ("p", pair.to_center(&alpha)),
    ] {
        bindings.bind(name, value);
    }
    for (name, angle) in [("alpha_a", alpha_a), ("alpha_d", alpha_d), ("alpha", alpha)] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}
