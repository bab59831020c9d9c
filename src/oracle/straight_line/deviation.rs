//! `deviation`: how long and how closely the point of a design keeps to its line.

use rug::Rational;
use serde_json::{Map, Value, json};

use super::given::{self, Given};
use super::solution::{Found, Rounded, Solution, closed};
use super::writer::passage;
use crate::linkage::passage::{Drive, Passage};
use crate::number::{Ball, Number};
use crate::oracle::input::Fields;
use crate::oracle::linkages::words;
use crate::oracle::numeral::Shown;
use crate::oracle::output::{self, into_floats};
use crate::oracle::sharpen::{Attempt, sharpen};
use crate::oracle::{Arithmetic, ProblemError, Request};
use crate::plane::{Point, relation};
use crate::straight_line::ball_burmester::Alternate;
use crate::straight_line::design::Design;
use crate::straight_line::deviation::arc::{Arcs, Limit};
use crate::straight_line::deviation::driven::{Driven, Position};
use crate::straight_line::deviation::rows::Rows;
use crate::straight_line::deviation::stepped::{Rule, records};
use crate::straight_line::no_design::NoDesign;

/// Derivatives of v(u) that are told.
const DERIVATIVES: usize = 6;
/// Bits of enclosures of which only floats are wanted.
const FLOAT_BITS: u32 = 128;

struct Problem {
    given: Given,
    alternates: Vec<Alternate>,
    levels: Vec<Rational>,
}

/// The linkage that the problem is about, in floats.
pub fn design(fields: &Fields<'_>) -> Result<Option<Design<f64>>, ProblemError> {
    let found = Problem::read(fields)?.found(FLOAT_BITS).ok();
    Ok(found.map(|chosen| chosen.design.map(float)))
}

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    let problem = Problem::read(fields)?;
    let mut answer = sharpen(request.digits, |attempt| {
        match problem.found(attempt.bits) {
            Ok(found) => problem.analysis(&found, attempt),
            Err(reason) => {
                if reason == NoDesign::Undecided {
                    attempt.decided("design", None);
                }
                let mut answer = Map::new();
                answer.insert("none".into(), json!(reason.to_string()));
                answer
            }
        }
    });
    if request.arithmetic == Arithmetic::Float {
        answer.values_mut().for_each(into_floats);
    }
    Ok(answer)
}

/// The linkage that is analysed.
struct Chosen {
    design: Design<Ball>,
    contact: usize,
    rays: Vec<(&'static str, crate::plane::Angle<Ball>)>,
}

impl Problem {
    fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        fields.only(&["design", "levels"])?;
        let (given, alternates) = given::read(&fields.object("design")?)?;
        let levels = fields.numbers("levels")?;
        for (place, level) in levels.iter().enumerate() {
            if !level.cmp0().is_gt() {
                let place = format!("levels[{place}]");
                return Err(ProblemError::new(
                    &place,
                    "a positive accuracy was expected",
                ));
            }
        }
        Ok(Problem {
            given,
            alternates,
            levels,
        })
    }

    /// The first linkage of the first solution.
    fn found(&self, bits: u32) -> Result<Chosen, NoDesign> {
        let solutions = match &self.given {
            Given::Closed(given) => closed::<Ball>(given, &self.alternates, &Rounded(bits))
                .ok_or(NoDesign::Undecided)??,
            Given::Iterated(iterated) => iterated.solve(&self.alternates, bits)?.solutions,
        };
        let Solution { rays, linkages } = solutions
            .into_iter()
            .next()
            .ok_or(NoDesign::NotReal("the design in this range"))?;
        let Found {
            design, contact, ..
        } = linkages.into_iter().next().ok_or(NoDesign::Undecided)?;
        Ok(Chosen {
            design: design?,
            contact,
            rays,
        })
    }

    fn analysis(&self, chosen: &Chosen, attempt: &mut Attempt) -> Map<String, Value> {
        let design = &chosen.design;
        let unit = design.unit();
        let mut answer = Map::new();
        for (name, square) in design.squared_lengths() {
            let length = Ball::numeral(&(square.sqrt() / &unit));
            answer.insert(name.into(), attempt.numeral(name, &length));
        }
        for (name, turn) in design.turns() {
            answer.insert(name.into(), attempt.turn(name, &turn));
        }
        let [o_a, o_b] = &design.linkage.pivots;
        let line = &design.direction * (o_b - o_a).conj();
        answer.insert("line".into(), attempt.turn("line", &line));
        for (name, ray) in chosen.rays.iter().filter(|(name, _)| *name == "alpha_d") {
            answer.insert((*name).into(), attempt.turn(name, &ray.cis()));
        }
        answer.insert(
            "unit".into(),
            attempt.numeral("unit", &Ball::numeral(&unit)),
        );
        let passage = passage(design, &[]);
        let kind = passage.link_type().map(|kind| json!(words::name(kind)));
        answer.insert("type".into(), attempt.decided("type", kind));
        let crank = crank(&passage).map(Value::from);
        answer.insert("crank".into(), attempt.decided("crank", crank));
        let derivatives = derivatives(design, &unit, attempt);
        answer.insert("derivatives".into(), derivatives);
        let arcs = Driven::new(design).map(|driven| Arcs::new(driven, attempt.bits));
        let stepped = stepped_levels(design, &unit, &self.levels);
        let levels = self.levels.iter().zip(stepped);
        let levels = levels.map(|(level, stepped)| match &arcs {
            Some(arcs) => Level {
                design,
                contact: chosen.contact,
                unit: &unit,
                arcs,
            }
            .written(level, stepped, attempt),
            None => attempt.decided("levels", None),
        });
        let levels: Vec<Value> = levels.collect();
        answer.insert("levels".into(), json!(levels));
        answer
    }
}

/// Which of R and T turn fully.
pub(super) fn crank(passage: &Passage<Ball>) -> Option<&'static str> {
    let [r, t] = Drive::ALL.map(|drive| passage.is_crank(drive));
    Some(match (r?, t?) {
        (true, true) => "both",
        (true, false) => "R",
        (false, true) => "T",
        (false, false) => "none",
    })
}

/// dʲv/duʲ in the design position, from j = 1 on, in units of the unit length.
fn derivatives(design: &Design<Ball>, unit: &Number<Ball>, attempt: &mut Attempt) -> Value {
    let Some(deviation) = design.deviation(DERIVATIVES) else {
        return Value::Null;
    };
    if !deviation.u.coefficient(1).is_zero().is_no() {
        return Value::Null;
    }
    let rate = deviation.u.derivative();
    let mut of_u = deviation.v;
    let list = (0_i32..).take(DERIVATIVES).map(|j| {
        of_u = of_u.derivative() / &rate;
        let value = of_u.coefficient(0) * unit.power(j);
        attempt.beside_one("derivatives", &value)
    });
    list.collect()
}

struct Level<'a> {
    design: &'a Design<Ball>,
    contact: usize,
    unit: &'a Number<Ball>,
    arcs: &'a Arcs,
}

impl Level<'_> {
    fn written(&self, level: &Rational, stepped: Value, attempt: &mut Attempt) -> Value {
        let bound = self.unit * Number::<Ball>::rounded(level, &attempt.bits);
        let Some((arc, ends)) = self.arc(&bound) else {
            return attempt.decided("levels", None);
        };
        let [from, to] = &ends;
        let u = ends
            .each_ref()
            .map(|end| &self.arcs.coordinates(end)[0] / self.unit);
        let length = (&u[1] - &u[0]).abs();
        let mut fields = Map::new();
        let mut add = |name: &str, value: Value| {
            fields.insert(name.to_owned(), value);
        };
        add("D", output::exact(level));
        add("length", attempt.numeral("length", &Ball::numeral(&length)));
        add("u", both(attempt, "u", &u));
        add(
            "phi",
            both(
                attempt,
                "phi",
                &arc.each_ref().map(|limit| limit.degrees.clone()),
            ),
        );
        let psi = arc.each_ref().map(|limit| self.arcs.turn_of_rocker(limit));
        add(
            "psi",
            match psi {
                [Some(from), Some(to)] => both(attempt, "psi", &[from, to]),
                _ => attempt.decided("psi", None),
            },
        );
        let [gamma_a, gamma_b] = self.transmission(&arc, [from, to], attempt);
        add("gamma_a", gamma_a);
        add("gamma_b", gamma_b);
        add(
            "ended_by",
            json!(arc.each_ref().map(|limit| limit.end.name())),
        );
        let extremes = self.extremes(&arc, attempt);
        add("extremes", extremes);
        add("stepped", stepped);
        Value::Object(fields)
    }

    fn arc(&self, bound: &Number<Ball>) -> Option<([Limit; 2], [Position<Ball>; 2])> {
        let arc = self.arcs.within(bound)?;
        let [from, to] = arc.each_ref().map(|limit| self.arcs.position(limit));
        let ends = [from?, to?];
        Some((arc, ends))
    }

    /// Extremes of v within the arc, with their places.
    fn extremes(&self, arc: &[Limit; 2], attempt: &mut Attempt) -> Value {
        let Some(extremes) = self.arcs.extremes(arc, self.contact) else {
            return attempt.decided("extremes", None);
        };
        let written = extremes.into_iter().map(|extreme| {
            let [u, v] = self
                .arcs
                .coordinates(&extreme.position)
                .map(|x| x / self.unit);
            json!({
                "phi": attempt.beside_one("extremes", &extreme.degrees),
                "u": attempt.beside_one("extremes", &u),
                "v": attempt.beside_one("extremes", &v),
            })
        });
        written.collect()
    }

    /// The least and the greatest acute angle between crank and coupler, at A and at B; it is 90° where
    /// the cosine changes its sign.
    fn transmission(
        &self,
        arc: &[Limit; 2],
        ends: [&Position<Ball>; 2],
        attempt: &mut Attempt,
    ) -> [Value; 2] {
        let [o_a, o_b] = self.arcs.pivots();
        let here = Position {
            pins: self.design.linkage.pins.clone(),
            point: self.design.linkage.point.clone(),
        };
        let mut at_a: Vec<Number<Ball>> = Vec::new();
        let mut at_b: Vec<Number<Ball>> = Vec::new();
        for position in ends.into_iter().chain([&here]) {
            let [a, b] = &position.pins;
            at_a.push(cosine(o_a, a, b));
            at_b.push(cosine(o_b, b, a));
        }
        let in_line = self.arcs.transmission_extremes(arc);
        let names = ["gamma_a", "gamma_b"];
        let Some([for_a, for_b]) = in_line else {
            return names.map(|name| attempt.decided(name, None));
        };
        for position in for_a {
            let [a, b] = &position.pins;
            at_a.push(cosine(o_a, a, b));
        }
        for position in for_b {
            let [a, b] = &position.pins;
            at_b.push(cosine(o_b, b, a));
        }
        [(names[0], at_a), (names[1], at_b)].map(|(name, cosines)| {
            match acute_range(&cosines, attempt.bits) {
                Some(range) => both(attempt, name, &range),
                None => attempt.decided(name, None),
            }
        })
    }
}

/// The arcs of all levels in steps of one degree, in floats, in the order of the levels.
fn stepped_levels(design: &Design<Ball>, unit: &Number<Ball>, levels: &[Rational]) -> Vec<Value> {
    let mut order: Vec<usize> = (0..levels.len()).collect();
    order.sort_by_key(|&i| levels.get(i));
    let ascending: Vec<Number<f64>> = order
        .iter()
        .filter_map(|&i| levels.get(i))
        .map(|level| Number(level.to_f64()))
        .collect();
    let found = Driven::new(design).and_then(|driven| {
        let (driven, unit) = (driven.map(float), float(unit));
        let rows = Rows::new(&driven, &unit, &())?;
        let side = |side| {
            records(
                |degrees| rows.met(degrees),
                &ascending,
                side,
                Rule::Reversal,
            )
        };
        Some([side(-1)?, side(1)?])
    });
    let mut values = vec![Value::Null; levels.len()];
    let Some([backwards, forwards]) = found else {
        return values;
    };
    for (i, ends) in order.iter().zip(backwards.iter().zip(&forwards)) {
        if let (Some(value), (Some(from), Some(to))) = (values.get_mut(*i), ends) {
            let v = [from, to].map(|end| output::float(end.row.v.0));
            *value = json!({
                "length": output::float((&to.row.u - &from.row.u).abs().0),
                "phi": [from.degrees, to.degrees],
                "v": v,
            });
        }
    }
    values
}

/// The float in the middle of an enclosure.
fn float(x: &Number<Ball>) -> Number<f64> {
    Number(x.0.midpoint_rational().map_or(f64::NAN, |q| q.to_f64()))
}

/// The cosine of the angle at `pin`.
fn cosine(pivot: &Point<Ball>, pin: &Point<Ball>, other: &Point<Ball>) -> Number<Ball> {
    let (crank, rod) = (pivot - pin, other - pin);
    let scale = relation::distance(pivot, pin) * relation::distance(other, pin);
    (crank * rod.conj()).re() / scale
}

/// The least and the greatest angle, as acute ones, of a range of cosines. `None` where nothing is
/// known of one.
fn acute_range(cosines: &[Number<Ball>], bits: u32) -> Option<[Number<Ball>; 2]> {
    let passes_90 = cosines.iter().any(|c| c.is_positive().is_yes())
        && cosines.iter().any(|c| (-c).is_positive().is_yes());
    let angles = cosines.iter().map(|c| {
        let sine = (1 - c.square()).sqrt();
        sine.atan2(&c.abs()) * 180 / Number::pi(&bits)
    });
    let bounds = angles.map(|angle| Some([angle.0.lower()?, angle.0.upper()?]));
    let bounds: Vec<[Rational; 2]> = bounds.collect::<Option<_>>()?;
    // The least number is between the least lower and the least upper bound, whichever it is.
    let of = |pick: fn(Rational, Rational) -> Rational| {
        let both = bounds.iter().cloned();
        let [low, high] = both.reduce(|[a, b], [c, d]| [pick(a, c), pick(b, d)])?;
        let middle = Rational::from(&low + &high) / 2u32;
        Some(Number(Ball::with_radius(
            &middle,
            &((high - low) / 2u32),
            bits,
        )))
    };
    let greatest = if passes_90 {
        Number::<Ball>::from(90)
    } else {
        of(Rational::max)?
    };
    Some([of(Rational::min)?, greatest])
}

/// Two numbers.
fn both(attempt: &mut Attempt, name: &str, numbers: &[Number<Ball>; 2]) -> Value {
    let numbers = numbers
        .each_ref()
        .map(|number| attempt.beside_one(name, number));
    json!(numbers)
}
