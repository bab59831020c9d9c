//! Section 4: the order of the curve of admissible points F.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Point, quadrilateral};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/focal-cubic",
    "Any quadrilateral MABN, M in the origin, N on the x-axis, and the curve of the points from which \
     opposite sides are seen under angles with a sum of 0 mod pi.",
    build,
    not symbolic: "an order that holds for all values; it drops for some",
    [
        "d": "length MN",
        "z_A": "complex coordinate of A",
        "z_B": "complex coordinate of B",
        "order": "order of the curve, lines at infinity not counted",
    ]
);

pub const PARALLELOGRAM: Scene = scene!(
    "wunderlich1968/focal-cubic-of-a-parallelogram",
    "The curve of the scene focal-cubic for a parallelogram MABN.",
    build_parallelogram,
    not symbolic: "an order that holds for all values; it drops for some",
    [
        "d": "length MN",
        "z_A": "complex coordinate of A",
        "z_B": "complex coordinate of B",
        "order": "order of the curve, lines at infinity not counted",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let d = free.length("d")?;
    let (a, b) = (point(free, "A")?, point(free, "B")?);
    bound(d, a, b, free)
}

fn build_parallelogram<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let d = free.length("d")?;
    let a = point(free, "A")?;
    let b = &a + Point::from(d.clone());
    bound(d, a, b, free)
}

fn bound<K: Real>(
    d: Number<K>,
    a: Point<K>,
    b: Point<K>,
    free: &mut dyn Free<K>,
) -> Result<Bindings<K>, Unbuilt> {
    let corners = [Number::zero(), a.clone(), b.clone(), d.clone().into()];
    let order = quadrilateral::focal_curve(&corners)
        .order()
        .and_then(|order| i64::try_from(order).ok())
        .ok_or_else(|| Unbuilt::NotHeld("the order of the curve".to_owned()))?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("order", Number::<K>::from(order));
    bindings.bind("d", d);
    bindings.bind("z_A", a);
    bindings.bind("z_B", b);
    Ok(bindings)
}
