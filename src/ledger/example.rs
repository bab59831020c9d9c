//! The parameters of a printed example.

use std::collections::BTreeMap;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rug::Rational;

use super::Printed;
use super::printed::NoDecimal;
use crate::formula::{Formula, read};

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

    /// A parameter of which the printed digits are known.
    pub fn measure(&mut self, parameter: &str, text: &str) -> Result<(), NoDecimal> {
        let printed = Printed::read(text)?;
        if let Some(formula) = number(&printed.value) {
            self.given.insert(parameter.to_owned(), formula);
        }
        self.measured.insert(parameter.to_owned(), printed);
        Ok(())
    }

    /// What is given, with the measured parameters anywhere within their digits, so many times; first
    /// as printed. Nothing where none is measured.
    pub fn samples(&self, wanted: u64) -> Vec<BTreeMap<String, Formula>> {
        if self.measured.is_empty() {
            return Vec::new();
        }
        let sample = |seed| {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            let mut given = self.given.clone();
            for (parameter, printed) in self.measured.iter().filter(|_| seed > 0) {
                // From minus to plus half a unit of the last digit.
                let place = Rational::from((i64::from(random.next_u32()), 1_i64 << 32))
                    - Rational::from((1, 2));
                let value = &printed.value + place * &printed.unit;
                given.insert(parameter.clone(), number(&value)?);
            }
            Some(given)
        };
        (0..wanted).filter_map(sample).collect()
    }
}

/// A number as a formula.
fn number(q: &Rational) -> Option<Formula> {
    read(&format!("({q})")).ok()
}
