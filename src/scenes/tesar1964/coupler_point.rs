//! Chapter II: curvature of the path of any point.

use super::pole_frame::along;
use crate::curvature::motion::{Motion, turning};
use crate::curvature::osculation::{center_of_curvature, inflection_circle};
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/coupler-point",
    "Any motion seen from the pole, and any point of the moving plane. The center of curvature of its path \
     is that of the circle through three infinitesimally near points, from the series of the path.",
    build,
    [
        "r": "from the pole to the point, along the ray",
        "alpha": "ray of the point",
        "rho": "from the center of curvature to the point, along the ray",
        "PJ": "from the pole to the inflection pole: on the pole normal, where paths have an inflection",
    ]
);

pub const INFLECTION: Scene = scene!(
    "tesar1964/inflection-point",
    "Any motion seen from the pole, and the point on any ray whose path has an inflection.",
    build_inflection,
    [
        "r": "from the pole to the point, along the ray",
        "alpha": "ray of the point",
        "PJ": "from the pole to the inflection pole: on the pole normal, where paths have an inflection",
        "D": "diameter of the inflection circle",
    ]
);

fn motion<K: Real>(free: &mut dyn Free<K>) -> Result<Motion<K>, Unbuilt> {
    let second = Number::complex(Number::zero(), free.length("second shift of the pole")?);
    let third = point(free, "third shift of the pole")?;
    Ok(turning(&[Number::zero(), second, third], 3))
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let motion = motion(free)?;
    let alpha = free.angle("alpha")?;
    let r = free.number("r")?;
    let point = alpha.cis().scaled(&r);
    let [x, y, w] = center_of_curvature(&motion.path_of(&point))
        .coordinates()
        .clone();
    let center = Number::complex(x / &w, y / w);
    Unbuilt::unless_true::<K>(
        (center.conj() * &point).im().is_zero(),
        "a point and its center are on one ray",
    )?;
    let circle = inflection_circle(&motion);
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("rho", &r - along(&alpha.cis(), &center));
    bindings.bind("PJ", -circle.c / circle.a);
    bindings.bind("r", r);
    bindings.bind("alpha", alpha);
    Ok(bindings)
}

fn build_inflection<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let circle = inflection_circle(&motion(free)?);
    let alpha = free.angle("alpha")?;
    Unbuilt::unless_true::<K>(circle.d.is_zero(), "the pole is on the inflection circle")?;
    let linear = &circle.b * alpha.cos() + &circle.c * alpha.sin();
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("r", -linear / &circle.a);
    bindings.bind("PJ", -&circle.c / &circle.a);
    bindings.bind("D", -circle.c / circle.a);
    bindings.bind("alpha", alpha);
    Ok(bindings)
}
