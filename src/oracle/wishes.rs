//! What a designer wishes of a linkage, and which of those found fulfil it.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::input::{Angle, Fields};
use super::linkages::{Driven, Linkage};
use super::sharpen::Attempt;
use super::{ProblemError, regions};
use crate::linkage::passage::{Joint, Type, is_in_order};
use crate::number::{Ball, Number, Truth};
use crate::plane::region::Region;

/// Wishes, each of them optional. Those that concern the drive must be fulfilled by one of the two.
pub struct Wishes {
    pivots_within: Option<Region<Ball>>,
    crank_driven: bool,
    least_transmission_angle: Option<Angle>,
    without_defects: bool,
    in_order: bool,
}

impl Wishes {
    /// Reads the field `wishes`, if there is one.
    pub fn read(fields: &Fields<'_>) -> Result<Option<Self>, ProblemError> {
        let Some(fields) = fields.optional_object("wishes")? else {
            return Ok(None);
        };
        fields.only(&[
            "pivots_within",
            "crank_driven",
            "least_transmission_angle",
            "without_defects",
            "in_order",
        ])?;
        Ok(Some(Wishes {
            pivots_within: regions::read(&fields, "pivots_within")?.map(|region| region.in_kind()),
            crank_driven: fields.flag("crank_driven")?,
            least_transmission_angle: least_angle(&fields)?,
            without_defects: fields.flag("without_defects")?,
            in_order: fields.flag("in_order")?,
        }))
    }

    /// Whether anything is wished of the drive.
    fn concern_drive(&self) -> bool {
        self.crank_driven
            || self.without_defects
            || self.in_order
            || self.least_transmission_angle.is_some()
    }

    /// Adds to each linkage as written what it fulfils; returns the ranking.
    pub fn judge(
        &self,
        attempt: &mut Attempt,
        linkages: &[Linkage<'_>],
        written: &mut [Value],
    ) -> Value {
        let mut ranked: Vec<(usize, Option<Number<Ball>>)> = Vec::new();
        let mut decided = true;
        for (place, (linkage, value)) in linkages.iter().zip(written).enumerate() {
            let judgement = self.of(linkage, attempt.bits);
            let fulfils = match judgement.fulfils {
                Truth::Unknown => None,
                truth => Some(json!(truth.is_yes())),
            };
            decided &= fulfils.is_some();
            if let Value::Object(fields) = value {
                let fulfils = attempt.decided("linkages.fulfils", fulfils);
                fields.insert("fulfils".into(), fulfils);
                fields.insert("misses".into(), json!(judgement.misses));
            }
            if judgement.fulfils.is_yes() {
                decided &= insert(&mut ranked, place, judgement.worst).is_some();
            }
        }
        let places: Vec<usize> = ranked.into_iter().map(|(place, _)| place).collect();
        attempt.decided("ranked", decided.then(|| json!(places)))
    }

    fn of(&self, linkage: &Linkage<'_>, bits: u32) -> Judgement {
        let mut misses = Vec::new();
        let mut fulfils = Truth::Yes;
        if let Some(region) = &self.pivots_within {
            let pivots = linkage.dyads.map(|dyad| dyad.center.clone());
            for (pivot, name) in pivots.iter().zip(["first", "second"]) {
                // A pivot at infinity is no place that one has to find room for.
                let Joint::At(pivot) = pivot else { continue };
                let inside = region.contains(pivot);
                if inside.is_no() {
                    misses.push(format!("the pivot of the {name} pair lies outside"));
                }
                fulfils = fulfils & inside;
            }
        }
        if linkage.facts.is_no_mechanism() && self.concern_drive() {
            misses.push("its joints coincide, so that it is no mechanism".into());
            fulfils = Truth::No;
        }
        let mut worst: Option<Number<Ball>> = None;
        let mut by_drive = Vec::new();
        let mut any = Truth::No;
        for (driven, name) in linkage.facts.drives.iter().zip(["first", "second"]) {
            let mut missing = Vec::new();
            let change_point = linkage.facts.link_type == Some(Type::ChangePoint);
            let turns_fully = driven.crank == Some(true) && !change_point;
            let truth = self.of_drive(driven, turns_fully, bits, &mut missing);
            if truth.is_yes() {
                worst = least(worst, cosine(driven, bits));
            }
            any = any | truth;
            let missing = missing.into_iter();
            by_drive.extend(missing.map(|what| format!("driven at the {name} pair, {what}")));
        }
        if self.concern_drive() && !linkage.facts.is_no_mechanism() {
            if !any.is_yes() {
                misses.extend(by_drive);
            }
            fulfils = fulfils & any;
        }
        Judgement {
            fulfils,
            misses,
            worst,
        }
    }

    /// Whether one drive fulfils all that concerns it.
    fn of_drive(
        &self,
        driven: &Driven,
        turns_fully: bool,
        bits: u32,
        missing: &mut Vec<String>,
    ) -> Truth {
        if !self.concern_drive() {
            return Truth::Yes;
        }
        let mut all = Truth::Yes;
        let mut wish = |truth: Truth, otherwise: &str| {
            if truth.is_no() {
                missing.push(otherwise.to_owned());
            }
            all = all & truth;
        };
        if self.crank_driven {
            wish(known(driven.crank), "the link does not turn fully");
        }
        let reached = known(driven.reaches_all());
        wish(reached, "not all positions are reached");
        if reached.is_yes() && self.in_order {
            let order = driven.order.as_ref();
            let in_order = order.map(|order| {
                let order = order.as_deref();
                order.is_some_and(|order| is_in_order(order, turns_fully))
            });
            wish(known(in_order), "the positions are passed in another order");
        }
        if let (Truth::Yes, Some(angle)) = (reached, &self.least_transmission_angle) {
            let most = angle.rounded::<Ball>(&bits).cos();
            let enough = match &driven.transmission {
                None => Truth::Unknown,
                Some(None) => Truth::No,
                Some(Some(cosines)) => Truth::all([
                    at_most(&cosines[0].ball(bits), &most),
                    at_most(&-cosines[1].ball(bits), &most),
                ]),
            };
            wish(enough, "the transmission angle becomes too small");
        }
        all
    }
}

/// What became of the wishes.
struct Judgement {
    fulfils: Truth,
    misses: Vec<String>,
    /// |cos| of the transmission angle where it is farthest from 90°, for the best drive.
    worst: Option<Number<Ball>>,
}

fn known(value: Option<bool>) -> Truth {
    value.map_or(Truth::Unknown, Truth::from)
}

fn at_most(x: &Number<Ball>, most: &Number<Ball>) -> Truth {
    Truth::of_sign(x.compare(most), Ordering::is_le)
}

/// |cos| of the transmission angle where it is farthest from 90°.
fn cosine(driven: &Driven, bits: u32) -> Option<Number<Ball>> {
    let cosines = driven.transmission.as_ref()?.as_ref()?;
    let (x, y) = (cosines[0].ball(bits), -cosines[1].ball(bits));
    Some((&x + &y + (x - y).abs()) / 2)
}

fn least(x: Option<Number<Ball>>, y: Option<Number<Ball>>) -> Option<Number<Ball>> {
    match (x, y) {
        (Some(x), Some(y)) => Some((&x + &y - (&x - &y).abs()) / 2),
        (x, y) => x.or(y),
    }
}

/// Into its place, the smallest cosine first, those without one last. `None` where it cannot be told.
fn insert(
    ranked: &mut Vec<(usize, Option<Number<Ball>>)>,
    place: usize,
    worst: Option<Number<Ball>>,
) -> Option<()> {
    let mut at = ranked.len();
    for (index, (_, other)) in ranked.iter().enumerate() {
        let earlier = match (&worst, other) {
            (Some(x), Some(y)) => x.compare(y)?.is_lt(),
            (Some(_), None) => true,
            (None, _) => false,
        };
        if earlier {
            at = index;
            break;
        }
    }
    ranked.insert(at, (place, worst));
    Some(())
}

/// The field `least_transmission_angle`, from 0° to 90°.
pub fn least_angle(fields: &Fields<'_>) -> Result<Option<Angle>, ProblemError> {
    let name = "least_transmission_angle";
    if !fields.has(name) {
        return Ok(None);
    }
    let angle = fields.angle(name)?;
    let turn = angle.rounded::<Ball>(&256);
    let negative = |part: Number<Ball>| part.sign().is_some_and(Ordering::is_lt);
    if negative(turn.cos()) || negative(turn.sin()) {
        return Err(fields.error(name, "an angle from 0° to 90° was expected"));
    }
    Ok(Some(angle))
}
