//! `mixed-positions`: five positions of which some are infinitely near each other.

use rug::Rational;
use serde_json::{Map, Value};

use super::found::Found;
use super::known::Known;
use super::undecided;
use super::writer::Writer;
use crate::curvature::mixed::{Groups, pairs};
use crate::curvature::motion::{path, turn};
use crate::number::{Ball, Exact, Kind, Number};
use crate::oracle::input::{Angle, Fields};
use crate::oracle::output::into_floats;
use crate::oracle::sharpen::sharpen;
use crate::oracle::{Arithmetic, ProblemError, Request};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Positions in all.
const POSITIONS: usize = 5;

/// A position, and the derivatives of its x, y and angle with respect to any parameter.
struct Group {
    place: [Rational; 2],
    angle: Angle,
    derivatives: Vec<[Rational; 3]>,
}

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions"])?;
    let list = fields.list("positions")?.iter().enumerate();
    let given: Vec<Group> = list.map(group).collect::<Result<_, _>>()?;
    let count: usize = given.iter().map(|one| one.derivatives.len() + 1).sum();
    if count != POSITIONS {
        return Err(ProblemError::new(
            "positions",
            format!(
                "five positions were expected, each derivative counted as one more; these are {count}"
            ),
        ));
    }
    let exact = groups(&given, rational);
    let pairs = exact.as_ref().and_then(pairs);
    let mut answer = sharpen(request.digits, |attempt| {
        let bits = attempt.bits;
        let Some(enclosed) = groups(&given, |angle| Some(angle.rounded::<Ball>(&bits).cis()))
        else {
            return undecided(attempt);
        };
        let found = match &exact {
            Some(groups) => {
                let conditions = groups.conditions();
                let exactly = Found::exact(&conditions, pairs.as_ref(), &Known::new(), bits);
                match &pairs {
                    Some(pairs) if attempt.is_repeated() => {
                        exactly.map(|found| found.with_surds(pairs))
                    }
                    _ => exactly,
                }
            }
            None => Found::enclosed(&enclosed.conditions(), bits),
        };
        match found.filter(|found| !found.is_undecided()) {
            None => undecided(attempt),
            Some(found) => {
                let writer = Writer {
                    attempt,
                    positions: enclosed.positions(),
                    conditions: enclosed,
                    exact: exact.as_ref().map(Groups::positions),
                    wishes: None,
                };
                writer.answer(&found)
            }
        }
    });
    if request.arithmetic == Arithmetic::Float {
        answer.remove("certificate");
        answer.values_mut().for_each(into_floats);
    }
    Ok(answer)
}

fn group((place, value): (usize, &Value)) -> Result<Group, ProblemError> {
    let at = format!("positions[{place}]");
    let fields = Fields::at(value, &at)?;
    fields.only(&["x", "y", "angle", "derivatives"])?;
    let list = if fields.has("derivatives") {
        fields.list("derivatives")?
    } else {
        &[]
    };
    let derivatives = list.iter().enumerate().map(|(order, value)| {
        let fields = Fields::at(value, &format!("{at}.derivatives[{order}]"))?;
        fields.only(&["x", "y", "angle"])?;
        Ok([
            fields.number("x")?,
            fields.number("y")?,
            fields.number("angle")?,
        ])
    });
    Ok(Group {
        place: [fields.number("x")?, fields.number("y")?],
        angle: fields.angle("angle")?,
        derivatives: derivatives.collect::<Result<_, _>>()?,
    })
}

fn rational(angle: &Angle) -> Option<Point<Exact>> {
    let turn = angle.exact()?.cis();
    let part = |x: &Number<crate::number::Surd>| Some(Number::from(x.0.rational()?.clone()));
    Some(Number::complex(part(turn.re())?, part(turn.im())?))
}

/// The motions, by their Taylor series.
fn groups<K: Kind>(
    given: &[Group],
    rotation: impl Fn(&Angle) -> Option<Point<K>>,
) -> Option<Groups<K>> {
    let motions = given.iter().map(|one| {
        let order = one.derivatives.len();
        let mut factorial = 1i64;
        let terms = one.derivatives.iter().zip(1..).map(|(derivative, power)| {
            factorial *= power;
            derivative
                .each_ref()
                .map(|value| Number::<K>::from(Rational::from(value / factorial)))
        });
        let terms: Vec<[Number<K>; 3]> = terms.collect();
        let start = one
            .place
            .each_ref()
            .map(|value| Number::<K>::from(value.clone()));
        let [x, y] = start;
        let shifts = terms
            .iter()
            .map(|[x, y, _]| Number::complex(x.clone(), y.clone()));
        let shift: Vec<Point<K>> = std::iter::once(Number::complex(x, y))
            .chain(shifts)
            .collect();
        let angles = terms.iter().map(|[_, _, angle]| angle.clone());
        let angle = Number::from_coefficients(std::iter::once(Number::zero()).chain(angles), order);
        let rotation = rotation(&one.angle)?;
        let constant = Number::complex(rotation.re().clone().into(), rotation.im().clone().into());
        Some(Displacement {
            rotation: turn(&angle) * constant,
            translation: path(&shift, order),
        })
    });
    motions.collect::<Option<_>>().map(Groups)
}
