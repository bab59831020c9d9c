//! The tangents from both points of each of three point pairs of the centerpoint curve.

use super::count::{bind_number, counted, number, tangents_from};
use super::quadrilateral::PoleQuadrilateral;
use super::side_order::Sides;
use crate::formula::{Bindings, Value};
use crate::number::Real;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "filemon1973/point-pairs",
    "The quadrilateral of the scene any-shape, and the tangents from its poles and from O1 and O2, which \
     are point pairs O12 O34, O14 O23, O1 O2. Where the curve has a loop or a closed branch, no real \
     tangent goes from its points to others.",
    build,
    not symbolic: "numbers of real tangents",
    [
        "U": "sum of the shortest and the longest side",
        "Z": "sum of the other two sides",
        "adjacent": "1 where the shortest and the longest side have a pole in common, else 0",
        "N_1": "number of real tangents from O1 to other points of the curve, of four",
        "I_2": "number of imaginary tangents from O2",
        "N_12": "number of real tangents from O12",
        "I_34": "number of imaginary tangents from O34",
        "N_14": "number of real tangents from O14",
        "I_23": "number of imaginary tangents from O23",
        "N_max": "number of real tangents from Q_max, that of O1 and O2 which faces the longest side",
        "N_s": "numbers of real tangents from both ends of the shortest side",
    ]
);

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let quadrilateral = PoleQuadrilateral::of_any_kind(free)?;
    let curve = quadrilateral.curve()?;
    let sides = Sides::of(&quadrilateral)?;
    let from_o1 = counted(&quadrilateral.pencil_of_o1(&curve))?;
    let from_o2 = counted(&quadrilateral.pencil_of_o2(&curve))?;
    let mut of_poles = Vec::new();
    for pole in quadrilateral.poles() {
        of_poles.push(tangents_from(&curve, &pole)?);
    }
    let [of_12, of_23, of_34, of_14] = of_poles.as_slice() else {
        return Err(Unbuilt::Contradiction("not four poles".to_owned()));
    };
    let facing_the_longest = if sides.longest == 1 { from_o1 } else { from_o2 };
    let mut bindings = Bindings::new(free.precision());
    for (name, count) in [
        ("N_1", from_o1.real),
        ("I_2", from_o2.imaginary),
        ("N_12", of_12.real),
        ("I_34", of_34.imaginary),
        ("N_14", of_14.real),
        ("I_23", of_23.imaginary),
        ("N_max", facing_the_longest.real),
        ("adjacent", sides.are_adjacent().into()),
    ] {
        bind_number(&mut bindings, name, count);
    }
    let ends = of_poles.iter().cycle().skip(sides.shortest).take(2);
    let ends = ends.map(|end| Value::Number(number(end.real)));
    bindings.bind("N_s", Value::Set(ends.collect()));
    bindings.bind("U", sides.u);
    bindings.bind("Z", sides.z);
    Ok(bindings)
}
