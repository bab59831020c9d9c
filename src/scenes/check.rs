//! Checks: statements that are no formula, as named functions.

use super::Unbuilt;
use crate::number::Truth;

/// What a check rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// For all values of the symbols.
    Identity,
    /// A decision on one configuration in exact arithmetic.
    Exact,
    /// Random exact instances.
    Instances,
    /// Enclosures of one configuration.
    Certified,
}

/// What a check found.
#[derive(Clone, Copy, Debug)]
pub struct Report {
    /// Whether the statement holds.
    pub holds: Truth,
    /// What a deliberately wrong variant of the statement came to; the check can fail only if this
    /// is [`Truth::No`].
    pub wrong_variant: Truth,
    /// What the answer rests on.
    pub basis: Basis,
    /// How many instances were tried.
    pub instances: usize,
    /// Where the statement does not hold, if it holds but for an exception; the check shows both.
    pub exception: Option<Exception>,
}

/// What the text does not say of a statement that holds but for some configurations.
#[derive(Clone, Copy, Debug)]
pub struct Exception {
    /// Where it holds.
    pub condition: &'static str,
    /// A configuration in which it does not hold.
    pub counterexample: &'static str,
}

/// A named check.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// The name by which data refer to it.
    pub name: &'static str,
    /// What it decides, and how.
    pub summary: &'static str,
    /// Runs it.
    pub run: fn() -> Result<Report, Unbuilt>,
}
