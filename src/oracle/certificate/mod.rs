//! The checker: whether an answer is right, told without the solver that made it.
//!
//! What a checker covers, each kind by conditions that define the answer:
//!
//! - `five-positions`: that every pair fulfils the circle conditions (each in a box that provably holds
//!   exactly one), that the digits hold it, that all are different, none missing and none invented (four
//!   simple pairs are all there can be; else by two eliminants on a route of their own, with
//!   multiplicities), counts, order, pairs at infinity, eliminant, family, what is left beside the known
//!   pairs; of every linkage with at most one joint at infinity type, cranks, circuit, branch, order and
//!   transmission angle. Not estimates of conditioning, nor `defects`, which are words for the same.
//! - `mixed-positions`: the same, where what a squared distance has of t, t², … takes the place of the
//!   positions that came together.
//! - `curvature`: the pairs likewise; pole, inflection circle, invariants, Ball's point and how often it counts, polodes, centers
//!   of curvature and orders of contact by the first terms of the paths; both curves by stationary
//!   curvature, and what is said of them.
//! - `centerpoint-curve`: the poles, the coefficients of both curves by the loop closure, type, focus,
//!   asymptote, midline and double points by the curve's own equation, the quadrilaterals.
//! - `poles`, `three-positions`: the points with one place in two positions, the turns; the circles by
//!   the area of three places, the pairs by the distances from three places.
//! - `hart`, `focal-mechanism`: that the lengths stay in many positions, that there are as many
//!   mechanisms, how the crank moves.
//! - `slider-crank-alternates`: that A, B, C, D keep their distances up to the fourth order, and that
//!   there are no others.
//!
//! Not covered, and said so where it is asked for: what is said of wishes; pairs beside a family; poles
//! that may be finite or not; linkages of two joints at infinity, degenerate ones, and those with a
//! position that is a dead centre itself. What an answer names as undecided is not checked, all else of
//! it is.

mod all_pairs;
mod alternates;
mod centerpoint_curve;
mod closure;
pub(super) mod conditions;
mod curve;
mod dyads;
mod eliminant;
mod elimination;
mod family;
mod fitted;
mod five_positions;
mod focal_mechanism;
mod frame;
mod geometry;
mod hart;
mod known;
mod linkages;
mod mixed_positions;
mod newton;
mod one_position;
mod pairs;
mod paths;
mod poles;
mod quadrilateral;
mod rest;
mod roots;
mod shown;
mod slider_crank_alternates;
mod three_positions;
mod way;

use serde_json::Value;
use thiserror::Error;

use super::input::Fields;
use super::positions::Given;
use crate::number::Complex;
use conditions::{Conditions, Five};
use rest::Rest;

/// Enough for floats.
const BITS: u32 = 128;

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
    let mut rest = Rest::default();
    rest.after(check_kind(name, &fields, answer))?;
    if fields.has("positions") && name != "mixed-positions" {
        let given = Given::read(&fields, 1, usize::MAX).map_err(refused)?;
        rest.after(fitted::check(&given, answer))?;
    }
    if fields.has("wishes") {
        rest.after(Err(Defect::unchecked("what is said of the wishes")))?;
    }
    rest.finish()
}

/// What a pair must fulfil, in floats; `None` for a problem that does not ask for pairs.
pub(super) fn conditions_in_floats(problem: &Value) -> Option<Conditions<Complex<f64>>> {
    let fields = Fields::of(problem).ok()?;
    let groups = match fields.name().ok()? {
        "five-positions" => Given::read(&fields, 5, 5).ok()?.enclosed(BITS),
        "mixed-positions" => mixed_positions::Given::read(&fields).ok()?.enclosed(BITS),
        "curvature" => one_position::Given::read(&fields).ok()?.enclosed(BITS),
        _ => return None,
    };
    Some(Conditions::in_floats(&groups))
}

/// What belongs to a kind of problem alone.
fn check_kind(name: &str, fields: &Fields<'_>, answer: &Value) -> Result<(), Defect> {
    let refused = |error: super::ProblemError| Defect::wrong("problem", error.to_string());
    let given = |least, most| Given::read(fields, least, most).map_err(refused);
    match name {
        "five-positions" => {
            let known = alternates::Known::read(fields).map_err(refused)?;
            five_positions::check(&given(5, 5)?, &known, answer)
        }
        "centerpoint-curve" => centerpoint_curve::check(&given(4, 4)?, answer),
        "three-positions" => {
            let given = three_positions::Given::read(fields).map_err(refused)?;
            three_positions::check(&given, answer)
        }
        "poles" => poles::check(&given(2, 9)?, answer),
        "hart" => hart::check(&hart::Given::read(fields).map_err(refused)?, answer),
        "focal-mechanism" => {
            let given = focal_mechanism::Given::read(fields).map_err(refused)?;
            focal_mechanism::check(&given, answer)
        }
        "slider-crank-alternates" => {
            let given = slider_crank_alternates::Given::read(fields).map_err(refused)?;
            slider_crank_alternates::check(&given, answer)
        }
        "mixed-positions" => {
            let given = mixed_positions::Given::read(fields).map_err(refused)?;
            mixed_positions::check(&given, answer)
        }
        "curvature" => {
            let given = one_position::Given::read(fields).map_err(refused)?;
            one_position::check(&given, answer)
        }
        other => Err(Defect::unchecked(format!("no checker for {other}"))),
    }
}
