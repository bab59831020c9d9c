//! The field `stretches` of `centerpoint-curve`: where on the curve all wishes are fulfilled.

use serde_json::{Map, Value, json};

use super::curve_wishes::Wished;
use super::positions::Given;
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, Request, output};
use crate::finite::stretches::cells::{Spot, Stretch, stretches};
use crate::finite::stretches::congruent_pencils::{CongruentPencils, Dyad};
use crate::number::Ball;
use crate::plane::projective::ProjectivePoint;

/// Adds the field to an answer. A stretch runs from one end to the other in the direction of its branch:
/// on a closed branch the line from the focus to the center turns counterclockwise, on one to infinity it
/// does so where the center is on the other side of the midline than the focus. Its end is a ball, before
/// which all wishes are fulfilled and beyond which one is not. The field is null, and named as undecided
/// with the reason, where it is not known.
pub fn extend(answer: &mut Map<String, Value>, given: &Given, wished: &Wished, request: &Request) {
    let pencils = given
        .rational()
        .ok_or("cosines and sines that are not rational")
        .and_then(|positions| {
            CongruentPencils::of(&positions)
                .map(|pencils| (positions, pencils))
                .ok_or("only of a curve without a line or a circle as a part")
        });
    let mut fields = match pencils {
        Ok((positions, pencils)) => sharpen(request.digits, |attempt| {
            let list = wished
                .bounded(attempt.bits)
                .and_then(|wishes| stretches(&positions, &pencils, &wishes));
            let shown = list.map(|list| {
                let list = list.iter().map(|one| shown(one, &pencils, attempt));
                list.collect::<Value>()
            });
            let name = "stretches (a wish is just fulfilled, or just not, all along a stretch)";
            Map::from_iter([("stretches".to_owned(), attempt.decided(name, shown))])
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
        fields.values_mut().for_each(output::into_floats);
    }
    answer.extend(fields);
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
