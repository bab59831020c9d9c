//! Chapter IV: a slider-crank in its second position, seen from the pole of the first.

use crate::curvature::closure;
use crate::curvature::contact::Guide;
use crate::curvature::motion::{Motion, Path, coefficient};
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point};
use crate::scenes::free::point;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/second-position",
    "A slider-crank in a second position, seen from the pole of the design position, which is on the ray \
     of the pivot O_a and on that of D_1. The way of the slider, length and direction of the crank are free. The \
     x-axis has its origin in O_a and is the ray of D_1, turned by 90 deg; the slider moves along it. B_2 is any \
     point of the coupler.",
    build,
    [
        "alpha_a": "ray of the crank in the design position",
        "alpha_d": "ray of the slider's pin D in the design position",
        "PO_a": "from the pole to the pivot O_a, along the ray of A",
        "s_12": "from D_1 to D_2, along the x-axis",
        "s_2": "abscissa of D_2",
        "omega": "direction of the crank from O_a to A_2, from the x-axis",
        "x_b": "coordinate of B_2, from the x-axis",
        "y_b": "coordinate of B_2, from the x-axis",
        "U_b": "coordinate of B_2, along the pole tangent",
        "V_b": "coordinate of B_2, along the pole normal",
        "U_P2": "coordinate of P_2, the point of the coupler without velocity",
        "V_P2": "coordinate of P_2",
    ]
);

pub const TANGENT: Scene = scene!(
    "tesar1964/tangent-at-the-second-position",
    "The same, with a pivot O_b anywhere across the direction in which B starts from B_2, by the closure of the \
     slider-crank: with a crank O_bB in place of the slider, D passes D_2 along the slider's line.",
    build_tangent,
    [
        "U_Ob": "coordinate of the pivot O_b",
        "V_Ob": "coordinate of the pivot O_b",
        "U_P2": "coordinate of P_2, the point of the coupler without velocity",
        "V_P2": "coordinate of P_2",
        "U_b2": "coordinate of B_2",
        "V_b2": "coordinate of B_2",
    ]
);

struct SecondPosition<K> {
    alpha_a: Angle<K>,
    alpha_d: Angle<K>,
    to_pivot: Number<K>,
    travel: Number<K>,
    omega: Angle<K>,
    x_axis: Displacement<K>,
    slider: Point<K>,
    /// From here on, to terms in θ.
    start: Motion<K>,
}

impl<K: Real> SecondPosition<K> {
    fn new(free: &mut dyn Free<K>) -> Result<Self, Unbuilt> {
        let (alpha_a, alpha_d) = (free.angle("alpha_a")?, free.angle("alpha_d")?);
        let to_pivot = free.number("PO_a")?;
        let pivot = alpha_a.cis().scaled(&to_pivot);
        let x_axis = Displacement {
            rotation: Number::i() * alpha_d.cis(),
            translation: pivot.clone(),
        };
        let travel = free.number("s_12")?;
        let slider = alpha_d.cis().scaled(&free.number("PD")?) + x_axis.rotation.scaled(&travel);
        let omega = free.angle("omega")?;
        let pin = x_axis.of(&omega.cis().scaled(&free.length("R")?));
        let crank = Guide::Circle {
            point: pin,
            center: pivot,
        };
        let line = Guide::Line {
            point: slider.clone(),
            normal: alpha_d.cis(),
        };
        let start = closure::motion(&[crank, line], 1)
            .ok_or_else(|| Unbuilt::NotReal("it is a change point".to_owned()))?;
        Ok(SecondPosition {
            alpha_a,
            alpha_d,
            to_pivot,
            travel,
            omega,
            x_axis,
            slider,
            start,
        })
    }

    /// The point without velocity.
    fn pole(&self) -> Point<K> {
        velocity(&self.start.translation) / -velocity(&self.start.rotation)
    }
}

fn velocity<K: Kind>(path: &Path<K>) -> Point<K> {
    coefficient(path, 1)
}

fn bind_point<K: Real>(bindings: &mut Bindings<K>, index: &str, point: &Point<K>) {
    bindings.bind(&format!("U_{index}"), point.re().clone());
    bindings.bind(&format!("V_{index}"), point.im().clone());
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let position = SecondPosition::new(free)?;
    let seen = point(free, "B_2")?;
    let mut bindings = Bindings::new(free.precision());
    bind_point(&mut bindings, "b", &position.x_axis.of(&seen));
    bind_point(&mut bindings, "P2", &position.pole());
    let slider = position.x_axis.inverse().of(&position.slider);
    for (name, value) in [
        ("x_b", seen.re().clone()),
        ("y_b", seen.im().clone()),
        ("s_2", slider.re().clone()),
        ("s_12", position.travel),
        ("PO_a", position.to_pivot),
    ] {
        bindings.bind(name, value);
    }
    for (name, angle) in [
        ("alpha_a", position.alpha_a),
        ("alpha_d", position.alpha_d),
        ("omega", position.omega),
    ] {
        bindings.bind(name, angle);
    }
    Ok(bindings)
}

fn build_tangent<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let position = SecondPosition::new(free)?;
    let pin = point(free, "B_2")?;
    let across = Number::i() * velocity(&position.start.path_of(&pin));
    let pivot = &pin + across.scaled(&free.number("O_b along the normal")?);
    let mut bindings = Bindings::new(free.precision());
    bind_point(&mut bindings, "Ob", &pivot);
    bind_point(&mut bindings, "P2", &position.pole());
    bind_point(&mut bindings, "b2", &pin);
    Ok(bindings)
}
