//! Writes what was found of five positions.

use std::cmp::Ordering;

use serde_json::{Map, Value, json};

use super::Five;
use super::found::{Couple, Families, Found, Real};
use crate::finite::five_positions::conditioning::conditioning;
use crate::finite::five_positions::conditions::finite_pair;
use crate::finite::five_positions::conics::Place;
use crate::finite::five_positions::families::Family;
use crate::finite::five_positions::krawczyk::{self, Enclosed};
use crate::number::exact::primitive;
use crate::number::{Ball, Complex, Exact, Number};
use crate::oracle::linkages::{self, Dyad};
use crate::oracle::numeral::{Numeral, together};
use crate::oracle::sharpen::Attempt;
use crate::oracle::wishes::Wishes;
use crate::plane::Point;
use crate::plane::displacement::Displacement;
use crate::plane::polynomial::Polynomial;

/// Writes what was found.
pub struct Writer<'a, C> {
    pub attempt: &'a mut Attempt,
    /// What a pair must fulfil.
    pub conditions: C,
    /// The positions that are apart.
    pub positions: Vec<Displacement<Ball>>,
    /// The same, where they are rational.
    pub exact: Option<Vec<Displacement<Exact>>>,
    pub wishes: Option<&'a Wishes>,
}

impl<C: Enclosed> Writer<'_, C> {
    /// The whole answer.
    pub fn answer(mut self, found: &Found) -> Map<String, Value> {
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
        if let Some(alternates) = &found.alternates {
            let finite: Vec<&Real> = pairs.iter().map(|(pair, _)| *pair).collect();
            let infinite = found.real.iter().filter(|pair| pair.place != Place::Finite);
            let infinite: Vec<&Real> = infinite.collect();
            answer.insert("alternates".into(), alternates.written(&finite, &infinite));
        }
        let points: Vec<[Point<Ball>; 2]> =
            pairs.iter().map(|(_, points)| points.clone()).collect();
        let finite = pairs.iter().enumerate();
        let mut dyads: Vec<Dyad> = finite
            .map(|(place, (pair, points))| {
                let dyad = Dyad::finite(place, points.clone());
                match &pair.surds {
                    Some(coordinates) => dyad.exactly(finite_pair(coordinates)),
                    None => dyad,
                }
            })
            .collect();
        dyads.extend(at_infinity);
        if self.positions.is_empty() {
            // Nothing is asked of linkages where there is no position for them to pass.
            dyads.clear();
        }
        let bits = self.attempt.bits;
        let linkages = linkages::all(&dyads, self.exact.as_deref(), &self.positions, bits);
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
        let mut value = json!({
            "circlepoint": self.attempt.finite_point("pairs", z),
            "center": self.attempt.finite_point("pairs", m),
            "multiplicity": pair.multiplicity,
        });
        let five = <&Five<Ball>>::try_from(self.positions.as_slice()).ok();
        let five = five.filter(|_| pair.multiplicity == 1);
        let estimate = five.and_then(|five| conditioning(five, [z, m]));
        if let (Some(estimate), Value::Object(fields)) = (estimate, &mut value) {
            let places = estimate.sensitivity.map(|place| place.map(rough));
            fields.insert("sensitivity".into(), json!(places));
            fields.insert("condition".into(), json!(rough(estimate.condition)));
            fields.insert("to_double".into(), json!(rough(estimate.to_double)));
        }
        value
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
                let kind = match curve.coefficients() {
                    [_, _, _] => "line",
                    [a, b, c, ..] if curve.order() == 2 => {
                        let is_circle = a.equals(c) & b.is_zero();
                        if is_circle.is_yes() {
                            "circle"
                        } else {
                            "conic"
                        }
                    }
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
            .map(|[z, m]| krawczyk::holds_one_pair(&self.conditions, [z, m], bits))
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

/// Three digits of an estimate.
fn rough(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
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
