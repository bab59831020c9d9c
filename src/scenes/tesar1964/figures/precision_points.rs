//! Linkages that were measured in figures.

use super::listed;
use super::results::{COARSE, Output, bind};
use crate::formula::Bindings;
use crate::linkage::cognates::CouplerPoint;
use crate::linkage::four_bar::third_corners;
use crate::number::{Elementary, Number};
use crate::plane::Point;
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::stepped::Rule;

pub const SCENE: Scene = listed!(
    "tesar1964/burmester-figure",
    "A four-bar of which the dimensions are given as they were measured, with B on the left of the way \
     from A to O_b. The line, through D in the design position, is given by its direction; D's deviation \
     from it is what counts.",
    build,
    build,
    ["theta": "direction of the line, from O_aO_b, in degrees", "U": "unit length before the division"]
);

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let (design, theta) = measured(free)?;
    let mut bindings = Bindings::new(free.precision());
    bind(
        &design,
        Output::Anywhere,
        COARSE,
        Rule::Reversal,
        &mut bindings,
    )?;
    bindings.bind("U", design.unit());
    bindings.bind("theta", theta);
    Ok(bindings)
}

/// The linkage, and the direction of its line.
pub(super) fn measured<K: Elementary>(
    free: &mut dyn Free<K>,
) -> Result<(Design<K>, Number<K>), Unbuilt> {
    let mut length = |name: &str| free.length(name);
    let (q, r, s) = (length("Q")?, length("R")?, length("S")?);
    let (t, m) = (length("T")?, length("M")?);
    let mut degrees = |name: &str| free.number(name);
    let (epsilon, phi) = (degrees("epsilon")?, degrees("phi_0")?);
    let theta = degrees("theta")?;
    let precision = free.precision();
    let o_b = Point::from(q);
    let a = direction(&phi, &precision).scaled(&r);
    let [b, _] = third_corners(&a, &o_b, &s.square(), &t.square())
        .ok_or_else(|| Unbuilt::NotReal("the linkage does not close".to_owned()))?;
    let arm = (&b - &a) * direction(&epsilon, &precision);
    let point = &a + arm.scaled(&(&m / &s));
    let design = Design {
        linkage: CouplerPoint {
            pivots: [Number::zero(), o_b],
            pins: [a, b],
            point,
        },
        direction: direction(&theta, &precision),
    }
    .checked()
    .map_err(|reason| Unbuilt::NotReal(reason.to_string()))?;
    Ok((design, theta))
}

/// e^{iα}.
fn direction<K: Elementary>(degrees: &Number<K>, precision: &K::Precision) -> Point<K> {
    let radians = degrees * Number::pi(precision) / 180;
    Number::complex(radians.clone().cos(), radians.sin())
}
