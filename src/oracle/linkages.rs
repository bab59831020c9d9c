//! What a designer asks of every two pairs: the four-bar that they make.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::sharpen::Attempt;
use crate::linkage::passage::{Drive, Passage, Type};
use crate::number::{Ball, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// The four-bars of every two real pairs, circlepoint and center each.
pub fn all(
    attempt: &mut Attempt,
    positions: &[Displacement<Ball>; 5],
    pairs: &[[Point<Ball>; 2]],
) -> Vec<Value> {
    let mut list = Vec::new();
    for (i, first) in pairs.iter().enumerate() {
        for (j, second) in pairs.iter().enumerate().skip(i + 1) {
            let place = |d: &Displacement<Ball>| [d.of(&first[0]), d.of(&second[0])];
            let passage = Passage {
                pivots: [first[1].clone(), second[1].clone()],
                joints: positions.iter().map(place).collect(),
            };
            list.push(linkage(attempt, [i, j], &passage));
        }
    }
    list
}

fn linkage(attempt: &mut Attempt, pairs: [usize; 2], passage: &Passage<Ball>) -> Value {
    let kind = passage.link_type();
    let circuits = passage.circuit();
    let both = |of: &mut dyn FnMut(Drive) -> Value| {
        let [first, second] = [Drive::First, Drive::Second].map(of);
        json!({"first": first, "second": second})
    };
    let circuit = circuits.as_deref().map(|signs| json!(all_equal(signs)));
    let branch = both(&mut |drive| {
        let value = passage
            .assembly(drive)
            .map(|signs| json!(all_equal(&signs)));
        attempt.decided("linkages.branch", value)
    });
    let order = both(&mut |drive| {
        let order = passage.order(drive);
        let numbers =
            order.map(|order| json!(order.iter().map(|place| place + 1).collect::<Vec<_>>()));
        attempt.decided("linkages.order", numbers)
    });
    let crank = both(&mut |drive| {
        let value = passage.is_crank(drive).map(|crank| json!(crank));
        attempt.decided("linkages.crank", value)
    });
    let transmission = both(&mut |drive| match passage.transmission(drive) {
        Some([least, greatest]) => json!({
            "least": degrees(attempt, &least),
            "greatest": degrees(attempt, &greatest),
        }),
        None => attempt.decided("linkages.transmission", None),
    });
    json!({
        "pairs": pairs,
        "type": attempt.decided("linkages.type", kind.map(|kind| json!(name(kind)))),
        "crank": crank,
        "order": order,
        "branch": branch,
        "circuit": attempt.decided("linkages.circuit", circuit),
        "transmission": transmission,
        "defects": defects(passage, circuits.as_deref()),
    })
}

fn name(kind: Type) -> &'static str {
    match kind {
        Type::CrankAndLever => "crank-and-lever",
        Type::DragLink => "drag-link",
        Type::GrashofDoubleLever | Type::DoubleLever => "double-lever",
        Type::ChangePoint => "change-point",
    }
}

fn all_equal(signs: &[Ordering]) -> bool {
    signs.iter().all(|sign| Some(sign) == signs.first())
}

/// Why the linkage does not pass through all positions, in words.
fn defects(passage: &Passage<Ball>, circuits: Option<&[Ordering]>) -> Vec<String> {
    let mut list = Vec::new();
    let others = |signs: &[Ordering]| -> Vec<String> {
        let differs = |(place, sign): (usize, &Ordering)| {
            (Some(sign) != signs.first()).then(|| (place + 1).to_string())
        };
        signs.iter().enumerate().filter_map(differs).collect()
    };
    let named = |places: &[String]| {
        let word = if places.len() == 1 {
            "position"
        } else {
            "positions"
        };
        format!("{word} {}", places.join(", "))
    };
    let on_other = circuits.map(others).unwrap_or_default();
    if !on_other.is_empty() {
        let verb = if on_other.len() == 1 { "needs" } else { "need" };
        list.push(format!("{} {verb} the other assembly", named(&on_other)));
        return list;
    }
    for (drive, link) in [(Drive::First, "first"), (Drive::Second, "second")] {
        let beyond = passage
            .assembly(drive)
            .map(|signs| others(&signs))
            .unwrap_or_default();
        if !beyond.is_empty() {
            list.push(format!(
                "driven at the {link} pair, {} lie beyond a dead centre",
                named(&beyond)
            ));
        }
    }
    list
}

/// The angle of a cosine.
fn degrees(attempt: &mut Attempt, cosine: &Number<Ball>) -> Value {
    let rounded = Number(cosine.0.with_precision(attempt.bits));
    let degrees = rounded.acos() * 180 / Number::pi(&attempt.bits);
    attempt.numeral(
        "linkages.transmission",
        &super::numeral::Numeral::Enclosed(degrees),
    )
}
