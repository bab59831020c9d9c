//! The parameters of a printed example.

use std::collections::BTreeMap;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rug::Rational;

use super::Printed;
use crate::formula::{Bindings, Formula, Value, evaluate_expression, read};
use crate::number::Exact;

/// Parameters of a printed example.
#[derive(Clone, Debug)]
pub struct Example {
    /// The data file and its name there.
    pub name: String,
    /// What the example assumes, by the scene's names.
    pub given: BTreeMap<String, Formula>,
    /// Which of it are results or measurements, as printed.
    pub measured: BTreeMap<String, Printed>,
}

impl Example {
    /// Nothing is given yet.
    pub fn new(name: String) -> Self {
        Example {
            name,
            given: BTreeMap::new(),
            measured: BTreeMap::new(),
        }
    }

    /// A parameter of which the printed digits are known. What is given beside is one value within them,
    /// which is tried first; else it is the printed one.
    pub fn measure(&mut self, parameter: &str, text: &str) -> Result<(), String> {
        let printed = Printed::read(text).map_err(|error| error.to_string())?;
        match self.given.get(parameter) {
            Some(given) => {
                let value = value(given).ok_or("a number was expected")?;
                if !printed.covers(&value, &value) {
                    return Err(format!("{given} is not within the digits of {text}"));
                }
            }
            None => {
                let formula = number(&printed.value).ok_or("a number was expected")?;
                self.given.insert(parameter.to_owned(), formula);
            }
        }
        self.measured.insert(parameter.to_owned(), printed);
        Ok(())
    }

    /// What is given, with the measured parameters anywhere within their digits: for the number 0 as
    /// given, else at random.
    pub fn sample(&self, seed: u64) -> BTreeMap<String, Formula> {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut given = self.given.clone();
        for (parameter, printed) in self.measured.iter().filter(|_| seed > 0) {
            // From minus to plus half a unit of the last digit.
            let place = Rational::from((i64::from(random.next_u32()), 1_i64 << 32))
                - Rational::from((1, 2));
            if let Some(formula) = number(&(&printed.value + place * &printed.unit)) {
                given.insert(parameter.clone(), formula);
            }
        }
        given
    }
}

/// The value of a formula that is a rational number.
fn value(formula: &Formula) -> Option<Rational> {
    match evaluate_expression(formula, &Bindings::<Exact>::new(())) {
        Ok(Value::Number(number)) => number.0.rational().cloned(),
        _ => None,
    }
}

/// A number as a formula.
fn number(q: &Rational) -> Option<Formula> {
    read(&format!("({q})")).ok()
}
