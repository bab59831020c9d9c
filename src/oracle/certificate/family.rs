//! Whether a family is what five positions have in common.
//!
//! Every three of the conditions have a center in common for the circlepoints of a curve. On a line these
//! curves are polynomials in one variable; their greatest common divisor must be what the family's curve
//! is there.

use rug::Rational;
use serde_json::Value;

use super::conditions::Form;
use super::elimination::{Row, determinant, row};
use super::{Defect, require};
use crate::number::linear::rank;
use crate::number::text::parse_rational;
use crate::number::univariate::Polynomial;
use crate::number::{Exact, Number};

type Forms = [Form<Exact>; 4];
type Poly = Polynomial<Exact>;

/// Every three of four.
const TRIPLES: [[usize; 3]; 4] = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];

/// The lines x = start + slope · t, y = t on which curves are compared.
const LINES: [[i64; 2]; 5] = [[3, 1], [-7, 2], [11, -3], [2, 5], [-13, -2]];

/// Whether three of the conditions, or three differences, already have no center in common for any
/// circlepoint, nor a circlepoint for any center: as of four translations on no circle and no line.
pub fn has_no_pair(forms: &Forms) -> bool {
    let exchanged = forms.each_ref().map(Form::exchanged);
    [forms, &exchanged].into_iter().all(is_never_fulfilled)
}

#[expect(clippy::indexing_slicing, reason = "triples of the four conditions")]
fn is_never_fulfilled(forms: &Forms) -> bool {
    let [first, second, third, fourth] = forms;
    let to_first = TRIPLES.map(|triple| triple.map(|i| forms[i].clone()));
    let without_first = [second, third, fourth].map(|form| form.minus(first));
    let mut triples = to_first.iter().chain([&without_first]);
    triples.any(|triple| {
        // The same on all lines, and so everywhere.
        let curves = LINES.map(|line| {
            let [p, q, r] = triple.each_ref().map(|form| on_line(form, line));
            determinant(&p, &q, &r)
        });
        let [one, ..] = &curves;
        let is_same = |curve: &Poly| (curve - one).is_zero();
        one.degree() == Some(0) && curves.iter().all(is_same)
    })
}

/// Checks the kind and the curve of a family.
pub fn check(forms: &Forms, family: &Value) -> Result<(), Defect> {
    // The centers are the circlepoints of the inverse motion.
    let exchanged = forms.each_ref().map(Form::exchanged);
    match family["kind"].as_str() {
        Some("plane") => plane(forms, family),
        Some("circlepoint-cubic") => curve(forms, &family["coefficients"], 10),
        Some("circle" | "conic") => curve(forms, &family["coefficients"], 6),
        Some("line") => curve(forms, &family["coefficients"], 3),
        Some("centers") => any_curve(&exchanged, &family["coefficients"]),
        Some("point-with-any-center") => {
            any_curve(&exchanged, &family["centers"])?;
            resting(forms, &family["circlepoint"])
        }
        _ => Err(Defect::wrong("family", "an unknown kind")),
    }
}

/// On x = start + slope · t, y = t, the curves of every three conditions.
#[expect(clippy::indexing_slicing, reason = "triples of the four conditions")]
fn curves(forms: &Forms, line: [i64; 2]) -> [Poly; 4] {
    let rows = forms.each_ref().map(|form| on_line(form, line));
    TRIPLES.map(|[i, j, k]| determinant(&rows[i], &rows[j], &rows[k]))
}

fn on_line(form: &Form<Exact>, [start, slope]: [i64; 2]) -> Row {
    let foot = [Number::from(start), Number::zero()];
    row(form, &foot, [slope, 1])
}

fn plane(forms: &Forms, family: &Value) -> Result<(), Defect> {
    if family.get("center").is_some() {
        let along_a_line = forms.iter().all(Form::is_of_translation)
            && rank(
                &forms
                    .each_ref()
                    .map(|form| form.linear().get(3..).unwrap_or_default().to_vec()),
                2,
            ) == Some(1);
        return require(
            along_a_line,
            "family",
            "these translations are not along a line",
        );
    }
    // A cubic has no more than three of the lines.
    let mut all = LINES.iter().flat_map(|line| curves(forms, *line));
    require(
        all.all(|curve| curve.is_zero()),
        "family",
        "not every point has a center",
    )
}

fn any_curve(forms: &Forms, coefficients: &Value) -> Result<(), Defect> {
    let count = coefficients.as_array().map_or(0, Vec::len);
    curve(forms, coefficients, count)
}

fn curve(forms: &Forms, coefficients: &Value, count: usize) -> Result<(), Defect> {
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
    let mut same = 0;
    for line in LINES {
        let own = shown_on_line(&numbers, order, line);
        let mut common = Poly::zero();
        for cubic in curves(forms, line) {
            common = common.gcd(&cubic).ok_or_else(|| wrong("no common part"))?;
        }
        // A line that is a part of all curves tells nothing.
        let rest = common.divide(&own).map(|(_, rest)| rest.is_zero());
        if !common.is_zero() && rest != Some(true) {
            return Err(wrong("it is no part of all curves"));
        }
        same += usize::from(!common.is_zero() && common.degree() == own.degree());
    }
    require(same > 0, place, "the curves have more in common")
}

/// A curve on a line: its terms are in the order x³, x²y, …, 1.
fn shown_on_line(coefficients: &[Number<Exact>], order: u32, [start, slope]: [i64; 2]) -> Poly {
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

/// Whether the conditions leave more than one center to a point.
fn resting(forms: &Forms, point: &Value) -> Result<(), Defect> {
    let number =
        |value: &Value| -> Option<Rational> { parse_rational(value.get("exact")?.as_str()?).ok() };
    let exact = number(&point[0]).zip(number(&point[1]));
    let (x, y) = exact.ok_or_else(|| Defect::unchecked("a point that is not rational"))?;
    let point = [Number::from(x), Number::from(y)];
    let values = forms.each_ref().map(|form| {
        let row = row(form, &point, [0, 0]);
        row.map(|part| part.coefficient(0)).to_vec()
    });
    require(
        rank(&values, 3).is_some_and(|rank| rank < 2),
        "family.circlepoint",
        "it has more than two places",
    )
}
