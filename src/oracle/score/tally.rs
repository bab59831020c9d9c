//! What the verdicts add up to.

use serde::Serialize;

use super::verdict::{Mark, Verdict};

/// How a problem ended.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It was answered.
    Scored(Verdict),
    /// The candidate does not do such problems, and says so.
    Skipped(String),
    /// No answer: the candidate stopped, was too slow, wrote what is no answer, or gave up.
    Lost(String),
}

/// A problem of a corpus with its outcome.
#[derive(Clone, Debug)]
pub struct Case {
    /// The corpus.
    pub corpus: String,
    /// The problem.
    pub id: String,
    /// Its kind within the corpus.
    pub kind: String,
    /// Whether the certified answer is known to be degenerate.
    pub degenerate: bool,
    /// How it ended.
    pub outcome: Outcome,
    /// From the question to the end.
    pub seconds: f64,
}

impl Case {
    /// Nothing missed, invented or wrong, and not lost.
    pub fn is_clean(&self) -> bool {
        match &self.outcome {
            Outcome::Scored(verdict) => verdict.is_clean(),
            Outcome::Skipped(_) => true,
            Outcome::Lost(_) => false,
        }
    }

    /// How many parts of the answer came out so; 0 without an answer.
    pub fn count(&self, mark: Mark) -> usize {
        match &self.outcome {
            Outcome::Scored(verdict) => verdict.count(mark),
            Outcome::Skipped(_) | Outcome::Lost(_) => 0,
        }
    }

    /// Correct digits of what is found, sorted.
    pub fn digits(&self) -> Vec<f64> {
        match &self.outcome {
            Outcome::Scored(verdict) => sorted(verdict.digits().collect()),
            Outcome::Skipped(_) | Outcome::Lost(_) => Vec::new(),
        }
    }

    /// The worse, the larger: lost, then invented, then missed, then wrong, then inexact.
    pub fn badness(&self) -> (bool, usize, usize, usize, f64) {
        let digits = self.digits().first().copied().unwrap_or(50.0);
        (
            matches!(self.outcome, Outcome::Lost(_)),
            self.count(Mark::Invented),
            self.count(Mark::Missed),
            self.count(Mark::Wrong),
            -digits,
        )
    }
}

/// The extreme and the middle of several numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// The least.
    pub worst: f64,
    /// The middle one.
    pub median: f64,
}

/// The sums over the problems of one kind.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Tally {
    /// The corpus.
    pub corpus: String,
    /// The kind within the corpus.
    pub kind: String,
    /// Problems asked.
    pub problems: usize,
    /// Answered.
    pub answered: usize,
    /// Declined.
    pub skipped: usize,
    /// Without an answer.
    pub lost: usize,
    /// Certified solutions that were given.
    pub found: usize,
    /// Certified solutions that were not given.
    pub missed: usize,
    /// Given solutions that do not exist.
    pub invented: usize,
    /// Given pairs of a family, or multiple ones given again.
    pub of_family: usize,
    /// Facts that were stated rightly.
    pub facts_right: usize,
    /// Facts that were stated wrongly.
    pub facts_wrong: usize,
    /// Correct digits of what was found.
    pub digits: Option<Spread>,
    /// Degenerate cases.
    pub degenerate: usize,
    /// Those of them that are right.
    pub degenerate_right: usize,
    /// The middle time of a problem.
    pub seconds_median: f64,
    /// The time of all.
    pub seconds_total: f64,
}

/// The sums by corpus and kind, in the order of their first problems.
pub fn tallies(cases: &[Case]) -> Vec<Tally> {
    grouped(cases, |a, b| a.corpus == b.corpus && a.kind == b.kind)
}

/// The sums by corpus.
pub fn by_corpus(cases: &[Case]) -> Vec<Tally> {
    let sums = grouped(cases, |a, b| a.corpus == b.corpus).into_iter();
    let unnamed = |tally| Tally {
        kind: String::new(),
        ..tally
    };
    sums.map(unnamed).collect()
}

fn grouped(cases: &[Case], alike: impl Fn(&Case, &Case) -> bool) -> Vec<Tally> {
    let mut groups: Vec<Vec<&Case>> = Vec::new();
    for case in cases {
        let same = groups
            .iter_mut()
            .find(|group| group.first().is_some_and(|first| alike(first, case)));
        match same {
            Some(group) => group.push(case),
            None => groups.push(vec![case]),
        }
    }
    groups.iter().map(|group| Tally::of(group)).collect()
}

impl Tally {
    /// The sums over these cases, named after the first.
    pub fn of(cases: &[&Case]) -> Tally {
        let sum = |mark: Mark| cases.iter().map(|case| case.count(mark)).sum();
        let number = |is: fn(&Case) -> bool| cases.iter().filter(|case| is(case)).count();
        let digits = sorted(cases.iter().flat_map(|case| case.digits()).collect());
        let seconds = sorted(cases.iter().map(|case| case.seconds).collect());
        let name = |part: fn(&Case) -> &String| cases.first().map(|case| part(case).clone());
        Tally {
            corpus: name(|case| &case.corpus).unwrap_or_default(),
            kind: name(|case| &case.kind).unwrap_or_default(),
            problems: cases.len(),
            answered: number(|case| matches!(case.outcome, Outcome::Scored(_))),
            skipped: number(|case| matches!(case.outcome, Outcome::Skipped(_))),
            lost: number(|case| matches!(case.outcome, Outcome::Lost(_))),
            found: sum(Mark::Found),
            missed: sum(Mark::Missed),
            invented: sum(Mark::Invented),
            of_family: sum(Mark::OfFamily),
            facts_right: sum(Mark::Right),
            facts_wrong: sum(Mark::Wrong),
            digits: digits.first().map(|&worst| Spread {
                worst,
                median: median(&digits),
            }),
            degenerate: number(|case| case.degenerate),
            degenerate_right: number(|case| match &case.outcome {
                Outcome::Scored(verdict) => verdict.degenerate == Some(true),
                Outcome::Skipped(_) | Outcome::Lost(_) => false,
            }),
            seconds_median: median(&seconds),
            seconds_total: seconds.iter().sum(),
        }
    }
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// Of sorted numbers; 0 of none.
fn median(sorted: &[f64]) -> f64 {
    let middle = sorted.len() / 2;
    let at = |index: usize| sorted.get(index).copied().unwrap_or_default();
    if sorted.len() % 2 == 1 {
        at(middle)
    } else {
        (at(middle.wrapping_sub(1)) + at(middle)) / 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!(median(&[]), 0.0);
        assert_eq!(median(&[1.0, 2.0, 9.0]), 2.0);
        assert_eq!(median(&[1.0, 3.0]), 2.0);
    }
}
