//! Linkages with a point that keeps to a line, with their arcs in floats: for a picture they need no
//! enclosure, and they take no time.

use serde_json::Value;

use super::{Entry, GalleryError};
use crate::ledger::Paper;
use crate::linkage::cognates::CouplerPoint;
use crate::number::{Complex, Number};
use crate::oracle;
use crate::report::complex::Z;
use crate::report::deviation::{Arc, Figure, Points};
use crate::report::number;
use crate::scenes::{self, free::Given};
use crate::straight_line::design::Design;
use crate::straight_line::deviation::driven::Driven;
use crate::straight_line::deviation::floats;

/// The linkage of a problem about deviations.
pub fn of_design(entry: &Entry, problem: &Value) -> Result<String, GalleryError> {
    let found = oracle::design(problem)
        .map_err(|error| GalleryError::Problem(entry.title.clone(), error))?;
    let levels = problem["levels"].as_array().into_iter().flatten();
    let levels: Vec<f64> = levels.filter_map(number).collect();
    found
        .and_then(|design| draw(&design, &levels, &entry.title))
        .ok_or_else(|| GalleryError::Nothing(entry.title.clone()))
}

/// The linkage of a printed example.
pub fn of_example(entry: &Entry, papers: &[Paper]) -> Result<String, GalleryError> {
    let nothing = || GalleryError::Nothing(entry.title.clone());
    let name = entry.example.as_deref().ok_or_else(nothing)?;
    let wanted = format!(": {name}");
    let (statement, example) = papers
        .iter()
        .flat_map(|paper| &paper.statements)
        .filter(|statement| statement.id.starts_with(&entry.beside))
        .filter_map(|statement| Some((statement, statement.example.as_ref()?)))
        .find(|(_, example)| example.name.ends_with(&wanted))
        .ok_or_else(nothing)?;
    let free = &mut Given::<f64>::new(&example.given, ());
    let drawn = scenes::drawn_linkage(statement.scene.name, free).ok_or_else(nothing)?;
    let (design, levels) =
        drawn.map_err(|unbuilt| GalleryError::Unbuilt(entry.title.clone(), unbuilt))?;
    draw(&design, &levels, &entry.title).ok_or_else(nothing)
}

fn draw(design: &Design<f64>, levels: &[f64], title: &str) -> Option<String> {
    let driven = Driven::new(&standing(design))?;
    let closed = driven.closed();
    let arc = |bound: &f64| {
        let arc = floats::arc(&closed, *bound)?;
        Some(Arc {
            bound: *bound,
            ends: arc.ends.map(|end| end.degrees),
        })
    };
    let figure = Figure {
        title: title.to_owned(),
        arcs: levels.iter().filter_map(arc).collect(),
        driven,
    };
    let every_ten_degrees = Points {
        name: "every 10° of the crank at A, from the design position on".to_owned(),
        deviation: figure.deviations(10.0),
        second: Vec::new(),
    };
    figure.draw(&every_ten_degrees)
}

/// The same with O_a in the origin, O_b on the x-axis and the unit length as unit.
fn standing(design: &Design<f64>) -> Design<f64> {
    let CouplerPoint {
        pivots: [o_a, o_b],
        pins,
        point,
    } = &design.linkage;
    let base: Z = o_b - o_a;
    let length = base.norm().sqrt();
    let turn: Number<Complex<f64>> = base.conj().scaled(&length.inverse());
    let scaled = turn.scaled(&design.unit().inverse());
    let place = |at: &Z| (at - o_a) * &scaled;
    Design {
        linkage: CouplerPoint {
            pivots: [place(o_a), place(o_b)],
            pins: pins.each_ref().map(place),
            point: place(point),
        },
        direction: &design.direction * turn,
    }
}
