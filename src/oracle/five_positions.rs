//! `five-positions`: all Burmester pairs, with proof, and the linkages that they make.

use std::cmp::Ordering;

use rug::Rational;
use serde_json::{Map, Value, json};

use super::input::Fields;
use super::linkages::{self, Dyad};
use super::numeral::{Numeral, together};
use super::positions::Given;
use super::sharpen::{Attempt, sharpen};
use super::wishes::Wishes;
use super::{Arithmetic, ProblemError, Request};
use crate::finite::five_positions::conditions::finite_pair;
use crate::finite::five_positions::conics::{self, Isolated, Pair, Pairs, Place};
use crate::finite::five_positions::families::{self, Family};
use crate::finite::five_positions::{enclosed, krawczyk};
use crate::finite::positions::Positions;
use crate::number::exact::primitive;
use crate::number::{Ball, Complex, Exact, Number};
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::Polynomial;

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions", "wishes"])?;
    let given = Given::read(fields, 5, 5)?;
    let wishes = Wishes::read(fields)?;
    let mut answer = match request.arithmetic {
        Arithmetic::Float => of_floats(&given, wishes.as_ref(), request),
        Arithmetic::Certified => certified(&given, wishes.as_ref(), request.digits),
    };
    if let Some(angles) = given.fitted(request) {
        answer.insert("fitted_angles".into(), angles);
    }
    Ok(answer)
}

type Five<K> = [Displacement<K>; 5];

fn certified(given: &Given, wishes: Option<&Wishes>, digits: u32) -> Map<String, Value> {
    let rational = given.rational().and_then(|positions| five(&positions));
    let exact = rational.as_ref().map(|five| (five, conics::pairs(five)));
    sharpen(digits, |attempt| {
        let bits = attempt.bits;
        let positions = five(&given.rounded::<Ball>(&bits));
        let found = match (&exact, &positions) {
            (Some((five, pairs)), _) => Found::exact(five, pairs.as_ref(), bits),
            (None, Some(positions)) => Found::enclosed(positions, bits),
            (None, None) => None,
        };
        match (found, positions) {
            (Some(found), Some(positions)) => {
                let exact = rational.clone();
                let writer = Writer {
                    attempt,
                    positions,
                    exact,
                    wishes,
                };
                writer.answer(&found)
            }
            _ => undecided(attempt),
        }
    })
}

/// Floats are rational numbers: solved exactly, and rounded.
fn of_floats(given: &Given, wishes: Option<&Wishes>, request: &Request) -> Map<String, Value> {
    let mut attempt = Attempt::new(request.digits.min(15), 192);
    let floats = given.rounded::<f64>(&());
    let exact =
        |x: &Number<f64>| Number::<Exact>::from(Rational::from_f64(x.0).unwrap_or_default());
    let point = |z: &Point<f64>| Number::complex(exact(z.re()), exact(z.im()));
    let displacements = floats.displacements().iter().map(|d| Displacement {
        rotation: point(&d.rotation),
        translation: point(&d.translation),
    });
    let displacements: Vec<Displacement<Exact>> = displacements.collect();
    let Ok(five) = <Five<Exact>>::try_from(displacements) else {
        return undecided(&mut attempt);
    };
    let pairs = conics::pairs(&five);
    let ball = |z: &Point<Exact>| {
        let part =
            |x: &Number<Exact>| Number::<Ball>::from(x.0.rational().cloned().unwrap_or_default());
        Number::complex(part(z.re()), part(z.im()))
    };
    let positions = five.each_ref().map(|d| Displacement {
        rotation: ball(&d.rotation),
        translation: ball(&d.translation),
    });
    let Some(found) = Found::exact(&five, pairs.as_ref(), attempt.bits) else {
        return undecided(&mut attempt);
    };
    let mut answer = Writer {
        attempt: &mut attempt,
        positions,
        exact: Some(five.clone()),
        wishes,
    }
    .answer(&found);
    answer.remove("certificate");
    answer.values_mut().for_each(into_floats);
    answer
}

/// Certified numbers become plain ones.
fn into_floats(value: &mut Value) {
    if let Some(float) = super::output::as_float(value) {
        *value = json!(float);
        return;
    }
    match value {
        Value::Array(members) => members.iter_mut().for_each(into_floats),
        Value::Object(fields) => fields.values_mut().for_each(into_floats),
        _ => {}
    }
}

fn undecided(attempt: &mut Attempt) -> Map<String, Value> {
    let names = [
        "pairs",
        "complex_pairs",
        "at_infinity",
        "family",
        "eliminant",
        "counts",
        "linkages",
    ];
    let mut answer = Map::new();
    for name in names {
        let optional = name == "family" || name == "eliminant";
        let value = if optional {
            Value::Null
        } else {
            attempt.decided(name, None)
        };
        answer.insert(name.into(), value);
    }
    answer.insert("certificate".into(), Value::Null);
    answer
}

fn five<K: crate::number::Kind>(positions: &Positions<K>) -> Option<Five<K>> {
    positions.displacements().first_chunk().cloned()
}

/// A real pair with its coordinates h, x, y, X, Y, p, q.
struct Real {
    coordinates: [Number<Ball>; 7],
    place: Place,
    multiplicity: usize,
}

impl Real {
    fn exact(pair: &Pair<Exact>) -> Self {
        let ball =
            |x: &Number<Exact>| Number::<Ball>::from(x.0.rational().cloned().unwrap_or_default());
        Real {
            coordinates: pair.coordinates.each_ref().map(ball),
            place: pair.place,
            multiplicity: pair.multiplicity,
        }
    }

    /// The finite point of a pair whose other point is at infinity.
    fn beside_infinity(&self) -> Point<Ball> {
        let [_, x, y, cx, cy, p, q] = &self.coordinates;
        let w = Number::complex(p.clone(), q.clone());
        match self.place {
            Place::CirclepointAtInfinity => (w / Number::complex(x.clone(), y.clone())).conj(),
            _ => w / Number::complex(cx.clone(), -cy),
        }
    }
}

/// One of two conjugate pairs.
struct Couple {
    coordinates: [Number<Complex<Ball>>; 7],
    place: Place,
    multiplicity: usize,
}

/// What there is beside isolated pairs.
enum Families {
    None,
    Known(Family),
    /// Something that has no name here yet.
    Unknown,
}

/// All that was found, whatever the route.
struct Found {
    real: Vec<Real>,
    complex: Vec<Couple>,
    family: Families,
    eliminant: Option<Vec<Rational>>,
    method: &'static str,
}

impl Found {
    fn exact(five: &Five<Exact>, pairs: Option<&Pairs>, bits: u32) -> Option<Found> {
        match pairs? {
            Pairs::Isolated(isolated) => Some(Found::isolated(isolated, bits)),
            Pairs::Families(beside) => Some(Found {
                real: beside.iter().map(|pair| Real::exact(pair)).collect(),
                complex: Vec::new(),
                family: families::family(five).map_or(Families::Unknown, Families::Known),
                eliminant: None,
                method: "exact linear algebra: the conditions depend on each other, or the two conics \
                         have a part in common",
            }),
        }
    }

    fn isolated(isolated: &Isolated, bits: u32) -> Found {
        let real = isolated.real(bits).into_iter().map(|pair| Real {
            coordinates: pair.coordinates,
            place: pair.place,
            multiplicity: pair.multiplicity,
        });
        let complex = isolated.complex(bits).into_iter().map(|pair| Couple {
            coordinates: pair.coordinates,
            place: pair.place,
            multiplicity: pair.multiplicity,
        });
        let coefficients = isolated.eliminant().map(|eliminant| {
            let coefficients = eliminant.coefficients().iter().rev();
            coefficients
                .filter_map(|c| c.0.rational().cloned())
                .collect()
        });
        Found {
            real: real.collect(),
            complex: complex.collect(),
            family: Families::None,
            eliminant: coefficients,
            method: "exact eliminant of two conics, all of its four roots isolated",
        }
    }

    /// `None` where the enclosures cannot tell whether a pair is at infinity.
    fn enclosed(positions: &Five<Ball>, bits: u32) -> Option<Found> {
        let pairs = enclosed::pairs(positions, bits)?;
        let finite = |h: crate::number::Truth| h.is_no().then_some(Place::Finite);
        let real = pairs.real.into_iter().map(|coordinates| {
            Some(Real {
                place: finite(coordinates[0].is_zero())?,
                coordinates,
                multiplicity: 1,
            })
        });
        let complex = pairs.complex.into_iter().map(|coordinates| {
            Some(Couple {
                place: finite(coordinates[0].is_zero())?,
                coordinates,
                multiplicity: 1,
            })
        });
        Some(Found {
            real: real.collect::<Option<_>>()?,
            complex: complex.collect::<Option<_>>()?,
            family: Families::None,
            eliminant: None,
            method: "eliminant of two conics in enclosures, Newton's interval test for all four roots",
        })
    }
}

/// Writes what was found.
struct Writer<'a> {
    attempt: &'a mut Attempt,
    positions: Five<Ball>,
    /// The positions, where they are rational.
    exact: Option<Five<Exact>>,
    wishes: Option<&'a Wishes>,
}

impl Writer<'_> {
    fn answer(mut self, found: &Found) -> Map<String, Value> {
        let mut pairs: Vec<(&Real, [Point<Ball>; 2])> = found
            .real
            .iter()
            .filter(|pair| pair.place == Place::Finite)
            .map(|pair| (pair, finite_pair(&pair.coordinates)))
            .collect();
        pairs.sort_by(|(_, a), (_, b)| by_coordinates(&a[0], &b[0]));
        let mut answer = Map::new();
        let listed: Vec<Value> = pairs
            .iter()
            .map(|(pair, points)| self.pair(pair, points))
            .collect();
        answer.insert("pairs".into(), json!(listed));
        let complex: Vec<Value> = found
            .complex
            .iter()
            .filter(|pair| pair.place == Place::Finite)
            .flat_map(|pair| self.couple(pair))
            .collect();
        let infinite: Vec<Value> = self.at_infinity(found);
        answer.insert("complex_pairs".into(), json!(complex));
        let at_infinity = dyads_at_infinity(found, &infinite);
        answer.insert("at_infinity".into(), json!(infinite));
        let family = match &found.family {
            Families::None => Value::Null,
            Families::Known(family) => self.family(family),
            Families::Unknown => self.attempt.decided("family", None),
        };
        answer.insert("family".into(), family);
        let eliminant = found.eliminant.as_ref().map(|coefficients| {
            let integers = primitive(coefficients).into_iter();
            integers
                .map(|integer| integer.to_string())
                .collect::<Vec<_>>()
        });
        answer.insert("eliminant".into(), json!(eliminant));
        answer.insert("counts".into(), counts(found));
        let points: Vec<[Point<Ball>; 2]> =
            pairs.iter().map(|(_, points)| points.clone()).collect();
        let finite = points.iter().cloned().enumerate();
        let mut dyads: Vec<Dyad> = finite
            .map(|(place, points)| Dyad::finite(place, points))
            .collect();
        dyads.extend(at_infinity);
        let bits = self.attempt.bits;
        let linkages = linkages::all(&dyads, self.exact.as_ref(), &self.positions, bits);
        let mut written: Vec<Value> = linkages
            .iter()
            .map(|linkage| linkage.written(self.attempt))
            .collect();
        let ranked = self
            .wishes
            .map(|wishes| wishes.judge(self.attempt, &linkages, &mut written));
        answer.insert("linkages".into(), json!(written));
        answer.extend(ranked.map(|ranked| ("ranked".to_owned(), ranked)));
        answer.insert("certificate".into(), self.certificate(found, &points));
        answer
    }

    fn pair(&mut self, pair: &Real, [z, m]: &[Point<Ball>; 2]) -> Value {
        json!({
            "circlepoint": self.attempt.finite_point("pairs", z),
            "center": self.attempt.finite_point("pairs", m),
            "multiplicity": pair.multiplicity,
        })
    }

    /// Both of two conjugate pairs.
    fn couple(&mut self, pair: &Couple) -> [Value; 2] {
        let [h, x, y, cx, cy, ..] = &pair.coordinates;
        let parts = [x / h, y / h, cx / h, cy / h];
        let mut one = |conjugate: bool| {
            let parts = parts
                .each_ref()
                .map(|part| if conjugate { part.conj() } else { part.clone() });
            let [x, y, cx, cy] = parts;
            json!({
                "circlepoint": self.complex_point(&[x, y]),
                "center": self.complex_point(&[cx, cy]),
                "multiplicity": pair.multiplicity,
            })
        };
        [one(false), one(true)]
    }

    fn complex_point(&mut self, [x, y]: &[Number<Complex<Ball>>; 2]) -> Value {
        let parts = [x.re(), x.im(), y.re(), y.im()].map(|part| Numeral::Enclosed(part.clone()));
        let shown = together(&parts, self.attempt.digits, self.attempt.bits);
        let point = shown.as_deref().and_then(|list| match list {
            [a, b, c, d] => Some(json!([{"re": a, "im": b}, {"re": c, "im": d}])),
            _ => None,
        });
        self.attempt.decided("complex_pairs", point)
    }

    fn at_infinity(&mut self, found: &Found) -> Vec<Value> {
        let mut list = Vec::new();
        for pair in &found.real {
            let [_, x, y, cx, cy, ..] = &pair.coordinates;
            let value = match pair.place {
                Place::Finite => continue,
                Place::CenterAtInfinity => {
                    let z = pair.beside_infinity();
                    json!({
                        "kind": "center",
                        "circlepoint": self.attempt.finite_point("at_infinity", &z),
                        "direction": self.direction([cx, cy]),
                    })
                }
                Place::CirclepointAtInfinity => {
                    let m = pair.beside_infinity();
                    json!({
                        "kind": "circlepoint",
                        "direction": self.direction([x, y]),
                        "center": self.attempt.finite_point("at_infinity", &m),
                    })
                }
                Place::BothAtInfinity | Place::Isotropic => json!({"kind": "isotropic"}),
            };
            list.extend(std::iter::repeat_n(value, pair.multiplicity));
        }
        for pair in found
            .complex
            .iter()
            .filter(|pair| pair.place != Place::Finite)
        {
            let value = json!({"kind": "isotropic"});
            list.extend(std::iter::repeat_n(value, 2 * pair.multiplicity));
        }
        list
    }

    fn direction(&mut self, [x, y]: [&Number<Ball>; 2]) -> Value {
        let direction = self.attempt.direction(&[x.clone(), y.clone()]);
        self.attempt.decided("at_infinity", direction)
    }

    fn family(&mut self, family: &Family) -> Value {
        match family {
            Family::Empty => Value::Null,
            Family::Plane => json!({"kind": "plane"}),
            Family::PlaneOfLines(direction) => {
                let [x, y] = [direction.re(), direction.im()];
                let direction = self.attempt.direction(&[x.clone(), y.clone()]);
                json!({"kind": "plane", "center": {"at_infinity": direction}})
            }
            Family::Circlepoints(curve, center) => {
                let kind = match curve.order() {
                    1 => "line",
                    2 => "circlepoint-conic",
                    _ => "circlepoint-cubic",
                };
                let mut value = json!({"kind": kind, "coefficients": self.curve(curve)});
                if let (1, Value::Object(fields)) = (curve.order(), &mut value) {
                    let center = center.as_ref();
                    let center = center.map(|point| self.attempt.point("family", point));
                    fields.insert("center".into(), json!(center));
                }
                value
            }
            Family::PointWithAnyCenter(point, centers) => {
                let point = self.attempt.finite_point("family", point);
                json!({
                    "kind": "point-with-any-center",
                    "circlepoint": point,
                    "centers": self.curve(centers),
                })
            }
            Family::Centers(centers) => {
                json!({"kind": "centers", "coefficients": self.curve(centers)})
            }
        }
    }

    /// The primitive coefficients of a curve.
    fn curve(&mut self, curve: &Polynomial<Exact>) -> Value {
        self.attempt.coefficients("family", curve.coefficients())
    }

    fn certificate(&self, found: &Found, points: &[[Point<Ball>; 2]]) -> Value {
        let bits = self.attempt.bits;
        let verified: Vec<bool> = points
            .iter()
            .map(|[z, m]| krawczyk::holds_one_pair(&self.positions, [z, m], bits))
            .collect();
        json!({"method": found.method, "bits": bits, "krawczyk": verified})
    }
}

/// The pairs at infinity that are slides or turning blocks, named by their first place in the list.
fn dyads_at_infinity(found: &Found, listed: &[Value]) -> Vec<Dyad> {
    let mut place = 0;
    let mut dyads = Vec::new();
    for pair in found.real.iter().filter(|pair| pair.place != Place::Finite) {
        let [_, x, y, cx, cy, ..] = &pair.coordinates;
        let shown = listed
            .get(place)
            .map_or(&Value::Null, |value| &value["direction"]);
        let direction = |x: &Number<Ball>, y: &Number<Ball>| Number::complex(x.clone(), y.clone());
        match pair.place {
            Place::CenterAtInfinity => {
                let point = pair.beside_infinity();
                dyads.push(Dyad::slide(place, point, &direction(cx, cy), shown));
            }
            Place::CirclepointAtInfinity => {
                let point = pair.beside_infinity();
                dyads.push(Dyad::block(place, &direction(x, y), shown, point));
            }
            _ => {}
        }
        place += pair.multiplicity;
    }
    dyads
}

fn by_coordinates(a: &Point<Ball>, b: &Point<Ball>) -> Ordering {
    let part = |x: &Number<Ball>| x.0.midpoint_rational();
    let key = |z: &Point<Ball>| (part(z.re()), part(z.im()));
    let ((x, y), (u, v)) = (key(a), key(b));
    if a.re().compare(b.re()).is_some_and(Ordering::is_ne) {
        return x.cmp(&u);
    }
    y.cmp(&v)
}

fn counts(found: &Found) -> Value {
    let finite = |place: Place| place == Place::Finite;
    let real: usize = found
        .real
        .iter()
        .filter(|pair| finite(pair.place))
        .map(|pair| pair.multiplicity)
        .sum();
    let complex: usize = found
        .complex
        .iter()
        .filter(|pair| finite(pair.place))
        .map(|pair| 2 * pair.multiplicity)
        .sum();
    let infinite: usize = found
        .real
        .iter()
        .filter(|pair| !finite(pair.place))
        .map(|pair| pair.multiplicity)
        .sum();
    let isotropic: usize = found
        .complex
        .iter()
        .filter(|pair| !finite(pair.place))
        .map(|pair| 2 * pair.multiplicity)
        .sum();
    json!({"real": real, "complex": complex, "at_infinity": infinite + isotropic})
}
