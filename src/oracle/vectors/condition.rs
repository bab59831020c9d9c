//! How much an answer changes where its problem changes a little.

use rug::Rational;
use serde_json::{Map, Value, json};

use super::draw::turn;
use super::pose::{self, tenth};
use crate::number::text::parse_rational;
use crate::number::{Exact, Number};
use crate::oracle::{Request, solve};
use crate::plane::Point;

/// Disturbances are 10 to the minus this.
const DIGITS: u32 = 12;
/// How many disturbances are tried.
const DIRECTIONS: u32 = 3;
/// Signs of the disturbances: the binary digits of the golden ratio, which favour nothing.
const SIGNS: u64 = 0x9e37_79b9_7f4a_7c15;

/// An estimate of the relative change of the answer per relative change of the problem: the worst of a
/// few directions in which all inputs are disturbed by 10⁻¹², coordinates by that part of the largest
/// one, angles by that part of a radian. Null where the answer is discrete, or becomes another kind of
/// answer, as for degenerate problems.
pub fn condition(problem: &Value, answer: &Value) -> Value {
    let worst = estimate(problem, answer).map(|worst| format!("{worst:.2e}"));
    // A plain number of three digits.
    worst
        .and_then(|text| serde_json::from_str(&text).ok())
        .unwrap_or_default()
}

fn estimate(problem: &Value, answer: &Value) -> Option<f64> {
    let original = Quantities::of(answer)?;
    let request = Request::default();
    let mut worst = Rational::new();
    for direction in 0..DIRECTIONS {
        let disturbed = Disturbance::new(problem, direction).of(problem)?;
        let other = Quantities::of(&solve(&disturbed, &request).ok()?)?;
        worst = worst.max(original.change(&other)?);
    }
    let worst = (worst / tenth(DIGITS)).to_f64();
    (worst > 0.0 && worst.is_finite()).then_some(worst)
}

/// Changes every number of a problem.
struct Disturbance {
    /// The largest coordinate.
    size: Rational,
    direction: u32,
    /// How many numbers were changed.
    count: u32,
}

impl Disturbance {
    fn new(problem: &Value, direction: u32) -> Self {
        let mut size = Rational::new();
        let positions = problem["positions"].as_array();
        for position in positions.into_iter().flatten() {
            let points = position["points"].as_array().into_iter().flatten();
            let coordinates = points.flat_map(|point| [&point[0], &point[1]]);
            for value in coordinates.chain([&position["x"], &position["y"]]) {
                size = size.max(number(value).unwrap_or_default().abs());
            }
        }
        if size.is_zero() {
            size = Rational::from(1);
        }
        Disturbance {
            size,
            direction,
            count: 0,
        }
    }

    /// The next disturbance, plus or minus 10⁻¹².
    fn step(&mut self) -> Rational {
        let place = (self.count * 7 + self.direction * 13) % 64;
        self.count += 1;
        let sign = if (SIGNS >> place) & 1 == 1 { 1 } else { -1 };
        tenth(DIGITS) * sign
    }

    fn of(&mut self, problem: &Value) -> Option<Value> {
        let mut changed = Map::new();
        for (name, value) in problem.as_object()? {
            let value = match name.as_str() {
                "problem" => value.clone(),
                "positions" => self.list(value, Self::position)?,
                "circlepoints" | "centers" => self.list(value, Self::point)?,
                "links" => self.list(value, Self::link)?,
                "alpha_a" | "alpha_d" => self.angle(value)?,
                "k" | "m" | "n" | "d" | "a" | "b" | "c" | "rho" | "kappa" => {
                    let factor: Rational = self.step() + 1;
                    json!((number(value)? * factor).to_string())
                }
                // What is known of the problem is not known of its neighbours.
                _ => continue,
            };
            changed.insert(name.clone(), value);
        }
        Some(Value::Object(changed))
    }

    fn list(
        &mut self,
        list: &Value,
        change: impl Fn(&mut Self, &Value) -> Option<Value>,
    ) -> Option<Value> {
        let list = list.as_array()?.iter();
        let changed: Option<Vec<Value>> = list.map(|value| change(self, value)).collect();
        changed.map(Value::from)
    }

    fn coordinate(&mut self, value: &Value) -> Option<String> {
        let step = self.step() * &self.size;
        Some((number(value)? + step).to_string())
    }

    fn point(&mut self, value: &Value) -> Option<Value> {
        Some(json!([
            self.coordinate(&value[0])?,
            self.coordinate(&value[1])?
        ]))
    }

    fn link(&mut self, link: &Value) -> Option<Value> {
        let mut end = |name: &str| match link[name].get("at_infinity") {
            Some(direction) => Some(json!({"at_infinity": self.point(direction)?})),
            None => self.point(&link[name]),
        };
        Some(json!({"circlepoint": end("circlepoint")?, "center": end("center")?}))
    }

    #[expect(clippy::indexing_slicing, reason = "a field of an object")]
    fn position(&mut self, position: &Value) -> Option<Value> {
        if let Some(points) = position["points"].as_array() {
            return self.two_points(position, points);
        }
        let mut changed = json!({
            "x": self.coordinate(&position["x"])?,
            "y": self.coordinate(&position["y"])?,
            "angle": self.angle(&position["angle"])?,
        });
        if let Some(derivatives) = position.get("derivatives") {
            changed["derivatives"] = self.list(derivatives, Self::derivative)?;
        }
        Some(changed)
    }

    /// Lengths like coordinates, angles like those in radians.
    fn derivative(&mut self, derivative: &Value) -> Option<Value> {
        let step = self.step();
        Some(json!({
            "x": self.coordinate(&derivative["x"])?,
            "y": self.coordinate(&derivative["y"])?,
            "angle": (number(&derivative["angle"])? + step).to_string(),
        }))
    }

    /// Each for itself where the angle is fitted, else together as a body.
    fn two_points(&mut self, position: &Value, points: &[Value]) -> Option<Value> {
        if position.get("fit").is_some() {
            let points: Option<Vec<Value>> = points.iter().map(|point| self.point(point)).collect();
            return Some(json!({"points": points?, "fit": true}));
        }
        let turn = self.small_turn();
        let [dx, dy] = [self.step() * &self.size, self.step() * &self.size];
        let shift: Point<Exact> = Number::complex(dx.into(), dy.into());
        let points: Option<Vec<Value>> = points
            .iter()
            .map(|point| {
                let z = Number::complex(number(&point[0])?.into(), number(&point[1])?.into());
                Some(pose::point(&(&turn * z + &shift)))
            })
            .collect();
        Some(json!({"points": points?}))
    }

    fn small_turn(&mut self) -> Point<Exact> {
        turn(&(self.step() / 2))
    }

    fn angle(&mut self, angle: &Value) -> Option<Value> {
        if let Some(degrees) = angle.get("degrees") {
            // A radian has 57.3 degrees.
            let step = self.step() * Rational::from((573, 10));
            return Some(json!({"degrees": (number(degrees)? + step).to_string()}));
        }
        if let Some(radians) = angle.get("radians") {
            let step = self.step();
            return Some(json!({"radians": (number(radians)? + step).to_string()}));
        }
        let given = match angle.get("tan_half") {
            Some(half) => turn(&number(half)?),
            None => Number::complex(number(&angle["cos"])?.into(), number(&angle["sin"])?.into()),
        };
        Some(pose::angle(&(given * self.small_turn())))
    }
}

/// A number of a problem.
fn number(value: &Value) -> Option<Rational> {
    match value {
        Value::String(text) => parse_rational(text).ok(),
        Value::Number(number) => parse_rational(&number.to_string()).ok(),
        _ => None,
    }
}

/// A number of an answer.
fn shown(value: &Value) -> Option<Rational> {
    let text = value.get("exact").or_else(|| value.get("value"))?;
    parse_rational(text.as_str()?).ok()
}

/// The numbers of an answer: those that belong to one point or curve together.
#[derive(Default)]
struct Quantities {
    /// What is no number: it must stay as it is.
    words: Vec<String>,
    vectors: Vec<Vec<Rational>>,
    /// Angles in degrees, which are the same a turn apart.
    degrees: Vec<Rational>,
    /// Solutions in no order, each of a circlepoint and its center.
    pairs: Vec<[Vec<Rational>; 2]>,
}

/// Fields that tell nothing about the answer itself.
const ASIDE: [&str; 8] = [
    "problem",
    "id",
    "digits",
    "linkages",
    "certificate",
    "eliminant",
    "alternates",
    "fitted_angles",
];

impl Quantities {
    /// `None` where there is no number that could change smoothly.
    fn of(answer: &Value) -> Option<Self> {
        let mut quantities = Quantities::default();
        if answer["problem"] == "five-positions" || answer["problem"] == "mixed-positions" {
            quantities.five_positions(answer)?;
        } else {
            for (name, value) in answer.as_object()? {
                if !ASIDE.contains(&name.as_str()) {
                    quantities.collect(name, value);
                }
            }
        }
        let Quantities {
            vectors,
            degrees,
            pairs,
            ..
        } = &quantities;
        let nothing = vectors.is_empty() && degrees.is_empty() && pairs.is_empty();
        (!nothing).then_some(quantities)
    }

    /// Simple finite pairs only: multiple ones split, those at infinity come from there.
    fn five_positions(&mut self, answer: &Value) -> Option<()> {
        let is_empty = |name: &str| answer[name].as_array().is_some_and(Vec::is_empty);
        if !answer["family"].is_null() || !is_empty("at_infinity") {
            return None;
        }
        self.words.push(answer["counts"].to_string());
        for name in ["pairs", "complex_pairs"] {
            for pair in answer[name].as_array()? {
                if pair["multiplicity"] != json!(1) {
                    return None;
                }
                let [z, m] = [&pair["circlepoint"], &pair["center"]].map(point_of_pair);
                self.pairs.push([z?, m?]);
            }
        }
        Some(())
    }

    fn collect(&mut self, name: &str, value: &Value) {
        if let Some(number) = shown(value) {
            if name == "degrees" {
                self.degrees.push(number);
            } else {
                self.vectors.push(vec![number]);
            }
            return;
        }
        match value {
            Value::Array(list) => {
                let free = matches!(name, "coefficients" | "at_infinity" | "asymptote")
                    || matches!(name, "midline" | "line");
                let read = |value: &Value| if free { either(value) } else { shown(value) };
                let numbers: Option<Vec<Rational>> = list.iter().map(read).collect();
                match numbers {
                    Some(numbers) if free => self.vectors.push(divided_by_largest(numbers)),
                    Some(numbers) => self.vectors.push(numbers),
                    None => list.iter().for_each(|value| self.collect(name, value)),
                }
            }
            Value::Object(fields) => {
                for (name, value) in fields {
                    self.words.push(name.clone());
                    self.collect(name, value);
                }
            }
            other => self.words.push(other.to_string()),
        }
    }

    /// The largest relative change; `None` where the two are not of one form.
    fn change(&self, other: &Self) -> Option<Rational> {
        let alike = self.words == other.words
            && self.vectors.len() == other.vectors.len()
            && self.degrees.len() == other.degrees.len()
            && self.pairs.len() == other.pairs.len();
        if !alike {
            return None;
        }
        let mut worst = Rational::new();
        // What is zero is measured by the rest of the answer, the points of a pair by one another.
        let all = largest(&self.vectors.concat());
        for (a, b) in self.vectors.iter().zip(&other.vectors) {
            worst = worst.max(change(a, b, &all)?);
        }
        let all = largest(&self.pairs.concat().concat());
        for (a, b) in self.degrees.iter().zip(&other.degrees) {
            worst = worst.max(change_of_angle(a, b));
        }
        let mut left: Vec<&[Vec<Rational>; 2]> = other.pairs.iter().collect();
        for [z, m] in &self.pairs {
            let own = largest(z).max(largest(m));
            let scale = if own.is_zero() { &all } else { &own };
            // The nearest of those that are left.
            let changes = left
                .iter()
                .map(|[z1, m1]| Some(change(z, z1, scale)?.max(change(m, m1, scale)?)));
            let changes: Option<Vec<Rational>> = changes.collect();
            let nearest = changes?
                .into_iter()
                .enumerate()
                .min_by(|a, b| a.1.cmp(&b.1));
            let (place, least) = nearest?;
            left.swap_remove(place);
            worst = worst.max(least);
        }
        Some(worst)
    }
}

/// Re x, Im x, Re y, Im y.
fn point_of_pair(value: &Value) -> Option<Vec<Rational>> {
    let mut parts = Vec::new();
    for coordinate in value.as_array()? {
        match coordinate.get("re") {
            Some(re) => parts.extend([shown(re)?, shown(&coordinate["im"])?]),
            None => parts.extend([shown(coordinate)?, Rational::new()]),
        }
    }
    Some(parts)
}

/// A number, also where it is an integer of a normal form.
fn either(value: &Value) -> Option<Rational> {
    shown(value).or_else(|| parse_rational(value.as_str()?).ok())
}

fn largest(list: &[Rational]) -> Rational {
    let sizes = list.iter().map(|x| x.clone().abs());
    sizes.fold(Rational::new(), Rational::max)
}

/// In a form that has no free factor: the entry that is largest is 1.
fn divided_by_largest(list: Vec<Rational>) -> Vec<Rational> {
    let size = largest(&list);
    let Some(divisor) = list.iter().find(|x| (*x).clone().abs() == size) else {
        return list;
    };
    if divisor.is_zero() {
        return list;
    }
    list.iter().map(|x| Rational::from(x / divisor)).collect()
}

/// Relative to the angle, or to a radian where that is more.
fn change_of_angle(a: &Rational, b: &Rational) -> Rational {
    let turn = Rational::from(360);
    let difference = Rational::from(a - b);
    let turns = Rational::from(&difference / &turn).round();
    let size = a.clone().abs().max(Rational::from(57));
    (difference - turns * turn).abs() / size
}

/// Relative to the largest entry, or to `scale` where all are zero.
fn change(a: &[Rational], b: &[Rational], scale: &Rational) -> Option<Rational> {
    if a.len() != b.len() {
        return None;
    }
    let differences: Vec<Rational> = a
        .iter()
        .zip(b)
        .map(|(a, b)| Rational::from(a - b))
        .collect();
    let (difference, own) = (largest(&differences), largest(a));
    if difference.is_zero() {
        return Some(difference);
    }
    let size = if own.is_zero() { scale } else { &own };
    (!size.is_zero()).then(|| difference / size)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn condition_of(problem: &Value) -> f64 {
        let answer = solve(problem, &Request::default());
        let answer = answer.unwrap_or_default();
        condition(problem, &answer).as_f64().unwrap_or(f64::NAN)
    }

    /// 180° and −180° are one angle.
    #[test]
    fn half_a_revolution_is_nothing_special() {
        let problem = json!({"problem": "poles", "positions": [
            {"x": "3", "y": "-5", "angle": {"tan_half": "-1/3"}},
            {"x": "13/7", "y": "-6", "angle": {"cos": "-4/5", "sin": "3/5"}},
        ]});
        assert!((0.1..100.0).contains(&condition_of(&problem)));
    }

    /// A pole that happens to be the origin changes as others do.
    #[test]
    fn the_origin_is_nothing_special() {
        let problem = json!({"problem": "poles", "positions": [
            {"x": "0", "y": "0", "angle": {"tan_half": "0"}},
            {"x": "0", "y": "0", "angle": {"tan_half": "1/2"}},
            {"x": "3", "y": "1", "angle": {"tan_half": "2"}},
        ]});
        assert!((0.1..100.0).contains(&condition_of(&problem)));
    }
}
