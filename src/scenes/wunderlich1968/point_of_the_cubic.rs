//! Section 4: a quadrilateral and a point from which opposite sides are seen under equal or
//! supplementary angles.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Angle, Point, line};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/point-of-the-cubic",
    "A quadrilateral MABN with M in the origin and N on the x-axis, and a point F with angle AFM + \
     angle NFB = 0 mod pi. N, A and F are free; this leaves a line through F for B.",
    build,
    [
        "d": "length MN",
        "z": "complex coordinate of F",
        "z_A": "complex coordinate of A",
        "z_B": "complex coordinate of B",
    ]
);

pub const QUADRILATERAL: Scene = scene!(
    "wunderlich1968/quadrilateral",
    "Any quadrilateral MABN with M in the origin and N on the x-axis, and the meets of its opposite \
     sides.",
    build_quadrilateral,
    [
        "d": "length MN",
        "z_A": "complex coordinate of A",
        "z_B": "complex coordinate of B",
        "X": "where the lines MA and NB meet",
        "Y": "where the lines MN and AB meet",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let d = free.length("d")?;
    let (a, f) = (point(free, "A")?, point(free, "F")?);
    let share = free.number("share")?;
    let (m, n): (Point<K>, Point<K>) = (Number::zero(), d.clone().into());
    // (M − F)(B − F) must be a real multiple of (A − F)(N − F).
    let b = &f + ((&a - &f) * (&n - &f) / (&m - &f)).scaled(&share);
    let sum = &Angle::at_vertex(&a, &f, &m) + &Angle::at_vertex(&n, &f, &b);
    Unbuilt::unless_true::<K>(
        sum.direction().im().is_zero(),
        "the angles at F do not add to a multiple of pi",
    )?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("d", d);
    bindings.bind("z", f);
    bindings.bind("z_A", a);
    bindings.bind("z_B", b);
    Ok(bindings)
}

fn build_quadrilateral<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let d = free.length("d")?;
    let (a, b) = (point(free, "A")?, point(free, "B")?);
    let (m, n): (Point<K>, Point<K>) = (Number::zero(), d.clone().into());
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("X", line::meet(&m, &a, &n, &b));
    bindings.bind("Y", line::meet(&m, &n, &a, &b));
    bindings.bind("d", d);
    bindings.bind("z_A", a);
    bindings.bind("z_B", b);
    Ok(bindings)
}
