//! A row of the table of deviations.

use std::cmp::Ordering;

use super::listing::Listing;
use super::truth;
use crate::formula::Bindings;
use crate::number::{Ball, Elementary, Number, Series};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::deviation::stepped::Met;
use crate::straight_line::turning::path;

pub const SCENE: Scene = scene!(
    "tesar1964/program-row",
    "A row of the program's table (lines 254 to 257 of its listing): D with the crank turned by whole degrees, \
     and the derivatives of its deviation as differences of the rows before and after it, with v_u and \
     v_uu for the true derivatives. A row in which the travel has turned back is not stored: there the \
     differences meet zeros. Lengths are divided by the unit length.",
    build_certified,
    machine: 8,
    build,
    [
        "alpha_a": "ray of A in degrees",
        "alpha_b": "ray of B in degrees",
        "Z": "degrees by which the crank is turned from the design position",
        "u": "travel, positive towards the u axis of (6.4)",
        "v": "deviation",
        "velocity": "first difference",
        "acceleration": "second difference",
        "v_u": "dv/du",
        "v_uu": "d^2v/du^2",
    ]
);

fn undecided() -> Unbuilt {
    Unbuilt::NotHeld("a row of the program".to_owned())
}

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let listing = Listing::run(free)?;
    let mut bindings = Bindings::new(free.precision());
    for name in ["alpha_a", "alpha_b", "Z"] {
        bindings.bind(name, free.number(name)?);
    }
    let z = free.number("Z")?;
    let at = |z: &Number<K>| match listing.met(z) {
        Some(Met::Row(row)) => Ok([row.u, row.v]),
        _ => Err(undecided()),
    };
    let [u_0, _] = at(&Number::zero())?;
    let here = at(&z)?;
    let neighbour = |step: i64| -> Result<[Number<K>; 2], Unbuilt> {
        let [u, v] = at(&(&z + step))?;
        let [outwards, turned] = [&here[0] - &u_0, &u - &here[0]];
        let is_outside = (step * &z).is_positive().is_yes();
        let has_turned = (outwards * turned).sign().ok_or_else(undecided)? == Ordering::Less;
        Ok(match is_outside && has_turned {
            true => [Number::zero(), Number::zero()],
            false => [u - &u_0, v],
        })
    };
    let ([u_before, v_before], [u_after, v_after]) = (neighbour(-1)?, neighbour(1)?);
    let [u, v] = [&here[0] - &u_0, here[1].clone()];
    let span = &u_after - &u_before;
    let forwards = (&v_after - &v) / (&u_after - &u);
    let backwards = (&v - &v_before) / (&u - &u_before);
    bindings.bind("velocity", (v_after - v_before) / &span);
    bindings.bind("acceleration", 2 * ((forwards - backwards) / span));
    bindings.bind("u", u);
    bindings.bind("v", v);
    Ok(bindings)
}

fn build_certified(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    let mut bindings = build(free)?;
    let design = truth::design(free)?;
    let driven = Driven::new(&design).ok_or_else(undecided)?;
    let driven: Driven<Series<Ball>> = driven.map(|x| x.clone().into());
    let degrees = Number::from_coefficients([free.number("Z")?, Number::one()], 2);
    let position = driven.position(&path(&degrees, free.precision()));
    let [u, v] = driven.coordinates(&position.ok_or_else(undecided)?);
    let rate = u.derivative();
    let slope = v.derivative() / &rate;
    let unit = design.unit();
    bindings.bind("v_u", slope.coefficient(0));
    bindings.bind("v_uu", (slope.derivative() / rate).coefficient(0) * unit);
    Ok(bindings)
}
