//! Certified and given side by side.

use std::fmt;

use crate::oracle::score::{Line, Mark, Verdict};

/// What came of a comparison; as text it names everything that is missed, invented or wrong, and how far
/// the rest is off.
#[derive(Clone, Debug)]
pub struct Comparison {
    verdict: Verdict,
    condition: Option<f64>,
    tolerance: f64,
}

impl Comparison {
    pub(super) fn new(verdict: Verdict, condition: Option<f64>, tolerance: f64) -> Self {
        Comparison {
            verdict,
            condition,
            tolerance,
        }
    }

    /// Nothing is missed, invented or wrong, with the tolerance that the conditioning of the problem
    /// allows.
    pub fn is_right(&self) -> bool {
        self.verdict.is_clean()
    }

    /// Part by part.
    pub fn lines(&self) -> &[Line] {
        &self.verdict.lines
    }

    /// The relative error up to which a number is found.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The largest error of what is found, in units in the last place of the number that is off; 0 where
    /// nothing is found.
    pub fn most_ulps(&self) -> f64 {
        self.worst(|line| line.closeness.map(|closeness| closeness.ulps))
    }

    /// The largest error of what is found, as a share of what rounding the problem to doubles may change
    /// in the answer: a solver without losses of its own stays at about 1. `None` where the problem has
    /// no condition.
    pub fn most_of_conditioning(&self) -> Option<f64> {
        self.condition?;
        Some(self.worst(|line| self.share(line)))
    }

    fn worst(&self, of: impl Fn(&Line) -> Option<f64>) -> f64 {
        let list = self.verdict.lines.iter();
        list.filter_map(of).fold(0.0, f64::max)
    }

    fn share(&self, line: &Line) -> Option<f64> {
        // Rounding to a double changes a number by 2⁻⁵³ of itself at most.
        let unavoidable = self.condition? * f64::EPSILON / 2.0;
        Some(line.closeness?.relative / unavoidable)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |mark| self.verdict.count(mark);
        write!(
            f,
            "{} found, {} missed, {} invented, {} wrong (relative error allowed: {:.1e})",
            count(Mark::Found),
            count(Mark::Missed),
            count(Mark::Invented),
            count(Mark::Wrong),
            self.tolerance,
        )?;
        for line in &self.verdict.lines {
            if line.mark == Mark::Unstated {
                continue;
            }
            write!(f, "\n{}: {}", line.place, line.mark)?;
            if let Some(closeness) = line.closeness {
                write!(
                    f,
                    ", {:.1} digits, {:.1} ulp",
                    closeness.digits(),
                    closeness.ulps
                )?;
            }
            if let Some(share) = self.share(line) {
                write!(f, ", {share:.1} of what rounding the problem may cost")?;
            }
            for (name, side) in [("certified", &line.certified), ("given", &line.given)] {
                if let Some(side) = side {
                    write!(f, "\n  {name:<9}  {side}")?;
                }
            }
        }
        Ok(())
    }
}
