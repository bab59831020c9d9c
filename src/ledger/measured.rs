//! A printed value whose inputs are themselves printed results or measurements.

use rug::Rational;

use super::error::JudgeError;
use super::number::{ball_of, rational_of};
use super::paper::Text;
use super::stage::Stage;
use super::{Judgement, Printed, Proof, Verdict};

/// What is printed: a decimal, or an integer that means equality.
enum Print {
    Decimal(Printed),
    Integer(Rational),
}

impl Print {
    /// Whether numbers between these bounds are printed so.
    fn is_of(&self, low: &Rational, high: &Rational) -> bool {
        match self {
            Print::Decimal(printed) => printed.covers(low, high) || printed.is_cut_of(low, high),
            Print::Integer(i) => low == i && high == i,
        }
    }
}

/// Looks for inputs within their printed digits that give the print. Where none is found, nothing is
/// proven: the print is not reproduced.
pub fn compare_measured(
    printed: &str,
    quantity: &Text,
    stage: &mut Stage,
) -> Result<Judgement, JudgeError> {
    let print = match Printed::read(printed) {
        Ok(decimal) => Print::Decimal(decimal),
        Err(error) => match rational_of(printed) {
            Some(integer) => Print::Integer(integer),
            None => return Err(error.into()),
        },
    };
    let mut values = Vec::new();
    for bindings in stage.samples() {
        let ball = ball_of(&quantity.formula, &bindings)?;
        let Some((low, high)) = ball.lower().zip(ball.upper()) else {
            continue;
        };
        if print.is_of(&low, &high) {
            let mut judgement = Judgement::bare(Verdict::Consistent, Proof::Certified);
            let finding = "inputs within their printed digits give the print";
            judgement.findings.push(finding.to_owned());
            return Ok(judgement);
        }
        values.push((low, high));
    }
    let mut judgement = Judgement::bare(Verdict::NotReproducible, Proof::Numeric);
    judgement.samples = Some(values.len());
    let least = values.iter().map(|(low, _)| low).min();
    let greatest = values.iter().map(|(_, high)| high).max();
    if let Some((least, greatest)) = least.zip(greatest) {
        judgement.findings.push(format!(
            "inputs within their printed digits were found to give values from {:.6} to {:.6}",
            least.to_f64(),
            greatest.to_f64()
        ));
    }
    Ok(judgement)
}
