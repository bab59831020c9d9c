//! Polynomials of order 2 in two coordinates, from their values.

use crate::number::{Kind, Number};

/// x2 x² + xy xy + y2 y² + x x + y y + constant.
pub struct Quadratic<K> {
    pub x2: Number<K>,
    pub xy: Number<K>,
    pub y2: Number<K>,
    pub x: Number<K>,
    pub y: Number<K>,
    pub constant: Number<K>,
}

impl<K: Kind> Quadratic<K> {
    /// By the values of a polynomial of order 2 at most.
    pub fn interpolated(value: impl Fn(i64, i64) -> Number<K>) -> Self {
        let constant = value(0, 0);
        let x = (value(1, 0) - value(-1, 0)) / 2;
        let y = (value(0, 1) - value(0, -1)) / 2;
        let x2 = value(1, 0) - &constant - &x;
        let y2 = value(0, 1) - &constant - &y;
        let xy = value(1, 1) - &constant - &x - &y - &x2 - &y2;
        Quadratic {
            x2,
            xy,
            y2,
            x,
            y,
            constant,
        }
    }
}
