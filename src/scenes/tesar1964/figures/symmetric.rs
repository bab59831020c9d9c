//! Symmetric linkages.

use super::super::sense::sense;
use super::super::symmetric_linkage::central_position;
use super::figure;
use super::results::{COARSE, Listed, Output, bind, with_arcs};
use crate::formula::Bindings;
use crate::number::{Ball, Elementary, Number};
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::stepped::Rule;

pub const SCENE: Scene = figure!(
    "tesar1964/symmetric-figure",
    "A symmetric four-bar in its central position, with the coupler of length 2 before all is divided by the \
     unit length. D is on the axis of symmetry.",
    build_certified,
    build,
    [
        "a": "half the distance of the pivots, negative where O_aO_b and AB have opposite directions",
        "c": "height of the triangle ABD, positive where D is on the right of the way from A to B",
        "d": "height of the coupler above the pivots",
    ]
);

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list(free)?.0)
}

fn build_certified(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list(free)?, COARSE)
}

fn list<K: Elementary>(free: &mut dyn Free<K>) -> Result<Listed<K>, Unbuilt> {
    let half = free.length("|a|")?;
    let sense = sense(free, "sign of a")?;
    let (c, d) = (free.number("c")?, free.number("d")?);
    let design = Design {
        linkage: central_position(&half, &sense, &c, &d),
        direction: Number::one(),
    }
    .checked()
    .map_err(|reason| Unbuilt::NotReal(reason.to_string()))?;
    let mut bindings = Bindings::new(free.precision());
    bind(
        &design,
        Output::Anywhere,
        COARSE,
        Rule::Reversal,
        &mut bindings,
    )?;
    bindings.bind("a", half * sense);
    bindings.bind("c", c);
    bindings.bind("d", d);
    Ok((bindings, design))
}
