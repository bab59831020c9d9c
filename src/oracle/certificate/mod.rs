//! The checker: whether an answer is right, told without the solver that made it.
//!
//! What a checker covers:
//!
//! - `five-positions`: that every pair fulfils the circle conditions (each in a box that provably holds
//!   exactly one), that the digits hold it, that all are different, none missing and none invented (four
//!   simple pairs are all there can be; else by two eliminants on a route of their own, with
//!   multiplicities), counts, order, pairs at infinity, eliminant, family. Not what is said of the
//!   linkages, but which pairs they are made of.
//! - `centerpoint-curve`: the poles and the coefficients of both curves, by a route of their own.
//! - `poles`, `three-positions`: the poles by their defining equations, the turns, the pairs by their
//!   distances.
//!
//! Other kinds have no checker yet, and say so.

mod centerpoint_curve;
mod curve;
mod family;
mod five_positions;
mod focal_mechanism;
mod geometry;
mod hart;
mod known;
mod newton;
mod poles;
mod quadrilateral;
mod rest;
mod roots;
mod shown;
mod slider_crank_alternates;
mod three_positions;

use serde_json::Value;
use thiserror::Error;

use super::input::Fields;
use super::positions::Given;

/// What is wrong with an answer.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum Defect {
    /// Something in it is false.
    #[error("{place}: {message}")]
    Wrong {
        /// The field.
        place: String,
        /// What is wrong there.
        message: String,
    },
    /// It is not known whether the answer is right.
    #[error("not checked: {reason}")]
    Unchecked {
        /// Why not.
        reason: String,
    },
}

impl Defect {
    fn wrong(place: &str, message: impl Into<String>) -> Self {
        Defect::Wrong {
            place: place.to_owned(),
            message: message.into(),
        }
    }

    fn unchecked(reason: impl Into<String>) -> Self {
        Defect::Unchecked {
            reason: reason.into(),
        }
    }
}

/// Passes where a condition is fulfilled.
fn require(condition: bool, place: &str, message: &str) -> Result<(), Defect> {
    if condition {
        Ok(())
    } else {
        Err(Defect::wrong(place, message))
    }
}

/// Checks a certified answer against its problem; see the module for what that covers.
///
/// # Errors
/// What is wrong, or that this answer cannot be checked; never silently nothing.
pub fn check_answer(problem: &Value, answer: &Value) -> Result<(), Defect> {
    let refused = |error: super::ProblemError| Defect::wrong("problem", error.to_string());
    let fields = Fields::of(problem).map_err(refused)?;
    let name = fields.name().map_err(refused)?;
    require(
        answer["problem"] == name,
        "problem",
        "the answer is to another kind of problem",
    )?;
    let given = |least, most| Given::read(&fields, least, most).map_err(refused);
    match name {
        "five-positions" => five_positions::check(&given(5, 5)?, answer),
        "centerpoint-curve" => centerpoint_curve::check(&given(4, 4)?, answer),
        "three-positions" => {
            let given = three_positions::Given::read(&fields).map_err(refused)?;
            three_positions::check(&given, answer)
        }
        "poles" => poles::check(&given(2, 9)?, answer),
        "hart" => hart::check(&hart::Given::read(&fields).map_err(refused)?, answer),
        "focal-mechanism" => {
            let given = focal_mechanism::Given::read(&fields).map_err(refused)?;
            focal_mechanism::check(&given, answer)
        }
        "slider-crank-alternates" => {
            let given = slider_crank_alternates::Given::read(&fields).map_err(refused)?;
            slider_crank_alternates::check(&given, answer)
        }
        other => Err(Defect::unchecked(format!("no checker for {other} yet"))),
    }
}
