//! For the tests of other programs: a problem in, its certified answer out, and a comparison with what
//! a program in `f64` found.
//!
//! ```
//! use burmester::testing::{Expected, Pair, Position};
//!
//! // x, y and the angle in radians, taken exactly as the doubles that they are.
//! let positions = [
//!     (0.0, 0.0, 0.0), (3.0, 1.0, 0.4), (5.0, 1.0, 0.65), (6.0, -1.0, 1.2), (5.0, -4.0, 1.6),
//! ]
//! .map(|(x, y, angle)| Position { x, y, angle });
//! let expected = Expected::five_positions(&positions)?;
//!
//! // What the solver under test would find.
//! let found: Vec<Pair> = expected.pairs();
//! let comparison = expected.compare_pairs(&found)?;
//! assert!(comparison.is_right(), "{comparison}");
//! assert!(comparison.most_ulps() <= 0.5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Every other problem that [`solve`] knows is given and compared as JSON:
//!
//! ```
//! use burmester::testing::Expected;
//! use serde_json::json;
//!
//! let expected = Expected::of(json!({
//!     "problem": "slider-crank-alternates",
//!     "k": "1/2",
//!     "alpha_a": {"tan_half": "3/4"},
//!     "alpha_d": {"cos": "3/5", "sin": "4/5"},
//! }))?;
//! assert!(expected.compare(&json!({"PO_a": 0.48}))?.is_right());
//! let comparison = expected.compare(&json!({"PO_a": 0.84}))?;
//! assert!(comparison.to_string().contains("PO_a: missed"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod comparison;

use rug::{Float, Rational};
use serde_json::{Value, json};
use thiserror::Error;

pub use comparison::Comparison;

use crate::number::text::parse_rational;
use crate::oracle::score::{Misread, Reference};
use crate::oracle::vectors::condition;
use crate::oracle::{ProblemError, Request, solve};

/// A position of the moving plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position {
    /// Where its origin is.
    pub x: f64,
    /// Where its origin is.
    pub y: f64,
    /// By how much it is turned, in radians.
    pub angle: f64,
}

/// A point of the moving plane and the center of the circle on which it lies in all positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// In the moving plane.
    pub circlepoint: [f64; 2],
    /// In the fixed plane.
    pub center: [f64; 2],
}

/// What is wrong with a problem or with what is compared with its answer.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum TestingError {
    /// A problem that cannot be solved.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// What is no answer to this problem.
    #[error(transparent)]
    Misread(#[from] Misread),
    /// A number that is infinite or none.
    #[error("{0} is not finite")]
    NotFinite(&'static str),
}

/// A problem with its certified answer.
#[derive(Clone, Debug)]
pub struct Expected {
    problem: Value,
    answer: Value,
    condition: Option<f64>,
    reference: Reference,
}

impl Expected {
    /// Solves a problem, given as JSON, with 50 digits.
    ///
    /// # Errors
    /// A problem that cannot be solved.
    pub fn of(problem: Value) -> Result<Self, TestingError> {
        let request = Request {
            digits: 50,
            ..Request::default()
        };
        let answer = solve(&problem, &request)?;
        let condition = condition(&problem, &answer);
        let name = problem
            .get("problem")
            .and_then(Value::as_str)
            .unwrap_or_default();
        let reference = Reference::read(name, &answer, &condition)?;
        Ok(Expected {
            condition: condition.as_f64(),
            problem,
            answer,
            reference,
        })
    }

    /// All Burmester pairs of five positions.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn five_positions(positions: &[Position; 5]) -> Result<Self, TestingError> {
        Self::of(problem("five-positions", positions)?)
    }

    /// Centerpoint curve and circlepoint curve of four positions.
    ///
    /// # Errors
    /// A number that is not finite.
    pub fn four_positions(positions: &[Position; 4]) -> Result<Self, TestingError> {
        Self::of(problem("centerpoint-curve", positions)?)
    }

    /// The problem, as `burmester solve` takes it.
    pub fn problem(&self) -> &Value {
        &self.problem
    }

    /// The certified answer, as `burmester solve` gives it.
    pub fn answer(&self) -> &Value {
        &self.answer
    }

    /// An estimate of the relative change of the answer per relative change of the problem; `None` where
    /// the answer becomes one of another form, as for degenerate problems.
    pub fn condition(&self) -> Option<f64> {
        self.condition
    }

    /// The real Burmester pairs of five positions that have both points at finite places, rounded to
    /// doubles; of another problem none.
    pub fn pairs(&self) -> Vec<Pair> {
        let pairs = self.answer.get("pairs").and_then(Value::as_array);
        let pairs = pairs.into_iter().flatten();
        pairs
            .filter_map(|pair| {
                Some(Pair {
                    circlepoint: rounded(&pair["circlepoint"])?,
                    center: rounded(&pair["center"])?,
                })
            })
            .collect()
    }

    /// Compares an answer that is given as a candidate of `burmester score` gives it. What it does not
    /// state is not judged.
    ///
    /// # Errors
    /// What is no answer to such a problem.
    pub fn compare(&self, answer: &Value) -> Result<Comparison, TestingError> {
        let verdict = self.reference.judge(&self.problem, answer)?;
        Ok(Comparison::new(
            verdict,
            self.condition,
            self.reference.tolerance(),
        ))
    }

    /// Compares Burmester pairs, in any order.
    ///
    /// # Errors
    /// A number that is not finite, or another problem than that of five positions.
    pub fn compare_pairs(&self, pairs: &[Pair]) -> Result<Comparison, TestingError> {
        let point = |[x, y]: [f64; 2]| -> Result<Value, TestingError> {
            Ok(json!([
                exact(x, "a coordinate")?,
                exact(y, "a coordinate")?
            ]))
        };
        let list: Result<Vec<Value>, TestingError> = pairs
            .iter()
            .map(|pair| {
                Ok(json!({
                    "circlepoint": point(pair.circlepoint)?,
                    "center": point(pair.center)?,
                }))
            })
            .collect();
        self.compare(&json!({"pairs": list?}))
    }
}

fn problem(name: &str, positions: &[Position]) -> Result<Value, TestingError> {
    let list: Result<Vec<Value>, TestingError> = positions
        .iter()
        .map(|Position { x, y, angle }| {
            Ok(json!({
                "x": exact(*x, "x")?,
                "y": exact(*y, "y")?,
                "angle": {"radians": exact(*angle, "the angle")?},
            }))
        })
        .collect();
    Ok(json!({"problem": name, "positions": list?}))
}

/// The number that a double is: a shortest decimal would be another one.
fn exact(x: f64, name: &'static str) -> Result<String, TestingError> {
    let number = Rational::from_f64(x).ok_or(TestingError::NotFinite(name))?;
    Ok(number.to_string())
}

fn rounded(point: &Value) -> Option<[f64; 2]> {
    let coordinate = |value: &Value| {
        let text = value.get("exact").or_else(|| value.get("value"))?;
        let number = parse_rational(text.as_str()?).ok()?;
        Some(Float::with_val(53, number).to_f64())
    };
    Some([coordinate(point.get(0)?)?, coordinate(point.get(1)?)?])
}
