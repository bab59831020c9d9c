//! Geometry of the plane over any number kind.
//!
//! A point is a complex number x + iy; a turn by an angle is a product with a complex number.

mod angle;
pub mod circle;
pub mod circular_cubic;
pub mod common_part;
pub mod conic;
pub mod curve_type;
pub mod displacement;
pub mod focal_cubic;
pub mod hessian;
pub mod inflexions;
pub mod isotropic;
pub mod line;
pub mod pencil;
pub mod polynomial;
pub mod projective;
pub mod quadrilateral;
pub mod region;
mod region_edges;
pub mod relation;
pub mod tangents;
pub mod trace;

pub use angle::Angle;

use crate::number::{Complex, Number};

/// A finite point x + iy.
pub type Point<K> = Number<Complex<K>>;
