//! Chapter VI: travel and deviation of the output point.

use crate::curvature::motion::{coefficient, turning};
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/tangent-of-the-path",
    "Any motion whose pole is the origin, with the pole tangent as the U-axis and an inflection circle \
     of diameter 1. The path of the output point D on that circle starts along the u-axis, without \
     curvature. Any point is given in both systems, of which both are right-handed.",
    build,
    [
        "alpha_d": "ray of D",
        "UP_1": "coordinate of D",
        "VP_1": "coordinate of D",
        "U": "coordinate of any point",
        "V": "coordinate of the same point",
        "u": "coordinate of the same point, along the tangent of the path of D, which is the origin",
        "v": "coordinate of the same point, across that tangent",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let alpha_d = free.angle("alpha_d")?;
    let place = point(free, "any point")?;
    let ray = alpha_d.cis();
    let output = ray.scaled(ray.im());
    let along = Number::i() * ray;
    let path = turning(&[Number::zero(), Number::i()], 2).path_of(&output);
    for order in [1, 2] {
        let step = coefficient(&path, order);
        let across = (step * along.conj()).im().is_zero();
        Unbuilt::unless_true::<K>(across, "the path of D starts straight along the u-axis")?;
    }
    let from_d = (&place - &output) * along.conj();
    let mut bindings = Bindings::new(free.precision());
    for (x, y, place) in [
        ("UP_1", "VP_1", &output),
        ("U", "V", &place),
        ("u", "v", &from_d),
    ] {
        bindings.bind(x, place.re().clone());
        bindings.bind(y, place.im().clone());
    }
    bindings.bind("alpha_d", alpha_d);
    Ok(bindings)
}
