//! Reading regions of the plane.

use super::ProblemError;
use super::input::Fields;
use super::positions::point;
use crate::number::Exact;
use crate::plane::Point;
use crate::plane::region::{Region, is_simple};

/// More vertices than this are not read: whether a polygon meets itself is asked of every two edges.
const MOST_VERTICES: usize = 500;

const SHAPES: [&str; 3] = ["box", "circle", "polygon"];

/// A field with a region, if there is one.
pub fn read(fields: &Fields<'_>, name: &str) -> Result<Option<Region<Exact>>, ProblemError> {
    let region = fields.optional_object(name)?;
    region.map(|fields| region_of(&fields)).transpose()
}

fn region_of(fields: &Fields<'_>) -> Result<Region<Exact>, ProblemError> {
    fields.only(&SHAPES)?;
    match SHAPES.map(|name| fields.has(name)) {
        [true, false, false] => rectangle(fields),
        [false, true, false] => circle(fields),
        [false, false, true] => polygon(fields),
        _ => Err(fields.error(
            "box",
            "exactly one of box, circle, polygon was expected here",
        )),
    }
}

fn rectangle(fields: &Fields<'_>) -> Result<Region<Exact>, ProblemError> {
    match fields.points("box")?.as_slice() {
        [p, q] => Ok(Region::Box([point(p), point(q)])),
        list => Err(fields.error(
            "box",
            format!(
                "two opposite corners were expected, not {} points",
                list.len()
            ),
        )),
    }
}

fn circle(fields: &Fields<'_>) -> Result<Region<Exact>, ProblemError> {
    let circle = fields.object("circle")?;
    circle.only(&["center", "radius"])?;
    Ok(Region::Circle {
        center: point(&circle.point("center")?),
        radius: circle.positive("radius")?.into(),
    })
}

fn polygon(fields: &Fields<'_>) -> Result<Region<Exact>, ProblemError> {
    let vertices: Vec<Point<Exact>> = fields.points("polygon")?.iter().map(point).collect();
    if vertices.len() < 3 || vertices.len() > MOST_VERTICES {
        return Err(fields.error(
            "polygon",
            format!(
                "3 to {MOST_VERTICES} vertices were expected, not {}",
                vertices.len()
            ),
        ));
    }
    if !is_simple(&vertices).is_yes() {
        return Err(fields.error(
            "polygon",
            "the polygon meets itself; one whose edges have only neighbouring ends in common was expected",
        ));
    }
    Ok(Region::Polygon(vertices))
}
