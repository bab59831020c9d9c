//! Formula on scene: does it hold?

use super::Proof;
use super::error::JudgeError;
use super::stage::Stage;
use crate::formula::{Bindings, Failure, Formula, Value, evaluate};
use crate::number::{Number, Real, Surd, Truth};

/// Exact configurations that a formula meets before a proof for all values is tried.
pub const FIRST_INSTANCES: usize = 3;
/// Exact configurations that a proof by instances rests on.
pub const MANY_INSTANCES: usize = 40;
/// Bits of the first enclosures of an example; doubled until something is decided.
const FIRST_BITS: u32 = 256;
/// Bits at which an enclosure of an example gives up.
const MOST_BITS: u32 = 4096;

/// What was found of a formula.
#[derive(Clone, Debug)]
pub enum Finding {
    /// It holds.
    Holds {
        /// On what that rests.
        proof: Proof,
        /// For [`Proof::Instances`], how many.
        instances: Option<usize>,
    },
    /// It fails.
    Fails {
        /// On what that rests.
        proof: Proof,
        /// The symbols of the formula where it fails.
        counterexample: Vec<(String, String)>,
    },
    /// Neither could be shown.
    Undecided(String),
}

impl Finding {
    /// For messages.
    pub fn in_words(&self) -> String {
        match self {
            Finding::Holds { .. } => "it holds".to_owned(),
            Finding::Fails { counterexample, .. } if counterexample.is_empty() => {
                "it fails".to_owned()
            }
            Finding::Fails { counterexample, .. } => {
                let values: Vec<String> = counterexample
                    .iter()
                    .map(|(name, value)| format!("{name} = {value}"))
                    .collect();
                format!("it fails where {}", values.join(", "))
            }
            Finding::Undecided(why) => why.clone(),
        }
    }
}

/// Decides a formula on its stage.
pub fn decide(formula: &Formula, stage: &mut Stage) -> Result<Finding, JudgeError> {
    if stage.example().is_some() {
        return decide_example(formula, stage);
    }
    if let Some(failure) = first_failure(formula, stage, FIRST_INSTANCES)? {
        return Ok(failure);
    }
    if proved_for_all(formula, stage)? {
        return Ok(Finding::Holds {
            proof: Proof::Identity,
            instances: None,
        });
    }
    if let Some(failure) = first_failure(formula, stage, MANY_INSTANCES)? {
        return Ok(failure);
    }
    match count_of_instances_that_hold(formula, stage)? {
        0 => Ok(Finding::Undecided(
            "no exact configuration of the scene meets the line's assumptions".to_owned(),
        )),
        instances => Ok(Finding::Holds {
            proof: Proof::Instances,
            instances: Some(instances),
        }),
    }
}

/// Whether the formula holds for all values of the scene's symbols.
pub fn proved_for_all(formula: &Formula, stage: &Stage) -> Result<bool, JudgeError> {
    let Ok(bindings) = stage.symbolic() else {
        return Ok(false);
    };
    match evaluate(formula, bindings) {
        Ok(outcome) => Ok(outcome.holds.is_yes()),
        Err(Failure::NoValue { .. }) => Ok(false),
        Err(wrong) => Err(JudgeError::formula(wrong)),
    }
}

fn first_failure(
    formula: &Formula,
    stage: &mut Stage,
    wanted: usize,
) -> Result<Option<Finding>, JudgeError> {
    for bindings in stage.instances(wanted)? {
        if holds_on(formula, bindings)?.is_no() {
            return Ok(Some(Finding::Fails {
                proof: Proof::Exact,
                counterexample: values_of_symbols(formula, bindings),
            }));
        }
    }
    Ok(None)
}

fn count_of_instances_that_hold(formula: &Formula, stage: &mut Stage) -> Result<usize, JudgeError> {
    let mut count = 0;
    for bindings in stage.instances(MANY_INSTANCES)? {
        if holds_on(formula, bindings)?.is_yes() {
            count += 1;
        }
    }
    Ok(count)
}

/// Yes or no where the assumptions hold and everything has a value, else unknown.
pub fn holds_on<K: Real>(formula: &Formula, bindings: &Bindings<K>) -> Result<Truth, JudgeError> {
    match evaluate(formula, bindings) {
        Ok(outcome) if outcome.assumed.is_yes() => Ok(outcome.holds),
        Ok(_) | Err(Failure::NoValue { .. }) => Ok(Truth::Unknown),
        Err(wrong) => Err(JudgeError::formula(wrong)),
    }
}

fn decide_example(formula: &Formula, stage: &mut Stage) -> Result<Finding, JudgeError> {
    if let Some(bindings) = stage.instances(1)?.first() {
        match holds_on(formula, bindings)? {
            Truth::Yes => {
                return Ok(Finding::Holds {
                    proof: Proof::Exact,
                    instances: None,
                });
            }
            Truth::No => {
                return Ok(Finding::Fails {
                    proof: Proof::Exact,
                    counterexample: values_of_symbols(formula, bindings),
                });
            }
            Truth::Unknown => {}
        }
    }
    let mut bits = FIRST_BITS;
    while bits <= MOST_BITS {
        let bindings = stage.certified(bits)?;
        match holds_on(formula, &bindings)? {
            Truth::Yes => {
                return Ok(Finding::Holds {
                    proof: Proof::Certified,
                    instances: None,
                });
            }
            Truth::No => {
                return Ok(Finding::Fails {
                    proof: Proof::Certified,
                    counterexample: Vec::new(),
                });
            }
            Truth::Unknown => bits *= 2,
        }
    }
    Ok(Finding::Undecided(
        "the enclosures of the example leave it open".to_owned(),
    ))
}

/// A formula that is meant only where a condition holds.
pub fn restricted(formula: &Formula, condition: &Formula) -> Formula {
    let mut restricted = formula.clone();
    restricted
        .definitions
        .extend(condition.definitions.iter().cloned());
    let further = condition.claims.iter().chain(&condition.assumptions);
    restricted.assumptions.extend(further.cloned());
    restricted
}

/// The symbols of a configuration in which neither the condition nor the formula holds.
pub fn failure_outside(
    formula: &Formula,
    condition: &Formula,
    stage: &mut Stage,
) -> Result<Option<Vec<(String, String)>>, JudgeError> {
    for bindings in stage.instances(FIRST_INSTANCES)? {
        if holds_on(condition, bindings)?.is_no() && holds_on(formula, bindings)?.is_no() {
            let both = restricted(formula, condition);
            return Ok(Some(values_of_symbols(&both, bindings)));
        }
    }
    Ok(None)
}

/// The numbers that stand for the symbols of a formula.
fn values_of_symbols(formula: &Formula, bindings: &Bindings<Surd>) -> Vec<(String, String)> {
    formula
        .symbols()
        .into_iter()
        .filter_map(|name| match bindings.get(&name)? {
            Value::Number(number) => Some((name, shown(number))),
            Value::Point(point) => {
                let (re, im) = (shown(point.re()), shown(point.im()));
                Some((name, format!("{re} + {im} i")))
            }
            _ => None,
        })
        .collect()
}

/// A rational number as it is, a root to some digits.
fn shown(number: &Number<Surd>) -> String {
    match number.0.rational() {
        Some(q) => q.to_string(),
        None => number.0.enclosure(64).0.to_string(),
    }
}
