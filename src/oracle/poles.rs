//! `poles`: the poles of several positions, in the fixed and in the moving plane, and the turns.

use serde_json::{Map, Value};

use super::input::Fields;
use super::numeral::Shown;
use super::positions::{Given, Task};
use super::sharpen::Attempt;
use super::{ProblemError, Request};
use crate::finite::positions::Positions;

/// More positions are no design task.
const MOST: usize = 9;

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    fields.only(&["positions"])?;
    Ok(Given::read(fields, 2, MOST)?.solve(&Poles, request))
}

struct Poles;

impl Task for Poles {
    fn answer<K: Shown>(
        &self,
        positions: &Positions<K>,
        _: &K::Precision,
        attempt: &mut Attempt,
    ) -> Map<String, Value> {
        let mut answer = both(positions, attempt);
        let mut turns = Map::new();
        for (i, j) in positions.pairs() {
            if let Some(turn) = positions.turn(i, j) {
                turns.insert(label(i, j), attempt.turn("turns", &turn));
            }
        }
        answer.insert("turns".into(), Value::Object(turns));
        answer
    }
}

/// The label of the pole of positions i and j, counted from 0: `12` for the first two.
pub fn label(i: usize, j: usize) -> String {
    format!("{}{}", i + 1, j + 1)
}

/// The fields `poles` and `image_poles`.
pub fn both<K: Shown>(positions: &Positions<K>, attempt: &mut Attempt) -> Map<String, Value> {
    let inverse = positions.inverse();
    let mut answer = Map::new();
    for (name, positions) in [("poles", positions), ("image_poles", &inverse)] {
        let mut poles = Map::new();
        for (i, j) in positions.pairs() {
            let pole = positions.pole(i, j);
            let value = pole.map(|pole| attempt.point(name, &pole));
            poles.insert(label(i, j), value.unwrap_or_default());
        }
        answer.insert(name.into(), Value::Object(poles));
    }
    answer
}
