//! Chapter V: five precision points on a line.

use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::Angle;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/precision-points",
    "Five points on a line, which is the u-axis.",
    build,
    [
        "theta": "from the x-axis to the u-axis",
        "x_1": "coordinate of the first point",
        "y_1": "coordinate of the first point",
        "x_2": "coordinate of the second point",
        "y_2": "coordinate of the second point",
        "x_3": "coordinate of the third point",
        "y_3": "coordinate of the third point",
        "x_4": "coordinate of the fourth point",
        "y_4": "coordinate of the fourth point",
        "x_5": "coordinate of the fifth point",
        "y_5": "coordinate of the fifth point",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let theta: Angle<K> = free.angle("theta")?;
    let origin = point(free, "the origin of u")?;
    let mut bindings = Bindings::new(free.precision());
    for j in 1..=5 {
        let place = &origin + theta.cis().scaled(&free.number(&format!("u_{j}"))?);
        bindings.bind(&format!("x_{j}"), place.re().clone());
        bindings.bind(&format!("y_{j}"), place.im().clone());
    }
    bindings.bind("theta", theta);
    Ok(bindings)
}
