//! Chapter II: the slider's pin at the inflection pole.

use super::ball_burmester::motion_with;
use super::pole_frame::{Pair, angle_of_tangent, inflection_point, pair_on_ray, unless_contact};
use crate::curvature::canonical::Invariants;
use crate::curvature::osculation::inflection_circle;
use crate::formula::Bindings;
use crate::number::{Kind, Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};

pub const SCENE: Scene = scene!(
    "tesar1964/pin-at-the-inflection-pole",
    "A slider-crank whose slider's pin D is the inflection pole J, in units of the diameter of the inflection \
     circle, with the other Burmester points B and C of its coupler. The rays of A and B are free; \
     contact of order four, from the series of the paths, leaves one motion. C is on the pole normal.",
    build,
    [
        "k": "PO_a / sin alpha_a",
        "W": "tan alpha_a tan alpha_b",
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the Burmester point B",
        "alpha_c": "ray of the Burmester point C",
        "PA": "from the pole to A, along its ray",
        "PB": "from the pole to B, along its ray",
        "PC": "from the pole to C, along its ray",
        "PO_a": "from the pole to the center of the path of A",
        "PO_b": "from the pole to the center of the path of B",
        "PO_c": "from the pole to the center of the path of C",
        "PJ_c": "from the pole to the inflection circle, along the ray of C",
        "P": "pole",
        "A": "crank pin",
        "B": "Burmester point",
        "O_a": "center of the path of A",
        "O_b": "center of the path of B",
    ]
);

pub const EQUAL_CRANKS: Scene = scene!(
    "tesar1964/equal-cranks",
    "The same with the pole normal as the bisector of the rays of A and B. A is named so that the tangent of \
     its ray is positive.",
    build_equal_cranks,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the Burmester point B",
    ]
);

pub const DOUBLE: Scene = scene!(
    "tesar1964/double-point-at-the-inflection-pole",
    "The same with C at the inflection pole too: the condition for the points on the pole normal has a double \
     root there. The ray of A is free.",
    build_double,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of the crank pin A",
        "alpha_b": "ray of the Burmester point B",
        "PC": "from the pole to C, along its ray",
        "PJ": "from the pole to the inflection pole",
    ]
);

fn normal<K: Kind>() -> Point<K> {
    Number::i()
}

/// The Burmester point on the pole normal beside the inflection pole: one root of the condition is
/// σ = 0, the other one minus the linear coefficient.
fn other_on_normal<K: Real>(invariants: &Invariants<K>) -> Result<Pair<K>, Unbuilt> {
    let condition = invariants.on_pole_normal();
    Unbuilt::unless_true::<K>(
        condition.c.is_zero() & invariants.third.im().is_zero(),
        "the inflection pole is a Burmester point",
    )?;
    let sigma = -condition.b / condition.a;
    Ok(Pair {
        ray: normal(),
        point: normal::<K>().scaled(&(&sigma + 1).inverse()),
        center: sigma
            .is_zero()
            .is_no()
            .then(|| normal::<K>().scaled(&sigma.inverse())),
    })
}

struct Design<K> {
    invariants: Invariants<K>,
    a: Pair<K>,
    b: Pair<K>,
    k: Number<K>,
}

fn design<K: Real>(alpha_a: &Angle<K>, alpha_b: &Angle<K>) -> Design<K> {
    let rays = [alpha_a, alpha_b].map(Angle::direction);
    let invariants = motion_with(rays[0], rays[1], &normal());
    let [a, b] = rays.map(|ray| pair_on_ray(&invariants, ray));
    Design {
        k: a.to_center(alpha_a) / alpha_a.sin(),
        invariants,
        a,
        b,
    }
}

fn build<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (alpha_a, alpha_b) = (free.angle("alpha_a")?, free.angle("alpha_b")?);
    let Design {
        invariants,
        a,
        b,
        k,
    } = design(&alpha_a, &alpha_b);
    let c = other_on_normal(&invariants)?;
    let motion = invariants.motion();
    let d = inflection_point(&normal());
    unless_contact(&motion, [&a, &b, &c, &d])?;
    let circle = inflection_circle(&motion);
    let on_ray_of_c = -(&circle.b * c.ray.re() + &circle.c * c.ray.im()) / &circle.a;
    let mut bindings = Bindings::new(free.precision());
    let alpha_c = Angle::from_cos_sin(c.ray.re().clone(), c.ray.im().clone());
    for (name, angle, pair) in [
        ("a", &alpha_a, &a),
        ("b", &alpha_b, &b),
        ("c", &alpha_c, &c),
    ] {
        let upper = name.to_uppercase();
        let center = pair.to_center(angle);
        bindings.bind(&format!("alpha_{name}"), angle.clone());
        bindings.bind(&format!("P{upper}"), pair.to_point(angle));
        if name != "c" {
            bindings.bind(&upper, pair.point.clone());
            bindings.bind(&format!("O_{name}"), angle.cis().scaled(&center));
        }
        bindings.bind(&format!("PO_{name}"), center);
    }
    bindings.bind("PJ_c", on_ray_of_c);
    bindings.bind("P", Point::<K>::zero());
    bindings.bind("k", k);
    bindings.bind("W", alpha_a.tan() * alpha_b.tan());
    Ok(bindings)
}

fn build_equal_cranks<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let tan = free.length("tan alpha_a")?;
    let alpha_a = angle_of_tangent(free, "1/cos alpha_a", &tan)?;
    let alpha_b = Angle::of_known_length(
        -alpha_a.direction().conj(),
        alpha_a.direction().re() / alpha_a.cos(),
    );
    let Design {
        invariants,
        a,
        b,
        k,
    } = design(&alpha_a, &alpha_b);
    let motion = invariants.motion();
    unless_contact(&motion, [&a, &b, &inflection_point(&normal())])?;
    let squares = [a, b].map(|pair| pair.center.map(|center| (pair.point - center).norm()));
    let [Some(first), Some(second)] = squares else {
        return Err(Unbuilt::NotReal("a center is at infinity".to_owned()));
    };
    Unbuilt::unless_true::<K>(first.equals(&second), "the cranks are equal")?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("k", k);
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    Ok(bindings)
}

fn build_double<K: Real>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let alpha_a = free.angle("alpha_a")?;
    let ray = alpha_a.cis();
    // Both roots are 0 for b₄ = −1 and this a₃; the condition of A is linear in a₄.
    let third: Point<K> = Number::<K>::ratio(-3, 4).into();
    let with = |a4: Number<K>| Invariants {
        third: third.clone(),
        fourth: Number::complex(a4, Number::from(-1)),
    };
    let excess = |a4: i64| {
        let invariants = with(a4.into());
        let pair = pair_on_ray(&invariants, &ray);
        pair.guide().along(&invariants.motion()).coefficient(4)
    };
    let (zero, one) = (excess(0), excess(1));
    let invariants = with(&zero / (&zero - one));
    let a = pair_on_ray(&invariants, &ray);
    let c = other_on_normal(&invariants)?;
    // Two of the rays are the pole normal; the two others have tangents with this product.
    let [absolute, _, leading, ..] = invariants.burmester_rays();
    let tan_b = absolute / leading / alpha_a.tan();
    let b = pair_on_ray(&invariants, &Number::complex(Number::one(), tan_b.clone()));
    unless_contact(&invariants.motion(), [&a, &b, &c])?;
    let mut bindings = Bindings::new(free.precision());
    bindings.bind("k", a.to_center(&alpha_a) / alpha_a.sin());
    let upwards = Angle::of_known_length(normal(), Number::one());
    bindings.bind("PC", c.to_point(&upwards));
    bindings.bind("PJ", inflection_point::<K>(&normal()).to_point(&upwards));
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", Angle::from_tan(tan_b));
    Ok(bindings)
}
