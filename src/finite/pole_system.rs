//! The six poles of four positions, and where the poles of the moving plane are in position 1.

use crate::number::Kind;
use crate::plane::displacement::Displacement;
use crate::plane::{Point, line};

/// The pairs of positions 1 to 4.
pub const PAIRS: [[usize; 2]; 6] = [[1, 2], [1, 3], [1, 4], [2, 3], [2, 4], [3, 4]];

/// One point for each pair of positions; the order of the two does not matter.
#[derive(Clone, Debug)]
pub struct OfPairs<K>([Point<K>; 6]);

impl<K: Kind> OfPairs<K> {
    /// The point of each pair i < j, by a function.
    pub fn from_fn(point: impl Fn([usize; 2]) -> Point<K>) -> Self {
        OfPairs(PAIRS.map(point))
    }

    /// The poles O_ij: where a point of the moving plane lies in both positions. No value where
    /// these differ by a translation only.
    #[expect(
        clippy::indexing_slicing,
        reason = "positions are numbered from 1 to 4"
    )]
    pub fn poles(positions: &[Displacement<K>; 4]) -> Self {
        Self::from_fn(|[i, j]| positions[i - 1].pole(&positions[j - 1]))
    }

    /// The mirror poles O¹_ij: where the point of the moving plane that positions i and j carry to
    /// O_ij is in position 1. O¹_1j is O_1j, and O¹_jk the mirror image of O_jk in the line
    /// O_1j O_1k.
    #[expect(
        clippy::indexing_slicing,
        reason = "positions are numbered from 1 to 4"
    )]
    pub fn mirror_poles(positions: &[Displacement<K>; 4]) -> Self {
        Self::from_fn(|[i, j]| {
            let pole = positions[i - 1].pole(&positions[j - 1]);
            positions[0].of(&positions[i - 1].inverse().of(&pole))
        })
    }

    /// Where opposite sides of the quadrilaterals of poles meet: Q_ij is the meet of the lines
    /// O_ik O_jk and O_il O_jl, whose names have i and j besides what they have twice. No value for
    /// parallel lines.
    pub fn meets_of_opposite_sides(&self) -> Self {
        Self::from_fn(|pair @ [i, j]| {
            let [k, l] = others(pair);
            line::meet(self.of(i, k), self.of(j, k), self.of(i, l), self.of(j, l))
        })
    }

    /// The point of positions i ≠ j, numbers from 1 to 4.
    #[expect(clippy::indexing_slicing, reason = "the place of one of the six pairs")]
    pub fn of(&self, i: usize, j: usize) -> &Point<K> {
        let place = PAIRS.iter().position(|pair| *pair == [i.min(j), i.max(j)]);
        &self.0[place.unwrap_or_default()]
    }

    /// The quadrilateral O_ij, O_jk, O_kl, O_li of the positions i, j, k, l in this order: no two
    /// opposite vertices share a position.
    pub fn quadrilateral(&self, [i, j, k, l]: [usize; 4]) -> [Point<K>; 4] {
        [[i, j], [j, k], [k, l], [l, i]].map(|[i, j]| self.of(i, j).clone())
    }
}

/// The two positions that are not in a pair.
fn others(pair: [usize; 2]) -> [usize; 2] {
    PAIRS
        .into_iter()
        .find(|other| other.iter().all(|i| !pair.contains(i)))
        .unwrap_or(pair)
}
