//! Whether an answer to positions of which some have come together lists all pairs and nothing else, and
//! what linkages they make in the positions that are apart.

use rug::Rational;
use serde_json::Value;

use super::conditions::{Five, Group};
use super::geometry::Sheet;
use super::pairs::Pairs;
use super::rest::Rest;
use super::{Defect, all_pairs, dyads};
use crate::number::{Ball, Exact, Kind, Number, Surd, count};
use crate::oracle::ProblemError;
use crate::oracle::input::{Angle, Fields};
use crate::plane::Point;
use crate::plane::displacement::Displacement;

/// Positions as they were given, each with its derivatives.
pub struct Given(Vec<Position>);

struct Position {
    angle: Angle,
    /// x, y and the angle in radians with what they change by tⁿ: their derivatives over n!. The angle
    /// itself stands apart.
    terms: Vec<[Rational; 3]>,
}

impl Given {
    /// Reads them.
    pub fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        let list = fields.list("positions")?.iter();
        let positions = list.map(|value| Position::read(&Fields::at(value, "positions")?));
        Ok(Given(positions.collect::<Result<_, _>>()?))
    }
}

impl Position {
    fn read(fields: &Fields<'_>) -> Result<Self, ProblemError> {
        let start = [fields.number("x")?, fields.number("y")?, Rational::new()];
        let mut terms = vec![start];
        let mut factorial = Rational::from(1);
        let derivatives = fields.has("derivatives");
        let derivatives = derivatives
            .then(|| fields.list("derivatives"))
            .transpose()?;
        for (value, order) in derivatives.unwrap_or_default().iter().zip(1_u64..) {
            let derivative = Fields::at(value, "derivatives")?;
            factorial *= order;
            let term = |name: &str| Ok(derivative.number(name)? / &factorial);
            terms.push([term("x")?, term("y")?, term("angle")?]);
        }
        Ok(Position {
            angle: fields.angle("angle")?,
            terms,
        })
    }

    /// From r' = iφ'r: n rₙ = i Σ k φₖ rₙ₋ₖ.
    fn group<K: Kind>(&self, start: Point<K>) -> Group<K> {
        let mut turns = vec![start];
        for n in 1..self.terms.len() {
            let earlier = self
                .terms
                .iter()
                .zip(0i64..)
                .skip(1)
                .zip(turns.iter().rev());
            let sum: Point<K> = earlier
                .map(|(([_, _, angle], k), turn)| {
                    turn * Point::<K>::from(Rational::from(angle * k))
                })
                .sum();
            turns.push(Number::i() * sum / count::to_i64(n));
        }
        let shifts = self.terms.iter().map(|[x, y, _]| {
            let [x, y] = [x, y].map(|part| Number::from(part.clone()));
            Number::complex(x, y)
        });
        let terms = turns.into_iter().zip(shifts);
        terms
            .map(|(rotation, translation)| Displacement {
                rotation,
                translation,
            })
            .collect()
    }
}

impl Five for Given {
    fn enclosed(&self, bits: u32) -> Vec<Group<Ball>> {
        let start = |position: &Position| position.angle.rounded::<Ball>(&bits).cis();
        let all = self.0.iter();
        all.map(|position| position.group(start(position)))
            .collect()
    }

    fn exact(&self) -> Option<Vec<Group<Exact>>> {
        let number = |x: &Number<Surd>| Some(Number::<Exact>::from(x.0.rational()?.clone()));
        let all = self.0.iter().map(|position| {
            let turn = position.angle.exact()?.cis();
            Some(position.group(Number::complex(number(turn.re())?, number(turn.im())?)))
        });
        all.collect()
    }
}

/// Checks everything but estimates.
pub fn check(given: &Given, answer: &Value) -> Result<(), Defect> {
    let sheet = Sheet::of(answer)?;
    let pairs = Pairs::of(given, &sheet)?;
    let mut rest = Rest::default();
    rest.after(dyads::linkages(given, &pairs, &sheet))?;
    rest.after(all_pairs::check(given, &pairs, &sheet))?;
    rest.finish()
}
