//! The linkage in its design position.

use super::listing::Listing;
use crate::formula::Bindings;
use crate::number::Elementary;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/program",
    "The four-bar with a Ball-double-Burmester point as the program has it in the design position: \
     lines 23 to 106 of its listing. Lengths are divided by the unit length, angles are in degrees.",
    build,
    machine: 8,
    build,
    [
        "alpha_a": "ray of A in degrees",
        "alpha_b": "ray of B in degrees",
        "alpha_d": "ray of D in degrees, from 0 to 180",
        "unit": "unit length (6.27), the diameter of the inflection circle being 1",
        "Q": "fixed link O_a O_b",
        "R": "crank O_a A",
        "S": "coupler A B",
        "T": "crank O_b B",
        "M": "distance A D",
        "N": "distance B D",
        "epsilon": "turn from AB to AD",
        "phi": "turn from the fixed link to R, from 0 to 360",
        "psi": "turn from the fixed link to T, from 0 to 360",
        "gamma_a": "acute angle at A",
        "gamma_b": "acute angle at B",
    ]
);

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let listing = Listing::run(free)?;
    let mut bindings = Bindings::new(free.precision());
    for name in ["alpha_a", "alpha_b"] {
        bindings.bind(name, free.number(name)?);
    }
    let Listing { degree, unit, .. } = &listing;
    for (name, angle) in [
        ("alpha_d", &listing.alpha_d),
        ("phi", &listing.phi),
        ("psi", &listing.psi),
    ] {
        bindings.bind(name, angle / degree);
    }
    for (name, length) in [
        ("Q", &listing.q),
        ("R", &listing.r),
        ("S", &listing.s),
        ("T", &listing.t),
        ("M", &listing.m),
        ("N", &listing.n),
    ] {
        bindings.bind(name, length / unit);
    }
    let [gamma_a, gamma_b] = listing.gamma;
    bindings.bind("unit", listing.unit);
    bindings.bind("epsilon", listing.epsilon);
    bindings.bind("gamma_a", gamma_a);
    bindings.bind("gamma_b", gamma_b);
    Ok(bindings)
}
