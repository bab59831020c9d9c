//! `four-bar`: a four-bar with a point of its coupler: how it moves, and the curve of the point.

mod double_points;
mod given;
mod motion;
mod writer;

use serde_json::{Map, Value};

use super::input::Fields;
use super::output::into_floats;
use super::sharpen::{Attempt, sharpen};
use super::{Arithmetic, ProblemError, Request};
use given::Given;
use motion::Frame;

/// Reads and solves the problem.
pub fn answer(fields: &Fields<'_>, request: &Request) -> Result<Map<String, Value>, ProblemError> {
    let given = Given::read(fields)?;
    let mut answer = sharpen(request.digits, |attempt| attempt.four_bar(&given));
    if request.arithmetic == Arithmetic::Float {
        answer.values_mut().for_each(into_floats);
    }
    Ok(answer)
}

impl Attempt {
    fn four_bar(&mut self, given: &Given) -> Map<String, Value> {
        let bars = given.bars();
        let exactly = given.curve_exactly();
        let in_balls = given.curve_in_balls(self.bits);
        let mut answer = match (&exactly, &in_balls) {
            (Some(curve), _) => self.curve(curve, &bars),
            (None, Some(curve)) => self.curve(curve, &bars),
            (None, None) => Map::new(),
        };
        if given.has_position() {
            match (given.position_exactly(), given.position_in_balls(self.bits)) {
                (Some(linkage), _) => self.position(&linkage, &mut answer),
                (None, Some(linkage)) => self.position(&linkage, &mut answer),
                (None, None) => {
                    self.decided("A", None);
                }
            }
        }
        let exactly = exactly.map(|curve| Frame::of(&curve, &bars.d));
        let in_balls = in_balls.map(|curve| Frame::of(&curve, &bars.d.0.enclosure(self.bits)));
        answer.extend(self.motion(&bars, exactly.as_ref(), in_balls.as_ref()));
        answer
    }
}
