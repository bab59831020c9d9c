//! The field `stretches` of `centerpoint-curve`: where on the curve all wishes are fulfilled.

use serde_json::{Map, Value, json};

use super::positions::Given;
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, Request, output};
use crate::finite::positions::Positions;
use crate::finite::stretches::cells::{Spot, Stretch, stretches};
use crate::finite::stretches::congruent_pencils::{CongruentPencils, Dyad};
use crate::finite::stretches::wishes::Wishes;
use crate::number::{Ball, Exact};
use crate::plane::projective::ProjectivePoint;

/// Adds the field to an answer. A stretch runs from one end to the other in the direction of its branch:
/// on a closed branch the line from the focus to the center turns counterclockwise, on one to infinity it
/// does so where the center is on the other side of the midline than the focus. The field is null, and named as undecided with the reason, where it is not known.
pub fn extend(answer: &mut Map<String, Value>, given: &Given, wishes: &Wishes, request: &Request) {
    let found = given
        .rational()
        .ok_or("cosines and sines that are not rational")
        .and_then(|positions| decided(&positions, wishes));
    let mut fields = match found {
        Ok((pencils, list)) => sharpen(request.digits, |attempt| {
            let shown = list.iter().map(|one| shown(one, &pencils, attempt));
            Map::from_iter([("stretches".to_owned(), shown.collect())])
        }),
        Err(reason) => Map::from_iter([
            ("stretches".to_owned(), Value::Null),
            (
                "undecided".to_owned(),
                json!(format!("stretches ({reason})")),
            ),
        ]),
    };
    if let (Some(Value::String(before)), Some(Value::String(new))) =
        (answer.get("undecided"), fields.get_mut("undecided"))
    {
        *new = format!("{before}, {new}");
    }
    if request.arithmetic == Arithmetic::Float {
        fields.values_mut().for_each(to_floats);
    }
    answer.extend(fields);
}

fn decided(
    positions: &Positions<Exact>,
    wishes: &Wishes,
) -> Result<(CongruentPencils, Vec<Stretch>), &'static str> {
    let pencils = CongruentPencils::of(positions)
        .ok_or("only of a curve without a line or a circle as a part")?;
    let list = stretches(positions, &pencils, wishes)
        .ok_or("a wish is just fulfilled, or just not, all along a stretch")?;
    Ok((pencils, list))
}

fn shown(stretch: &Stretch, pencils: &CongruentPencils, attempt: &mut Attempt) -> Value {
    let mut place = |spot: &Spot| {
        let Dyad {
            center,
            circlepoint,
        } = spot.pair(pencils, attempt.bits);
        [
            point(attempt, "stretches.center", &center),
            point(attempt, "stretches.circlepoint", &circlepoint),
        ]
    };
    let [center, circlepoint] = place(&stretch.sample);
    let [from, to] = match &stretch.ends {
        Some(ends) => ends.each_ref().map(place),
        None => [(); 2].map(|()| [Value::Null, Value::Null]),
    };
    json!({
        "branch": stretch.branch,
        "closed": stretch.ends.is_none(),
        "from": from[0],
        "to": to[0],
        "circlepoint_from": from[1],
        "circlepoint_to": to[1],
        "sample": {"center": center, "circlepoint": circlepoint},
    })
}

fn point(attempt: &mut Attempt, name: &str, point: &ProjectivePoint<Ball>) -> Value {
    attempt.point(name, point)
}

/// All numbers as floats.
fn to_floats(value: &mut Value) {
    if let Some(number) = output::as_float(value) {
        *value = output::float(number);
        return;
    }
    match value {
        Value::Array(list) => list.iter_mut().for_each(to_floats),
        Value::Object(fields) => fields.values_mut().for_each(to_floats),
        _ => {}
    }
}
