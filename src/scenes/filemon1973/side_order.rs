//! The order of the sides of a pole quadrilateral by their lengths.

use super::quadrilateral::PoleQuadrilateral;
use crate::number::{Number, Real};
use crate::scenes::Unbuilt;

/// The order of the sides r, h, R, c, counted from 0, each next to the one before.
pub struct Sides<K> {
    pub shortest: usize,
    pub longest: usize,
    pub u: Number<K>,
    pub z: Number<K>,
}

impl<K: Real> Sides<K> {
    /// c < h and r < R, so that the shortest side is c or r and the longest h or R.
    pub fn of(quadrilateral: &PoleQuadrilateral<K>) -> Result<Self, Unbuilt> {
        let PoleQuadrilateral { r, h, long, c, .. } = quadrilateral;
        let less = |x: &Number<K>, y: &Number<K>| match x.compare(y) {
            Some(order) => Ok(order.is_lt()),
            None => Err(Unbuilt::NotHeld("the order of two sides".to_owned())),
        };
        let (shortest, short, shorter) = if less(c, r)? { (3, c, r) } else { (0, r, c) };
        let (longest, greatest, greater) = if less(h, long)? {
            (2, long, h)
        } else {
            (1, h, long)
        };
        Ok(Sides {
            shortest,
            longest,
            u: short + greatest,
            z: shorter + greater,
        })
    }

    pub fn are_adjacent(&self) -> bool {
        self.shortest.abs_diff(self.longest) != 2
    }
}
