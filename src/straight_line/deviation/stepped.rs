//! The arc in steps of one degree of the crank, in floats, as the thesis's program goes (Tesar 1964,
//! chapter VI).
//!
//! From the design position the crank is turned by whole degrees, both ways, until the deviation is
//! beyond the bound; that row is the last. Where the travel turns back or the linkage does not close
//! any more, the row before it is the last.

use super::driven::Driven;
use crate::number::Number;

/// The last row on one side.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The crank's angle from the design position.
    pub degrees: i32,
    /// Travel.
    pub u: f64,
    /// Deviation.
    pub v: f64,
}

/// The last rows on both sides.
pub fn stepped(driven: &Driven<f64>, bound: f64) -> [Row; 2] {
    [-1, 1].map(|side| last(driven, bound, side))
}

fn last(driven: &Driven<f64>, bound: f64, side: i32) -> Row {
    let mut last = Row {
        degrees: 0,
        u: 0.0,
        v: 0.0,
    };
    let mut direction = 0.0;
    for step in 1..=360 {
        let Some(row) = row(driven, side * step) else {
            break;
        };
        let travel = row.u - last.u;
        if travel * direction < 0.0 {
            break;
        }
        direction = travel;
        last = row;
        if row.v.abs() > bound {
            break;
        }
    }
    last
}

fn row(driven: &Driven<f64>, degrees: i32) -> Option<Row> {
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    let position = driven.position(&Number::complex(Number(cos), Number(sin)))?;
    let [u, v] = driven.coordinates(&position).map(|x| x.0);
    v.is_finite().then_some(Row { degrees, u, v })
}
