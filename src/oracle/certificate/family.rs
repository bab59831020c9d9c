//! Whether a family is what five positions have in common.
//!
//! On a line the five circlepoint curves, found from the loop closure, are polynomials in one variable;
//! their greatest common divisor must be what the family's curve is there.

use rug::Rational;
use serde_json::Value;

use super::{Defect, require};
use crate::finite::four_positions::loop_closure::centerpoint_cubic;
use crate::number::text::parse_rational;
use crate::number::univariate::Polynomial;
use crate::number::{Exact, Number};
use crate::plane::displacement::Displacement;
use crate::plane::{Point, relation};

type Five = [Displacement<Exact>; 5];
type Poly = Polynomial<Exact>;

/// The lines x = start + slope · t, y = t on which curves are compared.
const LINES: [[i64; 2]; 5] = [[3, 1], [-7, 2], [11, -3], [2, 5], [-13, -2]];

/// Whether four of the positions are translations on no circle and no line: then not even these have a
/// pair.
pub fn has_no_pair(positions: &Five) -> bool {
    (0..positions.len()).any(|left_out| {
        let kept = positions.iter().enumerate();
        let kept = kept.filter(|(place, _)| *place != left_out);
        let four: Vec<&Displacement<Exact>> = kept.map(|(_, one)| one).collect();
        are_free_translations(&four)
    })
}

fn are_free_translations(positions: &[&Displacement<Exact>]) -> bool {
    let parallel = positions.windows(2).all(|two| {
        let [a, b] = [&two[0].rotation, &two[1].rotation];
        a.equals(b).is_yes()
    });
    let places: Vec<Point<Exact>> = positions
        .iter()
        .map(|one| one.translation.clone())
        .collect();
    parallel && relation::collinear(&places).is_no() && relation::concyclic(&places).is_no()
}

/// Checks the kind and the curve of a family.
pub fn check(positions: &Five, family: &Value) -> Result<(), Defect> {
    let inverse = positions.each_ref().map(Displacement::inverse);
    // The centers of a motion are the circlepoints of its inverse.
    match family["kind"].as_str() {
        Some("plane") => plane(positions, family),
        Some("circlepoint-cubic") => curve(&inverse, &family["coefficients"], 10),
        Some("circle") => curve(&inverse, &family["coefficients"], 6),
        Some("line") => curve(&inverse, &family["coefficients"], 3),
        Some("centers") => any_curve(positions, &family["coefficients"]),
        Some("point-with-any-center") => {
            any_curve(positions, &family["centers"])?;
            resting(positions, &family["circlepoint"])
        }
        _ => Err(Defect::wrong("family", "an unknown kind")),
    }
}

/// The curves of the centers of every four of the positions.
fn cubics(positions: &Five) -> Option<Vec<Vec<Number<Exact>>>> {
    (0..positions.len())
        .map(|left_out| {
            let kept = positions.iter().enumerate();
            let kept = kept.filter(|(place, _)| *place != left_out);
            let four: Vec<Displacement<Exact>> = kept.map(|(_, one)| one.clone()).collect();
            let cubic = centerpoint_cubic(four.first_chunk()?)?;
            Some(cubic.coefficients().to_vec())
        })
        .collect()
}

fn all_cubics(positions: &Five) -> Result<Vec<Vec<Number<Exact>>>, Defect> {
    cubics(positions).ok_or_else(|| Defect::unchecked("no second route to this family"))
}

fn is_zero(cubic: &[Number<Exact>]) -> bool {
    cubic.iter().all(|c| c.is_zero().is_yes())
}

fn plane(positions: &Five, family: &Value) -> Result<(), Defect> {
    if family.get("center").is_some() {
        let places: [Point<Exact>; 5] = positions.each_ref().map(|one| one.translation.clone());
        return require(
            relation::collinear(&places).is_yes(),
            "family",
            "these translations are not along a line",
        );
    }
    let cubics = all_cubics(positions)?;
    require(
        cubics.iter().all(|cubic| is_zero(cubic)),
        "family",
        "not every point has a center",
    )
}

fn any_curve(positions: &Five, coefficients: &Value) -> Result<(), Defect> {
    let count = coefficients.as_array().map_or(0, Vec::len);
    curve(positions, coefficients, count)
}

fn curve(positions: &Five, coefficients: &Value, count: usize) -> Result<(), Defect> {
    let place = "family.coefficients";
    let wrong = |message: &str| Defect::wrong(place, message);
    let list = coefficients
        .as_array()
        .ok_or_else(|| wrong("a list was expected"))?;
    let numbers: Option<Vec<Number<Exact>>> = list
        .iter()
        .map(|value| Some(Number::from(parse_rational(value.as_str()?).ok()?)))
        .collect();
    let numbers = numbers.ok_or_else(|| wrong("integers were expected"))?;
    let order = match numbers.len() {
        3 => 1,
        6 => 2,
        10 => 3,
        _ => return Err(wrong("3, 6 or 10 coefficients were expected")),
    };
    if numbers.len() != count {
        return Err(wrong("another number of coefficients belongs to this kind"));
    }
    let cubics = all_cubics(positions)?;
    let mut same = 0;
    for line in LINES {
        let own = on_line(&numbers, order, line);
        let mut common = Poly::zero();
        for cubic in &cubics {
            let cubic = on_line(cubic, 3, line);
            common = common.gcd(&cubic).ok_or_else(|| wrong("no common part"))?;
        }
        let rest = common.divide(&own).map(|(_, rest)| rest.is_zero());
        if rest != Some(true) {
            return Err(wrong("it is no part of all five curves"));
        }
        same += usize::from(common.degree() == own.degree());
    }
    require(same > 0, place, "the curves have more in common")
}

/// A curve on a line: its terms are in the order x³, x²y, …, 1.
fn on_line(coefficients: &[Number<Exact>], order: u32, [start, slope]: [i64; 2]) -> Poly {
    let x = Poly::new(vec![start.into(), slope.into()]);
    let y = Poly::new(vec![0.into(), 1.into()]);
    let exponents = (0..=order)
        .rev()
        .flat_map(|n| (0..=n).map(move |k| (n - k, k)));
    let terms = coefficients.iter().zip(exponents);
    terms.fold(Poly::zero(), |sum, (c, (j, k))| {
        sum + (x.power(j) * y.power(k)).scaled(c)
    })
}

/// Whether a point has two places at most.
fn resting(positions: &Five, point: &Value) -> Result<(), Defect> {
    let number =
        |value: &Value| -> Option<Rational> { parse_rational(value.get("exact")?.as_str()?).ok() };
    let exact = number(&point[0]).zip(number(&point[1]));
    let (x, y) = exact.ok_or_else(|| Defect::unchecked("a point that is not rational"))?;
    let z: Point<Exact> = Number::complex(x.into(), y.into());
    let mut places: Vec<Point<Exact>> = Vec::new();
    for place in positions.iter().map(|position| position.of(&z)) {
        if !places.iter().any(|other| other.equals(&place).is_yes()) {
            places.push(place);
        }
    }
    require(
        places.len() <= 2,
        "family.circlepoint",
        "it has more than two places",
    )
}
