//! A printed value of a quantity: is it what the scene computes?

use rug::Rational;

use super::error::JudgeError;
use super::formula::{Finding, decide};
use super::paper::Text;
use super::stage::Stage;
use super::{Computed, Printed, Proof, Verdict};
use crate::formula::{
    Bindings, Failure, Formula, Node, Relation, Tree, Value, evaluate_expression, read,
};
use crate::number::text::parse_rational;
use crate::number::{Ball, BallText, Number, Real};
use crate::plane::Angle;

/// Bits with which the comparison begins: those by which 30 digits are shown, so that the quantities of
/// a stage are computed once for both.
const FIRST_BITS: u32 = 164;

/// More bits than this are not spent on deciding a printed digit.
const MOST_BITS: u32 = 1 << 14;

/// A quantity of a stage, evaluated.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// An enclosure, in degrees for an angle.
    pub ball: Ball,
    /// The number itself, where the scene is exact and the quantity rational.
    pub rational: Option<Rational>,
    /// Whether the enclosure was made from an exact number.
    pub exact: bool,
}

/// Evaluates a quantity to about this many bits.
pub fn evaluate_quantity(
    quantity: &Text,
    stage: &mut Stage,
    bits: u32,
) -> Result<Quantity, JudgeError> {
    let exact = stage.instances(1)?.first();
    if let Some(Ok(Value::Number(number))) =
        exact.map(|bindings| evaluate_expression(&quantity.formula, bindings))
    {
        return Ok(Quantity {
            ball: number.0.enclosure(bits).0,
            rational: number.0.rational().cloned(),
            exact: true,
        });
    }
    let bindings = stage.certified(bits)?;
    let ball = ball_of(&quantity.formula, &bindings)?;
    // Integers, such as whole degrees, stay themselves among enclosures.
    let ends = ball.lower().zip(ball.upper());
    let rational = ends.filter(|(low, high)| low == high).map(|(low, _)| low);
    Ok(Quantity {
        ball,
        rational,
        exact: false,
    })
}

/// An enclosure of the value of an expression, in degrees for an angle.
pub fn ball_of(formula: &Formula, bindings: &Bindings<Ball>) -> Result<Ball, JudgeError> {
    match evaluate_expression(formula, bindings).map_err(JudgeError::formula)? {
        Value::Number(number) => Ok(number.0),
        Value::Angle(angle) => Ok(in_degrees(&angle, *bindings.precision()).0),
        Value::Turn(turn) => Ok(Ball::rounded(&(turn * 180), bindings.precision())),
        other => Err(JudgeError::formula(Failure::Wrong {
            message: format!(
                "a number or an angle was expected, not {}",
                other.kind_name()
            ),
            span: 0..0,
        })),
    }
}

/// An angle in degrees, in (−180°, 180°].
pub fn in_degrees(angle: &Angle<Ball>, bits: u32) -> Number<Ball> {
    let direction = angle.direction();
    let radians = direction.im().clone().atan2(direction.re());
    radians * 180 / Number::pi(&bits)
}

/// A number as it is shown: exact where it is rational, else an enclosure of so many digits.
pub fn shown(quantity: &Quantity, digits: usize) -> Computed {
    match &quantity.rational {
        Some(q) => Computed::Exact {
            exact: q.to_string(),
        },
        None => match quantity.ball.to_decimal(digits) {
            Some(BallText { value, radius }) => Computed::Enclosure { value, radius },
            None => Computed::Unknown,
        },
    }
}

/// What was found of a printed value.
#[derive(Clone, Debug)]
pub struct ValueFinding {
    pub verdict: Verdict,
    pub proof: Proof,
    pub corrected: Option<String>,
    /// On how many samples it rests.
    pub samples: Option<usize>,
    /// What was found beside it.
    pub findings: Vec<String>,
}

/// Compares a printed decimal with the computed enclosure, sharpening it until one of the verdicts
/// is proven.
pub fn compare_decimal(
    printed: &Printed,
    quantity: &Text,
    stage: &mut Stage,
) -> Result<ValueFinding, JudgeError> {
    let mut bits = FIRST_BITS;
    loop {
        let value = evaluate_quantity(quantity, stage, bits)?;
        let proof = if value.exact {
            Proof::Exact
        } else {
            Proof::Certified
        };
        if let (Some(low), Some(high)) = (value.ball.lower(), value.ball.upper()) {
            let finding = |verdict, corrected| {
                Ok(ValueFinding {
                    verdict,
                    proof,
                    corrected,
                    samples: None,
                    findings: Vec::new(),
                })
            };
            if printed.covers(&low, &high) {
                return finding(Verdict::Reproduced, None);
            }
            if printed.excludes(&low, &high) {
                if printed.is_cut_of(&low, &high) {
                    return finding(Verdict::Truncated, None);
                }
                if let Some(noise) = noise(printed, quantity, stage, [&low, &high]) {
                    return Ok(noise);
                }
                let right = [&low, &high].map(|end| printed.like(end));
                let decided = (right[0] == right[1]).then(|| right[0].clone());
                if decided.is_some() {
                    return finding(Verdict::Contradicted, decided);
                }
            }
        }
        bits *= 2;
        if bits > MOST_BITS {
            return Ok(ValueFinding {
                verdict: Verdict::NotReproducible,
                proof,
                corrected: None,
                samples: None,
                findings: Vec::new(),
            });
        }
    }
}

/// Whether rounding errors of the machine that printed the number explain it: whether some number that
/// is no farther from the true one than the worst of its emulated results is printed so.
fn noise(
    printed: &Printed,
    quantity: &Text,
    stage: &Stage,
    [low, high]: [&Rational; 2],
) -> Option<ValueFinding> {
    let results = stage.emulated().iter().map(|bindings| {
        match evaluate_expression(&quantity.formula, bindings) {
            Ok(Value::Number(number)) => number.0.rational(),
            _ => None,
        }
    });
    let results: Vec<Rational> = results.collect::<Option<_>>()?;
    let error = |result: &Rational| {
        let [above, below] = [Rational::from(result - low), Rational::from(high - result)];
        above.max(below)
    };
    let bound = results.iter().map(error).max()?;
    let reach = [Rational::from(low - &bound), Rational::from(high + &bound)];
    printed
        .is_within(&reach[0], &reach[1])
        .then(|| ValueFinding {
            verdict: Verdict::Noise,
            proof: Proof::Numeric,
            corrected: None,
            samples: Some(results.len()),
            findings: vec![format!(
                "emulated results differ from the exact one by up to {:.1e}",
                bound.to_f64()
            )],
        })
}

/// A text that is an integer or a fraction.
pub fn rational_of(printed: &str) -> Option<Rational> {
    parse_rational(printed).ok()
}

/// Compares a printed integer with the quantity where that is known to be rational among enclosures:
/// whole degrees, for instance.
pub fn compare_integer(
    printed: &str,
    quantity: &Text,
    stage: &mut Stage,
) -> Result<Option<ValueFinding>, JudgeError> {
    let value = evaluate_quantity(quantity, stage, FIRST_BITS)?;
    let (Some(printed), Some(rational), false) =
        (rational_of(printed), value.rational, value.exact)
    else {
        return Ok(None);
    };
    let is_equal = printed == rational;
    Ok(Some(ValueFinding {
        verdict: if is_equal {
            Verdict::Reproduced
        } else {
            Verdict::Contradicted
        },
        proof: Proof::Certified,
        corrected: (!is_equal).then(|| rational.to_string()),
        samples: None,
        findings: Vec::new(),
    }))
}

/// Compares a printed expression (`4`, `2 sqrt 6`) with the quantity: both must be equal.
pub fn compare_expression(
    printed: &str,
    quantity: &Text,
    stage: &mut Stage,
) -> Result<Finding, JudgeError> {
    let expression = read(printed).map_err(JudgeError::reading)?;
    let equation = equation(&quantity.formula, &expression).ok_or_else(|| {
        JudgeError::formula(Failure::Wrong {
            message: "a single expression was expected".to_owned(),
            span: 0..0,
        })
    })?;
    decide(&equation, stage)
}

/// `left = right`, of two formulas that are one expression each.
fn equation(left: &Formula, right: &Formula) -> Option<Formula> {
    let [left] = left.claims.as_slice() else {
        return None;
    };
    let [right] = right.claims.as_slice() else {
        return None;
    };
    Some(Formula {
        claims: vec![Tree {
            node: Node::Chain {
                first: Box::new(left.clone()),
                rest: vec![(Relation::Equal, right.clone())],
                modulus: None,
            },
            span: 0..0,
        }],
        definitions: Vec::new(),
        assumptions: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Turns, angles and numbers.
    #[test]
    fn angles_are_in_degrees() {
        for (text, expected) in [("30 deg + 60 deg", 90), ("arccos(0)", 90), ("180/2", 90)] {
            let bindings = Bindings::<Ball>::new(128);
            let formula = read(text).unwrap();
            let found = ball_of(&formula, &bindings).unwrap();
            let [low, high] = [found.lower().unwrap(), found.upper().unwrap()];
            assert!(
                low <= expected && expected <= high && high - low < Rational::from((1, 1000)),
                "{text}"
            );
        }
    }
}
