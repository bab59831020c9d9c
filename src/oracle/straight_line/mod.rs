//! `straight-line`: linkages of which a point goes nearly straight.

pub mod chart;
pub mod deviation;
mod given;
mod iterated;
mod solution;
mod writer;

use serde_json::{Map, Value};

use super::input::Fields;
use super::output::into_floats;
use super::sharpen::sharpen;
use super::{Arithmetic, ProblemError, Request};
use crate::number::{Ball, Surd};
use crate::straight_line::ball_burmester::Alternate;
use crate::straight_line::no_design::NoDesign;
use given::{Closed, Given};
use solution::{Exactly, Rounded, Solution, closed};

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["design"])?;
    let (given, alternates) = given::read(&fields.object("design")?)?;
    let mut answer = sharpen(request.digits, |attempt| match &given {
        Given::Iterated(iterated) => match iterated.solve(&alternates, attempt.bits) {
            Ok(outcome) => attempt.outcome(&outcome, &iterated.range),
            Err(reason) => attempt.no_solution(&reason),
        },
        Given::Closed(given) => match exactly(given, &alternates) {
            Some(Ok(solutions)) => attempt.solutions(&solutions),
            Some(Err(reason)) => attempt.no_solution(&reason),
            None => match closed::<Ball>(given, &alternates, &Rounded(attempt.bits)) {
                Some(Ok(solutions)) => attempt.solutions(&solutions),
                Some(Err(reason)) => attempt.no_solution(&reason),
                None => attempt.no_solution(&NoDesign::Undecided),
            },
        },
    });
    if request.arithmetic == Arithmetic::Float {
        answer.values_mut().for_each(into_floats);
    }
    Ok(answer)
}

/// The solutions in exact numbers, where these hold all of them.
fn exactly(
    given: &Closed,
    alternates: &[Alternate],
) -> Option<Result<Vec<Solution<Surd>>, NoDesign>> {
    match closed(given, alternates, &Exactly)? {
        Ok(solutions) => solutions
            .iter()
            .all(Solution::is_whole)
            .then_some(Ok(solutions)),
        Err(NoDesign::Undecided) => None,
        Err(reason) => Some(Err(reason)),
    }
}
