//! The order in which a driving link passes the positions.

use super::driver::{Driver, Motion, Turn};
use super::{Drive, Passage};
use crate::number::{Number, Real};
use crate::plane::Point;

/// A turning link from where it is cut open, so that its directions are on a line: −cot(φ/2) of the
/// angle φ from there, which grows from −∞ to ∞.
pub(super) struct Opened<K> {
    /// The direction of the cut, of any length.
    pub cut: Point<K>,
    /// Which gate that is; `None` for the first position, where both are free.
    pub gate: Option<usize>,
}

impl<K: Real> Opened<K> {
    /// −cot(φ/2) of a direction.
    pub(super) fn place(&self, direction: &Point<K>, length: &Number<K>) -> Number<K> {
        // w/|w| = (t − i)²/(1 + t²)
        let turned = direction * self.cut.conj();
        let length = length * self.cut.norm().sqrt();
        -(turned.im() / (length - turned.re()))
    }

    /// The direction of a place, of length 1.
    pub(super) fn direction(&self, place: &Number<K>) -> Point<K> {
        let root = Number::complex(place.clone(), (-1).into());
        let turn = root.square().scaled(&root.norm().inverse());
        self.cut.scaled(&self.cut.norm().sqrt().inverse()) * turn
    }
}

impl<K: Real> Driver<K> {
    /// The link cut open in a gate that is not free, else in the first position.
    pub(super) fn opened(&self, turn: &Turn<K>) -> Option<Opened<K>> {
        let rooms = self.rooms(turn);
        let barred = |room: &Option<std::cmp::Ordering>| room.is_some_and(|room| !room.is_gt());
        match rooms.iter().position(barred) {
            Some(gate) => {
                let axis = turn.axis.clone()?;
                let cut = if gate == 0 { axis } else { -axis };
                Some(Opened {
                    cut,
                    gate: Some(gate),
                })
            }
            None if rooms.contains(&None) => None,
            None => Some(Opened {
                cut: turn.directions.first()?.clone(),
                gate: None,
            }),
        }
    }
}

impl<K: Real> Passage<K> {
    /// The places of the positions in the order in which the driving link passes them, turning
    /// counterclockwise: from the first position on where it turns fully, from one end of its range to
    /// the other where it rocks. A slider turns counterclockwise about its center at infinity. Without
    /// meaning where a dead centre lies between the positions. `None` where it cannot be told.
    pub fn order(&self, drive: Drive) -> Option<Vec<usize>> {
        let driver = Driver::of(self, drive)?;
        match &driver.motion {
            Motion::Slide(slide) => sorted(slide.places.iter().enumerate()),
            Motion::Turn(turn) => {
                let opened = driver.opened(turn)?;
                let directions = turn.directions.iter();
                let places: Vec<Number<K>> = directions
                    .map(|direction| opened.place(direction, &turn.length))
                    .collect();
                if opened.gate.is_some() {
                    return sorted(places.iter().enumerate());
                }
                // The first position is where the turn begins.
                let mut order = vec![0];
                order.extend(sorted(places.iter().enumerate().skip(1))?);
                Some(order)
            }
        }
    }
}

/// Whether the positions are passed as they are numbered, forwards or backwards; a link that turns fully
/// comes back to the first one in the end.
pub fn is_in_order(order: &[usize], turns_fully: bool) -> bool {
    let forwards = order.iter().copied().eq(0..order.len());
    let backwards = if turns_fully {
        order.iter().skip(1).copied().eq((1..order.len()).rev())
    } else {
        order.iter().copied().eq((0..order.len()).rev())
    };
    forwards || backwards
}

/// The places of numbers in ascending order.
fn sorted<'a, K: Real + 'a>(
    numbers: impl Iterator<Item = (usize, &'a Number<K>)>,
) -> Option<Vec<usize>> {
    let mut sorted: Vec<(usize, &Number<K>)> = Vec::new();
    for (place, number) in numbers {
        let mut at = sorted.len();
        for (index, (_, other)) in sorted.iter().enumerate() {
            if number.compare(other)?.is_lt() {
                at = index;
                break;
            }
        }
        sorted.insert(at, (place, number));
    }
    Some(sorted.into_iter().map(|(place, _)| place).collect())
}
