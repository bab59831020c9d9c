//! What the program approximates.

use crate::number::Ball;
use crate::plane::Angle;
use crate::scenes::{Free, Unbuilt};
use crate::straight_line::ball_burmester::{Alternate, double};
use crate::straight_line::design::Design;

/// The design of the library for the same rays, in degrees.
pub fn design(free: &mut dyn Free<Ball>) -> Result<Design<Ball>, Unbuilt> {
    let [a, b] = [ray(free, "alpha_a")?, ray(free, "alpha_b")?];
    double(&a, &b)
        .and_then(|cranks| cranks.design(Alternate::First))
        .map_err(|why| Unbuilt::NotReal(why.to_string()))
}

fn ray(free: &mut dyn Free<Ball>, name: &str) -> Result<Angle<Ball>, Unbuilt> {
    let degrees = free.number(name)?;
    let exact = degrees.0.midpoint_rational();
    exact
        .and_then(|q| Angle::from_degrees(&q, &free.precision()))
        .ok_or_else(|| Unbuilt::NotHeld(format!("the cosine of {name}")))
}
