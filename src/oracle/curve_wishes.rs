//! Reading what a designer wishes of a center and its circlepoint.

use super::ProblemError;
use super::input::Fields;
use super::positions::point;
use crate::finite::positions::Positions;
use crate::finite::stretches::congruent_pencils::Dyad;
use crate::finite::stretches::wishes::{Beside, Wishes};
use crate::linkage::passage::Drive;
use crate::number::{Exact, Number};
use crate::plane::region_edges::{Region, crosses_itself};
use crate::plane::{Point, relation};

/// The fields that need a link given beside the one that is sought.
const OF_LINKAGES: [&str; 3] = ["driver", "crank_driven", "without_defects"];

/// The field `wishes`; `None` where there is none.
pub fn read(
    fields: &Fields<'_>,
    positions: Option<&Positions<Exact>>,
) -> Result<Option<Wishes>, ProblemError> {
    let Some(wishes) = fields.object("wishes")? else {
        return Ok(None);
    };
    let known = ["pivots_within", "circlepoints_within", "in_order", "beside"];
    wishes.only(&[&known[..], &OF_LINKAGES].concat())?;
    let beside = match wishes.object("beside")? {
        Some(dyad) => Some(beside(&wishes, &dyad, positions)?),
        None => None,
    };
    if beside.is_none()
        && let Some(name) = OF_LINKAGES.into_iter().find(|name| wishes.has(name))
    {
        return Err(wishes.error(name, "this needs a link given by \"beside\""));
    }
    Ok(Some(Wishes {
        centers: region(&wishes, "pivots_within")?,
        circlepoints: region(&wishes, "circlepoints_within")?,
        in_order: wishes.flag("in_order")?,
        beside,
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
    let is_circle = squares
        .windows(2)
        .all(|pair| pair[0].equals(&pair[1]).is_yes());
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

fn region(wishes: &Fields<'_>, name: &str) -> Result<Option<Region>, ProblemError> {
    let Some(fields) = wishes.object(name)? else {
        return Ok(None);
    };
    fields.only(&["box", "circle", "polygon"])?;
    let given: Vec<&str> = ["box", "circle", "polygon"]
        .into_iter()
        .filter(|shape| fields.has(shape))
        .collect();
    match given.as_slice() {
        ["box"] => rectangle(&fields),
        ["circle"] => circle(&fields),
        ["polygon"] => polygon(&fields),
        _ => Err(wishes.error(name, "one of box, circle, polygon was expected")),
    }
    .map(Some)
}

fn rectangle(fields: &Fields<'_>) -> Result<Region, ProblemError> {
    let corners = fields.points("box")?;
    let [[x0, y0], [x1, y1]] = corners.as_slice() else {
        let message = format!("two opposite corners were expected, not {}", corners.len());
        return Err(fields.error("box", message));
    };
    if x0 == x1 || y0 == y1 {
        return Err(fields.error("box", "the box has no inside"));
    }
    let corner = |x: &rug::Rational, y: &rug::Rational| point(&[x.clone(), y.clone()]);
    let corners = vec![
        corner(x0, y0),
        corner(x1, y0),
        corner(x1, y1),
        corner(x0, y1),
    ];
    Ok(Region::Polygon(corners))
}

fn circle(fields: &Fields<'_>) -> Result<Region, ProblemError> {
    let Some(circle) = fields.object("circle")? else {
        return Err(fields.error("circle", "this field is missing"));
    };
    circle.only(&["center", "radius"])?;
    Ok(Region::Circle {
        center: point(&circle.point("center")?),
        radius: circle.positive("radius")?.into(),
    })
}

fn polygon(fields: &Fields<'_>) -> Result<Region, ProblemError> {
    let corners: Vec<Point<Exact>> = fields.points("polygon")?.iter().map(point).collect();
    if corners.len() < 3 {
        let message = format!(
            "three corners at least were expected, not {}",
            corners.len()
        );
        return Err(fields.error("polygon", message));
    }
    if crosses_itself(&corners) {
        let message = "the sides of a polygon must meet in its corners only";
        return Err(fields.error("polygon", message));
    }
    Ok(Region::Polygon(corners))
}
