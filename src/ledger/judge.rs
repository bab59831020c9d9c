//! Statement and scene to verdict.

use std::collections::HashMap;
use std::iter::successors;

use super::error::JudgeError;
use super::formula::{Finding, decide, failure_outside, restricted};
use super::measured::compare_measured;
use super::mutation::try_mutants;
use super::number::{
    ValueFinding, compare_decimal, compare_expression, compare_integer, evaluate_quantity, shown,
};
use super::paper::{Condition, Content, Statement, Text};
use super::stage::Stage;
use super::table::Tables;
use super::{Computed, Judgement, Kind, Printed, Proof, Verdict};

use crate::number::{Real, Truth};
use crate::scenes;
use crate::scenes::check::{Basis, Report};

/// What to compute beside the verdict.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Significant digits of computed values.
    pub digits: usize,
    /// Whether to try the mutants of every formula.
    pub mutants: bool,
}

/// Judges statements; a scene that several of them share is built once.
pub struct Judge {
    options: Options,
    stages: HashMap<(&'static str, Option<String>), Stage>,
    tables: Tables,
}

impl Judge {
    /// A judge who has seen nothing yet.
    pub fn new(options: Options) -> Self {
        Judge {
            options,
            stages: HashMap::new(),
            tables: Tables::default(),
        }
    }

    /// Judges one statement.
    pub fn judge(&mut self, statement: &Statement) -> Result<Judgement, JudgeError> {
        let example = statement.example.as_ref();
        let key = (
            statement.scene.name,
            example.map(|example| example.name.clone()),
        );
        let stage = self
            .stages
            .entry(key)
            .or_insert_with(|| Stage::new(statement.scene, example.cloned()));
        judge_on(statement, stage, &mut self.tables, &self.options)
    }
}

fn judge_on(
    statement: &Statement,
    stage: &mut Stage,
    tables: &mut Tables,
    options: &Options,
) -> Result<Judgement, JudgeError> {
    let mut judgement = match &statement.content {
        Content::Formula(printed) => judge_formula(statement, printed, stage, options)?,
        Content::Value {
            quantity,
            explained_by,
            certified,
        } => {
            let explained_by = explained_by.as_ref();
            let mut judgement = judge_value(statement, quantity, explained_by, stage, options)?;
            if let Some(certified) = certified {
                judgement.certified = Some(computed(certified, stage, options.digits)?);
            }
            judgement
        }
        Content::Check => Judgement::bare(Verdict::Holds, Proof::Identity),
        Content::Garbled => judge_garbled(statement, stage, options)?,
        Content::Cell { table, row, column } => {
            tables.judge_cell(table, row, column, &statement.printed)?
        }
        Content::Table(table) => tables.judge_whole(table)?,
    };
    run_checks(statement, &mut judgement)?;
    if let (Content::Check, Verdict::Fails, Some(correct)) =
        (&statement.content, judgement.verdict, &statement.correct)
    {
        check_correction(correct, stage)?;
        judgement.corrected = Some(correct.text.clone());
    }
    judgement
        .evidence
        .insert(0, format!("scene {}", statement.scene.name));
    Ok(judgement)
}

fn judge_formula(
    statement: &Statement,
    printed: &Text,
    stage: &mut Stage,
    options: &Options,
) -> Result<Judgement, JudgeError> {
    if let Some(condition) = &statement.condition {
        return judge_under_condition(printed, condition, stage, options);
    }
    let mut judgement = judgement_of(decide(&printed.formula, stage)?);
    let right = match (&statement.correct, judgement.verdict) {
        (Some(correct), Verdict::Fails) => {
            check_correction(correct, stage)?;
            judgement.corrected = Some(correct.text.clone());
            judgement.evidence.push("corrected form holds".to_owned());
            Some(correct)
        }
        (_, Verdict::Holds) => Some(printed),
        _ => None,
    };
    if let (Some(right), true) = (right, options.mutants) {
        judgement.mutants = Some(try_mutants(&right.formula, stage)?);
    }
    Ok(judgement)
}

/// A line that holds where a condition does, and fails in a configuration outside.
fn judge_under_condition(
    printed: &Text,
    condition: &Condition,
    stage: &mut Stage,
    options: &Options,
) -> Result<Judgement, JudgeError> {
    let restricted = restricted(&printed.formula, &condition.text.formula);
    let mut judgement = judgement_of(decide(&restricted, stage)?);
    if judgement.verdict != Verdict::Holds {
        return Ok(judgement);
    }
    judgement
        .findings
        .push(format!("holds if {}", condition.text.text));
    let mut outside = Stage::new(condition.outside, None);
    match failure_outside(&printed.formula, &condition.text.formula, &mut outside)? {
        Some(counterexample) => {
            judgement.verdict = Verdict::HoldsIf;
            judgement.counterexample = counterexample;
            judgement.evidence.push(format!(
                "counterexample in scene {}",
                condition.outside.name
            ));
        }
        None => judgement
            .findings
            .push("no configuration was found in which the condition and the line fail".to_owned()),
    }
    if options.mutants {
        judgement.mutants = Some(try_mutants(&restricted, stage)?);
    }
    Ok(judgement)
}

/// A line that cannot be read: what it must have said holds.
fn judge_garbled(
    statement: &Statement,
    stage: &mut Stage,
    options: &Options,
) -> Result<Judgement, JudgeError> {
    let mut judgement = Judgement::bare(Verdict::Fails, Proof::Exact);
    judgement
        .findings
        .push("the line cannot be read; it is stored verbatim".to_owned());
    if let Some(correct) = &statement.correct {
        check_correction(correct, stage)?;
        judgement.corrected = Some(correct.text.clone());
        judgement.evidence.push("corrected form holds".to_owned());
        if options.mutants {
            judgement.mutants = Some(try_mutants(&correct.formula, stage)?);
        }
    }
    Ok(judgement)
}

fn judgement_of(finding: Finding) -> Judgement {
    match finding {
        Finding::Holds { proof, instances } => Judgement {
            instances,
            ..Judgement::bare(Verdict::Holds, proof)
        },
        Finding::Fails {
            proof,
            counterexample,
        } => Judgement {
            counterexample,
            ..Judgement::bare(Verdict::Fails, proof)
        },
        Finding::Undecided(why) => Judgement {
            findings: vec![why],
            ..Judgement::bare(Verdict::Unclear, Proof::Numeric)
        },
    }
}

fn check_correction(correct: &Text, stage: &mut Stage) -> Result<(), JudgeError> {
    match decide(&correct.formula, stage)? {
        Finding::Holds { .. } => Ok(()),
        finding => Err(JudgeError::WrongCorrection {
            text: correct.text.clone(),
            why: finding.in_words(),
        }),
    }
}

fn judge_value(
    statement: &Statement,
    quantity: &Text,
    explained_by: Option<&Text>,
    stage: &mut Stage,
    options: &Options,
) -> Result<Judgement, JudgeError> {
    let is_measured = stage
        .example()
        .is_some_and(|example| !example.measured.is_empty());
    let mut judgement = match Printed::read(&statement.printed) {
        _ if is_measured => compare_measured(&statement.printed, quantity, stage)?,
        Ok(printed) => {
            let mut judgement = judgement_of_value(compare_decimal(&printed, quantity, stage)?);
            if let Some(explanation) = explained_by {
                explain(explanation, &printed, statement, stage, &mut judgement)?;
            }
            judgement
        }
        Err(_) => match compare_integer(&statement.printed, quantity, stage)? {
            Some(finding) => judgement_of_value(finding),
            None => judge_expression(statement, quantity, stage)?,
        },
    };
    if let (Some(tried), Verdict::Contradicted) = (&statement.tried, judgement.verdict) {
        // How the print was made is not known, so that it does not contradict what is computed here.
        judgement.verdict = Verdict::NotReproducible;
        judgement.corrected = None;
        judgement.findings.push(format!("tried: {tried}"));
    }
    judgement.computed = Some(computed(quantity, stage, options.digits)?);
    Ok(judgement)
}

fn judgement_of_value(finding: ValueFinding) -> Judgement {
    Judgement {
        corrected: finding.corrected,
        samples: finding.samples,
        findings: finding.findings,
        ..Judgement::bare(finding.verdict, finding.proof)
    }
}

/// An expression in roots or an integer: equal or not.
fn judge_expression(
    statement: &Statement,
    quantity: &Text,
    stage: &mut Stage,
) -> Result<Judgement, JudgeError> {
    let mut judgement = judgement_of(compare_expression(&statement.printed, quantity, stage)?);
    if judgement.verdict == Verdict::Fails {
        judgement.corrected = match &statement.correct {
            Some(correct) => {
                let equal = compare_expression(&correct.text, quantity, stage)?;
                if !matches!(equal, Finding::Holds { .. }) {
                    return Err(JudgeError::WrongCorrection {
                        text: correct.text.clone(),
                        why: equal.in_words(),
                    });
                }
                Some(correct.text.clone())
            }
            None => match computed(quantity, stage, 30)? {
                Computed::Exact { exact } => Some(exact),
                _ => None,
            },
        };
    }
    if statement.kind == Kind::Number {
        judgement.verdict = match judgement.verdict {
            Verdict::Holds => Verdict::Reproduced,
            Verdict::Fails => Verdict::Contradicted,
            _ => Verdict::NotReproducible,
        };
    }
    Ok(judgement)
}

fn explain(
    explanation: &Text,
    printed: &Printed,
    statement: &Statement,
    stage: &mut Stage,
    judgement: &mut Judgement,
) -> Result<(), JudgeError> {
    let other = compare_decimal(printed, explanation, stage)?;
    if other.verdict != Verdict::Reproduced {
        return Err(JudgeError::WrongExplanation {
            text: explanation.text.clone(),
            printed: statement.printed.clone(),
        });
    }
    judgement
        .findings
        .push(format!("the print is the value of {}", explanation.text));
    Ok(())
}

/// The quantity to so many digits, sharpened until they are there.
fn computed(quantity: &Text, stage: &mut Stage, digits: usize) -> Result<Computed, JudgeError> {
    let wanted = u32::try_from(digits * 10 / 3).unwrap_or(u32::MAX / 4);
    let most = wanted.saturating_mul(8).saturating_add(4096);
    let first = wanted.saturating_add(64);
    let doubled = |bits: &u32| (*bits <= most).then(|| bits.saturating_mul(2));
    let precisions = successors(Some(first), doubled);
    let last = precisions.clone().last().unwrap_or(first);
    for bits in precisions {
        let value = evaluate_quantity(quantity, stage, bits)?;
        let is_sharp = value.ball.accuracy_bits() > Some(i64::from(wanted) + 4);
        if value.rational.is_some() || is_sharp {
            return Ok(shown(&value, digits));
        }
        // What is zero never is: then only the last precision is left to be seen.
        if bits > first && value.ball.sign().is_none() {
            let value = evaluate_quantity(quantity, stage, last)?;
            if value.ball.sign().is_none() {
                return Ok(shown(&value, digits));
            }
        }
    }
    Ok(shown(&evaluate_quantity(quantity, stage, last)?, digits))
}

/// Runs the checks in code that belong to a statement; one that fails makes the line fail.
fn run_checks(statement: &Statement, judgement: &mut Judgement) -> Result<(), JudgeError> {
    for check in statement
        .checks
        .iter()
        .filter_map(|name| scenes::find_check(name))
    {
        let report = (check.run)()?;
        judgement.evidence.push(format!("check {}", check.name));
        if !report.wrong_variant.is_no() {
            judgement
                .findings
                .push(format!("the check {} cannot fail", check.name));
            judgement.verdict = Verdict::Unclear;
        }
        match report.holds {
            Truth::Yes => note_exception(&report, judgement),
            Truth::No => judgement.verdict = Verdict::Fails,
            Truth::Unknown => judgement.verdict = Verdict::Unclear,
        }
        // A claim that is no formula, or that a formula says for instances only.
        let proves_more = report.basis == Basis::Identity && statement.condition.is_some();
        if matches!(statement.content, Content::Check) || proves_more && report.holds.is_yes() {
            (judgement.proof, judgement.instances) = match report.basis {
                Basis::Identity => (Proof::Identity, None),
                Basis::Exact => (Proof::Exact, None),
                Basis::Instances => (Proof::Instances, Some(report.instances)),
                Basis::Certified => (Proof::Certified, None),
            };
        }
    }
    Ok(())
}

/// What holds but for an exception holds under a condition.
fn note_exception(report: &Report, judgement: &mut Judgement) {
    let Some(exception) = &report.exception else {
        return;
    };
    if judgement.verdict == Verdict::Holds {
        judgement.verdict = Verdict::HoldsIf;
    }
    judgement
        .findings
        .push(format!("holds if {}", exception.condition));
    judgement
        .findings
        .push(format!("counterexample: {}", exception.counterexample));
}
