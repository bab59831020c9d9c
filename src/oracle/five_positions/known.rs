//! Pairs that are known already, and the alternates: those that are left.

use serde_json::{Value, json};

use super::Five;
use super::found::Real;
use crate::finite::five_positions::conditions::{Coordinates, of_pair, of_slide, rows};
use crate::finite::five_positions::conics::Isolated;
use crate::number::exact::primitive;
use crate::number::{Exact, Number};
use crate::oracle::ProblemError;
use crate::oracle::input::Fields;
use crate::oracle::positions::point;
use crate::plane::Point;

/// Pairs that the problem names.
pub type Known = Vec<Coordinates<Exact>>;

/// Reads the field `known`, which may be missing: circlepoints with their centers, which may be at
/// infinity.
pub fn read(fields: &Fields<'_>, positions: Option<&Five<Exact>>) -> Result<Known, ProblemError> {
    if !fields.has("known") {
        return Ok(Known::new());
    }
    let Some(positions) = positions else {
        return Err(fields.error(
            "known",
            "known pairs need positions with rational coordinates, cosines and sines",
        ));
    };
    let list = fields.list("known")?.iter().enumerate();
    list.map(|(place, value)| {
        let at = format!("known[{place}]");
        let pair = pair(&Fields::at(value, &at)?)?;
        match failing(positions, &pair) {
            None => Ok(pair),
            Some(position) => Err(ProblemError::new(
                &at,
                format!(
                    "this is no circlepoint with its center: in position {position} it is not where \
                     it should be"
                ),
            )),
        }
    })
    .collect()
}

fn pair(fields: &Fields<'_>) -> Result<Coordinates<Exact>, ProblemError> {
    fields.only(&["circlepoint", "center"])?;
    let circlepoint: Point<Exact> = point(&fields.point("circlepoint")?);
    let is_slide = fields.get("center")?.is_object();
    if !is_slide {
        return Ok(of_pair(&circlepoint, &point(&fields.point("center")?)));
    }
    let center = fields.object("center")?;
    center.only(&["at_infinity"])?;
    let direction: Point<Exact> = point(&center.point("at_infinity")?);
    if direction.is_zero().is_yes() {
        return Err(center.error("at_infinity", "a direction that is not zero was expected"));
    }
    Ok(of_slide(&circlepoint, &direction))
}

/// The number of the first position that the pair does not fit.
fn failing(positions: &Five<Exact>, pair: &Coordinates<Exact>) -> Option<usize> {
    let rows = rows(positions);
    let value = |row: &Vec<Number<Exact>>| -> Number<Exact> {
        row.iter().zip(pair).map(|(a, b)| a * b).sum()
    };
    let place = rows.iter().position(|row| !value(row).is_zero().is_yes());
    place.map(|place| place + 2)
}

/// What is left beside the known pairs.
pub struct Alternates {
    rest: Isolated,
}

impl Alternates {
    /// Counts each of the real pairs as often as it is not known. `None` where one of the known pairs
    /// is listed more often than it counts.
    pub fn new(isolated: &Isolated, known: &Known, real: &mut [Real]) -> Option<Self> {
        for pair in known {
            let pair = real.get_mut(isolated.place_of(pair)?)?;
            pair.left = pair.left.checked_sub(1)?;
        }
        let rest = isolated.without(known)?;
        Some(Alternates { rest })
    }

    /// The places of the pairs that are left and the polynomial of the finite ones among them.
    pub fn written(&self, finite: &[&Real], infinite: &[&Real]) -> Value {
        let left = finite.iter().enumerate().filter(|(_, pair)| pair.left > 0);
        let pairs: Vec<usize> = left.map(|(place, _)| place).collect();
        // A multiple one is listed as often as it counts.
        let listed = infinite
            .iter()
            .flat_map(|pair| (0..pair.multiplicity).map(|copy| copy < pair.left));
        let left = listed.enumerate().filter(|(_, is_left)| *is_left);
        let at_infinity: Vec<usize> = left.map(|(place, _)| place).collect();
        let eliminant = self.rest.eliminant().map(|polynomial| {
            let coefficients: Vec<_> = polynomial
                .coefficients()
                .iter()
                .rev()
                .filter_map(|c| c.0.rational().cloned())
                .collect();
            let integers = primitive(&coefficients).into_iter();
            integers
                .map(|integer| integer.to_string())
                .collect::<Vec<_>>()
        });
        json!({
            "pairs": pairs,
            "at_infinity": at_infinity,
            "eliminant": eliminant,
        })
    }
}
