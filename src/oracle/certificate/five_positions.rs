//! Whether an answer to five positions lists all pairs and nothing else.

use rug::Rational;
use serde_json::{Value, json};

use super::alternates::{Known, Listed as Finite};
use super::geometry::Sheet;
use super::linkages;
use super::newton::{self, Vector};
use super::rest::Rest;
use super::roots::{self, Listed};
use super::shown::{Coordinate, Shown, digits, list, point};
use super::{Defect, alternates, dyads, eliminant, family, require};
use crate::finite::positions::Positions;
use crate::number::exact::primitive;
use crate::number::{Ball, Complex, Exact, Number};
use crate::oracle::positions::Given;
use crate::plane::Point;
use crate::plane::displacement::Displacement;

type Entry = Number<Complex<Ball>>;
type Five<K> = [Displacement<K>; 5];

/// How often the precision is doubled before a pair is said to be none.
const EFFORTS: u32 = 3;

/// A finite pair of the answer.
struct Pair {
    /// As listed.
    shown: [Coordinate; 4],
    /// In a box that holds one pair only; as listed where it is multiple.
    enclosure: Vector,
    multiplicity: usize,
    is_real: bool,
}

/// Checks everything but estimates and what is said of wishes.
pub fn check(given: &Given, known: &[Known], answer: &Value) -> Result<(), Defect> {
    let digits = digits(answer)?;
    let bits = digits.saturating_mul(8).saturating_add(256);
    let mut pairs = Vec::new();
    for (name, is_real) in [("pairs", true), ("complex_pairs", false)] {
        for value in list(answer, name)? {
            pairs.push(pair(given, value, name, is_real, digits, bits)?);
        }
    }
    let at_infinity = list(answer, "at_infinity")?;
    counts(answer, &pairs, at_infinity)?;
    order(&pairs)?;
    different(&pairs)?;
    certificate(answer)?;
    let sheet = Sheet {
        answer,
        digits,
        bits,
    };
    let mut rest = Rest::default();
    rest.after(linkages(given, &pairs, at_infinity, &sheet))?;
    let finite: Vec<Finite<'_>> = pairs.iter().map(Pair::listed).collect();
    let left = &answer["alternates"];
    rest.after(alternates::check(known, &finite, at_infinity, left, digits))?;
    rest.after(all_pairs(given, &pairs, at_infinity, &sheet))?;
    rest.finish()
}

/// Whether the pairs are all that there are.
fn all_pairs(
    given: &Given,
    pairs: &[Pair],
    at_infinity: &[Value],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let Sheet {
        answer,
        digits,
        bits,
    } = *sheet;
    let exact = given.rational().and_then(|positions| five(&positions));
    let undecided = answer["undecided"].as_str().unwrap_or_default();
    if undecided.split(", ").any(|name| name == "family") {
        return Err(Defect::unchecked("the answer leaves the family undecided"));
    }
    if !answer["family"].is_null() {
        require(
            answer["eliminant"].is_null(),
            "eliminant",
            "families have none",
        )?;
        let exact = exact.ok_or_else(|| Defect::unchecked("a family of enclosed positions"))?;
        family::check(&exact, &answer["family"])?;
        return if pairs.is_empty() && at_infinity.is_empty() {
            Ok(())
        } else {
            Err(Defect::unchecked(
                "that no pair beside the family is missing",
            ))
        };
    }
    match exact {
        Some(exact) => of_rational(&exact, answer, pairs, at_infinity, digits, bits),
        None => of_enclosed(answer, pairs, at_infinity),
    }
}

fn five<K: Clone + crate::number::Kind>(positions: &Positions<K>) -> Option<Five<K>> {
    positions.displacements().to_vec().try_into().ok()
}

fn pair(
    given: &Given,
    value: &Value,
    name: &str,
    is_real: bool,
    digits: u32,
    bits: u32,
) -> Result<Pair, Defect> {
    if value["circlepoint"].is_null() || value["center"].is_null() {
        return Err(Defect::unchecked("the answer leaves pairs undecided"));
    }
    let [x, y] = point(&value["circlepoint"], name, digits)?;
    let [cx, cy] = point(&value["center"], name, digits)?;
    let shown = [x, y, cx, cy];
    let real_parts = shown
        .iter()
        .all(|part| part.im.is_exact() && part.im.value.is_zero());
    require(
        real_parts == is_real,
        name,
        "real and complex pairs are mixed up",
    )?;
    let multiplicity = value["multiplicity"].as_u64().unwrap_or_default() as usize;
    require(
        (1..=4).contains(&multiplicity),
        name,
        "a multiplicity from 1 to 4 was expected",
    )?;
    let start = shown.each_ref().map(|part| part.ball(bits));
    let enclosure = if multiplicity == 1 {
        simple(given, &shown, name, is_real, bits)?
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
    given: &Given,
    shown: &[Coordinate; 4],
    name: &str,
    is_real: bool,
    bits: u32,
) -> Result<Vector, Defect> {
    let mut message = "no pair fulfils the circle conditions there";
    for effort in 0..=EFFORTS {
        let bits = bits << effort;
        let Some(positions) = five(&given.rounded::<Ball>(&bits)) else {
            break;
        };
        let start = shown.each_ref().map(|part| part.ball(bits));
        if let Some(enclosure) = newton::enclosed(&positions, &start, is_real, bits) {
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

fn counts(answer: &Value, pairs: &[Pair], at_infinity: &[Value]) -> Result<(), Defect> {
    let count = |is_real: bool| -> usize {
        let kind = pairs.iter().filter(|pair| pair.is_real == is_real);
        kind.map(|pair| pair.multiplicity).sum()
    };
    let right =
        json!({"real": count(true), "complex": count(false), "at_infinity": at_infinity.len()});
    require(
        answer["counts"] == right,
        "counts",
        "the counts are not those of the lists",
    )
}

/// By x, then y.
fn order(pairs: &[Pair]) -> Result<(), Defect> {
    let real: Vec<&Pair> = pairs.iter().filter(|pair| pair.is_real).collect();
    for two in real.windows(2) {
        if let [a, b] = two {
            let compare = |axis: usize| a.enclosure[axis].re().compare(b.enclosure[axis].re());
            let sorted = match compare(0) {
                Some(order) if order.is_ne() => order.is_lt(),
                _ => compare(1).is_none_or(std::cmp::Ordering::is_le),
            };
            require(sorted, "pairs", "the pairs are not sorted by x, then y")?;
        }
    }
    Ok(())
}

fn different(pairs: &[Pair]) -> Result<(), Defect> {
    for (place, a) in pairs.iter().enumerate() {
        for b in pairs.iter().skip(place + 1) {
            let apart = a
                .enclosure
                .iter()
                .zip(&b.enclosure)
                .any(|(x, y)| !x.re().0.overlaps(&y.re().0) || !x.im().0.overlaps(&y.im().0));
            require(apart, "pairs", "one pair is listed twice")?;
        }
    }
    Ok(())
}

fn certificate(answer: &Value) -> Result<(), Defect> {
    let verified = answer["certificate"]["krawczyk"].as_array();
    let pairs = list(answer, "pairs")?.len();
    require(
        verified.is_some_and(|verified| verified.len() == pairs),
        "certificate.krawczyk",
        "one entry for each pair was expected",
    )
}

/// Every two pairs once, in order, finite ones before those at infinity; and what is said of them.
fn linkages(
    given: &Given,
    pairs: &[Pair],
    at_infinity: &[Value],
    sheet: &Sheet<'_>,
) -> Result<(), Defect> {
    let linkages = list(sheet.answer, "linkages")?;
    let finite = list(sheet.answer, "pairs")?.len();
    let mut names: Vec<Value> = (0..finite).map(Value::from).collect();
    for (place, pair) in at_infinity.iter().enumerate() {
        let is_new = place == 0 || at_infinity[place - 1] != *pair;
        if is_new && pair["kind"] != "isotropic" {
            names.push(json!({"at_infinity": place}));
        }
    }
    let every = names.iter().enumerate().flat_map(|(place, one)| {
        let others = names.iter().skip(place + 1);
        others.map(move |other| json!([one, other]))
    });
    let listed = linkages.iter().map(|linkage| linkage["pairs"].clone());
    require(
        listed.eq(every),
        "linkages",
        "not every two pairs, once each",
    )?;
    let real = pairs.iter().filter(|pair| pair.is_real);
    let real = real.map(|pair| (&pair.enclosure, pair.exactly()));
    let finite = dyads::finite(given, real, sheet.bits);
    let infinite = dyads::infinite(given, at_infinity, sheet)?;
    let named = |name: &Value| {
        let (list, place) = match name.as_u64() {
            Some(place) => (&finite, Some(place)),
            None => (&infinite, name["at_infinity"].as_u64()),
        };
        list.get(usize::try_from(place?).ok()?)
    };
    let mut rest = Rest::default();
    for linkage in linkages {
        if let [Some(first), Some(second)] =
            [0, 1].map(|side: usize| named(&linkage["pairs"][side]))
        {
            rest.after(linkages::check([first, second], linkage, sheet))?;
        }
    }
    rest.finish()
}

impl Pair {
    fn listed(&self) -> Finite<'_> {
        Finite {
            entries: &self.enclosure,
            multiplicity: self.multiplicity,
            is_real: self.is_real,
        }
    }

    /// Circlepoint and center, where they are listed exactly.
    fn exactly(&self) -> Option<[Point<Exact>; 2]> {
        let parts = self.shown.each_ref().map(|part| &part.re);
        let number = |part: &Shown| Number::<Exact>::from(part.value.clone());
        let [x, y, cx, cy] = parts.map(number);
        let is_exact = parts.iter().all(|part| part.is_exact());
        is_exact.then(|| [Number::complex(x, y), Number::complex(cx, cy)])
    }
}

/// Four simple finite pairs are all that two conics can have in common.
fn of_enclosed(answer: &Value, pairs: &[Pair], at_infinity: &[Value]) -> Result<(), Defect> {
    require(
        answer["eliminant"].is_null(),
        "eliminant",
        "there is none for input that is not rational",
    )?;
    if !at_infinity.is_empty() || pairs.iter().any(|pair| pair.multiplicity > 1) {
        return Err(Defect::unchecked(
            "multiple pairs and pairs at infinity of enclosed positions",
        ));
    }
    require(
        pairs.len() == 4,
        "pairs",
        "there are four pairs, counted with those that are not real",
    )
}

fn of_rational(
    positions: &Five<Exact>,
    answer: &Value,
    pairs: &[Pair],
    at_infinity: &[Value],
    digits: u32,
    bits: u32,
) -> Result<(), Defect> {
    let total: usize = pairs.iter().map(|pair| pair.multiplicity).sum();
    if total + at_infinity.len() == 0 && family::has_no_pair(positions) {
        return Ok(());
    }
    require(
        total + at_infinity.len() == 4,
        "counts",
        "there are four pairs, counted with those that are not real or at infinity",
    )?;
    let four_simple = total == 4 && pairs.iter().all(|pair| pair.multiplicity == 1);
    if !four_simple {
        by_elimination(positions, pairs, at_infinity, digits, bits)?;
    }
    eliminant(positions, answer, pairs, at_infinity)
}

/// Both points of all pairs, by two eliminations, and the pairs at infinity.
fn by_elimination(
    positions: &Five<Exact>,
    pairs: &[Pair],
    at_infinity: &[Value],
    digits: u32,
    bits: u32,
) -> Result<(), Defect> {
    let inverse = positions.each_ref().map(Displacement::inverse);
    let listed = |offset: usize| {
        pairs.iter().map(move |pair| Listed {
            point: [
                pair.enclosure[offset].clone(),
                pair.enclosure[offset + 1].clone(),
            ],
            multiplicity: pair.multiplicity,
        })
    };
    let mut circlepoints: Vec<Listed> = listed(0).collect();
    let mut centers: Vec<Listed> = listed(2).collect();
    for value in at_infinity {
        match value["kind"].as_str() {
            Some("center") => {
                let point = point(&value["circlepoint"], "at_infinity", digits)?;
                along_a_line(positions, &point, &value["direction"], bits)?;
                circlepoints.push(Listed::single(&point, bits));
            }
            Some("circlepoint") => {
                let point = point(&value["center"], "at_infinity", digits)?;
                along_a_line(&inverse, &point, &value["direction"], bits)?;
                centers.push(Listed::single(&point, bits));
            }
            Some("isotropic") => {}
            _ => return Err(Defect::wrong("at_infinity", "an unknown kind")),
        }
    }
    roots::check(positions, &circlepoints, "circlepoints", bits)?;
    roots::check(&inverse, &centers, "centers", bits)
}

impl Listed {
    fn single(point: &[Coordinate; 2], bits: u32) -> Self {
        Listed {
            point: point.each_ref().map(|part| part.ball(bits)),
            multiplicity: 1,
        }
    }
}

/// Whether the places of a point lie along a line, across the direction.
fn along_a_line(
    positions: &Five<Exact>,
    point: &[Coordinate; 2],
    direction: &Value,
    bits: u32,
) -> Result<(), Defect> {
    let place = "at_infinity";
    let [x, y] = [&direction[0], &direction[1]].map(|part| Shown::read(part, place));
    let (x, y) = (x?, y?);
    let first = if x.value.is_zero() { &y } else { &x };
    require(
        !first.is_exact() || first.value.cmp0().is_gt(),
        place,
        "the first part of a primitive direction is positive",
    )?;
    let across: Number<Complex<Ball>> = Number::complex(x.ball(bits), y.ball(bits));
    let z: Entry = Number::complex(point[0].re.ball(bits), point[1].re.ball(bits));
    let places = positions.each_ref().map(|position| {
        let turn = enclosed(&position.rotation, bits);
        turn * &z + enclosed(&position.translation, bits)
    });
    let [first, rest @ ..] = &places;
    let fits = rest.iter().all(|other| {
        let along = (other - first) * across.conj();
        along.re().0.contains(&Rational::new())
    });
    require(
        fits,
        place,
        "the point does not move along a line across the direction",
    )
}

fn enclosed(z: &Number<Complex<Exact>>, bits: u32) -> Entry {
    let part =
        |x: &Number<Exact>| Number::rounded(&x.0.rational().cloned().unwrap_or_default(), &bits);
    Number::complex(part(z.re()), part(z.im()))
}

/// The product of z + x over all finite pairs, as primitive integers.
fn eliminant(
    positions: &Five<Exact>,
    answer: &Value,
    pairs: &[Pair],
    at_infinity: &[Value],
) -> Result<(), Defect> {
    let place = "eliminant";
    let integers = eliminant::integers(&answer[place], place)?;
    let total: usize = pairs.iter().map(|pair| pair.multiplicity).sum();
    require(
        integers.len() == total + 1,
        place,
        "its degree is not the number of finite pairs",
    )?;
    let slides = at_infinity.iter().any(|value| value["kind"] == "center");
    if !slides && let Some(polynomial) = roots::eliminant(positions, [-1, 0]) {
        let coefficients = polynomial.coefficients().iter().rev();
        let own: Option<Vec<Rational>> = coefficients.map(|c| c.0.rational().cloned()).collect();
        let same = own.is_some_and(|own| primitive(&own) == integers);
        return require(same, place, "an independent elimination gives another one");
    }
    let own: Vec<(&Entry, usize)> = pairs
        .iter()
        .map(|pair| (&pair.enclosure[0], pair.multiplicity))
        .collect();
    eliminant::is_of_roots(&answer[place], place, &own)
}
