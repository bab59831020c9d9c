//! Mutants of a formula: how a scene shows that it could have rejected the line.

use serde::Serialize;

use super::error::JudgeError;
use super::formula::{FIRST_INSTANCES, Finding, MANY_INSTANCES, decide, proved_for_all};
use super::stage::Stage;
use crate::formula::{Failure, Formula, Mutant, evaluate, follows, mutants};

/// What became of the mutants of a formula.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct MutantCounts {
    /// How many were made that are formulas of the scene.
    pub tried: usize,
    /// Shown to fail, or to have a value nowhere.
    pub rejected: usize,
    /// Proved to hold as well: they say the same, or another truth.
    pub equivalent: usize,
    /// Neither.
    pub undecided: usize,
    /// What was changed in those that are undecided, and why that is open.
    #[serde(skip)]
    pub survivors: Vec<String>,
}

enum Fate {
    Rejected,
    Equivalent,
    Undecided,
    NoFormula,
}

/// Tries all mutants of a formula that holds.
pub fn try_mutants(formula: &Formula, stage: &mut Stage) -> Result<MutantCounts, JudgeError> {
    let names: Vec<&str> = stage
        .scene()
        .symbols
        .iter()
        .map(|symbol| symbol.name)
        .collect();
    let mut counts = MutantCounts::default();
    for mutant in mutants(formula, &names) {
        match fate(&mutant, formula, stage)? {
            Fate::NoFormula => continue,
            Fate::Rejected => counts.rejected += 1,
            Fate::Equivalent => counts.equivalent += 1,
            Fate::Undecided => {
                counts.undecided += 1;
                let why = reason(stage);
                let survivor = format!("{}: {} ({why})", mutant.what, mutant.formula);
                counts.survivors.push(survivor);
            }
        }
        counts.tried += 1;
    }
    Ok(counts)
}

/// Why a mutant that holds in all instances is not proved to hold.
fn reason(stage: &Stage) -> String {
    if stage.example().is_some() {
        return "the enclosures of the example leave it open".to_owned();
    }
    match stage.symbolic() {
        Err(unbuilt) => {
            format!("it holds in {MANY_INSTANCES} instances; no free symbols: {unbuilt}")
        }
        Ok(_) => format!(
            "it holds in {MANY_INSTANCES} instances; with free symbols an order, a condition or a \
             root stays open"
        ),
    }
}

/// The numbers of an example are all that the line speaks of. Elsewhere a few instances first; free
/// symbols, then more instances, only for those that survive.
fn fate(mutant: &Mutant, formula: &Formula, stage: &mut Stage) -> Result<Fate, JudgeError> {
    if stage.example().is_some() {
        return fate_in_example(mutant, stage);
    }
    match rejected(mutant, stage, FIRST_INSTANCES) {
        Ok(true) => return Ok(Fate::Rejected),
        Ok(false) => {}
        // A change that mixes types makes no formula.
        Err(JudgeError::Formula { .. }) => return Ok(Fate::NoFormula),
        Err(other) => return Err(other),
    }
    if follows(&mutant.formula, formula) || proved_for_all(&mutant.formula, stage)? {
        return Ok(Fate::Equivalent);
    }
    if rejected(mutant, stage, MANY_INSTANCES)? {
        return Ok(Fate::Rejected);
    }
    Ok(Fate::Undecided)
}

fn fate_in_example(mutant: &Mutant, stage: &mut Stage) -> Result<Fate, JudgeError> {
    match decide(&mutant.formula, stage) {
        Ok(Finding::Fails { .. }) => Ok(Fate::Rejected),
        Ok(Finding::Holds { .. }) => Ok(Fate::Equivalent),
        Ok(Finding::Undecided(_)) if rejected(mutant, stage, 1)? => Ok(Fate::Rejected),
        Ok(Finding::Undecided(_)) => Ok(Fate::Undecided),
        Err(JudgeError::Formula { .. }) => Ok(Fate::NoFormula),
        Err(other) => Err(other),
    }
}

/// Whether the mutant fails in some configuration, or has a value in none.
fn rejected(mutant: &Mutant, stage: &mut Stage, wanted: usize) -> Result<bool, JudgeError> {
    let instances = stage.instances(wanted)?;
    let mut undefined = 0;
    for bindings in instances {
        match evaluate(&mutant.formula, bindings) {
            Ok(outcome) if (!outcome.holds & outcome.assumed).is_yes() => return Ok(true),
            Ok(_) => {}
            Err(Failure::NoValue { .. }) => undefined += 1,
            Err(wrong) => return Err(JudgeError::formula(wrong)),
        }
    }
    Ok(undefined > 0 && undefined == instances.len())
}
