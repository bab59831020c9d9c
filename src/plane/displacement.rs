//! Displacements of the moving plane, and the points that they leave where they are.

use super::Point;
use crate::number::{Kind, Number};

/// X = rotation · x + translation, |rotation| = 1: where a point x of the moving plane is in the
/// fixed one.
#[derive(Clone, Debug)]
pub struct Displacement<K> {
    /// e^{iθ}
    pub rotation: Point<K>,
    /// Where the origin of the moving plane is.
    pub translation: Point<K>,
}

impl<K: Kind> Displacement<K> {
    /// Where a point of the moving plane is.
    pub fn of(&self, point: &Point<K>) -> Point<K> {
        &self.rotation * point + &self.translation
    }

    /// The pole of two positions, the point of the fixed plane where the same point of the moving
    /// plane lies both times; no value where they differ by a translation only.
    pub fn pole(&self, other: &Self) -> Point<K> {
        let point = (&self.translation - &other.translation) / (&other.rotation - &self.rotation);
        self.of(&point)
    }
}

impl<K: Kind> Displacement<K> {
    /// No displacement.
    pub fn identity() -> Self {
        Displacement {
            rotation: Number::one(),
            translation: Number::zero(),
        }
    }
}
