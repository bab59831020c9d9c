//! Angles in degrees whose cosine and sine are exact.

use rug::{Integer, Rational};

/// How many quarter turns (0 to 3) an angle in degrees is, if it is a multiple of 90°.
pub fn quarter_turns(degrees: &Rational) -> Option<u8> {
    whole_steps(degrees, 90, 4)
}

/// Cosine and sine of a number of quarter turns.
pub fn cos_sin_of_quarter_turns(quarter: u8) -> (i64, i64) {
    match quarter % 4 {
        0 => (1, 0),
        1 => (0, 1),
        2 => (-1, 0),
        _ => (0, -1),
    }
}

/// The angle as a number of steps of `step` degrees, reduced modulo `turn` steps, if it is one.
pub fn whole_steps(degrees: &Rational, step: u32, turn: u32) -> Option<u8> {
    let steps = Rational::from(degrees / step);
    if !steps.is_integer() {
        return None;
    }
    let reduced = steps.numer().clone().modulo(&Integer::from(turn));
    reduced.to_u8()
}
