//! Where the deviation passes one of the three accuracies.

use super::listing::Listing;
use super::truth;
use crate::formula::Bindings;
use crate::number::{Ball, Elementary, Number};
use crate::scenes::scene::scene;
use crate::scenes::{Free, Scene, Unbuilt};
use crate::straight_line::deviation::arc::Arcs;
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::deviation::stepped::{Record, Rule, records};

pub const SCENE: Scene = scene!(
    "tesar1964/program-level",
    "The part of the path of D that keeps within an accuracy: as the program has it in steps of one degree \
     of the crank (lines 107 to 236 of its listing) and, with e, the exact arc. L is the end towards which \
     the crank turns forwards, R the other one. Lengths are divided by the unit length, angles are in \
     degrees and measured from the design position.",
    build_certified,
    machine: 8,
    build,
    [
        "alpha_a": "ray of A in degrees",
        "alpha_b": "ray of B in degrees",
        "level": "1, 2 or 3: the accuracies 0.0001, 0.01, 0.05",
        "length": "travel from one end to the other",
        "d_L": "size of the deviation at the end L",
        "d_R": "size of the deviation at the end R",
        "phi_L": "turn of the crank O_a A to the end L",
        "phi_R": "turn of the crank O_a A to the end R",
        "psi_L": "turn of the crank O_b B to the end L",
        "psi_R": "turn of the crank O_b B to the end R",
        "gamma_aL": "acute angle at A at the end L",
        "gamma_aR": "acute angle at A at the end R",
        "gamma_bL": "acute angle at B at the end L",
        "gamma_bR": "acute angle at B at the end R",
        "length_e": "exact length",
        "d_Le": "exact size of the deviation at the end L",
        "d_Re": "exact size of the deviation at the end R",
        "phi_Le": "exact turn of the crank O_a A to the end L",
        "phi_Re": "exact turn of the crank O_a A to the end R",
        "psi_Le": "exact turn of the crank O_b B to the end L",
        "psi_Re": "exact turn of the crank O_b B to the end R",
        "gamma_aLe": "exact acute angle at A at the end L",
        "gamma_aRe": "exact acute angle at A at the end R",
        "gamma_bLe": "exact acute angle at B at the end L",
        "gamma_bRe": "exact acute angle at B at the end R",
    ]
);

/// Lines 160, 165, 169.
fn accuracies<K: Elementary>() -> [Number<K>; 3] {
    [(1, 10_000), (1, 100), (5, 100)].map(|(p, q)| Number::ratio(p, q))
}

/// Up to the accuracy that is asked for.
fn levels<K: Elementary>(free: &mut dyn Free<K>) -> Result<Vec<Number<K>>, Unbuilt> {
    let level = free.number("level")?;
    let count = (1_u8..=3).find(|i| level.equals(&Number::from(i64::from(*i))).is_yes());
    let count =
        count.ok_or_else(|| Unbuilt::Unfit("level".to_owned(), "is not 1, 2 or 3".to_owned()))?;
    Ok(accuracies().into_iter().take(count.into()).collect())
}

fn build<K: Elementary>(free: &mut dyn Free<K>) -> Result<Bindings<K>, Unbuilt> {
    let listing = Listing::run(free)?;
    let levels = levels(free)?;
    let mut bindings = Bindings::new(free.precision());
    for name in ["alpha_a", "alpha_b", "level"] {
        bindings.bind(name, free.number(name)?);
    }
    let end = |side: i32| -> Result<Record<K>, Unbuilt> {
        let met = |degrees: i32| listing.met(&i64::from(degrees).into());
        let found = records(met, &levels, side, Rule::Reversal);
        let last = found.and_then(|mut records| records.pop().flatten());
        last.ok_or_else(|| Unbuilt::NotHeld("the end of the rows".to_owned()))
    };
    let ends = [end(1)?, end(-1)?];
    let [forwards, backwards] = ends.each_ref().map(|end| end.row.u.abs());
    bindings.bind("length", forwards + backwards);
    for (name, end) in ["L", "R"].into_iter().zip(ends) {
        let [gamma_a, gamma_b] = end.row.gamma;
        bindings.bind(&format!("d_{name}"), end.row.v.abs());
        bindings.bind(
            &format!("phi_{name}"),
            Number::<K>::from(i64::from(end.degrees)),
        );
        bindings.bind(&format!("psi_{name}"), end.row.psi);
        bindings.bind(&format!("gamma_a{name}"), gamma_a);
        bindings.bind(&format!("gamma_b{name}"), gamma_b);
    }
    Ok(bindings)
}

fn build_certified(free: &mut dyn Free<Ball>) -> Result<Bindings<Ball>, Unbuilt> {
    let mut bindings = build(free)?;
    let undecided = || Unbuilt::NotHeld("the ends of the arc".to_owned());
    let design = truth::design(free)?;
    let unit = design.unit();
    let arcs = Driven::new(&design).map(|driven| Arcs::new(driven, free.precision()));
    let arcs = arcs.ok_or_else(undecided)?;
    let accuracy = levels(free)?.pop().ok_or_else(undecided)?;
    let [back, forth] = arcs.within(&(&unit * accuracy)).ok_or_else(undecided)?;
    let mut travels = Vec::new();
    for (name, limit) in [("L", forth), ("R", back)] {
        let position = arcs.position(&limit).ok_or_else(undecided)?;
        let [u, v] = arcs.coordinates(&position).map(|x| x / &unit);
        travels.push(u);
        for (pin, gamma) in ["a", "b"]
            .into_iter()
            .zip(arcs.transmission_angles(&position))
        {
            bindings.bind(&format!("gamma_{pin}{name}e"), gamma);
        }
        bindings.bind(&format!("d_{name}e"), v.abs());
        let psi = arcs.turn_of_rocker(&limit).ok_or_else(undecided)?;
        bindings.bind(&format!("psi_{name}e"), psi);
        bindings.bind(&format!("phi_{name}e"), limit.degrees);
    }
    if let [to, from] = travels.as_slice() {
        bindings.bind("length_e", (to - from).abs());
    }
    Ok(bindings)
}
