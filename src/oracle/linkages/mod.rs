//! What a designer asks of every two pairs: the linkage that they make.

mod dyad;
mod facts;
pub mod words;

use serde_json::{Value, json};

pub use dyad::Dyad;
pub use facts::{Driven, Facts};

use super::numeral::Numeral;
use super::sharpen::Attempt;
use crate::number::{Ball, Exact, Number};
use crate::plane::displacement::Displacement;

/// The linkage of two dyads.
pub struct Linkage<'a> {
    /// The dyads.
    pub dyads: [&'a Dyad; 2],
    /// What is known of it.
    pub facts: Facts,
}

/// The linkages of every two dyads, in positions that may be known exactly.
pub fn all<'a>(
    dyads: &'a [Dyad],
    exact: Option<&[Displacement<Exact>]>,
    positions: &[Displacement<Ball>],
    bits: u32,
) -> Vec<Linkage<'a>> {
    let mut list = Vec::new();
    for (i, first) in dyads.iter().enumerate() {
        for second in dyads.iter().skip(i + 1) {
            let dyads = [first, second];
            let in_balls = || Facts::of(&dyad::in_balls(dyads, positions, bits));
            let facts = match exact.and_then(|exact| dyad::exactly(dyads, exact)) {
                Some(passage) => Facts::of(&passage).or(in_balls),
                None => in_balls(),
            };
            list.push(Linkage { dyads, facts });
        }
    }
    list
}

impl Linkage<'_> {
    /// As it goes out.
    pub fn written(&self, attempt: &mut Attempt) -> Value {
        let facts = &self.facts;
        // Nothing can be asked of joints that coincide, so that nothing is undecided there.
        let known = |attempt: &mut Attempt, name: &str, value: Option<Value>| {
            if facts.is_no_mechanism() {
                Value::Null
            } else {
                attempt.decided(name, value)
            }
        };
        let both = |attempt: &mut Attempt, of: &dyn Fn(&mut Attempt, &Driven) -> Value| {
            let [first, second] = facts.drives.each_ref().map(|driven| of(attempt, driven));
            json!({"first": first, "second": second})
        };
        let kind = facts.link_type.map(|kind| json!(words::name(kind)));
        let circuit = facts
            .circuit
            .as_deref()
            .map(|reached| json!(facts::all(reached)));
        if facts.degenerate.is_none() {
            attempt.decided("linkages.defects", None);
        }
        json!({
            "pairs": self.dyads.map(|dyad| &dyad.name),
            "type": known(attempt, "linkages.type", kind),
            "crank": both(attempt, &|attempt, driven| {
                known(attempt, "linkages.crank", driven.crank.map(Value::from))
            }),
            "order": both(attempt, &|attempt, driven| {
                let order = driven.order.as_ref().map(|order| json!(order.as_deref().map(numbered)));
                known(attempt, "linkages.order", order)
            }),
            "branch": both(attempt, &|attempt, driven| {
                known(attempt, "linkages.branch", driven.reaches_all().map(Value::from))
            }),
            "circuit": known(attempt, "linkages.circuit", circuit),
            "transmission": both(attempt, &|attempt, driven| match &driven.transmission {
                Some(Some(cosines)) => transmission(attempt, cosines),
                Some(None) => Value::Null,
                None => known(attempt, "linkages.transmission", None),
            }),
            "defects": words::defects(facts),
        })
    }
}

/// Positions are counted from 1.
fn numbered(order: &[usize]) -> Vec<usize> {
    order.iter().map(|place| place + 1).collect()
}

/// The range of the transmission angle by its cosines, and how far it comes from 90°.
fn transmission(attempt: &mut Attempt, cosines: &[Numeral; 2]) -> Value {
    let [greatest, least] = cosines;
    let [below, above] = [greatest.ball(attempt.bits), -least.ball(attempt.bits)];
    let worst = match below.compare(&above) {
        Some(std::cmp::Ordering::Less) => above,
        Some(_) => below,
        None => (&below + &above + (&below - &above).abs()) / 2,
    };
    json!({
        "least": degrees(attempt, greatest, Number::acos, 90),
        "greatest": degrees(attempt, least, Number::acos, 90),
        "deviation": degrees(attempt, &Numeral::Enclosed(worst), Number::asin, 0),
    })
}

/// The angle of a cosine or sine, that of 0 known.
fn degrees(
    attempt: &mut Attempt,
    of: &Numeral,
    inverse: fn(Number<Ball>) -> Number<Ball>,
    of_zero: i64,
) -> Value {
    let angle = if of.rational().is_some_and(|q| q.is_zero()) {
        Numeral::Enclosed(of_zero.into())
    } else {
        let rounded = Number(of.ball(attempt.bits).0.with_precision(attempt.bits));
        Numeral::Enclosed(inverse(rounded) * 180 / Number::pi(&attempt.bits))
    };
    attempt.numeral("linkages.transmission", &angle)
}
