//! Section 2: a link AB between two cranks on one base.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::{Point, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "wunderlich1968/coupler",
    "One position of a four-bar MABN with M in the origin and N on the x-axis. Cranks, base and both \
     crank angles are free; the coupler is what remains.",
    build,
    [
        "a": "length MA",
        "b": "length NB",
        "c": "length AB of the coupler",
        "d": "length MN of the base",
        "u": "unit vector of MA",
        "v": "unit vector of NB",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (a, b, d) = (free.length("a")?, free.length("b")?, free.length("d")?);
    let u = free.angle("phi")?.direction().clone();
    let v = free.angle("psi")?.direction().clone();
    let pin_b = Point::from(d.clone()) + v.scaled(&b);
    let c = free.root("c", &relation::distance_squared(&u.scaled(&a), &pin_b))?;
    let mut bindings = Bindings::new(free.precision());
    let lengths: [(&str, Number<K>); 4] = [("a", a), ("b", b), ("c", c), ("d", d)];
    for (name, length) in lengths {
        bindings.bind(name, length);
    }
    bindings.bind("u", u);
    bindings.bind("v", v);
    Ok(bindings)
}
