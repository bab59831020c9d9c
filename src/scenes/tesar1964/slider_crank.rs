//! Chapter II: the slider-crank and its alternates.

use crate::curvature::slider_crank::{Alternates, SliderCrank};
use crate::formula::Bindings;
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/slider-crank",
    "A slider-crank in one position, in units of the diameter of the inflection circle, with the two \
     other Burmester points B and C of its coupler AD. They are found from the motion's series to \
     order four, as the points whose paths have contact of order four with a circle.",
    build,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the Burmester point B, in [0 deg, 180 deg)",
        "alpha_c": "ray of the Burmester point C, in [0 deg, 180 deg), the one with the larger tangent",
        "alpha_d": "ray of the slider's pin D",
        "PD": "distance of D from the pole",
        "PA": "distance of A from the pole",
        "PB": "distance of B from the pole",
        "PC": "distance of C from the pole",
        "PO_a": "distance of the center of the path of A from the pole",
        "PO_b": "distance of the center of the path of B from the pole",
        "PO_c": "distance of the center of the path of C from the pole",
        "N": "constant of the cubic of stationary curvature",
        "M": "constant of the cubic of stationary curvature",
        "R": "radius of curvature of the moving polode",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let linkage = SliderCrank {
        k: free.number("k")?,
        alpha_a: free.angle("alpha_a")?,
        alpha_d: free.angle("alpha_d")?,
    };
    let [b, c] = match linkage.alternates() {
        Alternates::Real(pairs) => *pairs,
        Alternates::Complex(_) => return Err(Unbuilt::NotReal("B and C are complex".to_owned())),
        Alternates::Undetermined => {
            return Err(Unbuilt::NotReal("the crank guides nothing".to_owned()));
        }
        Alternates::Undecided => {
            return Err(Unbuilt::NotHeld("the sign of the discriminant".to_owned()));
        }
    };
    let numbers = [
        ("PD", linkage.pd()),
        ("PO_a", linkage.po_a()),
        ("PA", linkage.pa().value()),
        ("N", linkage.n().value()),
        ("M", linkage.m().value()),
        ("R", linkage.r().value()),
        ("PB", b.point.value()),
        ("PO_b", b.center.value()),
        ("PC", c.point.value()),
        ("PO_c", c.center.value()),
    ];
    let mut bindings = Bindings::new(free.precision());
    for (name, number) in numbers {
        if !number.has_value() {
            return Err(Unbuilt::NotHeld(format!(
                "{name}, which is infinite or irrational"
            )));
        }
        bindings.bind(name, number);
    }
    bindings.bind("k", linkage.k);
    bindings.bind("alpha_a", linkage.alpha_a);
    bindings.bind("alpha_b", b.ray);
    bindings.bind("alpha_c", c.ray);
    bindings.bind("alpha_d", linkage.alpha_d);
    Ok(bindings)
}
