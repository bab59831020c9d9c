//! Geometry of the plane over any number kind.
//!
//! A point is a complex number x + iy; a turn by an angle is a product with a complex number.

mod angle;
pub mod circle;
pub mod circular_cubic;
pub mod conic;
pub mod displacement;
pub mod isotropic;
pub mod line;
pub mod projective;
pub mod quadrilateral;
pub mod relation;

pub use angle::Angle;

use crate::number::{Complex, Number};

/// A finite point x + iy.
pub type Point<K> = Number<Complex<K>>;
