//! Lecture notes on Burmester theory for three and four positions, after Sandor and Freudenstein
//! (Kaufman).
//!
//! Vectors are complex numbers. Position 1 is the reference: φⱼ, γⱼ and δⱼ lead from it to position j.

pub(super) mod circuits;
pub(super) mod compatibility_determinant;
pub(super) mod compatibility_triangle;
pub(super) mod construction_from_an_angle;
pub(super) mod dyad;
pub(super) mod equal_angles;
pub(super) mod linear_equations;
pub(super) mod opposite_pole_pairs;
pub(super) mod poles;
pub(super) mod three_positions;
pub(super) mod two_poles;
pub(super) mod which_can_be_solved;
