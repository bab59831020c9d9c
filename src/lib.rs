//! A certified reference for planar linkage kinematics.

pub mod formula;
pub mod number;
pub mod plane;
