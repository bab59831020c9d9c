//! The arc in steps of one degree of the crank, as a program of 1964 went (Tesar 1964, chapter VI).
//!
//! From the design position the crank is turned by whole degrees, both ways. Where the deviation is
//! beyond a level for the first time, the row is recorded for that level. A row in which the travel has
//! turned back, or in which the linkage does not close, ends all levels that are left; what is
//! recorded then is peculiar:
//!
//! - travel, deviation and the turn of T are those of the row beyond the reversal, but the
//!   transmission angles those of the row before (where the linkage does not close, all are of the last
//!   row that does);
//! - the crank's angle is put back by one degree for the first level that is ended so, by two for the next,
//!   and so on, since the counter of the rows is put back each time and the same row met again.
//!
//! So the ranges and lengths that it tells differ from the arc's by up to some degrees; the arc itself
//! is in [`arc`](super::arc).

use std::cmp::Ordering;

use crate::number::{Number, Real};

/// A position of the linkage as a row has it.
#[derive(Clone, Debug)]
pub struct Row<K> {
    /// Travel.
    pub u: Number<K>,
    /// Deviation.
    pub v: Number<K>,
    /// The turn of T from the design position, in degrees, of a row alone up to whole turns.
    pub psi: Number<K>,
    /// The acute angles between the coupler and R, T, in degrees.
    pub gamma: [Number<K>; 2],
}

/// What is met at an angle of the crank.
#[derive(Clone, Debug)]
pub enum Met<K> {
    /// A position.
    Row(Row<K>),
    /// The linkage does not close there.
    Open,
}

/// What is recorded where a level ends.
#[derive(Clone, Debug)]
pub struct Record<K> {
    /// The crank's angle from the design position.
    pub degrees: i32,
    /// What the row says; not all of it belongs to that angle.
    pub row: Row<K>,
}

/// What ends the rows beside the deviation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// A reversal of the travel, or that the linkage does not close.
    Reversal,
    /// Only that the linkage does not close.
    Closure,
}

/// Rows beyond this angle are not computed.
const MOST_DEGREES: i32 = 180;

/// The records of all levels on one side, −1 or 1, the levels from the least on; `None` for a level that
/// is not ended within half a turn. `None` where something cannot be decided; `met` says so likewise.
pub fn records<K: Real>(
    met: impl Fn(i32) -> Option<Met<K>>,
    levels: &[Number<K>],
    side: i32,
    rule: Rule,
) -> Option<Vec<Option<Record<K>>>> {
    let Met::Row(start) = met(0)? else {
        return None;
    };
    let mut records: Vec<Option<Record<K>>> = Vec::new();
    let mut last = start.clone();
    let mut saved = (0, start.u.clone());
    let mut heading = Number::zero();
    let mut degrees = side;
    let mut back = 1;
    while degrees.abs() <= MOST_DEGREES && records.len() < levels.len() {
        let is_ended = match met(degrees)? {
            Met::Open => true,
            Met::Row(next) => {
                if degrees == side {
                    heading = &next.u - &start.u;
                }
                // A row that is met again has not turned back.
                let turned = rule == Rule::Reversal
                    && degrees != saved.0
                    && (&heading * (&next.u - &saved.1)).sign()? == Ordering::Less;
                let gamma = if turned {
                    last.gamma.clone()
                } else {
                    saved = (degrees, next.u.clone());
                    next.gamma.clone()
                };
                let psi = followed(next.psi, &last.psi)?;
                last = Row { gamma, psi, ..next };
                turned
            }
        };
        let record = |degrees| {
            let row = last.clone();
            Some(Record { degrees, row })
        };
        if is_ended {
            degrees -= side * back;
            back += 1;
            records.push(record(degrees));
        }
        while let Some(level) = levels.get(records.len()) {
            if last.v.abs().compare(level)? != Ordering::Greater {
                break;
            }
            records.push(record(degrees));
        }
        degrees += side;
    }
    records.resize(levels.len(), None);
    Some(records)
}

/// An angle in degrees, a whole number of turns farther, so that it is near another.
fn followed<K: Real>(angle: Number<K>, near: &Number<K>) -> Option<Number<K>> {
    let step = &angle - near;
    if step.compare(&Number::from(180))? == Ordering::Greater {
        followed(angle - 360, near)
    } else if step.compare(&Number::from(-180))? == Ordering::Less {
        followed(angle + 360, near)
    } else {
        Some(angle)
    }
}

/// The angle between two lines whose angles are given in degrees, as that program took it: |x − y|, but
/// 180° less |x − y| where that is more than 90° and the angles have different signs. So it is acute while
/// both lines are between −90° and 90°. `None` where a comparison is not decided that matters.
pub fn between_lines<K: Real>(x: &Number<K>, y: &Number<K>) -> Option<Number<K>> {
    let (apart, right) = ((x - y).abs(), Number::from(90));
    match (apart.compare(&right), (x * y).sign()) {
        (Some(Ordering::Less | Ordering::Equal), _) | (_, Some(Ordering::Greater)) => Some(apart),
        (Some(Ordering::Greater), Some(_)) => Some((180 - apart).abs()),
        // Near 90° both are the same.
        (None, Some(_)) => Some(90 - (90 - apart).abs()),
        (_, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Exact;

    #[test]
    fn angles_are_followed_past_a_turn() {
        for (angle, near, expected) in [
            (-170, 170, 190),
            (170, -170, -190),
            (10, 700, 730),
            (5, -700, -715),
            (30, 20, 30),
        ] {
            let found = followed::<Exact>(angle.into(), &near.into()).unwrap();
            assert!(
                found.equals(&expected.into()).is_yes(),
                "{angle} near {near}: {found:?}"
            );
        }
    }
}
