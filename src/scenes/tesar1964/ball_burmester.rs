//! Chapter II: a Burmester point on the inflection circle, and the three others.

use super::pole_frame::{
    Constants, Pair, angle_of_tangent, fourth_tangent, inflection_point, pair_on_ray,
    unless_contact, unless_true, with_burmester_rays,
};
use crate::curvature::canonical::Invariants;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/ball-burmester-point",
    "A motion with a Burmester point D on the inflection circle, whose diameter is 1: the coupler of a \
     four-bar with the pins A and B, and of a slider-crank with the crank pin A and the slider's pin D. \
     The rays of A, B and D are free; contact of order four, from the series of the paths, leaves one \
     motion, and with it the fourth Burmester point C.",
    build,
    [
        "alpha_a": "ray of the Burmester point A",
        "alpha_b": "ray of the Burmester point B",
        "alpha_c": "ray of the Burmester point C",
        "alpha_d": "ray of the Burmester point D",
        "PA": "from the pole to A, along its ray",
        "PB": "from the pole to B, along its ray",
        "PC": "from the pole to C, along its ray",
        "PD": "from the pole to D, along its ray",
        "r_c": "the same as PC",
        "PO_a": "from the pole to the center of the path of A",
        "PO_b": "from the pole to the center of the path of B",
        "PO_c": "from the pole to the center of the path of C",
        "A": "Burmester point",
        "B": "Burmester point",
        "C": "Burmester point",
        "D": "Burmester point on the inflection circle",
        "M": "diameter of the circle that osculates the cubic in the pole and touches the pole tangent",
        "N": "the same for the pole normal",
        "R": "radius of curvature of the moving polode",
        "V": "tan alpha_a + tan alpha_b",
        "W": "tan alpha_a tan alpha_b",
        "k": "PO_a / sin alpha_a",
        "K_b": "tan alpha_b - tan alpha_d",
        "K_c": "tan alpha_c - tan alpha_d",
    ]
);

pub const DOUBLE: Scene = scene!(
    "tesar1964/ball-double-burmester-point",
    "The same with two Burmester points, C and D, that coincide on the inflection circle. The tangent of the \
     ray of C is linear in that of the ray of D; the two are made equal.",
    build_double,
    [
        "alpha_a": "ray of the Burmester point A",
        "alpha_b": "ray of the Burmester point B",
        "alpha_d": "ray of the Burmester points C and D, modulo 180 deg",
        "PA": "from the pole to A, along its ray",
        "PB": "from the pole to B, along its ray",
        "PO_a": "from the pole to the center of the path of A, along the ray",
        "PO_b": "from the pole to the center of the path of B, along the ray",
        "O_aA": "from the center of the path of A to A, along the ray",
        "O_bB": "from the center of the path of B to B, along the ray",
        "V": "tan alpha_a + tan alpha_b",
        "W": "tan alpha_a tan alpha_b",
    ]
);

/// The motion whose Burmester point on a ray is on the inflection circle: a₃ and b₃ are such that the
/// path of that point has contact of order three with a line, L = 0 on its ray.
pub(super) fn motion_with<K: Kind>(a: &Point<K>, b: &Point<K>, d: &Point<K>) -> Invariants<K> {
    let third = Number::complex(-d.im(), d.re().clone());
    with_burmester_rays([a, b, d], &third, true)
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let angles = [
        free.slope("alpha_a")?,
        free.slope("alpha_b")?,
        free.slope("alpha_d")?,
    ];
    let [a, b, d] = angles.each_ref().map(Angle::direction);
    let invariants = motion_with(a, b, d);
    let tangent = fourth_tangent(&invariants, [a, b, d]);
    let alpha_c = angle_of_tangent(free, "1/cos alpha_c", &tangent)?;
    let [alpha_a, alpha_b, alpha_d] = &angles;
    let motion = invariants.motion();
    let pairs = [
        ("a", alpha_a, pair_on_ray(&invariants, a)),
        ("b", alpha_b, pair_on_ray(&invariants, b)),
        ("c", &alpha_c, pair_on_ray(&invariants, alpha_c.direction())),
        ("d", alpha_d, inflection_point(d)),
    ];
    unless_contact(&motion, pairs.iter().map(|(_, _, pair)| pair))?;
    let mut bindings = Bindings::new(free.precision());
    for (name, angle, pair) in &pairs {
        let upper = name.to_uppercase();
        bindings.bind(&format!("alpha_{name}"), (*angle).clone());
        bindings.bind(&format!("P{upper}"), pair.to_point(angle));
        bindings.bind(&upper, pair.point.clone());
        if pair.center.is_some() {
            bindings.bind(&format!("PO_{name}"), pair.to_center(angle));
        }
    }
    let [(_, _, first), _, (_, _, third), _] = &pairs;
    bindings.bind("r_c", third.to_point(&alpha_c));
    bindings.bind("k", first.to_center(alpha_a) / alpha_a.sin());
    bindings.bind("K_b", alpha_b.tan() - alpha_d.tan());
    bindings.bind("K_c", &tangent - alpha_d.tan());
    bind_sum_and_product(&mut bindings, alpha_a, alpha_b);
    Constants::of(&motion)?.bind(&mut bindings);
    Ok(bindings)
}

/// Two Burmester points A, B where the two others coincide on the inflection circle.
pub(super) struct DoublePoint<K> {
    pub alpha_a: Angle<K>,
    pub alpha_b: Angle<K>,
    /// Of the ray of C and D.
    pub tangent: Number<K>,
    /// A and B with their centers.
    pub pairs: [Pair<K>; 2],
}

pub(super) fn double_point<K: Real>(free: &mut dyn Free<K>) -> Result<DoublePoint<K>, Unbuilt> {
    let (alpha_a, alpha_b) = (free.slope("alpha_a")?, free.slope("alpha_b")?);
    let (a, b) = (alpha_a.direction(), alpha_b.direction());
    let direction = |tan: &Number<K>| Number::complex(Number::one(), tan.clone());
    let fourth = |tan: &Number<K>| {
        let d = direction(tan);
        fourth_tangent(&motion_with(a, b, &d), [a, b, &d])
    };
    let (zero, one) = (fourth(&Number::zero()), fourth(&Number::one()));
    // zero + (one − zero) t = t
    let tangent = &zero / (1 + &zero - one);
    unless_true::<K>(|| fourth(&tangent).equals(&tangent), "C and D coincide")?;
    let d = direction(&tangent);
    let invariants = motion_with(a, b, &d);
    let pairs = [a, b].map(|ray| pair_on_ray(&invariants, ray));
    let output = inflection_point(&d);
    unless_contact(&invariants.motion(), pairs.iter().chain([&output]))?;
    Ok(DoublePoint {
        alpha_a,
        alpha_b,
        tangent,
        pairs,
    })
}

fn build_double<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let DoublePoint {
        alpha_a,
        alpha_b,
        tangent,
        pairs: [first, second],
    } = double_point(free)?;
    let mut bindings = Bindings::new(free.precision());
    for (name, angle, pair) in [("a", &alpha_a, first), ("b", &alpha_b, second)] {
        let upper = name.to_uppercase();
        let (point, center) = (pair.to_point(angle), pair.to_center(angle));
        bindings.bind(&format!("O_{name}{upper}"), &point - &center);
        bindings.bind(&format!("P{upper}"), point);
        bindings.bind(&format!("PO_{name}"), center);
    }
    bind_sum_and_product(&mut bindings, &alpha_a, &alpha_b);
    bindings.bind("alpha_d", Angle::from_tan(tangent));
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    Ok(bindings)
}

fn bind_sum_and_product<K: Real>(bindings: &mut Bindings<K>, a: &Angle<K>, b: &Angle<K>) {
    bindings.bind("V", a.tan() + b.tan());
    bindings.bind("W", a.tan() * b.tan());
}
