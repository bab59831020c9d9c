//! Problem in, certified answer out.

mod focal_mechanism;
mod hart;
mod input;
mod output;
mod sharpen;
mod slider_crank_alternates;

use serde_json::{Map, Value, json};
use thiserror::Error;

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
pub const PROBLEMS: [&str; 3] = ["focal-mechanism", "hart", "slider-crank-alternates"];

/// Solves one problem, given and answered as JSON.
///
/// # Errors
/// A problem of an unknown kind, with a missing, unknown or wrong field.
pub fn solve(problem: &Value, request: &Request) -> Result<Value, ProblemError> {
    let fields = input::Fields::of(problem)?;
    let name = fields.name()?;
    let answer = match name {
        "focal-mechanism" => focal_mechanism::answer(&fields, request)?,
        "hart" => hart::answer(&fields, request)?,
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
