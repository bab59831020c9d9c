//! Raising the precision until all digits are there.

use serde_json::{Map, Value, json};

use super::output;
use crate::number::{Ball, Number, Surd};

/// Bits beyond which a digit is called undecided, as a multiple of those that it needs.
const MOST_EFFORT: u32 = 16;

/// One attempt at an answer, to so many bits.
pub struct Attempt {
    /// Digits that are asked for.
    pub digits: u32,
    /// Bits of the balls.
    pub bits: u32,
    undecided: Vec<String>,
}

/// Answers with growing precision until nothing is undecided; what stays so at the end is named.
pub fn sharpen(
    digits: u32,
    answer: impl Fn(&mut Attempt) -> Map<String, Value>,
) -> Map<String, Value> {
    let needed = bits_for(digits);
    let mut bits = needed;
    loop {
        let mut attempt = Attempt::new(digits, bits);
        let mut fields = answer(&mut attempt);
        if attempt.undecided.is_empty() {
            return fields;
        }
        if bits >= needed.saturating_mul(MOST_EFFORT) {
            fields.insert("undecided".into(), json!(attempt.undecided.join(", ")));
            return fields;
        }
        bits = bits.saturating_mul(2);
    }
}

/// Bits of the first attempt.
fn bits_for(digits: u32) -> u32 {
    digits.saturating_mul(4).saturating_add(64)
}

impl Attempt {
    /// Whether fewer bits have left something undecided.
    pub fn is_repeated(&self) -> bool {
        self.bits > bits_for(self.digits)
    }

    /// An attempt to so many bits.
    pub fn new(digits: u32, bits: u32) -> Self {
        Attempt {
            digits,
            bits,
            undecided: Vec::new(),
        }
    }

    /// A value, or null and a note that it is not decided.
    pub fn decided(&mut self, name: &str, value: Option<Value>) -> Value {
        value.unwrap_or_else(|| {
            if !self.undecided.iter().any(|known| known == name) {
                self.undecided.push(name.to_owned());
            }
            Value::Null
        })
    }

    /// A number from its exact form, where there is one, else from its ball.
    pub fn number(
        &mut self,
        name: &str,
        exact: Option<&Number<Surd>>,
        ball: Option<&Number<Ball>>,
    ) -> Value {
        let value = exact
            .and_then(|number| output::surd(number, self.digits, self.bits))
            .or_else(|| output::enclosure(ball?, self.digits));
        self.decided(name, value)
    }
}
