//! The answer.

use rug::{Integer, Rational};
use serde_json::{Map, Value, json};

use super::iterated::Outcome;
use super::solution::{Found, Place, Solution};
use crate::linkage::cognates::CouplerPoint;
use crate::linkage::passage::{Joint, Passage};
use crate::number::{Ball, Number, Truth, array, count};
use crate::oracle::linkages::words;
use crate::oracle::numeral::{Numeral, Shown};
use crate::oracle::output;
use crate::oracle::sharpen::Attempt;
use crate::plane::displacement::Displacement;
use crate::plane::{Angle, Point};
use crate::straight_line::design::Design;
use crate::straight_line::no_design::NoDesign;

/// Up to which order contact with the line is looked for.
const CONTACT: usize = 7;

impl Attempt {
    /// All solutions of a formula.
    pub fn solutions<K: Shown>(&mut self, solutions: &[Solution<K>]) -> Map<String, Value> {
        let written: Vec<Value> = solutions.iter().map(|one| self.solution(one)).collect();
        let mut answer = Map::new();
        answer.insert("solutions".into(), json!(written));
        answer
    }

    /// All zeros in a range, and where neither one was found nor excluded, in degrees.
    pub fn outcome(&mut self, outcome: &Outcome, range: &[Rational; 2]) -> Map<String, Value> {
        let mut answer = self.solutions(&outcome.solutions);
        let unresolved = &outcome.unresolved;
        if outcome.solutions.is_empty() && unresolved.is_empty() {
            let none = "no angle in this range gives a linkage";
            answer.insert("none".into(), json!(none));
        }
        answer.insert("range".into(), degrees(range));
        answer.insert(
            "unresolved".into(),
            unresolved.iter().map(degrees).collect(),
        );
        answer
    }

    /// That there is none, and why.
    pub fn no_solution(&mut self, reason: &NoDesign) -> Map<String, Value> {
        let mut answer = Map::new();
        if *reason == NoDesign::Undecided {
            self.decided("solutions", None);
        }
        answer.insert("none".into(), json!(reason.to_string()));
        answer.insert("solutions".into(), json!([]));
        answer
    }

    fn solution<K: Shown>(&mut self, solution: &Solution<K>) -> Value {
        let mut fields = Map::new();
        for (name, ray) in &solution.rays {
            fields.insert((*name).into(), self.ray(name, ray));
        }
        let linkages = solution.linkages.iter().map(|found| self.found(found));
        let linkages: Vec<Value> = linkages.collect();
        fields.insert("linkages".into(), json!(linkages));
        Value::Object(fields)
    }

    /// A ray modulo 180°.
    fn ray<K: Shown>(&mut self, name: &str, ray: &Angle<K>) -> Value {
        let cis = ray.cis();
        let upwards = match cis.im().sign() {
            Some(std::cmp::Ordering::Less) => -cis,
            _ => cis,
        };
        self.turn(name, &upwards)
    }

    fn found<K: Shown>(&mut self, found: &Found<K>) -> Value {
        let mut fields = Map::new();
        if let Some(alternate) = found.alternate {
            fields.insert("alternate".into(), json!(alternate.name()));
        }
        match &found.design {
            Err(reason) => {
                if *reason == NoDesign::Undecided {
                    self.decided("linkages", None);
                }
                fields.insert("none".into(), json!(reason.to_string()));
            }
            Ok(design) => {
                fields.extend(self.linkage(design));
                fields.insert("direction".into(), self.direction_of(design));
                fields.insert("contact".into(), self.contact(design, found.contact));
                fields.insert("type".into(), self.link_type(design));
                let places = found.places.iter().map(|place| self.place(design, place));
                let places: Vec<Value> = places.collect();
                if !places.is_empty() {
                    fields.insert("places".into(), json!(places));
                }
                let cognates = design.cognates();
                let cognates = cognates.iter().map(|cognate| {
                    let mut fields = self.linkage(cognate);
                    fields.insert("contact".into(), self.contact(cognate, found.contact));
                    fields.insert("type".into(), self.link_type(cognate));
                    Value::Object(fields)
                });
                fields.insert("cognates".into(), cognates.collect());
            }
        }
        Value::Object(fields)
    }

    /// Joints, lengths and angles.
    fn linkage<K: Shown>(&mut self, design: &Design<K>) -> Map<String, Value> {
        let CouplerPoint {
            pivots: [o_a, o_b],
            pins: [a, b],
            point: d,
        } = &design.linkage;
        let mut fields = Map::new();
        for (name, point) in [("O_a", o_a), ("A", a), ("B", b), ("O_b", o_b), ("D", d)] {
            fields.insert(name.into(), self.finite_point(name, point));
        }
        for (name, square) in design.squared_lengths() {
            let length = K::numeral(&square).sqrt(self.bits);
            fields.insert(name.into(), self.numeral(name, &length));
        }
        for (name, turn) in design.turns() {
            // An angle with a bar of no length is none.
            let written = match turn.is_zero() {
                Truth::Yes => Value::Null,
                _ => self.turn(name, &turn),
            };
            fields.insert(name.into(), written);
        }
        fields
    }

    fn direction_of<K: Shown>(&mut self, design: &Design<K>) -> Value {
        let [x, y] = [design.direction.re(), design.direction.im()].map(Clone::clone);
        let written = self.direction(&[x, y]);
        self.decided("direction", written)
    }

    fn link_type<K: Shown>(&mut self, design: &Design<K>) -> Value {
        let passage = passage(design, &[]);
        let name = passage.link_type().map(|kind| json!(words::name(kind)));
        self.decided("type", name)
    }

    /// How closely D's path touches its line where the design stands: by its own closure.
    fn contact<K: Shown>(&mut self, design: &Design<K>, least: usize) -> Value {
        let Some(deviation) = design.deviation(CONTACT) else {
            return json!({"change_point": true});
        };
        let terms: Vec<Number<K>> = (1..=CONTACT).map(|j| deviation.v.coefficient(j)).collect();
        let order = terms.iter().position(|term| term.is_zero().is_no());
        let known = terms
            .iter()
            .take_while(|term| term.is_zero().is_yes())
            .count();
        let shown = order.unwrap_or(CONTACT);
        if known < shown && (shown < least || !self.vanish(terms.iter().take(least.max(known)))) {
            return self.decided("contact", None);
        }
        let proven = known.max(least).min(shown);
        if proven < shown || order.is_none() {
            return json!({"at_least": proven});
        }
        let term = |of: &Number<crate::number::Series<K>>, j: usize| of.coefficient(j);
        let rate = term(&deviation.u, 1);
        let next = proven + 1;
        let factorial = (1..=count::to_i64(next)).product::<i64>();
        let power = rate.power(i32::try_from(next).unwrap_or(i32::MAX));
        let derivative = factorial * term(&deviation.v, next) / power;
        let mut fields = Map::new();
        fields.insert("order".into(), json!(proven));
        let proof = if known == proven {
            "exact"
        } else {
            "enclosure"
        };
        fields.insert("proof".into(), json!(proof));
        if rate.is_zero().is_no() {
            fields.insert(
                "derivative".into(),
                self.numeral("derivative", &K::numeral(&derivative)),
            );
        }
        Value::Object(fields)
    }

    /// Whether all of these hold zero and are sharp enough.
    fn vanish<'a, K: Shown + 'a>(&self, terms: impl Iterator<Item = &'a Number<K>>) -> bool {
        let unit = Rational::from((1, Integer::from(Integer::u_pow_u(10, self.digits))));
        terms.into_iter().all(|term| match K::numeral(term) {
            Numeral::Exact(exact) => exact.is_zero().is_yes(),
            Numeral::Float(_) => false,
            Numeral::Enclosed(ball) => holds_zero(&ball, &unit),
        })
    }

    fn place<K: Shown>(&mut self, design: &Design<K>, place: &Place<K>) -> Value {
        let moved = moved(design, &place.displacement);
        let mut fields = Map::new();
        if let Some((s, assembly)) = &place.displaced {
            fields.insert("s".into(), self.numeral("s", &K::numeral(s)));
            fields.insert("assembly".into(), json!(assembly.name()));
        }
        let CouplerPoint {
            pins: [a, b],
            point: d,
            ..
        } = &moved.linkage;
        for (name, point) in [("A", a), ("B", b), ("D", d)] {
            fields.insert(name.into(), self.finite_point(name, point));
        }
        let Some(least) = place.contact else {
            let errors = errors(design, &moved);
            let errors = errors.map(|error| self.beside_one("errors", &error));
            fields.insert("errors".into(), json!(errors));
            return Value::Object(fields);
        };
        let across = ((d - &design.linkage.point) * design.direction.conj())
            .im()
            .clone();
        let closes = [across].into_iter().chain(errors(design, &moved));
        let closes: Vec<Number<K>> = closes.collect();
        if !self.vanish(closes.iter()) {
            self.decided("places", None);
        }
        fields.insert("contact".into(), self.contact(&moved, least));
        let circuit = passage(design, &[&place.displacement])
            .circuit()
            .and_then(|circuits| Some(if *circuits.get(1)? { "same" } else { "other" }));
        fields.insert(
            "circuit".into(),
            self.decided("circuit", circuit.map(Value::from)),
        );
        Value::Object(fields)
    }

    /// A number that may be zero without being known to be: its digits are those of 1.
    pub fn beside_one<K: Shown>(&mut self, name: &str, number: &Number<K>) -> Value {
        let size = Rational::from(1);
        match K::numeral(number) {
            Numeral::Enclosed(ball) => {
                let written = output::enclosure_beside(&ball, &size, self.digits);
                self.decided(name, written)
            }
            other => self.numeral(name, &other),
        }
    }
}

/// A range in degrees.
fn degrees([from, to]: &[Rational; 2]) -> Value {
    json!({"from": output::exact(from), "to": output::exact(to)})
}

/// A ball that holds zero and has a radius of no more than this.
fn holds_zero(ball: &Number<Ball>, unit: &Rational) -> bool {
    ball.0.contains(&Rational::new())
        && ball
            .0
            .radius_rational()
            .is_some_and(|radius| radius <= *unit)
}

/// The same linkage in another position, with the bars as they were.
fn moved<K: Shown>(design: &Design<K>, displacement: &Displacement<K>) -> Design<K> {
    let CouplerPoint {
        pivots,
        pins,
        point,
    } = &design.linkage;
    Design {
        linkage: CouplerPoint {
            pivots: pivots.clone(),
            pins: pins.each_ref().map(|pin| displacement.of(pin)),
            point: displacement.of(point),
        },
        direction: design.direction.clone(),
    }
}

/// By how much the squares of the cranks change (Tesar 1964, (4.39), (4.44)).
fn errors<K: Shown>(design: &Design<K>, moved: &Design<K>) -> [Number<K>; 2] {
    let cranks = |of: &Design<K>| {
        array::pairs(&of.linkage.pins, &of.linkage.pivots).map(|(pin, pivot)| (pin - pivot).norm())
    };
    array::pairs(&cranks(moved), &cranks(design)).map(|(moved, own)| moved - own)
}

/// The linkage in its design position and in others.
pub fn passage<K: Shown>(design: &Design<K>, others: &[&Displacement<K>]) -> Passage<K> {
    let at = |point: &Point<K>| Joint::At(point.clone());
    let here = design.linkage.pins.each_ref().map(at);
    let there = others
        .iter()
        .map(|other| design.linkage.pins.each_ref().map(|pin| at(&other.of(pin))));
    Passage {
        pivots: design.linkage.pivots.each_ref().map(at),
        joints: std::iter::once(here).chain(there).collect(),
    }
}
