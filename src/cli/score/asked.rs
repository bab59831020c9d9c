//! One problem: asked, answered, judged.

use std::time::Duration;

use burmester::oracle::score::corpus::{Corpus, Problem};
use burmester::oracle::score::{Case, Outcome};
use serde_json::Value;

use crate::cli::candidate::{Candidate, Silence};

/// A case, and the line that it rests on.
pub struct Asked {
    pub case: Case,
    pub line: Option<String>,
}

/// Asks one problem; an error where the candidate does not work at all.
pub fn ask(
    candidate: &mut Candidate,
    corpus: &Corpus,
    problem: &Problem,
    limit: Duration,
) -> Result<Asked, String> {
    let (answer, time) = candidate.ask(&problem.problem.to_string(), limit);
    let (outcome, line) = match answer {
        Err(Silence::DoesNotWork(reason)) => return Err(reason),
        Err(Silence::Lost(reason)) => (Outcome::Lost(reason), None),
        Ok(line) => match outcome(problem, &line) {
            Ok(outcome) => (outcome, Some(line)),
            Err(reason) => {
                // What comes next may belong to this line still.
                candidate.restart();
                (Outcome::Lost(reason), Some(line))
            }
        },
    };
    Ok(Asked {
        case: Case {
            corpus: corpus.name.clone(),
            id: problem.id.clone(),
            kind: problem.kind.clone(),
            degenerate: problem.reference.is_degenerate(),
            outcome,
            seconds: time.as_secs_f64(),
        },
        line,
    })
}

/// What a line says; an error where it does not keep to the protocol.
fn outcome(problem: &Problem, line: &str) -> Result<Outcome, String> {
    let value: Value = serde_json::from_str(line).map_err(|error| {
        let shown = around(line, error.column());
        format!("its line is no JSON ({error}): {shown}")
    })?;
    let said = |name: &str| {
        value.get(name).map(|text| match text {
            Value::String(text) => text.clone(),
            other => other.to_string(),
        })
    };
    if let Some(reason) = said("skipped") {
        return Ok(Outcome::Skipped(reason));
    }
    if let Some(reason) = said("error") {
        return Ok(Outcome::Lost(format!("it says: {reason}")));
    }
    let result = value.get("result").ok_or_else(|| {
        format!(
            "its line has neither result nor skipped nor error: {}",
            around(line, 0)
        )
    })?;
    for place in [&value, result] {
        if let Some(Value::String(id)) = place.get("id")
            && *id != problem.id
        {
            return Err(format!(
                "it answers the problem `{id}`, which was not asked"
            ));
        }
    }
    let verdict = problem
        .reference
        .judge(&problem.problem, result)
        .map_err(|error| format!("its result is no answer: {error}"))?;
    Ok(if verdict.stated {
        Outcome::Scored(verdict)
    } else if verdict.is_clean() {
        Outcome::Skipped("its result states nothing that is scored".to_owned())
    } else {
        Outcome::Scored(verdict)
    })
}

/// What stands before and after a place of a line.
fn around(line: &str, column: usize) -> String {
    let first = column.saturating_sub(40);
    let dots = if first > 0 { "…" } else { "" };
    let shown: String = line.trim().chars().skip(first).take(60).collect();
    format!("{dots}{shown}")
}
