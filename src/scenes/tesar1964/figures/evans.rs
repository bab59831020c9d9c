//! Evans' centric rectangular linkages.

use super::super::evans::{on_edge, rolling};
use super::figure;
use super::results::{COARSE, Listed, Output, bind, with_arcs};
use crate::formula::Bindings;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Ball, Elementary, Kind, Number, Real};
use crate::plane::{Angle, Point};
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::stepped::Rule;
use crate::straight_line::no_design::NoDesign;

pub const SCENE: Scene = figure!(
    "tesar1964/evans-figure",
    "A circle of radius 1 that rolls in a circle of radius 2 about the origin, in the initial position. B \
     and D are points of its edge, and move on the U-axis and on the V-axis; A is on the line BD. O_a is \
     the point of the U-axis that is as far from A as from the place of A in the position omega = 0. O_b is \
     at the height k above B.",
    build_certified,
    build,
    [
        "omega": "direction of the center of the rolling circle",
        "rho": "from the center of the rolling circle to A, positive towards B",
        "k": "height of O_b above B",
    ]
);

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list(free)?.0)
}

fn build_certified(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list(free)?, COARSE)
}

fn list<K: Elementary>(free: &mut dyn Free<K>) -> Result<Listed<K>, Unbuilt> {
    let omega = free.angle("omega")?;
    let (rho, k) = (free.number("rho")?, free.number("k")?);
    let design = design(&omega, &rho, &k).map_err(|reason| Unbuilt::NotReal(reason.to_string()))?;
    let mut bindings = Bindings::new(free.precision());
    bind(
        &design,
        Output::OnLine,
        COARSE,
        Rule::Reversal,
        &mut bindings,
    )?;
    bindings.bind("omega", omega);
    bindings.bind("rho", rho);
    bindings.bind("k", k);
    Ok((bindings, design))
}

/// The linkage in its initial position.
pub(super) fn design<K: Real>(
    omega: &Angle<K>,
    rho: &Number<K>,
    k: &Number<K>,
) -> Result<Design<K>, NoDesign> {
    let position = rolling(omega);
    let central = rolling(&Angle::from_cos_sin(Number::one(), Number::zero()));
    let on_diameter = Point::from(rho.clone());
    let a = position.of(&on_diameter);
    let o_a = equally_far(&a, &central.of(&on_diameter));
    let b = position.of(&Number::one());
    let upright = Angle::from_cos_sin(Number::zero(), Number::one());
    Design {
        linkage: CouplerPoint {
            pivots: [o_a, &b + Point::<K>::i().scaled(k)],
            pins: [a, b],
            point: position.of(&on_edge(&upright)),
        },
        direction: upright.cis(),
    }
    .checked()
}

/// The point of the U-axis that is equally far from both.
fn equally_far<K: Kind>(z: &Point<K>, w: &Point<K>) -> Point<K> {
    ((z.norm() - w.norm()) / (2 * (z.re() - w.re()))).into()
}
