//! Section 2: a point on a circle.

use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::Point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "example2020/circle",
    "A point on the circle of radius r about the origin.",
    build,
    [
        "r": "the radius",
        "z": "the point",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let r = free.length("r")?;
    let angle = free.angle("phi")?;
    let mut symbols = Bindings::new(free.precision());
    let z: Point<K> = angle.direction().scaled(&r);
    symbols.bind("r", r);
    symbols.bind("z", z);
    Ok(symbols)
}
