//! Reading what a designer wishes of a center and its circlepoint.

use super::input::{Angle, Fields};
use super::positions::point;
use super::wishes::least_angle;
use super::{ProblemError, regions};
use crate::finite::positions::Positions;
use crate::finite::stretches::congruent_pencils::Dyad;
use crate::finite::stretches::wishes::{Beside, LeastTransmission, Wishes};
use crate::linkage::passage::Drive;
use crate::number::{Ball, Exact, Number, array};
use crate::plane::region::Region;
use crate::plane::{Point, relation};

/// The fields that need a link given beside the one that is sought.
const OF_LINKAGES: [&str; 4] = [
    "driver",
    "crank_driven",
    "without_defects",
    "least_transmission_angle",
];

/// Wishes as they are read: one of them is known to as many bits as one likes.
pub struct Wished {
    wishes: Wishes,
    least_transmission_angle: Option<Angle>,
}

impl Wished {
    /// The wishes, with bounds that differ by about 2^−bits where they are not rational.
    pub fn bounded(&self, bits: u32) -> Option<Wishes> {
        let mut wishes = self.wishes.clone();
        if let (Some(angle), Some(beside)) = (&self.least_transmission_angle, &mut wishes.beside) {
            let square_of_cosine = square_of_cosine(angle, bits)?;
            beside.least_transmission = Some(LeastTransmission { square_of_cosine });
        }
        Some(wishes)
    }
}

/// Two bounds, the same where it is rational.
fn square_of_cosine(angle: &Angle, bits: u32) -> Option<[Number<Exact>; 2]> {
    let exact = angle.exact().map(|angle| angle.cos().square());
    if let Some(square) = exact.as_ref().and_then(|square| square.0.rational()) {
        return Some([square.clone().into(), square.clone().into()]);
    }
    let square = angle.rounded::<Ball>(&bits).cos().square().0;
    Some([square.lower()?.into(), square.upper()?.into()])
}

/// The field `wishes`; `None` where there is none.
pub fn read(
    fields: &Fields<'_>,
    positions: Option<&Positions<Exact>>,
) -> Result<Option<Wished>, ProblemError> {
    let Some(wishes) = fields.optional_object("wishes")? else {
        return Ok(None);
    };
    let known = ["pivots_within", "circlepoints_within", "in_order", "beside"];
    wishes.only(&[&known[..], &OF_LINKAGES].concat())?;
    let beside = match wishes.optional_object("beside")? {
        Some(dyad) => Some(beside(&wishes, &dyad, positions)?),
        None => None,
    };
    if beside.is_none()
        && let Some(name) = OF_LINKAGES.into_iter().find(|name| wishes.has(name))
    {
        return Err(wishes.error(name, "this needs a link given by \"beside\""));
    }
    Ok(Some(Wished {
        least_transmission_angle: least_angle(&wishes)?,
        wishes: Wishes {
            centers: region(&wishes, "pivots_within")?,
            circlepoints: region(&wishes, "circlepoints_within")?,
            in_order: wishes.flag("in_order")?,
            beside,
        },
    }))
}

fn beside(
    wishes: &Fields<'_>,
    dyad: &Fields<'_>,
    positions: Option<&Positions<Exact>>,
) -> Result<Beside, ProblemError> {
    dyad.only(&["circlepoint", "center"])?;
    let given = Dyad {
        circlepoint: point(&dyad.point("circlepoint")?),
        center: point(&dyad.point("center")?),
    };
    if let Some(positions) = positions {
        check_circle(wishes, &given, positions)?;
    }
    Ok(Beside {
        given,
        drive: match wishes.word("driver", &["given", "sought"])? {
            Some("sought") => Drive::Second,
            _ => Drive::First,
        },
        crank_driven: wishes.flag("crank_driven")?,
        without_defects: wishes.flag("without_defects")?,
        least_transmission: None,
    })
}

/// The circlepoint must be equally far from its center in all positions.
fn check_circle(
    wishes: &Fields<'_>,
    given: &Dyad<Point<Exact>>,
    positions: &Positions<Exact>,
) -> Result<(), ProblemError> {
    let squares: Vec<Number<Exact>> = positions
        .displacements()
        .iter()
        .map(|d| relation::distance_squared(&d.of(&given.circlepoint), &given.center))
        .collect();
    let is_circle = array::neighbours(&squares).all(|(one, next)| one.equals(next).is_yes());
    if is_circle {
        return Ok(());
    }
    let float =
        |square: &Number<Exact>| square.0.rational().map_or(f64::NAN, |q| q.to_f64().sqrt());
    let lengths: Vec<String> = squares
        .iter()
        .map(|square| float(square).to_string())
        .collect();
    Err(wishes.error(
        "beside",
        format!(
            "the circlepoint must be equally far from the center in all positions; the distances \
             are {}",
            lengths.join(", ")
        ),
    ))
}

/// A region through whose inside a curve can run.
fn region(wishes: &Fields<'_>, name: &str) -> Result<Option<Region<Exact>>, ProblemError> {
    let region = regions::read(wishes, name)?;
    if let Some(Region::Box([p, q])) = &region {
        let diagonal = p - q;
        if (diagonal.re() * diagonal.im()).is_zero().is_yes() {
            return Err(wishes.error(&format!("{name}.box"), "the box has no inside"));
        }
    }
    Ok(region)
}
