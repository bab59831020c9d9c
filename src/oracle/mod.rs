//! Problem in, certified answer out.

mod centerpoint_curve;
pub mod certificate;
mod curve_wishes;
mod five_positions;
mod focal_mechanism;
mod four_bar;
mod geometry;
mod hart;
mod input;
mod linkages;
mod numeral;
mod output;
mod poles;
mod positions;
mod regions;
pub mod score;
mod sharpen;
mod slider_crank_alternates;
mod straight_line;
mod stretches;
mod three_positions;
pub mod vectors;
mod wishes;

pub use straight_line::chart;

use serde_json::{Map, Value, json};
use thiserror::Error;

use crate::plane::displacement::Displacement;
use crate::straight_line::design::Design;

/// What to compute with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Arithmetic {
    /// Exact numbers where they suffice, else balls: every answer is certified.
    #[default]
    Certified,
    /// Floats: fast, nothing certified.
    Float,
}

/// How an answer is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Significant digits.
    pub digits: u32,
    /// What to compute with.
    pub arithmetic: Arithmetic,
}

impl Default for Request {
    fn default() -> Self {
        Request {
            digits: 30,
            arithmetic: Arithmetic::Certified,
        }
    }
}

/// What is wrong with a problem, and at which place in it.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{place}: {message}")]
pub struct ProblemError {
    /// The path to the place, like `alpha_a.degrees`.
    pub place: String,
    /// What is wrong and what was expected.
    pub message: String,
}

impl ProblemError {
    fn new(place: &str, message: impl Into<String>) -> Self {
        ProblemError {
            place: place.to_owned(),
            message: message.into(),
        }
    }
}

/// The kinds of problem that [`solve`] knows.
pub const PROBLEMS: [&str; 12] = [
    "centerpoint-curve",
    "curvature",
    "deviation",
    "five-positions",
    "focal-mechanism",
    "four-bar",
    "hart",
    "mixed-positions",
    "poles",
    "slider-crank-alternates",
    "straight-line",
    "three-positions",
];

/// The positions of the moving plane that a problem gives, in floats: for pictures.
///
/// # Errors
/// A problem without positions, or with wrong ones.
pub fn displacements(problem: &Value) -> Result<Vec<Displacement<f64>>, ProblemError> {
    let given = positions::Given::read(&input::Fields::of(problem)?, 1, usize::MAX)?;
    Ok(given.rounded::<f64>(&()).displacements().to_vec())
}

/// The directions of the rays of A and D that a slider-crank is given by, in floats: for pictures.
///
/// # Errors
/// A problem without these angles, or with wrong ones.
pub fn rays(problem: &Value) -> Result<[[f64; 2]; 2], ProblemError> {
    let fields = input::Fields::of(problem)?;
    let ray = |name: &str| {
        let angle = fields.angle(name)?.rounded::<f64>(&());
        Ok([angle.cos().0, angle.sin().0])
    };
    Ok([ray("alpha_a")?, ray("alpha_d")?])
}

/// The linkage that a problem of the kind `deviation` is about, in floats: for pictures. `None` where there
/// is no such linkage.
///
/// # Errors
/// A problem without a design or without levels, or with wrong ones.
pub fn design(problem: &Value) -> Result<Option<Design<f64>>, ProblemError> {
    straight_line::deviation::design(&input::Fields::of(problem)?)
}

/// Solves one problem, given and answered as JSON.
///
/// # Errors
/// A problem of an unknown kind, with a missing, unknown or wrong field.
pub fn solve(problem: &Value, request: &Request) -> Result<Value, ProblemError> {
    let fields = input::Fields::of(problem)?;
    let name = fields.name()?;
    let answer = match name {
        "centerpoint-curve" => centerpoint_curve::answer(&fields, request)?,
        "curvature" => five_positions::curvature::answer(&fields, request)?,
        "deviation" => straight_line::deviation::answer(&fields, request)?,
        "five-positions" => five_positions::answer(&fields, request)?,
        "focal-mechanism" => focal_mechanism::answer(&fields, request)?,
        "four-bar" => four_bar::answer(&fields, request)?,
        "hart" => hart::answer(&fields, request)?,
        "mixed-positions" => five_positions::mixed::answer(&fields, request)?,
        "poles" => poles::answer(&fields, request)?,
        "straight-line" => straight_line::answer(&fields, request)?,
        "three-positions" => three_positions::answer(&fields, request)?,
        "slider-crank-alternates" => slider_crank_alternates::answer(&fields, request)?,
        unknown => {
            return Err(ProblemError::new(
                "problem",
                format!(
                    "unknown problem `{unknown}`; expected {}",
                    PROBLEMS.join(", ")
                ),
            ));
        }
    };
    let mut whole = Map::new();
    whole.insert("problem".into(), json!(name));
    if let Some(id) = problem.get("id") {
        whole.insert("id".into(), id.clone());
    }
    whole.insert("digits".into(), json!(request.digits));
    whole.extend(answer);
    Ok(Value::Object(whole))
}
