//! The finite pairs of an answer: each in a box that holds exactly one solution, all different, in order
//! and as many as the answer says.

use std::cmp::Ordering;

use serde_json::{Value, json};

use super::alternates;
use super::conditions::{Conditions, Five};
use super::geometry::Sheet;
use super::newton::{self, Vector};
use super::shown::{Coordinate, Shown, list, point};
use super::{Defect, require};
use crate::number::{Exact, Number, array, count};
use crate::plane::Point;

/// How often the precision is doubled before a pair is said to be none.
const EFFORTS: u32 = 3;

/// A finite pair of the answer.
pub struct Pair {
    /// As listed.
    shown: [Coordinate; 4],
    /// In a box that holds one pair only; as listed where it is multiple.
    pub enclosure: Vector,
    pub multiplicity: usize,
    pub is_real: bool,
}

/// All pairs that an answer lists.
pub struct Pairs<'a> {
    pub finite: Vec<Pair>,
    pub at_infinity: &'a [Value],
}

impl<'a> Pairs<'a> {
    /// Reads and checks each of them.
    pub fn of(five: &impl Five, sheet: &Sheet<'a>) -> Result<Self, Defect> {
        let answer = sheet.answer;
        let mut finite = Vec::new();
        for (name, is_real) in [("pairs", true), ("complex_pairs", false)] {
            for value in list(answer, name)? {
                finite.push(pair(five, value, name, is_real, sheet)?);
            }
        }
        let pairs = Pairs {
            finite,
            at_infinity: list(answer, "at_infinity")?,
        };
        pairs.counts(answer)?;
        pairs.order()?;
        pairs.different()?;
        certificate(answer)?;
        Ok(pairs)
    }

    pub fn is_empty(&self) -> bool {
        self.finite.is_empty() && self.at_infinity.is_empty()
    }

    /// How many there are, those that are finite and all.
    pub fn totals(&self) -> [usize; 2] {
        let finite = self.finite.iter().map(|pair| pair.multiplicity).sum();
        [finite, finite + self.at_infinity.len()]
    }

    pub fn real(&self) -> impl Iterator<Item = &Pair> {
        self.finite.iter().filter(|pair| pair.is_real)
    }

    fn counts(&self, answer: &Value) -> Result<(), Defect> {
        let count = |is_real: bool| -> usize {
            let kind = self.finite.iter().filter(|pair| pair.is_real == is_real);
            kind.map(|pair| pair.multiplicity).sum()
        };
        let at_infinity = self.at_infinity.len();
        let right =
            json!({"real": count(true), "complex": count(false), "at_infinity": at_infinity});
        require(
            answer["counts"] == right,
            "counts",
            "the counts are not those of the lists",
        )
    }

    /// By x, then y.
    fn order(&self) -> Result<(), Defect> {
        let real: Vec<&Pair> = self.real().collect();
        for (one, next) in array::neighbours(&real) {
            let ([x, y, ..], [u, v, ..]) = (&one.enclosure, &next.enclosure);
            let sorted = match x.re().compare(u.re()) {
                Some(order) if order.is_ne() => order.is_lt(),
                _ => y.re().compare(v.re()).is_none_or(Ordering::is_le),
            };
            require(sorted, "pairs", "the pairs are not sorted by x, then y")?;
        }
        Ok(())
    }

    fn different(&self) -> Result<(), Defect> {
        for (place, a) in self.finite.iter().enumerate() {
            for b in self.finite.iter().skip(place + 1) {
                let apart =
                    a.enclosure.iter().zip(&b.enclosure).any(|(x, y)| {
                        !x.re().0.overlaps(&y.re().0) || !x.im().0.overlaps(&y.im().0)
                    });
                require(apart, "pairs", "one pair is listed twice")?;
            }
        }
        Ok(())
    }
}

impl Pair {
    pub fn listed(&self) -> alternates::Listed<'_> {
        alternates::Listed {
            entries: &self.enclosure,
            multiplicity: self.multiplicity,
            is_real: self.is_real,
        }
    }

    /// Circlepoint and center, where they are listed exactly.
    pub fn exactly(&self) -> Option<[Point<Exact>; 2]> {
        let parts = self.shown.each_ref().map(|part| &part.re);
        let number = |part: &Shown| Number::<Exact>::from(part.value.clone());
        let [x, y, cx, cy] = parts.map(number);
        let is_exact = parts.iter().all(|part| part.is_exact());
        is_exact.then(|| [Number::complex(x, y), Number::complex(cx, cy)])
    }
}

fn pair(
    five: &impl Five,
    value: &Value,
    name: &str,
    is_real: bool,
    sheet: &Sheet<'_>,
) -> Result<Pair, Defect> {
    if value["circlepoint"].is_null() || value["center"].is_null() {
        return Err(Defect::unchecked("the answer leaves pairs undecided"));
    }
    let [x, y] = point(&value["circlepoint"], name, sheet.digits)?;
    let [cx, cy] = point(&value["center"], name, sheet.digits)?;
    let shown = [x, y, cx, cy];
    let real_parts = shown
        .iter()
        .all(|part| part.im.is_exact() && part.im.value.is_zero());
    require(
        real_parts == is_real,
        name,
        "real and complex pairs are mixed up",
    )?;
    let multiplicity = value["multiplicity"].as_u64();
    let multiplicity = multiplicity.map_or(0, count::from_u64);
    require(
        (1..=4).contains(&multiplicity),
        name,
        "a multiplicity from 1 to 4 was expected",
    )?;
    let start = shown.each_ref().map(|part| part.ball(sheet.bits));
    let enclosure = if multiplicity == 1 {
        simple(five, &shown, name, is_real, sheet.bits)?
    } else {
        start
    };
    Ok(Pair {
        shown,
        enclosure,
        multiplicity,
        is_real,
    })
}

/// The box around a simple pair, which must lie within what is listed.
fn simple(
    five: &impl Five,
    shown: &[Coordinate; 4],
    name: &str,
    is_real: bool,
    bits: u32,
) -> Result<Vector, Defect> {
    let mut message = "no pair fulfils the circle conditions there";
    for effort in 0..=EFFORTS {
        let bits = bits << effort;
        let conditions = Conditions::enclosed(five, bits);
        let start = shown.each_ref().map(|part| part.ball(bits));
        if let Some(enclosure) = newton::enclosed(&conditions, &start, is_real, bits) {
            let pairs = || shown.iter().zip(&enclosure);
            if pairs().all(|(part, truth)| part.holds(truth)) {
                return Ok(enclosure);
            }
            message = "the digits do not hold the pair next to them";
            // An enclosure that is wider than the digits may be narrowed.
            if !pairs().all(|(part, truth)| part.meets(truth, bits)) {
                break;
            }
        }
    }
    Err(Defect::wrong(name, message))
}

fn certificate(answer: &Value) -> Result<(), Defect> {
    let verified = answer
        .pointer("/certificate/krawczyk")
        .and_then(Value::as_array);
    let pairs = list(answer, "pairs")?.len();
    require(
        verified.is_some_and(|verified| verified.len() == pairs),
        "certificate.krawczyk",
        "one entry for each pair was expected",
    )
}
