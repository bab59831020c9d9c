//! Chapter II: a four-bar in any position, seen from its pole.

use super::pole_frame::{Constants, Pair, unless_true};
use crate::curvature::closure;
use crate::curvature::motion::{Motion, coefficient, turning};
use crate::curvature::osculation::{center_of_curvature, inflection_circle, stationary_cubic};
use crate::formula::Bindings;
use crate::number::{Number, Real};
use crate::plane::Angle;
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/four-bar",
    "Any four-bar in any position. Its pins A, B are free; the pivots O_a, O_b are where the pole tangent and \
     the inflection circle come to lie as asked for. The coupler's motion is expanded from the closure of the \
     linkage; the cubic of stationary curvature are the points with four infinitesimally separated \
     positions on a circle.",
    build,
    [
        "r_a": "from the pole to the pin A, along its ray",
        "r_b": "from the pole to the pin B, along its ray",
        "PA": "the same as r_a",
        "PB": "the same as r_b",
        "alpha_a": "ray of A",
        "alpha_b": "ray of B",
        "PO_a": "from the pole to the pivot O_a, along the ray of A",
        "PO_b": "from the pole to the pivot O_b, along the ray of B",
        "O_aA": "from O_a to A, along the ray",
        "O_bB": "from O_b to B, along the ray",
        "D": "diameter of the inflection circle",
        "M": "diameter of the circle that osculates the cubic in the pole and touches the pole tangent",
        "N": "the same for the pole normal",
        "R": "radius of curvature of the moving polode",
        "alpha": "any ray",
        "r": "from the pole to the point of the cubic of stationary curvature on that ray",
    ]
);

pub const BALL: Scene = scene!(
    "tesar1964/ball-point",
    "Any four-bar in any position, and Ball's point of its coupler: beside the pole the only point whose path \
     has an inflection and four infinitesimally separated positions on a circle, both from the series of \
     the motion.",
    build_ball,
    [
        "alpha": "ray of Ball's point, modulo 180 deg",
        "D": "diameter of the inflection circle",
        "M": "diameter of the circle that osculates the cubic in the pole and touches the pole tangent",
        "N": "the same for the pole normal",
    ]
);

struct FourBar<K> {
    diameter: Number<K>,
    angles: [Angle<K>; 2],
    cranks: [Pair<K>; 2],
    motion: Motion<K>,
}

fn four_bar<K: Real>(free: &mut dyn Free<K>) -> Result<FourBar<K>, Unbuilt> {
    let diameter = free.length("D")?;
    let shift = Number::complex(Number::zero(), diameter.clone());
    let to_second_order = turning(&[Number::zero(), shift.clone()], 2);
    let mut crank = |name: &str| -> Result<(Angle<K>, Pair<K>), Unbuilt> {
        let angle = free.angle(&format!("alpha_{name}"))?;
        let ray = angle.cis();
        let point = ray.scaled(&free.number(&format!("r_{name}"))?);
        let center = center_of_curvature(&to_second_order.path_of(&point));
        let [x, y, w] = center.coordinates();
        let center = Some(Number::complex(x / w, y / w));
        Ok((angle, Pair { ray, point, center }))
    };
    let (first, second) = (crank("a")?, crank("b")?);
    let cranks = [first.1, second.1];
    let motion = closure::motion(&cranks.each_ref().map(Pair::guide), 4)
        .ok_or_else(|| Unbuilt::NotReal("the linkage is in a change point".to_owned()))?;
    let placed = coefficient(&motion.translation, 1).is_zero()
        & (2 * coefficient(&motion.translation, 2)).equals(&shift);
    Unbuilt::unless_true::<K>(placed, "the pole is the origin, and its normal the y-axis")?;
    Ok(FourBar {
        diameter,
        angles: [first.0, second.0],
        cranks,
        motion,
    })
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let FourBar {
        diameter,
        angles,
        cranks,
        motion,
    } = four_bar(free)?;
    let alpha = free.angle("alpha")?;
    let cubic = stationary_cubic(&motion)
        .ok_or_else(|| Unbuilt::NotHeld("the cubic of stationary curvature".to_owned()))?;
    // In polar coordinates it has r² and r³ only.
    let (c, s) = (alpha.cos(), alpha.sin());
    let [x3, x2y, xy2, y3, x2, xy, y2, ..] = cubic.coefficients();
    let third = ((x3 * &c + x2y * &s) * &c + xy2 * s.square()) * &c + y3 * s.power(3);
    let second = (x2 * &c + xy * &s) * &c + y2 * s.square();
    let mut bindings = Bindings::new(free.precision());
    for (name, pair, angle) in [("a", &cranks[0], &angles[0]), ("b", &cranks[1], &angles[1])] {
        let upper = name.to_uppercase();
        let (point, center) = (pair.to_point(angle), pair.to_center(angle));
        bindings.bind(&format!("alpha_{name}"), angle.clone());
        bindings.bind(&format!("r_{name}"), point.clone());
        bindings.bind(&format!("P{upper}"), point.clone());
        bindings.bind(&format!("PO_{name}"), center.clone());
        bindings.bind(&format!("O_{name}{upper}"), point - center);
    }
    bindings.bind("D", diameter);
    bindings.bind("alpha", alpha);
    bindings.bind("r", -second / third);
    Constants::of(&motion)?.bind(&mut bindings);
    Ok(bindings)
}

fn build_ball<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let FourBar {
        diameter, motion, ..
    } = four_bar(free)?;
    let cubic = stationary_cubic(&motion)
        .ok_or_else(|| Unbuilt::NotHeld("the cubic of stationary curvature".to_owned()))?;
    let circle = inflection_circle(&motion);
    // On the circle x² + y² = −cy/a; then y can be divided out of the cubic.
    let [x3, _, _, y3, _, xy, ..] = cubic.coefficients();
    let ray = Number::complex(&circle.c * y3, xy * &circle.a - &circle.c * x3);
    let common_point = || {
        let r = -(&circle.b * ray.re() + &circle.c * ray.im()) / (&circle.a * ray.norm());
        let point = ray.scaled(&r);
        circle.at(&point).is_zero() & cubic.at(&point).is_zero()
    };
    unless_true::<K>(
        common_point,
        "Ball's point is on the circle and on the cubic",
    )?;
    let Constants { m, n, .. } = Constants::of(&motion)?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("alpha", Angle::of(ray));
    bindings.bind("D", diameter);
    bindings.bind("M", m);
    bindings.bind("N", n);
    Ok(bindings)
}
