//! Chapter IV: the coupler triangle and the fixed link, seen from the pole.

use crate::formula::Bindings;
use crate::number::Real;
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/coupler-triangle",
    "A coupler triangle anywhere: its sides at A, the angle between them, where A is and how the triangle lies \
     are free.",
    build,
    [
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the coupler point B",
        "alpha_d": "ray of the slider's pin D",
        "PA": "from the pole to A, along its ray",
        "PB": "from the pole to B",
        "PD": "from the pole to D",
        "M": "length AD",
        "N": "length BD",
        "S": "length AB",
        "epsilon": "turn that leads from AB to AD, counterclockwise",
    ]
);

pub const FIXED_LINK: Scene = scene!(
    "tesar1964/fixed-link",
    "The pivots of two cranks anywhere: where O_a is, length and direction of the fixed link are free.",
    build_fixed_link,
    [
        "alpha_a": "ray of the crank A",
        "alpha_b": "ray of the crank B",
        "PO_a": "from the pole to the pivot O_a, along the ray of A",
        "PO_b": "from the pole to the pivot O_b",
        "Q": "length O_aO_b",
        "phi": "turn that leads from O_aO_b to the direction opposite to the ray of A, which leads from O_a to A \
                where PO_a > PA",
    ]
);

/// The ray of a point, and the length along it, as the root of that name.
fn ray<K: Real>(
    free: &mut dyn Free<K>,
    bindings: &mut Bindings<K>,
    [angle, distance]: [&str; 2],
    point: Point<K>,
) -> Result<(), Unbuilt> {
    let length = free.root(distance, &point.norm())?;
    bindings.bind(angle, Angle::of_known_length(point, length.clone()));
    bindings.bind(distance, length);
    Ok(())
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    let (alpha_a, pa) = (free.angle("alpha_a")?, free.number("PA")?);
    let (m, s) = (free.length("M")?, free.length("S")?);
    let (beta, epsilon) = (free.angle("direction of AD")?, free.angle("epsilon")?);
    let a = alpha_a.cis().scaled(&pa);
    let d = &a + beta.cis().scaled(&m);
    let b = &a + (&beta - &epsilon).cis().scaled(&s);
    bindings.bind("N", free.root("N", &(&d - &b).norm())?);
    ray(free, &mut bindings, ["alpha_d", "PD"], d)?;
    ray(free, &mut bindings, ["alpha_b", "PB"], b)?;
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("epsilon", epsilon);
    for (name, value) in [("PA", pa), ("M", m), ("S", s)] {
        bindings.bind(name, value);
    }
    Ok(bindings)
}

fn build_fixed_link<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let mut bindings = Bindings::new(free.precision());
    let (alpha_a, po_a) = (free.angle("alpha_a")?, free.number("PO_a")?);
    let (q, phi) = (free.length("Q")?, free.angle("phi")?);
    let direction = -(alpha_a.cis() * phi.cis().conj());
    let o_b = alpha_a.cis().scaled(&po_a) + direction.scaled(&q);
    ray(free, &mut bindings, ["alpha_b", "PO_b"], o_b)?;
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("phi", phi);
    bindings.bind("PO_a", po_a);
    bindings.bind("Q", q);
    Ok(bindings)
}
