//! How a linkage of four bars passes through given positions: its type, whether it reaches all of
//! them without being taken apart, in which order, and with which transmission angles. All by signs of
//! exact expressions, none by sampling.
//!
//! The joints A₀, A, B, B₀ may be finite, where links turn against each other, or at infinity, where
//! they slide: a center B₀ at infinity is a slide of B, a circlepoint B at infinity a line of the
//! coupler in a block that turns about B₀.

mod circuit;
mod degenerate;
mod driven;
mod driver;
mod grashof;
mod joint;
mod limits;
mod order;
mod transmission;

pub use degenerate::Degenerate;
pub use grashof::{Type, four_bar_type};
pub use joint::Joint;
pub use order::is_in_order;

use crate::number::Kind;

/// A linkage A₀ABB₀ with its joints A, B in each of several positions.
#[derive(Clone, Debug)]
pub struct Passage<K> {
    /// A₀ and B₀.
    pub pivots: [Joint<K>; 2],
    /// A and B in each position; one at infinity by the direction that turns with the coupler.
    pub joints: Vec<[Joint<K>; 2]>,
}

/// Which of the two links at the base drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Drive {
    /// The link A₀A.
    First,
    /// The link B₀B.
    Second,
}

impl Drive {
    /// Both.
    pub const ALL: [Drive; 2] = [Drive::First, Drive::Second];
}

impl<K: Kind> Passage<K> {
    /// The same linkage with A and B exchanged.
    fn exchanged(&self) -> Self {
        let [a, b] = &self.pivots;
        let joints = self.joints.iter().map(|[a, b]| [b.clone(), a.clone()]);
        Passage {
            pivots: [b.clone(), a.clone()],
            joints: joints.collect(),
        }
    }

    /// The same linkage, named so that A₀A drives.
    fn seen_from(&self, drive: Drive) -> Self {
        match drive {
            Drive::First => self.clone(),
            Drive::Second => self.exchanged(),
        }
    }
}
