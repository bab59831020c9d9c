//! Several positions of the moving plane, and their poles.

use crate::number::{Kind, Number};
use crate::plane::Point;
use crate::plane::displacement::{Displacement, HalfTurn};
use crate::plane::projective::ProjectivePoint;

/// The three opposite-pole quadrilaterals of positions 0 to 3, by the poles in order: the ends of a
/// diagonal have no position in common.
pub const OPPOSITE_POLES: [[(usize, usize); 4]; 3] = [
    [(0, 1), (1, 2), (2, 3), (0, 3)],
    [(0, 1), (1, 3), (2, 3), (0, 2)],
    [(0, 3), (1, 3), (1, 2), (0, 2)],
];

/// Positions of the moving plane. The turns between them are kept beside the displacements: two
/// angles that are equal, or differ by half a turn, may be known to do so where cosines and sines
/// are enclosures only.
#[derive(Clone, Debug)]
pub struct Positions<K> {
    displacements: Vec<Displacement<K>>,
    /// By the places i < j, in the order 01, 02, …, 12, ….
    half_turns: Vec<HalfTurn<K>>,
}

impl<K: Kind> Positions<K> {
    /// Positions by their displacements.
    pub fn new(displacements: Vec<Displacement<K>>) -> Self {
        let half_turns = pairs(displacements.len())
            .filter_map(|(i, j)| Some(displacements.get(i)?.half_turn_to(displacements.get(j)?)))
            .collect();
        Positions {
            displacements,
            half_turns,
        }
    }

    /// Positions whose turns are better known than their displacements tell: `half_turn(i, j)` is half
    /// of the turn from position i to position j.
    pub fn with_half_turns(
        displacements: Vec<Displacement<K>>,
        half_turn: impl Fn(usize, usize) -> HalfTurn<K>,
    ) -> Self {
        let half_turns = pairs(displacements.len())
            .map(|(i, j)| half_turn(i, j))
            .collect();
        Positions {
            displacements,
            half_turns,
        }
    }

    /// The displacements.
    pub fn displacements(&self) -> &[Displacement<K>] {
        &self.displacements
    }

    /// The first four displacements, where there are so many.
    pub fn first_four(&self) -> Option<&[Displacement<K>; 4]> {
        self.displacements.first_chunk()
    }

    /// The fixed plane seen from the moving one.
    pub fn inverse(&self) -> Self {
        let back = |turn: &HalfTurn<K>| HalfTurn {
            cos: turn.cos.clone(),
            sin: -&turn.sin,
        };
        Positions {
            displacements: self
                .displacements
                .iter()
                .map(Displacement::inverse)
                .collect(),
            half_turns: self.half_turns.iter().map(back).collect(),
        }
    }

    /// The pole of positions i and j, counted from 0 and in any order, finite or not; `None` where
    /// there are no two such positions.
    pub fn pole(&self, i: usize, j: usize) -> Option<ProjectivePoint<K>> {
        let (i, j) = (i.min(j), i.max(j));
        let place = pairs(self.displacements.len()).position(|pair| pair == (i, j))?;
        let (first, second) = (self.displacements.get(i)?, self.displacements.get(j)?);
        Some(first.pole_by_half_turn(second, self.half_turns.get(place)?))
    }

    /// The turn e^{iδ} from position i to a later one j, counted from 0: exactly 1 where it is known
    /// that nothing turns; `None` where there are no two such positions.
    pub fn turn(&self, i: usize, j: usize) -> Option<Point<K>> {
        let place = pairs(self.displacements.len()).position(|pair| pair == (i, j))?;
        let [from, to] = [i, j].map(|k| self.displacements.get(k));
        if self.half_turns.get(place)?.sin.is_zero().is_yes() {
            return Some(Number::one());
        }
        Some(&to?.rotation * from?.rotation.conj())
    }

    /// All places i < j, in order.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + use<K> {
        pairs(self.displacements.len())
    }
}

fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |i| (i + 1..count).map(move |j| (i, j)))
}
