//! Watt's linkages.

use super::figure;
use super::results::{COARSE, Listed, Output, bind, with_arcs};
use crate::formula::Bindings;
use crate::number::{Ball, Elementary, Number, Real};
use crate::plane::Angle;
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::deviation::stepped::Rule;
use crate::straight_line::watt::Watt;

pub const SCENE: Scene = figure!(
    "tesar1964/watt-figure",
    "Watt's linkage in the position in which both cranks are at right angles to the coupler, to opposite \
     sides of it, with the coupler's length as unit before all is divided by the unit length. D is the \
     point of the coupler with contact of order two at least. The program for it knows no reversal.",
    build_certified,
    build,
    [
        "r": "length of the crank O_aA in lengths of the coupler",
        "t": "length of the crank O_bB in lengths of the coupler",
    ]
);

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    Ok(list(free)?.0)
}

fn build_certified(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    with_arcs(list(free)?, COARSE)
}

fn list<K: Elementary>(free: &mut dyn Free<K>) -> Result<Listed<K>, Unbuilt> {
    let (r, t) = (free.length("r")?, free.length("t")?);
    let upright = Angle::from_cos_sin(Number::zero(), Number::one());
    let design = upon(&r, &t, &upright)
        .design()
        .map_err(|reason| Unbuilt::NotReal(reason.to_string()))?;
    let mut bindings = Bindings::new(free.precision());
    bind(
        &design,
        Output::OnLine,
        COARSE,
        Rule::Closure,
        &mut bindings,
    )?;
    bindings.bind("r", r);
    bindings.bind("t", t);
    Ok((bindings, design))
}

/// The linkage with crossed cranks at this angle with the coupler, and with D on it.
pub(super) fn upon<K: Real>(r: &Number<K>, t: &Number<K>, gamma: &Angle<K>) -> Watt<K> {
    Watt {
        r: r.clone(),
        t: t.clone(),
        gamma: gamma.clone(),
        n: 1,
        k: Number::zero(),
    }
}
