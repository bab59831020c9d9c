//! `curvature`: one position of a motion: pole, inflection circle, cubic of stationary curvature and
//! Burmester points.

use serde_json::{Map, Value, json};

use super::found::Found;
use super::known::Known;
use super::undecided;
use super::writer::Writer;
use crate::curvature::canonical::{Canonical, Invariants, fixed_polode, moving_polode};
use crate::curvature::closure;
use crate::curvature::contact::{Contact, Guide};
use crate::curvature::mixed::{Groups, pairs};
use crate::curvature::motion::{Motion, coefficient};
use crate::curvature::osculation::{
    center_of_curvature, cubic_of_centers, inflection_circle, stationary_cubic,
};
use crate::finite::five_positions::conics::Pairs;
use crate::number::{Ball, Exact, Number};
use crate::oracle::input::Fields;
use crate::oracle::output::into_floats;
use crate::oracle::positions::point;
use crate::oracle::sharpen::{Attempt, sharpen};
use crate::oracle::{Arithmetic, ProblemError, Request, centerpoint_curve};
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::projective::ProjectivePoint;

/// What five infinitesimally separated positions need.
const ORDER: usize = 4;
/// Up to which the contact of a point of the coupler is told.
const CONTACT: usize = 10;

/// A motion about one of its positions.
struct Given {
    /// To terms in t⁴.
    motion: Motion<Exact>,
    /// To as many as are known.
    longer: Motion<Exact>,
    /// Points of the moving plane of which more is asked.
    points: Vec<Point<Exact>>,
}

/// Reads and solves the problem. All but the Burmester pairs is rational.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["links", "invariants", "points"])?;
    let given = Given::read(fields)?;
    let groups = Groups(vec![given.motion.clone()]);
    let found = pairs(&groups);
    let mut answer = sharpen(request.digits, |attempt| {
        let mut answer = given.frame(attempt);
        answer.extend(burmester_pairs(&groups, found.as_ref(), attempt));
        answer
    });
    if request.arithmetic == Arithmetic::Float {
        answer.remove("certificate");
        answer.values_mut().for_each(into_floats);
    }
    Ok(answer)
}

/// The fields of five positions but for the linkages, which are asked for in several positions.
fn burmester_pairs(
    groups: &Groups<Exact>,
    pairs: Option<&Pairs>,
    attempt: &mut Attempt,
) -> Map<String, Value> {
    let bits = attempt.bits;
    let found = Found::exact(&groups.conditions(), pairs, &Known::new(), bits);
    let mut answer = match found.filter(|found| !found.is_undecided()) {
        None => undecided(attempt),
        Some(found) => {
            let ball = |x: &Number<Exact>| {
                Number::<Ball>::from(x.0.rational().cloned().unwrap_or_default())
            };
            let enclosed = groups.0.iter().map(|motion| motion.map(|x| x.map(ball)));
            let enclosed = Groups(enclosed.collect());
            let writer = Writer {
                attempt,
                positions: Vec::new(),
                conditions: enclosed,
                exact: None,
                wishes: None,
            };
            writer.answer(&found)
        }
    };
    answer.remove("linkages");
    answer
}

impl Given {
    fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        let points = fields.optional_points("points")?;
        let points = points.iter().map(point).collect();
        if fields.has("invariants") {
            if fields.has("links") {
                return Err(fields.error("links", "either two links or the invariants, not both"));
            }
            let motion = invariants(&fields.object("invariants")?)?;
            return Ok(Given {
                longer: motion.clone(),
                motion,
                points,
            });
        }
        let list = fields.list("links")?;
        let guides: Vec<Guide<Exact>> = list
            .iter()
            .enumerate()
            .map(|(place, value)| guide(value, &format!("links[{place}]")))
            .collect::<Result<_, _>>()?;
        let guides: [Guide<Exact>; 2] = guides.try_into().map_err(|list: Vec<_>| {
            fields.error(
                "links",
                format!("two links were expected, not {}", list.len()),
            )
        })?;
        let expanded = |order| {
            closure::motion(&guides, order).ok_or_else(|| {
                fields.error(
                    "links",
                    "the motion is not determined here: a change point, or two links that are one",
                )
            })
        };
        Ok(Given {
            motion: expanded(ORDER)?,
            longer: expanded(CONTACT)?,
            points,
        })
    }

    fn frame(&self, attempt: &mut Attempt) -> Map<String, Value> {
        let motion = &self.motion;
        let canonical = Canonical::of(motion).filter(|canonical| canonical.diameter.has_value());
        let mut answer = Map::new();
        let mut add = |name: &str, value: Value| {
            answer.insert(name.to_owned(), value);
        };
        add("pole", pole(motion, attempt));
        let circle = inflection_circle(motion);
        let circle = [circle.a, circle.b, circle.c, circle.d];
        add(
            "inflection_circle",
            attempt.coefficients("inflection_circle", &circle),
        );
        let turning = canonical.as_ref();
        add(
            "inflection_pole",
            turning.map_or(Value::Null, |canonical| {
                attempt.finite_point("inflection_pole", &canonical.inflection_pole())
            }),
        );
        let proper = turning.filter(|canonical| canonical.diameter.is_zero().is_no());
        add(
            "invariants",
            proper.map_or(Value::Null, |canonical| {
                let Invariants { third, fourth } = &canonical.invariants;
                json!({
                    "third": attempt.finite_point("invariants", third),
                    "fourth": attempt.finite_point("invariants", fourth),
                })
            }),
        );
        add(
            "ball_point",
            proper.map_or(Value::Null, |canonical| {
                let [x, y, w] = canonical.invariants.ball_point().coordinates().clone();
                if w.is_zero().is_yes() {
                    return json!({"undetermined": true});
                }
                let place = canonical.place(&Number::complex(x / &w, y / w));
                attempt.finite_point("ball_point", &place)
            }),
        );
        let counts = proper.map(|canonical| ball_burmester(&canonical.invariants, attempt));
        add("ball_burmester", counts.unwrap_or(Value::Null));
        let centers = [fixed_polode(motion), moving_polode(motion)].map(|polode| {
            let center = center_of_curvature(&polode);
            if proper.is_some() {
                attempt.point("polodes", &center)
            } else {
                Value::Null
            }
        });
        let [fixed, moving] = centers;
        add("polodes", json!({"fixed": fixed, "moving": moving}));
        add(
            "circlepoint",
            curve("circlepoint", stationary_cubic(motion), attempt),
        );
        add(
            "centerpoint",
            curve("centerpoint", cubic_of_centers(motion), attempt),
        );
        let points = self.points.iter().map(|point| self.point(point, attempt));
        let points: Vec<Value> = points.collect();
        if !points.is_empty() {
            add("points", json!(points));
        }
        answer
    }

    /// How the path of a point touches its tangent and its circle.
    fn point(&self, point: &Point<Exact>, attempt: &mut Attempt) -> Value {
        let path = self.longer.path_of(point);
        let center = center_of_curvature(&path);
        let contact = |guide: Option<Guide<Exact>>| {
            guide.map_or(Value::Null, |guide| shown(guide.contact(&self.longer)))
        };
        let velocity = coefficient(&path, 1);
        let tangent = velocity.is_zero().is_no().then(|| Guide::Line {
            point: point.clone(),
            normal: Number::i() * &velocity,
        });
        let circle = center.finite().map(|center| Guide::Circle {
            point: point.clone(),
            center,
        });
        json!({
            "point": attempt.finite_point("points", point),
            "center": attempt.point("points", &center),
            "contact": {"tangent": contact(tangent), "circle": contact(circle)},
        })
    }
}

/// How often Ball's point is a Burmester point, in words; null where it is not determined.
fn ball_burmester(invariants: &Invariants<Exact>, attempt: &mut Attempt) -> Value {
    if invariants.third.is_zero().is_yes() {
        return Value::Null;
    }
    let words = ["none", "burmester", "double-burmester", "triple-burmester"];
    let counts = invariants.ball_burmester_multiplicity();
    let word = counts.and_then(|counts| words.get(counts));
    attempt.decided("ball_burmester", word.map(|word| json!(word)))
}

/// An order of contact: a number, or that it is so many at least.
fn shown(contact: Contact) -> Value {
    match contact.most {
        Some(most) if most == contact.least => json!(most),
        _ => json!({"at_least": contact.least}),
    }
}

/// The point without velocity.
fn pole(motion: &Motion<Exact>, attempt: &mut Attempt) -> Value {
    let term = |of| coefficient(of, 1);
    let (turn, shift) = (term(&motion.rotation), term(&motion.translation));
    let spin = turn.im();
    // iωz + v = 0.
    let pole = ProjectivePoint::new(-shift.im(), shift.re().clone(), spin.clone());
    attempt.point("pole", &pole)
}

fn curve(name: &str, cubic: Option<Cubic<Exact>>, attempt: &mut Attempt) -> Value {
    cubic.map_or(Value::Null, |cubic| {
        Value::Object(centerpoint_curve::curve(name, &cubic, attempt))
    })
}

fn invariants(fields: &Fields<'_>) -> Result<Motion<Exact>, ProblemError> {
    fields.only(&["third", "fourth"])?;
    let invariants = Invariants {
        third: point(&fields.point("third")?),
        fourth: point(&fields.point("fourth")?),
    };
    Ok(invariants.motion())
}

/// A link by its circlepoint, where it is, and its center; one of them may be at infinity.
fn guide(value: &Value, place: &str) -> Result<Guide<Exact>, ProblemError> {
    let fields = Fields::at(value, place)?;
    fields.only(&["circlepoint", "center"])?;
    let infinite = |name: &str| -> Result<Option<Point<Exact>>, ProblemError> {
        if !fields.get(name)?.is_object() {
            return Ok(None);
        }
        let direction = fields.object(name)?;
        direction.only(&["at_infinity"])?;
        let direction: Point<Exact> = point(&direction.point("at_infinity")?);
        if direction.is_zero().is_yes() {
            return Err(fields.error(name, "a direction that is not zero was expected"));
        }
        Ok(Some(direction))
    };
    let finite = |name: &str| Ok(point(&fields.point(name)?));
    match (infinite("circlepoint")?, infinite("center")?) {
        (None, None) => {
            let (at, center): (Point<Exact>, Point<Exact>) =
                (finite("circlepoint")?, finite("center")?);
            if at.equals(&center).is_yes() {
                return Err(fields.error("center", "the link has no length"));
            }
            Ok(Guide::Circle { point: at, center })
        }
        (None, Some(normal)) => Ok(Guide::Line {
            point: finite("circlepoint")?,
            normal,
        }),
        (Some(normal), None) => Ok(Guide::MovingLine {
            center: finite("center")?,
            normal,
        }),
        (Some(_), Some(_)) => Err(fields.error("center", "only one of the two may be at infinity")),
    }
}
