//! How a verdict is known, in one or two sentences.

use crate::ledger::{Content, Decided, Judgement, Proof, Statement, Verdict};

/// Longer values are left to the command `explain`.
const LONGEST_VALUE: usize = 20;

/// How it is known.
pub fn sentences(decided: Decided<'_>) -> String {
    let Decided {
        statement,
        judgement,
    } = decided;
    match judgement.verdict {
        Verdict::Holds => holds(statement, judgement),
        Verdict::HoldsIf => format!(
            "{} Elsewhere it fails, as the counterexample shows{}",
            holds(statement, judgement),
            where_it_fails(judgement)
        ),
        Verdict::Fails => fails(statement, judgement),
        Verdict::Unclear => "Neither that it holds nor that it fails could be shown.".to_owned(),
        Verdict::Reproduced if judgement.proof == Proof::Exact => {
            "Computed in exact arithmetic; the print is that number, rounded.".to_owned()
        }
        Verdict::Reproduced => {
            "All of the computed enclosure lies within half a unit of the last printed digit."
                .to_owned()
        }
        Verdict::Truncated => {
            "The computed enclosure begins with the printed digits, the rest of which was cut off."
                .to_owned()
        }
        Verdict::Noise => format!(
            "The rounding errors of the machine reach the print, as {} runs with scattered rounding show.",
            judgement.samples.unwrap_or(0)
        ),
        Verdict::Consistent => {
            "Some inputs within their printed digits give the print; a rigorous enclosure shows it."
                .to_owned()
        }
        Verdict::Contradicted => {
            "The computed enclosure and what the print stands for have no number in common."
                .to_owned()
        }
        Verdict::NotReproducible => "What was tried does not give the print.".to_owned(),
    }
}

fn holds(statement: &Statement, judgement: &Judgement) -> String {
    if matches!(statement.content, Content::Check) {
        return format!(
            "{} A wrong variant of the claim was tried in the same way and is rejected.",
            by_check(judgement)
        );
    }
    match judgement.proof {
        Proof::Identity => "True for all values of the symbols: on the scene, which is built from first principles \
                            with free symbols, both sides are the same."
            .to_owned(),
        Proof::Exact => "True in exact arithmetic on this very configuration.".to_owned(),
        Proof::Instances => format!(
            "True on {} random exact configurations of the scene, none of them special, and false on none.",
            judgement.instances.unwrap_or(0)
        ),
        Proof::Certified => "A rigorous enclosure decides it.".to_owned(),
        Proof::Numeric => format!("{} samples agree with it.", judgement.samples.unwrap_or(0)),
    }
}

fn by_check(judgement: &Judgement) -> String {
    match judgement.proof {
        Proof::Identity => "A check in code decides it for all values.".to_owned(),
        Proof::Exact => "A check in code decides it in exact arithmetic.".to_owned(),
        Proof::Instances => format!(
            "A check in code decides it on {} random exact configurations.",
            judgement.instances.unwrap_or(0)
        ),
        Proof::Certified => "A check in code decides it by rigorous enclosures.".to_owned(),
        Proof::Numeric => "A check in code decides it on samples.".to_owned(),
    }
}

fn fails(statement: &Statement, judgement: &Judgement) -> String {
    let mut known = match &statement.content {
        Content::Garbled => "The line cannot be read.".to_owned(),
        Content::Check => by_check(judgement),
        Content::Cell { .. } | Content::Table(_) => {
            "What belongs there was computed in exact arithmetic.".to_owned()
        }
        _ => {
            let how = match judgement.proof {
                Proof::Certified => "by a rigorous enclosure",
                _ => "in exact arithmetic",
            };
            format!("It is false {how}{}", where_it_fails(judgement))
        }
    };
    if judgement.corrected.is_some() && statement.correct.is_some() {
        known.push_str(" The right form was decided on the same scene, and holds.");
    }
    known
}

/// `, for instance where a = 1, b = 2.`
fn where_it_fails(judgement: &Judgement) -> String {
    let short = judgement.counterexample.iter();
    let short: Vec<String> = short
        .filter(|(_, value)| value.len() < LONGEST_VALUE)
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    match (
        short.is_empty(),
        judgement.counterexample.len() > short.len(),
    ) {
        (true, _) => ".".to_owned(),
        (false, true) => format!(
            ", for instance where {}, and the rest follows.",
            short.join(", ")
        ),
        (false, false) => format!(", for instance where {}.", short.join(", ")),
    }
}
