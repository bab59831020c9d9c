//! Whether what is left beside the pairs that a problem names is so.

use rug::Rational;
use serde_json::{Value, json};

use super::shown::{Shown, point};
use super::{Defect, require};
use crate::number::{Ball, Complex, Number};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;

type Entry = Number<Complex<Ball>>;

/// A pair that the problem names.
pub struct Known {
    circlepoint: [Rational; 2],
    center: Center,
}

enum Center {
    Finite([Rational; 2]),
    Towards([Rational; 2]),
}

impl Known {
    /// All that a problem names.
    pub fn read(fields: &Fields<'_>) -> Result<Vec<Self>, ProblemError> {
        if !fields.has("known") {
            return Ok(Vec::new());
        }
        let list = fields.list("known")?.iter();
        list.map(|value| {
            let fields = Fields::at(value, "known")?;
            Ok(Known {
                circlepoint: fields.point("circlepoint")?,
                center: if fields.get("center")?.is_object() {
                    Center::Towards(fields.object("center")?.point("at_infinity")?)
                } else {
                    Center::Finite(fields.point("center")?)
                },
            })
        })
        .collect()
    }

    fn is_finite_pair(&self, [x, y, cx, cy]: &[Entry; 4]) -> bool {
        let Center::Finite(center) = &self.center else {
            return false;
        };
        let coordinates = self.circlepoint.iter().chain(center);
        coordinates.zip([x, y, cx, cy]).all(|(known, entry)| {
            entry.re().0.contains(known) && entry.im().0.contains(&Rational::new())
        })
    }

    fn is_slide(&self, listed: &Value, digits: u32) -> bool {
        let Center::Towards([dx, dy]) = &self.center else {
            return false;
        };
        let point = point(&listed["circlepoint"], "at_infinity", digits);
        let direction = &listed["direction"];
        let part = |axis: usize| Shown::read(&direction[axis], "at_infinity");
        let (Ok(point), Ok(x), Ok(y)) = (point, part(0), part(1)) else {
            return false;
        };
        let bits = 64;
        let across =
            x.ball(bits) * Number::from(dy.clone()) - y.ball(bits) * Number::from(dx.clone());
        let places = point.iter().zip(&self.circlepoint);
        let same = places
            .into_iter()
            .all(|(shown, known)| shown.re.ball(bits).0.contains(known));
        listed["kind"] == "center" && same && !across.is_zero().is_no()
    }
}

/// A finite pair of the answer.
pub struct Listed<'a> {
    pub entries: &'a [Entry; 4],
    pub multiplicity: usize,
    pub is_real: bool,
}

/// Checks the places of the pairs that are left, and the polynomial of their −x.
pub fn check(
    known: &[Known],
    pairs: &[Listed<'_>],
    at_infinity: &[Value],
    shown: &Value,
    digits: u32,
) -> Result<(), Defect> {
    if known.is_empty() {
        return require(shown.is_null(), "alternates", "the problem names no pair");
    }
    if shown.is_null() {
        return Err(Defect::unchecked("what is left beside the known pairs"));
    }
    let times = |pair: &Listed<'_>| {
        let named = known.iter().filter(|one| one.is_finite_pair(pair.entries));
        named.count()
    };
    let left: Option<Vec<usize>> = pairs
        .iter()
        .map(|pair| pair.multiplicity.checked_sub(times(pair)))
        .collect();
    let left = left.ok_or_else(|| Defect::wrong("pairs", "a known pair is missing"))?;
    let real = pairs.iter().zip(&left).filter(|(pair, _)| pair.is_real);
    let places: Vec<usize> = real
        .enumerate()
        .filter(|(_, (_, left))| **left > 0)
        .map(|(place, _)| place)
        .collect();
    require(
        shown["pairs"] == json!(places),
        "alternates.pairs",
        "other pairs are left",
    )?;
    require(
        shown["at_infinity"] == json!(slides_left(known, at_infinity, digits)),
        "alternates.at_infinity",
        "other pairs are left at infinity",
    )?;
    let roots: Vec<(&Entry, usize)> = pairs
        .iter()
        .zip(left)
        .map(|(pair, left)| (&pair.entries[0], left))
        .collect();
    super::eliminant::is_of_roots(&shown["eliminant"], "alternates.eliminant", &roots)
}

/// Of a pair that is listed several times the known copies come last.
fn slides_left(known: &[Known], at_infinity: &[Value], digits: u32) -> Vec<usize> {
    let is_left = |(place, pair): &(usize, &Value)| {
        let named = known
            .iter()
            .filter(|one| one.is_slide(pair, digits))
            .count();
        let copies_from_here = at_infinity.iter().skip(*place);
        copies_from_here.filter(|other| other == pair).count() > named
    };
    let left = at_infinity.iter().enumerate().filter(is_left);
    left.map(|(place, _)| place).collect()
}
