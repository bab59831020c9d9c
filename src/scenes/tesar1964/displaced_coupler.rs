//! Chapter IV: a coupler in its design position and in a displaced one.

use super::pole_frame::along;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point, line};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/displaced-coupler",
    "Two positions of a coupler whose point D moves along the slider's line, which is across the ray of D \
     from the pole P_1 of the design position. The way of D and the turn are free. B is any other point, and O_b the \
     point of its ray as far from B_1 as from B_2: a crank O_bB can lead the coupler through both positions.",
    build,
    [
        "alpha_b": "ray of the coupler point B in the design position",
        "alpha_d": "ray of the slider's pin D in the design position",
        "PB": "from the pole to B in the design position, along its ray",
        "PO_b": "from the pole to the pivot O_b, along the ray of B",
        "s_12": "from D_1 to D_2, in the direction of the ray of D turned by 90 deg",
        "theta": "any ray",
        "m": "from the pole to the point of the line P_12 D_12 on that ray",
        "U_b2": "coordinate of B_2, along the pole tangent",
        "V_b2": "coordinate of B_2, along the pole normal",
        "P_12": "pole of the two positions",
        "D_12": "middle of D_1 and D_2",
        "B_12": "middle of B_1 and B_2",
        "O_b": "the pivot O_b",
    ]
);

pub const DEVIATION: Scene = scene!(
    "tesar1964/deviation-from-the-crank",
    "The same with two points B and C of the coupler and a pivot anywhere on the ray of each, so that B and C \
     need not keep to their cranks in the displaced position.",
    build_deviation,
    [
        "alpha_b": "ray of the coupler point B in the design position",
        "alpha_c": "ray of the coupler point C in the design position",
        "PO_b": "from the pole to the pivot O_b, along the ray of B",
        "PO_c": "from the pole to the pivot O_c, along the ray of C",
        "O_bB": "from B to O_b, along the ray",
        "O_cC": "from C to O_c, along the ray",
        "U_Ob": "coordinate of O_b",
        "V_Ob": "coordinate of O_b",
        "U_Oc": "coordinate of O_c",
        "V_Oc": "coordinate of O_c",
        "U_3": "coordinate of the displaced point B, where the displaced position is the third",
        "V_3": "coordinate of the displaced point B, where the displaced position is the third",
        "U_b2": "coordinate of the displaced point B, where it is the second",
        "V_b2": "coordinate of the displaced point B, where it is the second",
        "U_c2": "coordinate of the displaced point C",
        "V_c2": "coordinate of the displaced point C",
        "delta": "by how much the square of the distance from O_b grows when B is displaced",
        "delta_b": "the same",
        "delta_c": "by how much the square of the distance from O_c grows when C is displaced",
    ]
);

/// The pin of the slider in its design position, and the displacement that leads to the second.
struct Displaced<K> {
    alpha_d: Angle<K>,
    slider: Point<K>,
    travel: Number<K>,
    second: Displacement<K>,
}

impl<K: Real> Displaced<K> {
    fn new(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let alpha_d = free.angle("alpha_d")?;
        let slider = alpha_d.cis().scaled(&free.number("PD")?);
        let travel = free.number("s_12")?;
        let turn = free.angle("turn of the coupler")?.cis();
        let moved = &slider + (Number::i() * alpha_d.cis()).scaled(&travel);
        let second = Displacement {
            translation: moved - &turn * &slider,
            rotation: turn,
        };
        Ok(Displaced {
            alpha_d,
            slider,
            travel,
            second,
        })
    }
}

/// The point of the ray of a point that is as far from it as from its second place.
fn pivot_on_ray<K: Kind>(point: &Point<K>, second: &Displacement<K>) -> Point<K> {
    let place = second.of(point);
    let middle = (point + &place) / 2;
    let toward = &middle + Number::i() * (place - point);
    line::meet(&Number::zero(), point, &middle, &toward)
}

fn bind_point<K: Real>(bindings: &mut Bindings<K>, index: &str, point: &Point<K>) {
    bindings.bind(&format!("U_{index}"), point.re().clone());
    bindings.bind(&format!("V_{index}"), point.im().clone());
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let Displaced {
        alpha_d,
        slider,
        travel,
        second,
    } = Displaced::new(free)?;
    let (alpha_b, theta) = (free.angle("alpha_b")?, free.angle("theta")?);
    let pb = free.number("PB")?;
    let point = alpha_b.cis().scaled(&pb);
    let place = second.of(&point);
    let center = pivot_on_ray(&point, &second);
    let pole = second.pole(&Displacement::identity());
    let d_12 = (&slider + second.of(&slider)) / 2;
    let met = line::meet(&Number::zero(), &theta.cis(), &pole, &d_12);
    let mut bindings = Bindings::new(free.precision());
    bind_point(&mut bindings, "b2", &place);
    bindings.bind("m", along(&theta.cis(), &met));
    bindings.bind("PO_b", along(&alpha_b.cis(), &center));
    bindings.bind("PB", pb);
    bindings.bind("s_12", travel);
    for (name, value) in [
        ("P_12", pole),
        ("B_12", (point + place) / 2),
        ("D_12", d_12),
        ("O_b", center),
    ] {
        bindings.bind(name, value);
    }
    for (name, angle) in [("alpha_b", alpha_b), ("alpha_d", alpha_d), ("theta", theta)] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}

fn build_deviation<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let second = Displaced::new(free)?.second;
    let mut bindings = Bindings::new(free.precision());
    for (name, upper) in [("b", "B"), ("c", "C")] {
        let alpha = free.angle(&format!("alpha_{name}"))?;
        let to_point = free.number(&format!("P{upper}"))?;
        let to_pivot = free.number(&format!("PO_{name}"))?;
        let [point, pivot] = [&to_point, &to_pivot].map(|r| alpha.cis().scaled(r));
        let place = second.of(&point);
        let growth = (&place - &pivot).norm() - (&point - &pivot).norm();
        bind_point(&mut bindings, &format!("{name}2"), &place);
        bind_point(&mut bindings, &format!("O{name}"), &pivot);
        bindings.bind(&format!("delta_{name}"), growth.clone());
        if name == "b" {
            bind_point(&mut bindings, "3", &place);
            bindings.bind("delta", growth);
        }
        bindings.bind(&format!("O_{name}{upper}"), &to_pivot - to_point);
        bindings.bind(&format!("PO_{name}"), to_pivot);
        bindings.bind(&format!("alpha_{name}"), alpha);
    }
    Ok(bindings)
}
