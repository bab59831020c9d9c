//! Figure 3: a quadrilateral moved as a four-bar, and the pole of the coupler.

use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Point;
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1970/two-positions-of-a-quadrilateral",
    "The quadrilateral ABCD as a four-bar on the frame DA, in two positions. The coupler BC is \
     turned by any angle about any point S; A and D lie anywhere on the midnormals of BB' and CC', \
     which keeps the lengths AB and CD.",
    build,
    [
        "A": "fixed pivot",
        "B": "joint of AB and BC",
        "C": "joint of BC and CD",
        "D": "fixed pivot",
        "B'": "second position of B",
        "C'": "second position of C",
        "S": "where the midnormals of BB' and CC' meet",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (s, b, c) = (point(free, "S")?, point(free, "B")?, point(free, "C")?);
    let half = free.angle("half of the turn")?.cis();
    // From S the midnormal of a point and its image is seen half-way.
    let turned = |point: &Point<K>, times: i32| &s + (point - &s) * half.power(times);
    let on_midnormal = |point: &Point<K>, share: &Number<K>| {
        let seen = turned(point, 1) - &s;
        &s + seen.scaled(share)
    };
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("A", on_midnormal(&b, &free.number("SA : SB")?));
    bindings.bind("D", on_midnormal(&c, &free.number("SD : SC")?));
    bindings.bind("B'", turned(&b, 2));
    bindings.bind("C'", turned(&c, 2));
    for (name, point) in [("S", s), ("B", b), ("C", c)] {
        bindings.bind(name, point);
    }
    Ok(bindings)
}
