//! `centerpoint-curve`: both curves of four positions, their type, and the pole quadrilaterals.

use std::cmp::Ordering;

use serde_json::{Map, Value, json};

use super::input::Fields;
use super::numeral::{Numeral, Shown};
use super::poles::{self, label};
use super::positions::{Given, Task};
use super::sharpen::Attempt;
use super::{ProblemError, Request, curve_wishes, stretches};
use crate::finite::four_positions::{circle_conditions, isotropic, loop_closure, viewing_angles};
use crate::finite::positions::{OPPOSITE_POLES, Positions};
use crate::number::array;
use crate::plane::Point;
use crate::plane::circular_cubic::Cubic;
use crate::plane::curve_type::{self, CurveType};
use crate::plane::focal_cubic::FocalCubic;
use crate::plane::projective::ProjectivePoint;
use crate::plane::quadrilateral::{self, Extremes, Shape};

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions", "wishes"])?;
    let given = Given::read(fields, 4, 4)?;
    let wishes = curve_wishes::read(fields, given.rational().as_ref())?;
    let mut answer = given.solve(&Curves, request);
    if let Some(wishes) = wishes {
        stretches::extend(&mut answer, &given, &wishes, request);
    }
    Ok(answer)
}

struct Curves;

impl Task for Curves {
    fn answer<K: Shown>(
        &self,
        positions: &Positions<K>,
        _: &K::Precision,
        attempt: &mut Attempt,
    ) -> Map<String, Value> {
        let mut answer = poles::both(positions, attempt);
        let curves = [
            ("centerpoint", by_all_routes(positions)),
            ("circlepoint", by_all_routes(&positions.inverse())),
        ];
        for (name, cubic) in curves {
            let curve = cubic.map(|cubic| curve(name, &cubic, attempt));
            let curve = attempt.decided(name, curve.map(Value::Object));
            answer.insert(name.into(), curve);
        }
        let quadrilaterals: Vec<Value> = OPPOSITE_POLES
            .iter()
            .map(|poles| Value::Object(quadrilateral_of(poles, positions, attempt)))
            .collect();
        answer.insert("quadrilaterals".into(), json!(quadrilaterals));
        answer
    }
}

/// The curve of the centers, if no route contradicts it; floats, which round without saying so, cannot
/// tell.
fn by_all_routes<K: Shown>(positions: &Positions<K>) -> Option<Cubic<K>> {
    let cubic = viewing_angles::centerpoint_cubic(positions)?;
    let four = positions.first_four()?;
    let others = [
        isotropic::centerpoint_cubic(positions)?,
        circle_conditions::centerpoint_cubic(four)?,
        loop_closure::centerpoint_cubic(four)?,
    ];
    let contradicted = others.iter().any(|other| cubic.equals(other).is_no());
    (K::ROUNDS || !contradicted).then_some(cubic)
}

/// What there is to say of a cubic through the circular points.
pub fn curve<K: Shown>(name: &str, cubic: &Cubic<K>, attempt: &mut Attempt) -> Map<String, Value> {
    let at = |part: &str| format!("{name}.{part}");
    let curve_type = curve_type::curve_type(cubic);
    let form = FocalCubic::of(cubic);
    let mut fields = Map::new();
    let coefficients = attempt.coefficients(&at("coefficients"), cubic.coefficients());
    fields.insert("coefficients".into(), coefficients);
    let word = attempt.decided(&at("type"), curve_type.map(|t| json!(type_name(t))));
    fields.insert("type".into(), word);
    let nodes = curve_type.and_then(|t| nodes(t, cubic, form.as_ref(), attempt));
    let nodes = attempt.decided(&at("nodes"), nodes.map(Value::from));
    fields.insert("nodes".into(), nodes);
    let exists = !cubic.contains_line_at_infinity().is_yes();
    let of_form = |attempt: &mut Attempt,
                   part: &str,
                   show: &dyn Fn(&mut Attempt, &FocalCubic<K>) -> Value| {
        match &form {
            _ if !exists => Value::Null,
            Some(form) => show(attempt, form),
            None => attempt.decided(&at(part), None),
        }
    };
    let focus = of_form(attempt, "focus", &|attempt, form| {
        attempt.finite_point(&at("focus"), &form.focus)
    });
    fields.insert("focus".into(), focus);
    let asymptote = of_form(attempt, "asymptote", &|attempt, form| {
        attempt.line(&at("asymptote"), &form.asymptote())
    });
    fields.insert("asymptote".into(), asymptote);
    let midline = of_form(attempt, "midline", &|attempt, form| {
        attempt.line(&at("midline"), &form.midline())
    });
    fields.insert("midline".into(), midline);
    fields
}

/// The format's word; null for a curve without any finite point.
fn type_name(curve_type: CurveType) -> Option<&'static str> {
    match curve_type {
        CurveType::OneBranch => Some("one-branch"),
        CurveType::TwoBranches => Some("two-branches"),
        CurveType::Nodal => Some("nodal"),
        CurveType::LineAndCircle => Some("line-and-circle"),
        CurveType::ThreeLines => Some("three-lines"),
        CurveType::Hyperbola => Some("hyperbola"),
        CurveType::TwoLines => Some("two-lines"),
        CurveType::EveryPoint => Some("every-point"),
        CurveType::NoPoint => None,
    }
}

/// The finite real double points; `None` where they are not sharp enough.
fn nodes<K: Shown>(
    curve_type: CurveType,
    cubic: &Cubic<K>,
    form: Option<&FocalCubic<K>>,
    attempt: &mut Attempt,
) -> Option<Vec<Value>> {
    let one = |attempt: &mut Attempt, point: &Point<K>| vec![attempt.finite_point("nodes", point)];
    match (curve_type, form) {
        (CurveType::Nodal, Some(form)) => Some(one(attempt, &form.node())),
        (CurveType::ThreeLines, Some(form)) => Some(one(attempt, &form.focus)),
        (CurveType::LineAndCircle, Some(form)) => of_line_and_circle(form, attempt),
        (CurveType::TwoLines, _) => {
            let center = cubic.beside_line_at_infinity().center();
            Some(vec![attempt.point("nodes", &center)])
        }
        _ => Some(Vec::new()),
    }
}

/// φ ± i√(−q/|α|²) α.
fn of_line_and_circle<K: Shown>(form: &FocalCubic<K>, attempt: &mut Attempt) -> Option<Vec<Value>> {
    if form.squared_radius().sign()?.is_lt() {
        return Some(Vec::new());
    }
    let squared = form.squared_radius() / form.alpha.norm();
    let root = K::numeral(&squared).sqrt(attempt.bits);
    let (x, y) = (K::numeral(form.focus.re()), K::numeral(form.focus.im()));
    let (a, b) = (form.alpha.re(), form.alpha.im());
    let at = |attempt: &mut Attempt, dx: &Numeral, dy: &Numeral| {
        let bits = attempt.bits;
        let point = [
            x.plus_product(dx, &root, bits),
            y.plus_product(dy, &root, bits),
        ];
        attempt.coordinates("nodes", &point)
    };
    let first = at(attempt, &K::numeral(b), &K::numeral(&-a));
    let second = at(attempt, &K::numeral(&-b), &K::numeral(a));
    Some(vec![first, second])
}

fn quadrilateral_of<K: Shown>(
    pairs: &[(usize, usize); 4],
    positions: &Positions<K>,
    attempt: &mut Attempt,
) -> Map<String, Value> {
    let poles = pairs.map(|(i, j)| positions.pole(i, j));
    let finite = poles.each_ref().map(|pole| pole.as_ref()?.finite());
    let sides = array::sides(&finite).map(|(one, other)| side(one, other, attempt));
    let [shape, u_vs_z, extremes] = match finite {
        [Some(a), Some(b), Some(c), Some(d)] => described(&[a, b, c, d]),
        // A vertex at infinity, or none: what needs four finite ones does not exist.
        _ => {
            let decided = poles.iter().flatten().all(is_known);
            [
                decided.then(|| json!("degenerate")),
                Some(Value::Null),
                Some(Value::Null),
            ]
        }
    };
    let labels: Vec<String> = pairs.iter().map(|(i, j)| label(*i, *j)).collect();
    let mut fields = Map::new();
    fields.insert("vertices".into(), json!(labels));
    fields.insert(
        "shape".into(),
        attempt.decided("quadrilaterals.shape", shape),
    );
    fields.insert("sides".into(), json!(sides));
    for (name, value) in [("u_vs_z", u_vs_z), ("shortest_and_longest", extremes)] {
        let value = attempt.decided(&format!("quadrilaterals.{name}"), value);
        fields.insert(name.into(), value);
    }
    fields
}

/// Whether it is known that a pole is finite, at infinity, or not determined.
fn is_known<K: Shown>(pole: &ProjectivePoint<K>) -> bool {
    !pole.is_finite().is_unknown() || pole.is_determined().is_no()
}

/// Shape, U against Z, and where the shortest and the longest side lie, as far as they are known.
fn described<K: Shown>(vertices: &[Point<K>; 4]) -> [Option<Value>; 3] {
    let shape = quadrilateral::shape(vertices).map(|shape| match shape {
        Shape::Convex => "convex",
        Shape::Concave => "concave",
        Shape::Crossed => "crossed",
        Shape::Degenerate => "degenerate",
    });
    let squares = quadrilateral::squared_sides(vertices);
    let extremes = quadrilateral::extremes(&squares).map(|extremes| match extremes {
        Extremes::Adjacent => "adjacent",
        Extremes::Opposite => "opposite",
        Extremes::Both => "both",
    });
    let u_vs_z = quadrilateral::u_vs_z(vertices).map(|order| match order {
        Ordering::Less => "<",
        Ordering::Equal => "=",
        Ordering::Greater => ">",
    });
    [shape, u_vs_z, extremes].map(|word| word.map(Value::from))
}

/// The length of a side between finite poles.
fn side<K: Shown>(from: &Option<Point<K>>, to: &Option<Point<K>>, attempt: &mut Attempt) -> Value {
    let (Some(from), Some(to)) = (from, to) else {
        return Value::Null;
    };
    let square = K::numeral(&(to - from).norm());
    let bits = attempt.bits;
    attempt.numeral("quadrilaterals.sides", &square.sqrt(bits))
}
