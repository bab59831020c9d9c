//! Verdicts and proofs in words.

use super::{Cause, Judgement, Proof, Verdict};

impl Verdict {
    /// All verdicts, those on lines before those on numbers.
    pub const ALL: [Verdict; 10] = [
        Verdict::Holds,
        Verdict::HoldsIf,
        Verdict::Fails,
        Verdict::Unclear,
        Verdict::Reproduced,
        Verdict::Truncated,
        Verdict::Noise,
        Verdict::Consistent,
        Verdict::Contradicted,
        Verdict::NotReproducible,
    ];

    /// What it says of a line.
    pub fn meaning(self) -> &'static str {
        match self {
            Verdict::Holds => "the line is true",
            Verdict::HoldsIf => "the line is true under a condition that the text does not state",
            Verdict::Fails => "the line is false",
            Verdict::Unclear => "it could not be decided what the line says, or whether it is true",
            Verdict::Reproduced => "the computed value is what is printed",
            Verdict::Truncated => "the print cuts off what it should have rounded",
            Verdict::Noise => "the print differs by no more than the machine's own rounding",
            Verdict::Consistent => "the print agrees within the digits of its printed inputs",
            Verdict::Contradicted => "the computed value is not what is printed",
            Verdict::NotReproducible => "nothing that was tried gives the print",
        }
    }
}

impl Proof {
    /// All kinds of proof, the strongest first.
    pub const ALL: [Proof; 5] = [
        Proof::Identity,
        Proof::Exact,
        Proof::Instances,
        Proof::Certified,
        Proof::Numeric,
    ];

    /// What a verdict with this proof rests on.
    pub fn basis(self) -> &'static str {
        match self {
            Proof::Identity => "for all values of the symbols",
            Proof::Exact => "decided in exact arithmetic on this instance",
            Proof::Instances => "random exact instances",
            Proof::Certified => "a rigorous enclosure",
            Proof::Numeric => "samples of limited precision",
        }
    }
}

impl Cause {
    /// Who made a line wrong, after a comma or the verdict.
    pub fn in_words(self) -> &'static str {
        match self {
            Cause::Author => "by the author",
            Cause::Print => "in print",
            Cause::Copy => "in the scan",
            Cause::Inherited => "inherited",
            Cause::Unknown => "author or print",
        }
    }
}

impl Judgement {
    /// What the verdict rests on, with the number of instances or samples.
    pub fn basis(&self) -> String {
        let count = match self.proof {
            Proof::Instances => self.instances,
            Proof::Numeric => self.samples,
            _ => None,
        };
        match count {
            Some(count) => format!("{count} {}", self.proof.basis()),
            None => self.proof.basis().to_owned(),
        }
    }
}
