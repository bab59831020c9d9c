//! Chapter VI: the follower's angle of a four-bar by that of its crank.

use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::{Angle, Point, line, relation};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/input-output",
    "Any four-bar in any position, with the pivot O_a in the origin and O_b on the positive x-axis. Fixed \
     link and cranks are free by lengths and angles; the coupler is what remains. The follower's other \
     position for the same place of the crank has B mirrored in the line through A and O_b. The output point \
     D is any point of the coupler.",
    build,
    [
        "Q": "length of the fixed link O_aO_b",
        "R": "length of the crank O_aA",
        "S": "length of the coupler AB",
        "T": "length of the crank O_bB",
        "M": "distance of D from A",
        "epsilon": "from AB to AD",
        "phi": "from the x-axis to the direction from O_a to A",
        "psi": "from the x-axis to the direction from O_b to B",
        "psi'": "the same in the follower's other position",
        "chi": "from the x-axis to the direction from A to B",
        "x_a": "coordinate of A",
        "y_a": "coordinate of A",
        "x_b": "coordinate of B",
        "y_b": "coordinate of B",
        "x": "coordinate of D",
        "y": "coordinate of D",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (q, r, t) = (free.length("Q")?, free.length("R")?, free.length("T")?);
    let (phi, psi) = (free.angle("phi")?, free.angle("psi")?);
    let (m, epsilon) = (free.length("M")?, free.angle("epsilon")?);
    let o_b = Point::from(q.clone());
    let a = phi.cis().scaled(&r);
    let b = &o_b + psi.cis().scaled(&t);
    let other = line::mirror(&b, &a, &o_b) - &o_b;
    let coupler = &b - &a;
    let s = free.root("S", &relation::distance_squared(&a, &b))?;
    let d = &a + (&coupler * epsilon.cis()).scaled(&(&m / &s));
    let mut bindings = Bindings::new(free.precision());
    for (x, y, place) in [("x_a", "y_a", &a), ("x_b", "y_b", &b), ("x", "y", &d)] {
        bindings.bind(x, free.among_all(place.re().clone()));
        bindings.bind(y, free.among_all(place.im().clone()));
    }
    bindings.bind("psi'", Angle::of_known_length(other, t.clone()));
    bindings.bind("chi", Angle::of_known_length(coupler, s.clone()));
    for (name, angle) in [("phi", phi), ("psi", psi), ("epsilon", epsilon)] {
        bindings.bind(name, angle);
    }
    for (name, value) in [("Q", q), ("R", r), ("S", s), ("T", t), ("M", m)] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}
