//! Verdicts, how much they rest on, and what a judgement holds.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::MutantCounts;

/// What kind of statement a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// An equation or definition.
    Equation,
    /// A claim in words.
    Claim,
    /// A printed number.
    Number,
    /// A cell of a table.
    TableCell,
}

/// What was found of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// True.
    Holds,
    /// True except on a thin or named set, or only under a condition that the text does not state.
    HoldsIf,
    /// False.
    Fails,
    /// Two sensible readings differ in truth.
    Unclear,
    /// The computed enclosure lies within half a unit of the last printed digit.
    Reproduced,
    /// Within one unit of the last digit, the print cut towards zero.
    Truncated,
    /// Differs by no more than a proven or emulated bound of the printing machine's arithmetic.
    Noise,
    /// Computed from printed inputs as intervals, and overlapping.
    Consistent,
    /// Disjoint from what is printed.
    Contradicted,
    /// What was tried did not give the print.
    NotReproducible,
}

impl Verdict {
    /// Whether a line of this kind can have this verdict.
    pub fn fits(self, kind: Kind) -> bool {
        let of_number = matches!(
            self,
            Verdict::Reproduced
                | Verdict::Truncated
                | Verdict::Noise
                | Verdict::Consistent
                | Verdict::Contradicted
                | Verdict::NotReproducible
        );
        of_number == (kind == Kind::Number)
    }

    /// Whether the print is wrong.
    pub fn is_erratum(self) -> bool {
        matches!(self, Verdict::Fails | Verdict::Contradicted)
    }
}

/// What a verdict rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Proof {
    /// For all values of the symbols.
    Identity,
    /// A decision on this instance in exact arithmetic.
    Exact,
    /// Many random exact instances.
    Instances,
    /// A rigorous enclosure.
    Certified,
    /// Samples of limited precision.
    Numeric,
}

/// Who made a line wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cause {
    /// The author's derivation.
    Author,
    /// The printer.
    Print,
    /// The machine that read the scan.
    Copy,
    /// It follows rightly from a wrong line.
    Inherited,
    /// It cannot be told.
    Unknown,
}

/// A computed number as it is shown.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Computed {
    /// An exact rational number.
    Exact {
        /// As an integer or fraction.
        exact: String,
    },
    /// Nothing is known of it.
    Unknown,
    /// What stands in a cell, or in all cells, of a table.
    Text(String),
    /// The true number lies within `radius` of `value`.
    Enclosure {
        /// A decimal.
        value: String,
        /// A decimal.
        radius: String,
    },
}

impl fmt::Display for Computed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Computed::Exact { exact } => f.write_str(exact),
            Computed::Unknown => f.write_str("unknown"),
            Computed::Text(text) => f.write_str(text),
            Computed::Enclosure { value, radius } => write!(f, "{value} ± {radius}"),
        }
    }
}

/// The result for one statement, and what it rests on.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// What was found.
    pub verdict: Verdict,
    /// What that rests on.
    pub proof: Proof,
    /// The value of a printed number or expression.
    pub computed: Option<Computed>,
    /// The true value of what a machine only approximates.
    pub certified: Option<Computed>,
    /// The right form, itself checked to hold.
    pub corrected: Option<String>,
    /// For a proof by instances, how many.
    pub instances: Option<usize>,
    /// For a numeric proof, how many samples.
    pub samples: Option<usize>,
    /// Parameters for which a failing line fails.
    pub counterexample: Vec<(String, String)>,
    /// The mutants of the right form, where they were tried.
    pub mutants: Option<MutantCounts>,
    /// Names of what was run.
    pub evidence: Vec<String>,
    /// What was found beside the verdict: what explains a wrong print, what was tried in vain.
    pub findings: Vec<String>,
}

impl Judgement {
    pub(super) fn bare(verdict: Verdict, proof: Proof) -> Self {
        Judgement {
            verdict,
            proof,
            computed: None,
            certified: None,
            corrected: None,
            instances: None,
            samples: None,
            counterexample: Vec::new(),
            mutants: None,
            evidence: Vec::new(),
            findings: Vec::new(),
        }
    }
}

/// Serialises to the name that data and output use.
macro_rules! named {
    ($($name:ident),*) => {
        $(impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.serialize(f)
            }
        })*
    };
}
named!(Kind, Verdict, Proof, Cause);
