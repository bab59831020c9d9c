//! Linkages with a Ball-Burmester point.

use super::figure;
use super::results::{FINE, Listed, Output, bind, in_degrees, not_negative, with_arcs};
use crate::formula::Bindings;
use crate::number::{Ball, Elementary};
use crate::plane::Angle;
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::ball_burmester::{
    Alternate, Cranks, at_inflection_pole, double, of_rays,
};
use crate::straight_line::deviation::stepped::Rule;
use crate::straight_line::no_design::NoDesign;

pub const FIRST: Scene = figure!(
    "tesar1964/alternate-of-a-and-b",
    "A four-bar with the Burmester points A and B as pins, A on the crank that is turned, and with the \
     Burmester point D on the inflection circle as output point.",
    certified_first,
    build_first,
    [
        "alpha_a": "ray of A",
        "alpha_b": "ray of B",
        "alpha_d": "ray of D",
        "alpha_c": "ray of the fourth Burmester point C, in degrees from 0 to 180",
    ]
);

pub const SECOND: Scene = figure!(
    "tesar1964/alternate-of-b-and-c",
    "The same with B and C as pins, B on the crank that is turned.",
    certified_second,
    build_second,
    [
        "alpha_a": "ray of A",
        "alpha_b": "ray of B",
        "alpha_d": "ray of D",
        "alpha_c": "ray of C, in degrees from 0 to 180",
    ]
);

pub const DOUBLE: Scene = figure!(
    "tesar1964/four-bar-with-a-double-point",
    "A four-bar with the Burmester points A and B as pins, A on the crank that is turned, and with a double \
     Burmester point D on the inflection circle as output point: A, B and D are on a line.",
    certified_double,
    build_double,
    [
        "alpha_a": "ray of A",
        "alpha_b": "ray of B",
        "alpha_d": "ray of D, in degrees from 0 to 180",
    ]
);

pub const INFLECTION_POLE: Scene = figure!(
    "tesar1964/alternate-of-c-and-a",
    "A four-bar with the inflection pole D as a Burmester point, and with the Burmester points C, on the \
     pole normal, and A as pins, C on the crank that is turned.",
    certified_at_inflection_pole,
    build_at_inflection_pole,
    [
        "k": "PO_a / sin alpha_a",
        "alpha_a": "ray of A",
        "alpha_b": "ray of the Burmester point B, in degrees from 0 to 180",
    ]
);

fn none(reason: NoDesign) -> Unbuilt {
    Unbuilt::NotReal(reason.to_string())
}

/// The angle of a ray, which is one of a line through the pole.
fn bind_ray<K: Elementary>(name: &str, ray: &Angle<K>, bindings: &mut Bindings<K>) {
    let degrees = in_degrees(ray.direction(), bindings.precision());
    bindings.bind(name, not_negative(degrees, 180));
}

fn build_first<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list_alternate(free, Alternate::First)?.0)
}

fn certified_first(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list_alternate(free, Alternate::First)?, FINE)
}

fn build_second<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list_alternate(free, Alternate::Second)?.0)
}

fn certified_second(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list_alternate(free, Alternate::Second)?, FINE)
}

fn build_double<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list_double(free)?.0)
}

fn certified_double(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list_double(free)?, FINE)
}

fn build_at_inflection_pole<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list_at_inflection_pole(free)?.0)
}

fn certified_at_inflection_pole(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list_at_inflection_pole(free)?, FINE)
}

fn list_alternate<K: Elementary>(
    free: &mut dyn Free<K>,
    alternate: Alternate,
) -> Result<Listed<K>, Unbuilt> {
    let (alpha_a, alpha_b) = (free.angle("alpha_a")?, free.angle("alpha_b")?);
    let alpha_d = free.angle("alpha_d")?;
    let cranks = of_rays(&alpha_a, &alpha_b, &alpha_d).map_err(none)?;
    let (mut bindings, design) = results(&cranks, alternate, Output::Anywhere, free)?;
    let [.., c] = &cranks.pairs;
    bind_ray("alpha_c", &c.ray, &mut bindings);
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    bindings.bind("alpha_d", alpha_d);
    Ok((bindings, design))
}

fn list_double<K: Elementary>(free: &mut dyn Free<K>) -> Result<Listed<K>, Unbuilt> {
    let (alpha_a, alpha_b) = (free.angle("alpha_a")?, free.angle("alpha_b")?);
    let cranks = double(&alpha_a, &alpha_b).map_err(none)?;
    let (mut bindings, design) = results(&cranks, Alternate::First, Output::OnLine, free)?;
    bind_ray("alpha_d", &cranks.alpha_d, &mut bindings);
    bindings.bind("alpha_a", alpha_a);
    bindings.bind("alpha_b", alpha_b);
    Ok((bindings, design))
}

fn list_at_inflection_pole<K: Elementary>(free: &mut dyn Free<K>) -> Result<Listed<K>, Unbuilt> {
    let (k, alpha_a) = (free.number("k")?, free.angle("alpha_a")?);
    let cranks = at_inflection_pole(&k, &alpha_a).map_err(none)?;
    let (mut bindings, design) = results(&cranks, Alternate::Third, Output::Anywhere, free)?;
    let [_, b, _] = &cranks.pairs;
    bind_ray("alpha_b", &b.ray, &mut bindings);
    bindings.bind("k", k);
    bindings.bind("alpha_a", alpha_a);
    Ok((bindings, design))
}

fn results<K: Elementary>(
    cranks: &Cranks<K>,
    alternate: Alternate,
    output: Output,
    free: &mut dyn Free<K>,
) -> Result<Listed<K>, Unbuilt> {
    let design = cranks.design(alternate).map_err(none)?;
    let mut bindings = Bindings::new(free.precision());
    bind(&design, output, FINE, Rule::Reversal, &mut bindings)?;
    Ok((bindings, design))
}
