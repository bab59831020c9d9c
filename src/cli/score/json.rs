//! The scores for other programs.

use burmester::oracle::score::{Case, Mark, Outcome, Tally, by_corpus, tallies};
use serde_json::{Value, json};

use super::Run;

/// One object: sums by kind, in total, and every problem.
pub fn report(run: &Run<'_>) -> Value {
    let all: Vec<&Case> = run.cases.iter().collect();
    let kinds: Vec<Value> = tallies(&run.cases)
        .iter()
        .map(|tally| {
            let sums = with(sums(tally), "corpus", &tally.corpus);
            with(sums, "kind", &tally.kind)
        })
        .collect();
    let by_corpus: Vec<Value> = by_corpus(&run.cases)
        .iter()
        .map(|tally| with(sums(tally), "corpus", &tally.corpus))
        .collect();
    let worst: Vec<Value> = run
        .worst()
        .iter()
        .take(super::text::WORST)
        .map(|case| json!({"corpus": case.corpus, "id": case.id, "rerun": run.rerun(case)}))
        .collect();
    let problems: Vec<Value> = run.cases.iter().map(problem).collect();
    json!({
        "command": run.arguments.command,
        "corpora": run.corpora,
        "time_limit": run.arguments.time_limit.as_secs_f64(),
        "clean": run.cases.iter().all(Case::is_clean),
        "total": sums(&Tally::of(&all)),
        "by_corpus": by_corpus,
        "kinds": kinds,
        "worst": worst,
        "problems": problems,
    })
}

fn sums(tally: &Tally) -> Value {
    json!({
        "problems": tally.problems,
        "answered": tally.answered,
        "skipped": tally.skipped,
        "lost": tally.lost,
        "found": tally.found,
        "missed": tally.missed,
        "invented": tally.invented,
        "of_family": tally.of_family,
        "facts": {"right": tally.facts_right, "wrong": tally.facts_wrong},
        "digits": tally.digits,
        "degenerate": {"cases": tally.degenerate, "right": tally.degenerate_right},
        "seconds": {"median": tally.seconds_median, "total": tally.seconds_total},
    })
}

fn problem(case: &Case) -> Value {
    let (outcome, reason) = match &case.outcome {
        Outcome::Scored(_) => ("answered", None),
        Outcome::Skipped(reason) => ("skipped", Some(reason)),
        Outcome::Lost(reason) => ("lost", Some(reason)),
    };
    let value = json!({
        "corpus": case.corpus,
        "id": case.id,
        "kind": case.kind,
        "outcome": outcome,
        "found": case.count(Mark::Found),
        "missed": case.count(Mark::Missed),
        "invented": case.count(Mark::Invented),
        "facts_wrong": case.count(Mark::Wrong),
        "digits": case.digits().first(),
        "seconds": case.seconds,
    });
    match reason {
        Some(reason) => with(value, "reason", reason),
        None => value,
    }
}

/// The object with one more field.
fn with(mut object: Value, name: &str, value: &str) -> Value {
    if let Value::Object(fields) = &mut object {
        fields.insert(name.to_owned(), value.into());
    }
    object
}
