//! `focal-mechanism`: the crank drives of a four-bar, all focal mechanisms whose crank support S
//! divides the base in a given ratio.

use serde_json::{Map, Value, json};

use super::input::Fields;
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, ProblemError, Request, output};
use crate::linkage::crank_drive::{Crank, CrankDrive, crank_drives};
use crate::linkage::four_bar::FourBar;
use crate::number::{Ball, Number, Real, Surd};

/// What a mechanism's numbers are called.
const NUMBERS: [&str; 9] = ["lambda", "m", "n", "p", "q", "MS", "AT", "r", "t"];

struct Problem {
    sides: [rug::Rational; 4],
    rho: rug::Rational,
}

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["a", "b", "c", "d", "rho"])?;
    let mut sides = Vec::new();
    for name in ["a", "b", "c", "d"] {
        sides.push(fields.positive(name)?);
    }
    let rho = fields.number("rho")?;
    if rho.is_zero() || rho == -1 {
        return Err(ProblemError::new(
            "rho",
            "the ratio mp : nq is neither 0 nor -1; at -1 the point S is at infinity: see problem `hart`",
        ));
    }
    let sides = sides
        .try_into()
        .map_err(|_| ProblemError::new("problem", "four sides were expected"))?;
    let problem = Problem { sides, rho };
    Ok(match request.arithmetic {
        Arithmetic::Float => problem.float(),
        Arithmetic::Certified => problem.certified(request.digits),
    })
}

impl Problem {
    /// `None` where this arithmetic cannot tell how many are real.
    fn mechanisms<K: Real>(&self, precision: &K::Precision) -> Option<Vec<Mechanism<K>>> {
        let number = |q: &rug::Rational| Number::<K>::rounded(q, precision);
        let [a, b, c, d] = self.sides.each_ref().map(number);
        let four_bar = FourBar { a, b, c, d };
        let drives = crank_drives(&four_bar, &number(&self.rho))?;
        Some(
            drives
                .iter()
                .map(|drive| Mechanism::of(drive, &four_bar))
                .collect(),
        )
    }

    /// Where exact numbers hold everything, they decide; balls give the digits of the rest.
    fn certified(&self, digits: u32) -> Map<String, Value> {
        let exact = self.mechanisms::<Surd>(&());
        sharpen(digits, |attempt| {
            let balls = self.mechanisms::<Ball>(&attempt.bits);
            answer_of(attempt, exact.as_deref(), balls.as_deref())
        })
    }

    fn float(&self) -> Map<String, Value> {
        let mut fields = Map::new();
        let list = self.mechanisms::<f64>(&()).unwrap_or_default();
        fields.insert("count".into(), json!(list.len()));
        let list: Vec<Value> = list.iter().map(float_mechanism).collect();
        fields.insert("mechanisms".into(), json!(list));
        fields
    }
}

/// What the answer tells of a mechanism.
struct Mechanism<K> {
    numbers: [Number<K>; 9],
    crank: Option<Crank>,
}

impl<K: Real> Mechanism<K> {
    fn of(drive: &CrankDrive<K>, four_bar: &FourBar<K>) -> Self {
        let (ms, at) = drive.divisions(four_bar);
        let CrankDrive {
            lambda,
            m,
            n,
            p,
            q,
            r,
            t,
        } = drive.clone();
        Mechanism {
            numbers: [lambda, m, n, p, q, ms, at, r.abs(), t.abs()],
            crank: drive.crank(four_bar),
        }
    }
}

fn answer_of(
    attempt: &mut Attempt,
    exact: Option<&[Mechanism<Surd>]>,
    balls: Option<&[Mechanism<Ball>]>,
) -> Map<String, Value> {
    let mut fields = Map::new();
    let count = exact.map(<[_]>::len).or(balls.map(<[_]>::len));
    let count = attempt.decided("count", count.map(|count| json!(count)));
    fields.insert("count".into(), count);
    let known = exact.map_or(0, <[_]>::len).max(balls.map_or(0, <[_]>::len));
    let mut list = Vec::new();
    for place in 0..known {
        let exact = exact.and_then(|mechanisms| mechanisms.get(place));
        let ball = balls.and_then(|mechanisms| mechanisms.get(place));
        list.push(mechanism(attempt, exact, ball));
    }
    fields.insert("mechanisms".into(), json!(list));
    fields
}

fn mechanism(
    attempt: &mut Attempt,
    exact: Option<&Mechanism<Surd>>,
    ball: Option<&Mechanism<Ball>>,
) -> Value {
    let mut fields = Map::new();
    for (place, name) in NUMBERS.into_iter().enumerate() {
        let exact = exact.and_then(|mechanism| mechanism.numbers.get(place));
        let ball = ball.and_then(|mechanism| mechanism.numbers.get(place));
        fields.insert(name.into(), attempt.number(name, exact, ball));
    }
    let crank = exact
        .and_then(|mechanism| mechanism.crank)
        .or_else(|| ball?.crank);
    let crank = attempt.decided("crank", crank.map(|crank| json!(word(crank))));
    fields.insert("crank".into(), crank);
    Value::Object(fields)
}

fn word(crank: Crank) -> &'static str {
    match crank {
        Crank::Turns => "turns",
        Crank::ChangePoint => "change-point",
        Crank::Rocks => "rocks",
    }
}

fn float_mechanism(mechanism: &Mechanism<f64>) -> Value {
    let mut fields = Map::new();
    for (name, number) in NUMBERS.into_iter().zip(&mechanism.numbers) {
        fields.insert(name.into(), output::float(number.0));
    }
    fields.insert("crank".into(), json!(mechanism.crank.map(word)));
    Value::Object(fields)
}
