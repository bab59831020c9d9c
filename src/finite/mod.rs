//! Finitely separated positions of the moving plane.

pub mod compatibility;
pub mod equal_angles;
pub mod five_positions;
pub mod four_positions;
pub mod half_angles;
pub mod pole_four_bar;
pub mod pole_system;
pub mod positions;
pub mod stretches;
pub mod three_positions;
